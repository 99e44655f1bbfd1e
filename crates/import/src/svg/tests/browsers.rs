//! Differences between browsers and the library.

use super::*;

/// A page of which the root has these attributes, with a line from its corner to (100, 50).
fn with_root(attributes: &str) -> (Drawing, Vec<Warning>) {
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" {attributes}><path d="M0 0L100 50" stroke="red"/></svg>"#
    );
    Drawing::from_svg(&svg, &options()).unwrap_or_else(|error| panic!("{attributes}: {error}"))
}

#[test]
fn a_page_size_that_browsers_ignore_is_reported_and_the_view_box_applies() {
    for size in [
        "200 mm",
        "",
        "100vw",
        "calc(100% - 2px)",
        "wide",
        "1e3 1",
        "-5mm",
    ] {
        let (drawing, warnings) = with_root(&format!(
            r#"viewBox="0 0 100 50" width="{size}" height="{size}""#
        ));
        let expected_mm = 100.0 * 25.4 / 96.0;
        assert!((drawing.width_mm - expected_mm).abs() < 1e-3, "{size}");
        assert!(warnings[0].to_string().ends_with(
            ": 2 page sizes: (width or height of <svg>) ignored, because it is not a length such as \
             200mm; the size is that of the viewBox or of the drawing, in pixels"
        ));
    }
    for size in ["100%", "auto", "200mm", " 200mm "] {
        let (_, warnings) = with_root(&format!(r#"viewBox="0 0 100 50" width="{size}""#));
        assert_eq!(warnings, [], "{size}");
    }
    let (drawing, warnings) = with_root(r#"width="20 cm" height="""#);
    assert_eq!((drawing.strokes.len(), warnings.len()), (1, 1));
}

#[test]
fn width_and_height_of_the_styles_are_both_read() {
    let (drawing, warnings) = with_root(r#"viewBox="0 0 100 50" style="width:100mm;height:50mm""#);
    let end = drawing.strokes[0].last().unwrap();
    assert!(close(end, 100.0, 50.0), "{end:?}");
    assert_eq!(warnings, []);
}

#[test]
fn a_length_with_blanks_around_it_is_read() {
    let (strokes, _) = draw(r#"<rect x=" 5" y="5 " width=" 20mm " height="10" fill="red"/>"#);
    let ink = bounds_of_strokes(&strokes);
    assert!((ink.x0 - 5.0).abs() < 1e-3 && ink.width() > 70.0, "{ink:?}");
}

#[test]
fn a_marker_points_along_the_other_handle_if_one_coincides_with_its_end() {
    let marker = |d: &str, which: &str| {
        let ends = ends(&format!(
            r#"<marker id="m" orient="auto" markerUnits="userSpaceOnUse" markerWidth="9" markerHeight="9" overflow="visible">
                <path d="M0 0H5" stroke="red"/></marker>
            <g marker-{which}="url(#m)"><path d="{d}" stroke="blue" fill="none"/></g>"#
        ));
        let [from, to] = *ends.last().unwrap();
        let round = |x: f64| (10.0 * x).round() / 10.0 + 0.0;
        (round(to.0 - from.0), round(to.1 - from.1))
    };
    // It begins downwards and ends to the right.
    assert_eq!(marker("M10 10C10 10 10 40 40 40", "start"), (0.0, 5.0));
    assert_eq!(marker("M10 10C10 40 40 40 40 40", "end"), (5.0, 0.0));
    assert_eq!(marker("M10 10c0 0 0 30 30 30 M9 9H5", "start"), (0.0, 5.0));
    assert_eq!(marker("M10 10C10 10 40 40 40 40", "start"), (3.5, 3.5));
    // In the middle, along both curves, which go to the right there.
    let both = "M10 10C10 30 40 30 40 30C40 30 60 30 60 10";
    assert_eq!(marker(both, "mid"), (5.0, 0.0));
}

#[test]
fn dashes_of_a_line_that_does_not_scale_are_as_long_as_on_a_screen() {
    let dashes = |attributes: &str| {
        let (strokes, _) = draw(&format!(
            r#"<path transform="scale(2 1)" d="M0 5H20" stroke="red" {attributes}/>"#
        ));
        let lengths = strokes
            .iter()
            .map(|stroke| (10.0 * stroke.length_mm()).round());
        lengths.collect::<Vec<f64>>()
    };
    let px = 25.4 / 96.0;
    let long = (100.0 * px * 10.0_f64).round();
    for still in [
        r#"vector-effect="non-scaling-stroke" stroke-dasharray="100 20""#,
        r#"style="vector-effect: non-scaling-stroke; stroke-dasharray: 100 20""#,
    ] {
        let rest = (10.0 * (40.0 - 120.0 * px)).round();
        assert_eq!(dashes(still), [long, rest], "{still}");
    }
    assert_eq!(dashes(r#"stroke-dasharray="5 5""#), [100.0, 100.0]);
}

/// How wide and how far to the left and right the ink of a text lies.
fn ink(content: &str, options: &ReadOptions) -> dobot_geometry::Rect {
    let (drawing, _) = Drawing::from_svg(&page(content), options).unwrap();
    bounds_of_strokes(&drawing.strokes)
}

#[test]
fn a_hidden_part_of_a_text_is_skipped_with_its_contents() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let expected = ink(r#"<text x="10" y="30">II</text>"#, &options);
    for hidden in [
        r#"<tspan display="none">M<tspan>M</tspan>M</tspan>"#,
        r#"<tspan style="display: none">M<tspan style="display:inline">M</tspan></tspan>"#,
        r#"<tspan class="h"><tspan>M</tspan></tspan>"#,
    ] {
        let svg =
            format!(r#"<style>.h{{display:none}}</style><text x="10" y="30">I{hidden}I</text>"#);
        assert_eq!(ink(&svg, &options), expected, "{hidden}");
    }
}

#[test]
fn a_text_from_right_to_left_starts_at_its_right_end() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let sides = |attributes: &str| {
        let svg = format!(r#"<g {attributes}><text x="50" y="30">III</text></g>"#);
        let ink = ink(&svg, &options);
        (ink.x1 < 51.0, ink.x0 > 49.0)
    };
    for (attributes, expected) in [
        (r#"direction="rtl""#, (true, false)),
        (r#"direction="rtl" text-anchor="start""#, (true, false)),
        (r#"style="direction: rtl; text-anchor: end""#, (false, true)),
        (r#"direction="rtl" text-anchor="middle""#, (false, false)),
        (r#"direction="ltr" text-anchor="end""#, (true, false)),
    ] {
        assert_eq!(sides(attributes), expected, "{attributes}");
    }
}

#[test]
fn rules_select_elements_by_parts_of_their_attributes_and_by_their_positions() {
    for selector in [
        "[id^='hidden-']",
        "path[id$=two]",
        "path[id*='-']",
        "path:nth-child(2n+3)",
        "path:last-child",
        "path:not(.shown)",
        "g > path:nth-of-type(2), circle:first-of-type",
    ] {
        let lines = ends(&format!(
            r#"<style>.shown{{fill:none}} {selector}{{display:none}}</style>
            <g><rect/><path class="shown" d="M10 10H90" stroke="red"/>
            <path id="hidden-two" d="M10 20H90" stroke="red"/></g>"#
        ));
        assert_eq!(lines, LINE, "{selector}");
    }
    // A reference counts as much as its target.
    let lines = ends(
        r#"<style>path[id^=a]{display:inline} path{display:none}</style>
        <path id="a" d="M10 10H90" stroke="red"/>"#,
    );
    assert_eq!(lines, LINE);
}

/// The lengths of the lines of a page, rounded.
fn lengths(content: &str) -> (Vec<f64>, Vec<String>) {
    let (strokes, warnings) = draw(content);
    let lengths = strokes.iter().map(|stroke| stroke.length_mm().round());
    (
        lengths.collect(),
        warnings.iter().map(ToString::to_string).collect(),
    )
}

#[test]
fn a_mask_of_black_and_white_clips() {
    let line = r#"<g mask="url(#m)"><path d="M0 10H50" stroke="red"/></g>"#;
    let through = |mask: &str| lengths(&format!("{mask}{line}"));
    let area = r#"x="0" y="0" width="100" height="50" maskUnits="userSpaceOnUse""#;
    for (mask, shown) in [
        (format!(r#"<mask id="m" {area} fill="white"><rect x="20" width="20" height="60"/></mask>"#), vec![20.0]),
        (
            format!(r#"<mask id="m" {area}><rect width="99" height="60" fill="white"/><rect x="20" width="20" height="60"/></mask>"#),
            vec![20.0, 10.0],
        ),
        (format!(r#"<mask id="m" {area} style="mask-type:alpha"><rect x="20" width="20" height="60" fill="blue"/></mask>"#), vec![20.0]),
        (
            format!(r#"<mask id="n" {area}><rect width="30" height="60" fill="white"/></mask><mask id="m" {area} mask="url(#n)"><rect x="20" width="20" height="60" fill="white"/></mask>"#),
            vec![10.0],
        ),
        (r#"<mask id="m" x="0" y="0" width="30" height="50" maskUnits="userSpaceOnUse"><rect width="99" height="60" fill="white"/></mask>"#.to_owned(), vec![30.0]),
    ] {
        assert_eq!(through(&mask), (shown, Vec::new()), "{mask}");
    }
    for mask in [
        format!(r#"<mask id="m" {area}><rect width="99" height="60" fill="gray"/></mask>"#),
        format!(
            r#"<mask id="m" {area}><rect width="99" height="60" fill="white" opacity=".5"/></mask>"#
        ),
        format!(r#"<mask id="m" {area}><path d="M0 0H9" stroke="white" stroke-width="9"/></mask>"#),
    ] {
        let (shown, warnings) = through(&mask);
        assert_eq!(shown, [50.0], "{mask}");
        assert_eq!(
            warnings,
            ["1 mask: ignored; what it hides is drawn"],
            "{mask}"
        );
    }
}

#[test]
fn a_mask_that_hides_a_line_because_it_has_no_height_is_reported() {
    let mask = r#"<mask id="m" fill="white"><rect x="20" width="20" height="60"/></mask>"#;
    let line = r#"<path d="M0 10H50" stroke="red" mask="url(#m)"/><path d="M0 0H9" stroke="red"/>"#;
    let (shown, warnings) = lengths(&format!("{mask}{line}"));
    assert_eq!(shown, [9.0]);
    assert!(warnings[0].contains("1 mask: of something without width or height hides it"));
}

#[test]
fn dashes_of_a_path_with_a_length_are_shares_of_it() {
    for (path, shown) in [
        (
            r#"<path d="M0 10H60" pathLength="6" stroke-dasharray="2 1" stroke="red"/>"#,
            vec![20.0, 20.0],
        ),
        (
            r#"<g stroke-dasharray="1"><path d="M0 10H60" pathLength="4" style="stroke:red;stroke-dashoffset:-1"/></g>"#,
            vec![15.0, 15.0],
        ),
        (
            r#"<circle cx="50" cy="25" r="10" fill="none" pathLength="2" stroke-dasharray="1" stroke="red"/>"#,
            vec![31.0],
        ),
        (
            r#"<path d="M0 10H60" pathLength="0" stroke-dasharray="2" stroke="red"/>"#,
            vec![60.0],
        ),
        (
            r#"<path d="M0 10H30" pathLength="-1" stroke-dasharray="10 20" stroke="red"/>"#,
            vec![10.0],
        ),
    ] {
        assert_eq!(lengths(path), (shown, Vec::new()), "{path}");
    }
}

#[test]
fn an_image_that_is_an_svg_file_is_drawn() {
    let inner = "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'><path d='M0 5H20' style='STROKE:red'/></svg>";
    let data = inner.replace('<', "%3C").replace('>', "%3E");
    let image = |data: &str| {
        format!(r#"<image x="10" y="10" width="20" height="20" href="data:image/svg+xml,{data}"/>"#)
    };
    let (shown, warnings) = lengths(&image(&data));
    assert_eq!((shown, warnings), (vec![20.0], Vec::new()));
    // An image in an image, damage, and what cannot be drawn.
    let nested = "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'><path d='M0 5H10L' stroke='red'/><image width='5' height='5' href='data:image/svg+xml,x'/></svg>";
    let data = nested.replace('<', "%3C").replace('>', "%3E");
    let (shown, warnings) = lengths(&image(&data));
    assert_eq!(shown, [20.0]);
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(
        warnings
            .iter()
            .any(|text| text.contains("1 image: left out"))
    );
    assert!(
        warnings
            .iter()
            .any(|text| text.starts_with("invalid path: ") && text.ends_with("drawn up to there"))
    );
    let (_, warnings) = draw(&format!(
        "{}{}",
        image("broken"),
        r#"<path d="M0 0H9" stroke="red"/>"#
    ));
    assert_eq!(
        warnings[0].to_string(),
        "1 image: left out; trace it to paths"
    );
}

#[test]
fn a_pattern_is_drawn_as_its_lines_inside_the_shape() {
    let pattern = |attributes: &str, content: &str| {
        format!(
            r#"<pattern id="p" width="10" height="10" patternUnits="userSpaceOnUse" {attributes}>{content}</pattern>
            <rect x="20" y="10" width="30" height="20" fill="url(#p)"/>"#
        )
    };
    let line = r#"<path d="M0 5H10" stroke="red"/>"#;
    for (content, total_mm) in [
        (pattern("", line), 60.0),
        (pattern(r#"patternTransform="rotate(90)""#, line), 60.0),
        (
            pattern(r#"x="2""#, r#"<path d="M5 0V10" stroke="red"/>"#),
            60.0,
        ),
        (pattern("", r#"<path d="M-5 5H50" stroke="red"/>"#), 60.0),
        (
            pattern(
                r#"viewBox="0 0 1 1""#,
                r#"<path d="M0 .5H1" stroke="red"/>"#,
            ),
            60.0,
        ),
    ] {
        let (strokes, warnings) = draw(&content);
        let found: f64 = strokes.iter().map(Stroke::length_mm).sum();
        assert!((found - total_mm).abs() < 0.1, "{content}: {found}");
        assert_eq!(warnings, [], "{content}");
    }
    let fine = pattern("", line)
        .replace(r#"width="10""#, r#"width="0.01""#)
        .replace(r#"height="10""#, r#"height="0.01""#);
    let (strokes, warnings) = draw(&fine);
    assert_eq!(strokes.len(), 1);
    assert!(
        warnings[0]
            .to_string()
            .contains("1 pattern: of a line, or of too many tiles")
    );
}

#[test]
fn a_layer_that_axidraw_does_not_draw_is_left_out_and_unread_codes_are_reported() {
    let layer = |label: &str| {
        format!(
            r#"<g xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:groupmode="layer" i:label="{label}"><path d="M0 5H10" stroke="red"/></g>"#
        )
    };
    let content = format!(
        "{}{}{}",
        layer("%guides"),
        layer("!1+S30+H40 red"),
        layer("blue")
    );
    let (strokes, warnings) = draw(&content);
    assert_eq!(strokes.len(), 2);
    let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(texts.len(), 2);
    assert!(texts[0].contains(": 1 layer: with % before its name: left out, as by AxiDraw"));
    assert!(
        texts[1].contains("1 layer name: with a pen height or delay"),
        "{texts:?}"
    );
}

#[test]
fn a_plain_label_in_html_is_written_in_its_middle() {
    let Some(options) = with_fonts() else {
        return; // A machine without fonts cannot show this.
    };
    let label = |style: &str, lines: &str| {
        format!(
            r#"<foreignObject x="20" y="10" width="60" height="24"><div xmlns="http://www.w3.org/1999/xhtml" style="font-size:8px;{style}">{lines}</div></foreignObject>"#
        )
    };
    let middle = ink(&label("text-align: center", "<p>HI</p>"), &options);
    assert!((middle.center().x - 50.0).abs() < 2.0, "{middle:?}");
    assert!(middle.y0 > 10.0 && middle.y1 < 20.0, "{middle:?}");
    let left = ink(&label("", "<span>HI</span><br/>HI"), &options);
    assert!(
        left.x0 > 19.0 && left.x0 < 23.0 && left.height() > 12.0,
        "{left:?}"
    );
    let (_, warnings) = Drawing::from_svg(&page(&label("", "HI")), &options).unwrap();
    assert!(
        warnings[0]
            .to_string()
            .contains("1 label: in a foreignObject (HTML): drawn as plain")
    );
    // In a switch, the text for other programs is drawn, and a long text is not wrapped.
    let both = format!(
        "<switch>{}<text x='5' y='40' font-size='8'>O</text></switch>",
        label("", "HI")
    );
    assert!(ink(&both, &options).y0 > 30.0);
    let long = format!(
        "{}{}",
        label("", &"word ".repeat(40)),
        "<path d='M0 0H9' stroke='red'/>"
    );
    let (_, warnings) = Drawing::from_svg(&page(&long), &options).unwrap();
    assert!(
        warnings[0]
            .to_string()
            .contains("1 foreignObject: left out"),
        "{warnings:?}"
    );
}
