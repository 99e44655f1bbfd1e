use dobot_teach::NoFiles;
use dobot_wire::Command;

use dobot_api::NewJob;
use dobot_arm::Tool;
use dobot_host::{PlannedFor, Rules};
use dobot_safety::Policy;
use dobot_teach::{GridSize, Point};

use super::*;

fn place(x: f64, suction: bool) -> RecordedPlace {
    RecordedPlace {
        point_mm: [x, 0.0, 10.0],
        rotation_deg: 0.0,
        suction,
        gripper_deg: 0.0,
    }
}

/// The texts of the rows after the start.
fn lines(it: &Lesson) -> Vec<String> {
    let rows = it.rows().into_iter().skip(1);
    rows.map(|(_, text)| text).collect()
}

/// The x of the targets of a run.
fn run(it: &mut Lesson) -> Vec<f32> {
    let job = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
    targets(&job)
}

fn capture(it: &mut Lesson, x: f64) {
    it.capture(&place(x, false), MovingMode::Jump).unwrap();
}

/// Selects a row by a part of its text.
fn select(it: &mut Lesson, part: &str) {
    let at = it.rows().iter().position(|row| row.1.contains(part));
    let at = at.unwrap_or_else(|| panic!("{part} is missing: {:?}", it.rows()));
    while it.cursor() > at {
        it.move_cursor(false);
    }
    while it.cursor() < at {
        it.move_cursor(true);
    }
}

/// A pick at 200, a place at 250.
fn pick_and_place() -> Lesson {
    let mut it = Lesson::new("cubes".into());
    it.capture(&place(200.0, false), MovingMode::Jump).unwrap();
    assert!(it.switch_suction(true).unwrap());
    it.capture(&place(250.0, true), MovingMode::Jump).unwrap();
    assert!(it.switch_suction(false).unwrap());
    it
}

fn any_arm() -> PlannedFor {
    PlannedFor::any(Rules::of(&Policy::default()).into(), None)
}

#[test]
fn a_pick_and_place_is_taught_with_four_keys() {
    let it = pick_and_place();
    let program = Program::from_toml(&it.text()).unwrap();
    assert_eq!(program.title, "cubes");
    assert!(it.text().contains("p1 = { x = 200"), "{}", it.text());
    assert_eq!(program.points["p1"], Point::xyz(200.0, 0.0, 10.0));
    assert_eq!(program.points["p2"], Point::xyz(250.0, 0.0, 10.0));
    let lines = lines(&it);
    assert_eq!(lines.len(), 4, "{lines:?}");
    assert!(lines[0].contains("go = \"p1\""), "{lines:?}");
    assert!(lines[1].contains("suction = true"), "{lines:?}");
    assert!(!lines[2].contains("suction"), "it is on already: {lines:?}");
    assert_eq!(it.cursor(), 4);
}

#[test]
fn every_key_can_be_undone_down_to_the_empty_program() {
    let mut it = pick_and_place();
    it.shift(false).unwrap();
    it.remove().unwrap();
    it.add_path(&[place(260.0, true), place(270.0, true)])
        .unwrap();
    let mut texts = Vec::new();
    while it.undo() {
        texts.push((it.text(), it.cursor()));
    }
    assert_eq!(texts.len(), 7);
    assert_eq!(texts.last(), Some(&(String::new(), 0)));
    assert_eq!(texts[2].0, pick_and_place().text());
}

#[test]
fn a_step_is_put_behind_the_cursor_and_moved_with_it() {
    let mut it = pick_and_place();
    it.move_cursor(false);
    it.move_cursor(false);
    it.capture(&place(220.0, true), MovingMode::MovL).unwrap();
    assert_eq!(it.cursor(), 3);
    assert!(lines(&it)[2].contains("p3"), "{:?}", lines(&it));
    it.shift(true).unwrap();
    assert_eq!(it.cursor(), 4);
    assert!(lines(&it)[3].contains("p3"), "{:?}", lines(&it));
}

#[test]
fn the_pump_is_not_taught_twice_nor_before_the_first_point() {
    let mut it = Lesson::new(String::new());
    assert!(!it.switch_suction(true).unwrap());
    it.capture(&place(200.0, true), MovingMode::Jump).unwrap();
    assert!(lines(&it)[0].contains("suction = true"), "{:?}", lines(&it));
    assert!(!it.switch_suction(true).unwrap());
}

#[test]
fn a_program_goes_on_where_it_was_and_keeps_its_comments() {
    let text =
        "# mine\n[points]\np1 = { x = 200, y = 0, z = 0 } # the pick\n\n[[steps]]\ngo = \"p1\"\n";
    let mut it = Lesson::of_text(text).unwrap();
    assert!(!it.is_changed());
    assert_eq!(
        it.capture(&place(230.0, false), MovingMode::MovJ).unwrap(),
        "p2"
    );
    assert!(it.is_changed());
    let now = it.text();
    assert!(
        now.contains("# mine") && now.contains("# the pick"),
        "{now}"
    );
    it.handle_saved(now);
    assert!(!it.is_changed());
}

fn targets(job: &NewJob) -> Vec<f32> {
    let x = |it: &Command| match it {
        Command::MoveTo(it) => Some(it.x_mm),
        _ => None,
    };
    job.commands.iter().filter_map(x).collect()
}

#[test]
fn a_part_of_the_program_is_run_from_the_cursor_on() {
    let mut it = pick_and_place();
    it.move_cursor(false);
    let rest = it.job(Part::FromHere, &mut NoFiles, &any_arm()).unwrap();
    assert_eq!(targets(&rest).first(), Some(&250.0));
    let all = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
    assert_eq!(targets(&all).first(), Some(&200.0));
    assert_eq!(all.program.repeat, None);
    let looped = it.job(Part::Loop, &mut NoFiles, &any_arm()).unwrap();
    assert_eq!(looped.program.repeat.map(|it| it.times), Some(None));
    assert!(
        Lesson::new(String::new())
            .job(Part::All, &mut NoFiles, &any_arm(),)
            .is_err()
    );
}

#[test]
fn what_was_undone_is_made_again_until_something_else_is_taught() {
    let mut it = Lesson::new("t".into());
    assert!(!it.redo());
    it.capture(&place(200.0, false), MovingMode::Jump).unwrap();
    it.capture(&place(210.0, true), MovingMode::MovL).unwrap();
    let (text, cursor) = (it.text(), it.cursor());
    while it.undo() {}
    assert_eq!(it.text(), "");
    while it.redo() {}
    assert_eq!((it.text(), it.cursor()), (text.clone(), cursor));
    while it.undo() {}
    it.capture(&place(220.0, false), MovingMode::Jump).unwrap();
    assert!(!it.redo());
    assert_ne!(it.text(), text);
}

#[test]
fn an_impossible_step_is_reported_before_anything_runs_and_the_cursor_moves_to_it() {
    let mut it = Lesson::new("t".into());
    for x in [200.0, 900.0, 210.0] {
        it.capture(&place(x, false), MovingMode::MovL).unwrap();
    }
    let arm = any_arm();
    for part in [Part::All, Part::Loop] {
        it.move_cursor(true);
        let why = it.job(part, &mut NoFiles, &arm).unwrap_err();
        assert!(why.starts_with("step 2: "), "{why}");
        assert_eq!(it.cursor(), 2);
    }
}

#[test]
fn a_step_is_added_before_the_first_one_from_the_start() {
    let mut it = pick_and_place();
    select(&mut it, "start");
    capture(&mut it, 180.0);
    assert_eq!(run(&mut it)[..2], [180.0, 200.0]);
    assert_eq!(it.cursor(), 1);
}

#[test]
fn a_point_is_named_also_after_the_pump_was_switched() {
    let mut it = pick_and_place();
    let last = it.last_point().unwrap();
    it.rename_point(&last, "tray").unwrap();
    assert!(lines(&it)[2].contains("go = \"tray\""), "{:?}", lines(&it));
    assert_eq!(it.cursor(), 4, "the cursor stays");
    assert!(it.text().contains("tray = { x = 250"), "{}", it.text());
    let error = it.rename_point("tray", "p1").unwrap_err().to_string();
    assert!(error.contains("already a point"), "{error}");
    assert!(it.undo());
    assert_eq!(it.text(), pick_and_place().text());
}

#[test]
fn a_repeat_begins_with_the_next_step_and_ends_after_the_selected_one() {
    let mut it = Lesson::new("t".into());
    capture(&mut it, 200.0);
    assert!(!it.begin_repeat(Times::Count(3)).unwrap());
    assert!(it.end_block().is_err(), "it has no step");
    capture(&mut it, 210.0);
    capture(&mut it, 220.0);
    assert_eq!(it.end_block().unwrap(), "repeat");
    capture(&mut it, 230.0);
    let expected = [
        "go = \"p1\"",
        "repeat = 3",
        "  go = \"p2\"",
        "  go = \"p3\"",
        "end of repeat",
        "go = \"p4\"",
    ];
    assert_eq!(lines(&it), expected);
    let cycle = [210.0, 220.0];
    let all = [&[200.0][..], &cycle, &cycle, &cycle, &[230.0]].concat();
    assert_eq!(run(&mut it), all);
}

#[test]
fn a_repeat_is_put_around_steps_that_were_taught() {
    let mut it = Lesson::new("t".into());
    for x in [200.0, 210.0, 220.0, 230.0] {
        capture(&mut it, x);
    }
    select(&mut it, "p1");
    assert!(it.begin_repeat(Times::Count(2)).unwrap());
    select(&mut it, "p3");
    it.end_block().unwrap();
    assert_eq!(run(&mut it), [200.0, 210.0, 220.0, 210.0, 220.0, 230.0]);
    select(&mut it, "repeat = 2");
    it.shift(true).unwrap();
    // A repeat at the end is not expanded.
    assert_eq!(run(&mut it), [200.0, 230.0, 210.0, 220.0]);
    while it.undo() {}
    assert_eq!(it.text(), "");
}

#[test]
fn the_first_step_of_a_program_may_be_in_a_repeat() {
    let mut it = Lesson::new("t".into());
    it.begin_repeat(Times::Count(2)).unwrap();
    capture(&mut it, 200.0);
    assert!(it.undo());
    assert_eq!(it.text(), "");
    assert!(it.redo());
    assert_eq!(lines(&it), ["repeat = 2", "  go = \"p1\"", "end of repeat"]);
    it.begin_repeat(Times::Count(5)).unwrap();
    assert!(it.undo(), "a repeat without a step is dropped");
    assert_eq!(it.begun(), None);
    assert_eq!(lines(&it).len(), 3);
}

#[test]
fn steps_move_into_a_repeat_and_out_of_it() {
    let mut it = Lesson::new("t".into());
    for x in [200.0, 210.0, 220.0] {
        capture(&mut it, x);
    }
    select(&mut it, "p2");
    it.begin_repeat(Times::Count(2)).unwrap();
    select(&mut it, "p2");
    let mut seen = Vec::new();
    for down in [true, true, true, false, false, false] {
        it.shift(down).unwrap();
        let position = lines(&it).iter().position(|line| line.contains("p2"));
        assert_eq!(position.map(|row| row + 1), Some(it.cursor()));
        seen.push(position);
    }
    let expected = [2, 3, 4, 3, 2, 1].map(Some);
    assert_eq!(seen, expected);
    select(&mut it, "p3");
    let error = it.remove().unwrap_err().to_string();
    assert!(error.contains("only step of the repeat"), "{error}");
    select(&mut it, "repeat");
    it.remove().unwrap();
    assert_eq!(lines(&it).len(), 2);
}

#[test]
fn an_endless_repeat_is_the_last_step_of_a_program() {
    let mut it = Lesson::new("t".into());
    it.begin_repeat(Times::Forever).unwrap();
    capture(&mut it, 200.0);
    let error = it.end_block().unwrap_err().to_string();
    assert!(error.contains("nothing can follow"), "{error}");
    let error = it.begin_repeat(Times::Forever).unwrap_err().to_string();
    assert!(error.contains("enter a count"), "{error}");
    assert_eq!(lines(&it), ["repeat = \"forever\"", "  go = \"p1\""]);
    let job = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
    assert_eq!(job.program.repeat.map(|repeat| repeat.times), Some(None));
}

#[test]
fn the_pump_is_switched_in_every_cycle_of_a_repeat() {
    let mut it = Lesson::new("t".into());
    capture(&mut it, 200.0);
    assert!(it.switch_suction(true).unwrap());
    it.begin_repeat(Times::Count(2)).unwrap();
    assert!(
        it.switch_suction(true).unwrap(),
        "it may be off in the second cycle"
    );
    assert!(!it.switch_suction(true).unwrap());
    assert!(it.switch_suction(false).unwrap());
}

#[test]
fn points_after_a_tool_are_those_of_its_tip() {
    let mut it = Lesson::new("t".into());
    let tool = MountedTool {
        kind: Tool::Gripper,
        length: 40.0,
    };
    assert!(!it.add_tool(tool).unwrap());
    capture(&mut it, 200.0);
    it.add_path(&[place(210.0, false), place(220.0, false)])
        .unwrap();
    assert_eq!(it.program().points["p1"], Point::xyz(200.0, 0.0, -30.0));
    assert!(
        it.text()
            .contains("gripper = { kind = \"gripper\", length = 40.0 }"),
        "{}",
        it.text()
    );
    let job = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
    let heights = job.commands.iter().filter_map(|command| match command {
        Command::MoveTo(target) => Some(target.z_mm),
        _ => None,
    });
    assert_eq!(
        heights.collect::<Vec<_>>(),
        [10.0; 3],
        "the wrist goes where it was"
    );
    // Another length for points that were taught already.
    select(&mut it, "start");
    let longer = MountedTool {
        length: 60.0,
        ..tool
    };
    assert!(it.add_tool(longer).unwrap());
    assert!(lines(&it)[0].contains("gripper2"), "{:?}", lines(&it));
}

fn corner(x: f64, y: f64) -> RecordedPlace {
    RecordedPlace {
        point_mm: [x, y, 10.0],
        ..place(0.0, false)
    }
}

fn tray(name: &str, columns: u32, y: f64) -> TouchedGrid {
    TouchedGrid {
        name: name.to_owned(),
        corners: [corner(200.0, y), corner(220.0, y), corner(200.0, y + 30.0)],
        size: GridSize {
            columns,
            rows: 2,
            layers: 1,
            layer_mm: 0.0,
        },
    }
}

#[test]
fn a_grid_is_visited_cell_by_cell_and_what_is_taught_next_belongs_to_each_cell() {
    let mut it = Lesson::new("t".into());
    let (used, corner_deg) = it
        .add_grid(&tray("from", 2, 0.0), MovingMode::Jump)
        .unwrap();
    assert_eq!(used, GridUse::Visited);
    assert!((corner_deg - 90.0).abs() < 1e-9, "{corner_deg}");
    it.switch_suction(true).unwrap();
    let error = it
        .add_grid(&tray("to", 3, -60.0), MovingMode::Jump)
        .unwrap_err();
    assert!(error.to_string().contains("6 cells"), "{error}");
    let joined = it
        .add_grid(&tray("to", 2, -60.0), MovingMode::Jump)
        .unwrap();
    assert_eq!(joined.0, GridUse::Joined);
    let lines = lines(&it);
    assert_eq!(lines[0], "each = [\"from\", \"to\"]");
    assert_eq!(lines[3], "  go = \"to\"");
    assert_eq!(
        run(&mut it),
        [
            200.0, 200.0, 200.0, 220.0, 220.0, 220.0, 200.0, 200.0, 200.0, 220.0, 220.0, 220.0
        ]
    );
    while it.undo() {}
    assert_eq!(it.text(), "");
}

#[test]
fn a_grid_that_is_taught_again_keeps_its_steps() {
    let mut it = Lesson::new("t".into());
    it.add_grid(&tray("tray", 2, 0.0), MovingMode::MovL)
        .unwrap();
    let before = (lines(&it), it.cursor());
    let mut moved = tray("tray", 2, 0.0);
    for corner in &mut moved.corners {
        corner.point_mm[0] += 50.0;
    }
    let (used, _) = it.add_grid(&moved, MovingMode::Jump).unwrap();
    assert_eq!(used, GridUse::TaughtAgain);
    assert_eq!((lines(&it), it.cursor()), before);
    assert_eq!(run(&mut it), [250.0, 270.0, 250.0, 270.0]);
}

#[test]
fn points_are_taught_in_a_frame_until_another_one_is_chosen() {
    let mut it = Lesson::new("t".into());
    let points = [
        corner(200.0, 10.0),
        corner(200.0, 50.0),
        corner(150.0, 10.0),
    ];
    let error = it.set_frame("tray", &points).unwrap_err().to_string();
    assert!(error.contains("no step yet"), "{error}");
    capture(&mut it, 190.0);
    assert!(
        it.set_frame("tray", &points).unwrap(),
        "its z axis points up"
    );
    assert_eq!(it.frame(), Some("tray"));
    capture(&mut it, 210.0);
    it.use_frame(None);
    capture(&mut it, 220.0);
    assert!(
        it.text()
            .contains("p2 = { x = -10.0, y = -10.0, z = 0.0, rotation = -90.0, frame = \"tray\" }"),
        "{}",
        it.text()
    );
    for (target, expected) in run(&mut it).into_iter().zip([190.0, 210.0, 220.0_f32]) {
        assert!(
            (target - expected).abs() < 0.01,
            "{target} instead of {expected}"
        );
    }
    let [origin, x, y] = points;
    assert!(
        !it.set_frame("down", &[origin, y, x]).unwrap(),
        "its z axis points down"
    );
    let error = it
        .set_frame("line", &[origin, x, x])
        .unwrap_err()
        .to_string();
    assert!(error.contains("on one line"), "{error}");
    assert_eq!(it.frame(), Some("down"));
    assert!(it.undo());
    assert_eq!(it.frame(), None, "the frame is gone");
}
