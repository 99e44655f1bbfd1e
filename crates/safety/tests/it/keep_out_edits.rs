//! Keep-outs that are added, replaced and removed in the text of a policy.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use dobot_safety::{Area, Bounds, Cylinder, KeepOut, KeepOutEdit, Policy};

const TEXT: &str = "[table]\nz_mm = -60\n\n[keep_out]   # with names\n# lamp = { }\ncup = { cylinder = { x_mm = 300, y_mm = 2, radius_mm = 3, z_mm = [0, 9] } }  # blue\n\n[speed]\njoint_deg_s = 200\n";

const BOX: KeepOut = KeepOut::Box(Area {
    x_mm: Bounds::new(201.0, 202.5),
    y_mm: Bounds::new(3.0, 4.0),
    z_mm: Bounds::new(-5.0, 6.0),
});
const LINE: &str = "{ box = { x_mm = [201, 202.5], y_mm = [3, 4], z_mm = [-5, 6] } }";

fn add(keep_out: KeepOut) -> KeepOutEdit {
    KeepOutEdit::Add { keep_out }
}

fn replace(name: &str) -> KeepOutEdit {
    KeepOutEdit::Replace {
        name: name.into(),
        keep_out: BOX,
    }
}

fn remove(name: &str) -> KeepOutEdit {
    KeepOutEdit::Remove { name: name.into() }
}

#[test]
fn a_new_keep_out_is_a_line_of_its_table_and_all_other_lines_stay() {
    let text = add(BOX).apply(TEXT).unwrap();
    let line = format!("zone_1 = {LINE}\n");
    assert_eq!(text.replace(&line, ""), TEXT);
    assert_eq!(Policy::from_toml(&text).unwrap().keep_out["zone_1"], BOX);
}

#[test]
fn an_existing_keep_out_is_replaced_in_place_with_its_comment_or_removed() {
    let text = replace("cup").apply(TEXT).unwrap();
    let expected = format!("# lamp = {{ }}\ncup = {LINE}  # blue\n\n[speed]");
    assert!(text.contains(&expected), "{text}");
    let text = remove("cup").apply(TEXT).unwrap();
    assert!(!text.contains("cylinder"), "{text}");
    assert!(text.contains("[speed]\njoint_deg_s = 200\n"), "{text}");
}

#[test]
fn a_text_without_keep_outs_gets_a_table_of_them() {
    let text = add(BOX).apply("[table]\nz_mm = -60\n").unwrap();
    let expected = format!("[keep_out]\nzone_1 = {LINE}\n");
    assert!(text.contains(&expected), "{text}");
    let text = add(BOX).apply("").unwrap();
    assert_eq!(Policy::from_toml(&text).unwrap().keep_out.len(), 1);
}

#[test]
fn a_keep_out_is_changed_in_any_notation() {
    for text in [
        "[keep_out.arch]\nbox = { x_mm = [250, 260], y_mm = [0, 9], z_mm = [0, 9] }\n\n[speed]\n",
        "[keep_out.arch.box]\nx_mm = [250, 260]\ny_mm = [0, 9]\nz_mm = [0, 9]\n",
        "keep_out = { arch = { box = { x_mm = [250, 260], y_mm = [0, 9], z_mm = [0, 9] } } }\n",
        "keep_out.arch.box = { x_mm = [250, 260], y_mm = [0, 9], z_mm = [0, 9] }\n",
    ] {
        let replaced = replace("arch").apply(text).unwrap();
        let policy = Policy::from_toml(&replaced).unwrap();
        assert_eq!(policy.keep_out["arch"], BOX, "{replaced}");
        let added = add(BOX).apply(text).unwrap();
        let policy = Policy::from_toml(&added).unwrap();
        assert_eq!(policy.keep_out.len(), 2, "{added}");
        let removed = remove("arch").apply(text).unwrap();
        let policy = Policy::from_toml(&removed).unwrap();
        assert!(policy.keep_out.is_empty(), "{removed}");
    }
}

#[test]
fn the_default_policy_with_a_cylinder_is_a_policy_with_its_comments() {
    let cylinder = KeepOut::Cylinder(Cylinder {
        x_mm: 180.0,
        y_mm: -180.5,
        radius_mm: 30.0,
        z_mm: Bounds::new(-103.0, 60.0),
    });
    let text = add(cylinder).apply(Policy::DEFAULT_TOML).unwrap();
    let policy = Policy::from_toml(&text).unwrap();
    assert_eq!(policy.keep_out["zone_1"], cylinder);
    assert_eq!(
        text.lines().count(),
        Policy::DEFAULT_TOML.lines().count() + 1
    );
    let without = remove("zone_1").apply(&text).unwrap();
    assert_eq!(without, Policy::DEFAULT_TOML);
}

#[test]
fn a_new_keep_out_gets_an_unused_name() {
    let text = add(BOX).apply(TEXT).unwrap();
    let text = add(BOX).apply(&text).unwrap();
    let names: Vec<_> = Policy::from_toml(&text)
        .unwrap()
        .keep_out
        .into_keys()
        .collect();
    assert_eq!(names, ["cup", "zone_1", "zone_2"]);
}

#[test]
fn bounds_that_are_briefly_out_of_order_can_be_put_in_order() {
    let crossed = KeepOut::Box(Area {
        x_mm: Bounds::new(260.0, 250.0),
        y_mm: Bounds::new(3.0, 4.0),
        z_mm: Bounds::new(5.0, 6.0),
    });
    let text = add(crossed).apply(TEXT).unwrap();
    assert!(Policy::from_toml(&text).is_err());
    let text = replace("zone_1").apply(&text).unwrap();
    assert!(Policy::from_toml(&text).is_ok());
}

#[test]
fn an_impossible_change_is_refused_with_the_reason() {
    let no_toml = add(BOX).apply("[table]\nz_mm = = 2\n").unwrap_err();
    assert_eq!(no_toml.line, Some(2), "{no_toml}");
    let unknown = remove("lamp").apply(TEXT).unwrap_err();
    assert_eq!(
        unknown.to_string(),
        "no keep-out is called \"lamp\"; there are cup"
    );
    let none = replace("lamp").apply("").unwrap_err();
    assert_eq!(
        none.to_string(),
        "no keep-out is called \"lamp\"; there are none"
    );
    let value = add(BOX).apply("keep_out = 3\n").unwrap_err();
    assert_eq!(
        value.to_string(),
        "keep_out is a value; a policy has a table there"
    );
    let endless = KeepOut::Cylinder(Cylinder {
        x_mm: f64::NAN,
        y_mm: 0.0,
        radius_mm: 1.0,
        z_mm: Bounds::new(0.0, 1.0),
    });
    assert!(add(endless).apply(TEXT).is_err());
}
