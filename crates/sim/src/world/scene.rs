//! Scene files: the objects around the arm at power-up.

mod check;
mod file;

use dobot_geometry::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{Object, Tool};

/// The surroundings of an arm: its tool, the paper and the objects.
///
/// ```
/// use dobot_sim::world::Scene;
///
/// let scene = Scene::parse(r#"
///     [suction-cup]
///     down_z_mm = -40       # z of the arm when the cup touches the table
///
///     [[box]]
///     name = "cube"
///     size_mm = [25, 25, 25]
///     at_mm = [200, 60]
///     color = "red"
/// "#)?;
/// assert_eq!(scene.objects[0].top_mm(), 25.0);
///
/// let error = Scene::parse("[pen]\nwidth_mm = -1").unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "line 2: width_mm of [pen] is -1; from 0.05 to 10 is allowed"
/// );
/// # Ok::<(), dobot_sim::world::SceneError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Scene {
    /// The mounted tool.
    pub tool: Tool,
    /// The height of the table in the base frame; only used for the length of the tool in pictures.
    pub table_z_mm: f64,
    /// The paper on the table.
    pub paper: Option<Paper>,
    /// The objects, in the order of the file.
    pub objects: Vec<Object>,
}

/// A sheet of paper, with its sides along X and Y. It has no thickness.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct Paper {
    /// Its corner with the least X and Y.
    #[serde(with = "super::place::pair")]
    #[schemars(with = "[f64; 2]")]
    pub from_mm: Point,
    /// Its corner with the largest X and Y.
    #[serde(with = "super::place::pair")]
    #[schemars(with = "[f64; 2]")]
    pub to_mm: Point,
}

/// The error returned when a text is not a scene. Lines count from 1.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// The text is not TOML, or has unknown keys or value types.
    #[error("line {line}: {reason}")]
    Syntax {
        /// The line.
        line: usize,
        /// The message of the TOML parser.
        reason: String,
    },
    /// There is not exactly one tool.
    #[error("line {line}: {found}; one of [pen], [laser], [suction-cup] and [gripper] is needed")]
    Tools {
        /// The line.
        line: usize,
        /// The tools found.
        found: String,
    },
    /// A value is invalid.
    #[error("line {line}: {what} is {found}; {allowed}")]
    Value {
        /// The line.
        line: usize,
        /// The name of the value.
        what: String,
        /// The value found.
        found: String,
        /// The allowed values.
        allowed: String,
    },
    /// Two objects have the same name.
    #[error(
        "line {line}: the name `{name}` is already used in line {first_line}; names must be unique"
    )]
    NameTwice {
        /// The line of the second object.
        line: usize,
        /// The name.
        name: String,
        /// The line of the first object.
        first_line: usize,
    },
    /// Two objects overlap.
    #[error(
        "line {line}: `{name}` overlaps `{other}` of line {other_line}; objects may touch but not overlap"
    )]
    Overlap {
        /// The line of the later object.
        line: usize,
        /// The later object.
        name: String,
        /// The earlier object.
        other: String,
        /// The line of the earlier object.
        other_line: usize,
    },
    /// An object stands on something that cannot support it.
    #[error("line {line}: `{name}` cannot stand on `{on}`: {reason}")]
    Support {
        /// The line.
        line: usize,
        /// The object.
        name: String,
        /// The supporting object.
        on: String,
        /// The reason.
        reason: &'static str,
    },
}

impl Scene {
    /// Parses a scene.
    ///
    /// # Errors
    ///
    /// Returns a [`SceneError`] if the text is not TOML, has unknown keys or invalid values.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        check::scene(&file::read(text)?, text)
    }
}

impl Paper {
    /// Whether a point is on the paper.
    #[must_use]
    pub fn contains(&self, at: Point) -> bool {
        let inside = |from: f64, at: f64, to: f64| (from..=to).contains(&at);
        inside(self.from_mm.x, at.x, self.to_mm.x) && inside(self.from_mm.y, at.y, self.to_mm.y)
    }
}
