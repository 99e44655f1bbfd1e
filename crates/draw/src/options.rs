//! The options of `dobot draw`, also in JSON under the same names. The documentation of a field is
//! its help on the command line and its description in the API.

mod asked;
mod check;
mod content;
mod error;
mod fields;
mod path;
mod place;
mod placement;
mod tool;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use self::asked::{DrawingRequest, Subject, WITHOUT_ARM_Z_MM};
pub use self::content::{Auto, ContentOptions, LayerTool, Spacing};
pub use self::error::OptionsError;
pub use self::fields::{OPTION_RANGES, OptionRange};
pub use self::path::PathOptions;
pub use self::place::PlaceOptions;
pub use self::tool::{PassesBy, ToolOptions};

/// The options of a drawing. [`DrawingRequest::new`] converts them to
/// [`Settings`](crate::Settings); `dobot draw` reads them from its arguments, other clients from
/// JSON:
///
/// ```
/// use dobot_draw::{DrawingRequest, Materials, Options, Subject};
///
/// let asked = r#"{"what": {"text": "Hello"}, "place": {"at": [210, 20]}, "tool": {"pen": "marker"}}"#;
/// let options: Options = serde_json::from_str(asked)?;
/// let text = Subject::of_text(&options.what).expect("there is one");
/// let asked = DrawingRequest::new(options, text, &Materials::built_in())?;
/// let (prepared, _) = asked.prepare(None, -40.0)?;
/// assert!(prepared.plan.summary().drawn_mm > 40.0); // of letters 10 mm high
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What to draw
    pub what: ContentOptions,
    /// Where to draw it
    pub place: PlaceOptions,
    /// The tool to draw with
    pub tool: ToolOptions,
    /// How to draw it
    pub way: PathOptions,
}

impl Options {
    /// Checks each option and their combinations, independently of the content.
    ///
    /// # Errors
    ///
    /// [`OptionsError`]: the first field that is out of range, conflicts with another one, or has
    /// no effect without another one.
    pub fn check_values(&self) -> Result<(), OptionsError> {
        check::check_values(self)
    }

    /// Checks the options against the content and each other.
    ///
    /// # Errors
    ///
    /// [`OptionsError`]: the first option that is out of range, conflicts with another one, or
    /// would have no effect.
    pub fn check(&self, subject: &Subject) -> Result<(), OptionsError> {
        check::check(self, &subject.sources, &subject.title)
    }
}

#[cfg(test)]
mod tests;
