//! Tests of cancelled readers.

use std::fmt::Write as _;

use dobot_geometry::CancelToken;
use jpeg_encoder::{ColorType, Encoder};

use crate::{ReadOptions, Shading, ShadingStyle, Source, Text};

/// Checks that a reader stops at each of these checks of its token: its steps are small.
fn check(name: &str, source: &Source, options: &ReadOptions) {
    for count in [0, 1, 10, CHECKS] {
        let options = ReadOptions {
            cancel: CancelToken::after_checks(count),
            ..options.clone()
        };
        let read = source.read(&options);
        let is_cancelled = matches!(&read, Err(error) if error.is_cancelled());
        assert!(is_cancelled, "{name} after {count} checks: {read:?}");
    }
}

/// Repeats a part of a file, once for each number.
fn repeated(part: impl Fn(u32) -> String) -> String {
    (0..2 * PARTS).map(part).collect()
}

#[test]
fn each_reader_of_lines_can_be_cancelled_at_any_line() {
    let svg = repeated(|i| format!(r#"<path d="M{} 0V9" stroke="black"/>"#, i % 90));
    let page = r#"<svg xmlns="http://www.w3.org/2000/svg" width="99mm" height="99mm" viewBox="0 0 99 99">"#;
    let dxf = repeated(|i| format!("0\nLINE\n8\n0\n10\n{i}\n20\n0\n11\n{i}\n21\n9\n"));
    let shape = repeated(|i| {
        format!(
            r#"<Shape Type="Rect" CutIndex="0" W="5" H="5"><XForm>1 0 0 1 {i} 0</XForm></Shape>"#
        )
    });
    let strokes: Vec<String> = (0..2 * PARTS)
        .map(|i| format!("[[{i},0],[{i},9]]"))
        .collect();
    let files = [
        ("a.svg", format!("{page}{svg}</svg>")),
        (
            "a.dxf",
            format!("0\nSECTION\n2\nENTITIES\n{dxf}0\nENDSEC\n0\nEOF\n"),
        ),
        (
            "a.lbrn2",
            format!("<LightBurnProject>{shape}</LightBurnProject>"),
        ),
        ("a.csv", repeated(|i| format!("{i},0\n{i},9\n\n"))),
        ("a.json", format!("[{}]", strokes.join(","))),
        (
            "a.plt",
            format!("IN;SP1;{}", repeated(|i| format!("PU{i},0;PD{i},9;"))),
        ),
        (
            "a.gcode",
            repeated(|i| format!("M5\nG0 X{i} Y0\nM3\nG1 Y9\n")),
        ),
    ];
    for (name, text) in files {
        let source = Source::of_file(name, text.into_bytes()).unwrap();
        check(name, &source, &ReadOptions::default());
    }
}

#[test]
fn each_reader_of_moves_without_ink_can_be_cancelled() {
    for (name, text) in [
        (
            "a.gcode",
            repeated(|_| "(nothing)\n".to_owned() + "G0 X1\n"),
        ),
        ("a.plt", repeated(|_| "PU0,0;".to_owned())),
        ("a.csv", "\n".repeat(2 * CHECKS)),
        ("a.dxf", "999\nnothing\n".repeat(2 * CHECKS) + "0\nEOF\n"),
    ] {
        let source = Source::of_file(name, text.into_bytes()).unwrap();
        check(name, &source, &ReadOptions::default());
    }
}

#[test]
fn each_step_of_reading_an_svg_file_can_be_cancelled() {
    let svg = |before: &str, content: &str| {
        format!(
            r#"{before}<svg xmlns="http://www.w3.org/2000/svg" width="99mm" height="99mm">{content}<path d="M0 0V9" stroke="red"/></svg>"#
        )
    };
    let rules = repeated(|i| format!(".a{i}{{fill:red}}"));
    let inner = repeated(|i| format!("<path d='M{i} 0V9' stroke='red'/>"));
    let inner = svg("", &inner).replace('"', "'").replace('<', "%3C");
    let inner = inner.replace('>', "%3E");
    let defaults = r#"<!DOCTYPE svg [<!ATTLIST a b CDATA "c">]>"#;
    for (name, text) in [
        ("rules", svg("", &format!("<style>{rules}</style>"))),
        ("elements", svg("", &repeated(|_| "<g/>".to_owned()))),
        ("defaults", svg(defaults, &repeated(|_| "<g/>".to_owned()))),
        (
            "image",
            svg(
                "",
                &format!(r#"<image width="9" height="9" href="data:image/svg+xml,{inner}"/>"#),
            ),
        ),
        (
            "tiles",
            svg(
                "",
                r#"<pattern id="p" width="1" height="1" patternUnits="userSpaceOnUse"><g id="a"><path d="M9 9h1" stroke="red"/></g></pattern><rect width="30" height="30" fill="url(#p)"/>"#,
            ),
        ),
        ("white shapes", svg("", &repeated(white_on_dark))),
    ] {
        let source = Source::of_file("a.svg", text.into_bytes()).unwrap();
        check(name, &source, &ReadOptions::default());
    }
}

/// A white shape that hides a part of a black one.
fn white_on_dark(at: u32) -> String {
    format!(
        r#"<rect width="9" height="9" y="{at}"/><rect width="5" height="20" y="{at}" fill="white"/>"#
    )
}

/// A cancelled search for what is under white shapes is not an exhausted one.
#[test]
fn reading_an_svg_file_is_cancelled_at_any_check() {
    let mut shapes = String::new();
    for i in 0..9 {
        shapes += &white_on_dark(i);
    }
    let text = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="99mm" height="99mm"><style>rect {{ stroke: none }}</style>{shapes}</svg>"#
    );
    let source = Source::from(text.as_str());
    let read = |cancel: &CancelToken| {
        let cancel = cancel.clone();
        source.read(&ReadOptions {
            cancel,
            ..ReadOptions::default()
        })
    };
    let whole = read(&CancelToken::default()).unwrap();
    for count in 0..1_000_000 {
        match read(&CancelToken::after_checks(count)) {
            Err(error) => assert!(error.is_cancelled(), "{count}: {error}"),
            Ok(drawn) => {
                assert!(count > CHECKS, "{count}");
                assert_eq!(drawn, whole, "{count}");
                return;
            }
        }
    }
    panic!("never read");
}

#[test]
fn each_shading_of_a_picture_can_be_cancelled() {
    let pixels: Vec<u8> = (0..200_u8)
        .flat_map(|y| (0..200_u8).map(move |x| x ^ y))
        .collect();
    let mut file = Vec::new();
    let encoder = Encoder::new(&mut file, 90);
    encoder.encode(&pixels, 200, 200, ColorType::Luma).unwrap();
    let source = Source::of_file("a.jpg", file).unwrap();
    for style in [
        ShadingStyle::Outline,
        ShadingStyle::Lines,
        ShadingStyle::Spiral,
        ShadingStyle::Flow,
        ShadingStyle::Stipple,
        ShadingStyle::Tsp,
        ShadingStyle::Hatch,
    ] {
        let options = ReadOptions {
            shading: Shading::new(style),
            ..ReadOptions::default()
        };
        check(&format!("{style:?}"), &source, &options);
    }
}

#[test]
fn writing_a_text_can_be_cancelled() {
    let mut text = String::new();
    for _ in 0..PARTS {
        writeln!(text, "letters").unwrap();
    }
    check(
        "text",
        &Source::Text(Text::new(text)),
        &ReadOptions::default(),
    );
}

/// A reader is cancelled after this many checks, too.
const CHECKS: usize = 150;
const PARTS: u32 = 100;
