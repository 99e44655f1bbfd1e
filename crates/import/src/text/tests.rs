#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use std::sync::Arc;

use dobot_geometry::{Area, Point, Rect, bounds};
use proptest::prelude::*;
use usvg::fontdb;

use super::*;

fn with_fonts() -> Option<ReadOptions> {
    let mut fonts = fontdb::Database::new();
    fonts.load_system_fonts();
    // A machine without fonts cannot show this.
    (!fonts.is_empty()).then(|| ReadOptions {
        fonts: Arc::new(fonts),
        ..ReadOptions::default()
    })
}

fn read(text: &Text) -> (Artwork, Vec<String>) {
    let (artwork, warnings) = text.read(&ReadOptions::default()).unwrap();
    (artwork, warnings.iter().map(Warning::to_string).collect())
}

fn error(text: &Text) -> String {
    text.read(&ReadOptions::default()).unwrap_err().to_string()
}

fn ink(artwork: &Artwork) -> Rect {
    bounds(artwork.points())
}

#[test]
fn capitals_have_the_requested_height() {
    for font in StrokeFont::ALL {
        let text = Text {
            font: Font::Stroke(font),
            height_mm: 42.0,
            ..Text::new("H")
        };
        let (artwork, warnings) = read(&text);
        assert!(
            (artwork.height_mm - 42.0).abs() <= 2.01,
            "{font:?} {}",
            artwork.height_mm
        );
        assert_eq!(warnings.len(), 0);
    }
}

#[test]
fn the_page_is_the_ink() {
    let (artwork, _) = read(&Text::new("Grüße,\nÅse"));
    let ink = ink(&artwork);
    assert_eq!((ink.x0, ink.y0), (0.0, 0.0));
    assert_eq!((ink.x1, ink.y1), (artwork.width_mm, artwork.height_mm));
    assert_eq!(artwork.layers.len(), 1);
    assert_eq!(artwork.layers[0].name, "Grüße,");
}

#[test]
fn lines_have_the_requested_spacing_and_alignment() {
    let end = |align| {
        let (artwork, _) = read(&Text {
            align,
            ..Text::new("HHHH\nH")
        });
        let lower = artwork.points().filter(|p| p.y > 15.0);
        let lower = bounds(lower);
        assert!((lower.y0 - 17.5).abs() < 1e-9, "{lower:?}");
        [lower.x0, artwork.width_mm - lower.x1].map(|value| value.abs() < 1e-9)
    };
    assert_eq!(end(Align::Left), [true, false]);
    assert_eq!(end(Align::Center), [false, false]);
    assert_eq!(end(Align::Right), [false, true]);
}

#[test]
fn large_letters_are_round() {
    let (artwork, _) = read(&Text {
        height_mm: 100.0,
        ..Text::new("O")
    });
    let turn = |point: &[Point]| {
        let (a, b) = (point[1] - point[0], point[2] - point[1]);
        a.cross(b).atan2(a.dot(b)).abs()
    };
    let sharpest = artwork.layers[0].strokes[0].points.windows(3).map(turn);
    assert!(sharpest.fold(0.0, f64::max) < 0.15);
}

#[test]
fn characters_that_cannot_be_written_are_named() {
    let (_, warnings) = read(&Text::new("a漢b字漢"));
    assert_eq!(
        warnings,
        [
            "3 characters: not in the sans letters, left out: \"漢字\"; use an installed font with --font"
        ]
    );
}

#[test]
fn letters_in_parts_are_written_as_those_in_one() {
    for font in StrokeFont::ALL {
        let write = |text: &str| {
            read(&Text {
                font: Font::Stroke(font),
                ..Text::new(text)
            })
        };
        let (parts, warnings) = write("Cafe\u{301} O\u{308}l\nA\u{30a}r");
        let (whole, _) = write("Caf\u{e9} \u{d6}l\n\u{c5}r");
        assert_eq!(warnings, Vec::<String>::new());
        assert_eq!(parts.layers[0].strokes, whole.layers[0].strokes, "{font:?}");
    }
    let (_, warnings) = read(&Text::new("a\u{325}"));
    assert!(warnings[0].contains("\\u{325}"), "{warnings:?}");
}

#[test]
fn text_without_ink_is_refused() {
    for text in ["", " \n\t", "\r\n"] {
        assert_eq!(
            error(&Text::new(text)),
            "nothing to draw: the text is empty"
        );
    }
    assert_eq!(
        error(&Text::new("\u{7}")),
        "nothing to draw: 1 character: not in the sans letters, left out: \"\\u{7}\"; use an installed font with --font"
    );
}

#[test]
fn letters_of_size_zero_or_as_tall_as_houses_are_refused() {
    for height_mm in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e9] {
        let message = error(&Text {
            height_mm,
            ..Text::new("a")
        });
        assert_eq!(
            message,
            format!("the letter height is {height_mm} mm; allowed are 0.1 to 1000 mm")
        );
    }
    for line_spacing in [0.0, f64::NAN, 1e9] {
        let text = Text {
            line_spacing,
            ..Text::new("a")
        };
        assert!(error(&text).contains("allowed are 0.5 to 10"));
    }
}

#[test]
fn a_megabyte_of_text_is_refused() {
    assert_eq!(
        error(&Text::new("x".repeat(1_000_000))),
        "the text has 1000000 characters; allowed are 20000; write it in parts"
    );
}

#[test]
fn a_missing_font_is_named_with_similar_ones() {
    let text = Text {
        font: Font::of("Nonsense"),
        ..Text::new("a")
    };
    assert_eq!(
        error(&text),
        "there is no font \"Nonsense\"; no fonts are installed; \
         sans, bold, script, serif, italic, gothic and hand are built in"
    );
    let Some(options) = with_fonts() else { return };
    let message = text.read(&options).unwrap_err().to_string();
    assert!(
        message.starts_with("there is no font \"Nonsense\"; similar ones are"),
        "{message}"
    );
}

#[test]
fn handwriting_is_included_and_other_svg_fonts_are_read_from_their_files() {
    let text = |font: &str, text: &str| Text {
        font: Font::of(font),
        height_mm: 30.0,
        ..Text::new(text)
    };
    let (artwork, warnings) = read(&text("hand", "H"));
    assert!(
        (artwork.height_mm - 30.0).abs() < 2.0,
        "{}",
        artwork.height_mm
    );
    assert_eq!(warnings.len(), 0);
    let (artwork, warnings) = read(&text("Hand", "Grüße, Ørø! Quiz (12 €)"));
    assert_eq!(warnings, [""; 0]);
    assert!(artwork.layers[0].areas.is_empty(), "its letters are lines");
    let file = r#"<svg xmlns="http://www.w3.org/2000/svg"><font horiz-adv-x="9"><font-face font-family="Sticks"/><glyph unicode="H" d="M0 0V7M3 0V7"/></font></svg>"#;
    let (artwork, warnings) = read(&text(file, "HxH"));
    let layer = &artwork.layers[0];
    assert_eq!(layer.strokes.len(), 4);
    assert!(
        (artwork.height_mm - 30.0).abs() < 1e-3,
        "{}",
        artwork.height_mm
    );
    assert_eq!(
        warnings,
        [
            "1 character: not in the Sticks letters, left out: \"x\"; use an installed font with --font"
        ]
    );
    assert_eq!(
        error(&text("Sticks.SVG", "H")),
        "what.font is an SVG font that cannot be used: Sticks.SVG is its name; give the content of the file"
    );
    let message = error(&text("<svg/>", "H"));
    assert!(message.contains("no <font> element"), "{message}");
}

/// The ink of the lines of a text with gaps between them.
fn line_inks(artwork: &Artwork, line_mm: f64) -> Vec<Rect> {
    let mut inks = Vec::<Rect>::new();
    let mut points: Vec<Point> = artwork.points().collect();
    points.sort_by(|a, b| a.y.total_cmp(&b.y));
    for p in points {
        match inks.last_mut() {
            Some(ink) if p.y < ink.y0 + line_mm => *ink = ink.union_pt(p),
            _ => inks.push(Rect::from_points(p, p)),
        }
    }
    inks
}

#[test]
fn wrapped_lines_keep_their_height_within_the_width_and_justified_ones_fill_it() {
    let options = with_fonts().unwrap_or_default();
    let outline = options.fonts.faces().next();
    let outline = outline.map(|face| face.families[0].0.clone());
    let fonts = ["sans", "hand"]
        .map(str::to_owned)
        .into_iter()
        .chain(outline);
    for font in fonts {
        let written = |justify, text: &str| {
            let text = Text {
                font: Font::of(&font),
                height_mm: 5.0,
                line_spacing: 4.0,
                wrap: Some(Wrap {
                    width_mm: 60.0,
                    justify,
                }),
                ..Text::new(text)
            };
            let (artwork, _) = text.read(&options).unwrap();
            line_inks(&artwork, 15.0)
        };
        let words = "HE HHH HEE EHHHE HH HHEE HHHH HE EEEH HHH HHEE EH HEHHHH";
        let ragged = written(false, words);
        assert!(ragged.len() > 2, "{font}: {ragged:?}");
        for line in &ragged {
            assert!(line.width() <= 60.0, "{font}: {line:?}");
            assert!((line.height() - 5.0).abs() < 0.5, "{font}: {line:?}");
        }
        let full = written(true, words);
        assert_eq!(full.len(), ragged.len());
        let (last, others) = full.split_last().unwrap();
        for line in others {
            // The space beside the first and the last letter has no ink.
            assert!((56.0..60.01).contains(&line.width()), "{font}: {line:?}");
        }
        let widest = ragged.last().unwrap().width();
        // Outlines of fonts are `f32`.
        assert!((last.width() - widest).abs() < 1e-4, "{font}");
        // Line breaks are kept, and so are blank lines.
        let spaced = written(false, "H\n\nH");
        let apart_mm = spaced[1].y0 - spaced[0].y0;
        assert!((apart_mm - 40.0).abs() < 0.5, "{font}: {apart_mm}");
    }
}

#[test]
fn slanted_letters_stay_within_the_width_too() {
    for font in [
        "sans", "bold", "script", "serif", "italic", "gothic", "hand",
    ] {
        for justify in [false, true] {
            let wrap = Wrap {
                width_mm: 60.0,
                justify,
            };
            let text = Text {
                font: Font::of(font),
                wrap: Some(wrap),
                ..Text::new("fjord jelly fluff joy of jazz for 4 Wolf Ford Taft if")
            };
            let (artwork, _) = read(&text);
            assert!(artwork.width_mm <= 60.0, "{font}: {}", artwork.width_mm);
            assert!((artwork.width_mm > 57.0) == justify || !justify, "{font}");
            // A word that is too wide neither ends the loop nor the other lines early.
            let wide = Text {
                wrap: Some(Wrap {
                    width_mm: 20.0,
                    ..wrap
                }),
                ..text
            };
            assert!(read(&wide).0.width_mm > 20.0);
        }
    }
}

#[test]
fn a_width_that_holds_no_line_is_refused() {
    for width_mm in [0.0, -1.0, f64::NAN, 1e9] {
        let message = error(&Text {
            wrap: Some(Wrap {
                width_mm,
                justify: false,
            }),
            ..Text::new("a")
        });
        assert_eq!(
            message,
            format!("lines are wrapped at {width_mm} mm; allowed are 1 to 10000 mm")
        );
    }
}

#[test]
fn outlines_are_areas_of_the_requested_height_on_their_lines() {
    let Some(options) = with_fonts() else { return };
    let family = options.fonts.faces().next().unwrap().families[0].0.clone();
    let text = Text {
        font: Font::Outline(family.to_uppercase()),
        height_mm: 30.0,
        align: Align::Center,
        ..Text::new("HH\n\nH<&\">\u{7}")
    };
    let (artwork, _) = text.read(&options).unwrap();
    let ink = |area: &Area| bounds(area.rings.iter().flatten().copied());
    let lines: Vec<Rect> = artwork.layers[0].areas.iter().map(ink).collect();
    assert_eq!(lines.len(), 2);
    assert!((lines[0].height() - 30.0).abs() < 0.1, "{lines:?}");
    let apart_mm = lines[1].center().y - lines[0].center().y;
    assert!((apart_mm - 2.0 * 1.75 * 30.0).abs() < 10.0, "{lines:?}");
    assert_eq!(
        artwork.layers[0].strokes.len(),
        artwork.layers[0]
            .areas
            .iter()
            .map(|area| area.rings.len())
            .sum::<usize>()
    );
}

#[test]
fn styles_may_follow_the_name_of_a_font() {
    let Some(options) = with_fonts() else { return };
    let family = options.fonts.faces().next().unwrap().families[0].0.clone();
    let text = Text {
        font: Font::of(&format!("{family} Bold Italic")),
        ..Text::new("H")
    };
    assert!(text.read(&options).is_ok());
}

proptest! {
    #[test]
    fn any_text_is_written_or_refused_with_one_line(
        text in ".{0,40}",
        height_mm in 0.1..1000.0_f64,
        font in proptest::sample::select(StrokeFont::ALL.to_vec()),
    ) {
        let text = Text { font: Font::Stroke(font), height_mm, ..Text::new(text) };
        match text.read(&ReadOptions::default()) {
            Ok((artwork, _)) => {
                let ink = ink(&artwork);
                prop_assert!(ink.x0 == 0.0 && ink.y0 == 0.0);
                prop_assert!(ink.x1.is_finite() && ink.y1.is_finite());
            }
            Err(error) => prop_assert!(!error.to_string().contains('\n')),
        }
    }
}
