//! The tools at the end of the arm, and all that differs between them.

use crate::Millimeters;

/// The tool mounted at the end of the arm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Tool {
    /// The suction cup.
    #[default]
    SuctionCup,
    /// The gripper.
    Gripper,
    /// A pen in its holder.
    Pen,
    /// The laser.
    Laser,
}

impl Tool {
    /// All tools.
    pub const ALL: [Self; 4] = [Self::SuctionCup, Self::Gripper, Self::Pen, Self::Laser];

    /// The tools of the protocol, each at its [`code`](Self::code) (Table 3.9; state 9, mode 4).
    pub const END_EFFECTORS: [Self; 3] = [Self::SuctionCup, Self::Gripper, Self::Laser];

    /// The table of the tools.
    const fn facts(self) -> Facts {
        match self {
            Self::SuctionCup => Facts {
                name: "suction_cup",
                option: "suction-cup",
                short: "cup",
                label: "suction cup",
                code: 0,
                reach: Millimeters(55.07),
                length: Millimeters(40.0),
                burns: false,
            },
            Self::Gripper => Facts {
                name: "gripper",
                option: "gripper",
                short: "gripper",
                label: "gripper",
                code: 1,
                reach: Millimeters(55.07),
                length: Millimeters(40.0),
                burns: false,
            },
            // Its holder takes the place of the suction cup.
            Self::Pen => Facts {
                name: "pen",
                option: "pen",
                short: "pen",
                label: "pen",
                ..Self::SuctionCup.facts()
            },
            Self::Laser => Facts {
                name: "laser",
                option: "laser",
                short: "laser",
                label: "laser",
                code: 2,
                reach: Millimeters(49.57),
                length: Millimeters(38.0),
                burns: true,
            },
        }
    }

    /// The tool with this name: its [`name`](Self::name), [`option`](Self::option) or [`short`](Self::short).
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let names = |tool: Self| [tool.name(), tool.option(), tool.short()];
        Self::ALL
            .into_iter()
            .find(|tool| names(*tool).contains(&name))
    }

    /// Its name in files and in the API, such as `suction_cup`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.facts().name
    }

    /// Its name on the command line and as a section of a file, such as `suction-cup`.
    #[must_use]
    pub const fn option(self) -> &'static str {
        self.facts().option
    }

    /// Its shortest name on the command line, such as `cup`.
    #[must_use]
    pub const fn short(self) -> &'static str {
        self.facts().short
    }

    /// Its name in a text, such as `suction cup`.
    #[must_use]
    pub const fn label(self) -> &'static str {
        self.facts().label
    }

    /// The tool that the arm is configured for when this one is mounted: one of
    /// [`END_EFFECTORS`](Self::END_EFFECTORS), with the same reach.
    #[must_use]
    pub const fn end_effector(self) -> Self {
        Self::END_EFFECTORS[self.code() as usize]
    }

    /// The value in the protocol for which the arm is configured: 0 to 2.
    #[must_use]
    pub const fn code(self) -> u8 {
        self.facts().code
    }

    /// The horizontal distance from the wrist to the tool's centre.
    #[must_use]
    pub const fn reach(self) -> Millimeters {
        self.facts().reach
    }

    /// The default distance of its tip below the wrist.
    #[must_use]
    pub const fn default_length(self) -> Millimeters {
        self.facts().length
    }

    /// Whether it marks by burning, so that the rules for the laser apply.
    #[must_use]
    pub const fn burns(self) -> bool {
        self.facts().burns
    }
}

/// A row of the table of the tools; each field is described at the function that returns it.
#[derive(Clone, Copy)]
struct Facts {
    name: &'static str,
    option: &'static str,
    short: &'static str,
    label: &'static str,
    code: u8,
    reach: Millimeters,
    length: Millimeters,
    burns: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_name_of_a_tool_finds_that_tool_and_no_other() {
        for tool in Tool::ALL {
            for name in [tool.name(), tool.option(), tool.short()] {
                assert_eq!(Tool::named(name), Some(tool), "{name}");
            }
        }
        for unknown in ["", "none", "Laser", "suction cup", "brush"] {
            assert_eq!(Tool::named(unknown), None, "{unknown}");
        }
    }

    #[test]
    fn the_arm_is_configured_for_an_end_effector_with_the_same_reach() {
        for tool in Tool::ALL {
            let configured = tool.end_effector();
            assert!(Tool::END_EFFECTORS.contains(&configured), "{tool:?}");
            assert_eq!(configured.reach(), tool.reach(), "{tool:?}");
            assert_eq!(configured.end_effector(), configured, "{tool:?}");
        }
        assert_eq!(Tool::Pen.end_effector(), Tool::SuctionCup);
    }

    #[test]
    fn the_codes_are_those_of_table_3_9() {
        let codes = [Tool::SuctionCup, Tool::Gripper, Tool::Laser].map(Tool::code);
        assert_eq!(codes, [0, 1, 2]);
        assert_eq!(Tool::END_EFFECTORS.map(Tool::code), codes);
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_tool_is_its_name_in_json() {
        for tool in Tool::ALL {
            let json = serde_json::to_value(tool).expect("a name");
            assert_eq!(json, tool.name());
            assert_eq!(serde_json::from_value::<Tool>(json).expect("a tool"), tool);
        }
    }
}
