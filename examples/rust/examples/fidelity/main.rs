//! `cargo run -p dobot-examples --example fidelity` holds the twin against every recording of the stock controller.
//!
//! With `> docs/fidelity.md` behind it, it writes that file anew.

#[path = "../../../../crates/sim/tests/it/recordings.rs"]
mod recordings;
#[path = "../../../../crates/sim/tests/it/report.rs"]
mod report;

fn main() {
    print!("{}", report::report());
}
