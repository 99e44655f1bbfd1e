//! Common parts of all pictures of the arm's table: paper on a background, in millimetres. Text
//! scales with a `unit`, which grows with the page.

use crate::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};

impl Sheet {
    /// Creates a sheet with only the background.
    #[must_use]
    pub fn with_background(page: Rectangle) -> Self {
        let mut sheet = Self::new(page, "mm");
        sheet.rect(&page, 0.0, &ShapeStyle::area(BACKGROUND));
        sheet
    }

    /// Draws paper with the content of `draw` clipped to its edges.
    pub fn paper(&mut self, frame: &Rectangle, radius: f64, draw: impl FnOnce(&mut Self)) {
        self.rect(frame, radius, &ShapeStyle::area(PAPER));
        self.clipped(frame, radius, draw);
        self.rect(frame, radius, &ShapeStyle::line("#c9c3b4", 0.3));
    }

    /// Draws the reach of the arm around its axis: the smallest and the largest radius. Each label
    /// is placed the given number of units below its arc.
    pub fn reach(&mut self, [near, far]: [f64; 2], labels: [f64; 2], unit: f64) {
        let arcs = |r: f64| format!("M{r} 0A{r} {r} 0 1 0 -{r} 0A{r} {r} 0 1 0 {r} 0");
        let style = ShapeStyle::area("#e9f0f3").edged("#9fb3c2", 0.4);
        self.path(&(arcs(far) + &arcs(near)), &style);
        for (reach, below) in [near, far].into_iter().zip(labels) {
            let words = format!("reach {reach:.0} mm");
            let kind = TextStyle::new(1.5 * unit, MUTED);
            self.text([0.0, below * unit - reach], Anchor::Middle, &kind, &words);
        }
    }

    /// Draws a scale bar of 50 mm with its right end at a point.
    pub fn scale_bar(&mut self, [right, y]: [f64; 2], long: f64, unit: f64) {
        let (left, top) = (right - long, y - 1.2 * unit);
        let bar = [[left, top], [left, y], [right, y], [right, top]];
        self.curve(&bar, &ShapeStyle::line(MUTED, 0.16 * unit));
        let middle = [right - long / 2.0, y - 2.0 * unit];
        self.text(
            middle,
            Anchor::Middle,
            &TextStyle::new(1.7 * unit, MUTED),
            "50 mm",
        );
    }

    /// Writes names and values below a paper.
    pub fn figures<N: AsRef<str>>(&mut self, [x, y]: [f64; 2], all: &[(N, String)], unit: f64) {
        let (names, figures) = (
            TextStyle::new(1.7 * unit, MUTED),
            TextStyle::new(2.6 * unit, INK),
        );
        let mut x = x;
        for (name, figure) in all {
            let name = name.as_ref();
            self.text([x, y + 6.0 * unit], Anchor::Left, &names, name);
            self.text([x, y + 11.2 * unit], Anchor::Left, &figures, figure);
            x += names.width(name).max(figures.width(figure)) + 7.0 * unit;
        }
    }
}

/// The background colour.
const BACKGROUND: &str = "#f4f1e9";
/// The colour of paper.
pub const PAPER: &str = "#fffefb";
/// The colour of ink and important text.
pub const INK: &str = "#1b2a41";
/// The colour of secondary text.
pub const MUTED: &str = "#75838d";
