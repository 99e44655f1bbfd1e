//! The arm and the rules that something is planned for.

use std::sync::Arc;

use dobot_api::{CalibrationFile, JobProgram, NewJob, State};
use dobot_arm::Calibration;
use dobot_motion::Model;
use dobot_supervisor::{JobPlan, Refusal};
use dobot_wire::{Dialect, Status};

use crate::Rules;

/// The arm, as it stands, and the rules that something is planned for.
#[derive(Clone, Debug)]
pub struct PlannedFor {
    /// The rules.
    pub rules: Arc<Rules>,
    /// The dialect, if known.
    pub dialect: Option<Dialect>,
    /// The raw status; `None` before the first one.
    pub status: Option<Status>,
    /// The calibration.
    pub calibration: Option<CalibrationFile>,
}

impl PlannedFor {
    /// Returns the arm in a state.
    #[must_use]
    pub fn of(rules: Arc<Rules>, state: &State) -> Self {
        let has_true_angles = state
            .calibrated
            .is_some_and(|calibrated| calibrated.zeros_told);
        let known = rules.calibrations.calibration.clone();
        let arm = state.arm.as_ref();
        Self {
            calibration: known.map(|known| {
                if has_true_angles {
                    known.without_zeros()
                } else {
                    known
                }
            }),
            rules,
            dialect: state.dialect,
            status: arm.map(|arm| arm.told.unwrap_or(arm.status)),
        }
    }

    /// Returns any arm that matches the drawing.
    #[must_use]
    pub fn any(rules: Arc<Rules>, dialect: Option<Dialect>) -> Self {
        Self {
            rules,
            dialect,
            status: None,
            calibration: None,
        }
    }

    /// Returns the dialect; if unknown, that of the specification.
    #[must_use]
    pub fn dialect(&self) -> Dialect {
        self.dialect.unwrap_or(Dialect::SPECIFICATION)
    }

    /// Returns the calibration for the kinematics.
    #[must_use]
    pub fn arm(&self) -> Calibration {
        let known = &self.calibration;
        known
            .as_ref()
            .map_or(Calibration::NONE, CalibrationFile::arm)
    }

    /// Returns why the rules refuse a job from where the arm stands, if they do.
    #[must_use]
    pub fn refuses(&self, job: &NewJob) -> Option<Refusal> {
        let commands = job.commands.clone();
        let plain = JobProgram::default();
        let policy = &self.rules.policy;
        JobPlan::new(policy, self.model(), commands, &[], job.lift_mm, 0, &plain).err()
    }

    /// Returns the model of the arm where it stands, as just after power-up.
    #[must_use]
    pub fn model(&self) -> Model {
        let status = self.status.unwrap_or(Status::AT_ZERO);
        Model::new(self.dialect(), &status).calibrated(self.arm())
    }
}
