//! The `dobot` program: [`dobot_cli::run`]. As a library, it is compiled beside the crates that it uses.

use std::process::ExitCode;

fn main() -> ExitCode {
    dobot_cli::run()
}
