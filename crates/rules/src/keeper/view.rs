//! What the keeper tells all the time.

use dobot_api::{ArmView, LinkView, QueueView, State, TrustView};

use super::Keeper;

impl Keeper {
    /// All that is known now.
    #[must_use]
    pub fn state(&self) -> State {
        State {
            at_s: self.now.as_secs_f64(),
            link: self.link_view(),
            arm: self.last.map(|status| ArmView {
                status,
                moving: self.still == 0,
            }),
            dialect: self.session.dialect().copied(),
            trust: TrustView {
                trusted: self.session.is_trusted(),
                reason: self.session.distrust_reason().map(str::to_owned),
            },
            queue: QueueView {
                waiting: self.session.waiting(),
                under_way: self.session.under_way(),
                ahead_s: self.session.ahead_s(),
            },
            lease: self.lease_view(),
            stop: self.stop_view(),
            laser: self.laser_view(),
            job: self.job(),
            clients: self.clients.len(),
        }
    }

    fn link_view(&self) -> LinkView {
        let quality = self.session.link();
        LinkView {
            address: self.link.address.clone(),
            phase: self.link.phase,
            problem: self.link.problem.clone(),
            bluetooth: quality.bluetooth,
            statuses_per_s: quality.statuses_per_s,
            lost_statuses: quality.lost,
            damaged_bytes: quality.damaged_bytes,
            latency_ms: quality.latency.map(|it| it.as_secs_f64() * 1e3),
        }
    }
}
