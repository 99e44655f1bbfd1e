use super::*;

const SQUARE: &str = "o100 sub (a square)\nG91\nG1 X10\nY10\nX-10\nY-10\nG90\no100 endsub\n";

#[test]
fn a_subroutine_is_drawn_where_it_is_called() {
    let calls = "G0 X0 Y0\nO100 call\nG0 X20\no100 CALL ; again\nM2";
    for text in [
        format!("{SQUARE}{calls}"),
        format!("{SQUARE}{calls}").replace("100", "<square>"),
        format!("o1 sub\nO100 call\no1 endsub\n{SQUARE}G0 X0\no1 call\nG0 X20\no1 call"),
    ] {
        let starts = corners(&text)
            .iter()
            .map(|line| line[0])
            .collect::<Vec<_>>();
        assert_eq!(starts, [(0.0, 10.0), (20.0, 10.0)], "{text}");
        let lengths = draw(&text).0.layers[0]
            .strokes
            .iter()
            .map(Stroke::length_mm)
            .collect::<Vec<_>>();
        assert_eq!(lengths, [40.0, 40.0], "{text}");
    }
}

#[test]
fn a_mistake_in_a_subroutine_ends_the_drawing_at_its_call() {
    let text = "o1 sub\nG1 Y5\nG1 Xabc\no1 endsub\nG1 X10\no1 call\nG1 X20";
    let (artwork, warnings) = draw(text);
    assert_eq!(
        corners_of(&artwork),
        [[(0.0, 5.0), (10.0, 5.0), (10.0, 0.0)]]
    );
    assert!(
        warnings[0].starts_with("3:4: found \"Xabc\""),
        "{warnings:?}"
    );
}

#[test]
fn calls_without_an_end_are_refused_with_their_place() {
    for (text, expected) in [
        (
            "o1 call",
            "1:1: found \"o1 call\"; expected a call of a subroutine defined above in this file",
        ),
        (
            "o1 sub\nG1 X1",
            "1:1: found \"o1 sub\"; expected endsub with the same name after it",
        ),
        (
            "o1 endsub",
            "1:1: found \"o1 endsub\"; expected endsub only after sub",
        ),
        (
            "o1 sub\no1 call\no1 endsub\no1 call",
            "2:1: found \"o1 call\"; expected calls nested at most 32 deep",
        ),
    ] {
        assert_eq!(error(text), expected, "{text}");
    }
    // Each level calls the one before it twice.
    let mut text = "o0 sub\n(nothing is drawn here)\no0 endsub\n".to_owned();
    for i in 1..31 {
        let callee = i - 1;
        writeln!(
            text,
            "o{i} sub\no{callee} call\no{callee} call\no{i} endsub"
        )
        .unwrap();
    }
    text += "o30 call";
    assert!(error(&text).ends_with("expected at most 16 MB of called lines"));
}
