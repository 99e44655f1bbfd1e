//! An arm before a policy, and short words for commands.

use dobot_arm::{Degrees, Joints, Pose, Position, Tool};
use dobot_motion::{ArmPlace, Model, Trajectory};
use dobot_safety::{Policy, Violation};
use dobot_wire::{
    Command, Dialect, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MoveJoints, MoveTo,
    MovingMode, WriteVector,
};

/// An arm at rest at a point, and its policy.
#[derive(Clone, Debug)]
pub(crate) struct Desk {
    pub(crate) policy: Policy,
    pub(crate) model: Model,
}

impl Desk {
    /// The arm is at x, y, z in mm, the tool turned to 0 degrees.
    #[track_caller]
    pub(crate) fn at(x: f64, y: f64, z: f64) -> Self {
        let pose = Pose {
            position: Position::new(x, y, z),
            rotation: Degrees(y.atan2(x).to_degrees()),
        };
        let place = ArmPlace::at_pose(pose, Tool::SuctionCup).expect("the arm can be there");
        Self::standing(place)
    }

    /// The arm has these joint angles in degrees, the servo at 0.
    pub(crate) fn with_joints(base: f64, rear: f64, fore: f64) -> Self {
        Self::standing(ArmPlace::at_joints(
            Joints::new(base, rear, fore, 0.0),
            Tool::SuctionCup,
        ))
    }

    fn standing(place: ArmPlace) -> Self {
        Self {
            policy: Policy::default(),
            model: Model::standing(Dialect::SPECIFICATION, place),
        }
    }

    /// The desk with the default policy plus these keys.
    #[track_caller]
    pub(crate) fn under(mut self, policy: &str) -> Self {
        self.policy = Policy::from_toml(policy).expect("it is a policy");
        self
    }

    pub(crate) fn speaking(mut self, dialect: Dialect) -> Self {
        self.model = Model::standing(dialect, self.model.place);
        self
    }

    pub(crate) fn check(&self, command: impl Into<Command>) -> Result<Trajectory, Violation> {
        self.policy.check(&self.model, &command.into())
    }

    #[track_caller]
    pub(crate) fn allows(&self, command: impl Into<Command>) -> Trajectory {
        match self.check(command) {
            Ok(trajectory) => trajectory,
            Err(violation) => panic!("refused: {violation}"),
        }
    }

    /// Refuses by this rule.
    #[track_caller]
    pub(crate) fn refuses(&self, rule: &str, command: impl Into<Command>) -> Violation {
        let violation = self.check(command).expect_err("it must not be allowed");
        assert_eq!(violation.rule, rule, "{violation}");
        violation
    }
}

pub(crate) fn go(mode: MovingMode, x: f32, y: f32, z: f32) -> MoveTo {
    MoveTo {
        rotation_deg: y.atan2(x).to_degrees(),
        mode,
        ..MoveTo::to(x, y, z)
    }
}

pub(crate) fn turn(mode: MovingMode, base: f32, rear: f32, fore: f32) -> MoveJoints {
    MoveJoints::to([base, rear, fore, 0.0]).with_mode(mode)
}

pub(crate) fn vector(x: f32, y: f32, z: f32) -> WriteVector {
    WriteVector::by(x, y, z, 40.0)
}

pub(crate) fn burning(x: f32, y: f32) -> WriteVector {
    vector(x, y, 0.0).burning()
}

pub(crate) fn jog(axis: JointJogAxis, speed_percent: f32) -> JointJog {
    JointJog::new(axis, speed_percent)
}

pub(crate) fn slide(axis: LinearJogAxis, speed_percent: f32) -> LinearJog {
    LinearJog::new(axis, speed_percent)
}

/// Fails unless two numbers are as near as `tolerance`.
#[track_caller]
pub(crate) fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "found {found}, expected {expected}, tolerance {tolerance}"
    );
}
