//! The sections of a policy, each with its default.

use dobot_arm::Tool;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Area, Bounds};

macro_rules! section {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty = $default:expr,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
        #[serde(default, deny_unknown_fields)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)* }
            }
        }
    };
}

section! {
    /// The limits of the joints, in degrees; never beyond what the arm itself can do.
    JointLimits {
        /// Joint 1: -180 to 180 at most, but the cables need 135 or less.
        base_deg: Bounds = Bounds::new(-135.0, 135.0),
        /// Joint 2, from the vertical, forward positive: -5 to 85 at most.
        rear_deg: Bounds = Bounds::new(-5.0, 85.0),
        /// Joint 3, below the horizontal: -10 to 95 at most.
        fore_deg: Bounds = Bounds::new(-10.0, 95.0),
        /// Joint 4: -90 to 90 at most.
        servo_deg: Bounds = Bounds::new(-90.0, 90.0),
        /// Joint 2 minus joint 3, the opening of the elbow: -105 to 35 at most.
        opening_deg: Bounds = Bounds::new(-105.0, 35.0),
    }
}

section! {
    /// The limits of the tool's position in the base frame, in mm (z is the height of the wrist).
    Workspace {
        /// Forward: -321 to 321 at most.
        x_mm: Bounds = Bounds::new(-321.0, 321.0),
        /// To the left: -321 to 321 at most.
        y_mm: Bounds = Bounds::new(-321.0, 321.0),
        /// Up: -300 to 136 at most.
        z_mm: Bounds = Bounds::new(-103.0, 136.0),
        /// Horizontal distance from the axis of the base: 129 to 321 at most.
        reach_mm: Bounds = Bounds::new(129.0, 321.0),
    }
}

section! {
    /// The table, which the tool tip may not enter.
    Table {
        /// The height of its surface in the base frame, in mm: -300 to 136.
        z_mm: f64 = -103.0,
        /// How far below the paper a tool tip may be if the calibration includes the paper, in mm:
        /// 0 to 300.
        below_paper_mm: f64 = 5.0,
    }
}

section! {
    /// How far the tip of each tool is below the wrist, in mm: 0 to 200.
    ToolLengths {
        /// The suction cup; the pen too.
        suction_cup_mm: f64 = Tool::SuctionCup.default_length().0,
        /// The gripper.
        gripper_mm: f64 = Tool::Gripper.default_length().0,
        /// The laser.
        laser_mm: f64 = Tool::Laser.default_length().0,
    }
}

section! {
    /// The thickness of the arm, for keep-outs.
    ArmBody {
        /// The radius of the arm around the lines through its links, in mm: 0 to 100.
        radius_mm: f64 = 20.0,
    }
}

section! {
    /// The highest speeds: configured speed times its percentage.
    SpeedCeilings {
        /// Base, rear arm and forearm, in degrees/s: above 0 to 1000.
        joint_deg_s: f64 = 200.0,
        /// The servo, in degrees/s: above 0 to 1000.
        servo_deg_s: f64 = 200.0,
        /// The tool, in mm/s: above 0 to 1000.
        line_mm_s: f64 = 200.0,
        /// Writing and laser vectors, in mm/s: above 0 to 1000.
        writing_mm_s: f64 = 200.0,
        /// The percentage of a jog: 1 to 100.
        jog_percent: f64 = 100.0,
    }
}

section! {
    /// The highest accelerations: configured acceleration times its percentage.
    AccelerationCeilings {
        /// Base, rear arm and forearm, in degrees/s2: above 0 to 10000.
        joint_deg_s2: f64 = 500.0,
        /// The servo, in degrees/s2: above 0 to 10000.
        servo_deg_s2: f64 = 500.0,
        /// The tool, in mm/s2: above 0 to 10000.
        line_mm_s2: f64 = 500.0,
        /// Writing and laser vectors, in mm/s2: above 0 to 10000.
        writing_mm_s2: f64 = 500.0,
    }
}

section! {
    /// The rules for JUMP moves.
    JumpRules {
        /// The highest configurable JUMP height, in mm: 0 to 300.
        height_mm: f64 = 150.0,
    }
}

section! {
    /// When and where the laser may burn.
    LaserRules {
        /// Whether the laser may be switched on at all.
        allowed: bool = true,
        /// The longest time for which a person may arm it, in s: 1 to 3600.
        arm_for_s: f64 = 600.0,
        /// The minimum of the highest speed of a burning vector, in mm/s: 0 to 1000.
        least_speed_mm_s: f64 = 1.0,
        /// The longest duration of a burning vector, in s: 0.1 to 3600. The arm finishes the
        /// vectors it has received, so the laser may burn this long after a stop.
        longest_s: f64 = 3600.0,
        /// Whether it may burn while the arm stands still.
        standing: bool = false,
        /// Where it may burn: x, y and z as in the workspace.
        area: Area = Area {
            x_mm: Bounds::new(130.0, 321.0),
            y_mm: Bounds::new(-200.0, 200.0),
            z_mm: Bounds::new(-103.0, 60.0),
        },
    }
}

section! {
    /// The rules for jogs, which continue until they are released.
    JogRules {
        /// The time without a message from the client after which a jog is released, in s: 0.05 to
        /// 2.
        dead_man_s: f64 = 0.15,
        /// The dead-man time for old programs on the raw port, which repeat every 0.5 s, in s: 0.05
        /// to 5.
        raw_dead_man_s: f64 = 1.2,
        /// The time from a position to the effect of a release there, in s: 0.05 to 2.
        reaction_s: f64 = 0.25,
    }
}

section! {
    /// The rules for commands waiting in the arm.
    QueueRules {
        /// How early a command may be sent before the arm should begin it, in s: 0 to 60. The arm
        /// may still begin another motion this long after a stop.
        ahead_s: f64 = 0.5,
        /// The longest duration of a client's straight line (MOVL), in s: 0.5 to 3600. A longer
        /// line is sent in pieces, between which the arm stands still for a moment; after a stop
        /// the arm finishes the current piece.
        line_s: f64 = 3600.0,
    }
}

section! {
    /// The rules for spoken orders.
    VoiceRules {
        /// The longest distance of one spoken order, in mm: 1 to 1000. It may have been
        /// misunderstood.
        largest_mm: f64 = 50.0,
    }
}

impl ToolLengths {
    /// Returns how far the tip of this tool is below the wrist, in mm.
    #[must_use]
    pub const fn of(&self, tool: Tool) -> f64 {
        // In the order of `Tool::END_EFFECTORS`.
        [self.suction_cup_mm, self.gripper_mm, self.laser_mm][tool.code() as usize]
    }
}
