//! Finding out which dialect the arm speaks, while nobody else moves it.

use std::time::Duration;

use dobot_api::ClientId;
use dobot_arm::{Calibration, Joints, Tool};
use dobot_motion::ArmPlace;
use dobot_session::Detection;
use dobot_wire::{Finding, Packet, Status};

use super::arm::Arm;
use super::still_moving;
use crate::refusal::Refusal;

/// The detection that is under way, if one is, and what the last one found.
#[derive(Debug, Default)]
pub(super) struct Detecting {
    running: Option<RunningDetection>,
    finding: Option<Finding>,
    /// By when the arm is through with the last packet of a detection, even of one that ended early.
    busy_until: Duration,
}

/// A detection, and who asked for it.
#[derive(Debug)]
struct RunningDetection {
    client: ClientId,
    detection: Detection,
}

impl Detecting {
    /// Begins, where the arm rests.
    pub(super) fn begin(
        &mut self,
        client: ClientId,
        arm: &Arm,
        rests_within: Duration,
    ) -> Result<(), Refusal> {
        let Some(status) = arm.last().filter(|_| arm.is_at_rest()) else {
            return Err(still_moving(rests_within));
        };
        let model = arm.session().model();
        let tool = model.map_or(Tool::SuctionCup, |it| it.tool);
        let calibration = model.map_or(Calibration::NONE, |it| it.calibration);
        let allowed = |joints: &Joints| {
            let place = ArmPlace::at_joints(*joints, tool);
            let checked = arm.policy().check_place(&place, tool, &calibration);
            checked.is_ok()
        };
        let detection = Detection::new(&status, allowed)
            .map_err(|error| Refusal::NotFound(error.to_string()))?;
        self.running = Some(RunningDetection { client, detection });
        Ok(())
    }

    pub(super) const fn check(&self) -> Result<(), Refusal> {
        match self.running {
            None => Ok(()),
            Some(_) => Err(Refusal::Detecting),
        }
    }

    /// How long the arm may still be at what it was asked: what it has, it does, whatever becomes of the
    /// detection.
    pub(super) const fn motion(&self, now: Duration) -> Duration {
        self.busy_until.saturating_sub(now)
    }

    /// With each status: what is to be sent now.
    pub(super) fn handle_status(&mut self, now: Duration, status: &Status) -> Option<Packet> {
        let RunningDetection { detection, .. } = self.running.as_mut()?;
        detection.handle_status(now, status);
        let packet = detection.poll_packet()?;
        self.busy_until = now + MOTION;
        Some(packet)
    }

    /// What came of it, and who asked for it, once it is over.
    pub(super) fn poll_outcome(&mut self) -> Option<(ClientId, Result<Finding, Refusal>)> {
        let RunningDetection { client, detection } = self.running.as_mut()?;
        let (client, outcome) = (*client, detection.poll_outcome()?);
        self.running = None;
        if outcome.is_ok() {
            // Its last packets configure, and the arm rested before.
            self.busy_until = Duration::ZERO;
        }
        let found = outcome.map_err(|error| Refusal::NotFound(error.to_string()));
        self.finding = found.as_ref().ok().cloned().or(self.finding.take());
        Some((client, found))
    }

    /// Ends a detection that cannot go on; says whose it was.
    pub(super) fn end(&mut self) -> Option<ClientId> {
        self.running.take().map(|it| it.client)
    }

    /// How the dialect was found, if the arm was asked for it.
    pub(super) const fn finding(&self) -> Option<&Finding> {
        self.finding.as_ref()
    }

    /// Somebody says the dialect.
    pub(super) fn forget_finding(&mut self) {
        self.finding = None;
    }
}

/// None of the motions takes longer.
const MOTION: Duration = Duration::from_secs(5);
