//! The policy as a whole.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::validate::{line_of, problem};
use crate::{
    AccelerationCeilings, ArmBody, JogRules, JointLimits, JumpRules, KeepOut, LaserRules,
    PolicyError, QueueRules, SpeedCeilings, Table, ToolLengths, Workspace,
};

/// What no command of any client may do.
///
/// What a file does not say is as in [`Policy::DEFAULT_TOML`], which is [`Policy::default`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Policy {
    /// How far each joint may turn.
    pub joints: JointLimits,
    /// Where the tool may be.
    pub workspace: Workspace,
    /// What the tool tip may not go into.
    pub table: Table,
    /// How far each tool hangs down.
    pub tool_length: ToolLengths,
    /// How thick the arm is.
    pub arm: ArmBody,
    /// What no part of the arm may touch, by name.
    pub keep_out: BTreeMap<String, KeepOut>,
    /// The highest speeds.
    pub speed: SpeedCeilings,
    /// The highest accelerations.
    pub acceleration: AccelerationCeilings,
    /// JUMP moves.
    pub jump: JumpRules,
    /// When and where the laser may burn.
    pub laser: LaserRules,
    /// Jogs.
    pub jog: JogRules,
    /// What waits in the arm.
    pub queue: QueueRules,
}

impl Policy {
    /// The default policy as a file with every key and a comment on each.
    pub const DEFAULT_TOML: &str = include_str!("../policy.toml");

    /// Reads a policy file.
    ///
    /// # Errors
    ///
    /// [`PolicyError`] with the line: no TOML, an unknown key, a value of another kind, not finite,
    /// outside its range, or a least above its most.
    pub fn from_toml(text: &str) -> Result<Self, PolicyError> {
        let policy: Self = toml::from_str(text).map_err(|error| PolicyError::toml(text, &error))?;
        match problem(&policy) {
            Some(problem) => Err(PolicyError::value(line_of(text, &problem.key), problem)),
            None => Ok(policy),
        }
    }

    /// Writes a policy file without comments; [`from_toml`](Self::from_toml) reads it back unchanged.
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "tables of numbers are TOML")]
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("tables with text keys, numbers and switches are TOML")
    }

    /// Whether all values are in their ranges, for a policy that did not come from a file.
    ///
    /// # Errors
    ///
    /// [`PolicyError`] without a line.
    pub fn validate(&self) -> Result<(), PolicyError> {
        problem(self).map_or(Ok(()), |problem| Err(PolicyError::value(None, problem)))
    }

    /// The JSON Schema of a policy, for editors and programs.
    #[must_use]
    pub fn json_schema() -> serde_json::Value {
        schemars::schema_for!(Self).to_value()
    }
}
