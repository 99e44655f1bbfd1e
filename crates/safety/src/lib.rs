//! The safety policy: what no command of any client may do.

/// Why a command is not allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// Which rule.
    pub rule: String,
    /// Where on the way.
    pub at: Option<dobot_course::Place>,
    /// The nearest place allowed, in millimetres.
    pub nearest: Option<[f64; 3]>,
}

impl std::fmt::Display for Violation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.rule)
    }
}

impl std::error::Error for Violation {}
