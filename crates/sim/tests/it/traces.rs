//! The twin beside the recordings of the stock controller's own program, in `vectors/traces/`.

use std::fmt::Write as _;
use std::path::Path;

use crate::recordings::{names, recording, twin};
use crate::report::report;

#[test]
fn the_twin_does_what_the_stock_controller_was_recorded_to_do() {
    let names = names();
    assert!(names.len() >= 84, "recordings are missing: {names:?}");
    let mut failures = String::new();
    for name in &names {
        let comparison = twin(name).compare(&recording(name));
        let values = comparison.floats.iter().chain(&comparison.outputs);
        let off: Vec<_> = values.filter(|it| it.size() > 0.0).collect();
        let (missing, extra) = (&comparison.missing_ms, &comparison.extra_ms);
        let same = missing.is_empty() && extra.is_empty() && off.is_empty();
        if !(same && comparison.same_ticks && comparison.same_text) {
            writeln!(failures, "{name}: off {off:?}; {comparison:?}").expect("a string takes all");
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
        page == report(),
        "docs/fidelity.md is out of date; regenerate it with `cargo run -p dobot-examples --example fidelity > docs/fidelity.md`"
    );
}

#[test]
fn every_recording_is_explained_on_the_page() {
    let page = include_str!("../../../../docs/fidelity.md");
    for name in names() {
        assert!(!page.contains(&format!("| `{name}` |  |")), "{name}");
    }
}
