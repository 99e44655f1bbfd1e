//! The state of the faults of a virtual arm, and the restart of its controller.

use std::time::Duration;

use dobot_controller::{Controller, PowerUp};

use super::schedule::Counted;
use super::{ArmOrder, Fault, FaultSchedule, Tilt};
use crate::Mechanics;

/// The faults of a virtual arm and the data to restart its controller.
#[derive(Debug)]
pub(crate) struct FaultState {
    pub(crate) schedule: FaultSchedule,
    power_up: PowerUp,
    /// The offset of each joint from the controller's estimate at power-up.
    zeros_deg: [f64; 4],
    /// The counters of the previous controllers.
    before: Counted,
    /// Whether the port is present.
    pub(crate) has_port: bool,
}

impl FaultState {
    /// Applies the faults to the machine, unknown to the controller.
    pub(crate) fn new(
        power_up: PowerUp,
        faults: &[Fault],
        seed: u64,
        machine: &mut Mechanics,
    ) -> Self {
        let schedule = FaultSchedule::new(faults, seed);
        let zeros_deg = schedule.fit(machine);
        Self {
            schedule,
            zeros_deg,
            ..Self::none(power_up)
        }
    }

    /// Creates a state without faults.
    pub(crate) fn none(power_up: PowerUp) -> Self {
        Self {
            schedule: FaultSchedule::new(&[], 0),
            power_up,
            zeros_deg: [0.0; 4],
            before: Counted::default(),
            has_port: true,
        }
    }

    /// Ends all active faults; the resulting actions follow with the time.
    pub(crate) fn end_all(&mut self, now: Duration) {
        self.schedule.end_all(now);
    }

    /// Replaces the ended faults; the new ones count from now.
    pub(crate) fn replace(
        &mut self,
        now: Duration,
        controller: &Controller,
        faults: &[Fault],
        seed: u64,
    ) {
        let counted = self.counted(controller);
        let faults: Vec<Fault> = faults
            .iter()
            .map(|fault| fault.counted_from(now, counted))
            .collect();
        self.schedule.replace(&faults, seed);
    }

    /// Advances to `now` and returns an action on the arm, if one is due.
    pub(crate) fn handle_time(
        &mut self,
        now: Duration,
        controller: &Controller,
    ) -> Option<ArmOrder> {
        self.schedule.handle_time(now, self.counted(controller));
        self.schedule.poll_order()
    }

    /// Restarts the controller from the readings of the tilt sensors.
    pub(crate) fn restart(
        &mut self,
        at: Duration,
        controller: &Controller,
        machine: &Mechanics,
        tilt: Tilt,
    ) -> Controller {
        self.before = self.counted(controller);
        let joints = machine.joints_at(at);
        let [_, rear_zero_deg, fore_zero_deg, _] = self.zeros_deg;
        Controller::power_up(self.power_up.with_tilt(
            joints.rear.0 - rear_zero_deg + tilt.rear_deg,
            joints.fore.0 - fore_zero_deg + tilt.fore_deg,
        ))
    }

    fn counted(&self, controller: &Controller) -> Counted {
        let counters = controller.counters();
        Counted {
            packets: self.before.packets + counters.packets,
            statuses: self.before.statuses + counters.statuses,
        }
    }
}
