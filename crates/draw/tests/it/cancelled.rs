//! Tests of cancelled preparations.

use dobot_controller::Personality;
use dobot_draw::{CancelToken, Hatch, PrepareError, Settings, prepare};
use dobot_geometry::{Point, Stroke};
use dobot_import::Source;
use dobot_plan::{ArmLimits, DrawingTool, Laser, Paper, Pass, Plan, PlanError};

/// Letters: closed shapes with holes, to hatch, order and plan.
fn drawing() -> Source {
    let ring = |i: u32| {
        let (x, y) = (5 + 9 * (i % 10), 5 + 9 * (i / 10));
        format!(r#"<path d="M{x} {y}h7v7h-7zm2 2q2 1 3 0v3h-3z" fill="black" stroke="black"/>"#)
    };
    let rings: String = (0..20).map(ring).collect();
    let page = r#"<svg xmlns="http://www.w3.org/2000/svg" width="99mm" height="60mm" viewBox="0 0 99 60">"#;
    Source::from(format!("{page}{rings}</svg>").as_str())
}

/// Prepares the drawing with a token that is cancelled after this many checks.
fn prepared(personality: Personality, tool: DrawingTool, count: usize) -> Option<PrepareError> {
    let settings = Settings {
        arm_limits: ArmLimits::of(personality.dialect()),
        tool,
        hatch: Some(Hatch::default()),
        tries: Some(100),
        cancel: CancelToken::after_checks(count),
        ..Settings::default()
    };
    let anywhere = |_| Ok::<(), String>(());
    prepare(&drawing(), &settings, anywhere).err()
}

#[test]
fn a_preparation_ends_at_whichever_check_it_is_cancelled() {
    for personality in Personality::ALL {
        for tool in [DrawingTool::default(), DrawingTool::Laser(Laser::default())] {
            for count in [0, 1, 3, 10, 30, 100, 300] {
                let end = prepared(personality, tool, count);
                let is_cancelled = end == Some(PrepareError::Cancelled);
                assert!(is_cancelled, "{personality:?}, {tool:?}, {count}: {end:?}");
            }
        }
    }
}

#[test]
fn a_plan_of_one_long_stroke_ends_soon_after_it_is_cancelled() {
    let corner = |i: u32| Point::new(180.0 + f64::from(i % 90), f64::from(i % 7));
    let stroke = Stroke::open((0..500).map(corner).collect());
    for personality in Personality::ALL {
        for tool in [DrawingTool::default(), DrawingTool::Laser(Laser::default())] {
            let passes = [Pass::new(tool, vec![stroke.clone()])];
            let arm_limits = ArmLimits::of(personality.dialect());
            for count in [0, 1, 3] {
                let cancel = CancelToken::after_checks(count);
                let planned = Plan::new_until(&passes, &Paper::default(), &arm_limits, &cancel);
                let is_cancelled = matches!(planned, Err(PlanError::Cancelled(_)));
                assert!(is_cancelled, "{personality:?}, {tool:?}, {count} checks");
            }
        }
    }
}
