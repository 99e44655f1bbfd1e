//! Scene files: what stands where before the arm is switched on.

mod check;
mod file;

use dobot_geometry::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{Object, Tool};

/// What is around an arm: its tool, the paper and the objects.
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
pub struct Scene {
    /// What is mounted at the end of the arm.
    pub tool: Tool,
    /// The height of the table in the base frame; pictures show how long the tool is by it, and
    /// nothing else depends on it.
    pub table_z_mm: f64,
    /// The paper on the table, if there is any.
    pub paper: Option<Paper>,
    /// The objects, in the order of the file.
    pub objects: Vec<Object>,
}

/// A sheet of paper, with its sides along X and Y. It has no thickness.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
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

/// Why a text is not a scene. Lines count from 1.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// It is not TOML, or has other keys or kinds of values than a scene has.
    #[error("line {line}: {reason}")]
    Syntax {
        /// Where.
        line: usize,
        /// What the reader of TOML says.
        reason: String,
    },
    /// There has to be one tool.
    #[error("line {line}: {found}; one of [pen], [laser], [suction-cup] and [gripper] is needed")]
    Tools {
        /// Where.
        line: usize,
        /// What there is instead.
        found: String,
    },
    /// A value that cannot be.
    #[error("line {line}: {what} is {found}; {allowed}")]
    Value {
        /// Where.
        line: usize,
        /// Which value of what.
        what: String,
        /// What was found.
        found: String,
        /// What is allowed.
        allowed: String,
    },
    /// A name is given to two objects.
    #[error("line {line}: the name `{name}` is that of line {first_line}, too; names are unique")]
    NameTwice {
        /// Where the second one is.
        line: usize,
        /// The name.
        name: String,
        /// Where the first one is.
        first_line: usize,
    },
    /// Two objects are in each other.
    #[error(
        "line {line}: `{name}` is in the same place as `{other}` of line {other_line}; objects may touch but not overlap"
    )]
    Overlap {
        /// Where the later one is.
        line: usize,
        /// The later one.
        name: String,
        /// The earlier one.
        other: String,
        /// Where the earlier one is.
        other_line: usize,
    },
    /// An object stands on something that does not hold it.
    #[error("line {line}: `{name}` cannot stand on `{on}`: {reason}")]
    Support {
        /// Where.
        line: usize,
        /// The object.
        name: String,
        /// What it is to stand on.
        on: String,
        /// Why it cannot.
        reason: &'static str,
    },
}

impl Scene {
    /// Reads a scene.
    ///
    /// # Errors
    ///
    /// [`SceneError`] where the text is not TOML, has keys that scenes do not have, or describes
    /// something that cannot be.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        check::scene(&file::read(text)?, text)
    }
}

impl Paper {
    /// Whether a place is on it.
    #[must_use]
    pub fn contains(&self, at: Point) -> bool {
        let inside = |from: f64, at: f64, to: f64| (from..=to).contains(&at);
        inside(self.from_mm.x, at.x, self.to_mm.x) && inside(self.from_mm.y, at.y, self.to_mm.y)
    }
}
