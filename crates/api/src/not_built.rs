//! Parts of the program that need a build with the feature `full`.

/// The error returned when this build lacks a part.
///
/// ```
/// use dobot_api::NotBuilt;
///
/// let error = NotBuilt("Foxglove");
/// assert_eq!(error.to_string(), "this program is built without Foxglove");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("this program is built without {0}")]
pub struct NotBuilt(pub &'static str);

impl NotBuilt {
    /// The hint: how to get the part.
    pub const HINT: &str = "`cargo build --release --features full` builds a program with all parts; the released archives have them too";
}
