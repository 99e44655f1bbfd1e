//! Edits of programs keep comments.

use dobot_arm::Tool;
use dobot_teach::{
    Action, Frame, Go, Grid, Here, MountedTool, NoFiles, Offset, Point, Program, ProgramDocument,
    RecordedPlace, Times,
};

const TEXT: &str = "# A cube, to and fro.
title = \"cube\"

[points]
here = { x = 200, y = 60, z = 0 } # beside the tray

# Take it.
[[steps]]
go = \"here\"
suction = true

# Wait for the cup.
[[steps]]
pause = 0.5
";

#[test]
fn a_step_is_inserted_and_every_comment_stays() {
    let mut document = ProgramDocument::new(TEXT).unwrap();
    document
        .insert(&[1], Action::Go(Go::to(Point::xyz(210.0, 0.0, 5.5))))
        .unwrap();
    let text = document.text();
    assert_eq!(
        text,
        TEXT.replace(
            "# Wait",
            "[[steps]]\ngo = { x = 210.0, y = 0.0, z = 5.5 }\n\n# Wait"
        ),
    );
    assert_eq!(document.program().unwrap().steps.0.len(), 3);
}

#[test]
fn a_step_moves_with_the_comment_above_it_and_the_move_is_undone() {
    let mut document = ProgramDocument::new(TEXT).unwrap();
    document.insert(&[2], Action::Go(Go::to("here"))).unwrap();
    let before = document.text();
    document.move_step(&[1], &[2]).unwrap();
    let text = document.text();
    assert!(
        text.ends_with("[[steps]]\ngo = \"here\"\n\n# Wait for the cup.\n[[steps]]\npause = 0.5\n"),
        "{text}"
    );
    assert!(document.undo());
    assert_eq!(document.text(), before);
    assert!(document.redo());
    assert_eq!(document.text(), text);
}

#[test]
fn a_replaced_step_keeps_the_comment_above_it() {
    let mut document = ProgramDocument::new(TEXT).unwrap();
    let longer = Here {
        pause: Some(2.0),
        ..Here::default()
    };
    document.replace(&[1], Action::Here(longer)).unwrap();
    assert_eq!(document.text(), TEXT.replace("0.5", "2.0"));
    document.remove(&[1]).unwrap();
    assert!(
        document.text().ends_with("suction = true\n"),
        "{}",
        document.text()
    );
}

#[test]
fn a_point_is_taught_again_or_for_the_first_time() {
    let mut document = ProgramDocument::new(TEXT).unwrap();
    document
        .set_point("here", &Point::Joints([1.0, 2.0, 3.0, 4.0]))
        .unwrap();
    document
        .set_point("there", &Point::xyz(1.0, 2.0, 3.0))
        .unwrap();
    let text = document.text();
    let program = document.program().unwrap();
    assert_eq!(program.points["here"], Point::Joints([1.0, 2.0, 3.0, 4.0]));
    assert_eq!(program.points["there"], Point::xyz(1.0, 2.0, 3.0));
    assert!(
        text.contains("# beside the tray") && text.starts_with("# A cube"),
        "{text}"
    );
    let mut bare = ProgramDocument::new("[[steps]]\npause = 1\n").unwrap();
    bare.set_point("p", &Point::xyz(1.0, 2.0, 3.0)).unwrap();
    assert_eq!(bare.program().unwrap().points.len(), 1);
}

#[test]
fn a_change_that_would_break_the_program_is_not_made() {
    let mut document = ProgramDocument::new(TEXT).unwrap();
    let error = document
        .insert(&[0], Action::Go(Go::to("nowhere")))
        .unwrap_err();
    assert!(
        error.to_string().contains("no point \"nowhere\""),
        "{error}"
    );
    assert!(document.insert(&[9], Action::Laser(false)).is_err());
    assert!(document.remove(&[2]).is_err());
    assert_eq!(document.text(), TEXT);
    assert!(!document.undo());
}

/// Three points, in this order.
const THREE: &str = "[points]
a = { x = 200, y = 0, z = 0 } # first
b = { x = 210, y = 0, z = 0 }
c = { x = 220, y = 0, z = 0 }

[[steps]]
go = \"a\"

# The second one.
[[steps]]
go = \"b\"

[[steps]]
go = \"c\"
";

fn labels(text: &str) -> Vec<String> {
    let compiled = Program::from_toml(text).unwrap();
    let compiled = compiled.compile(&mut NoFiles).unwrap();
    compiled
        .steps
        .into_iter()
        .map(|step| step.label.to_string())
        .collect()
}

#[test]
fn a_repeat_is_put_around_steps_that_were_there_and_ended_after_one_of_them() {
    let mut document = ProgramDocument::new(THREE).unwrap();
    document.repeat(&[0], Times::Count(2)).unwrap();
    assert_eq!(document.steps(), 1);
    document.end_block(&[0, 1]).unwrap();
    assert_eq!(document.steps(), 2);
    let text = document.text();
    assert_eq!(
        labels(&text),
        ["go to a", "go to b", "go to a", "go to b", "go to c"]
    );
    assert!(
        text.contains("# The second one.\n[[steps.steps]]\ngo = \"b\"\n"),
        "{text}"
    );
    assert!(document.undo() && document.undo());
    assert_eq!(document.text(), THREE);
    assert!(
        document.end_block(&[0]).is_err(),
        "it is not inside a block"
    );
}

#[test]
fn steps_inside_others_are_inserted_moved_and_removed() {
    let mut document = ProgramDocument::new(THREE).unwrap();
    document.repeat(&[1], Times::Count(1)).unwrap();
    document.insert(&[1, 1], Action::Go(Go::to("a"))).unwrap();
    assert_eq!(
        labels(&document.text()),
        ["go to a", "go to b", "go to a", "go to c"]
    );
    document.move_step(&[0], &[0, 0]).unwrap();
    assert_eq!(
        labels(&document.text()),
        ["go to a", "go to b", "go to a", "go to c"]
    );
    document.move_step(&[0, 3], &[0]).unwrap();
    assert_eq!(
        labels(&document.text()),
        ["go to c", "go to a", "go to b", "go to a"]
    );
    document.remove(&[1, 1]).unwrap();
    assert_eq!(labels(&document.text()), ["go to c", "go to a", "go to a"]);
    document.remove(&[1, 1]).unwrap();
    let error = document.remove(&[1, 0]).unwrap_err().to_string();
    assert!(error.contains("repeat has no steps"), "{error}");
    assert!(document.insert(&[1, 5], Action::Laser(false)).is_err());
    assert!(document.insert(&[0, 0], Action::Laser(false)).is_err());
}

#[test]
fn a_point_is_renamed_wherever_it_is_used() {
    let text = format!(
        "{THREE}\n[[steps]]\narc = {{ through = \"b\", to = \"c\" }}\n\n[grids.tray]\nat = \"b\" # here\npitch = {{ x = 3 }}\n
[frames]\nf = {{ origin = \"a\", x = \"b\", y = \"c\" }}\n"
    );
    let mut document = ProgramDocument::new(&text).unwrap();
    document.rename_point("b", "the middle").unwrap();
    let renamed = text
        .replace("b = {", "\"the middle\" = {")
        .replace("\"b\"", "\"the middle\"");
    assert_eq!(document.text(), renamed);
    for taken in ["a", "tray"] {
        let error = document.rename_point("c", taken).unwrap_err().to_string();
        assert!(error.contains("there is already a"), "{error}");
    }
    assert!(
        document.rename_point("b", "d").is_err(),
        "it has another name"
    );
}

#[test]
fn grids_frames_and_tools_are_added_before_the_steps() {
    let mut document = ProgramDocument::new("title = \"t\"\n\n[[steps]]\npause = 1\n").unwrap();
    let corner = |x, y| Point::xyz(x, y, 0.0).into();
    let frame = Frame {
        origin: corner(200.0, 0.0),
        x: corner(230.0, 0.0),
        y: corner(200.0, 30.0),
    };
    document.set_frame("tray", &frame).unwrap();
    let grid = Grid {
        at: corner(200.0, 0.0),
        columns: 2,
        rows: 2,
        layers: 1,
        pitch: Offset {
            x: 10.0,
            y: 10.0,
            z: 0.0,
        },
    };
    document.set_grid("cells", &grid).unwrap();
    let tool = MountedTool {
        kind: Tool::Gripper,
        length: 40.0,
    };
    document.set_tool("gripper", &tool).unwrap();
    let each = Action::Each(
        vec!["cells".into()],
        dobot_teach::Steps::new(vec![Action::Go(Go::to("cells"))]),
    );
    document.insert(&[1], each).unwrap();
    document.set_grid("more", &grid).unwrap();
    document
        .set_each(&[1], &["cells".into(), "more".into()])
        .unwrap();
    assert!(document.set_each(&[1], &["none".into()]).is_err());
    let text = document.text();
    assert!(text.contains("each = [\"cells\", \"more\"]"), "{text}");
    assert!(text.starts_with("title = \"t\"\n"), "{text}");
    let at = |part: &str| text.find(part).unwrap();
    assert!(
        at("[frames]").max(at("[grids]")).max(at("[tools]")) < at("[[steps]]"),
        "{text}"
    );
    let program = document.program().unwrap();
    assert_eq!(program.frames["tray"], frame);
    assert_eq!(program.grids["more"], grid);
    assert_eq!(program.tools["gripper"], tool);
    let taught = RecordedPlace {
        point_mm: [203.0, 4.0, 45.0],
        rotation_deg: 0.0,
        suction: false,
        gripper_deg: 0.0,
    };
    let point = program
        .point_in("tray", &taught.tip(40.0), Some(&tool))
        .unwrap();
    let Point::Cartesian { position, .. } = point else {
        panic!("{point:?}");
    };
    assert_eq!(position, [3.0, 4.0, 5.0]);
}
