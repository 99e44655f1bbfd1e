//! The way to the arm: whether there is one, and why not.

use dobot_api::{LinkPhase, LinkView};
use dobot_session::LinkQuality;

use crate::refusal::Refusal;

/// The link as far as the arm was heard over it.
#[derive(Debug)]
pub(super) struct Link {
    phase: LinkPhase,
    address: Option<String>,
    problem: Option<String>,
    /// Why there is none any more, where there was one.
    lost: Option<String>,
    /// The laser has been switched off since the link came up.
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
    /// Takes that the port is open: statuses may come.
    pub(super) fn handle_up(&mut self, address: &str) {
        *self = Self {
            phase: LinkPhase::Listening,
            address: Some(address.to_owned()),
            ..Self::default()
        };
    }

    /// Takes that the port is gone, or could not be opened, and why; says whether there was one.
    pub(super) fn handle_down(&mut self, phase: LinkPhase, problem: Option<String>) -> bool {
        let is_lost = self.is_there();
        self.phase = phase;
        if is_lost {
            self.laser_off_sent = false;
            self.lost = problem;
            self.problem.clone_from(&self.lost);
        } else {
            // That it is not found again tells less than why it was lost.
            self.problem = match (&self.lost, problem) {
                (Some(lost), Some(since)) => Some(format!("{lost}; since then: {since}")),
                (_, since) => since,
            };
        }
        is_lost
    }

    /// Takes that nothing comes over it any more.
    pub(super) fn handle_silence(&mut self, why: &str) {
        self.phase = LinkPhase::Lost;
        self.laser_off_sent = false;
        self.problem = Some(format!(
            "{why}; is the arm switched on, and the cable in its place?"
        ));
        self.lost.clone_from(&self.problem);
    }

    /// With each status: says whether it is up only now.
    pub(super) fn handle_status(&mut self) -> bool {
        let comes_up = matches!(self.phase, LinkPhase::Listening | LinkPhase::Lost);
        if comes_up {
            self.phase = LinkPhase::Up;
            self.problem = None;
        }
        comes_up
    }

    /// Whether the laser has still to be switched off since it came up: by whoever asks.
    pub(super) const fn take_pending_laser_off(&mut self) -> bool {
        !std::mem::replace(&mut self.laser_off_sent, true)
    }

    pub(super) const fn is_there(&self) -> bool {
        matches!(self.phase, LinkPhase::Listening | LinkPhase::Up)
    }

    /// Whether the arm can be heard.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        if self.phase == LinkPhase::Up {
            return Ok(());
        }
        let why = match (&self.problem, self.phase) {
            (Some(problem), _) => problem.clone(),
            (None, LinkPhase::Searching) => "no arm has been found yet".into(),
            (None, _) => "the arm has not told anything yet".into(),
        };
        Err(Refusal::NoLink(why))
    }

    /// That it was lost, and why, in one line.
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
            latency_ms: quality.latency.map(|it| it.as_secs_f64() * 1e3),
        }
    }
}
