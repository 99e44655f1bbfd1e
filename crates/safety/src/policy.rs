//! The policy as a whole.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::text_lines::line_of;
use crate::validate::problem;
use crate::{
    AccelerationCeilings, ArmBody, JogRules, JointLimits, JumpRules, KeepOut, LaserRules,
    PolicyError, QueueRules, SpeedCeilings, Table, ToolLengths, VoiceRules, Workspace,
};

/// The safety policy: what no client's command may do.
///
/// Keys missing in a file have the values of [`Policy::DEFAULT_TOML`], which is
/// [`Policy::default`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Policy {
    /// The limits of the joints.
    pub joints: JointLimits,
    /// The limits of the tool's position.
    pub workspace: Workspace,
    /// The table, which the tool tip may not enter.
    pub table: Table,
    /// The length of each tool.
    pub tool_length: ToolLengths,
    /// The thickness of the arm.
    pub arm: ArmBody,
    /// The keep-outs by name, which no part of the arm may touch.
    pub keep_out: BTreeMap<String, KeepOut>,
    /// The highest speeds.
    pub speed: SpeedCeilings,
    /// The highest accelerations.
    pub acceleration: AccelerationCeilings,
    /// The rules for JUMP moves.
    pub jump: JumpRules,
    /// When and where the laser may burn.
    pub laser: LaserRules,
    /// The rules for jogs.
    pub jog: JogRules,
    /// The rules for commands waiting in the arm.
    pub queue: QueueRules,
    /// The rules for spoken orders.
    pub voice: VoiceRules,
}

impl Policy {
    /// The default policy as a file with every key and a comment on each.
    pub const DEFAULT_TOML: &str = include_str!("../policy.toml");

    /// Parses a policy file.
    ///
    /// # Errors
    ///
    /// [`PolicyError`] with the line: not TOML, an unknown key, a value of the wrong type, not
    /// finite, outside its range, or a minimum above its maximum.
    pub fn from_toml(text: &str) -> Result<Self, PolicyError> {
        let policy: Self = toml::from_str(text).map_err(|error| PolicyError::toml(text, &error))?;
        match problem(&policy) {
            Some(problem) => Err(PolicyError::value(line_of(text, &problem.key), problem)),
            None => Ok(policy),
        }
    }

    /// Writes a policy file without comments; [`from_toml`](Self::from_toml) reads it back
    /// unchanged.
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "tables of numbers are TOML")]
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("tables with text keys, numbers and switches are TOML")
    }

    /// Checks that all values are in their ranges, for a policy that was not read from a file.
    ///
    /// # Errors
    ///
    /// [`PolicyError`] without a line.
    pub fn validate(&self) -> Result<(), PolicyError> {
        problem(self).map_or(Ok(()), |problem| Err(PolicyError::value(None, problem)))
    }

    /// Returns the JSON Schema of a policy, for editors and programs.
    #[must_use]
    pub fn json_schema() -> serde_json::Value {
        schemars::schema_for!(Self).to_value()
    }
}
