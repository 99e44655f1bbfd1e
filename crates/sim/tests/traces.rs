//! The twin beside the recordings of the stock controller's own program, in `vectors/traces/`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use dobot_controller::Personality;
use dobot_sim::{Script, Tolerance, Trace, simulate};

/// Millimetres, degrees and motor pulses.
const TOLERANCE: Tolerance = Tolerance {
    float: 0.01,
    sum: 1.0,
};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../vectors/traces")
}

fn names() -> Vec<String> {
    let files = std::fs::read_dir(folder()).expect("the recordings are there");
    let mut names: Vec<_> = files
        .filter_map(|file| file.ok()?.file_name().into_string().ok())
        .filter_map(|name| Some(name.strip_suffix(".script")?.to_owned()))
        .collect();
    names.sort();
    names
}

fn read(name: &str, ending: &str) -> String {
    let path = folder().join(format!("{name}.{ending}"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn recording(name: &str) -> Trace {
    let other_port = std::fs::read(folder().join(format!("{name}.other_port.txt")));
    let trace = Trace::parse(
        &read(name, "csv"),
        &read(name, "ticks.csv"),
        &other_port.unwrap_or_default(),
    );
    trace.unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn twin(name: &str) -> Trace {
    let script: Script = read(name, "script")
        .parse()
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let simulation = simulate(&script, Personality::Firmware11).expect("the twin has both ports");
    assert_eq!(simulation.unsent, 0, "{name}");
    simulation.trace
}

#[test]
fn the_twin_does_what_the_stock_controller_was_recorded_to_do() {
    let names = names();
    assert!(names.len() >= 47, "recordings are missing: {names:?}");
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
