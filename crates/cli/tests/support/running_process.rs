//! A running `dobot` process.

#[cfg(unix)]
use std::io::Write;
use std::io::{BufRead, BufReader, PipeReader, PipeWriter, pipe};
use std::process::{Child, ChildStderr, Command, Stdio};

#[cfg(unix)]
use rustix::process::{Pid, Signal, kill_process};

#[cfg(unix)]
use super::full_pipe::full_pipe;

/// A running process, which is killed at the end of the test.
pub(crate) struct RunningProcess {
    child: Child,
    output: BufReader<PipeReader>,
}

impl RunningProcess {
    /// Starts a process; its standard error is discarded.
    pub(crate) fn new(command: Command) -> Self {
        Self::start(command, Stdio::null())
    }

    /// Starts a process, and returns its standard error.
    pub(crate) fn with_errors(command: Command) -> (Self, BufReader<ChildStderr>) {
        let mut process = Self::start(command, Stdio::piped());
        let errors = process.child.stderr.take().expect("it is piped");
        (process, BufReader::new(errors))
    }

    /// Starts a process whose output includes its standard error.
    #[cfg(unix)]
    pub(crate) fn with_errors_in_output(command: Command) -> Self {
        let (output, writer) = pipe().expect("a pipe is free");
        let errors = writer.try_clone().expect("a handle");
        Self::spawn(command, Stdio::null(), (output, writer), errors.into())
    }

    /// Starts a process whose standard error is a full pipe until the reader is dropped.
    #[cfg(unix)]
    pub(crate) fn with_full_errors(command: Command) -> (Self, PipeReader) {
        let (reader, errors) = full_pipe();
        (Self::start(command, errors.into()), reader)
    }

    /// Starts a process with a standard input.
    #[cfg(unix)]
    pub(crate) fn with_input(command: Command) -> Self {
        Self::start_with(command, Stdio::piped(), Stdio::null())
    }

    /// Writes a line to standard input.
    #[cfg(unix)]
    pub(crate) fn write_line(&mut self, line: &str) {
        let input = self.child.stdin.as_mut().expect("it is piped");
        writeln!(input, "{line}").expect("the process reads it");
    }

    fn start(command: Command, errors: Stdio) -> Self {
        Self::start_with(command, Stdio::null(), errors)
    }

    fn start_with(command: Command, input: Stdio, errors: Stdio) -> Self {
        Self::spawn(command, input, pipe().expect("a pipe is free"), errors)
    }

    fn spawn(
        mut command: Command,
        input: Stdio,
        (output, writer): (PipeReader, PipeWriter),
        errors: Stdio,
    ) -> Self {
        let command = command.stdin(input).stdout(writer).stderr(errors);
        Self {
            child: command.spawn().expect("the program starts"),
            output: BufReader::new(output),
        }
    }

    /// Waits for a line of output that contains a text.
    pub(crate) fn wait_for_line(&mut self, text: &str) -> String {
        line_with(text, &mut self.output)
    }

    /// The address at the start of the next line of output.
    pub(crate) fn address(&mut self) -> String {
        let line = self.wait_for_line("");
        let address = line.split_whitespace().next();
        address.expect("an address comes first").to_owned()
    }

    /// The process ID.
    #[cfg(unix)]
    pub(crate) fn pid(&self) -> Pid {
        Pid::from_child(&self.child)
    }

    /// Sends the signal of Ctrl-C.
    #[cfg(unix)]
    pub(crate) fn is_interrupted(&self) {
        kill_process(self.pid(), Signal::INT).expect("it is there");
    }

    /// Sends the signal of Ctrl-C, and returns the exit code.
    #[cfg(unix)]
    pub(crate) fn interrupt(self) -> Option<i32> {
        self.is_interrupted();
        self.ends()
    }

    /// Whether the process has ended.
    pub(crate) fn has_ended(&mut self) -> bool {
        self.child.try_wait().expect("it was started").is_some()
    }

    /// Waits for the end, and returns the exit code.
    pub(crate) fn ends(mut self) -> Option<i32> {
        self.child.wait().expect("it ends").code()
    }

    /// Sends `SIGKILL`.
    #[cfg(unix)]
    pub(crate) fn kill(&mut self) {
        self.child.kill().expect("it is there");
        self.child.wait().expect("it ends");
    }
}

impl Drop for RunningProcess {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Reads until a line that contains a text.
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
