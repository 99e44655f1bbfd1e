//! `cargo run -p dobot-examples --example fidelity` compares the twin with every recording of the
//! stock controller, and with the motion model over random scripts.
//!
//! With `> docs/fidelity.md`, it updates that file.

#[path = "../../../../crates/sim/tests/it/recordings.rs"]
mod recordings;
#[path = "../../../../crates/sim/tests/it/report.rs"]
mod report;
#[path = "../../../../crates/sim/tests/it/scripts.rs"]
mod scripts;

fn main() {
    print!("{}", report::report());
}
