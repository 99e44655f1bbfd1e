//! `cargo run -p dobot-examples --example arm_time`
//!
//! Plans curves of many kinds and prints a table of drawing times with their lower bounds,
//! deviations from the curve and accelerations, for several speeds, accelerations and arms.
//! Arguments, each optional: tolerance in mm, name of the curves. The ratio is to the larger bound
//! of each stroke.

use std::error::Error;
use std::time::Instant;

use dobot_draw::{Settings, prepare_passes, simplify};
use dobot_geometry::{PathDistance, Stroke, deviation, steps};
use dobot_plan::{ArmLimits, ChainVector, DrawingTool, MoveKind, Pass, Plan, acceleration};

mod curves;

use curves::Curves;

fn main() -> Result<(), Box<dyn Error>> {
    let mut tolerance_mm = 0.05;
    let mut name = None;
    for argument in std::env::args().skip(1) {
        match argument.parse() {
            Ok(given) => tolerance_mm = given,
            Err(_) => name = Some(argument),
        }
    }
    println!(
        "| curves | mm/s² | mm/s | optimum | link | arm | ours | ratio | vectors | mean off | most off | acceleration | planned in |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    let all = curves::all();
    for curves in all
        .iter()
        .filter(|curves| name.as_ref().is_none_or(|name| name == curves.name))
    {
        for (acceleration_mm_s2, speed_mm_s) in CASES {
            let case = Case {
                tolerance_mm,
                acceleration_mm_s2,
                speed_mm_s,
            };
            case.print(curves)?;
        }
    }
    Ok(())
}

/// The requested speed and acceleration.
struct Case {
    tolerance_mm: f64,
    acceleration_mm_s2: f64,
    speed_mm_s: f64,
}

impl Case {
    fn print(&self, curves: &Curves) -> Result<(), Box<dyn Error>> {
        let optima_s: Vec<f64> = curves
            .meant
            .iter()
            .map(|curve| self.optimum_s(curve))
            .collect();
        let links_s: Vec<f64> = curves
            .given
            .iter()
            .map(|curve| self.link_s(curve))
            .collect();
        let both = optima_s.iter().zip(&links_s);
        let bound_s: f64 = both.map(|(optimum_s, link_s)| optimum_s.max(*link_s)).sum();
        for (arm, has_ticks) in [("even", false), ("stock", true)] {
            println!(
                "| {} | {} | {} | {:.1} s | {:.1} s | {arm} | {}",
                curves.name,
                self.acceleration_mm_s2,
                self.speed_mm_s,
                optima_s.iter().sum::<f64>(),
                links_s.iter().sum::<f64>(),
                self.drawn(curves, has_ticks, bound_s)?
            );
        }
        Ok(())
    }

    /// Plans the curves for an arm.
    fn drawn(
        &self,
        curves: &Curves,
        has_ticks: bool,
        bound_s: f64,
    ) -> Result<String, Box<dyn Error>> {
        let settings = self.settings(has_ticks);
        let pass = Pass::new(settings.tool, curves.given.clone());
        let begin = Instant::now();
        let plan = prepare_passes(vec![pass], &settings, |_| Ok::<(), String>(()))?.plan;
        let took_s = begin.elapsed().as_secs_f64();
        let draws = plan
            .moves
            .iter()
            .filter(|motion| motion.kind == MoveKind::Draw);
        let drawn_s: f64 = draws.clone().map(|draw| f64::from(draw.duration_s)).sum();
        let (mean_mm, largest_mm) = off(&curves.given, &plan);
        Ok(format!(
            "{drawn_s:.1} s | {:.3} | {} | {mean_mm:.4} mm | {largest_mm:.4} mm | {:.3} | {:.0} ms |",
            drawn_s / bound_s,
            draws.count(),
            acceleration(&plan, settings.arm_limits.cornering().window_s) / self.acceleration_mm_s2,
            1e3 * took_s
        ))
    }

    fn settings(&self, has_ticks: bool) -> Settings {
        Settings {
            tolerance_mm: self.tolerance_mm,
            arm_limits: ArmLimits {
                acceleration_mm_s2: self.acceleration_mm_s2,
                corner_deviation_mm: 2.0 * self.tolerance_mm,
                // Only the curve is measured, not its position relative to the arm.
                joint_speed_deg_s: 10_000.0,
                has_ticks,
                ..ArmLimits::default()
            },
            tool: DrawingTool::default().at_speed(self.speed_mm_s),
            ..Settings::default()
        }
    }

    /// Returns the time of the fastest motion along the curve itself, in s: it has so many points
    /// that arcs between them are the curve.
    fn optimum_s(&self, curve: &Stroke) -> f64 {
        let chain: Vec<ChainVector> = curve
            .segments()
            .filter(|(a, b)| a != b)
            .map(|(a, b)| ChainVector::of([b.x - a.x, b.y - a.y, 0.0], self.speed_mm_s))
            .collect();
        let cornering = self.settings(false).arm_limits.cornering();
        cornering.durations_s(&chain).iter().sum()
    }

    /// Returns the time that the link takes for the fewest vectors, in s.
    fn link_s(&self, stroke: &Stroke) -> f64 {
        let fewest = simplify(stroke, FEWEST_SHARE * self.tolerance_mm);
        #[expect(clippy::cast_precision_loss, reason = "some thousands")]
        let vectors = (fewest.points.len() - 1) as f64;
        vectors * ArmLimits::default().link.period_s
    }
}

/// Returns the mean and maximum deviation of a plan, in mm.
fn off(wanted: &[Stroke], plan: &Plan) -> (f64, f64) {
    let drawn = plan.paths(MoveKind::Draw);
    let mut wanted_path = PathDistance::new(wanted);
    let points = drawn
        .iter()
        .flat_map(Stroke::segments)
        .flat_map(|(a, b)| steps(a, b, 0.05));
    let (sum, count) = points.fold((0.0, 0.0), |(sum, count), p| {
        (sum + wanted_path.distance_mm(p), count + 1.0)
    });
    (sum / count, deviation(wanted, &drawn).largest_mm())
}

/// Accelerations in mm/s², each with a speed in mm/s.
const CASES: [(f64, f64); 5] = [
    (100.0, 40.0),
    (100.0, 80.0),
    (200.0, 60.0),
    (200.0, 100.0),
    (200.0, 200.0),
];
/// The remaining share is for reading curves.
const FEWEST_SHARE: f64 = 0.9;
