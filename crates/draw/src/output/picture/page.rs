//! The page below the lines: reach, base and drawing area.

use dobot_geometry::{Point, Rect, steps};
use dobot_lettering::{Rectangle, ShapeStyle, Sheet, paper_style};

use super::REACH_MM;
use super::lines::{area_on_picture, seen};
use crate::layout::sheet::SheetPlace;

/// Draws the reachable ring, the base, and the drawing area or the sheet.
pub(super) fn workspace(sheet: &mut Sheet, area: Rect, place: Option<&SheetPlace>, unit: f64) {
    sheet.reach(REACH_MM, [-2.2, 4.2], unit);
    if let Some(place) = place {
        drawn_on(sheet, place);
    } else {
        let area = area_on_picture(area);
        let look = ShapeStyle::area(paper_style::PAPER).edged("#9fb3c2", 0.25);
        sheet.rect(&frame(area), 1.0, &look.dashed("2 1.4"));
    }
    for (radius, color) in [(38.0, "#dfe6ea"), (22.0, "#f3f6f7")] {
        let look = ShapeStyle::area(color).edged("#7d8f9b", 0.5);
        sheet.circle([0.0, 0.0], radius, &look);
    }
    sheet.path("M-5 0H5M0 -5V5", &ShapeStyle::line("#7d8f9b", 0.5));
}

/// Draws the sheet, striped where it is out of reach.
fn drawn_on(sheet: &mut Sheet, place: &SheetPlace) {
    let corners = place.corners();
    let edges: Vec<[f64; 2]> = seen(&corners).collect();
    sheet.area(&edges, &ShapeStyle::area("#ffffff").edged("#7d8f9b", 0.4));
    let stripes = stripes(place);
    let stripes = stripes.iter().map(|stripe| seen(stripe));
    sheet.curves(stripes, &ShapeStyle::line("#d98880", 0.35));
}

/// Returns lines across a sheet where it is out of reach.
fn stripes(place: &SheetPlace) -> Vec<Vec<Point>> {
    let [near, far] = REACH_MM;
    let reached = |p: &Point| (near..=far).contains(&p.to_vec2().length());
    let mut stripes = Vec::new();
    let mut down_mm = STRIPES_MM / 2.0;
    while down_mm < place.size.height_mm {
        let [from, to] = [0.0, place.size.width_mm].map(|x| place.place(Point::new(x, down_mm)));
        let places: Vec<Point> = steps(from, to, 0.5).collect();
        let pieces = places.split(reached).filter(|piece| piece.len() > 1);
        stripes.extend(pieces.map(|piece| vec![piece[0], piece[piece.len() - 1]]));
        down_mm += STRIPES_MM;
    }
    stripes
}

const STRIPES_MM: f64 = 3.0;

pub(super) fn frame(bounds: Rect) -> Rectangle {
    let Rect { x0, y0, x1, y1 } = bounds;
    Rectangle::between([x0, y0], [x1, y1])
}
