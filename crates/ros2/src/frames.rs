//! The frames of `/tf` and `/tf_static` (REP 105), and the frames of received messages.

use dobot_model::{LinkFrame, Model};
use dobot_wire::Status;

use crate::joints::joints_of;
use crate::messages::{
    Header, Pose, PoseStamped, Quaternion, TfMessage, TransformStamped, Vector3,
};

/// The frame names of this arm: the links of its description, prefixed with the namespace if there
/// is one.
#[derive(Clone, Debug)]
pub(crate) struct Frames {
    prefix: String,
}

impl Frames {
    /// Returns the frames of a namespace, as `/desk_3`; `/` means no prefix.
    pub(crate) fn new(namespace: &str) -> Self {
        let name = namespace.trim_matches('/');
        let prefix = if name.is_empty() {
            String::new()
        } else {
            format!("{name}/")
        };
        Self { prefix }
    }

    /// Returns the frame of a link.
    pub(crate) fn of(&self, link: &str) -> String {
        format!("{}{link}", self.prefix)
    }

    /// Checks that a message is in the base frame, or in none, which means the base frame.
    ///
    /// # Errors
    ///
    /// The problem, and what is allowed.
    pub(crate) fn check_base(&self, header: &Header) -> Result<(), String> {
        let base = self.of("base");
        if header.frame_id.is_empty() || header.frame_id == base {
            return Ok(());
        }
        let found = &header.frame_id;
        Err(format!(
            "header.frame_id is {found:?}; allowed is {base:?}; transform the message first"
        ))
    }

    /// Returns the dynamic or the static transforms.
    pub(crate) fn transforms(&self, model: &Model, status: &Status, fixed: bool) -> TfMessage {
        let frames = model.link_frames(&joints_of(status)).into_iter();
        let wanted = frames.filter(|frame| frame.is_fixed == fixed);
        TfMessage {
            transforms: wanted.map(|wanted| self.transform(&wanted)).collect(),
        }
    }

    /// Returns the pose of the frame `tool` in the base frame.
    pub(crate) fn pose(&self, status: &Status) -> PoseStamped {
        let [x, y, z] = [status.x_mm, status.y_mm, status.z_mm].map(|mm| metres(f64::from(mm)));
        let turn_rad = f64::from(status.rotation_deg).to_radians();
        PoseStamped {
            header: Header::now(self.of("base")),
            pose: Pose {
                position: Vector3 { x, y, z },
                orientation: turned([0.0, 0.0, 1.0], turn_rad),
            },
        }
    }

    fn transform(&self, frame: &LinkFrame) -> TransformStamped {
        let [x, y, z] = frame.at_mm.map(metres);
        TransformStamped {
            header: Header::now(self.of(&frame.parent)),
            child_frame_id: self.of(&frame.child),
            transform: Pose {
                position: Vector3 { x, y, z },
                orientation: turned(frame.axis, frame.angle.0.to_radians()),
            },
        }
    }
}

/// Returns the rotation by an angle about a unit vector.
fn turned([x, y, z]: [f64; 3], angle_rad: f64) -> Quaternion {
    let (sin, w) = (angle_rad / 2.0).sin_cos();
    Quaternion {
        x: x * sin,
        y: y * sin,
        z: z * sin,
        w,
    }
}

/// Converts millimetres to metres.
pub(crate) fn metres(mm: f64) -> f64 {
    mm / 1000.0
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_arm::{Millimeters, Tool};
    use dobot_model::MountedTool;

    use super::*;

    fn model() -> Model {
        let tool = MountedTool::new(Tool::Pen, Millimeters(62.0)).expect("it is allowed");
        Model::new(Some(tool))
    }

    #[test]
    fn the_tip_is_always_below_the_tool() {
        let fixed = Frames::new("/").transforms(&model(), &Status::AT_ZERO, true);
        let [tip] = &fixed.transforms[..] else {
            panic!("{fixed:?}");
        };
        assert_eq!(
            (&*tip.header.frame_id, &*tip.child_frame_id),
            ("tool", "tip")
        );
        assert!((tip.transform.position.z + 0.062).abs() < 1e-12, "{tip:?}");
    }

    #[test]
    fn the_pose_is_that_of_the_status_in_metres() {
        let status = Status {
            x_mm: 220.0,
            y_mm: -50.0,
            z_mm: 60.0,
            rotation_deg: 180.0,
            ..Status::AT_ZERO
        };
        let found = Frames::new("/desk_3").pose(&status);
        assert_eq!(found.header.frame_id, "desk_3/base");
        let Vector3 { x, y, z } = found.pose.position;
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-9;
        assert!(
            near(x, 0.22) && near(y, -0.05) && near(z, 0.06),
            "{x} {y} {z}"
        );
        let turn = &found.pose.orientation;
        assert!(near(turn.z, 1.0) && near(turn.w, 0.0), "{turn:?}");
    }

    #[test]
    fn a_base_that_points_to_the_left_is_a_quarter_turn_about_z() {
        let status = Status {
            base_deg: 90.0,
            ..Status::AT_ZERO
        };
        let moving = Frames::new("/desk_3").transforms(&model(), &status, false);
        let turret = &moving.transforms[0];
        assert_eq!(turret.header.frame_id, "desk_3/base");
        assert_eq!(turret.child_frame_id, "desk_3/turret");
        let (turn, half) = (
            &turret.transform.orientation,
            std::f64::consts::FRAC_1_SQRT_2,
        );
        assert!(
            (turn.z - half).abs() < 1e-12 && (turn.w - half).abs() < 1e-12,
            "{turn:?}"
        );
        assert!(turn.x == 0.0 && turn.y == 0.0, "{turn:?}");
    }

    #[test]
    fn a_frame_other_than_the_base_is_refused_with_the_allowed_one() {
        let frames = Frames::new("/desk_3");
        for allowed in ["", "desk_3/base"] {
            assert_eq!(frames.check_base(&Header::now(allowed)), Ok(()));
        }
        let refused = frames.check_base(&Header::now("base")).unwrap_err();
        assert!(refused.contains("desk_3/base"), "{refused}");
    }
}
