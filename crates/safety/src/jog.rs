//! The path that a jog can cover until its release takes effect.

use dobot_arm::{Degrees, Joints, Millimeters, Position, TICK_S};
use dobot_motion::{ArmPlace, JogAxis, JogTrajectory, Model};
use dobot_wire::Command;

use crate::check::worst;
use crate::effective_rules::EffectiveRules;
use crate::limits::Limit;
use crate::path::Path;
use crate::path_check::PathCheck;
use crate::{Policy, Violation};

impl Policy {
    /// Checks the path that a jog can cover within a time, plus its deceleration; all other
    /// commands are allowed here.
    ///
    /// Call it at every status while a jog is held, with the model at that status and the
    /// [`reaction_s`](crate::JogRules::reaction_s) of the policy: at the first violation the jog
    /// must be released. The jog is assumed to be at full speed already. `within_s` is 0 or more.
    ///
    /// # Errors
    ///
    /// [`Violation`] with the rule that the jog would break.
    pub fn check_jog(
        &self,
        model: &Model,
        command: &Command,
        within_s: f64,
    ) -> Result<(), Violation> {
        let trajectory = model
            .trajectory(command)
            .map_err(|error| Violation::of_trajectory(&error))?;
        let Some(jog) = trajectory.jog() else {
            return Ok(());
        };
        let speed = jog.target_speed();
        self.check_jog_way(
            model,
            &jog,
            run_out(&jog, speed, within_s),
            trajectory.laser(),
        )?;
        let now = jog.speed_at(0.0);
        if now * speed < 0.0 {
            // It still moves the other way, and has to turn round first.
            return self.check_jog_way(model, &jog, run_out(&jog, now, 0.0), trajectory.laser());
        }
        Ok(())
    }

    fn check_jog_way(
        &self,
        model: &Model,
        jog: &JogTrajectory,
        by: f64,
        burning: bool,
    ) -> Result<(), Violation> {
        let Some(path) = path(model, jog.axis(), by) else {
            return Ok(());
        };
        let rules = EffectiveRules::new(self, model.tool, model.calibration, burning);
        PathCheck::begin(rules, &path)
            .map_err(|error| Violation::of_arm(&error))?
            .along(&path)
            .map_err(|breach| {
                let place = |share: f64| Some(model.calibrated_place(&path.place_at(share).ok()?));
                let worst = |limit: &Limit| worst(limit, &model.calibration, place);
                Violation::of_breach(&breach, worst).before_a_stop()
            })
    }
}

/// Returns how far a jog goes within a time and until it stands, with the sign of its speed. A
/// stock arm may be faster by one tick's acceleration.
fn run_out(jog: &JogTrajectory, speed: f64, within_s: f64) -> f64 {
    let acceleration = jog.acceleration();
    let fastest = speed.abs() + acceleration * TICK_S;
    (fastest * within_s + fastest * fastest / (2.0 * acceleration)).copysign(speed)
}

/// Returns the path of an axis over a distance, in degrees or mm; `None` if nothing else moves with
/// it.
fn path(model: &Model, axis: JogAxis, by: f64) -> Option<Path<'static>> {
    let ArmPlace { joints, pose } = model.place;
    let tool = model.tool;
    let turned = |change: fn(&mut Joints) -> &mut Degrees| {
        let mut to = joints;
        *change(&mut to) += Degrees(by);
        Some(Path::Joints {
            from: joints,
            to,
            tool,
        })
    };
    let shifted = |change: fn(&mut Position) -> &mut Millimeters| {
        let mut to = pose;
        *change(&mut to.position) += Millimeters(by);
        Some(Path::Line {
            from: pose,
            to,
            tool,
        })
    };
    match axis {
        JogAxis::Base => turned(|joints| &mut joints.base),
        JogAxis::Rear => turned(|joints| &mut joints.rear),
        JogAxis::Fore => turned(|joints| &mut joints.fore),
        JogAxis::Servo => turned(|joints| &mut joints.servo),
        JogAxis::X => shifted(|position| &mut position.x),
        JogAxis::Y => shifted(|position| &mut position.y),
        JogAxis::Z => shifted(|position| &mut position.z),
        JogAxis::Gripper => None,
    }
}
