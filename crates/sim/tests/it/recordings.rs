//! The recordings in `vectors/traces/`, and what the twin makes of their scripts.

use std::path::{Path, PathBuf};

use dobot_controller::Personality;
use dobot_sim::{Script, Trace, simulate};

/// The names of all recordings, in order.
pub(crate) fn names() -> Vec<String> {
    let files = std::fs::read_dir(folder()).expect("the recordings are there");
    let mut names: Vec<_> = files
        .filter_map(|file| file.ok()?.file_name().into_string().ok())
        .filter_map(|name| Some(name.strip_suffix(".script")?.to_owned()))
        .collect();
    names.sort();
    names
}

/// What the stock controller did.
pub(crate) fn recording(name: &str) -> Trace {
    let other_port = std::fs::read(folder().join(format!("{name}.other_port.txt")));
    let trace = Trace::parse(
        &read(name, "csv"),
        &read(name, "ticks.csv"),
        &other_port.unwrap_or_default(),
    );
    trace.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What the twin does.
pub(crate) fn twin(name: &str) -> Trace {
    let script: Script = read(name, "script")
        .parse()
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let simulation = simulate(&script, Personality::Firmware11).expect("the twin has both ports");
    assert_eq!(simulation.unsent, 0, "{name}: lines were not sent");
    simulation.trace
}

fn read(name: &str, ending: &str) -> String {
    let path = folder().join(format!("{name}.{ending}"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../vectors/traces")
}
