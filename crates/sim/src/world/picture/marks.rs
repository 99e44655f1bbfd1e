//! Ink and burns.

use std::fmt::Write as _;

use dobot_geometry::Point;

use super::{INK, mix};
use crate::world::{Burn, Hole, ToolKind, WorldState};

/// All ink and all burns, from above.
pub(super) fn marks(state: &WorldState) -> String {
    let width_mm = match state.tool.kind {
        ToolKind::Pen { width_mm } => width_mm,
        _ => 0.5,
    };
    let mut svg = format!("<g stroke=\"{INK}\" stroke-width=\"{width_mm}\">\n");
    for stroke in &state.strokes {
        path(&mut svg, &stroke.points_mm, "");
    }
    svg += "</g>\n";
    for burn in &state.burns {
        scorch(&mut svg, burn);
    }
    for hole in &state.holes {
        char(&mut svg, hole);
    }
    svg
}

fn path(svg: &mut String, points: &[Point], style: &str) {
    let Some((first, rest)) = points.split_first() else {
        return;
    };
    let _ = write!(svg, "<path {style} d=\"M{:.3} {:.3}", -first.y, -first.x);
    for point in rest {
        let _ = write!(svg, "L{:.3} {:.3}", -point.y, -point.x);
    }
    // A dot is a line of no length with round ends.
    *svg += if rest.is_empty() {
        "h.001\"/>\n"
    } else {
        "\"/>\n"
    };
}

/// A burned line: the more energy for a millimetre, the darker and the wider.
fn scorch(svg: &mut String, burn: &Burn) {
    let share = (burn.dose_j_mm() / FAINT_J_MM).ln() / (BLACK_J_MM / FAINT_J_MM).ln();
    let share = if share.is_finite() { share } else { 1.0 };
    let width_mm = 0.35 + 0.55 * share.clamp(0.0, 1.0);
    let style = format!(r#"stroke="{}" stroke-width="{width_mm:.2}""#, brown(share));
    path(svg, &burn.points_mm, &style);
}

/// A burned hole: it grows, slower and slower, in a halo of scorched paper.
fn char(svg: &mut String, hole: &Hole) {
    let radius_mm = (0.3 + 0.45 * (hole.power_w * hole.time_s).sqrt()).clamp(0.3, 6.0);
    let (x, y) = (-hole.at_mm.y, -hole.at_mm.x);
    for (times, opacity) in [(2.2, 0.18), (1.6, 0.35), (1.0, 1.0)] {
        let _ = writeln!(
            svg,
            r#"<circle cx="{x:.3}" cy="{y:.3}" r="{:.2}" fill="{}" fill-opacity="{opacity}"/>"#,
            radius_mm * times,
            brown(if times > 1.0 { 0.5 } else { 1.0 })
        );
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
