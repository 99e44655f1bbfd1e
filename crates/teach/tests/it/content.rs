//! New content in an old text: nothing is lost, and comments stay with what they explain.

use dobot_teach::{Program, with_content};
use proptest::prelude::*;

const TEXT: &str = r#"# cubes from left to right
title = "cubes"   # shown in the list

[points]
# measured on Monday
left = { x = 200, y = 80, z = 0 }  # not higher
right = { x = 200.0, y = -80, z = 0 }

# the first motion is slow
[[steps]]
speed = { percent = 30 }

# three times
[[steps]]
repeat = 3

  # softly
  [[steps.steps]]
  go = "left"
  suction = true   # the cup

  [[steps.steps]]
  go = "right"
  suction = false
"#;

fn edited(edit: impl Fn(&mut toml::Table)) -> String {
    let mut content: toml::Table = TEXT.parse().unwrap();
    edit(&mut content);
    let text = with_content(TEXT, &content.to_string()).unwrap();
    let found: toml::Table = text.parse().unwrap();
    assert_eq!(found, content, "{text}");
    text
}

fn steps(content: &mut toml::Table) -> &mut Vec<toml::Value> {
    content["steps"].as_array_mut().unwrap()
}

#[test]
fn the_same_content_leaves_the_text_as_it_is() {
    let content: toml::Table = TEXT.parse().unwrap();
    assert_eq!(with_content(TEXT, &content.to_string()).unwrap(), TEXT);
    // 200.0 is 200.
    let content = TEXT.replace("200.0", "200");
    assert_eq!(with_content(TEXT, &content).unwrap(), TEXT);
}

#[test]
fn a_changed_value_changes_nothing_else() {
    let text = edited(|content| {
        steps(content)[1]["steps"][0]["suction"] = false.into();
    });
    assert_eq!(text, TEXT.replace("suction = true ", "suction = false "));
    let text = edited(|content| content["points"]["left"]["z"] = 5.into());
    assert_eq!(text, TEXT.replace("z = 0 }  #", "z = 5 }  #"));
}

#[test]
fn a_moved_step_takes_its_comments_along_also_into_a_repeat() {
    let text = edited(|content| {
        let steps = steps(content);
        let speed = steps.remove(0);
        let inner = steps[0]["steps"].as_array_mut().unwrap();
        inner.insert(1, speed);
    });
    let (slow, cup) = (
        text.find("# the first motion is slow"),
        text.find("# the cup"),
    );
    assert!(slow > cup && cup.is_some(), "{text}");
    assert_eq!(
        text.matches('#').count(),
        TEXT.matches('#').count(),
        "{text}"
    );
    let text = edited(|content| steps(content).swap(0, 1));
    let (slow, three) = (
        text.find("# the first motion is slow"),
        text.find("# three times"),
    );
    assert!(slow > three && three.is_some(), "{text}");
}

#[test]
fn new_names_and_steps_are_written_as_people_write_them() {
    let text = edited(|content| {
        let tray = "at = \"left\"\npitch = { x = 30 }";
        let tray: toml::Table = tray.parse().unwrap();
        let grids = toml::Table::from_iter([("tray".to_owned(), tray.into())]);
        content.insert("grids".into(), grids.into());
        let step: toml::Table = "go = \"left\"\noffset = { z = 20 }".parse().unwrap();
        steps(content).push(step.into());
    });
    assert!(
        text.contains("[grids]\ntray = { at = \"left\", pitch = { x = 30 } }\n"),
        "{text}"
    );
    assert!(text.find("[grids]") < text.find("[[steps]]"), "{text}");
    assert!(
        text.ends_with("\n[[steps]]\ngo = \"left\"\noffset = { z = 20 }\n"),
        "{text}"
    );
    assert!(Program::from_toml(&text).is_ok(), "{text}");
}

#[test]
fn a_removed_step_takes_its_comments_along() {
    let text = edited(|content| {
        steps(content).remove(0);
    });
    assert!(
        !text.contains("# the first motion") && text.contains("# three times"),
        "{text}"
    );
    let text = edited(|content| steps(content).clear());
    assert!(
        text.contains("# measured on Monday") && text.contains("steps = []"),
        "{text}"
    );
}

#[test]
fn unknown_keys_and_wrong_values_are_kept() {
    let content =
        "colour = \"red\"\n[[steps]]\ngo = 7\nglue = [1, \"x\"]\n[steps.deep]\nat = 1979-05-27\n";
    let text = with_content("[[steps]]\npause = 1\n", content).unwrap();
    let (found, wanted) = (text.parse::<toml::Table>(), content.parse::<toml::Table>());
    assert_eq!(found.unwrap(), wanted.unwrap(), "{text}");
}

#[test]
fn a_text_that_is_not_toml_is_refused_with_the_line() {
    let error = with_content("[[steps]]\npause = = 1", "").unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("line 2: the text is not TOML"),
        "{error}"
    );
}

/// Steps with few different contents, so that many are equal, some with steps inside.
fn list() -> impl Strategy<Value = toml::Value> {
    let leaf = (0..4_i64, any::<bool>()).prop_map(|(pause, suction)| {
        let mut step = toml::Table::from_iter([("pause".to_owned(), pause.into())]);
        if suction {
            step.insert("suction".into(), true.into());
        }
        toml::Value::Table(step)
    });
    let step = leaf.prop_recursive(3, 24, 5, |step| {
        (0..3_i64, prop::collection::vec(step, 0..5)).prop_map(|(times, steps)| {
            let rows = [
                ("repeat".to_owned(), times.into()),
                ("steps".to_owned(), steps.into()),
            ];
            toml::Value::Table(toml::Table::from_iter(rows))
        })
    });
    prop::collection::vec(step, 0..6).prop_map(toml::Value::Array)
}

proptest! {
    #[test]
    fn the_content_arrives_whatever_the_text_was(was in list(), is in list()) {
        let [was, is] = [was, is].map(|steps| toml::Table::from_iter([("steps".to_owned(), steps)]));
        let text = with_content(&was.to_string(), &is.to_string()).unwrap();
        prop_assert_eq!(text.parse::<toml::Table>().unwrap(), is);
    }
}
