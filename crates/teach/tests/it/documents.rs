//! Edits of programs keep comments.

use dobot_teach::{Action, Go, Here, Point, ProgramDocument};

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
        .insert(1, Action::Go(Go::to(Point::xyz(210.0, 0.0, 5.5))))
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
    document.insert(2, Action::Go(Go::to("here"))).unwrap();
    let before = document.text();
    document.move_step(1, 2).unwrap();
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
    document.replace(1, Action::Here(longer)).unwrap();
    assert_eq!(document.text(), TEXT.replace("0.5", "2.0"));
    document.remove(1).unwrap();
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
        .insert(0, Action::Go(Go::to("nowhere")))
        .unwrap_err();
    assert!(
        error.to_string().contains("no point \"nowhere\""),
        "{error}"
    );
    assert!(document.insert(9, Action::Laser(false)).is_err());
    assert!(document.remove(2).is_err());
    assert_eq!(document.text(), TEXT);
    assert!(!document.undo());
}
