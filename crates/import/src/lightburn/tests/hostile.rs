use dobot_geometry::Point;

use super::*;

fn lists(vertices: &str, joints: &str) -> String {
    let lists = format!("<VertList>{vertices}</VertList><PrimList>{joints}</PrimList>");
    project(&shape("Type=\"Path\"", HERE, &lists))
}

#[track_caller]
fn refused(text: &str, parts: &[&str]) {
    let error = error(text);
    assert!(!error.contains('\n'), "{error}");
    for part in parts {
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn wrong_lists_are_refused_with_their_place() {
    let points = "points such as V1 2";
    for vertices in [
        "V0", "V0 nan", "V0 inf", "V0 1e308", "V1e10 0", "V0 0c0x", "V0 0c2x1", "0 0", "V0 0;",
    ] {
        refused(&lists(vertices, "L0 1"), &["3:", points]);
    }
    let joints = "lines and curves such as L0 1B1 2";
    for list in [
        "L",
        "L0",
        "L0 -1",
        "Q0 1",
        "L0 1B",
        "LineSplined",
        "L99999999999999999999999 0",
    ] {
        refused(&lists("V0 0V1 1", list), &["3:", joints]);
    }
    refused(
        &lists("V0 0V1 1", "L0 2"),
        &["found point 2; expected one of the 2 points of the path, from 0 to 1"],
    );
    refused(
        &lists("", "L0 1"),
        &["found point 0; expected a path with points"],
    );
}

#[test]
fn wrong_shapes_are_refused_with_their_place() {
    for (attributes, frame, parts) in [
        (
            "Type=\"Rect\" W=\"wide\" H=\"1\"",
            HERE,
            ["\"wide\"", "a number of at most 1e9"],
        ),
        (
            "Type=\"Rect\" W=\"-5\" H=\"1\"",
            HERE,
            ["\"-5\"", "a length of 0 mm or more"],
        ),
        (
            "Type=\"Rect\" W=\"nan\" H=\"1\"",
            HERE,
            ["\"nan\"", "a number of at most 1e9"],
        ),
        (
            "Type=\"Rect\" W=\"9\" H=\"1\"",
            "1 0 0 1 0",
            ["\"1 0 0 1 0\"", "six numbers"],
        ),
        (
            "Type=\"Rect\" W=\"9\" H=\"1\"",
            "1 0 0 1 0 0 0",
            ["\"1 0 0 1 0 0 0\"", "six numbers"],
        ),
        (
            "Type=\"Rect\" W=\"9\" H=\"1\"",
            "1 0 0 inf 0 0",
            ["inf", "six numbers"],
        ),
        (
            "Type=\"Rect\" W=\"9\" H=\"1\"",
            "1 0 0 1 1e8 0",
            ["leads to", "at most 1000000 mm"],
        ),
        (
            "Type=\"Rect\" W=\"9\" H=\"9\" Cr=\"1\"",
            "1e9 0 0 1e9 0 0",
            ["leads to", "at most 1000000 mm"],
        ),
        (
            "Type=\"Ellipse\" Rx=\"1e7\" Ry=\"1e7\"",
            HERE,
            ["leads to", "at most 1000000 mm"],
        ),
        (
            "Type=\"Ellipse\" Rx=\"1e9\" Ry=\"1e9\"",
            "1e9 0 0 1e9 0 0",
            ["100000", "line segments"],
        ),
        (
            "Type=\"Polygon\" Rx=\"1\" Ry=\"1\"",
            HERE,
            ["a polygon without N", "from 3 to 10000"],
        ),
        (
            "Type=\"Polygon\" N=\"4294967295\" Rx=\"1\"",
            HERE,
            ["\"4294967295\"", "from 3 to 10000"],
        ),
        (
            "Type=\"Path\" VertID=\"5\" PrimID=\"1\"",
            HERE,
            ["\"5\"", "the number of a <VertList> of the file"],
        ),
        (
            "Type=\"Rect\" CutIndex=\"-1\" W=\"9\"",
            HERE,
            ["\"-1\"", "a whole number of 0 or more"],
        ),
    ] {
        refused(&project(&shape(attributes, frame, "")), &parts);
    }
    refused(
        &project("<CutSetting type=\"Cut\"/>"),
        &["3:1", "<index Value=\"0\"/>"],
    );
    refused(
        &project("<CutSetting><index Value=\"x\"/></CutSetting>"),
        &["\"x\"", "a whole number"],
    );
}

#[test]
fn an_invalid_project_is_refused_with_its_place() {
    refused("", &["not well-formed XML"]);
    refused("<LightBurnProject>", &["not well-formed XML"]);
    refused(
        "<LightBurnProject/>",
        &["nothing to draw: no shapes that are output"],
    );
    refused("<svg/>", &["1:1: found <svg>; expected <LightBurnProject"]);
    let bomb = "<!DOCTYPE l [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">]><LightBurnProject>&b;</LightBurnProject>";
    refused(
        bomb,
        &[
            "1:1: found \"<!DOCTYPE l [<!ENTIT..\"",
            "no drawing needs a DOCTYPE",
        ],
    );
}

#[test]
fn groups_that_are_nested_too_deep_are_refused() {
    let nested = |depth: usize| {
        let begin = "<Shape Type=\"Group\"><Children>".repeat(depth);
        let end = "</Children></Shape>".repeat(depth);
        let line = "<Shape Type=\"Rect\" W=\"9\" H=\"9\"/>";
        project(&format!("{begin}{line}{end}"))
    };
    assert_eq!(strokes(&read_text(&nested(100)).0).len(), 1);
    for depth in [101, 100_000] {
        refused(
            &nested(depth),
            &["3:", "groups nested more than 100 deep", "ungroup them"],
        );
    }
}

#[test]
fn texts_in_outlines_of_texts_end() {
    let begin = "<BackupPath Type=\"Text\">".repeat(100_000);
    let end = "</BackupPath>".repeat(100_000);
    let text = project(&shape("Type=\"Text\"", HERE, &format!("{begin}{end}")));
    refused(&text, &["nothing to draw", "plain text"]);
}

#[test]
fn a_long_list_that_many_paths_share_is_read_once_and_many_points_are_refused() {
    // Twenty thousand points, and as many paths that draw one line of them.
    let points = "V0 0V1 1".repeat(10_000);
    let first = shape(
        "Type=\"Path\" VertID=\"0\" PrimID=\"0\"",
        HERE,
        &format!("<VertList>{points}</VertList><PrimList>L0 1</PrimList>"),
    );
    let others = "<Shape Type=\"Path\" VertID=\"0\" PrimID=\"0\"/>".repeat(19_999);
    let (artwork, _) = read_text(&project(&(first + &others)));
    assert_eq!(strokes(&artwork).len(), 20_000);
    refused(
        &lists(&"V0 0".repeat(100_001), "L0 1"),
        &["more than 100000 line segments"],
    );
    let closed = shape(
        "Type=\"Path\" VertID=\"0\" PrimID=\"0\"",
        HERE,
        &format!("<VertList>{points}</VertList><PrimList>LineClosed</PrimList>"),
    );
    let text = project(&(closed + &others));
    refused(&text, &["more than 100000 line segments"]);
}

#[test]
fn too_many_elements_are_refused() {
    let text = project(&"<V/>".repeat(2_000_001));
    refused(
        &text,
        &[" elements, texts and attributes; expected at most that"],
    );
}

#[test]
fn a_huge_picture_is_skipped_quickly() {
    let data = "A".repeat(20_000_000);
    let picture = shape(&format!("Type=\"Bitmap\" Data=\"{data}\""), HERE, "");
    let (artwork, _) = read_text(&project(
        &(picture + "<Shape Type=\"Rect\" W=\"9\" H=\"9\"/>"),
    ));
    assert_eq!(strokes(&artwork).len(), 1);
}

/// Something of all that is read.
const PROJECT: &str = r#"<LightBurnProject MirrorX="True"><CutSetting type="Scan"><index Value="0"/><scanOpt
Value="byGroup"/></CutSetting><CutSetting type="Cut"><index Value="1"/><name Value="a"/><hide Value="0"/></CutSetting>
<Shape Type="Rect" CutIndex="1" W="9" H="5" Cr="2"><XForm>1 0 0 1 5 5</XForm></Shape><Shape Type="Group"><XForm>2 0 0 2 1
0</XForm><Children><Shape Type="Ellipse" CutIndex="0" Rx="9" Ry="5"/><Shape Type="Polygon" N="5" Rx="3" Ry="4"/></Children>
</Shape><Shape Type="Path" VertID="0" PrimID="0"><VertList>V0 0c0x1c1x1V9 0Sc0x12c0y3c1x1V9.5 1e1c0x1c1x6c1y12</VertList>
<PrimList>L0 1B1 2L2 0</PrimList></Shape><Shape Type="Path" VertID="0" PrimID="0"/><Shape Type="Path"><V vx="1" vy="2"/>
<V vx="3" vy="4"/><P T="L" p0="0" p1="1"/></Shape><Shape Type="Text"><BackupPath Type="Path"><VertList>V0 0V1 1</VertList>
<PrimList>LineOpen</PrimList></BackupPath></Shape></LightBurnProject>"#;

proptest! {
    #[test]
    fn a_truncated_or_damaged_project_gives_a_drawing_or_an_error_of_one_line(
        at in 0..PROJECT.len(),
        length in 0..40_usize,
        other in prop::sample::select(vec![
            "", "<", ">", "\"", "-", "1e9", "nan", "9", "V", "L9 9", "B0 1", "Scan", "Group", "Text", "</Shape>", "<Shape>",
        ]),
    ) {
        let end = (at + length).min(PROJECT.len());
        let damaged = format!("{}{other}{}", &PROJECT[..at], &PROJECT[end..]);
        for text in [&PROJECT[..at], damaged.as_str()] {
            match super::super::read(text, &ReadOptions::default()) {
                Ok((artwork, _)) => prop_assert!(artwork.points().all(Point::is_finite)),
                Err(error) => prop_assert!(!error.to_string().contains('\n'), "{error}"),
            }
        }
    }
}
