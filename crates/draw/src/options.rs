//! What a person asks for: the options of `dobot draw`, in JSON under the same names.

mod asked;
mod check;
mod content;
mod error;
mod path;
mod place;
mod tool;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use self::asked::{DrawingRequest, Subject, WITHOUT_ARM_Z_MM};
pub use self::content::{Auto, ContentOptions, LayerTool, Spacing};
pub use self::error::OptionsError;
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
#[cfg_attr(feature = "options", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What is drawn.
    #[cfg_attr(feature = "options", command(flatten))]
    pub what: ContentOptions,
    /// Where it goes.
    #[cfg_attr(feature = "options", command(flatten))]
    pub place: PlaceOptions,
    /// With what it is drawn.
    #[cfg_attr(feature = "options", command(flatten))]
    pub tool: ToolOptions,
    /// How it is drawn.
    #[cfg_attr(feature = "options", command(flatten))]
    pub way: PathOptions,
}

impl Options {
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
