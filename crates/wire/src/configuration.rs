//! Configuration.

use dobot_arm::Tool;

use crate::table::Table;
use crate::{Dialect, Frame, ParseError};

/// Sets the parameters of the arm (state 9; Table 3.9). Speeds and accelerations are above 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(
    feature = "serde",
    serde(tag = "mode", rename_all = "snake_case", deny_unknown_fields)
)]
pub enum Configuration {
    /// How fast a jog is (mode 0).
    Teach {
        /// The speed of base, rear arm and forearm, in degrees/s.
        joint_speed_deg_s: f32,
        /// Their acceleration, in degrees/s2.
        joint_acceleration_deg_s2: f32,
        /// The speed of the servo (joint 4), in degrees/s.
        servo_speed_deg_s: f32,
        /// Its acceleration, in degrees/s2.
        servo_acceleration_deg_s2: f32,
        /// The speed along an axis, in mm/s.
        linear_speed_mm_s: f32,
        /// The acceleration along an axis, in mm/s2.
        linear_acceleration_mm_s2: f32,
    },
    /// How fast a target is reached (mode 1).
    Playback {
        /// The largest speed of base, rear arm and forearm, in degrees/s.
        joint_speed_deg_s: f32,
        /// Their largest acceleration, in degrees/s2.
        joint_acceleration_deg_s2: f32,
        /// The largest speed of the servo, in degrees/s.
        servo_speed_deg_s: f32,
        /// Its largest acceleration, in degrees/s2.
        servo_acceleration_deg_s2: f32,
        /// The largest speed along a line, in mm/s.
        linear_speed_mm_s: f32,
        /// The largest acceleration along a line, in mm/s2.
        linear_acceleration_mm_s2: f32,
        /// The pause of targets that have none, 0 to 655 seconds (note N10).
        default_pause_s: f32,
        /// How high a JUMP lifts, 0 or above, in millimetres (note N11).
        jump_height_mm: f32,
    },
    /// How fast a line is written (mode 2).
    Writing {
        /// The acceleration, in mm/s2.
        acceleration_mm_s2: f32,
    },
    /// Where the arm is, said by hand (mode 3; note N8).
    InitialAngles {
        /// The rear arm's angle in degrees from the vertical, whatever the dialect's form.
        rear_deg: f32,
        /// The forearm's angle in degrees below the horizontal.
        fore_deg: f32,
    },
    /// The end effector (mode 4).
    EndEffector {
        /// The tool.
        #[cfg_attr(feature = "schema", schemars(with = "Tool"))]
        tool: EndEffector,
    },
}

impl Configuration {
    /// Float 1 of this command.
    pub const STATE: f32 = 9.0;

    /// How fast a jog is: the six numbers of [`speeds`](Self::speeds).
    #[must_use]
    pub const fn teach(speeds: [f32; 6]) -> Self {
        let [joint, joint_ramp, servo, servo_ramp, linear, linear_ramp] = speeds;
        Self::Teach {
            joint_speed_deg_s: joint,
            joint_acceleration_deg_s2: joint_ramp,
            servo_speed_deg_s: servo,
            servo_acceleration_deg_s2: servo_ramp,
            linear_speed_mm_s: linear,
            linear_acceleration_mm_s2: linear_ramp,
        }
    }

    /// How fast a target is reached: the six numbers of [`speeds`](Self::speeds), the pause of targets
    /// that have none, and how high a JUMP lifts.
    #[must_use]
    pub const fn playback(speeds: [f32; 6], default_pause_s: f32, jump_height_mm: f32) -> Self {
        let [joint, joint_ramp, servo, servo_ramp, linear, linear_ramp] = speeds;
        Self::Playback {
            joint_speed_deg_s: joint,
            joint_acceleration_deg_s2: joint_ramp,
            servo_speed_deg_s: servo,
            servo_acceleration_deg_s2: servo_ramp,
            linear_speed_mm_s: linear,
            linear_acceleration_mm_s2: linear_ramp,
            default_pause_s,
            jump_height_mm,
        }
    }

    /// The speeds of modes 0 and 1: speed and acceleration of base, rear arm and forearm
    /// in degrees/s and degrees/s2, the same of the servo, and along a line in mm/s and mm/s2.
    #[must_use]
    pub const fn speeds(&self) -> Option<[f32; 6]> {
        match *self {
            Self::Teach {
                joint_speed_deg_s: joint,
                joint_acceleration_deg_s2: joint_ramp,
                servo_speed_deg_s: servo,
                servo_acceleration_deg_s2: servo_ramp,
                linear_speed_mm_s: linear,
                linear_acceleration_mm_s2: linear_ramp,
            }
            | Self::Playback {
                joint_speed_deg_s: joint,
                joint_acceleration_deg_s2: joint_ramp,
                servo_speed_deg_s: servo,
                servo_acceleration_deg_s2: servo_ramp,
                linear_speed_mm_s: linear,
                linear_acceleration_mm_s2: linear_ramp,
                ..
            } => Some([joint, joint_ramp, servo, servo_ramp, linear, linear_ramp]),
            _ => None,
        }
    }

    /// Reads the command.
    ///
    /// # Errors
    ///
    /// [`ParseError::OutOfRange`] where a float breaks its range in Table 3.9.
    pub fn parse(frame: &Frame, dialect: &Dialect) -> Result<Self, ParseError> {
        TABLE.state(frame, Self::STATE, "9")?;
        let modes = [
            parse_teach,
            parse_playback,
            parse_writing,
            parse_initial_angles,
            parse_end_effector,
        ];
        let parse = TABLE.float(frame, 2, "mode").code(&modes, "0 to 4")?;
        parse(frame, dialect)
    }

    /// Writes the command; `parse` reads it back unchanged, but for the rounding of `90 - rear`
    /// (up to 8e-6 degrees) in a dialect that complements the initial angle.
    #[must_use]
    pub fn emit(&self, dialect: &Dialect) -> Frame {
        let frame = Frame::ZERO.with(1, Self::STATE);
        let speeds = self.speeds().into_iter().flatten().zip(3..);
        let frame = speeds.fold(frame, |frame, (speed, n)| frame.with(n, speed));
        match *self {
            Self::Teach { .. } => frame.with(2, 0.0),
            Self::Playback {
                default_pause_s,
                jump_height_mm,
                ..
            } => frame
                .with(2, 1.0)
                .with(9, default_pause_s)
                .with(10, jump_height_mm),
            Self::Writing { acceleration_mm_s2 } => frame.with(2, 2.0).with(3, acceleration_mm_s2),
            Self::InitialAngles { rear_deg, fore_deg } => frame
                .with(2, 3.0)
                .with(3, dialect.initial_rear(rear_deg))
                .with(4, fore_deg),
            Self::EndEffector { tool } => frame.with(2, 4.0).with(3, tool.emit()),
        }
    }
}

impl Dialect {
    /// Turns float 3 of mode 3 into the rear arm's angle, and back (note N8).
    pub(crate) fn initial_rear(&self, rear_deg: f32) -> f32 {
        if self.complements_initial_rear {
            90.0 - rear_deg
        } else {
            rear_deg
        }
    }
}

/// The tool for which the arm is configured (state 9, mode 4; Table 3.9).
///
/// The protocol defines three; any other tool is encoded as its [`Tool::end_effector`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "Tool", into = "Tool"))]
pub struct EndEffector(Tool);

impl EndEffector {
    fn parse(frame: &Frame) -> Result<Self, ParseError> {
        let allowed = "0 (suction cup), 1 (gripper) or 2 (laser)";
        TABLE
            .float(frame, 3, "end effector")
            .code(&Tool::END_EFFECTORS.map(Self), allowed)
    }

    fn emit(self) -> f32 {
        f32::from(self.0.code())
    }
}

impl From<Tool> for EndEffector {
    fn from(tool: Tool) -> Self {
        Self(tool.end_effector())
    }
}

impl From<EndEffector> for Tool {
    fn from(EndEffector(tool): EndEffector) -> Self {
        tool
    }
}

fn parse_teach(frame: &Frame, _: &Dialect) -> Result<Configuration, ParseError> {
    let names = [
        "joint jog speed",
        "joint jog acceleration",
        "joint 4 speed",
        "joint 4 acceleration",
        "linear jog speed",
        "linear jog acceleration",
    ];
    Ok(Configuration::teach(parse_speeds(frame, names)?))
}

fn parse_playback(frame: &Frame, _: &Dialect) -> Result<Configuration, ParseError> {
    let names = [
        "max joint moving speed",
        "max joint moving acceleration",
        "max servo speed",
        "max servo acceleration",
        "max linear moving speed",
        "max linear moving acceleration",
    ];
    Ok(Configuration::playback(
        parse_speeds(frame, names)?,
        TABLE.float(frame, 9, "default pause time").pause()?,
        TABLE.float(frame, 10, "JUMP height").not_negative()?,
    ))
}

fn parse_speeds(frame: &Frame, names: [&'static str; 6]) -> Result<[f32; 6], ParseError> {
    let mut speeds = [0.0; 6];
    for (i, name) in names.into_iter().enumerate() {
        speeds[i] = TABLE.float(frame, i + 3, name).positive()?;
    }
    Ok(speeds)
}

fn parse_writing(frame: &Frame, _: &Dialect) -> Result<Configuration, ParseError> {
    Ok(Configuration::Writing {
        acceleration_mm_s2: TABLE.float(frame, 3, "writing acceleration").positive()?,
    })
}

fn parse_initial_angles(frame: &Frame, dialect: &Dialect) -> Result<Configuration, ParseError> {
    Ok(Configuration::InitialAngles {
        rear_deg: dialect.initial_rear(TABLE.float(frame, 3, "joint2 angle").finite()?),
        fore_deg: TABLE.float(frame, 4, "joint3 angle").finite()?,
    })
}

fn parse_end_effector(frame: &Frame, _: &Dialect) -> Result<Configuration, ParseError> {
    Ok(Configuration::EndEffector {
        tool: EndEffector::parse(frame)?,
    })
}

const TABLE: Table = Table("Table 3.9");
