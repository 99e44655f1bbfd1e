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
    let shapes = 3000_u32;
    let mut svg = String::new();
    for i in 0..shapes {
        let at = 10.0 + f64::from(i) * 1e-4;
        write!(svg, r#"<rect x="{at}" y="{at}" width="20" height="20"/>"#).unwrap();
    }
    let (strokes, warnings) = hidden(&svg);
    // The lowest ones are looked at first, and hardly any of their lines shows.
    let whole = strokes.iter().filter(|stroke| stroke.closed).count();
    assert!(whole > 2000, "{whole}");
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
        r#"fill="url(#p)""#,
        r#"fill="red" style="mix-blend-mode:multiply""#,
    ] {
        let (strokes, _) = hidden(&format!(
            r#"{see_through}<path d="M0 10H60" stroke="red"/><rect x="20" y="0" width="20" height="20" {over}/>"#
        ));
        assert!((length_mm(&strokes) - (60.0 + 80.0)).abs() < 1e-3, "{over}");
    }
}
