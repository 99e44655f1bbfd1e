#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use super::*;
use crate::layout::frame::{FrameShape, frame};
use crate::layout::place::{Placement, Size};
use crate::strokes::cutting::Cutting;
use crate::strokes::hatch::{Hatch, HatchStyle};
use crate::strokes::shapes::tangle;
use dobot_api::{Backlash, CalibrationFile};
use dobot_geometry::{Random, Vec2, deviation};
use dobot_plan::{ArmLimits, DurationEstimator, Laser, MoveKind};

const EXAMPLES: [&str; 3] = [
    include_str!("../../../../examples/drawings/harbour.svg"),
    include_str!("../../../../examples/drawings/rosette.svg"),
    include_str!("../../../../examples/drawings/square.svg"),
];

fn file(name: &str, bytes: Vec<u8>) -> Source {
    Source::of_file(name, bytes).unwrap()
}

fn anywhere(p: Position) -> Result<(), &'static str> {
    if p.is_finite() {
        Ok(())
    } else {
        Err("nowhere")
    }
}

fn in_reach(p: Position) -> Result<(), String> {
    let reach = p.reach().0;
    if (129.0..=321.0).contains(&reach) {
        Ok(())
    } else {
        Err(format!("reach is {reach}"))
    }
}

#[test]
fn the_examples_are_planned_within_tolerance_and_reach() {
    for svg in EXAMPLES {
        let prepared = prepare(&svg.into(), &Settings::default(), in_reach).unwrap();
        let planned = prepared.plan.paths(MoveKind::Draw);
        let worst = deviation(&prepared.wanted(), &planned);
        assert!(worst.largest_mm() <= 0.045 + 1e-5, "{worst:?}");
        assert_eq!(prepared.warnings, []);
    }
}

#[test]
fn a_laser_burns_within_tolerance_and_nothing_shorter_than_its_spot() {
    let tool = DrawingTool::Laser(Laser {
        burn_speed_mm_s: 3.0,
        ..Laser::default()
    });
    let settings = Settings {
        tool,
        ..Settings::default()
    };
    // The last vector of an arc has any length.
    let arc = |radius: f64, count: u32| -> Vec<Point> {
        let at = |i: u32| Vec2::from_angle(f64::from(i) * 0.1 / radius) * radius;
        (0..count).map(|i| at(i).to_point()).collect()
    };
    for i in 0..200_u32 {
        let line = arc(1.0 + f64::from(i % 7), 20 + i);
        let prepared = prepare(&Source::Lines(vec![line]), &settings, in_reach).unwrap();
        let burned = prepared.plan.paths(MoveKind::Burn);
        let worst = deviation(&prepared.wanted(), &burned);
        assert!(worst.largest_mm() <= 0.05, "{i}: {worst:?}");
    }
}

#[test]
fn a_laser_burns_within_a_fine_tolerance_along_steps_of_any_length() {
    let tool = DrawingTool::Laser(Laser {
        burn_speed_mm_s: 3.0,
        ..Laser::default()
    });
    let mut random = Random::new(5);
    for i in 0..300 {
        let settings = Settings {
            tool,
            tolerance_mm: if i % 2 == 0 { 0.05 } else { 0.025 },
            ..Settings::default()
        };
        // Up and down in steps of 0.02 to 0.4 mm between lines of 2 mm, like serifs and teeth.
        let mut at = Point::ORIGIN;
        let mut line = vec![at];
        for n in 0..9 {
            let step_mm = 0.02 + 0.38 * random.share();
            let side = if n % 2 == 0 { 1.0 } else { -1.0 };
            for way in [Vec2::new(2.0, 0.0), Vec2::new(0.0, side * step_mm)] {
                at += way;
                line.push(at);
            }
        }
        at += Vec2::new(2.0, 0.0);
        line.push(at);
        let prepared = prepare(&Source::Lines(vec![line]), &settings, in_reach).unwrap();
        let burned = prepared.plan.paths(MoveKind::Burn);
        let worst = deviation(&prepared.wanted(), &burned);
        assert!(
            worst.largest_mm() <= settings.tolerance_mm,
            "{i}: {worst:?}"
        );
    }
}

/// A circle of 30 mm, visually not a polygon.
fn round() -> Stroke {
    let at = |i: u32| Vec2::from_angle(std::f64::consts::TAU * f64::from(i % 5000) / 5000.0);
    let points = (0..=5000).map(|i| Point::new(220.0, 0.0) + at(i) * 30.0);
    Stroke {
        points: points.collect(),
        closed: true,
    }
}

/// 100 mm/s2 and no joint limits.
fn at_80_mm_s(has_ticks: bool) -> Settings {
    Settings {
        tool: DrawingTool::default().at_speed(80.0),
        arm_limits: ArmLimits {
            acceleration_mm_s2: 100.0,
            joint_speed_deg_s: 10_000.0,
            has_ticks,
            ..ArmLimits::default()
        },
        ..Settings::default()
    }
}

#[test]
fn a_circle_is_drawn_almost_as_fast_as_the_fastest_motion_along_it() {
    // At v2 = a r the circle takes 2 pi sqrt(r / a); at both ends the acceleration turns from along
    // the circle to across it, which takes pi / 4 of that radian twice: the speed grows as the sine
    // of twice the angle.
    let optimum_s = {
        let settings = at_80_mm_s(false);
        let estimator = DurationEstimator::of(&settings.arm_limits, &settings.tool);
        let circle = round();
        let ways = circle.segments().map(|(a, b)| [b.x - a.x, b.y - a.y, 0.0]);
        estimator.durations_s(ways).iter().sum::<f64>()
    };
    let at_full_speed_s = std::f64::consts::TAU * (30.0_f64 / 100.0).sqrt();
    assert!(
        (at_full_speed_s..at_full_speed_s + 0.6).contains(&optimum_s),
        "{optimum_s}"
    );
    for (has_ticks, most) in [(false, 1.02), (true, 1.05)] {
        let settings = at_80_mm_s(has_ticks);
        let pass = Pass::new(settings.tool, vec![round()]);
        let plan = prepare_passes(vec![pass], &settings, anywhere)
            .unwrap()
            .plan;
        let draws = plan
            .moves
            .iter()
            .filter(|vector| vector.kind == MoveKind::Draw);
        let drawn_s: f64 = draws.map(|vector| f64::from(vector.duration_s)).sum();
        assert!(
            drawn_s <= most * optimum_s,
            "{drawn_s} instead of {optimum_s} s"
        );
        let seen = dobot_plan::acceleration(&plan, 0.08);
        assert!(seen <= 103.0, "{seen} mm/s2");
    }
}

#[test]
fn an_enlarged_drawing_keeps_the_tolerance() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="2mm" height="2mm" viewBox="0 0 2 2">
        <path d="M0 2C0 0 2 0 2 2" stroke="red" fill="none"/></svg>"#;
    let mut settings = Settings::default();
    settings.placement.size = Size::Fit;
    let prepared = prepare(&svg.into(), &settings, anywhere).unwrap();
    assert!((prepared.scale - 80.0).abs() < 0.1, "{}", prepared.scale);
    // The curve is 2 mm wide and 1.5 mm high, its top at t = 1/2; the area is 120 mm deep.
    let top = prepared.wanted()[0]
        .points
        .iter()
        .fold(0.0, |top: f64, p| top.max(p.x));
    assert!((top - 270.0).abs() < 0.01, "{top}");
    let planned = prepared.plan.paths(MoveKind::Draw);
    assert!(deviation(&prepared.wanted(), &planned).largest_mm() <= 0.0451);
    assert!(prepared.wanted()[0].points.len() > 60);
}

#[test]
fn a_plan_in_metres_is_read_with_the_precision_of_its_size_on_the_paper() {
    // Arcs of 100 m, whose 70,000 corners at 5 micrometres would be needed sixty times.
    let arcs = (0..60).map(|i| format!("0 ARC 8 0 10 {i} 20 0 40 100 50 0 51 359 "));
    let arcs: Vec<String> = arcs.collect();
    let arcs = arcs.concat().replace(' ', "\n");
    let dxf = format!(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n\
         0\nSECTION\n2\nENTITIES\n{arcs}0\nENDSEC\n0\nEOF\n"
    );
    let mut settings = Settings::default();
    settings.placement.size = Size::Within;
    settings.tries = None;
    let prepared = prepare(&file("a.dxf", dxf.into_bytes()), &settings, in_reach).unwrap();
    let planned = prepared.plan.paths(MoveKind::Draw);
    let worst = deviation(&prepared.wanted(), &planned);
    assert!(worst.largest_mm() <= 0.0451, "{worst:?}");
    let corners: usize = prepared
        .wanted()
        .iter()
        .map(|stroke| stroke.points.len())
        .sum();
    // A circle of some 75 mm radius within 5 micrometres: 272 each.
    assert!((60 * 200..60 * 350).contains(&corners), "{corners}");
}

#[test]
fn a_drawing_of_many_colours_drawn_as_one_has_none_of_them() {
    let svg = |colors: [&str; 2]| {
        let lines = colors.map(|color| format!(r#"<path d="M5 5H25V9" stroke="{color}"/>"#));
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
            <g fill="none">{}</g></svg>"#,
            lines.concat()
        )
    };
    let pass = |colors| {
        let svg = svg(colors);
        let prepared = prepare(&svg.as_str().into(), &Settings::default(), anywhere).unwrap();
        assert_eq!(prepared.passes.len(), 1);
        let pass = &prepared.passes[0];
        (pass.name.clone(), pass.color.is_some())
    };
    assert_eq!(pass(["red", "blue"]), (String::new(), false));
    assert_eq!(pass(["red", "red"]), ("red".to_owned(), true));
}

#[test]
fn in_a_material_that_is_cut_through_inner_shapes_are_cut_first() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80">
        <g fill="none" stroke="red"><rect x="10" y="10" width="100" height="60"/><circle cx="30" cy="30" r="8"/>
        <circle cx="80" cy="40" r="12"/><rect x="45" y="20" width="15" height="15"/></g></svg>"#;
    let laser = |cuts| {
        DrawingTool::Laser(Laser {
            cuts,
            ..Laser::default()
        })
    };
    let lengths = |cuts| {
        let settings = Settings {
            tool: laser(cuts),
            ..Settings::default()
        };
        let wanted = prepare(&svg.into(), &settings, anywhere).unwrap().wanted();
        wanted
            .iter()
            .map(|stroke| stroke.length_mm().round())
            .collect::<Vec<f64>>()
    };
    assert_eq!(lengths(true).last(), Some(&320.0));
    // An engraving may use the shortest path.
    assert_ne!(lengths(false).last(), Some(&320.0));
}

#[test]
fn a_hole_on_its_own_layer_is_cut_as_a_hole_and_engravings_are_unchanged() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80"><g fill="none">
        <rect x="10" y="10" width="100" height="60" stroke="red"/><rect x="30" y="30" width="20" height="20" stroke="blue"/>
        <rect x="60" y="30" width="20" height="20" stroke="black"/></g></svg>"#;
    let laser = |cuts| {
        DrawingTool::Laser(Laser {
            cuts,
            ..Laser::default()
        })
    };
    let settings = Settings {
        tool: laser(true),
        tools: vec![("black".to_owned(), laser(false))],
        layers: Some(dobot_import::LayersBy::Color),
        cutting: Cutting {
            kerf_mm: 0.4,
            ..Cutting::default()
        },
        ..Settings::default()
    };
    let prepared = prepare(&svg.into(), &settings, anywhere).unwrap();
    let found = prepared.passes.iter().map(|pass| {
        let [stroke] = &pass.strokes[..] else {
            panic!("one shape each");
        };
        let width = dobot_geometry::bounds(stroke.points.iter().copied()).height();
        (pass.name.as_str(), (10.0 * width).round() / 10.0)
    });
    // Inner shapes come before the parts they would fall out of.
    let wanted = [("black", 20.0), ("blue", 19.6), ("red", 100.4)];
    assert_eq!(found.collect::<Vec<_>>(), wanted);
}

#[test]
fn the_rings_of_a_hatching_are_neither_parts_nor_holes_and_are_burned_before_the_cut() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80">
        <rect x="10" y="10" width="40" height="40" fill="black" stroke="black"/></svg>"#;
    let laser = DrawingTool::Laser(Laser {
        cuts: true,
        ..Laser::default()
    });
    let settings = Settings {
        tool: laser,
        hatch: Some(Hatch {
            style: HatchStyle::Concentric,
            spacing_mm: 4.0,
            ..Hatch::default()
        }),
        cutting: Cutting {
            kerf_mm: 0.4,
            tabs: 2,
            tab_mm: 1.0,
            ..Cutting::default()
        },
        ..Settings::default()
    };
    let wanted = prepare(&svg.into(), &settings, anywhere).unwrap().wanted();
    let (rings, cut) = wanted.split_at(wanted.len() - 2);
    let mut rings_mm: Vec<f64> = rings.iter().map(|ring| ring.length_mm().round()).collect();
    rings_mm.sort_by(f64::total_cmp);
    assert_eq!(rings_mm, [32.0, 64.0, 96.0, 128.0]);
    for half in cut {
        assert!(
            (half.length_mm() - (80.0 + 0.2 * std::f64::consts::PI - 1.4)).abs() < 0.01,
            "{half:?}"
        );
    }
}

#[test]
fn an_area_that_cannot_be_hatched_concentrically_is_hatched_with_lines() {
    let corners = tangle().into_iter().map(|p| format!(" {},{}", p.x, p.y));
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="80mm" viewBox="0 0 90 80">
        <polygon points="{}"/></svg>"#,
        corners.collect::<String>()
    );
    let settings = Settings {
        hatch: Some(Hatch {
            style: HatchStyle::Spiral,
            spacing_mm: 10.0,
            ..Hatch::default()
        }),
        ..Settings::default()
    };
    let prepared = prepare(&svg.as_str().into(), &settings, anywhere).unwrap();
    let texts: Vec<String> = prepared.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        texts,
        ["1 area: hatched with lines, because its edge crosses itself too often"]
    );
}

#[test]
fn parts_out_of_reach_are_cut_off_on_request_at_any_place() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="900mm" height="900mm" viewBox="0 0 900 900">
        <path d="M0 0L900 900M0 900L900 0" stroke="black"/></svg>"#;
    let mut settings = Settings::default();
    let error = prepare(&svg.into(), &settings, in_reach).unwrap_err();
    assert!(
        matches!(error, PrepareError::Place(PlaceError::TooLarge { .. })),
        "{error}"
    );
    settings.placement.clips = true;
    let prepared = prepare(&svg.into(), &settings, in_reach).unwrap();
    let texts: Vec<String> = prepared.warnings.iter().map(ToString::to_string).collect();
    assert!(texts.concat().contains("mm of its lines"), "{texts:?}");
    // Both lines cross in the middle of the area.
    let center = Placement::default().area.center();
    let near = |stroke: &Stroke| {
        stroke.segments().any(|(a, b)| {
            dobot_geometry::ParamCurveNearest::nearest(
                &dobot_geometry::Line::new(a, b),
                center,
                0.0,
            )
            .distance_sq
                < 0.01
        })
    };
    assert_eq!(
        prepared
            .wanted()
            .iter()
            .filter(|stroke| near(stroke))
            .count(),
        2
    );
}

#[test]
fn a_pen_draws_each_line_as_often_as_requested() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
        <g fill="none" stroke="red"><path d="M5 5H25"/><rect x="5" y="20" width="10" height="10"/></g></svg>"#;
    let settings = Settings {
        pen_passes: 3,
        ..Settings::default()
    };
    let summary = prepare(&svg.into(), &settings, anywhere)
        .unwrap()
        .plan
        .summary();
    assert_eq!(summary.strokes, 2);
    assert!(
        (summary.drawn_mm - 180.0).abs() < 0.01,
        "{}",
        summary.drawn_mm
    );
}

#[test]
fn any_number_of_passes_needs_no_more_travel_than_one() {
    let rows = (0..16).map(|row| format!("M10 {}H110", 10 + 4 * row));
    let rows = rows.collect::<Vec<_>>().concat();
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80"><path d="{rows}" stroke="red"/></svg>"#
    );
    for pen_passes in 1..=4 {
        let settings = Settings {
            pen_passes,
            ..Settings::default()
        };
        let prepared = prepare(&svg.as_str().into(), &settings, anywhere).unwrap();
        let summary = prepared.plan.summary();
        assert_eq!(summary.strokes, 16);
        assert!((summary.drawn_mm - 1600.0 * f64::from(pen_passes)).abs() < 0.01);
        let strokes = &prepared.passes[0].strokes;
        let between = strokes
            .windows(2)
            .map(|pair| pair[0].last().unwrap().distance(pair[1].points[0]));
        // 15 ways of 4 mm between 16 rows.
        let travel_mm: f64 = between.sum();
        assert!(
            (travel_mm - 60.0).abs() < 0.001,
            "{pen_passes} passes: {travel_mm} mm"
        );
    }
}

#[test]
fn the_single_line_of_a_picture_is_repeated_as_a_whole() {
    let dots = (0..9).map(|n| vec![Point::new(f64::from(n % 3) * 5.0, f64::from(n / 3) * 5.0)]);
    let source = Source::Lines(dots.collect());
    let drawn_mm = |pen_passes| {
        let settings = Settings {
            pen_passes,
            shading: dobot_import::Shading::new(dobot_import::ShadingStyle::Tsp),
            ..Settings::default()
        };
        let summary = prepare(&source, &settings, anywhere)
            .unwrap()
            .plan
            .summary();
        assert_eq!(summary.strokes, 1);
        summary.drawn_mm
    };
    assert!((drawn_mm(2) - 2.0 * drawn_mm(1)).abs() < 0.01);
}

#[test]
fn a_tolerance_too_fine_for_vectors_is_refused() {
    let settings = Settings {
        tolerance_mm: 0.01,
        ..Settings::default()
    };
    let error = prepare(&EXAMPLES[2].into(), &settings, anywhere).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the tolerance is 0.01 mm; it must be a number from 0.02 to 10 mm"
    );
}

#[test]
fn a_drawing_out_of_reach_is_refused() {
    let mut settings = Settings::default();
    settings.placement.center = Some(Point::new(320.0, 0.0));
    let error = prepare(&EXAMPLES[2].into(), &settings, in_reach).unwrap_err();
    assert!(
        matches!(error, PrepareError::Place(PlaceError::OutOfReach { .. })),
        "{error}"
    );
}

#[test]
fn a_drawing_larger_than_the_area_leaves_room_for_the_acceleration_of_a_laser() {
    let laser = DrawingTool::Laser(Laser {
        burn_speed_mm_s: 60.0,
        ..Laser::default()
    });
    // As deep as the reach: a line that begins and ends at its borders.
    let deep = |mm: f64| vec![Point::new(0.0, 0.0), Point::new(0.0, mm)];
    let settings = |tool| Settings {
        tool,
        placement: Placement {
            size: Size::Within,
            ..Placement::default()
        },
        ..Settings::default()
    };
    for tool in [laser, DrawingTool::default()] {
        let prepared = prepare(&Source::Lines(vec![deep(250.0)]), &settings(tool), in_reach);
        let drawn_mm = prepared.unwrap().plan.summary().drawn_mm;
        assert!((120.0..190.0).contains(&drawn_mm), "{drawn_mm} mm");
    }
}

#[test]
fn an_empty_result_is_reported_with_a_remedy() {
    let mut settings = Settings::default();
    settings.placement.clips = true;
    settings.placement.center = Some(Point::new(600.0, 0.0));
    let error = prepare(&EXAMPLES[2].into(), &settings, in_reach).unwrap_err();
    assert_eq!(error, PrepareError::AllCutOff);
    assert!(error.to_string().contains("place it elsewhere"), "{error}");
}

#[test]
fn a_line_along_the_border_of_the_reach_is_cut_so_that_its_vectors_stay_within() {
    // Arcs around the axis of the arm, and waves across the border at 321 mm from it.
    let arc = |radius: f64| move |_: f64| radius;
    let ways: [&dyn Fn(f64) -> f64; 4] =
        [&arc(320.99), &arc(320.96), &arc(129.01), &|angle: f64| {
            321.0 + (angle * 40.0).sin()
        }];
    for radius in ways {
        let line = (-200..=200).map(|i| {
            let angle = f64::from(i) / 400.0;
            Point::new(radius(angle) * angle.cos(), radius(angle) * angle.sin())
        });
        let line: Vec<Point> = line.collect();
        // On the page, x is to the right and y down: -Y and -X of the arm.
        let page = line.iter().map(|p| Point::new(-p.y, -p.x)).collect();
        let mut settings = Settings::default();
        settings.placement.clips = true;
        settings.placement.center = Some(dobot_geometry::bounds(line.iter().copied()).center());
        let prepared = prepare(&Source::Lines(vec![page]), &settings, in_reach);
        match prepared {
            Ok(prepared) => assert!(!prepared.warnings.is_empty()),
            Err(error) => assert_eq!(error, PrepareError::AllCutOff),
        }
    }
}

#[test]
fn a_clipped_drawing_leaves_room_for_acceleration_lead_ins_and_backlash() {
    let slack = CalibrationFile {
        backlash: Backlash {
            base: 0.2,
            rear: 0.3,
            fore: 0.3,
        },
        ..CalibrationFile::default()
    };
    let laser = DrawingTool::Laser(Laser {
        burn_speed_mm_s: 40.0,
        ..Laser::default()
    });
    let cutting = Cutting {
        kerf_mm: 0.4,
        lead_in_mm: 5.0,
        ..Cutting::default()
    };
    let cases = [
        Settings {
            tool: laser,
            ..Settings::default()
        },
        Settings {
            tool: laser,
            cutting,
            ..Settings::default()
        },
        Settings {
            calibration: Some(slack),
            ..Settings::default()
        },
    ];
    // Spokes across the outer border of the reach, alternately outwards and inwards, and rings
    // beside them.
    let spoke = |i: i32| {
        let way = Vec2::from_angle(f64::from(i) / 20.0);
        let ends = if i % 2 == 0 {
            [200.0, 350.0]
        } else {
            [350.0, 200.0]
        };
        ends.map(|mm| (way * mm).to_point()).to_vec()
    };
    let ring = |i: i32| {
        let middle = (Vec2::from_angle(f64::from(i) / 20.0) * 320.0).to_point();
        let corner = |angle: i32| middle + Vec2::from_angle(f64::from(angle)) * 12.0;
        let mut ring: Vec<Point> = (0..6).map(corner).collect();
        ring.push(ring[0]);
        ring
    };
    let lines: Vec<Vec<Point>> = (-15..=15).flat_map(|i| [spoke(i), ring(i)]).collect();
    let center = dobot_geometry::bounds(lines.iter().flatten().copied()).center();
    // On the page, x is to the right and y down: -Y and -X of the arm.
    let on_page = |line: &Vec<Point>| line.iter().map(|p| Point::new(-p.y, -p.x)).collect();
    let page: Vec<Vec<Point>> = lines.iter().map(on_page).collect();
    for mut settings in cases {
        settings.placement.clips = true;
        settings.placement.center = Some(center);
        let prepared = prepare(&Source::Lines(page.clone()), &settings, in_reach)
            .unwrap_or_else(|error| panic!("{error} with {settings:?}"));
        // Barely more than necessary is omitted.
        let drawn_mm: f64 = prepared.wanted().iter().map(Stroke::length_mm).sum();
        assert!(drawn_mm > 31.0 * 100.0, "{drawn_mm} mm");
    }
}

#[test]
fn a_given_speed_overrides_that_of_the_file_and_plotter_speeds_do_not_apply_to_a_laser() {
    let laser = DrawingTool::Laser(Laser {
        burn_speed_mm_s: 8.0,
        ..Laser::default()
    });
    let pen = DrawingTool::default().at_speed(40.0);
    let plotter = |speed: &str| {
        file(
            "a.plt",
            format!("SP1;VS{speed};PU0,0;PD2000,0;PU").into_bytes(),
        )
    };
    let mill = file(
        "a.nc",
        b"G0 Z5\nG0 X0 Y0\nG1 Z-1 F60\nG1 X50 F600\nG0 Z5".to_vec(),
    );
    let engraver = file("a.nc", b"G0 X0 Y0\nM3 S1000\nG1 X50 F1200\nM5".to_vec());
    let speed_mm_s = |source: &Source, tool: DrawingTool, keeps_speed: bool| {
        let settings = Settings {
            tool,
            keeps_speed,
            ..Settings::default()
        };
        let prepared = prepare(source, &settings, anywhere).unwrap();
        let texts = prepared.warnings.iter().map(ToString::to_string);
        let is_warned = texts
            .into_iter()
            .any(|text| text.contains("layer with the speed of a pen"));
        (prepared.passes[0].tool.speed_mm_s(), is_warned)
    };
    for (source, tool, expected) in [
        (plotter("1"), pen, (10.0, false)),
        (plotter("36"), pen, (40.0, false)),
        (plotter("1"), laser, (8.0, true)),
        (plotter("36"), laser, (8.0, true)),
        (mill.clone(), pen, (10.0, false)),
        (mill, laser, (8.0, true)),
        (engraver.clone(), laser, (20.0, false)),
        (engraver, pen, (20.0, false)),
    ] {
        assert_eq!(speed_mm_s(&source, tool, false), expected, "{source:?}");
        assert_eq!(speed_mm_s(&source, tool, true), (tool.speed_mm_s(), false));
    }
}

/// Spokes all around the arm, from -120 to 120 degrees, drawn from left to right and back.
fn spokes_around_the_arm() -> Vec<Stroke> {
    let spoke = |angle: i32| {
        let way = Vec2::from_angle(f64::from(angle).to_radians());
        Stroke::open([150.0, 300.0].map(|mm| (way * mm).to_point()).to_vec())
    };
    let angles = (0..12).flat_map(|i| [-120 + 20 * i, 120 - 20 * i]);
    angles.map(spoke).collect()
}

#[test]
fn travels_between_strokes_lead_around_the_arm_and_never_behind_it() {
    let laser = DrawingTool::Laser(Laser::default());
    for tool in [DrawingTool::default(), laser] {
        for has_ticks in [false, true] {
            let mut settings = Settings {
                tool,
                ..Settings::default()
            };
            settings.arm_limits.has_ticks = has_ticks;
            let pass = Pass::new(tool, spokes_around_the_arm());
            // The base turns by up to 135 degrees to either side.
            let reachable = |p: Position| {
                let turned_deg = p.y.0.atan2(p.x.0).to_degrees();
                if turned_deg.abs() > 135.0 {
                    return Err(format!("the base is at {turned_deg} degrees"));
                }
                in_reach(p)
            };
            let plan = prepare_passes(vec![pass], &settings, reachable)
                .unwrap()
                .plan;
            assert_eq!(plan.summary().strokes, 24);
            // From each spoke the arm moves around to the other side, by no longer path than
            // necessary.
            let around_mm = plan.summary().travelled_mm;
            assert!(
                (23.0 * 300.0..23.0 * 600.0).contains(&around_mm),
                "{around_mm} mm"
            );
        }
    }
}

#[test]
fn the_frame_of_a_drawing_around_the_arm_also_leads_around_it() {
    let settings = Settings::default();
    let pass = Pass::new(settings.tool, spokes_around_the_arm());
    let prepared = prepare_passes(vec![pass], &settings, in_reach).unwrap();
    let arm_limits = prepared.plan.arm_limits();
    let plan = frame(
        &prepared.passes,
        &settings.paper,
        arm_limits,
        FrameShape::Hull,
    )
    .unwrap();
    check_reach(&plan, &settings.paper, in_reach).unwrap();
}

#[test]
fn a_picture_much_larger_than_the_paper_is_hatched_at_the_requested_spacing() {
    // All black, with a white margin of the same width on the right.
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 4800, 1600);
    encoder.set_depth(png::BitDepth::One);
    let row = [[0; 300], [255; 300]].concat();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&row.repeat(1600)).unwrap();
    drop(writer);
    let mut settings = Settings::default();
    settings.placement.size = Size::Fit;
    settings.shading.levels = 1;
    settings.tries = None;
    let prepared = prepare(&Source::of_file("-", file).unwrap(), &settings, anywhere).unwrap();
    let wanted = prepared.wanted();
    let length_mm: f64 = wanted.iter().map(Stroke::length_mm).sum();
    // The ink is as deep as the area and 1.5 times as wide.
    let lines_mm = 120.0 * 180.0 / settings.shading.spacing_mm;
    assert!(
        (length_mm / lines_mm - 1.0).abs() < 0.06,
        "{length_mm} mm, not {lines_mm} mm"
    );
}

#[test]
fn stipples_become_one_line_without_a_lift() {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 200, 100);
    encoder.set_depth(png::BitDepth::One);
    let row = [[0; 12].as_slice(), &[255; 13]].concat();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&row.repeat(100)).unwrap();
    drop(writer);
    let mut settings = Settings::default();
    settings.placement.size = Size::Fit;
    settings.shading = dobot_import::Shading::new(dobot_import::ShadingStyle::Tsp);
    settings.shading.spacing_mm = 6.0;
    let prepared = prepare(&Source::of_file("-", file).unwrap(), &settings, anywhere).unwrap();
    let wanted = prepared.wanted();
    assert_eq!(wanted.len(), 1);
    // A good tour through points of this density is 0.7124 times the root of area and number.
    let points = wanted[0].points.len();
    let ink = dobot_geometry::bounds_of_strokes(&wanted);
    let tour_mm = 0.7124 * (ink.area() * f64::from(u32::try_from(points).unwrap())).sqrt();
    let length_mm = wanted[0].length_mm();
    assert!(
        points > 150 && length_mm < 1.6 * tour_mm,
        "{points} {length_mm} {tour_mm}"
    );
}

#[test]
fn layers_are_chosen_by_names_with_commas_between_them_or_in_them() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
        width="50mm" height="50mm" viewBox="0 0 50 50" fill="none" stroke="black">
        <g inkscape:groupmode="layer" inkscape:label="cut, outside"><path d="M5 5H25"/></g>
        <g inkscape:groupmode="layer" inkscape:label="cut"><path d="M5 15H25"/></g>
        <g inkscape:groupmode="layer" inkscape:label="text"><path d="M5 25H25"/></g></svg>"#;
    let chosen = |only: &[&str]| {
        let settings = Settings {
            layers: Some(dobot_import::LayersBy::Group),
            only: only.iter().map(|&name| name.to_owned()).collect(),
            ..Settings::default()
        };
        let prepared = prepare(&svg.into(), &settings, anywhere);
        let names =
            prepared.map(|prepared| prepared.passes.into_iter().map(|pass| pass.name).collect());
        names.map_err(|error| error.to_string())
    };
    let names = |names: &[&str]| -> Result<Vec<String>, String> {
        Ok(names.iter().map(|&name| name.to_owned()).collect())
    };
    assert_eq!(chosen(&["cut, outside"]), names(&["cut, outside"]));
    assert_eq!(chosen(&["text,cut"]), names(&["cut", "text"]));
    assert_eq!(
        chosen(&["text", "cut, outside"]),
        names(&["cut, outside", "text"])
    );
    let error = chosen(&["text,red"]).unwrap_err();
    assert!(error.contains("no layer \"red\""), "{error}");
}

#[test]
fn a_hole_is_cut_as_a_hole_even_if_its_part_is_cut_another_time() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80"><g fill="none">
        <rect x="10" y="10" width="100" height="60" stroke="red"/><rect x="30" y="30" width="20" height="20" stroke="blue"/>
        </g></svg>"#;
    let settings = Settings {
        tool: DrawingTool::Laser(Laser {
            cuts: true,
            ..Laser::default()
        }),
        layers: Some(dobot_import::LayersBy::Color),
        only: vec!["blue".to_owned()],
        cutting: Cutting {
            kerf_mm: 0.4,
            ..Cutting::default()
        },
        ..Settings::default()
    };
    let wanted = prepare(&svg.into(), &settings, anywhere).unwrap().wanted();
    let width_mm = dobot_geometry::bounds_of_strokes(&wanted).height();
    assert!((width_mm - 19.6).abs() < 0.01, "{width_mm}");
}

#[test]
fn an_outline_with_gaps_is_reported_with_a_remedy() {
    let side = |a: (f64, f64), b: (f64, f64)| vec![Point::from(a), Point::from(b)];
    let source = Source::Lines(vec![
        side((0.0, 0.0), (40.0, 0.0)),
        side((40.2, 0.0), (40.0, 30.0)),
        side((40.0, 30.0), (0.0, 30.0)),
        side((0.0, 30.3), (0.0, 0.0)),
        side((5.0, 5.0), (9.0, 5.0)),
    ]);
    let warning_of = |cuts, join_mm| {
        let settings = Settings {
            tool: DrawingTool::Laser(Laser {
                cuts,
                ..Laser::default()
            }),
            join_mm,
            ..Settings::default()
        };
        let warnings = prepare(&source, &settings, anywhere).unwrap().warnings;
        let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        texts.concat()
    };
    let warning = warning_of(true, None);
    assert!(
        warning.contains("1 open outline") && warning.contains("way.join 0.5"),
        "{warning}"
    );
    assert_eq!(warning_of(true, Some(0.5)), "");
    assert_eq!(warning_of(false, None), "");
    // Parallel lines, like the two sides of a road, are not outlines.
    let side_by_side = (0..40).map(|i| side((0.0, f64::from(i)), (40.0, f64::from(i))));
    let source = Source::Lines(side_by_side.collect());
    let settings = Settings {
        tool: DrawingTool::Laser(Laser {
            cuts: true,
            ..Laser::default()
        }),
        ..Settings::default()
    };
    assert_eq!(prepare(&source, &settings, anywhere).unwrap().warnings, []);
}

#[test]
fn lines_burned_slower_than_requested_are_reported_with_the_speed_at_which_they_are_even() {
    let ring = (0..=60).map(|i| Vec2::from_angle(f64::from(6 * i).to_radians()).to_point());
    let source = Source::Lines(vec![ring.collect()]);
    let warning_of = |burn_speed_mm_s| {
        let settings = Settings {
            tool: DrawingTool::Laser(Laser {
                burn_speed_mm_s,
                ..Laser::default()
            }),
            ..Settings::default()
        };
        let warnings = prepare(&source, &settings, anywhere).unwrap().warnings;
        warnings.iter().map(ToString::to_string).collect::<String>()
    };
    // Around a ring of 1 mm at 100 mm/s2: sqrt(100 * 1) = 10 mm/s, and less as a polygon.
    assert_eq!(warning_of(6.0), "");
    let warning = warning_of(30.0);
    assert!(
        warning.contains("1 layer burned slower: 6 of its 6 mm"),
        "{warning}"
    );
    let speed = warning
        .split("; at ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    let even_mm_s: f64 = speed.and_then(|speed| speed.parse().ok()).expect("a speed");
    assert!(even_mm_s > 6.0 && even_mm_s < 10.1, "{warning}");
    assert_eq!(warning_of(even_mm_s), "");
    // 1000 mm/min, as in a file.
    let warning = warning_of(1000.0 / 60.0);
    assert!(warning.contains(" instead of 16.7 mm/s,"), "{warning}");
}

#[test]
fn on_a_sheet_with_a_margin_nothing_is_drawn_in_the_margin() {
    use crate::layout::sheet::SheetPlace;
    let source = Source::Lines(vec![vec![Point::new(0.0, 0.0), Point::new(90.0, 0.0)]]);
    let sheet = SheetPlace::centered("80x60".parse().unwrap(), Point::new(230.0, 0.0));
    let mut settings = Settings::default();
    settings.placement.sheet = Some(sheet);
    settings.placement.margin_mm = 10.0;
    let error = prepare(&source, &settings, in_reach).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("15.0 mm beyond the margin of the sheet"),
        "{error}"
    );
    settings.placement.clips = true;
    for (margin_mm, left_mm) in [(10.0, 60.0), (0.0, 80.0)] {
        settings.placement.margin_mm = margin_mm;
        let wanted = prepare(&source, &settings, in_reach).unwrap().wanted();
        let width_mm = dobot_geometry::bounds_of_strokes(&wanted).height();
        assert!((width_mm - left_mm).abs() < 0.13, "{width_mm}");
    }
}

#[test]
fn a_hole_is_cut_before_the_outline_of_a_part_with_a_shared_edge() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80"><g fill="none" stroke="red">
        <rect x="10" y="10" width="20" height="20"/><rect x="30" y="10" width="20" height="20"/>
        <circle cx="20" cy="20" r="4"/><circle cx="40" cy="20" r="5"/></g></svg>"#;
    let settings = Settings {
        tool: DrawingTool::Laser(Laser {
            cuts: true,
            ..Laser::default()
        }),
        drops_duplicates: true,
        ..Settings::default()
    };
    let wanted = prepare(&svg.into(), &settings, anywhere).unwrap().wanted();
    let mut lengths: Vec<f64> = wanted
        .iter()
        .map(|stroke| stroke.length_mm().round())
        .collect();
    let edges = lengths.split_off(2);
    assert_eq!(edges.iter().sum::<f64>(), 140.0);
    lengths.sort_by(f64::total_cmp);
    assert_eq!(lengths, [25.0, 31.0]);
}

#[test]
fn a_pen_pauses_before_layers_and_keeps_to_the_speeds_that_the_file_asks_for() {
    let layer = |label: &str, content: &str| {
        format!(r#"<g i:groupmode="layer" i:label="{label}">{content}</g>"#)
    };
    let line = |y: u32| format!(r#"<path d="M0 {y}H40" stroke="black"/>"#);
    let layers = [
        layer("!first+S5", &line(1)),
        layer("+S5", &line(3)),
        // An area without hatching draws nothing.
        layer(
            "!empty",
            r#"<rect width="5" height="5" clip-path="url(#none)"/>"#,
        ),
        layer("later", &line(5)),
    ];
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:i="http://www.inkscape.org/namespaces/inkscape" width="50mm" height="9mm" viewBox="0 0 50 9"><clipPath id="none"/>{}</svg>"#,
        layers.concat()
    );
    let passes = |settings: &Settings| {
        let prepared = prepare(&svg.as_str().into(), settings, anywhere).unwrap();
        let of_pass = |pass: &Pass| (pass.message.clone(), pass.tool.speed_mm_s().round());
        prepared.passes.iter().map(of_pass).collect::<Vec<_>>()
    };
    let pause = |label: &str| {
        Some(format!(
            "the file asks for a pause before the layer {label:?}"
        ))
    };
    let usual_mm_s = Settings::default().tool.speed_mm_s().round();
    // 5 % of 221 mm/s.
    let expected = [
        (pause("!first+S5"), usual_mm_s),
        (None, 11.0),
        (pause("!empty"), usual_mm_s),
    ];
    assert_eq!(passes(&Settings::default()), expected);
    let own_speed = Settings {
        keeps_speed: true,
        ..Settings::default()
    };
    let expected = expected.map(|(message, _)| (message, usual_mm_s));
    assert_eq!(passes(&own_speed), expected);
}
