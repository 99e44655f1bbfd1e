//! Log messages on `/rosout` and the terminal.

use std::io::Write;

use ros2_client::NodeLoggingHandle;
use ros2_client::log::LogLevel;
use ros2_client::rosout;

/// Logs to `/rosout` and the terminal.
pub(crate) struct Log {
    node: NodeLoggingHandle,
}

impl Log {
    pub(crate) const fn new(node: NodeLoggingHandle) -> Self {
        Self { node }
    }

    /// Logs a normal event.
    pub(crate) fn info(&self, text: &str) {
        print(text);
        rosout!(self.node, LogLevel::Info, "{text}");
    }

    /// Logs a refusal or a failure.
    pub(crate) fn warn(&self, text: &str) {
        print(&format!("warning: {text}"));
        rosout!(self.node, LogLevel::Warn, "{text}");
    }

    /// Logs an outcome, prefixed with the name of its request.
    pub(crate) fn outcome(&self, name: &str, done: &Result<String, String>) {
        match done {
            Ok(text) => self.info(&format!("{name}: {text}")),
            Err(text) => self.warn(&format!("{name}: {text}")),
        }
    }
}

/// The terminal may be gone, which must not end the node.
fn print(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}
