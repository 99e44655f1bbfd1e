//! Calibrations as files: the sheet, drawing with one, and bringing one back.

use std::fs;

use dobot_calibrate::Sheet;

use crate::support::program::{dobot, example};

const KNOWN: &str = "\
[zeros]
base = 3.0
rear = -4.0
fore = 4.0

[tool]
out_mm = 5.0
left_mm = 0.0

[paper]
z_mm = -42.0
slope_x = 0.02
slope_y = 0.0
";

#[test]
fn the_sheet_is_drawn_and_a_scaled_print_is_refused() {
    let folder = tempfile::tempdir().expect("there is room");
    let sheet = folder.path().join("sheet.svg");
    let sheet_name = sheet.to_str().expect("the path is text");
    dobot(&["calibrate", "--sheet", sheet_name]).succeeds();
    let text = fs::read_to_string(&sheet).expect("it was written");
    assert!(text.contains("width=\"297mm\""), "{text}");
    let file = folder.path().join("arm.toml");
    let file = file.to_str().expect("the path is text");
    let print = Sheet::chosen_by(17);
    let bar = format!("{}:{:.3}", print.number(), 0.97 * print.bar_mm());
    dobot(&["calibrate", file, "--bar", &bar, "--to", "virtual:"])
        .fails(2, &["97.0 %", "print it at 100 %"]);
}

#[test]
fn a_page_of_markers_is_drawn_and_those_of_the_sheet_are_refused() {
    let folder = tempfile::tempdir().expect("there is room");
    let page = folder.path().join("markers.svg");
    let name = page.to_str().expect("the path is text");
    dobot(&["markers", name, "--last", "6"]).succeeds();
    let text = fs::read_to_string(&page).expect("it was written");
    assert!(text.contains(">6 (20 mm)<") && !text.contains(">7 (20 mm)<"));
    dobot(&["markers", name, "--first", "3"]).fails(1, &["allowed are 4 to 49"]);
}

#[test]
fn a_calibration_can_be_brought_back() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("arm.toml");
    let name = file.to_str().expect("the path is text");
    fs::write(&file, KNOWN.replace("3.0", "9.0")).expect("there is room");
    dobot(&["calibrate", name, "--undo"]).fails(1, &["no calibration was replaced yet"]);
    fs::write(folder.path().join("arm.toml.before"), KNOWN).expect("there is room");
    dobot(&["calibrate", name, "--undo"]).succeeds();
    assert_eq!(fs::read_to_string(&file).expect("it is there"), KNOWN);
    dobot(&["calibrate", name, "--undo"]).succeeds();
    let again = fs::read_to_string(&file).expect("it is there");
    assert!(again.contains("base = 9.0"), "{again}");
}

#[test]
fn a_drawing_follows_a_calibration() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("arm.toml");
    let name = file.to_str().expect("the path is text");
    let harbour = example("harbour.svg");
    let draw = ["draw", &harbour, "--to", "virtual:", "--calibration", name];
    dobot(&draw).fails(1, &["arm.toml", "does not exist", "dobot calibrate"]);
    fs::write(&file, KNOWN).expect("there is room");
    dobot(&draw).succeeds();
    fs::write(&file, KNOWN.replace("-4.0", "-74.0")).expect("there is room");
    dobot(&draw).fails(1, &["zeros.rear is -74; allowed are -30 to 30"]);
}
