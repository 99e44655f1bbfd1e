//! For which arm something is planned, and by which rules.

use std::sync::Arc;

use dobot_api::{CalibrationFile, JobProgram, NewJob, State};
use dobot_arm::Calibration;
use dobot_motion::Model;
use dobot_supervisor::{JobPlan, Refusal};
use dobot_wire::{Dialect, Status};

use crate::Rules;

/// For which arm something is planned, as it stands, and by which rules.
#[derive(Clone, Debug)]
pub struct PlannedFor {
    /// By which rules.
    pub rules: Arc<Rules>,
    /// What the arm speaks, if that is known.
    pub dialect: Option<Dialect>,
    /// What it says itself; nothing before it has said anything.
    pub status: Option<Status>,
    /// How it differs from what it says.
    pub calibration: Option<CalibrationFile>,
}

impl PlannedFor {
    /// The arm in a state.
    #[must_use]
    pub fn of(rules: Arc<Rules>, state: &State) -> Self {
        let told = state.calibrated.is_some_and(|it| it.zeros_told);
        let known = rules.calibrations.calibration.clone();
        let arm = state.arm.as_ref();
        Self {
            calibration: known.map(|it| if told { it.without_zeros() } else { it }),
            rules,
            dialect: state.dialect,
            status: arm.map(|it| it.told.unwrap_or(it.status)),
        }
    }

    /// Any arm, as drawn.
    #[must_use]
    pub fn any(rules: Arc<Rules>, dialect: Option<Dialect>) -> Self {
        Self {
            rules,
            dialect,
            status: None,
            calibration: None,
        }
    }

    /// The dialect; while nobody knows it, that of the document.
    #[must_use]
    pub fn dialect(&self) -> Dialect {
        self.dialect.unwrap_or(Dialect::SPECIFICATION)
    }

    /// What is wrong with it.
    #[must_use]
    pub fn arm(&self) -> Calibration {
        let known = &self.calibration;
        known
            .as_ref()
            .map_or(Calibration::NONE, CalibrationFile::arm)
    }

    /// Why the rules do not let the arm do a job from where it stands, if they do not.
    #[must_use]
    pub fn refuses(&self, job: &NewJob) -> Option<Refusal> {
        let commands = job.commands.clone();
        let plain = JobProgram::default();
        let policy = &self.rules.policy;
        JobPlan::new(policy, self.model(), commands, &[], job.lift_mm, 0, &plain).err()
    }

    /// The arm where it stands, as it is when it has just been switched on.
    #[must_use]
    pub fn model(&self) -> Model {
        let status = self.status.unwrap_or(Status::AT_ZERO);
        Model::new(self.dialect(), &status).calibrated(self.arm())
    }
}
