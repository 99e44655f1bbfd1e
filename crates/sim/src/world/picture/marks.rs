//! Ink and burns.

use dobot_lettering::{ShapeStyle, Sheet};

use dobot_geometry::Point;

use super::{INK, mix};
use crate::world::{Burn, Hole, ToolAction, WorldState};

/// All ink and all burns, from above.
pub(super) fn marks(sheet: &mut Sheet, state: &WorldState) {
    let width_mm = match state.tool.action {
        ToolAction::Pen { width_mm } => width_mm,
        _ => 0.5,
    };
    let strokes = state.strokes.iter().map(|it| seen(&it.points_mm));
    sheet.curves(strokes, &ShapeStyle::line(INK, width_mm));
    for burn in &state.burns {
        scorch(sheet, burn);
    }
    for hole in &state.holes {
        char(sheet, hole);
    }
}

fn seen(points: &[Point]) -> impl Iterator<Item = [f64; 2]> {
    points.iter().map(|it| [-it.y, -it.x])
}

/// A burned line: the more energy for a millimetre, the darker and the wider.
fn scorch(sheet: &mut Sheet, burn: &Burn) {
    let share = (burn.dose_j_mm() / FAINT_J_MM).ln() / (BLACK_J_MM / FAINT_J_MM).ln();
    let share = if share.is_finite() { share } else { 1.0 };
    let width_mm = 0.35 + 0.55 * share.clamp(0.0, 1.0);
    let points: Vec<_> = seen(&burn.points_mm).collect();
    sheet.curve(&points, &ShapeStyle::line(&brown(share), width_mm));
}

/// A burned hole: it grows, slower and slower, in a halo of scorched paper.
fn char(sheet: &mut Sheet, hole: &Hole) {
    let radius_mm = (0.3 + 0.45 * (hole.power_w * hole.time_s).sqrt()).clamp(0.3, 6.0);
    let at = [-hole.at_mm.y, -hole.at_mm.x];
    for (times, share, opacity) in [(2.2, 0.5, 0.18), (1.6, 0.5, 0.35), (1.0, 1.0, 1.0)] {
        let color = brown(share);
        let look = ShapeStyle::area(&color).faded(opacity);
        sheet.circle(at, radius_mm * times, &look);
    }
}

fn brown(share: f64) -> String {
    if share < 0.5 {
        mix([226.0, 190.0, 140.0], [139.0, 84.0, 40.0], share * 2.0)
    } else {
        mix([139.0, 84.0, 40.0], [28.0, 18.0, 12.0], share * 2.0 - 1.0)
    }
}

/// Half a watt at 100 mm/s and at 1 mm/s.
const FAINT_J_MM: f64 = 0.005;
const BLACK_J_MM: f64 = 0.5;
