//! Failed attempts: ports that are not tried again for a while.

use std::time::Duration;

use dobot_api::LinkProblem;
use dobot_session::Address;

use super::ProbeFailure;
use super::candidate::Candidate;

/// Ports that were tried without success. Opening a port may disturb the device behind it, so it is
/// not tried again for a minute, or until it is plugged in again: it may be an arm that is switched
/// on by then.
#[derive(Debug, Default)]
pub(super) struct FailedAttempts(Vec<Attempt>);

#[derive(Debug)]
struct Attempt {
    address: Address,
    at: Duration,
    problem: LinkProblem,
}

impl FailedAttempts {
    /// Records a failed attempt. A port that could not be opened was not disturbed.
    pub(super) fn note(&mut self, candidate: &Candidate, failure: &ProbeFailure, now: Duration) {
        self.0
            .retain(|attempt| attempt.address != candidate.address);
        if !candidate.sure && failure.was_open() {
            self.0.push(Attempt {
                address: candidate.address.clone(),
                at: now,
                problem: failure.problem(),
            });
        }
    }

    /// Returns why a candidate should not be opened now, if it failed recently.
    pub(super) fn reason_to_wait(
        &self,
        candidate: &Candidate,
        now: Duration,
    ) -> Option<&LinkProblem> {
        let is_recent = |attempt: &&Attempt| now < attempt.at.saturating_add(LEFT_ALONE);
        let mut attempts = self.0.iter().filter(|_| !candidate.sure);
        let attempt = attempts.find(|attempt| attempt.address == candidate.address);
        attempt.filter(is_recent).map(|attempt| &attempt.problem)
    }

    /// Forgets ports that are gone.
    pub(super) fn keep(&mut self, candidates: &[Candidate]) {
        let is_there = |attempt: &Attempt| {
            candidates
                .iter()
                .any(|candidate| candidate.address == attempt.address)
        };
        self.0.retain(is_there);
    }
}

const LEFT_ALONE: Duration = Duration::from_secs(60);

#[cfg(test)]
mod tests {
    use dobot_session::{NoStatus, OpenError, Port, Usb};

    use super::super::Search;
    use super::super::candidate::choose;
    use super::*;

    const SILENT: ProbeFailure = ProbeFailure::NoStatus(NoStatus::Nothing);

    fn candidates() -> Vec<Candidate> {
        let port = Port {
            path: "/dev/ttyUSB0".into(),
            device: None,
            usb: Some(Usb {
                vendor: 0x1a86,
                product: 0x7523,
                serial: None,
            }),
        };
        choose(&Search::default(), &[port]).candidates
    }

    const fn s(s: u64) -> Duration {
        Duration::from_secs(s)
    }

    #[test]
    fn a_silent_port_is_left_alone_for_a_minute_and_the_reason_is_kept() {
        let mut failed_attempts = FailedAttempts::default();
        let candidate = &candidates()[0];
        failed_attempts.note(candidate, &SILENT, s(10));
        let why = failed_attempts.reason_to_wait(candidate, s(69));
        assert_eq!(why, Some(&SILENT.problem()));
        assert_eq!(failed_attempts.reason_to_wait(candidate, s(70)), None);
    }

    #[test]
    fn a_port_is_tried_again_after_it_was_plugged_in_again() {
        let mut failed_attempts = FailedAttempts::default();
        let candidates = candidates();
        failed_attempts.note(&candidates[0], &SILENT, s(10));
        failed_attempts.keep(&candidates);
        assert!(
            failed_attempts
                .reason_to_wait(&candidates[0], s(11))
                .is_some()
        );
        failed_attempts.keep(&[]);
        assert_eq!(failed_attempts.reason_to_wait(&candidates[0], s(12)), None);
    }

    #[test]
    fn a_port_that_could_not_be_opened_is_tried_each_time() {
        let mut failed_attempts = FailedAttempts::default();
        let candidate = &candidates()[0];
        let path = "/dev/ttyUSB0".into();
        let failure = ProbeFailure::Open(OpenError::InUse { path });
        failed_attempts.note(candidate, &failure, s(10));
        assert_eq!(failed_attempts.reason_to_wait(candidate, s(10)), None);
    }

    #[test]
    fn the_port_of_the_arm_is_tried_each_time() {
        let mut failed_attempts = FailedAttempts::default();
        let candidate = Candidate {
            sure: true,
            ..candidates()[0].clone()
        };
        failed_attempts.note(&candidate, &SILENT, s(10));
        assert_eq!(failed_attempts.reason_to_wait(&candidate, s(10)), None);
    }
}
