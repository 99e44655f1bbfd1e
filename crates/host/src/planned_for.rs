//! The arm and the rules that something is planned for.

use std::sync::Arc;

use dobot_api::{CalibrationFile, JobProgram, NewJob, State};
use dobot_arm::{Calibration, Joints, Tool};
use dobot_controller::PowerUp;
use dobot_motion::{ArmPlace, Model};
use dobot_supervisor::{JobPlan, Refusal};
use dobot_wire::{Command, Dialect, Status};

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
    /// The commands that give the arm's settings to one that was just switched on.
    pub settings: Vec<Command>,
    /// The calibration.
    pub calibration: Option<CalibrationFile>,
}

impl PlannedFor {
    /// Returns the arm in a state.
    #[must_use]
    pub fn of(rules: Arc<Rules>, state: &State) -> Self {
        let has_true_angles = state
            .calibrated
            .is_some_and(|calibrated| calibrated.angles_set);
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
            settings: state.settings.clone(),
            status: arm.map(|arm| arm.raw.unwrap_or(arm.status)),
        }
    }

    /// Returns an arm that was just switched on.
    #[must_use]
    pub fn any(rules: Arc<Rules>, dialect: Option<Dialect>) -> Self {
        Self {
            rules,
            dialect,
            status: None,
            settings: Vec::new(),
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

    /// Returns the raw status of the arm; before the first one, that of an arm that was just
    /// switched on, in the usual pose (note N28).
    #[must_use]
    pub fn status(&self) -> Status {
        self.status.unwrap_or_else(|| {
            let PowerUp {
                rear_deg, fore_deg, ..
            } = PowerUp::default();
            let joints = Joints::new(0.0, rear_deg, fore_deg, 0.0);
            ArmPlace::at_joints(joints, Tool::SuctionCup).status()
        })
    }

    /// Returns the model of the arm as it stands.
    #[must_use]
    pub fn model(&self) -> Model {
        let status = self.status();
        let mut model = Model::new(self.dialect(), &status);
        for command in &self.settings {
            if let Ok(trajectory) = model.trajectory(command) {
                model = model.after(command, &trajectory);
            }
        }
        model.observe(&status);
        model.calibrated(self.arm())
    }
}
