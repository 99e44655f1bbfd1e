//! Tickets: jobs for any arm, with all that must survive a crash.

use dobot_api::{JobPhase, JobView, WorkBefore, WorkMember, WorkPhase, WorkView};
use serde::{Deserialize, Serialize};

/// A job for any arm, as stored on the disk of the station to which it was submitted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Ticket {
    /// 32 hexadecimal digits.
    pub(crate) id: String,
    /// The sequence number at this station; tickets are served in this order.
    pub(crate) number: u64,
    pub(crate) title: String,
    pub(crate) student: String,
    pub(crate) group: Option<String>,
    pub(crate) needs: Vec<String>,
    pub(crate) submitted_ms: i64,
    /// The submitter's key of the request.
    pub(crate) key: Option<String>,
    pub(crate) at: Place,
    /// The stations that cannot run it, with reasons.
    pub(crate) refused: Vec<Refused>,
    /// The stations from which a person has taken it.
    pub(crate) before: Vec<Before>,
    /// The station that returned it last without having begun it, with the reason; absent once it
    /// is offered again.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) returned: Option<Refused>,
}

/// The place of a ticket.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Place {
    Waiting,
    /// Offered to a station: from here on the station may have it.
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

/// An offer to a station.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Offer {
    pub(crate) member: WorkMember,
    /// The key by which the other station identifies it permanently. No one else learns it.
    pub(crate) key: String,
    /// Whether a person has cancelled it.
    pub(crate) is_withdrawn: bool,
    /// Why it is recalled for another arm or a later time, if the arm cannot begin it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) recalled: Option<String>,
}

/// A station that cannot run it, or not now.
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
    /// The last known state of the job there; `None` if it was never received.
    pub(crate) job: Option<Box<JobView>>,
    /// Whether nothing more of it will be drawn there.
    pub(crate) is_settled: bool,
}

impl Ticket {
    /// Returns the offer that decides its result.
    pub(crate) const fn offer(&self) -> Option<&Offer> {
        match &self.at {
            Place::Offered(offer) | Place::Taken { offer, .. } | Place::Over { offer, .. } => {
                Some(offer)
            }
            Place::Waiting | Place::Cancelled => None,
        }
    }

    /// Returns its job.
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

    /// Whether a station may still be working on it, as far as is known here.
    pub(crate) const fn is_out(&self) -> bool {
        matches!(self.at, Place::Offered(_) | Place::Taken { .. })
    }

    /// Returns the arm time that it took or takes, in seconds, as far as is known.
    pub(crate) fn arm_s(&self) -> f64 {
        let Some(job) = self.job() else {
            return 0.0;
        };
        let planned_s = job.planned_s.unwrap_or_default();
        match job.phase {
            JobPhase::Stopped | JobPhase::Failed => {
                #[expect(clippy::cast_precision_loss, reason = "sufficient for a share")]
                let share = job.completed as f64 / job.commands.max(1) as f64;
                planned_s * share
            }
            _ => job.took_s.unwrap_or(planned_s),
        }
    }

    /// Returns the public view.
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
            member: self.offer().map(|offer| offer.member.clone()),
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
                    "it is being withdrawn from {name}; a running job continues until it is stopped there"
                ))
            }
            Place::Offered(offer) | Place::Taken { offer, .. } => {
                let why = offer.recalled.as_ref()?;
                let name = &offer.member.name;
                Some(format!("it is being recalled from {name}: {why}"))
            }
            Place::Waiting if !self.refused.is_empty() || self.returned.is_some() => {
                let refused = self.refused.iter().chain(&self.returned);
                let reasons =
                    refused.map(|refused| format!("{}: {}", refused.member.name, refused.reason));
                Some(reasons.collect::<Vec<_>>().join("; "))
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

/// Describes how much of a job may have been drawn.
pub(crate) fn drawn(job: Option<&JobView>, is_settled: bool) -> String {
    match job {
        None if is_settled => "nothing of it was drawn".into(),
        None => "it may have been drawn".into(),
        Some(job) if job.phase == JobPhase::Done => "all of it was drawn".into(),
        Some(job) => {
            let (done, all) = (job.completed, job.commands);
            let more = if is_settled {
                ""
            } else {
                ", and it may continue"
            };
            format!("{done} of {all} commands were done at the last report{more}")
        }
    }
}
