//! The twin beside the recordings of the stock controller's own program, in `vectors/traces/`.

#[path = "../examples/fidelity/recordings.rs"]
mod recordings;
#[path = "../examples/fidelity/report.rs"]
mod report;

use std::fmt::Write as _;
use std::path::Path;

use dobot_sim::Tolerance;

use crate::recordings::{names, recording, twin};

/// Millimetres, degrees and motor pulses.
const TOLERANCE: Tolerance = Tolerance {
    float: 0.0,
    sum: 0.0,
};

#[test]
fn the_twin_does_what_the_stock_controller_was_recorded_to_do() {
    let names = names();
    assert!(names.len() >= 61, "recordings are missing: {names:?}");
    let mut failures = String::new();
    for name in &names {
        if let Some(difference) = twin(name).first_difference(&recording(name), &TOLERANCE) {
            writeln!(failures, "{name}: {difference}").expect("a string takes all");
        }
    }
    assert!(
        failures.is_empty(),
        "the twin is not the original\n{failures}"
    );
}

#[test]
fn the_page_on_fidelity_is_what_its_command_prints() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/fidelity.md");
    let page = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        page == report::report(),
        "docs/fidelity.md is old; `cargo run -p dobot-sim --example fidelity > docs/fidelity.md` writes it anew"
    );
}

#[test]
fn every_recording_is_explained_on_the_page() {
    let report = report::report();
    for name in names() {
        assert!(!report.contains(&format!("| `{name}` |  |")), "{name}");
    }
}
