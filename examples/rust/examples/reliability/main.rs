//! `cargo run -p dobot-examples --example reliability -- --quick`: measures jobs under faults.
//!
//! Without `--quick`, its output is `docs/reliability.md`.

#[path = "../../../../crates/host/tests/it/cases/mod.rs"]
mod cases;
mod report;

use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let quick = match std::env::args().nth(1).as_deref() {
        None => false,
        Some("--quick") => true,
        Some(other) => {
            eprintln!("error: unknown argument {other}; only --quick is allowed");
            return ExitCode::from(2);
        }
    };
    let mut report = report::Report::default();
    report.all(if quick { 40 } else { 1 });
    if std::io::stdout().write_all(report.text.as_bytes()).is_err() {
        return ExitCode::FAILURE;
    }
    for wrong in &report.wrong {
        eprintln!("wrong: {wrong}");
    }
    ExitCode::from(u8::from(!report.wrong.is_empty()))
}
