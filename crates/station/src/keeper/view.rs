//! What the keeper tells all the time.

use super::Keeper;
use crate::words::{ArmView, QueueView, State, TrustView};

impl Keeper {
    /// All that is known now.
    #[must_use]
    pub fn state(&self) -> State {
        State {
            at_s: self.arm.now().as_secs_f64(),
            link: self.link.view(&self.arm.session().link()),
            arm: self.arm.last().map(|status| ArmView {
                status,
                moving: self.arm.still() == 0,
            }),
            dialect: self.arm.session().dialect().copied(),
            trust: TrustView {
                trusted: self.arm.session().is_trusted(),
                reason: self.arm.session().distrust_reason().map(str::to_owned),
            },
            queue: QueueView {
                waiting: self.arm.session().waiting(),
                under_way: self.arm.session().under_way(),
                ahead_s: self.arm.session().ahead_s(),
            },
            lease: self.leases.view(),
            stop: self.stop.view(),
            laser: self.arm.laser_view(),
            job: self.job(),
            clients: self.leases.clients(),
        }
    }
}
