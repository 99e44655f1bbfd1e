//! What happened, for those who look at `/rosout` and at the terminal.

use std::io::Write;

use ros2_client::NodeLoggingHandle;
use ros2_client::log::LogLevel;
use ros2_client::rosout;

/// Tells people what happened.
pub(crate) struct Told {
    node: NodeLoggingHandle,
}

impl Told {
    pub(crate) const fn new(node: NodeLoggingHandle) -> Self {
        Self { node }
    }

    /// Something went as it should.
    pub(crate) fn info(&self, text: &str) {
        print(text);
        rosout!(self.node, LogLevel::Info, "{text}");
    }

    /// Something was refused or went wrong.
    pub(crate) fn warn(&self, text: &str) {
        print(&format!("warning: {text}"));
        rosout!(self.node, LogLevel::Warn, "{text}");
    }

    /// Either, under the name of what was asked for.
    pub(crate) fn outcome(&self, name: &str, done: &Result<String, String>) {
        match done {
            Ok(text) => self.info(&format!("{name}: {text}")),
            Err(text) => self.warn(&format!("{name}: {text}")),
        }
    }
}

/// The terminal may be gone; the arm is not to be left because of that.
fn print(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}
