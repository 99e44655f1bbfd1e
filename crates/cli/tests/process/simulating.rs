//! `dobot simulate`.

use std::path::{Path, PathBuf};

use crate::support::program::{dobot, dobot_reading};

fn recording(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../vectors/traces")
        .join(name)
}

fn text(path: &Path) -> &str {
    path.to_str().expect("the path is text")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn a_trace_has_the_layout_of_the_recordings() {
    let folder = tempfile::tempdir().expect("there is room");
    let out = folder.path().join("out.csv");
    let script = recording("p36_framing.script");
    dobot(&[
        "simulate",
        text(&script),
        "--personality",
        "firmware-1.1",
        "--trace",
        text(&out),
    ])
    .succeeds();
    for ending in ["csv", "ticks.csv", "other_port.txt"] {
        let found = read(&out.with_extension(ending));
        let expected = read(&recording(&format!("p36_framing.{ending}")));
        assert_eq!(found.lines().next(), expected.lines().next(), "{ending}");
        assert_eq!(found.lines().count(), expected.lines().count(), "{ending}");
    }
}

#[test]
fn text_of_an_earlier_run_does_not_remain_next_to_a_trace_without_text() {
    let folder = tempfile::tempdir().expect("there is room");
    let out = folder.path().join("out.csv");
    let old = folder.path().join("out.other_port.txt");
    std::fs::write(&old, "old").expect("there is room");
    dobot_reading(&["simulate", "-", "--trace", text(&out)], b"!end 100").succeeds();
    assert!(out.exists() && !old.exists());
}

#[test]
fn a_trace_is_written_to_standard_output_and_is_always_the_same() {
    let run = || {
        let script = b"!end 2000\ncredit 3 0 240 0 0 0 0 2 0 0";
        dobot_reading(&["simulate", "-", "--trace", "-"], script).succeeds()
    };
    let outcome = run();
    assert!(
        outcome.stdout.starts_with("t_ms,x,y,z,rHead,"),
        "{outcome:?}"
    );
    // One in tick 3 and then every fourth, up to 1980 ms.
    assert_eq!(outcome.stdout.lines().count(), 1 + 25);
    assert_eq!(outcome.stdout, run().stdout);
}

#[test]
fn without_files_a_summary_describes_the_run() {
    let script = b"!end 1000\n100 3 0 999 0 0 0 0 2 0 0\n5000 3 0 240 0 0 0 0 2 0 0";
    let outcome = dobot_reading(&["simulate", "-"], script).succeeds();
    for part in [
        "1.00 s",
        "specification",
        "lines sent   1 of 2",
        "last status  at 0.94 s",
    ] {
        assert!(outcome.stdout.contains(part), "{part}: {outcome:?}");
    }
    for part in [
        "at 160 ms: a command was refused",
        "1 of 2 lines were not sent",
    ] {
        assert!(outcome.stderr.contains(part), "{part}: {outcome:?}");
    }
}

#[test]
fn a_plot_is_an_svg_file() {
    let folder = tempfile::tempdir().expect("there is room");
    let out = folder.path().join("out.svg");
    let script = recording("p27_laser.script");
    dobot(&["simulate", text(&script), "--plot", text(&out)]).succeeds();
    let svg = read(&out);
    assert!(svg.starts_with("<svg ") && svg.contains("p27_laser.script"));
}

#[test]
fn a_wrong_line_is_reported_with_file_and_number() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("wrong.script");
    std::fs::write(&path, "# words\n!end 500\n100 3 0 240 0 0\n").expect("there is room");
    let place = format!("{}:3: ", path.display());
    dobot(&["simulate", text(&path)]).fails(1, &[&place, "5 floats", "10"]);
    dobot_reading(&["simulate", "-"], b"\nraw 0 A5\xFF").fails(1, &["standard input:2: ", "FF"]);
}

#[test]
fn an_unreadable_or_unsuitable_script_is_an_error() {
    dobot(&["simulate", "no-such.script"]).fails(1, &["cannot read no-such.script"]);
    dobot_reading(&["simulate", "-"], b"!port bt").fails(
        2,
        &[
            "`!port bt`",
            "specification",
            "hint: use `--personality firmware-1.1`",
        ],
    );
    for arguments in [
        &["simulate"][..],
        &["simulate", "-", "--trace", "out.txt"],
        &["simulate", "-", "--plot", "out.png"],
        &["simulate", "-", "--personality", "klingon"],
    ] {
        let outcome = dobot(arguments);
        assert_eq!(outcome.code, Some(2), "{outcome:?}");
    }
}

#[test]
fn a_script_with_refused_packets_fails_on_request() {
    let refused = b"credit 3 0 500 0 0 0 0 1 0 0";
    dobot_reading(&["simulate", "-"], refused).succeeds();
    let ended = dobot_reading(&["simulate", "-", "--strict"], refused);
    ended.fails(
        1,
        &["1 packet was refused and 0 lines were not sent", "hint"],
    );
    let good = b"credit 3 0 240 0 0 0 0 2 0 0";
    dobot_reading(&["simulate", "-", "--strict"], good).succeeds();
}
