use std::path::PathBuf;

use super::*;

fn recording(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../vectors/traces");
    std::fs::read_to_string(path.join(name)).unwrap()
}

fn jog() -> Trace {
    Trace::parse(
        &recording("p08_linear_jog.csv"),
        &recording("p08_linear_jog.ticks.csv"),
        recording("p08_linear_jog.other_port.txt").as_bytes(),
    )
    .unwrap()
}

#[test]
fn recordings_are_read_and_written_byte_by_byte_the_same() {
    for name in [
        "p08_linear_jog",
        "p34_bt_status",
        "x1_movl_zero_nan",
        "x7_jog_past_reach_nan",
    ] {
        let statuses = recording(&format!("{name}.csv"));
        let ticks = recording(&format!("{name}.ticks.csv"));
        let trace = Trace::parse(&statuses, &ticks, b"").unwrap();
        assert_eq!(trace.statuses_csv(), statuses.as_bytes(), "{name}");
        assert_eq!(trace.ticks_csv(), ticks.as_bytes(), "{name}");
    }
}

#[test]
fn what_is_no_trace_says_where() {
    let error = |statuses: &str| Trace::parse(statuses, "", b"").unwrap_err().to_string();
    let header = STATUS_FIELDS.join(",");
    assert!(error("a,b").starts_with("line 1 is `a,b`; allowed is `t_ms,x,"));
    assert_eq!(
        error(&format!("{header}\n60,0,0")),
        "line 2 has 3 fields; allowed are 11"
    );
    assert_eq!(
        error(&format!(
            "{header}\n60,0,0,0,0,0,0,0,0,0,0\n150,0,0,0,0,0,0,0,0,0,0"
        )),
        "line 3, field t_ms is `150`; allowed is a multiple of 20 ms"
    );
    assert_eq!(
        error(&format!("{header}\n60,0,up,0,0,0,0,0,0,0,0")),
        "line 2, field y is `up`; allowed is a number or `nan`"
    );
}

#[test]
fn a_trace_does_not_differ_from_itself() {
    let trace = jog();
    let comparison = trace.compare(&trace);
    assert_eq!(comparison.statuses, trace.statuses.len());
    assert_eq!(comparison.missing_ms, [0; 0]);
    assert_eq!(comparison.extra_ms, [0; 0]);
    assert!(comparison.floats.iter().all(|it| it.size() == 0.0));
    assert!(comparison.outputs.iter().all(|it| it.size() == 0.0));
    assert!(comparison.same_ticks && comparison.same_text);
}

#[test]
fn the_largest_deviation_of_a_field_names_its_time_and_both_values() {
    let (expected, mut found) = (jog(), jog());
    found.statuses[7].floats[1] += 0.5;
    found.statuses[8].floats[1] += 0.25;
    found.statuses[9].floats[0] += 3.0;
    let [x, y, ..] = found.compare(&expected).floats;
    assert_eq!((x.size(), y.size()), (3.0, 0.5));
    assert_eq!((x.field, y.field), ("x", "y"));
    assert_eq!(y.t_ms, expected.statuses[7].t_ms());
    assert_eq!(y.found - y.expected, 0.5);
}

#[test]
fn nan_agrees_with_nan_only() {
    let (mut expected, mut found) = (jog(), jog());
    expected.statuses[3].floats[2] = f32::NAN;
    assert_eq!(found.compare(&expected).floats[2].size(), f64::INFINITY);
    found.statuses[3].floats[2] = -f32::NAN;
    assert_eq!(found.compare(&expected).floats[2].size(), 0.0);
}

#[test]
fn missing_and_extra_statuses_are_reported_with_their_times() {
    let (expected, mut found) = (jog(), jog());
    found.statuses.remove(2);
    found.statuses[5].tick += 1;
    let comparison = found.compare(&expected);
    assert_eq!(comparison.missing_ms, [220, 540]);
    assert_eq!(comparison.extra_ms, [560]);
}

#[test]
fn a_tick_is_compared_value_by_value() {
    let (expected, mut found) = (jog(), jog());
    found.ticks[40].sums[1] += 1;
    found.ticks[30].outputs.laser = true;
    let outputs = found.compare(&expected).outputs;
    let off = outputs.iter().filter(|it| it.size() > 0.0);
    let off: Vec<_> = off.map(|it| (it.field, it.t_ms, it.size())).collect();
    assert_eq!(off, [("sum_rear", 800, 1.0), ("laser", 600, 1.0)]);
    found.ticks.pop();
    assert!(!found.compare(&expected).same_ticks);
}

#[test]
fn text_of_the_other_port_has_to_be_the_same() {
    let (expected, mut found) = (jog(), jog());
    found.other_port.push(b'!');
    assert!(!found.compare(&expected).same_text);
}
