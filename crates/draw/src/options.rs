//! What a person asks for: the options of `dobot draw`, in JSON under the same names. The documentation of a field is its
//! help on the command line and its description in the API.

mod asked;
mod check;
mod content;
mod error;
mod fields;
mod path;
mod place;
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

/// What a person asks for. [`DrawingRequest::new`] makes [`Settings`](crate::Settings) of it; `dobot draw` reads it from its
/// arguments, any other client from JSON:
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
    /// What is drawn.
    pub what: ContentOptions,
    /// Where it goes.
    pub place: PlaceOptions,
    /// With what it is drawn.
    pub tool: ToolOptions,
    /// How it is drawn.
    pub way: PathOptions,
}

impl Options {
    /// Whether each of them is allowed by itself and fits the others, whatever is drawn.
    ///
    /// # Errors
    ///
    /// [`OptionsError`]: the first field that is out of its range, that another one excludes, or that does nothing
    /// without another one.
    pub fn check_values(&self) -> Result<(), OptionsError> {
        check::check_values(self)
    }

    /// Whether they fit what is drawn, and each other.
    ///
    /// # Errors
    ///
    /// [`OptionsError`]: the first option that is out of its range, that another one excludes, or that would do
    /// nothing.
    pub fn check(&self, subject: &Subject) -> Result<(), OptionsError> {
        check::check(self, &subject.sources, &subject.title)
    }
}
