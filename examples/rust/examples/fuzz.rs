//! `cargo run -p dobot-examples --example fuzz -- --requests 20000`
//!
//! Sends random requests to the whole station, until the arm is lost. A million take some minutes
//! (`--release`). Prints the figures as the table of docs/reliability.md (`reliability/fuzz.md`).

#[path = "../../../crates/host/tests/it/cases/mod.rs"]
#[allow(
    dead_code,
    reason = "the other cases are used by the reliability example"
)]
mod cases;

use std::io::Write;
use std::process::ExitCode;

use cases::fuzz;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (first, requests) = match &arguments[..] {
        [] => (0, 100_000),
        [name, count] if name == "--requests" => (0, count.parse().unwrap_or(0)),
        [name, seed] if name == "--seed" => (seed.parse().unwrap_or(0), 1),
        _ => {
            eprintln!("error: expected --requests COUNT, or --seed NUMBER for one case");
            return ExitCode::from(2);
        }
    };
    let cases = u64::div_ceil(requests, fuzz::REQUESTS);
    let figures = fuzz::run(first, cases);
    let page = figures.page();
    if std::io::stdout().write_all(page.as_bytes()).is_err() {
        return ExitCode::FAILURE;
    }
    for wrong in &figures.wrong {
        eprintln!("wrong: {wrong}\n");
    }
    ExitCode::from(u8::from(!figures.wrong.is_empty()))
}
