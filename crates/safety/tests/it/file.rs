//! The policy as a file.

use dobot_safety::{Area, Bounds, Cylinder, KeepOut, Policy};
use proptest::prelude::*;

#[track_caller]
fn refused(text: &str, line: usize, parts: &[&str]) {
    let error = Policy::from_toml(text).expect_err("it is no policy");
    assert_eq!(error.line, Some(line), "{error}");
    let message = error.to_string();
    assert!(message.starts_with(&format!("line {line}: ")), "{message}");
    assert!(!message.contains('\n'), "{message}");
    for part in parts {
        assert!(message.contains(part), "`{part}` is missing: {message}");
    }
}

#[test]
fn the_default_is_the_file_that_is_shipped() {
    let shipped = Policy::from_toml(Policy::DEFAULT_TOML).expect("it is a policy");
    assert_eq!(shipped, Policy::default());
    assert!(Policy::default().validate().is_ok());
}

#[test]
fn the_shipped_file_has_every_key_and_its_examples_are_good() {
    for line in Policy::default().to_toml().lines() {
        let key = line.split(['=', '.']).next().expect("a line");
        let key = key.trim().trim_end_matches(']');
        assert!(Policy::DEFAULT_TOML.contains(key), "{key}");
    }
    let with_examples = Policy::DEFAULT_TOML
        .replace("# camera", "camera")
        .replace("# lamp", "lamp");
    let policy = Policy::from_toml(&with_examples).expect("the examples are good");
    assert_eq!(policy.keep_out.len(), 2);
}

#[test]
fn missing_settings_are_those_of_the_default() {
    let policy = Policy::from_toml("[jog]\nreaction_s = 0.3").expect("it is a policy");
    let mut expected = Policy::default();
    expected.jog.reaction_s = 0.3;
    assert_eq!(policy, expected);
    assert_eq!(
        Policy::from_toml("").expect("it is a policy"),
        Policy::default()
    );
}

#[test]
fn unknown_keys_and_wrong_units_are_reported_with_line_and_allowed_values() {
    refused(
        "[joints]\n\nbase_rad = [-2, 2]",
        3,
        &["base_rad", "base_deg"],
    );
    refused("[table]\nz_cm = -10", 2, &["z_cm", "z_mm"]);
    refused("[tabel]\nz_mm = -10", 1, &["tabel", "table"]);
    refused(
        "[keep_out]\nx = { ball = { x_mm = 1 } }",
        2,
        &["ball", "box", "cylinder"],
    );
    refused(
        "[keep_out.x]\nbox = { x_mm = [0, 1], y_mm = [0, 1] }",
        2,
        &["z_mm"],
    );
}

#[test]
fn values_of_another_kind_are_reported_with_their_line() {
    refused("[laser]\nallowed = 1", 2, &["boolean"]);
    refused("[table]\nz_mm = \"low\"", 2, &["low"]);
    refused(
        "[joints]\nbase_deg = [1, 2, 3]",
        2,
        &["3 numbers", "[min, max]"],
    );
    refused("[joints]\nbase_deg = [1]", 2, &["1 number"]);
    refused("[joints]\nbase_deg = 3", 2, &["3"]);
    refused("[joints\nbase_deg = 3", 1, &[]);
    refused("a = 1\n[jog]\na b", 3, &[]);
}

#[test]
fn values_out_of_range_are_reported_with_key_line_and_range() {
    refused(
        "[jog]\n# milliseconds?\ndead_man_s = 150",
        3,
        &["jog.dead_man_s is 150", "0.05 to 2"],
    );
    refused(
        "[table]\nz_mm = nan",
        2,
        &["table.z_mm is NaN", "-300 to 136"],
    );
    refused("[speed]\nline_mm_s = inf", 2, &["speed.line_mm_s is inf"]);
    refused("[speed]\nline_mm_s = 0", 2, &["speed.line_mm_s is 0"]);
    refused(
        "[joints]\nrear_deg = [0, 50]\nbase_deg = [135, -135]",
        3,
        &["joints.base_deg is [135, -135]", "min <= max"],
    );
    refused(
        "[workspace]\nreach_mm = [100, 321]",
        2,
        &["workspace.reach_mm is [100, 321]", "129 to 321"],
    );
    refused(
        "[keep_out]\na = { box = { x_mm = [1, 2], y_mm = [3, 1], z_mm = [0, 1] } }",
        2,
        &["keep_out.a.box.y_mm is [3, 1]"],
    );
    refused(
        "[keep_out.b.cylinder]\nx_mm = 1\ny_mm = 1\nradius_mm = -1\nz_mm = [0, 1]",
        4,
        &["keep_out.b.cylinder.radius_mm is -1"],
    );
    refused(
        "[keep_out.\"my camera\"]\nbox = { x_mm = [1, 2], y_mm = [1, 3], z_mm = [0, 1] }",
        1,
        &["my camera", "letters"],
    );
    refused(
        "[keep_out]\nbase = { cylinder = { x_mm = 0, y_mm = 30, radius_mm = 12, z_mm = [-50, 50] } }",
        2,
        &["keep_out.base is around the pivot", "20 mm"],
    );
    refused(
        "[laser.area]\nx_mm = [1, nan]\ny_mm = [0, 1]\nz_mm = [0, 1]",
        2,
        &["laser.area.x_mm"],
    );
}

#[test]
fn a_policy_without_a_file_is_checked_without_a_line() {
    let mut policy = Policy::default();
    policy.queue.ahead_s = f64::NAN;
    let error = policy.validate().expect_err("not a number");
    assert_eq!(error.line, None);
    assert_eq!(
        error.to_string(),
        "queue.ahead_s is NaN; a policy allows 0 to 60"
    );
}

#[test]
fn the_schema_has_every_key_of_the_default() {
    let schema = Policy::json_schema();
    let policy = serde_json::to_value(Policy::default()).expect("it is JSON");
    let sections = policy.as_object().expect("an object");
    for (name, section) in sections {
        let property = &schema["properties"][name];
        assert!(property.is_object(), "{name}");
        let Some(fields) = section.as_object().filter(|object| !object.is_empty()) else {
            continue;
        };
        let reference = property["$ref"].as_str().expect("a definition");
        let definition = schema
            .pointer(reference.trim_start_matches('#'))
            .expect("it is defined");
        assert_eq!(definition["additionalProperties"], false, "{name}");
        for field in fields.keys() {
            assert!(
                definition["properties"][field].is_object(),
                "{name}.{field}"
            );
        }
    }
}

proptest! {
    #[test]
    fn every_policy_is_restored_from_its_file_and_from_json(policy in policies()) {
        prop_assert!(policy.validate().is_ok(), "{:?}", policy.validate());
        let text = policy.to_toml();
        prop_assert_eq!(&Policy::from_toml(&text).map_err(|error| error.to_string()), &Ok(policy.clone()));
        let json = serde_json::to_value(&policy).expect("it is JSON");
        prop_assert_eq!(serde_json::from_value::<Policy>(json).ok(), Some(policy));
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in "\\PC{0,80}") {
        let _ = Policy::from_toml(&text);
    }

    #[test]
    fn a_damaged_file_is_read_or_refused_in_one_line(
        at in 0..Policy::DEFAULT_TOML.len(),
        byte in any::<char>(),
    ) {
        let mut text = Policy::DEFAULT_TOML.to_owned();
        text.replace_range(at..=at, &byte.to_string());
        if let Err(error) = Policy::from_toml(&text) {
            prop_assert_eq!(error.to_string().lines().count(), 1, "{}", error);
        }
    }
}

fn policies() -> impl Strategy<Value = Policy> {
    let names = "[a-z][a-z0-9_-]{0,8}";
    (
        within(-180.0, 180.0),
        within(129.0, 321.0),
        -300.0..136.0,
        0.0..200.0,
        any::<bool>(),
        0.05..2.0,
        prop::collection::btree_map(names, keep_outs(), 0..4),
    )
        .prop_map(
            |(base, reach, table_mm, length_mm, allowed, dead_man_s, keep_out)| {
                let mut policy = Policy {
                    keep_out,
                    ..Policy::default()
                };
                policy.joints.base_deg = base;
                policy.workspace.reach_mm = reach;
                policy.table.z_mm = table_mm;
                policy.tool_length.gripper_mm = length_mm;
                policy.laser.allowed = allowed;
                policy.jog.dead_man_s = dead_man_s;
                policy
            },
        )
}

fn keep_outs() -> impl Strategy<Value = KeepOut> {
    let span = || within(-1000.0, 1000.0);
    let blocks = (span(), span(), span())
        .prop_map(|(x_mm, y_mm, z_mm)| KeepOut::Box(Area { x_mm, y_mm, z_mm }));
    let cylinders = (-1000.0..1000.0, -1000.0..1000.0, 0.0..1000.0, span()).prop_map(
        |(x_mm, y_mm, radius_mm, z_mm)| {
            KeepOut::Cylinder(Cylinder {
                x_mm,
                y_mm,
                radius_mm,
                z_mm,
            })
        },
    );
    prop_oneof![blocks, cylinders].prop_filter("around the pivot", |keep_out| {
        let mut policy = Policy::default();
        policy.keep_out.insert("it".to_owned(), *keep_out);
        policy.validate().is_ok()
    })
}

fn within(min: f64, max: f64) -> impl Strategy<Value = Bounds> {
    (min..max, min..max).prop_map(|(a, b)| Bounds::new(f64::min(a, b), f64::max(a, b)))
}
