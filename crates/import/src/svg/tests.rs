#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod browsers;
mod css;
mod hiding;
mod layers;

use std::fmt::Write as _;

use dobot_geometry::{Point, Rect, Stroke, bounds_of_strokes};
use proptest::prelude::*;

use super::*;

#[derive(Debug)]
struct Drawing {
    width_mm: f64,
    strokes: Vec<Stroke>,
}

impl Drawing {
    fn from_svg(text: &str, options: &ReadOptions) -> Result<(Self, Vec<Warning>), SourceError> {
        let (artwork, warnings) = super::draw(text, options, &super::Substitutes::default())?;
        let drawing = Self {
            width_mm: artwork.width_mm,
            strokes: artwork
                .layers
                .into_iter()
                .flat_map(|layer| layer.strokes)
                .collect(),
        };
        Ok((drawing, warnings))
    }
}

fn options() -> ReadOptions {
    ReadOptions::default()
}

/// With the fonts of this machine; `None` where it has none.
fn with_fonts() -> Option<ReadOptions> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_system_fonts();
    let has_any = !fonts.is_empty();
    has_any.then(|| ReadOptions {
        fonts: Arc::new(fonts),
        ..options()
    })
}

fn page(content: &str) -> String {
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50">{content}</svg>"#
    )
}

fn draw(content: &str) -> (Vec<Stroke>, Vec<Warning>) {
    let (drawing, warnings) = Drawing::from_svg(&page(content), &options()).unwrap();
    (drawing.strokes, warnings)
}

fn error(text: &str) -> String {
    Drawing::from_svg(text, &options()).unwrap_err().to_string()
}

fn close(a: Point, x: f64, y: f64) -> bool {
    a.distance(Point::new(x, y)) < 1e-4
}

#[test]
fn millimetres_are_true_in_any_unit() {
    for (size, user) in [
        ("96", "96"),
        ("1in", "96"),
        ("25.4mm", "25.4"),
        ("6pc", "6"),
        ("72pt", "7"),
    ] {
        let text = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{size}" viewBox="0 0 {user} {user}">
            <path d="M0 0H{user}V{user}" stroke="red" fill="none"/></svg>"#
        );
        let (drawing, _) = Drawing::from_svg(&text, &options()).unwrap();
        let end = drawing.strokes[0].last().unwrap();
        assert!(close(end, 25.4, 25.4), "{size}: {end:?}");
        assert!((drawing.width_mm - 25.4).abs() < 1e-4);
    }
}

#[test]
fn transforms_and_copies_compose() {
    let (strokes, _) = draw(
        r##"<defs><path id="a" d="M0 0L5 0" stroke="red"/></defs>
        <g transform="translate(10 20) rotate(90)"><use href="#a" x="2" transform="scale(2)"/></g>"##,
    );
    assert!(close(strokes[0].points[0], 10.0, 24.0), "{:?}", strokes[0]);
    assert!(close(strokes[0].points[1], 10.0, 34.0), "{:?}", strokes[0]);
}

#[test]
fn invisible_shapes_are_not_drawn() {
    let (strokes, warnings) = draw(
        r#"<rect x="1" y="1" width="5" height="5"/>
        <rect x="1" y="1" width="5" height="5" fill="none"/>
        <rect x="1" y="1" width="5" height="5" display="none"/>
        <rect x="1" y="1" width="5" height="5" visibility="hidden"/>
        <rect x="1" y="1" width="5" height="5" opacity="0"/>
        <g opacity="0"><rect x="1" y="1" width="5" height="5"/></g>
        <rect x="1" y="1" width="5" height="5" fill-opacity="0"/>
        <rect x="1" y="70" width="5" height="5"/>"#,
    );
    assert_eq!((strokes.len(), warnings.len()), (1, 1));
    assert!(strokes[0].closed);
}

#[test]
fn strokes_are_cut_at_the_edge_of_the_page_and_this_is_reported() {
    let beyond = r#"<path d="M-10 25H200" stroke="red"/><path d="M-9 60H9" stroke="red"/>"#;
    let (strokes, warnings) = draw(beyond);
    assert_eq!(strokes.len(), 1);
    // Half a percent of the page lies beyond its edge.
    assert!(close(strokes[0].points[0], -0.25, 25.0));
    assert!(close(strokes[0].last().unwrap(), 100.25, 25.0));
    assert_eq!(
        warnings[0].to_string(),
        "2 cut lines: 127.5 mm beyond the edge of the page left out; draw them with what.no_crop"
    );
    let whole = ReadOptions {
        crops: false,
        ..options()
    };
    let (drawing, warnings) = Drawing::from_svg(&page(beyond), &whole).unwrap();
    assert!(close(drawing.strokes[0].points[0], -10.0, 25.0));
    assert_eq!((drawing.strokes.len(), warnings), (2, vec![]));
}

#[test]
fn a_line_that_rounding_put_beyond_the_page_is_drawn_whole() {
    let (strokes, warnings) = draw(
        r#"<path d="M1 45H99V50.1H1Z" stroke="red" fill="none"/><path d="M0 -.1H100" stroke="red"/>"#,
    );
    assert_eq!((strokes.len(), warnings), (2, vec![]));
    assert!(strokes[0].closed && strokes[0].points.len() == 5);
}

#[test]
fn a_clipped_filled_shape_has_the_edge_of_its_clip_path() {
    let (strokes, warnings) = draw(
        r#"<clipPath id="c"><circle cx="50" cy="25" r="5"/></clipPath>
        <rect width="100" height="50" clip-path="url(#c)"/>
        <rect x="40" y="25" width="20" height="10" clip-path="url(#c)" stroke="red"/>"#,
    );
    assert_eq!(warnings, []);
    // The circle, its lower half, and of the line what lies in it.
    assert!(strokes[0].closed && !strokes[1].closed);
    assert!((strokes[1].length_mm() - 15.7).abs() < 0.1);
    let length_mm = strokes[0].length_mm();
    assert!((length_mm - 31.4).abs() < 0.1, "{length_mm} mm");
    assert!((strokes[2].length_mm() - 10.0).abs() < 1e-3);
    let (strokes, _) = draw(
        r#"<clipPath id="c"><rect width="9" height="9"/></clipPath>
        <path d="M1 1H5V5H1Z" clip-path="url(#c)"/>"#,
    );
    assert_eq!((strokes.len(), strokes[0].points.len()), (1, 5));
}

#[test]
fn flowed_text_of_old_inkscape_files_is_reported() {
    let flowed = r#"<flowRoot><flowRegion><rect width="9" height="9"/></flowRegion><flowPara>a</flowPara></flowRoot>"#;
    let (strokes, warnings) = draw(&format!(r#"<path d="M1 1H9" stroke="red"/>{flowed}"#));
    assert_eq!((strokes.len(), warnings.len()), (1, 1));
    assert!(
        warnings[0]
            .to_string()
            .starts_with("1 flowed text: left out; convert it in Inkscape")
    );
    assert!(
        error(&page(flowed)).contains("1 flowed text"),
        "{}",
        error(&page(flowed))
    );
}

#[test]
fn a_filled_shape_that_is_open_is_drawn_closed() {
    let (strokes, _) = draw(r#"<path d="M5 5H25V25H5"/><path d="M5 5H25V25H5" stroke="red"/>"#);
    let lengths: Vec<f64> = strokes
        .iter()
        .map(|stroke| stroke.length_mm().round())
        .collect();
    assert_eq!(lengths, [80.0, 60.0]);
    assert!(strokes[0].closed);
}

#[test]
fn clip_paths_cut_with_their_own_clips_and_transforms() {
    let (strokes, _) = draw(
        r#"<clipPath id="outer"><rect x="0" y="0" width="30" height="50"/></clipPath>
        <clipPath id="c" clip-path="url(#outer)" transform="translate(10 0)">
            <path clip-rule="evenodd" d="M0 0H60V50H0Z M10 0H15V50H10Z"/></clipPath>
        <g clip-path="url(#c)"><path d="M0 25H100" stroke="red"/></g>"#,
    );
    let spans: Vec<[f64; 2]> = strokes
        .iter()
        .map(|s| [s.points[0].x, s.last().unwrap().x].map(|x| (x * 1e3).round() / 1e3))
        .collect();
    // The outer clip is in the user space of the clipped object, not in that of the inner clip.
    assert_eq!(spans, [[10.0, 20.0], [25.0, 30.0]]);
}

#[test]
fn dashes_scale_with_their_path() {
    let (strokes, _) =
        draw(r#"<path transform="scale(2)" d="M0 5H20" stroke="red" stroke-dasharray="5 3"/>"#);
    let lengths: Vec<f64> = strokes.iter().map(|s| s.length_mm().round()).collect();
    assert_eq!(lengths, [10.0, 10.0, 8.0]);
}

#[test]
fn points_are_drawn_up_to_one_without_y_which_is_reported_with_its_place() {
    let reported = |content: &str| -> Vec<String> {
        let (_, warnings) = super::read(&page(content), &options()).unwrap();
        warnings.iter().map(ToString::to_string).collect()
    };
    let odd = r#"<polygon points="10,10 20,10 20,20 30" fill="none" stroke="red"/>"#;
    let even = odd.replace(" 30", "");
    let (strokes, _) = draw(odd);
    assert_eq!(strokes, draw(&even).0);
    assert_eq!((strokes.len(), strokes[0].points.len()), (1, 4));
    assert_eq!(reported(&even), <[&str; 0]>::default());
    let column = page(odd).find(" 30\"").unwrap() + 4;
    let lone = |column: usize, what: &str| {
        format!(
            "1:{column}: {what}: x without y in the points of a polygon or polyline left out; the points before it are drawn"
        )
    };
    assert_eq!(reported(odd), [lone(column, "1 lone coordinate")]);
    let two = format!("{odd}\n{}", odd.replace("polygon", "polyline"));
    assert_eq!(reported(&two), [lone(column, "2 lone coordinates")]);
    // Characters replaced before it do not change its place.
    let sized = format!(r#"<rect x=" 5 " y="1" width="5" height="5" stroke="red"/>{odd}"#);
    let column = page(&sized).find(" 30\"").unwrap() + 4;
    assert_eq!(reported(&sized), [lone(column, "1 lone coordinate")]);
    // A single number is no point.
    let alone = r#"<path d="M5 5h5" stroke="red"/><polyline points="7" stroke="red"/>"#;
    let column = page(alone).find("7\"").unwrap() + 2;
    assert_eq!(reported(alone), [lone(column, "1 lone coordinate")]);
    assert_eq!(draw(alone).0.len(), 1);
}

#[test]
fn a_line_without_length_is_a_dot_if_its_caps_are_drawn() {
    let line =
        |cap| format!(r#"<path d="M5 5h0M7 7h2M3 3zM1 1" stroke="red" stroke-linecap="{cap}"/>"#);
    let count = |cap| draw(&line(cap)).0.len();
    // A place alone is none, but closed it is.
    assert_eq!([count("butt"), count("round"), count("square")], [1, 3, 3]);
}

#[test]
fn a_circle_is_round_within_the_tolerance() {
    let (strokes, _) = draw(r#"<circle cx="50" cy="25" r="20"/>"#);
    for (a, b) in strokes[0].segments() {
        for p in [a, a.lerp(b, 0.5)] {
            let radius = p.distance(Point::new(50.0, 25.0));
            // SVG readers make a quarter circle one cubic, which is 0.03 % off.
            assert!((radius - 20.0).abs() < 0.005 + 20.0 * 0.0003, "{radius}");
        }
    }
}

#[test]
fn curves_keep_the_tolerance_when_their_group_is_enlarged() {
    let curve = "M0 0C0 1 1 1 1 0";
    let small = draw(&format!(r#"<path d="{curve}" stroke="red"/>"#)).0;
    let large = draw(&format!(
        r#"<g transform="scale(40)"><path d="{curve}" stroke="red"/></g>"#
    ))
    .0;
    assert!(large[0].points.len() > 5 * small[0].points.len());
}

#[test]
fn effects_that_a_pen_cannot_show_are_counted() {
    let (_, warnings) = draw(
        r#"<linearGradient id="g"><stop stop-color="red"/><stop offset="1"/></linearGradient>
        <mask id="m"><rect width="9" height="9" fill="gray"/></mask>
        <filter id="f"><feGaussianBlur stdDeviation="2"/></filter>
        <rect width="9" height="9" fill="url(#g)"/>
        <rect width="9" height="9" mask="url(#m)"/>
        <rect width="9" height="9" filter="url(#f)"/>
        <image href="cat.png" width="5" height="5"/>
        <image href="data:image/png;base64,AAAA" width="5" height="5"/>"#,
    );
    let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        texts,
        [
            "1 mask: ignored; what it hides is drawn",
            "1 filter: ignored; the shape is drawn unchanged",
            "1 gradient: drawn as one colour, the first of its stops that is not white",
            "2 images: left out; trace it to paths",
        ]
    );
}

#[test]
fn text_without_any_font_is_skipped_with_a_warning() {
    let (strokes, warnings) =
        draw(r#"<text x="5" y="20">Hi</text><path d="M0 0L9 9" stroke="red"/>"#);
    assert_eq!(strokes.len(), 1);
    assert_eq!(warnings[0].what, "text");
}

#[test]
fn nothing_but_text_and_no_font_is_an_error_with_a_remedy() {
    assert_eq!(
        error(&page(r#"<text x="5" y="20">Hi</text>"#)),
        "nothing to draw: the file holds only text and no font was found; \
         install a font or convert the text to paths"
    );
}

#[test]
fn nothing_visible_is_an_error() {
    assert_eq!(
        error(&page("")),
        "nothing to draw: no visible shape or text on the page"
    );
    assert_eq!(
        error(&page(r#"<image href="cat.png" width="5" height="5"/>"#)),
        "nothing to draw: 1 image: left out; trace it to paths"
    );
}

#[test]
fn an_invalid_svg_file_is_refused_with_its_place() {
    assert_eq!(
        error(" \n"),
        "the file is empty; an SVG file begins with <svg"
    );
    assert_eq!(
        error("<html/>"),
        "1:1: the outermost element is <html>; it must be <svg>"
    );
    assert!(error("<svg>\n  <g></svg>").starts_with("2:6: not well-formed XML: expected 'g' tag"));
    assert!(error("hello").starts_with("1:1: not well-formed XML"));
    assert_eq!(
        error("<svg><g/\n</svg>"),
        r"1:9: not well-formed XML: expected '>' not '\n'"
    );
}

#[test]
fn a_damaged_path_is_drawn_up_to_the_error_which_is_reported_with_its_place() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>\n<path d='M 0 0 H 5 L NaN 5 H 9' stroke='red'/></svg>";
    let (drawing, warnings) = Drawing::from_svg(text, &options()).unwrap();
    assert_eq!(drawing.strokes.len(), 1);
    assert!((drawing.strokes[0].length_mm() - 5.0 * 25.4 / 96.0).abs() < 1e-4);
    assert_eq!(
        warnings[0].to_string(),
        "2:22: invalid path: d of <path> holds \"NaN 5 H 9\"; expected path data: commands MLHVCSQTAZ and finite numbers: drawn up to there"
    );
    let strict = ReadOptions {
        strict: true,
        ..options()
    };
    let refused = crate::Source::from(text).read(&strict).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "2:22: invalid path: d of <path> holds \"NaN 5 H 9\"; expected path data: commands MLHVCSQTAZ and finite numbers"
    );
}

#[test]
fn an_invalid_value_spoils_nothing_else_and_is_reported_with_its_place() {
    let line = r#"<path d="M1 1H9" stroke="red"/>"#;
    for (content, found, strokes) in [
        (
            r#"<path d="M0 0H3L1e400 5" stroke="red"/>"#,
            r#"holds "1e400 5";"#,
            1,
        ),
        (
            r#"<path d="M0 0H3L1e30 5" stroke="red"/>"#,
            r#"holds "M0 0H3L1e30 5";"#,
            1,
        ),
        (
            r#"<path d="M0 0H3L5" stroke="red"/>"#,
            r#"ends after "M0 0H3L5";"#,
            1,
        ),
        (
            r#"<path d="M0 0H3A5 5 0 2 0 9 9H20" stroke="red"/>"#,
            "invalid path",
            1,
        ),
        (r#"<path d="Z M0 0" stroke="red"/>"#, "invalid path", 0),
        (
            r#"<rect width="" height="3" stroke="red"/>"#,
            r#"width of <rect> holds "";"#,
            0,
        ),
        (
            r#"<polyline points="1,2 3,4 5,x" stroke="red" fill="none"/>"#,
            r#"holds "x";"#,
            1,
        ),
        (r#"<rect width="NaN" height="3"/>"#, r#"holds "NaN";"#, 0),
        (
            r#"<rect x="inf" width="3" height="3"/>"#,
            r#"holds "inf";"#,
            1,
        ),
        (
            r#"<g transform="rotate(foo)"><path d="M0 0H3" stroke="red"/></g>"#,
            r#"holds "rotate(foo)";"#,
            1,
        ),
        (
            r#"<g transform="matrix(1 2)"><path d="M0 0H3" stroke="red"/></g>"#,
            "invalid transform",
            1,
        ),
        (
            r#"<svg viewBox="0 0 x"><path d="M0 0H3" stroke="red"/></svg>"#,
            "invalid viewBox",
            1,
        ),
    ] {
        let (drawn, warnings) = draw(&format!("{line}{content}"));
        assert_eq!(drawn.len(), 1 + strokes, "{content}");
        assert_eq!(warnings.len(), 1, "{content}: {warnings:?}");
        assert!(
            warnings[0].to_string().contains(found),
            "{content}: {warnings:?}"
        );
        assert!(warnings[0].place.is_some());
    }
    let two = r#"<path d="M0 0H3 x" stroke="red"/><path d="M0 0H3 y" stroke="red"/>"#;
    let (drawn, warnings) = draw(two);
    assert_eq!((drawn.len(), warnings.len(), warnings[0].count), (2, 1, 2));
}

#[test]
fn a_point_beyond_a_kilometre_is_refused() {
    let message = error(&page(r#"<path d="M0 0L5e6 5" stroke="red"/>"#));
    assert_eq!(
        message,
        "a path leads to (5000000, 5) mm; at most 1000000 mm from the page's corner are allowed"
    );
}

#[test]
fn a_page_without_area_is_refused() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="0" height="9"><path d="M0 0L1 1"/></svg>"#;
    assert_eq!(
        error(text),
        "the page has no area; set width, height or viewBox of <svg> above 0"
    );
}

#[test]
fn more_segments_than_allowed_are_refused() {
    let path = "l1 1".repeat(100_001);
    assert_eq!(
        error(&page(&format!(r#"<path d="M0 0{path}" stroke="red"/>"#))),
        "the drawing has more than 100000 line segments; simplify its paths, or draw it in parts"
    );
}

#[test]
fn copies_of_copies_of_copies_are_refused_before_they_are_made() {
    let mut content = r#"<defs><path id="a0" d="M0 0L1 1"/>"#.to_owned();
    for i in 1..40 {
        let j = i - 1;
        write!(
            content,
            r##"<g id="a{i}"><use href="#a{j}"/><use href="#a{j}"/></g>"##
        )
        .unwrap();
    }
    content += r##"</defs><use href="#a39"/>"##;
    assert!(error(&page(&content)).contains("more than 20000 elements"));
}

#[test]
fn shapes_that_become_groups_count_twice_and_those_of_full_opacity_do_not() {
    let paths = |attribute: &str| format!("<path {attribute} d=\"M0 0H1\"/>").repeat(13_000);
    let shapes = |attribute: &str| page(&paths(attribute));
    for attribute in ["transform=\"scale(2)\"", "style=\"fill:red; opacity: 0.5\""] {
        let reported = error(&shapes(attribute));
        assert!(reported.contains("more than 25000 elements"), "{reported}");
    }
    let styled = |rule: &str| {
        let paths = paths("class=\"faint\" fill=\"none\"");
        page(&format!("<style>{rule}</style>{paths}"))
    };
    for rule in ["path { opacity: 0.5 }", "g, svg > .faint { opacity: .5 }"] {
        let reported = error(&styled(rule));
        assert!(reported.contains("more than 25000 elements"), "{reported}");
    }
    let opaque = "opacity=\"1\" style=\"fill-opacity:0.5\" fill=\"none\"";
    for content in [
        styled("path { opacity: 1 } .other { opacity: 0.5 }"),
        shapes(opaque),
    ] {
        let reported = error(&content);
        assert!(reported.contains("nothing to draw"), "{reported}");
    }
}

#[test]
fn unsupported_style_and_html_content_is_reported() {
    let line = "<path d='M0 0H9' stroke='red'/>";
    let reported = |more: &str| {
        let (strokes, warnings) = draw(&format!("{line}{more}"));
        assert_eq!(strokes.len(), 1, "{more}");
        let reported = warnings.iter().map(ToString::to_string);
        reported.collect::<Vec<_>>().join("; ")
    };
    let turned =
        "<g style='transform: rotate(9deg); transform-box: fill-box; transform-origin: center'/>";
    assert!(reported(turned).contains("1 transform-box: not supported"));
    let html = "<foreignObject width='9' height='9'><table xmlns='http://www.w3.org/1999/xhtml'><tr><td>A</td></tr></table></foreignObject>";
    assert!(reported(&html.repeat(2)).contains("2 foreignObjects: left out with its text (HTML)"));
    for more in [
        "<foreignObject width='9' height='9'> </foreignObject>",
        "<g style='transform: none; transform-origin: 0 0'/>",
        "<style>svg{width:100%}</style><g style='width:9px'/>",
    ] {
        assert_eq!(reported(more), "", "{more}");
    }
}

#[test]
fn styles_that_would_take_too_long_are_refused() {
    let sheet = |rules: usize| format!("<style>{}</style><rect/>", "a{fill:red}".repeat(rules));
    assert!(error(&page(&sheet(2_000))).contains("nothing to draw"));
    let many = format!("{}{}", sheet(400), "<a/>".repeat(5_000));
    assert!(
        error(&page(&many)).contains("the styles (CSS) take too long to read; use fewer rules")
    );
    let other = format!("{}{}", sheet(400), "<g/>".repeat(5_000));
    assert!(error(&page(&other)).contains("nothing to draw"));
}

#[test]
fn a_drawing_with_very_many_sheets_of_styles_is_read_at_once() {
    let sheets = "<style/>".repeat(12_000);
    let (strokes, _) = draw(&format!("{sheets}<path d='M0 0H9' stroke='red'/>"));
    assert_eq!(strokes.len(), 1);
}

#[test]
fn an_arc_may_turn_any_number_of_times() {
    let length_mm = |turn: &str| {
        let (strokes, _) = draw(&format!(
            r#"<path d="M20 20a5 9 {turn} 0 1 9 9" stroke="red" fill="none"/>"#
        ));
        strokes.iter().map(Stroke::length_mm).sum::<f64>()
    };
    for (turn, same) in [("400", "40"), ("-320", "40"), ("36e10", "0")] {
        assert!((length_mm(turn) - length_mm(same)).abs() < 1e-3, "{turn}");
    }
}

#[test]
fn a_far_too_large_radius_ends_a_path_and_takes_no_memory() {
    let arc = "M1 1H9a1e150 10 0 0 1 10 10H9";
    for content in [
        format!(r#"<path d="{arc}" stroke="red"/>"#),
        format!(
            r#"<marker id="m"><path d="M0 0H1"/></marker><path d="{arc}" stroke="red" marker-mid="url(#m)"/>"#
        ),
        format!(
            r#"<style>.a{{d:path("{arc}")}}</style><path class="a" d="M1 1H9" stroke="red"/>"#
        ),
        format!(
            r#"<path style="d:path('{arc}')" d="M1 1H9" stroke="red"/>"#
        ),
        r#"<path d="M1 1H9" stroke="red"/><circle style="r:1e150px" stroke="red"/>"#.to_owned(),
        r#"<path d="M1 1H9" stroke="red"/><rect width="9" height="9" rx="1e150" style="ry:1e150px;fill:none"/>"#.to_owned(),
    ] {
        let (drawing, warnings) = Drawing::from_svg(&page(&content), &options()).unwrap();
        let length_mm: f64 = drawing.strokes.iter().map(Stroke::length_mm).sum();
        assert!((length_mm - 8.0).abs() < 1e-3, "{length_mm} mm of {content}");
        assert!(!warnings.is_empty(), "{content}");
    }
}

#[test]
fn a_reference_to_an_element_around_it_is_ignored_and_reported() {
    let line = r#"<path d="M1 1H9" stroke="red"/>"#;
    for (content, name) in [
        (
            format!(r##"<g id="a">{line}<g><use href="#a"/></g></g>"##),
            "href of <use> holds \"#a\"",
        ),
        (
            format!(r##"{line}<use id="a" href="#a"/>"##),
            "href of <use> holds \"#a\"",
        ),
        (
            format!(
                r##"<defs><g id="b"><use href="#c"/></g><g id="c">{line}<use href="#b"/></g></defs><use href="#c"/>"##
            ),
            "href of <use> holds \"#b\"",
        ),
        (
            format!(
                r#"<mask id="a" mask="url(#a)" maskUnits="userSpaceOnUse" width="50" height="50"><rect width="50" height="50" fill="white"/></mask><g mask="url(#a)">{line}</g>"#
            ),
            "mask of <mask> holds \"url(#a)\"",
        ),
    ] {
        let (drawing, warnings) = Drawing::from_svg(&page(&content), &options()).unwrap();
        assert_eq!(drawing.strokes.len(), 1, "{content}");
        let warning = warnings[0].to_string();
        let message = format!(
            "circular reference: {name}; expected an element that does not contain this one: ignored"
        );
        assert!(warning.ends_with(&message), "{warning}");
    }
}

#[test]
fn a_file_with_an_error_is_drawn_up_to_it() {
    let line = r#"<path d="M1 1H9" stroke="red"/>"#;
    for (rest, message) in [
        (
            "",
            "1:1: not well-formed XML: the file ends too soon: <svg> starts here and is not closed",
        ),
        (
            "<g><path d='M1 2H9' stro",
            "not well-formed XML: the file ends too soon: <path> starts here",
        ),
        ("<g><text>a & b</text></g></svg>", "not well-formed XML: "),
        (
            "<path d='M1 1H9' d='M2 2H9' stroke='red'/></svg>",
            "not well-formed XML: ",
        ),
        ("<g></svg>", "not well-formed XML: expected 'g' tag"),
        ("</svg><more", "not well-formed XML: "),
    ] {
        let whole = page(&format!("<g>{line}</g>"));
        let text = whole.replace("</svg>", rest);
        let (drawing, warnings) = Drawing::from_svg(&text, &options()).unwrap();
        assert_eq!(drawing.strokes.len(), 1, "{text}");
        let warning = warnings[0].to_string();
        assert!(warning.contains(message), "{warning}");
        assert!(
            warning.ends_with(": the rest of the file is left out"),
            "{warning}"
        );
        let strict = ReadOptions {
            strict: true,
            ..options()
        };
        let refused = crate::Source::from(&*text).read(&strict).unwrap_err();
        assert!(refused.to_string().contains(message), "{refused}");
    }
}

#[test]
fn deep_nesting_is_refused_and_allowed_nesting_fits_the_stack() {
    let nested = |depth| {
        let open = "<g transform='rotate(1 50 25)'>".repeat(depth);
        page(&format!(
            "{open}<path d='M40 20L60 30' stroke='red'/>{}",
            "</g>".repeat(depth)
        ))
    };
    assert!(error(&nested(100_000)).contains("nested more than 100 deep"));
    Drawing::from_svg(&nested(98), &options()).unwrap();
}

#[test]
fn a_billion_dashes_are_refused() {
    let message = error(&page(
        r#"<path d="M0 5H90" stroke="red" stroke-dasharray="0.00001"/>"#,
    ));
    assert!(
        message.contains("more than 100000 line segments"),
        "{message}"
    );
}

#[test]
fn a_tolerance_must_be_a_positive_length() {
    for tolerance_mm in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = ReadOptions {
            tolerance_mm,
            ..options()
        };
        let error = Drawing::from_svg(&page("<rect width='5' height='5'/>"), &options).unwrap_err();
        assert!(matches!(
            error,
            SourceError::Svg(SvgError::Tolerance { .. })
        ));
    }
}

#[test]
fn text_that_names_a_hershey_font_is_written_in_single_lines() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    for family in [
        "Hershey sans",
        "'Hershey Sans 1-stroke'",
        "HersheySans1",
        // A name with a digit at the start of a word needs quotes in CSS; many omit them.
        "Hershey Sans 1-stroke",
        "Hershey  Sans 1-stroke , serif",
    ] {
        for (anchor, least_x, most_x) in [("start", 30.0, 50.0), ("end", 10.0, 30.0)] {
            let text = page(&format!(
                r#"<text x="30" y="30" font-size="20" font-family="{family}" text-anchor="{anchor}">II</text>"#
            ));
            let (drawing, warnings) = Drawing::from_svg(&text, &options).unwrap();
            assert_eq!(warnings, []);
            // Each I is one line, seven tenths of the size of the font tall, on the base line.
            assert_eq!(drawing.strokes.len(), 2);
            for stroke in drawing.strokes {
                let ink = bounds_of_strokes(&[stroke]);
                assert!(ink.width() < 0.1, "{ink:?}");
                assert!(
                    (ink.height() - 14.0).abs() < 1e-3 && (ink.y1 - 30.0).abs() < 1e-3,
                    "{ink:?}"
                );
                assert!(ink.x0 > least_x && ink.x1 < most_x, "{ink:?}");
            }
        }
    }
}

#[test]
fn letters_of_single_lines_are_raised_turned_and_underlined() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let draw = |attributes: &str| {
        let text = page(&format!(
            r#"<text x="30" y="30" font-size="20" font-family="Hershey sans"><tspan {attributes}>I</tspan></text>"#
        ));
        let (drawing, warnings) = Drawing::from_svg(&text, &options).unwrap();
        let reported: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        let ink = |stroke: &Stroke| bounds_of_strokes(std::slice::from_ref(stroke));
        (
            drawing.strokes.iter().map(ink).collect::<Vec<_>>(),
            reported,
        )
    };
    let foot = |attributes: &str| {
        let (ink, reported) = draw(attributes);
        assert_eq!((ink.len(), reported), (1, Vec::new()), "{attributes}");
        ink[0].y1
    };
    assert!((foot(r#"baseline-shift="sub""#) - 34.0).abs() < 1e-3);
    assert!((foot(r#"baseline-shift="super""#) - 22.0).abs() < 1e-3);
    assert!((foot(r#"baseline-shift="5""#) - 25.0).abs() < 1e-3);
    // On its side, to the right of its place.
    let (turned, _) = draw(r#"rotate="90""#);
    assert!(turned[0].height() < 0.1 && (turned[0].width() - 14.0).abs() < 1e-3);
    assert!((turned[0].x0 - 30.0).abs() < 1e-3, "{turned:?}");
    for (line, at) in [
        ("underline", 33.0),
        ("overline", 13.0),
        ("line-through", 23.0),
    ] {
        let (ink, reported) = draw(&format!(r#"text-decoration="{line}""#));
        let is_line = |rect: &&Rect| rect.height() < 1e-3 && (rect.y0 - at).abs() < 1e-3;
        let found = ink.iter().find(is_line);
        assert!(
            found.is_some_and(|found| found.x0 < 30.01 && found.width() > 4.0),
            "{ink:?}"
        );
        assert_eq!((ink.len(), reported), (2, Vec::new()));
    }
    for unread in [
        r#"textLength="60""#,
        r#"dominant-baseline="hanging""#,
        r#"alignment-baseline="middle""#,
        r#"style="dominant-baseline: middle""#,
    ] {
        let (ink, reported) = draw(unread);
        assert_eq!(
            (ink.len(), reported.len()),
            (1, 1),
            "{unread}: {reported:?}"
        );
        assert!(
            reported[0].contains("of Hershey letters, ignored"),
            "{reported:?}"
        );
    }
}

#[test]
fn unsupported_styles_of_single_line_letters_are_reported_once_with_their_line() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let text = page(
        r#"<style>.low { dominant-baseline: hanging }</style>
        <text x="5" y="9" font-size="5" dominant-baseline="middle" font-family="serif">I</text>
        <g font-family="Hershey sans" font-size="5" dominant-baseline="auto">
        <text x="5" y="20">I<tspan textLength="9">I</tspan><tspan class="low">I</tspan></text>
        <text x="5" y="30" textLength="9">I</text>
        <text x="50" y="30" writing-mode="tb">I</text></g>"#,
    );
    let (_, warnings) = Drawing::from_svg(&text, &options).unwrap();
    let mut reported: Vec<(String, usize, u32)> = Vec::new();
    for warning in warnings {
        reported.push((warning.what, warning.count, warning.place.unwrap().line));
    }
    reported.sort();
    let wanted = [
        ("dominant-baseline", 1, 4),
        ("textLength", 2, 4),
        ("writing-mode", 1, 6),
    ];
    let wanted = wanted.map(|(what, count, line)| (what.to_owned(), count, line));
    assert_eq!(reported, wanted);
}

#[test]
fn lines_of_letters_follow_the_moves_of_their_parts() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let text = page(
        r#"<text x="30" y="30" dx="0 4" dy="0 -6" font-size="20" font-family="Hershey sans" text-decoration="underline">II</text>"#,
    );
    let (drawing, _) = Drawing::from_svg(&text, &options).unwrap();
    let ink = |stroke: &Stroke| bounds_of_strokes(std::slice::from_ref(stroke));
    let is_level = |rect: &Rect| rect.height() < 1e-3;
    let lines: Vec<Rect> = drawing.strokes.iter().map(ink).filter(is_level).collect();
    // One below each letter, the second as much higher as the letter is, and none in the gap.
    let [first, second] = lines[..] else {
        panic!("{lines:?}");
    };
    assert!((first.y0 - second.y0 - 6.0).abs() < 1e-3, "{lines:?}");
    assert!((second.x0 - first.x1 - 4.0).abs() < 1e-3, "{lines:?}");
}

#[test]
fn a_font_whose_name_has_a_number_is_found_without_quotes_in_styles_and_sheets() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let text = r#"<text x="30" y="30" style="font-size:20px;font-family:Hershey Sans 1-stroke;fill:red">I</text>"#;
    let sheet = r#"<style>text { font-family: Hershey Sans 1-stroke }</style><text x="30" y="30" font-size="20">I</text>"#;
    for content in [text, sheet] {
        let (drawing, warnings) = Drawing::from_svg(&page(content), &options).unwrap();
        assert_eq!((drawing.strokes.len(), warnings), (1, Vec::new()));
        assert_eq!(drawing.strokes[0].points.len(), 2, "{content}");
    }
    let other = r#"<text x="30" y="30" font-size="20" font-family="Nobody Sans 3">I</text>"#;
    let (_, warnings) = super::read(&page(other), &options).unwrap();
    assert!(
        warnings[0].to_string().contains("Nobody Sans 3"),
        "{warnings:?}"
    );
}

#[test]
fn letters_in_parts_are_written_as_those_in_one() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    for anchor in ["start", "middle", "end"] {
        let draw = |dx: &str, text: &str| {
            let text = page(&format!(
                r#"<text x="30" y="30" dx="{dx}" font-size="10" font-family="Hershey sans" letter-spacing="1"
                text-anchor="{anchor}">{text}</text>"#
            ));
            let (drawing, warnings) = Drawing::from_svg(&text, &options).unwrap();
            (drawing.strokes, warnings)
        };
        let (whole, warnings) = draw("0 0 2", "a\u{e9}a");
        assert_eq!(warnings, []);
        assert_eq!(
            draw("0 0 0 2", "ae\u{301}a"),
            (whole, Vec::new()),
            "{anchor}"
        );
    }
}

#[test]
fn text_becomes_outlines_if_fonts_are_available() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let text = page(r#"<text x="10" y="30" font-size="20">I</text>"#);
    let (drawing, warnings) = Drawing::from_svg(&text, &options).unwrap();
    let ink = bounds_of_strokes(&drawing.strokes);
    assert!(
        ink.x0 > 9.0 && ink.y1 < 30.5 && ink.height() > 10.0,
        "{ink:?}"
    );
    assert_eq!(warnings, []);
}

proptest! {
    #[test]
    fn a_damaged_file_is_drawn_or_refused_but_never_breaks_the_program(
        at in 0.0..1.0_f64,
        length in 0..40_usize,
        filler in proptest::sample::select(vec!["", "<", "\"", "9e99", "-", "url(#frame)", "&", "0", "é"]),
    ) {
        let text = include_str!("../../../../examples/drawings/harbour.svg");
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a place in a short text"
        )]
        let start = (at * text.len() as f64) as usize;
        let end = (start + length).min(text.len());
        let damaged = [&text[..start], filler, &text[end..]].concat();
        match Drawing::from_svg(&damaged, &options()) {
            Ok((drawing, _)) => prop_assert!(!drawing.strokes.is_empty()),
            Err(error) => prop_assert!(!error.to_string().contains('\n')),
        }
    }
}

/// The lines of a page, each by its first and last point.
fn ends(content: &str) -> Vec<[(f64, f64); 2]> {
    let round = |p: Point| ((1e3 * p.x).round() / 1e3, (1e3 * p.y).round() / 1e3);
    let (strokes, _) = draw(content);
    let ends = strokes.iter().map(|stroke| {
        let last = stroke.points[stroke.points.len() - 1];
        [stroke.points[0], last].map(round)
    });
    ends.collect()
}

const LINE: [[(f64, f64); 2]; 1] = [[(10.0, 10.0), (90.0, 10.0)]];

#[test]
fn a_colour_in_the_words_of_newer_css_is_a_colour() {
    for style in [
        r#"style="stroke:light-dark(#000,#fff)""#,
        r#"style="stroke:#000;stroke:color(display-p3 0 0 0)""#,
        r#"stroke="var(--c,black)""#,
        r#"style="--c: rgb(0 0 0 / 50%); stroke: var(--c)""#,
        r#"style="stroke:oklch(0.63 0.26 29.2)""#,
        r#"style="stroke:rgb(255 0 0 / 50%)""#,
        r#"style="stroke:rgba(255, 0, 0, 0.5)""#,
        r#"style="stroke:color-mix(in srgb, red 50%, blue)""#,
        r#"class="a""#,
    ] {
        let sheet = "<style>&lt;!-- @layer y{} :root{--sea:light-dark(navy, white)} @media (prefers-color-scheme: dark){.a{stroke:none}} @layer x{@media screen{.a{stroke:var(--sea)}}} --&gt;</style>";
        let path = format!(r#"{sheet}<path d="M10 10H90" fill="none" {style}/>"#);
        let drawn = Drawing::from_svg(&page(&path), &options());
        assert!(drawn.is_ok(), "{style}: {drawn:?}");
        assert_eq!(ends(&path), LINE, "{style}");
    }
}

#[test]
fn the_colours_of_newer_css_are_those_of_the_layers() {
    let by_color = ReadOptions {
        layers: LayersBy::Color,
        ..options()
    };
    for (color, name) in [
        ("rgb(255 0 0)", "red"),
        ("rgb(100% 0% 0% / 1)", "red"),
        ("color(srgb 0 0 1)", "blue"),
        ("oklch(0 0 0)", "black"),
        ("hwb(120 0% 0%)", "lime"),
        ("light-dark(var(--no, #0ff), red)", "cyan"),
        ("rgb(255, 0, 0)", "red"),
    ] {
        let svg = page(&format!(r#"<path d="M10 10H90" style="stroke:{color}"/>"#));
        let (artwork, _) = super::draw(&svg, &by_color, &super::Substitutes::default()).unwrap();
        assert_eq!(artwork.layers[0].name, name, "{color}");
    }
}

#[test]
fn odd_styles_and_nested_variables_are_read() {
    let each: Vec<String> = (0..20)
        .map(|i| format!("--v{i}: var(--v{}) var(--v{});", i + 1, i + 1))
        .collect();
    let each = each.concat();
    let svg = format!(r#"<path d="M10 10H90" stroke="black" style="{each} fill: var(--v0)"/>"#);
    assert_eq!(ends(&svg), LINE);
    for odd in [
        "fill: \u{2192}var(--a)",
        "fill: \u{2192}2rem; x: \u{2192}rem",
        "\u{2192}--a: b; fill: \u{2192}(var(--a, translate(1)))",
        "font: \u{2192}/\u{2192} a",
        "fill: var(",
        "fill: color-mix(in srgb, \u{2192} 5%",
        "--\u{e4}\u{2192}: \u{e4}",
    ] {
        let sheet = format!("<style>{odd} {{ {odd} }} @media screen {{ \u{2192} {{ {odd}</style>");
        let svg = format!(r#"{sheet}<path d="M10 10H90" stroke="black" stop-color="{odd}"/>"#);
        assert_eq!(ends(&svg), LINE, "{odd}");
    }
    let (long, often) = ("x".repeat(100_000), "var(--long) ".repeat(10_000));
    let svg = format!(
        r#"<path d="M10 10H90" stroke="black" style="--long:{long}" stop-color="{often}"/>"#
    );
    assert_eq!(ends(&svg), LINE);
    let open = "var(".repeat(100_000);
    assert_eq!(
        ends(&format!(
            r#"<path d="M10 10H90" stroke="black" stop-color="{open}"/>"#
        )),
        LINE
    );
    let nested = "@layer a{".repeat(2_000);
    assert_eq!(
        ends(&format!(
            r#"<style>{nested}</style><path d="M10 10H90" stroke="black"/>"#
        )),
        LINE
    );
}

#[test]
fn the_sizes_of_the_page_and_of_letters_are_those_of_the_styles() {
    let wide = |root: &str| {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" {root}><path d="M0 0H24" stroke="red"/></svg>"#
        );
        Drawing::from_svg(&svg, &options()).unwrap().0.width_mm
    };
    assert!((wide(r#"style="width:240mm;height:24cm""#) - 240.0).abs() < 1e-3);
    assert!(
        (wide(r#"width="5mm" height="5mm" style="width:24cm;height:24cm""#) - 240.0).abs() < 1e-3
    );
    assert!((wide(r#"width="24mm" height="24mm" style="width:100%""#) - 24.0).abs() < 1e-3);
}

#[test]
fn letters_have_the_size_given_by_newer_css() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let high = |style: &str| {
        let svg = page(&format!(r#"<text x="10" y="40" style="{style}">H</text>"#));
        let (drawing, _) = Drawing::from_svg(&svg, &options).unwrap();
        bounds_of_strokes(&drawing.strokes).height()
    };
    let expected = high("font-weight:bold;font-size:32px;font-family:sans-serif");
    assert!(expected > 10.0);
    for style in [
        "font:bold 32px/1.5 sans-serif",
        "font: bold 2rem sans-serif",
        "--size: 1; font-weight:bold;font-size:2rem;font-family:sans-serif",
    ] {
        assert!((high(style) - expected).abs() < 1e-6, "{style}");
    }
}

#[test]
fn attributes_that_would_needlessly_hide_a_shape_are_ignored() {
    for path in [
        r##"<path d="M10 10H90" stroke="#000" filter="url(#no)"/>"##,
        r##"<path d="M10 10H90" stroke="#000" pathLength="1" stroke-dasharray="1"/>"##,
        r##"<path d="M10 10H90" stroke="#000" pathLength="1" style="stroke-dasharray:1;fill:none"/>"##,
    ] {
        assert_eq!(ends(path), LINE, "{path}");
    }
    let (_, warnings) =
        draw(r#"<path d="M10 10H90" stroke="red" pathLength="1" stroke-dasharray="10%"/>"#);
    let text = warnings[0].to_string();
    assert!(
        text.ends_with(": 1 dashed line: with pathLength and dashes in percent or em: drawn solid"),
        "{text}"
    );
    assert_eq!(warnings[0].place.unwrap().line, 1);
}

#[test]
fn shapes_that_no_browser_shows_are_not_drawn() {
    for nothing in [
        r#"<line x1="10" y1="10" x2="90" y2="30"/>"#,
        r#"<path d="M20 20h50"/>"#,
        r#"<linearGradient id="g"><stop stop-opacity="0"/><stop offset="1" stop-opacity="0"/></linearGradient><circle r="9" fill="url(#g)"/>"#,
    ] {
        let error = error(&page(nothing));
        assert!(error.contains("nothing to draw"), "{error}");
    }
}

#[test]
fn a_gradient_that_starts_with_white_is_ink() {
    let (strokes, warnings) = draw(
        r##"<radialGradient id="g"><stop stop-color="#fff"/><stop offset="1" stop-color="#00f"/></radialGradient>
        <rect x="10" y="10" width="20" height="20" fill="url(#g)"/>"##,
    );
    assert_eq!(strokes.len(), 1);
    assert!(warnings[0].to_string().contains("1 gradient"));
}

#[test]
fn unsupported_styles_are_reported() {
    for (content, reported) in [
        (
            r#"<g style="clip-path: inset(0 50% 0 0)">LINE</g>"#,
            "1 CSS clip-path",
        ),
        (
            r#"<use href="other.svg#a"/>LINE"#,
            "1 shape: of another file",
        ),
        (
            r"<style>:odd(.h, .i){display:none} .a:hover{fill:red}</style>LINE",
            "1 CSS rule: ignored",
        ),
    ] {
        let line = r#"<path d="M10 10H90" stroke="red"/>"#;
        let (strokes, warnings) = draw(&content.replace("LINE", line));
        assert_eq!(
            (strokes.len(), warnings.len()),
            (1, 1),
            "{content}: {warnings:?}"
        );
        assert!(warnings[0].to_string().contains(reported), "{warnings:?}");
    }
}
