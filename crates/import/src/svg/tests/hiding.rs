use super::*;

fn hidden(content: &str) -> (Vec<Stroke>, Vec<Warning>) {
    let hides = ReadOptions {
        hides: true,
        ..options()
    };
    let (drawing, warnings) = Drawing::from_svg(&page(content), &hides).unwrap();
    (drawing.strokes, warnings)
}

fn length_mm(strokes: &[Stroke]) -> f64 {
    strokes.iter().map(Stroke::length_mm).sum()
}

#[test]
fn a_line_under_a_filled_shape_is_cut_and_one_above_it_is_not() {
    let line = r#"<path d="M0 10H60" stroke="red"/>"#;
    let square = r#"<rect x="20" y="0" width="20" height="20" fill="blue"/>"#;
    let (strokes, _) = hidden(&format!("{line}{square}"));
    assert!((length_mm(&strokes) - (40.0 + 80.0)).abs() < 1e-3);
    assert_eq!(strokes.len(), 3);
    let (strokes, _) = hidden(&format!("{square}{line}"));
    assert!((length_mm(&strokes) - (60.0 + 80.0)).abs() < 1e-3);
}

#[test]
fn a_white_shape_hides_and_is_not_drawn_itself() {
    let (strokes, warnings) = hidden(
        r##"<path d="M0 10H60" stroke="red"/><rect x="20" y="0" width="20" height="20" fill="#fff"/>"##,
    );
    assert_eq!(strokes.len(), 2);
    assert!((length_mm(&strokes) - 40.0).abs() < 1e-3);
    assert_eq!(warnings, []);
}

#[test]
fn the_outline_of_a_shape_is_above_its_own_fill() {
    let (strokes, _) =
        hidden(r#"<rect x="10" y="10" width="10" height="10" fill="white" stroke="black"/>"#);
    assert_eq!(strokes.len(), 1);
    assert!(strokes[0].closed);
}

#[test]
fn a_hole_shows_the_shapes_below() {
    let rings = "M20 0H50V30H20ZM30 5H40V25H30Z";
    for (rule, shown_mm) in [("evenodd", 40.0), ("nonzero", 30.0)] {
        let (strokes, _) = hidden(&format!(
            r##"<path d="M0 10H60" stroke="red"/><path d="{rings}" fill-rule="{rule}" fill="#fff"/>"##
        ));
        assert!((length_mm(&strokes) - shown_mm).abs() < 1e-3, "{rule}");
    }
}

#[test]
fn a_transparent_shape_hides_nothing() {
    for faint in [
        r#"fill-opacity="0.5""#,
        r#"opacity="0.9""#,
        r#"fill="none" stroke="red""#,
    ] {
        let (strokes, _) = hidden(&format!(
            r#"<path d="M0 10H60" stroke="red"/><rect x="20" y="0" width="20" height="20" {faint}/>"#
        ));
        assert!(
            (length_mm(&strokes) - (60.0 + 80.0)).abs() < 1e-3,
            "{faint}"
        );
    }
}

#[test]
fn a_clipped_shape_hides_only_where_it_is_visible() {
    let (strokes, _) = hidden(
        r##"<clipPath id="c"><rect x="0" y="0" width="30" height="50"/></clipPath>
        <path d="M0 10H60" stroke="red"/>
        <rect x="20" y="0" width="20" height="20" fill="#fff" clip-path="url(#c)"/>"##,
    );
    assert!((length_mm(&strokes) - 50.0).abs() < 1e-3);
}

#[test]
fn the_hidden_part_of_an_area_is_not_hatched() {
    let hides = ReadOptions {
        hides: true,
        ..options()
    };
    let svg = page(
        r##"<rect x="0" y="0" width="20" height="20" fill="red"/><circle cx="50" cy="20" r="5"/>
        <rect x="10" y="0" width="20" height="20" fill="blue"/><rect x="40" y="10" width="20" height="20" fill="#fff"/>"##,
    );
    let (artwork, _) =
        super::super::draw(&svg, &hides, &super::super::Substitutes::default()).unwrap();
    let areas: Vec<_> = artwork
        .layers
        .iter()
        .flat_map(|layer| &layer.areas)
        .collect();
    let sizes = areas.iter().map(|area| {
        let corners = bounds_of_strokes(&[Stroke::open(area.rings.concat())]);
        corners.area().round()
    });
    assert_eq!(sizes.collect::<Vec<f64>>(), [200.0, 400.0]);
}

#[test]
fn if_too_many_shapes_overlap_all_are_drawn_and_this_is_reported() {
    let shapes = 600_u32;
    let mut svg = String::new();
    for i in 0..shapes {
        let at = 10.0 + f64::from(i) * 1e-4;
        write!(svg, r#"<rect x="{at}" y="{at}" width="20" height="20"/>"#).unwrap();
    }
    let (strokes, warnings) = hidden(&svg);
    // The lowest ones are looked at first, and hardly any of their lines shows.
    let whole = strokes.iter().filter(|stroke| stroke.closed).count();
    assert!(whole > 300, "{whole}");
    assert!(
        warnings[0]
            .to_string()
            .contains("drawn completely, because too many shapes lie over it"),
        "{warnings:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_visible_parts_are_those_that_no_later_shape_covers(
        squares in proptest::collection::vec((0_u32..30, 0_u32..30, 1_u32..20, 1_u32..20), 1..12),
    ) {
        // Edges of all squares lie on different lines, so that none is along another.
        let box_of = |(i, &(x, y, w, h)): (usize, &(u32, u32, u32, u32))| {
            let off = f64::from(u32::try_from(i).unwrap()) * 0.03;
            let [x0, y0] = [x, y].map(|value| f64::from(value) + off);
            [x0, y0, x0 + f64::from(w) + 0.011, y0 + f64::from(h) + 0.017]
        };
        let boxes: Vec<[f64; 4]> = squares.iter().enumerate().map(box_of).collect();
        let mut svg = String::new();
        for [x0, y0, x1, y1] in &boxes {
            write!(svg, r#"<path d="M{x0} {y0}H{x1}V{y1}H{x0}Z" fill="red"/>"#).unwrap();
        }
        let (strokes, _) = hidden(&svg);
        let covered = |p: Point, above: usize| {
            let slack = 5e-3;
            boxes[above..].iter().any(|&[x0, y0, x1, y1]| {
                p.x > x0 + slack && p.x < x1 - slack && p.y > y0 + slack && p.y < y1 - slack
            })
        };
        let mut wanted_mm = 0.0;
        for (i, &[x0, y0, x1, y1]) in boxes.iter().enumerate() {
            let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)];
            let corners = corners.map(|(x, y)| Point::new(x, y));
            for pair in corners.windows(2) {
                let steps = 4000;
                let seen = (0..steps).filter(|&step| {
                    let share = (f64::from(step) + 0.5) / f64::from(steps);
                    !covered(pair[0].lerp(pair[1], share), i + 1)
                });
                let share = f64::from(u32::try_from(seen.count()).unwrap()) / f64::from(steps);
                wanted_mm += share * pair[0].distance(pair[1]);
            }
        }
        let found_mm = length_mm(&strokes);
        prop_assert!((found_mm - wanted_mm).abs() < 0.002 * wanted_mm + 0.3, "{found_mm} mm, not {wanted_mm} mm");
    }
}

#[test]
fn a_translucent_fill_hides_nothing() {
    let see_through = r#"<linearGradient id="g"><stop stop-opacity=".5"/><stop offset="1" stop-opacity="0"/></linearGradient>
        <pattern id="p" width="4" height="4" patternUnits="userSpaceOnUse"><circle r="1"/></pattern>"#;
    for over in [
        r#"fill="url(#g)""#,
        r#"fill="red" style="mix-blend-mode:multiply""#,
    ] {
        let (strokes, _) = hidden(&format!(
            r#"{see_through}<path d="M0 10H60" stroke="red"/><rect x="20" y="0" width="20" height="20" {over}/>"#
        ));
        assert!((length_mm(&strokes) - (60.0 + 80.0)).abs() < 1e-3, "{over}");
    }
    let hides = ReadOptions {
        hides: true,
        ..options()
    };
    let tiled = format!(
        r#"{see_through}<path d="M0 10H60" stroke="red"/><rect x="20" y="0" width="20" height="20" fill="url(#p)"/>"#
    );
    // The line runs between the circles of its tiles.
    let red = layer_lengths(&tiled, &hides)
        .into_iter()
        .find(|layer| layer.0 == "red");
    assert_eq!(red, Some(("red".to_owned(), 60.0)));
}

/// The length of the lines of each layer.
fn layer_lengths(content: &str, read_options: &ReadOptions) -> Vec<(String, f64)> {
    let substitutes = super::super::Substitutes::default();
    let (artwork, _) = super::super::draw(&page(content), read_options, &substitutes).unwrap();
    let lengths = artwork
        .layers
        .into_iter()
        .map(|layer| (layer.name, length_mm(&layer.strokes).round()));
    lengths.collect()
}

const WHITE_ON_BLACK: &str = r##"<rect x="5" y="5" width="40" height="40"/><rect x="15" y="15" width="10" height="10" fill="#fff"/>"##;

#[test]
fn the_edge_of_a_white_shape_on_a_darker_one_is_drawn_in_the_colour_below() {
    let hides = ReadOptions {
        hides: true,
        ..options()
    };
    let shown = ReadOptions {
        white_edges: true,
        ..options()
    };
    for read_options in [&hides, &shown] {
        assert_eq!(
            layer_lengths(WHITE_ON_BLACK, read_options),
            [("black".to_owned(), 200.0)]
        );
    }
    // Half of it lies on paper, and an edge on white is none.
    let half = WHITE_ON_BLACK.replace(r#"x="15""#, r#"x="0""#);
    assert_eq!(layer_lengths(&half, &shown)[0].1, 160.0 + 20.0);
    let white = format!(
        "{WHITE_ON_BLACK}{}",
        r#"<rect x="17" y="17" width="3" height="3" fill="white"/>"#
    );
    assert_eq!(layer_lengths(&white, &hides), [("black".to_owned(), 200.0)]);
    // Later shapes hide it, and without a darker fill there is nothing to show.
    let covered = format!(
        "{WHITE_ON_BLACK}{}",
        r#"<rect x="10" y="10" width="20" height="20" fill="red"/>"#
    );
    assert_eq!(
        layer_lengths(&covered, &hides),
        [("black".to_owned(), 160.0), ("red".to_owned(), 80.0)]
    );
    let line = r##"<path d="M0 10H60" stroke="red"/><rect x="20" y="0" width="20" height="20" fill="#fff"/>"##;
    assert_eq!(layer_lengths(line, &hides), [("red".to_owned(), 40.0)]);
    // A translucent fill below, and one above.
    let faint = WHITE_ON_BLACK.replace("40\"/>", "40\" fill-opacity=\".5\"/>");
    assert_eq!(layer_lengths(&faint, &hides), [("black".to_owned(), 200.0)]);
    let clipped = r#"<clipPath id="c"><rect x="0" y="0" width="20" height="50"/></clipPath>"#;
    let clipped = format!(
        "{clipped}{}",
        WHITE_ON_BLACK.replace("10\" fill", "10\" clip-path=\"url(#c)\" fill")
    );
    assert_eq!(
        layer_lengths(&clipped, &hides),
        [("black".to_owned(), 160.0 + 30.0)]
    );
}

#[test]
fn white_shapes_on_darker_ones_are_counted_if_their_edges_are_not_drawn() {
    let (strokes, warnings) = draw(&format!(
        r#"<rect width="100" height="50" fill="white"/>{WHITE_ON_BLACK}"#
    ));
    assert_eq!(length_mm(&strokes).round(), 160.0);
    let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        texts,
        [
            "2 white shapes: left out, because the paper is white",
            "1 white shape on a darker one: its edge is not drawn; draw it with what.white_edges or what.hide",
        ]
    );
}

#[test]
fn the_edges_that_a_clip_path_cuts_into_a_shape_with_a_line_are_drawn() {
    let clip = r#"<clipPath id="c"><rect x="30" y="0" width="40" height="60"/></clipPath>"#;
    let shape = |paint: &str| {
        format!(r#"{clip}<rect x="10" y="15" width="80" height="30" {paint} clip-path="url(#c)"/>"#)
    };
    let lengths = |paint: &str| layer_lengths(&shape(paint), &options());
    assert_eq!(
        lengths(r#"fill="orange" stroke="black""#),
        [("orange".to_owned(), 60.0), ("black".to_owned(), 80.0)]
    );
    assert_eq!(
        lengths(r#"fill="none" stroke="black""#),
        [("black".to_owned(), 80.0)]
    );
    assert_eq!(
        lengths(r#"fill="white" stroke="black""#),
        [("black".to_owned(), 80.0)]
    );
    assert_eq!(lengths(r#"fill="orange""#), [("orange".to_owned(), 140.0)]);
}

#[test]
fn very_many_white_shapes_on_darker_ones_spoil_nothing_else() {
    let mut svg = r#"<clipPath id="c"><rect width="50" height="50"/></clipPath>"#.to_owned();
    for i in 0..9_000_u32 {
        let at = f64::from(i) * 1e-3;
        write!(svg, r#"<rect x="{at}" y="{at}" width="20" height="20"/><rect x="{at}" y="{at}" width="9" height="9" fill="white"/>"#).unwrap();
    }
    svg += r#"<path d="M0 40H99" stroke="red" clip-path="url(#c)"/>"#;
    let (strokes, warnings) = draw(&svg);
    assert_eq!(strokes.len(), 9_001);
    let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert!(
        texts
            .iter()
            .any(|text| text.contains("1 white shape: among too many shapes")),
        "{texts:?}"
    );
}
