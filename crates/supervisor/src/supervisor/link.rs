//! The link to the arm and its problems.

use dobot_api::{LinkPhase, LinkView};
use dobot_session::LinkQuality;

use crate::refusal::Refusal;

/// The link, as seen by the statuses received.
#[derive(Debug)]
pub(super) struct Link {
    phase: LinkPhase,
    address: Option<String>,
    problem: Option<String>,
    /// Why the last link was lost.
    lost: Option<String>,
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
            ..Self::default()
        };
    }

    /// Handles a port that is gone or could not be opened; returns whether there was a link.
    pub(super) fn handle_down(&mut self, phase: LinkPhase, problem: Option<String>) -> bool {
        let is_lost = self.is_there();
        self.phase = phase;
        if is_lost {
            self.laser_off_sent = false;
            self.lost = problem;
            self.problem.clone_from(&self.lost);
        } else {
            // Why the link was lost is more useful than why it is not found again.
            self.problem = match (&self.lost, problem) {
                (Some(lost), Some(since)) => Some(format!("{lost}; since then: {since}")),
                (_, since) => since,
            };
        }
        is_lost
    }

    /// Handles a link that has gone silent.
    pub(super) fn handle_silence(&mut self, why: &str) {
        self.phase = LinkPhase::Lost;
        self.laser_off_sent = false;
        self.problem = Some(format!(
            "{why}; check that the arm is switched on and its cable plugged in"
        ));
        self.lost.clone_from(&self.problem);
    }

    /// Handles a status; returns whether the link has just come up.
    pub(super) fn handle_status(&mut self) -> bool {
        let comes_up = matches!(self.phase, LinkPhase::Listening | LinkPhase::Lost);
        if comes_up {
            self.phase = LinkPhase::Up;
            self.problem = None;
        }
        comes_up
    }

    /// Returns whether a laser-off packet is still owed to the arm since the link came up, and
    /// marks it as sent.
    pub(super) const fn take_pending_laser_off(&mut self) -> bool {
        !std::mem::replace(&mut self.laser_off_sent, true)
    }

    pub(super) const fn is_there(&self) -> bool {
        matches!(self.phase, LinkPhase::Listening | LinkPhase::Up)
    }

    /// Checks that the arm can be reached.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        if self.phase == LinkPhase::Up {
            return Ok(());
        }
        let why = match (&self.problem, self.phase) {
            (Some(problem), _) => problem.clone(),
            (None, LinkPhase::Searching) => "no arm has been found yet".into(),
            (None, _) => "no status has arrived yet".into(),
        };
        Err(Refusal::NoLink(why))
    }

    /// Returns a one-line description of the loss.
    pub(super) fn loss(&self) -> String {
        match &self.problem {
            Some(problem) => format!("the link to the arm was lost: {problem}"),
            None => "the link to the arm was lost".to_owned(),
        }
    }

    pub(super) fn view(&self, quality: &LinkQuality) -> LinkView {
        LinkView {
            address: self.address.clone(),
            phase: self.phase,
            problem: self.problem.clone(),
            bluetooth: quality.bluetooth,
            statuses_per_s: quality.statuses_per_s,
            lost_statuses: quality.lost,
            damaged_bytes: quality.damaged_bytes,
            latency_ms: quality.latency.map(|latency| latency.as_secs_f64() * 1e3),
        }
    }
}
