//! Detection of the arm's dialect, while no client moves it.

use std::time::Duration;

use dobot_api::ClientId;
use dobot_arm::{Calibration, Joints, Tool};
use dobot_motion::ArmPlace;
use dobot_session::Detection;
use dobot_wire::{Finding, Packet, Status};

use super::arm::Arm;
use super::still_moving;
use crate::refusal::Refusal;

/// The running detection, if any, and the finding of the last one.
#[derive(Debug, Default)]
pub(super) struct Detecting {
    running: Option<RunningDetection>,
    finding: Option<Finding>,
    /// When the arm has finished the last packet of a detection, even of one that ended early.
    busy_until: Duration,
}

/// A running detection and its requester.
#[derive(Debug)]
struct RunningDetection {
    client: ClientId,
    detection: Detection,
}

impl Detecting {
    /// Starts a detection; the arm must be at rest.
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
        let tool = model.map_or(Tool::SuctionCup, |model| model.tool);
        let calibration = model.map_or(Calibration::NONE, |model| model.calibration);
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

    /// Returns how long the arm may still take for the packets of a detection: it finishes them
    /// even if the detection ends.
    pub(super) const fn motion(&self, now: Duration) -> Duration {
        self.busy_until.saturating_sub(now)
    }

    /// Handles a status; returns the next packet to send.
    pub(super) fn handle_status(&mut self, now: Duration, status: &Status) -> Option<Packet> {
        let RunningDetection { detection, .. } = self.running.as_mut()?;
        detection.handle_status(now, status);
        let packet = detection.poll_packet()?;
        self.busy_until = now + MOTION;
        Some(packet)
    }

    /// Returns the outcome and its requester once the detection is over.
    pub(super) fn poll_outcome(&mut self) -> Option<(ClientId, Result<Finding, Refusal>)> {
        let RunningDetection { client, detection } = self.running.as_mut()?;
        let (client, outcome) = (*client, detection.poll_outcome()?);
        self.running = None;
        if outcome.is_ok() {
            // Its last packets only configure the arm, which was at rest before.
            self.busy_until = Duration::ZERO;
        }
        let found = outcome.map_err(|error| Refusal::NotFound(error.to_string()));
        self.finding = found.as_ref().ok().cloned().or(self.finding.take());
        Some((client, found))
    }

    /// Aborts the detection; returns its requester.
    pub(super) fn end(&mut self) -> Option<ClientId> {
        self.running.take().map(|running| running.client)
    }

    /// Returns how the dialect was detected, if it was.
    pub(super) const fn finding(&self) -> Option<&Finding> {
        self.finding.as_ref()
    }

    /// Drops the finding because the dialect was set by hand.
    pub(super) fn forget_finding(&mut self) {
        self.finding = None;
    }
}

/// No motion of the detection takes longer.
const MOTION: Duration = Duration::from_secs(5);
