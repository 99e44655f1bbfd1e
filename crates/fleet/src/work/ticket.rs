//! A ticket: work for any arm, with all that has to be known of it after a crash.

use dobot_api::{JobPhase, JobView, WorkBefore, WorkMember, WorkPhase, WorkView};
use serde::{Deserialize, Serialize};

/// Work for any arm, as it is on the disk of the station where it was submitted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Ticket {
    /// 32 hexadecimal digits.
    pub(crate) id: String,
    /// Which one it is of those submitted here: they are served in that order.
    pub(crate) number: u64,
    pub(crate) title: String,
    pub(crate) student: String,
    pub(crate) group: Option<String>,
    pub(crate) needs: Vec<String>,
    pub(crate) submitted_ms: i64,
    /// What the sender calls the request for it.
    pub(crate) key: Option<String>,
    pub(crate) at: Place,
    /// Who cannot do it, and why.
    pub(crate) refused: Vec<Refused>,
    /// From whom a person has taken it.
    pub(crate) before: Vec<Before>,
    /// Who gave it back last without having begun it, and why; absent once it is offered again.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) returned: Option<Refused>,
}

/// How far a ticket is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Place {
    Waiting,
    /// A station is or was asked to take it: from here on it may have it.
    Offered(Offer),
    /// A station has it as a job.
    Taken {
        offer: Offer,
        job: Box<JobView>,
    },
    /// That job is over.
    Over {
        offer: Offer,
        job: Box<JobView>,
    },
    Cancelled,
}

/// What was offered to whom.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Offer {
    pub(crate) member: WorkMember,
    /// By what the other station knows it, for good. Nobody else learns it.
    pub(crate) key: String,
    /// Whether a person does not want it any more.
    pub(crate) is_withdrawn: bool,
    /// Why it is taken back for another arm or a later time, where the arm cannot begin it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) recalled: Option<String>,
}

/// A station that cannot do it, or not now.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Refused {
    pub(crate) member: WorkMember,
    pub(crate) reason: String,
}

/// A station from which a person has taken it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Before {
    pub(crate) offer: Offer,
    /// The job there as it was heard of last; `None` where it was never heard of.
    pub(crate) job: Option<Box<JobView>>,
    /// Nothing more of it will be drawn there.
    pub(crate) is_settled: bool,
}

impl Ticket {
    /// The offer that it stands or falls with.
    pub(crate) const fn offer(&self) -> Option<&Offer> {
        match &self.at {
            Place::Offered(offer) | Place::Taken { offer, .. } | Place::Over { offer, .. } => {
                Some(offer)
            }
            Place::Waiting | Place::Cancelled => None,
        }
    }

    /// The job that has come of it.
    pub(crate) fn job(&self) -> Option<&JobView> {
        match &self.at {
            Place::Taken { job, .. } | Place::Over { job, .. } => Some(job),
            Place::Waiting | Place::Offered(_) | Place::Cancelled => None,
        }
    }

    pub(crate) fn phase(&self) -> WorkPhase {
        match &self.at {
            Place::Waiting => WorkPhase::Waiting,
            Place::Offered(_) => WorkPhase::Offered,
            Place::Taken { .. } => WorkPhase::Taken,
            Place::Over { job, .. } if job.phase == JobPhase::Done => WorkPhase::Done,
            Place::Over { .. } => WorkPhase::Failed,
            Place::Cancelled => WorkPhase::Cancelled,
        }
    }

    /// Whether a station may still be at it, as far as is known here.
    pub(crate) const fn is_out(&self) -> bool {
        matches!(self.at, Place::Offered(_) | Place::Taken { .. })
    }

    /// The time of an arm that it took or takes, in seconds, as far as is known.
    pub(crate) fn arm_s(&self) -> f64 {
        let Some(job) = self.job() else {
            return 0.0;
        };
        let planned_s = job.planned_s.unwrap_or_default();
        match job.phase {
            JobPhase::Stopped | JobPhase::Failed => {
                #[expect(clippy::cast_precision_loss, reason = "a share needs no more")]
                let share = job.completed as f64 / job.commands.max(1) as f64;
                planned_s * share
            }
            _ => job.took_s.unwrap_or(planned_s),
        }
    }

    /// What others see of it.
    pub(crate) fn view(&self, doubt: Option<String>) -> WorkView {
        WorkView {
            id: self.id.clone(),
            title: self.title.clone(),
            student: self.student.clone(),
            group: self.group.clone(),
            needs: self.needs.clone(),
            submitted_ms: self.submitted_ms,
            phase: self.phase(),
            doubt,
            reason: self.reason(),
            member: self.offer().map(|it| it.member.clone()),
            job: self.job().cloned(),
            before: self.before.iter().map(Before::view).collect(),
        }
    }

    fn reason(&self) -> Option<String> {
        match &self.at {
            Place::Over { job, .. } => job.reason.clone(),
            Place::Offered(offer) | Place::Taken { offer, .. } if offer.is_withdrawn => {
                let name = &offer.member.name;
                Some(format!(
                    "it is being withdrawn from {name}; what the arm is at goes on until it is stopped there"
                ))
            }
            Place::Offered(offer) | Place::Taken { offer, .. } => {
                let why = offer.recalled.as_ref()?;
                let name = &offer.member.name;
                Some(format!("it is being taken back from {name}: {why}"))
            }
            Place::Waiting if !self.refused.is_empty() || self.returned.is_some() => {
                let refused = self.refused.iter().chain(&self.returned);
                let told = refused.map(|it| format!("{}: {}", it.member.name, it.reason));
                Some(told.collect::<Vec<_>>().join("; "))
            }
            _ => None,
        }
    }
}

impl Offer {
    /// Whether it is to end there, unless the arm has begun it.
    pub(crate) const fn is_taken_back(&self) -> bool {
        self.is_withdrawn || self.recalled.is_some()
    }
}

impl Before {
    fn view(&self) -> WorkBefore {
        WorkBefore {
            member: self.offer.member.clone(),
            drawn: drawn(self.job.as_deref(), self.is_settled),
            is_settled: self.is_settled,
        }
    }
}

/// What of a job may have been drawn, in words.
pub(crate) fn drawn(job: Option<&JobView>, is_settled: bool) -> String {
    match job {
        None if is_settled => "nothing of it was drawn".into(),
        None => "it may have been drawn".into(),
        Some(job) if job.phase == JobPhase::Done => "all of it was drawn".into(),
        Some(job) => {
            let (done, all) = (job.completed, job.commands);
            let more = if is_settled { "" } else { ", and it may go on" };
            format!("{done} of {all} commands were done when it was heard of last{more}")
        }
    }
}
