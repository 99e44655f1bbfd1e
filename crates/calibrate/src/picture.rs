//! A picture of the residuals.

use std::fmt::Write;

use crate::sheet::{HIGH_MM, WIDE_MM, on_sheet};
use crate::{Fit, Touch};

/// Draws the sheet, A4 landscape, with an arrow from each point to its calibrated position, forty
/// times enlarged. A touch that was left out is red and has a cross.
#[must_use]
pub fn residuals_svg(touches: &[Touch], fit: &Fit) -> String {
    let mut svg = format!(
        concat!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="0 0 {w} {h}">"#,
            r#"<rect width="{w}" height="{h}" fill="white"/>"#,
            r#"<g font-family="sans-serif" font-size="4" stroke-width="0.6" stroke-linecap="round">"#,
            r#"<text x="10" y="12">touches and where the calibration has them, {l} times as far apart</text>"#,
            r#"<path d="M10 18h{bar}m0 -1.5v3m-{bar} 0v-3" stroke="black" fill="none"/><text x="{after}" y="19.5">1 mm</text>"#,
        ),
        w = WIDE_MM,
        h = HIGH_MM,
        l = LARGER,
        bar = LARGER,
        after = 10.0 + LARGER + 3.0,
    );
    for (index, touch) in touches.iter().enumerate() {
        let [dx, dy, dz] = fit.residuals_mm.get(index).copied().unwrap_or_default();
        let [right, down] = on_sheet(touch.place_mm);
        // Keep the arrow on the sheet.
        let [to_right, to_down] = [
            (right - LARGER * dy).clamp(2.0, WIDE_MM - 2.0),
            (down - LARGER * dx).clamp(2.0, HIGH_MM - 2.0),
        ];
        let is_left_out = fit.left_out.contains(&index);
        let color = if is_left_out { "#c0392b" } else { "#1f5fbf" };
        let cross = if is_left_out { CROSS } else { "" };
        let _ = write!(
            svg,
            concat!(
                r#"<g transform="translate({right:.2} {down:.2})"><circle r="1.2" fill="none" stroke="black"/>{cross}</g>"#,
                r#"<path d="M{right:.2} {down:.2}L{to_right:.2} {to_down:.2}" stroke="{color}"/>"#,
                r#"<circle cx="{to_right:.2}" cy="{to_down:.2}" r="1" fill="{color}"/>"#,
                r##"<text x="{text:.2}" y="{below:.2}" stroke="white" stroke-width="1" paint-order="stroke">{number}: {away:.2} mm, {dz:+.2} in height</text>"##,
            ),
            right = right,
            down = down,
            cross = cross,
            to_right = to_right,
            to_down = to_down,
            color = color,
            text = right - 14.0,
            below = down + 8.0,
            number = index + 1,
            away = dx.hypot(dy),
            dz = dz,
        );
    }
    svg.push_str("</g></svg>\n");
    svg
}

const CROSS: &str = r##"<path d="M-3 -3L3 3M3 -3L-3 3" stroke="#c0392b" fill="none"/>"##;
/// The enlargement of residuals in the picture.
const LARGER: f64 = 40.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_arm::{Calibration, Position, Tool};

    use super::*;
    use crate::{SHEET_POINTS, fit};

    #[test]
    fn an_excluded_touch_is_marked_in_the_picture() {
        let arm = Calibration {
            rear_deg: 4.0,
            ..Calibration::NONE
        };
        let mut touches = SHEET_POINTS.map(|[x, y]| {
            let there = Position::new(x, y, -40.0);
            let raw = arm.raw_joints(there, Tool::SuctionCup).unwrap();
            Touch {
                place_mm: [x, y],
                height_mm: 0.0,
                raw,
            }
        });
        let good = residuals_svg(&touches, &fit(&touches, Tool::SuctionCup).unwrap());
        assert!(!good.contains(CROSS) && good.contains("9: 0.0"), "{good}");
        touches[4].place_mm[0] += 12.0;
        let fit = fit(&touches, Tool::SuctionCup).unwrap();
        assert_eq!(fit.left_out, [4]);
        assert!(residuals_svg(&touches, &fit).contains(CROSS));
    }
}
