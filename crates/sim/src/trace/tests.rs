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
    assert_eq!(trace.first_difference(&trace, &EXACT), None);
}

#[test]
fn the_first_difference_names_time_field_and_both_values() {
    let (expected, mut found) = (jog(), jog());
    found.statuses[7].floats[1] += 0.5;
    found.statuses[9].floats[0] += 3.0;
    let difference = found.first_difference(&expected, &EXACT).unwrap();
    let text = difference.to_string();
    let t_ms = 20 * expected.statuses[7].tick;
    assert!(text.starts_with(&format!("at {t_ms} ms y is ")), "{text}");
    assert!(text.ends_with("off by 0.500000"), "{text}");
    let tolerance = Tolerance {
        float: 1.0,
        ..EXACT
    };
    let text = found
        .first_difference(&expected, &tolerance)
        .unwrap()
        .to_string();
    assert!(text.contains(" ms x is "), "{text}");
    let largest = found.compare(&expected).floats;
    assert_eq!((largest[0].size(), largest[1].size()), (3.0, 0.5));
}

#[test]
fn nan_agrees_with_nan_only() {
    let (mut expected, mut found) = (jog(), jog());
    expected.statuses[3].floats[2] = f32::NAN;
    assert_eq!(found.compare(&expected).floats[2].size(), f64::INFINITY);
    assert!(found.first_difference(&expected, &EXACT).is_some());
    found.statuses[3].floats[2] = -f32::NAN;
    assert_eq!(found.first_difference(&expected, &EXACT), None);
}

#[test]
fn statuses_that_are_missing_or_too_many_are_told_by_their_times() {
    let (expected, mut found) = (jog(), jog());
    found.statuses.remove(2);
    found.statuses[5].tick += 1;
    let comparison = found.compare(&expected);
    assert_eq!(comparison.missing_ms, [220, 540]);
    assert_eq!(comparison.extra_ms, [560]);
    assert_eq!(
        found.first_difference(&expected, &EXACT),
        Some(Difference::Missing { t_ms: 220 })
    );
}

#[test]
fn outputs_have_to_be_the_same_and_sums_almost() {
    let (expected, mut found) = (jog(), jog());
    found.ticks[40].sums[1] += 1;
    let tolerance = Tolerance { sum: 1.0, ..EXACT };
    assert!(found.first_difference(&expected, &EXACT).is_some());
    assert_eq!(found.first_difference(&expected, &tolerance), None);
    found.ticks[30].outputs.laser = true;
    let text = found
        .first_difference(&expected, &tolerance)
        .unwrap()
        .to_string();
    assert!(
        text.starts_with("at 600 ms laser is 1; expected 0"),
        "{text}"
    );
    found.ticks.pop();
    assert!(!found.compare(&expected).same_ticks);
}

#[test]
fn text_of_the_other_port_has_to_be_the_same() {
    let (expected, mut found) = (jog(), jog());
    found.other_port.push(b'!');
    assert!(matches!(
        found.first_difference(&expected, &EXACT),
        Some(Difference::Text { .. })
    ));
    assert!(!found.compare(&expected).same_text);
}

const EXACT: Tolerance = Tolerance {
    float: 0.0,
    sum: 0.0,
};
