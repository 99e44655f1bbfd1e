#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use super::*;
use dobot_geometry::{Stroke, bounds_of_strokes};
use dobot_plan::{ArmLimits, DrawingTool, Pass};

fn place(placement: &Placement, stroke: Stroke) -> Result<(Vec<Stroke>, f64), PlaceError> {
    let layer = Layer {
        strokes: vec![stroke],
        ..Layer::default()
    };
    let artwork = Artwork {
        layers: vec![layer],
        ..Artwork::default()
    };
    let placed = placement.place(artwork)?;
    Ok((placed.layers[0].strokes.clone(), placed.scale))
}

fn line(points: &[(f64, f64)]) -> Stroke {
    Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
}

#[test]
fn right_on_the_sheet_is_to_the_right_of_the_arm_and_down_is_towards_it() {
    let sheet = line(&[(0.0, 0.0), (20.0, 0.0), (20.0, 10.0)]);
    let placed = place(&Placement::default(), sheet).unwrap();
    // The centre of the area is x 210, y 0.
    let expected = line(&[(215.0, 10.0), (215.0, -10.0), (205.0, -10.0)]);
    assert_eq!(placed, (vec![expected], 1.0));
}

#[test]
fn fitting_scales_up_and_down_and_keeps_the_aspect() {
    let fit = Placement {
        size: Size::Fit,
        ..Placement::default()
    };
    let wide = place(&fit, line(&[(0.0, 0.0), (400.0, 10.0)])).unwrap();
    assert_eq!(wide.1, 0.5);
    let small = place(&fit, line(&[(0.0, 0.0), (10.0, 10.0)])).unwrap();
    assert_eq!(small.1, 12.0);
    assert_eq!(
        bounds_of_strokes(&small.0).origin(),
        Point::new(150.0, -60.0)
    );
    let dot = place(&fit, line(&[(7.0, 7.0)])).unwrap();
    assert_eq!(dot.0, [line(&[(210.0, 0.0)])]);
}

#[test]
fn a_drawing_limited_to_the_area_shrinks_but_never_grows() {
    let within = Placement {
        size: Size::Within,
        ..Placement::default()
    };
    for (width, scale) in [(400.0, 0.5), (100.0, 1.0)] {
        let placed = place(&within, line(&[(0.0, 0.0), (width, 10.0)])).unwrap();
        assert_eq!(placed.1, scale);
    }
}

#[test]
fn a_drawing_larger_than_the_area_is_refused_with_both_sizes() {
    let wide = line(&[(0.0, 0.0), (400.0, 10.0)]);
    let error = place(&Placement::default(), wide).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the drawing is 400.0 x 10.0 mm, and the arm reaches all of 200.0 x 5.0 mm; \
         make it smaller"
    );
}

#[test]
fn a_quarter_turn_counterclockwise_makes_right_up() {
    let turned = Placement {
        rotate_deg: 90.0,
        ..Placement::default()
    };
    // Up on the paper is away from the arm: +X.
    let (strokes, _) = place(&turned, line(&[(0.0, 0.0), (20.0, 0.0)])).unwrap();
    assert_eq!(strokes, [line(&[(200.0, 0.0), (220.0, 0.0)])]);
    let endless = Placement {
        rotate_deg: f64::INFINITY,
        ..Placement::default()
    };
    let error = place(&endless, line(&[(0.0, 0.0), (20.0, 0.0)])).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the rotation is inf degrees; it must be a finite number"
    );
}

#[test]
fn a_margin_stays_empty_and_must_leave_room() {
    let within = |margin_mm| Placement {
        margin_mm,
        size: Size::Fit,
        ..Placement::default()
    };
    let square = || line(&[(0.0, 0.0), (10.0, 10.0)]);
    let (strokes, scale) = place(&within(10.0), square()).unwrap();
    assert_eq!(scale, 10.0);
    assert_eq!(
        bounds_of_strokes(&strokes).origin(),
        Point::new(160.0, -50.0)
    );
    for margin_mm in [-1.0, 60.0, f64::NAN] {
        let error = place(&within(margin_mm), square()).unwrap_err();
        let expected = format!("the margin is {margin_mm} mm; it must be from 0 to below 60 mm");
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn a_scale_must_be_a_number_above_0() {
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let placement = Placement {
            size: Size::Scaled(factor),
            ..Placement::default()
        };
        let error = place(&placement, line(&[(0.0, 0.0), (4.0, 1.0)])).unwrap_err();
        assert!(error.to_string().starts_with("the scale is "));
    }
}

#[test]
fn a_straight_line_through_the_hole_around_the_base_is_detected() {
    let paper = Paper::default();
    let ends_fine = [line(&[(0.0, 150.0), (0.0, -150.0)])];
    let pass = Pass::new(DrawingTool::default(), ends_fine.to_vec());
    let plan = Plan::new(&[pass], &paper, &ArmLimits::default()).unwrap();
    let reachable = |p: Position| {
        if p.reach().0 < 129.0 {
            Err("too near")
        } else {
            Ok(())
        }
    };
    let error = check_reach(&plan, &paper, reachable).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("the pen cannot reach x 0.0, y 1"),
        "{error}"
    );
    assert!(
        error
            .to_string()
            .contains("mm: too near; make the drawing smaller")
    );
    check_reach(&plan, &paper, |_| Ok::<(), String>(())).unwrap();
}

#[test]
fn a_path_through_the_hole_around_the_base_is_distinguished_from_a_line_through_it() {
    let dots = [
        line(&[(0.0, 150.0), (1.0, 150.0)]),
        line(&[(0.0, -150.0), (1.0, -150.0)]),
    ];
    let pass = Pass::new(DrawingTool::default(), dots.to_vec());
    let paper = Paper::default();
    let plan = Plan::new(&[pass], &paper, &ArmLimits::default()).unwrap();
    let reachable = |p: Position| {
        let near = p.reach().0 < 129.0;
        if near { Err("too near") } else { Ok(()) }
    };
    let error = check_reach(&plan, &paper, reachable)
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("the travel between two strokes passes through x "),
        "{error}"
    );
    assert!(
        error.contains("mm: too near; place the drawing farther"),
        "{error}"
    );
}

#[test]
fn a_place_beyond_reach_is_reported_as_a_place_and_not_as_a_path_for_any_travel_of_the_pen() {
    let lines = [
        line(&[(200.0, 0.0), (210.0, 0.0)]),
        line(&[(330.0, 0.0), (210.0, 20.0)]),
    ];
    let pass = Pass::new(DrawingTool::default(), lines.to_vec());
    let paper = Paper::default();
    let plan = Plan::new(&[pass], &paper, &ArmLimits::default()).unwrap();
    let error = check_reach(&plan, &paper, within_320).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("the pen cannot reach x 330.0, y 0.0"),
        "{error}"
    );
}

#[test]
fn a_laser_whose_acceleration_distance_is_out_of_reach_is_reported_to_burn_slower() {
    // At 100 mm/s the run-up takes some 55 mm.
    let laser = |burn_speed_mm_s| {
        DrawingTool::Laser(dobot_plan::Laser {
            burn_speed_mm_s,
            ..dobot_plan::Laser::default()
        })
    };
    let paper = Paper::default();
    let check = |speed_mm_s, ends: [(f64, f64); 2]| {
        let pass = Pass::new(laser(speed_mm_s), vec![line(&ends)]);
        let plan = Plan::new(&[pass], &paper, &ArmLimits::default()).unwrap();
        check_reach(&plan, &paper, within_320)
    };
    let inwards = [(290.0, 0.0), (250.0, 0.0)];
    let outwards = [inwards[1], inwards[0]];
    for ends in [inwards, outwards] {
        let error = check(100.0, ends).unwrap_err();
        assert!(
            matches!(error, PlaceError::RunOutOfReach { x_mm, .. } if x_mm > 320.0),
            "{error}"
        );
        check(20.0, ends).unwrap();
    }
    // If the line itself is out of reach, no speed helps.
    for ends in [[(250.0, 0.0), (330.0, 0.0)], [(330.0, 0.0), (250.0, 0.0)]] {
        let error = check(20.0, ends).unwrap_err();
        assert!(matches!(error, PlaceError::OutOfReach { .. }), "{error}");
    }
}

fn within_320(p: Position) -> Result<(), &'static str> {
    if p.reach().0 > 320.0 {
        Err("too far")
    } else {
        Ok(())
    }
}

/// Returns a page with ink in one corner.
fn page(width_mm: f64, height_mm: f64) -> Artwork {
    let layer = Layer {
        strokes: vec![line(&[(5.0, 5.0), (15.0, 10.0)])],
        ..Layer::default()
    };
    Artwork {
        width_mm,
        height_mm,
        has_page: true,
        layers: vec![layer],
        ..Artwork::default()
    }
}

fn on_a5(change: impl FnOnce(&mut Placement)) -> Placement {
    let size: crate::PaperSize = "a5".parse().unwrap();
    let sheet = SheetPlace::centered(size.landscape(), Point::new(225.0, 0.0));
    let mut placement = Placement {
        sheet: Some(sheet),
        size: Size::Within,
        ..Placement::default()
    };
    change(&mut placement);
    placement
}

fn first(placement: &Placement, artwork: Artwork) -> (Point, f64) {
    let placed = placement.place(artwork).unwrap();
    let p = placed.layers[0].strokes[0].points[0];
    let rounded = |mm: f64| (mm * 1e6).round() / 1e6;
    (Point::new(rounded(p.x), rounded(p.y)), placed.scale)
}

#[test]
fn a_page_full_of_ink_keeps_its_corner_and_ink_without_a_page_is_centred() {
    let frame = |has_page: bool| {
        let corners = [
            (0.0, 0.0),
            (40.0, 0.0),
            (40.0, 20.0),
            (0.0, 20.0),
            (0.0, 0.0),
        ];
        let layer = Layer {
            strokes: vec![line(&corners)],
            ..Layer::default()
        };
        let artwork = Artwork {
            width_mm: 40.0,
            height_mm: 20.0,
            has_page,
            layers: vec![layer],
            ..Artwork::default()
        };
        let placed = on_a5(|_| ()).place(artwork).unwrap();
        let ink = bounds_of_strokes(&placed.layers[0].strokes);
        (ink.x1, ink.y1)
    };
    // The sheet is 210 mm wide and 148 mm high, centred at 225, 0: its upper left corner is at 299,
    // 105.
    assert_eq!(frame(true), (299.0, 105.0));
    assert_eq!(frame(false), (235.0, 20.0));
}

#[test]
fn a_page_keeps_its_corner_on_the_sheet() {
    // The sheet's upper left corner is at x 299, y 105.
    let corner = (Point::new(294.0, 100.0), 1.0);
    assert_eq!(first(&on_a5(|_| {}), page(210.0, 148.0)), corner);
    assert_eq!(first(&on_a5(|_| {}), page(85.0, 54.0)), corner);
    let margin = on_a5(|placement| placement.margin_mm = 10.0);
    assert_eq!(first(&margin, page(85.0, 54.0)).0, Point::new(284.0, 90.0));
    // A page larger than the sheet is fitted and stays in the corner.
    let half = first(&on_a5(|_| {}), page(420.0, 148.0));
    assert_eq!(half, (Point::new(296.5, 102.5), 0.5));
    // The right edge of the mirrored page is its left one.
    let mirrored = on_a5(|placement| placement.mirrors = true);
    assert_eq!(
        first(&mirrored, page(85.0, 54.0)).0,
        Point::new(294.0, 25.0)
    );
}

#[test]
fn a_drawing_fitted_to_a_sheet_fills_it_with_its_ink() {
    let fitting = on_a5(|placement| {
        placement.size = Size::Fit;
        placement.margin_mm = 4.0;
    });
    // 10 x 5 mm of ink on 202 x 140 mm.
    let (at, scale) = first(&fitting, page(210.0, 148.0));
    assert_eq!((at, scale), (Point::new(275.5, 101.0), 20.2));
}

#[test]
fn a_drawing_larger_than_the_area_is_placed_within_reach() {
    let placement = Placement {
        reach: Some([130.0, 320.0]),
        ..Placement::default()
    };
    let sheet = line(&[(0.0, 0.0), (200.0, 138.0)]);
    let (strokes, scale) = place(&placement, sheet).unwrap();
    assert_eq!(scale, 1.0);
    let placed = bounds_of_strokes(&strokes);
    assert!(
        placed.x0 >= 130.0 && placed.x1.hypot(100.0) <= 320.0,
        "{placed:?}"
    );
    // A larger one becomes as large as possible.
    let within = Placement {
        size: Size::Within,
        ..placement
    };
    let (strokes, scale) = place(&within, line(&[(0.0, 0.0), (400.0, 400.0)])).unwrap();
    let placed = bounds_of_strokes(&strokes);
    assert!((placed.x0 - 130.0).abs() < 1e-6, "{placed:?}");
    assert!(
        (placed.x1.hypot(200.0 * scale) - 320.0).abs() < 1e-6,
        "{placed:?}"
    );
    let error = place(&placement, line(&[(0.0, 0.0), (400.0, 400.0)])).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("the arm reaches all of 177.5 x 177.5 mm"),
        "{error}"
    );
}
