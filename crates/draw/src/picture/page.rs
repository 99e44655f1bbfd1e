//! The page under the lines: what the arm reaches, its base, and the drawing area.

use dobot_geometry::Rect;
use dobot_lettering::{Rectangle, ShapeStyle, Sheet, desk};

use super::REACH_MM;
use super::lines::area_on_picture;

/// The ring that the arm reaches, its base, and the drawing area.
pub(super) fn workspace(sheet: &mut Sheet, area: Rect, unit: f64) {
    sheet.reach(REACH_MM, [-2.2, 4.2], unit);
    let area = area_on_picture(area);
    let look = ShapeStyle::area(desk::PAPER).edged("#9fb3c2", 0.25);
    sheet.rect(&frame(area), 1.0, &look.dashed("2 1.4"));
    for (radius, color) in [(38.0, "#dfe6ea"), (22.0, "#f3f6f7")] {
        let look = ShapeStyle::area(color).edged("#7d8f9b", 0.5);
        sheet.circle([0.0, 0.0], radius, &look);
    }
    sheet.path("M-5 0H5M0 -5V5", &ShapeStyle::line("#7d8f9b", 0.5));
}

pub(super) fn frame(bounds: Rect) -> Rectangle {
    let Rect { x0, y0, x1, y1 } = bounds;
    Rectangle::between([x0, y0], [x1, y1])
}
