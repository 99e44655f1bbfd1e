#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use dobot_geometry::{Area, FillRule, Line, ParamCurveNearest, Point, Stroke, direction, steps};
use proptest::prelude::*;

use super::*;
use crate::strokes::shapes::tangle;

fn ring(corners: &[(f64, f64)]) -> Vec<Point> {
    corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

fn area(rings: &[&[(f64, f64)]], rule: FillRule) -> Area {
    Area {
        rings: rings.iter().map(|corners| ring(corners)).collect(),
        rule,
    }
}

fn along_x(spacing_mm: f64) -> Hatch {
    Hatch {
        spacing_mm,
        angle_deg: 0.0,
        ..Hatch::default()
    }
}

const SQUARE: &[(f64, f64)] = &[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
const HOLE: &[(f64, f64)] = &[(3.0, 3.0), (7.0, 3.0), (7.0, 7.0), (3.0, 7.0)];

fn length_mm(strokes: &[Stroke]) -> f64 {
    strokes.iter().map(Stroke::length_mm).sum()
}

/// Whether a point is inside by the rule, or extremely close to the border.
fn holds(area: &Area, p: Point) -> bool {
    let edges = || {
        let rings = area.rings.iter();
        rings.flat_map(|ring| (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()])))
    };
    if edges().any(|(a, b)| Line::new(a, b).nearest(p, 0.0).distance_sq < 1e-12) {
        return true;
    }
    let winding: i32 = edges()
        .filter(|(a, b)| (a.y <= p.y) != (b.y <= p.y))
        .filter(|(a, b)| a.lerp(*b, (p.y - a.y) / (b.y - a.y)).x > p.x)
        .map(|(a, b)| if a.y < b.y { 1 } else { -1 })
        .sum();
    match area.rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => winding % 2 != 0,
    }
}

#[test]
fn a_square_is_filled_in_one_stroke_back_and_forth() {
    let strokes = hatch(&area(&[SQUARE], FillRule::NonZero), &along_x(1.0)).unwrap();
    assert_eq!(strokes.len(), 1);
    assert_eq!(strokes[0].points.len(), 20);
    assert!((length_mm(&strokes) - 109.0).abs() < 1e-9);
    assert_eq!(
        strokes[0].points[..4],
        ring(&[(0.0, 0.5), (10.0, 0.5), (10.0, 1.5), (0.0, 1.5)])
    );
}

#[test]
fn a_hole_stays_empty_under_either_fill_rule() {
    let turned: Vec<(f64, f64)> = HOLE.iter().rev().copied().collect();
    let odd = hatch(&area(&[SQUARE, HOLE], FillRule::EvenOdd), &along_x(0.5)).unwrap();
    let against = hatch(&area(&[SQUARE, &turned], FillRule::NonZero), &along_x(0.5)).unwrap();
    let with = hatch(&area(&[SQUARE, HOLE], FillRule::NonZero), &along_x(0.5)).unwrap();
    assert_eq!(odd, against);
    assert_eq!(odd.len(), 2, "to the left of the hole and to the right");
    assert_eq!(with.len(), 1);
}

#[test]
fn neighbours_share_a_grid() {
    let right = [(10.0, 3.3), (20.0, 3.3), (20.0, 8.1), (10.0, 8.1)];
    let heights = |corners: &[(f64, f64)]| -> Vec<f64> {
        let strokes = hatch(&area(&[corners], FillRule::NonZero), &along_x(0.7)).unwrap();
        strokes
            .iter()
            .flat_map(|s| s.points.iter().map(|p| p.y))
            .collect()
    };
    let left = heights(SQUARE);
    assert!(heights(&right).iter().all(|y| left.contains(y)));
}

#[test]
fn crossed_lines_run_at_a_right_angle_to_the_first() {
    let crossed = Hatch {
        cross: true,
        ..along_x(2.0)
    };
    let strokes = hatch(&area(&[SQUARE], FillRule::NonZero), &crossed).unwrap();
    assert_eq!(strokes.len(), 2);
    let first = |i: usize| strokes[i].points[1] - strokes[i].points[0];
    assert_eq!(first(0).dot(first(1)), 0.0);
}

#[test]
fn separate_lines_are_the_same_lines_as_individual_strokes() {
    let ringed = area(&[SQUARE, HOLE], FillRule::EvenOdd);
    let apart = Hatch {
        apart: true,
        ..along_x(1.0)
    };
    let strokes = hatch(&ringed, &apart).unwrap();
    assert!(strokes.iter().all(|stroke| stroke.points.len() == 2));
    let level = |strokes: &[Stroke]| -> f64 {
        let segments = strokes.iter().flat_map(Stroke::segments);
        let level = segments.filter(|(a, b)| (a.y - b.y).abs() < 1e-9);
        level.map(|(a, b)| a.distance(b)).sum()
    };
    let joined = hatch(&ringed, &along_x(1.0)).unwrap();
    assert!(joined.len() < strokes.len());
    assert!((level(&joined) - length_mm(&strokes)).abs() < 1e-9);
}

fn wound(style: HatchStyle, spacing_mm: f64) -> Hatch {
    Hatch {
        style,
        ..along_x(spacing_mm)
    }
}

/// Returns the distance of a point from the nearest line.
fn far_from(strokes: &[Stroke], p: Point) -> f64 {
    let pieces = strokes.iter().flat_map(Stroke::segments);
    let far2 = pieces.map(|(a, b)| Line::new(a, b).nearest(p, 0.0).distance_sq);
    far2.fold(f64::INFINITY, f64::min).sqrt()
}

#[test]
fn concentric_lines_are_insets_of_the_outline() {
    let settings = wound(HatchStyle::Concentric, 1.0);
    let strokes = hatch(&area(&[SQUARE], FillRule::NonZero), &settings).unwrap();
    let mut lengths: Vec<f64> = strokes
        .iter()
        .map(|stroke| stroke.length_mm().round())
        .collect();
    lengths.sort_by(f64::total_cmp);
    assert_eq!(lengths, [8.0, 16.0, 24.0, 32.0]);
    assert!(strokes.iter().all(|stroke| stroke.closed));
}

#[test]
fn concentric_lines_go_around_holes_and_start_at_the_inset() {
    let settings = Hatch {
        inset_mm: 0.25,
        ..wound(HatchStyle::Concentric, 0.5)
    };
    let ringed = area(&[SQUARE, HOLE], FillRule::EvenOdd);
    let strokes = hatch(&ringed, &settings).unwrap();
    let bounds = dobot_geometry::bounds_of_strokes(&strokes);
    assert!((bounds.x0 - 0.25).abs() < 1e-3 && (bounds.x1 - 9.75).abs() < 1e-3);
    for p in strokes.iter().flat_map(|stroke| &stroke.points) {
        // Corners are rounded.
        let beside = |at: f64| (3.0 - at).max(at - 7.0).max(0.0);
        assert!(beside(p.x).hypot(beside(p.y)) > 0.24, "{p:?}");
    }
    // 0.25, 0.75, 1.25: at the closest point of the hole, three millimetres hold three lines on
    // each side.
    assert!(strokes.len() >= 6, "{}", strokes.len());
}

#[test]
fn a_spiral_fills_a_square_in_one_stroke_without_gaps() {
    let settings = wound(HatchStyle::Spiral, 1.0);
    let square = area(&[SQUARE], FillRule::NonZero);
    let strokes = hatch(&square, &settings).unwrap();
    assert_eq!(strokes.len(), 1);
    for p in &strokes[0].points {
        assert!(holds(&square, *p), "{p:?}");
    }
    for x in 1..20 {
        for y in 1..20 {
            let p = Point::new(f64::from(x) * 0.5, f64::from(y) * 0.5);
            let far_mm = far_from(&strokes, p);
            assert!(far_mm <= 1.05, "{far_mm} mm at {p:?}");
        }
    }
}

#[test]
fn a_winding_hatch_with_too_many_corners_is_refused() {
    let teeth = (0..40_000).map(|i| (f64::from(i) * 0.005, f64::from(i % 2) * 20.0));
    let teeth: Vec<(f64, f64)> = teeth.chain([(200.0, 100.0), (0.0, 100.0)]).collect();
    let error = hatch(
        &area(&[&teeth], FillRule::NonZero),
        &wound(HatchStyle::Spiral, 0.1),
    );
    let error = error.unwrap_err().to_string();
    assert!(error.contains("choose a wider spacing"), "{error}");
}

#[test]
fn an_inset_keeps_the_lines_away_from_the_border() {
    let inset = Hatch {
        inset_mm: 0.8,
        ..along_x(0.5)
    };
    let strokes = hatch(&area(&[SQUARE, HOLE], FillRule::EvenOdd), &inset).unwrap();
    let bounds = dobot_geometry::bounds_of_strokes(&strokes);
    assert!((bounds.x0 - 0.8).abs() < 1e-9 && (bounds.x1 - 9.2).abs() < 1e-9);
    assert!(bounds.y0 >= 0.8 && bounds.y1 <= 9.2);
    let corners = strokes.iter().flat_map(|s| &s.points);
    let nearest = corners.map(|p| (p.x - 5.0).abs().max((p.y - 5.0).abs()) - 2.0);
    assert!(nearest.fold(f64::INFINITY, f64::min) > 0.5);
}

#[test]
fn a_shape_without_an_inside_has_no_lines() {
    let degenerate: [&[(f64, f64)]; 4] = [
        &[],
        &[(1.0, 1.0)],
        &[(1.0, 1.0), (5.0, 4.0)],
        &[(0.0, 0.5), (5.0, 0.5), (9.0, 0.5)],
    ];
    for corners in degenerate {
        let strokes = hatch(&area(&[corners], FillRule::NonZero), &along_x(0.5)).unwrap();
        assert_eq!(strokes, [], "{corners:?}");
    }
}

#[test]
fn invalid_numbers_are_refused() {
    let square = area(&[SQUARE], FillRule::NonZero);
    for spacing_mm in [0.0, 0.049, -1.0, f64::NAN, f64::INFINITY] {
        let error = hatch(&square, &along_x(spacing_mm)).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!(
                "the spacing of the hatch is {spacing_mm} mm; it must be a number from 0.05 mm up"
            )
        );
    }
    let nowhere = area(
        &[&[(0.0, 0.0), (f64::NAN, 1.0), (2.0, 2.0)]],
        FillRule::EvenOdd,
    );
    let error = hatch(&nowhere, &along_x(1.0)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a corner of the area is NaN, 1; both must be finite numbers"
    );
    let turned = Hatch {
        angle_deg: f64::NAN,
        ..along_x(1.0)
    };
    assert_eq!(
        hatch(&square, &turned).unwrap_err().to_string(),
        "the angle of the hatch is NaN degrees; it must be a number"
    );
}

#[test]
fn more_lines_than_memory_holds_are_refused() {
    let huge = area(&[&[(0.0, 0.0), (1e9, 0.0), (1e9, 1e9)]], FillRule::NonZero);
    let error = hatch(&huge, &along_x(0.05)).unwrap_err();
    assert!(matches!(error, HatchError::TooMany { .. }), "{error}");
}

#[test]
fn an_area_whose_border_crosses_itself_too_often_is_hatched_with_lines_only() {
    let area = Area {
        rings: vec![tangle()],
        rule: FillRule::NonZero,
    };
    for style in [HatchStyle::Concentric, HatchStyle::Spiral] {
        let concentric = Hatch {
            style,
            ..along_x(2.0)
        };
        assert_eq!(hatch(&area, &concentric), Err(HatchError::Entangled));
    }
    assert!(hatch(&area, &along_x(2.0)).is_ok_and(|lines| !lines.is_empty()));
}

/// Corners on a coarse grid, where edges meet lines and each other in degenerate ways, or anywhere.
fn rings() -> impl Strategy<Value = Vec<Vec<Point>>> {
    let coarse = (0..9_i32, 0..9_i32).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
    let fine = (0.0..9.0_f64, 0.0..9.0_f64).prop_map(|(x, y)| Point::new(x, y));
    let ring = prop_oneof![
        proptest::collection::vec(coarse, 0..8),
        proptest::collection::vec(fine, 0..8)
    ];
    proptest::collection::vec(ring, 1..4)
}

fn rules() -> impl Strategy<Value = FillRule> {
    prop_oneof![Just(FillRule::NonZero), Just(FillRule::EvenOdd)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn all_ink_is_inside(
        rings in rings(),
        rule in rules(),
        angle_deg in prop_oneof![Just(0.0), Just(90.0), Just(45.0), -360.0..360.0_f64],
        spacing_mm in prop_oneof![Just(0.5), Just(2.0), 0.1..2.0_f64],
        inset_mm in prop_oneof![Just(0.0), Just(0.3), 0.0..1.0_f64],
    ) {
        let area = Area { rings, rule };
        let settings = Hatch { angle_deg, inset_mm, ..along_x(spacing_mm) };
        for (a, b) in hatch(&area, &settings).unwrap().iter().flat_map(Stroke::segments) {
            for p in steps(a, b, 0.02) {
                prop_assert!(holds(&area, p), "{p:?} of {a:?} to {b:?}");
            }
        }
    }

    #[test]
    fn the_length_of_the_lines_measures_the_area(
        corners in proptest::collection::vec((0.0..9.0_f64, 0.0..9.0_f64), 3..4),
        angle_deg in 0.0..360.0_f64,
    ) {
        let triangle = ring(&corners);
        let (one, other) = (triangle[1] - triangle[0], triangle[2] - triangle[0]);
        let size = one.cross(other).abs() / 2.0;
        let area = Area { rings: vec![triangle.clone()], rule: FillRule::NonZero };
        let settings = Hatch { angle_deg, ..along_x(0.05) };
        let back = direction(-angle_deg);
        let strokes = hatch(&area, &settings).unwrap();
        let lines = strokes.iter().flat_map(|s| s.points.chunks(2));
        let mut length = 0.0;
        for line in lines {
            let [a, b] = [line[0], line[1]].map(|p| p.to_vec2().rotate_scale(back).to_point());
            // On the grid: half a spacing off its multiples.
            let off = (a.y / 0.05 - 0.5).rem_euclid(1.0);
            prop_assert!((a.y - b.y).abs() < 1e-9 && off.min(1.0 - off) < 1e-6);
            length += a.distance(b);
        }
        let border: f64 = (0..3).map(|i| triangle[i].distance(triangle[(i + 1) % 3])).sum();
        prop_assert!((length * 0.05 - size).abs() <= border * 0.05, "{length} {size}");
    }

    #[test]
    fn a_winding_hatch_stays_inside(
        corners in prop::collection::vec((0.0..30.0_f64, 0.0..30.0_f64), 3..9),
        spiral in any::<bool>(),
        even_odd in any::<bool>(),
        spacing_mm in 0.3..3.0_f64,
    ) {
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let area = area(&[&corners], rule);
        let style = if spiral { HatchStyle::Spiral } else { HatchStyle::Concentric };
        for stroke in hatch(&area, &wound(style, spacing_mm)).unwrap() {
            for p in stroke.points {
                prop_assert!(holds(&area, p) || far_from(&outlines(&area), p) < 1e-3, "{p:?}");
            }
        }
    }
}

fn outlines(area: &Area) -> Vec<Stroke> {
    let closed = |ring: &Vec<Point>| ring.iter().chain(ring.first()).copied().collect();
    area.rings
        .iter()
        .map(|ring| Stroke::open(closed(ring)))
        .collect()
}

#[test]
fn the_hatching_of_one_area_can_be_cancelled_at_any_line() {
    let square = area(&[SQUARE], FillRule::NonZero);
    for style in [
        HatchStyle::Lines,
        HatchStyle::Concentric,
        HatchStyle::Spiral,
    ] {
        let fine = Hatch {
            style,
            ..along_x(0.05)
        };
        // 200 lines, or 100 rings.
        for checks in [0, 1, 10, 90] {
            let hatched = hatch_until(&square, &fine, &CancelToken::after_checks(checks));
            let cancelled = Err(HatchError::Cancelled(Cancelled));
            assert_eq!(hatched, cancelled, "{style:?}, {checks}");
        }
    }
}
