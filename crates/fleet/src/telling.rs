//! What this station tells the others.

use std::time::Duration;

use dobot_api::{MemberAbout, State};
use dobot_rules::Snapshot;

/// What this station tells, as the others read it.
pub(crate) fn told(about: &MemberAbout, state: &Snapshot) -> Vec<u8> {
    let about = serde_json::to_vec(about).expect("structures with text keys are JSON");
    let parts: [&[u8]; 5] = [
        br#"{"about":"#,
        &about,
        br#","state":"#,
        &state.json(),
        b"}",
    ];
    parts.concat()
}

/// Whether to tell a state now: what changed is told at once, and that one is there every second.
#[derive(Debug, Default)]
pub(crate) struct Pace {
    told: Option<(Duration, State)>,
}

/// So often a state is told that is like the one before.
const STILL_THERE: Duration = Duration::from_secs(1);

impl Pace {
    pub(crate) fn is_due(&mut self, now: Duration, state: &State) -> bool {
        let is_due = self.told.as_ref().is_none_or(|(at, told)| {
            now.saturating_sub(*at) >= STILL_THERE || !is_like(told, state)
        });
        if is_due {
            self.told = Some((now, state.clone()));
        }
        is_due
    }
}

/// Whether nobody would see a difference: the clock and the counters of the link go on all the time.
fn is_like(one: &State, other: &State) -> bool {
    let mut one = one.clone();
    one.at_s = other.at_s;
    one.link.statuses_per_s = other.link.statuses_per_s;
    one.link.latency_ms = other.link.latency_ms;
    one.link.lost_statuses = other.link.lost_statuses;
    one.link.damaged_bytes = other.link.damaged_bytes;
    one.laser.armed_for_s = other.laser.armed_for_s;
    one == *other
}

#[cfg(test)]
pub(crate) mod tests {
    use dobot_api::{LaserView, LinkPhase, LinkView, QueueView, StopView, TrustView};

    use super::*;

    pub(crate) fn state() -> State {
        State {
            at_s: 1.0,
            link: LinkView {
                address: None,
                phase: LinkPhase::Up,
                problem: None,
                bluetooth: false,
                statuses_per_s: 12.5,
                lost_statuses: 0,
                damaged_bytes: 0,
                latency_ms: None,
            },
            arm: None,
            calibrated: None,
            dialect: None,
            trust: TrustView {
                trusted: true,
                reason: None,
            },
            queue: QueueView {
                waiting: 0,
                under_way: 0,
                ahead_s: 0.0,
            },
            lease: None,
            lock: None,
            slots: None,
            stop: None,
            fleet_stops: Vec::new(),
            laser: LaserView {
                armed_for_s: 0.0,
                on: false,
            },
            job: None,
            jobs_missing: None,
            clients: 0,
        }
    }

    #[test]
    fn a_stop_is_told_at_once_and_a_resting_arm_every_second() {
        let at = Duration::from_millis;
        let mut pace = Pace::default();
        assert!(pace.is_due(at(0), &state()));
        let later = State {
            at_s: 1.2,
            ..state()
        };
        assert!(!pace.is_due(at(200), &later));
        assert!(pace.is_due(at(1000), &later));
        let stopped = State {
            stop: Some(StopView {
                by: "Anna".into(),
                reason: None,
                at_s: 1.3,
                rests_by_s: 1.4,
                at_rest: false,
                delivered: true,
                of_fleet: false,
            }),
            ..later
        };
        assert!(pace.is_due(at(1100), &stopped));
    }
}
