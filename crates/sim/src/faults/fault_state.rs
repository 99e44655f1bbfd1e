//! The state of the faults of a virtual arm, and the start of another controller.

use std::time::Duration;

use dobot_controller::{Controller, PowerUp};

use super::schedule::Counted;
use super::{ArmOrder, Fault, FaultSchedule, Tilt};
use crate::Mechanics;

/// The faults of a virtual arm, and what it takes to start its controller anew.
#[derive(Debug)]
pub(crate) struct FaultState {
    pub(crate) schedule: FaultSchedule,
    power_up: PowerUp,
    /// How much further each joint stands than the controller believes at power-up.
    zeros_deg: [f64; 4],
    /// What was counted by the controllers before this one.
    before: Counted,
    /// Whether the port is there to be opened.
    pub(crate) has_port: bool,
}

impl FaultState {
    /// Fits the machine with faults, which a controller switched on so knows nothing of.
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

    /// No faults yet.
    pub(crate) fn none(power_up: PowerUp) -> Self {
        Self {
            schedule: FaultSchedule::new(&[], 0),
            power_up,
            zeros_deg: [0.0; 4],
            before: Counted::default(),
            has_port: true,
        }
    }

    /// Ends what acts now; what is to happen to the arm by that comes with the time.
    pub(crate) fn end_all(&mut self, now: Duration) {
        self.schedule.end_all(now);
    }

    /// Puts other faults in place of those that are over, counted from now.
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
            .map(|it| it.counted_from(now, counted))
            .collect();
        self.schedule.replace(&faults, seed);
    }

    /// Takes the passing of time; says what is to happen to the arm, if something is.
    pub(crate) fn handle_time(
        &mut self,
        now: Duration,
        controller: &Controller,
    ) -> Option<ArmOrder> {
        self.schedule.handle_time(now, self.counted(controller));
        self.schedule.poll_order()
    }

    /// The controller that starts in place of another, from what the tilt sensors read.
    pub(crate) fn start_anew(
        &mut self,
        at: Duration,
        controller: &Controller,
        machine: &Mechanics,
        tilt: Tilt,
    ) -> Controller {
        self.before = self.counted(controller);
        let joints = machine.joints_at(at);
        let [_, rear_zero_deg, fore_zero_deg, _] = self.zeros_deg;
        Controller::power_up(PowerUp {
            rear_deg: joints.rear.0 - rear_zero_deg + tilt.rear_deg,
            fore_deg: joints.fore.0 - fore_zero_deg + tilt.fore_deg,
            ..self.power_up
        })
    }

    fn counted(&self, controller: &Controller) -> Counted {
        let counters = controller.counters();
        Counted {
            packets: self.before.packets + counters.packets,
            statuses: self.before.statuses + counters.statuses,
        }
    }
}
