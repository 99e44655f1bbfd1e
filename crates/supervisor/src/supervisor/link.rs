//! The link to the arm and its problems.

use dobot_api::{LinkCause, LinkPhase, LinkProblem, LinkView};
use dobot_session::{LinkQuality, NoStatus};

use crate::refusal::Refusal;

/// The link, as seen by the statuses received.
#[derive(Debug)]
pub(super) struct Link {
    phase: LinkPhase,
    address: Option<String>,
    problem: Option<LinkProblem>,
    /// Why the last link was lost.
    lost: Option<String>,
    /// The cause in the last notice.
    reported: Option<LinkCause>,
    /// Whether the laser has been switched off since the link came up.
    laser_off_sent: bool,
}

impl Default for Link {
    /// No port has been found yet.
    fn default() -> Self {
        Self {
            phase: LinkPhase::Searching,
            address: None,
            problem: None,
            lost: None,
            reported: None,
            laser_off_sent: false,
        }
    }
}

impl Link {
    /// Handles an opened port: statuses may arrive.
    pub(super) fn handle_up(&mut self, address: &str) {
        *self = Self {
            phase: LinkPhase::Listening,
            address: Some(address.to_owned()),
            reported: self.reported,
            ..Self::default()
        };
    }

    /// Handles a port that is gone or could not be opened; returns what ends with it.
    pub(super) fn handle_down(&mut self, phase: LinkPhase, problem: LinkProblem) -> LinkEnd {
        let end = self.end();
        self.phase = if end == LinkEnd::NeverUp {
            LinkPhase::Searching
        } else {
            phase
        };
        if end != LinkEnd::None {
            self.laser_off_sent = false;
        }
        if end == LinkEnd::Lost {
            self.lost = Some(problem.text.clone());
        }
        // Why the link was lost is more useful than why it is not found again.
        let text = match &self.lost {
            Some(lost) if end == LinkEnd::None => format!("{lost}; since then: {}", problem.text),
            _ => problem.text,
        };
        self.problem = Some(LinkProblem { text, ..problem });
        end
    }

    /// Handles the silence of the arm; returns what ends with it.
    pub(super) fn handle_silence(&mut self, text: String, received: &NoStatus) -> LinkEnd {
        let end = self.end();
        if end == LinkEnd::None {
            return end;
        }
        self.laser_off_sent = false;
        self.problem = Some(LinkProblem {
            cause: cause_of_silence(received),
            remedy: Some(received.hint().to_owned()),
            text,
        });
        if end == LinkEnd::Lost {
            self.phase = LinkPhase::Lost;
            self.lost = self.problem.as_ref().map(|problem| problem.text.clone());
        }
        end
    }

    /// Returns what ends if there is no link from now on.
    const fn end(&self) -> LinkEnd {
        match self.phase {
            LinkPhase::Up => LinkEnd::Lost,
            LinkPhase::Listening => LinkEnd::NeverUp,
            LinkPhase::Searching | LinkPhase::Lost => LinkEnd::None,
        }
    }

    /// Returns the cause of the problem if it has not been reported yet, and counts it as reported.
    pub(super) fn take_new_cause(&mut self) -> Option<LinkCause> {
        let cause = self.problem.as_ref().map(|problem| problem.cause);
        let before = std::mem::replace(&mut self.reported, cause);
        cause.filter(|_| cause != before)
    }

    /// Handles a status; returns whether the link has just come up.
    pub(super) fn handle_status(&mut self) -> bool {
        let is_new = matches!(self.phase, LinkPhase::Listening | LinkPhase::Lost);
        if is_new {
            self.phase = LinkPhase::Up;
            (self.problem, self.reported) = (None, None);
        }
        is_new
    }

    /// Returns whether a laser-off packet is still owed to the arm since the link came up, and
    /// marks it as sent.
    pub(super) const fn take_pending_laser_off(&mut self) -> bool {
        !std::mem::replace(&mut self.laser_off_sent, true)
    }

    pub(super) const fn is_there(&self) -> bool {
        matches!(self.phase, LinkPhase::Listening | LinkPhase::Up)
    }

    /// Returns whether the port is open, but no status has come.
    pub(super) const fn is_listening(&self) -> bool {
        matches!(self.phase, LinkPhase::Listening)
    }

    /// Checks that the arm can be reached.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        if self.phase == LinkPhase::Up {
            return Ok(());
        }
        let why = match (&self.problem, self.phase) {
            (Some(problem), _) => problem.to_string(),
            (None, LinkPhase::Searching) => "no arm has been found yet".into(),
            (None, _) => "no status has arrived yet".into(),
        };
        Err(Refusal::NoLink(why))
    }

    /// Returns what ended and why, in one line.
    pub(super) fn loss(&self, end: LinkEnd) -> String {
        let what = match end {
            LinkEnd::Lost => LOST,
            LinkEnd::NeverUp | LinkEnd::None => "there is no link to an arm",
        };
        match &self.problem {
            Some(problem) => format!("{what}: {problem}"),
            None => what.to_owned(),
        }
    }

    pub(super) fn view(&self, quality: &LinkQuality) -> LinkView {
        let problem = self.problem.as_ref();
        LinkView {
            address: self.address.clone(),
            phase: self.phase,
            problem: problem.map(|problem| problem.text.clone()),
            cause: problem.map(|problem| problem.cause),
            remedy: problem.and_then(|problem| problem.remedy.clone()),
            bluetooth: quality.bluetooth,
            statuses_per_s: quality.statuses_per_s,
            lost_statuses: quality.lost,
            damaged_bytes: quality.damaged_bytes,
            latency_ms: quality.latency.map(|latency| latency.as_secs_f64() * 1e3),
        }
    }
}

/// What ends when there is no link any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LinkEnd {
    /// Nothing: there was no link.
    None,
    /// An open port from which no status has come.
    NeverUp,
    /// A link that was up.
    Lost,
}

/// Why something ends with a link that is lost.
pub(super) const LOST: &str = "the link to the arm was lost";

/// Returns the cause for what arrived instead of a status.
#[must_use]
pub const fn cause_of_silence(received: &NoStatus) -> LinkCause {
    match received {
        NoStatus::Nothing => LinkCause::Silent,
        NoStatus::BigEndian => LinkCause::BigEndian,
        _ => LinkCause::NotAnArm,
    }
}
