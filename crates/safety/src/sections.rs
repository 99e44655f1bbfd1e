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
    /// How far each joint may turn, in degrees; never further than the arm itself can.
    JointLimits {
        /// Joint 1: -180 to 180 at most, though the cables want no more than 135.
        base_deg: Bounds = Bounds::new(-135.0, 135.0),
        /// Joint 2, from the vertical, forward positive: -5 to 85 at most.
        rear_deg: Bounds = Bounds::new(-5.0, 85.0),
        /// Joint 3, below the horizontal: -10 to 95 at most.
        fore_deg: Bounds = Bounds::new(-10.0, 95.0),
        /// Joint 4: -90 to 90 at most.
        servo_deg: Bounds = Bounds::new(-90.0, 90.0),
        /// Joint 2 minus joint 3, how far the elbow opens: -105 to 35 at most.
        opening_deg: Bounds = Bounds::new(-105.0, 35.0),
    }
}

section! {
    /// Where the tool may be, in mm: x, y and z as the arm tells them (z is the height of the wrist).
    Workspace {
        /// Forward: -321 to 321 at most.
        x_mm: Bounds = Bounds::new(-321.0, 321.0),
        /// To the left: -321 to 321 at most.
        y_mm: Bounds = Bounds::new(-321.0, 321.0),
        /// Up: -300 to 136 at most.
        z_mm: Bounds = Bounds::new(-103.0, 136.0),
        /// Horizontally from the axis of the base: 129 to 321 at most.
        reach_mm: Bounds = Bounds::new(129.0, 321.0),
    }
}

section! {
    /// The table, which no tool tip may go into.
    Table {
        /// The height of its surface in the base frame, in mm: -300 to 136.
        z_mm: f64 = -103.0,
        /// How far below the paper a tool tip may be where a calibration knows how the paper lies, in mm: 0 to 300.
        below_paper_mm: f64 = 5.0,
    }
}

section! {
    /// How far the tip of each tool hangs below the wrist, in mm: 0 to 200.
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
    /// How thick the arm is where keep-outs are concerned.
    ArmBody {
        /// How much arm there is around the lines through its links, in mm: 0 to 100.
        radius_mm: f64 = 20.0,
    }
}

section! {
    /// The highest speeds: what is configured times its percentage.
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
    /// The highest accelerations: what is configured times its percentage.
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
    /// JUMP moves.
    JumpRules {
        /// The highest that may be configured, in mm: 0 to 300.
        height_mm: f64 = 150.0,
    }
}

section! {
    /// When and where the laser may burn.
    LaserRules {
        /// Whether anything may light it at all.
        allowed: bool = true,
        /// For how long a person arms it at most, in s: 1 to 3600.
        arm_for_s: f64 = 600.0,
        /// The least of the largest speed of a burning vector, in mm/s: 0 to 1000.
        least_speed_mm_s: f64 = 1.0,
        /// How long a vector may burn, in s: 0.1 to 3600. The arm finishes what it has received, so it burns on for so
        /// long after a stop.
        longest_s: f64 = 3600.0,
        /// Whether it may burn while the arm stands.
        standing: bool = false,
        /// Where it may burn: x, y and z as the arm tells them.
        area: Area = Area {
            x_mm: Bounds::new(130.0, 321.0),
            y_mm: Bounds::new(-200.0, 200.0),
            z_mm: Bounds::new(-103.0, 60.0),
        },
    }
}

section! {
    /// Jogs, which go on until they are told otherwise.
    JogRules {
        /// After this long without a word from the client a jog is released, in s: 0.05 to 2.
        dead_man_s: f64 = 0.15,
        /// The same for old programs on the raw port, which repeat every 0.5 s, in s: 0.05 to 5.
        raw_dead_man_s: f64 = 1.2,
        /// How long it takes from a place to the release in force, in s: 0.05 to 2.
        reaction_s: f64 = 0.25,
    }
}

section! {
    /// What waits in the arm.
    QueueRules {
        /// How long before the arm should begin a command it may be sent, in s: 0 to 60. So long after a stop
        /// the arm may begin another motion.
        ahead_s: f64 = 0.5,
        /// How long a straight line (MOVL) of a client may take, in s: 0.5 to 3600. A longer one is sent in pieces, between which
        /// the arm stands for a moment; after a stop it finishes the piece that it is at.
        line_s: f64 = 3600.0,
    }
}

impl ToolLengths {
    /// How far the tip of this tool hangs below the wrist, in mm.
    #[must_use]
    pub const fn of(&self, tool: Tool) -> f64 {
        // In the order of `Tool::END_EFFECTORS`.
        [self.suction_cup_mm, self.gripper_mm, self.laser_mm][tool.code() as usize]
    }
}
