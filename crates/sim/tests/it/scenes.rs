//! Scene files: the samples, and what is said of bad ones.

use std::path::Path;

use dobot_sim::world::Scene;

/// A scene, the line that is wrong in it, and words of its error.
const BAD: &[(&str, usize, &[&str])] = &[
    ("", 1, &["there is no tool", "[suction-cup]"]),
    ("[pen]\n\n[laser]", 3, &["a second tool"]),
    ("[pen]\nwidth_mm = ", 2, &[]),
    (
        "[pen]\nwidth = 3",
        2,
        &["unknown field `width`", "width_mm"],
    ),
    ("[brush]", 1, &["unknown field `brush`", "pen"]),
    ("[pen]\nwidth_mm = \"thin\"", 2, &["invalid type", "thin"]),
    (
        "[pen]\nwidth_mm = 0",
        2,
        &["width_mm of [pen] is 0", "from 0.05 to 10"],
    ),
    ("[pen]\nwidth_mm = nan", 2, &["is NaN", "from 0.05 to 10"]),
    (
        "[pen]\ndown_z_mm = -inf",
        2,
        &["is -inf", "from -300 to 130"],
    ),
    ("[laser]\npower_w = -1", 2, &["power_w of [laser] is -1"]),
    (
        "[gripper]\nopen_mm = 30\nclosed_mm = 31",
        3,
        &["closed_mm", "from 0 to 30"],
    ),
    (
        "[suction-cup]\nlifts_g = 0",
        2,
        &["lifts_g of [suction-cup] is 0"],
    ),
    (
        "[pen]\n[table]\nz_mm = 20",
        3,
        &["z_mm of [table] is 20", "from -400 to 0"],
    ),
    (
        "[pen]\n[paper]\nx_mm = [1, 2]\ny_mm = [50, 20]",
        4,
        &["y_mm of [paper] is [50, 20]"],
    ),
    (
        "[pen]\n[paper]\nx_mm = [1, 2]",
        2,
        &["missing field `y_mm`"],
    ),
    (
        "[pen]\n[[box]]\nsize_mm = [1, 1]\nat_mm = [200, 0]",
        3,
        &["invalid length 2"],
    ),
    (
        "[pen]\n[[box]]\nsize_mm = [9, -9, 9]\nat_mm = [200, 0]",
        3,
        &["size_mm of `box 1` is -9", "from 0.5 to 500"],
    ),
    (
        "[pen]\n[[box]]\nsize_mm = [9, 9, 9]\nat_mm = [200, 0]\nmass_g = -3",
        5,
        &["mass_g of `box 1` is -3"],
    ),
    (
        "[pen]\n[[box]]\nsize_mm = [9, 9, 9]\nat_mm = [200, 0]\ncolor = \"pnik\"",
        5,
        &["color of `box 1` is \"pnik\"", "#rrggbb", "pink"],
    ),
    (
        "[pen]\n[[box]]\nsize_mm = [9, 9, 9]\nat_mm = [900, 0]",
        4,
        &["at_mm of `box 1` is [900, 0]", "500 mm"],
    ),
    (
        "[pen]\n[[box]]\nsize_mm = [9, 9, 9]\nat_mm = [nan, 0]",
        4,
        &["[NaN, 0]"],
    ),
    (
        "[pen]\n[[cylinder]]\ndiameter_mm = 50\nheight_mm = 9\nat_mm = [90, 0]",
        5,
        &["at_mm of `cylinder 1`", "in the base of the arm"],
    ),
    (
        "[pen]\n[[cylinder]]\ndiameter_mm = 50\nheight_mm = 9\nat_mm = [200, 0]\nturn_deg = 3",
        6,
        &["unknown field `turn_deg`"],
    ),
    (
        "[pen]\n[[box]]\nname = \"\"\nsize_mm = [9, 9, 9]\nat_mm = [200, 0]",
        3,
        &["a name is \"\"", "1 to 40"],
    ),
];

/// Two cubes, the second of which is wrong.
const TWO: &str = "[pen]
[[box]]
name = \"a\"
size_mm = [20, 20, 20]
at_mm = [200, 0]
[[box]]
";

const BAD_SECOND: &[(&str, usize, &[&str])] = &[
    (
        "name = \"a\"\nsize_mm = [9, 9, 9]\nat_mm = [150, 0]",
        6,
        &["the name `a` is already used in line 2"],
    ),
    (
        "size_mm = [20, 20, 20]\nat_mm = [219, 0]",
        6,
        &["`box 2` overlaps `a` of line 2"],
    ),
    (
        "size_mm = [9, 9, 9]\nat_mm = [200, 0]\non = \"b\"",
        9,
        &["`box 2` cannot stand on `b`", "no object of that name"],
    ),
    (
        "size_mm = [9, 9, 9]\nat_mm = [230, 0]\non = \"a\"",
        9,
        &["cannot stand on `a`", "no part of it is above"],
    ),
    (
        "size_mm = [9, 9, 9]\nat_mm = [200, 0]\non = \"box 2\"",
        9,
        &["cannot stand on `box 2`", "in a circle"],
    ),
];

#[track_caller]
fn expect_error(text: &str, line: usize, parts: &[&str]) {
    let error = Scene::parse(text).unwrap_err().to_string();
    assert!(
        error.starts_with(&format!("line {line}: ")),
        "{error}\n{text}"
    );
    for part in parts {
        assert!(error.contains(part), "`{part}` is missing: {error}");
    }
    assert!(!error.contains('\n') && !error.ends_with('.'), "{error}");
}

#[test]
fn a_bad_scene_is_reported_with_its_line_what_was_found_and_what_is_allowed() {
    for (text, line, parts) in BAD {
        expect_error(text, *line, parts);
    }
    for (text, line, parts) in BAD_SECOND {
        expect_error(&format!("{TWO}{text}"), *line, parts);
    }
}

#[test]
fn objects_may_touch_and_stand_on_each_other_in_any_order() {
    let beside = format!("{TWO}size_mm = [20, 20, 20]\nat_mm = [220, 0]");
    assert_eq!(Scene::parse(&beside).unwrap().objects.len(), 2);
    let below = format!(
        "{TWO}name = \"c\"\nsize_mm = [9, 9, 9]\nat_mm = [200, 0]\non = \"b\"
[[cylinder]]\nname = \"b\"\ndiameter_mm = 9\nheight_mm = 5\nat_mm = [200, 0]\non = \"a\""
    );
    let objects = Scene::parse(&below).unwrap().objects;
    let tops: Vec<(&str, f64)> = objects.iter().map(|it| (&*it.name, it.top_mm())).collect();
    assert_eq!(tops, [("a", 20.0), ("c", 34.0), ("b", 25.0)]);
}

#[test]
fn the_sample_scenes_are_good() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes");
    let files: Vec<_> = std::fs::read_dir(folder).unwrap().collect();
    assert!(files.len() >= 3);
    for file in files {
        let path = file.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let scene = Scene::parse(&text);
        assert!(scene.is_ok(), "{}: {scene:?}", path.display());
    }
}
