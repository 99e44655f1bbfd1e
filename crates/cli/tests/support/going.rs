//! A `dobot` that goes on while a test talks to it.

use std::io::{BufRead, BufReader};
#[cfg(unix)]
use std::io::{PipeReader, Write};
use std::process::{Child, ChildStderr, ChildStdout, Command, Stdio};

#[cfg(unix)]
use rustix::process::{Pid, Signal, kill_process};

#[cfg(unix)]
use super::full_pipe::full_pipe;

/// A program that goes on; it ends with the test.
pub(crate) struct Going {
    child: Child,
    output: BufReader<ChildStdout>,
}

impl Going {
    /// Its standard error is seen by nobody.
    pub(crate) fn new(command: Command) -> Self {
        Self::start(command, Stdio::null())
    }

    /// And what it prints on standard error.
    pub(crate) fn with_errors(command: Command) -> (Self, BufReader<ChildStderr>) {
        let mut going = Self::start(command, Stdio::piped());
        let errors = going.child.stderr.take().expect("it is piped");
        (going, BufReader::new(errors))
    }

    /// Its standard error is a full pipe for as long as the reader is kept.
    #[cfg(unix)]
    pub(crate) fn with_full_errors(command: Command) -> (Self, PipeReader) {
        let (reader, errors) = full_pipe();
        (Self::start(command, errors.into()), reader)
    }

    /// One that is talked to.
    #[cfg(unix)]
    pub(crate) fn talking(command: Command) -> Self {
        Self::start_with(command, Stdio::piped(), Stdio::null())
    }

    /// Says a line to it.
    #[cfg(unix)]
    pub(crate) fn says(&mut self, line: &str) {
        let input = self.child.stdin.as_mut().expect("it is piped");
        writeln!(input, "{line}").expect("it is heard");
    }

    fn start(command: Command, errors: Stdio) -> Self {
        Self::start_with(command, Stdio::null(), errors)
    }

    fn start_with(mut command: Command, input: Stdio, errors: Stdio) -> Self {
        let mut child = command
            .stdin(input)
            .stdout(Stdio::piped())
            .stderr(errors)
            .spawn()
            .expect("the program starts");
        let output = BufReader::new(child.stdout.take().expect("it is piped"));
        Self { child, output }
    }

    /// Reads until a line with this text.
    pub(crate) fn reads(&mut self, text: &str) -> String {
        line_with(text, &mut self.output)
    }

    /// The next address that it prints, first in its line.
    pub(crate) fn address(&mut self) -> String {
        let line = self.reads("");
        let address = line.split_whitespace().next();
        address.expect("an address comes first").to_owned()
    }

    /// Its number.
    #[cfg(unix)]
    pub(crate) fn pid(&self) -> Pid {
        Pid::from_child(&self.child)
    }

    /// As Ctrl-C does.
    #[cfg(unix)]
    pub(crate) fn is_interrupted(&self) {
        kill_process(self.pid(), Signal::INT).expect("it is there");
    }

    /// As Ctrl-C does; the exit code.
    #[cfg(unix)]
    pub(crate) fn interrupt(self) -> Option<i32> {
        self.is_interrupted();
        self.ends()
    }

    /// Waits until it has ended; the exit code.
    pub(crate) fn ends(mut self) -> Option<i32> {
        self.child.wait().expect("it ends").code()
    }

    /// As `SIGKILL` does.
    #[cfg(unix)]
    pub(crate) fn kill(&mut self) {
        self.child.kill().expect("it is there");
        self.child.wait().expect("it ends");
    }
}

impl Drop for Going {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Reads until a line with this text.
pub(crate) fn line_with(text: &str, output: &mut impl BufRead) -> String {
    loop {
        let mut line = String::new();
        let read = output.read_line(&mut line).expect("it prints text");
        assert!(read > 0, "it ended before `{text}`");
        if line.contains(text) {
            return line;
        }
    }
}
