//! The page under the lines: the paper, what the arm reaches, and how long 50 mm are.

use dobot_geometry::Rect;
use dobot_lettering::{Anchor, lettering};

use super::lines::area_on_picture;
use super::{MUTED, REACH_MM, unit};

/// The ring that the arm reaches, its base, and the drawing area.
pub(super) fn workspace(area: Rect, paper: Rect) -> String {
    let [near, far] = REACH_MM;
    let ring = format!(
        "M{far} 0A{far} {far} 0 1 0 -{far} 0A{far} {far} 0 1 0 {far} 0M{near} 0A{near} {near} 0 1 0 -{near} 0A{near} {near} 0 1 0 {near} 0"
    );
    let unit = unit(paper);
    let label = |reach: f64, below: f64| {
        let text = format!("reach {reach:.0} mm");
        lettering(&text, Anchor::Middle, 0.0, below * unit - reach, 1.7 * unit)
    };
    let labels = label(near, -2.2) + &label(far, 4.2);
    let area = area_on_picture(area);
    let area = frame(
        area,
        r##"fill="#fffefb" stroke="#9fb3c2" stroke-width="0.25" stroke-dasharray="2 1.4""##,
        1.0,
    );
    format!(
        r##"<path d="{ring}" fill="#e9f0f3" fill-rule="evenodd" stroke="#9fb3c2" stroke-width="0.4"/>
{area}<g stroke="#7d8f9b" stroke-width="0.5"><circle r="38" fill="#dfe6ea"/><circle r="22" fill="#f3f6f7"/><path d="M-5 0H5M0 -5V5"/></g><g stroke="{MUTED}" stroke-width="0.75">{labels}</g>
"##
    )
}

pub(super) fn frame(bounds: Rect, style: &str, radius: f64) -> String {
    format!(
        "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" rx=\"{radius}\" {style}/>\n",
        bounds.x0,
        bounds.y0,
        bounds.width(),
        bounds.height()
    )
}

pub(super) fn scale_bar(paper: Rect) -> String {
    let unit = unit(paper);
    let (x, y) = (paper.x1 - 50.0 - 6.0 * unit, paper.y1 - 5.5 * unit);
    let label = lettering(
        "50 mm",
        Anchor::Middle,
        x + 25.0,
        y - 2.0 * unit,
        1.9 * unit,
    );
    let tick = 1.2 * unit;
    format!(
        r#"<g stroke="{MUTED}" stroke-width="0.35"><path d="M{x:.2} {:.2}v{tick:.2}h50v-{tick:.2}"/><g stroke-width="0.75">{label}</g></g>
"#,
        y - tick
    )
}
