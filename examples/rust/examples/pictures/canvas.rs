//! Lines, arcs and texts in millimetres on a sheet.

use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};

/// A picture in the caller's units: x to the right, y up.
pub(crate) struct Canvas {
    sheet: Sheet,
    /// The caller's origin in pixels.
    origin: [f64; 2],
    /// Pixels per unit, right and up.
    scale: [f64; 2],
}

impl Canvas {
    pub(crate) fn new(width: u32, height: u32) -> Self {
        let page = Rectangle::between([0.0, 0.0], [width, height].map(f64::from));
        let mut sheet = Sheet::new(page, "px");
        sheet.rect(&page, 10.0, &ShapeStyle::area(PAPER));
        Self {
            sheet,
            origin: [0.0, 0.0],
            scale: [1.0, 1.0],
        }
    }

    /// Sets the origin (in pixels) and the scale of the following units.
    pub(crate) fn place(&mut self, origin: [f64; 2], scale: [f64; 2]) {
        (self.origin, self.scale) = (origin, scale);
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], look: &ShapeStyle<'_>) {
        self.path(&[from, to], look);
    }

    pub(crate) fn path(&mut self, points: &[[f64; 2]], look: &ShapeStyle<'_>) {
        self.sheet.curve(&self.pixels(points), look);
    }

    pub(crate) fn area(&mut self, points: &[[f64; 2]], color: &str) {
        self.sheet
            .area(&self.pixels(points), &ShapeStyle::area(color));
    }

    pub(crate) fn dot(&mut self, at: [f64; 2], radius_px: f64, fill: &str, edge: &str) {
        let look = ShapeStyle::area(fill).edged(edge, 2.5);
        self.sheet.circle(self.pixel(at), radius_px, &look);
    }

    /// An arrow from one point to another.
    pub(crate) fn arrow(&mut self, from: [f64; 2], to: [f64; 2], color: &str, width: f64) {
        self.line(from, to, &ShapeStyle::line(color, width));
        let [a, b] = [self.pixel(from), self.pixel(to)];
        self.head(b, (b[1] - a[1]).atan2(b[0] - a[0]), color);
    }

    /// A line with an arrow head at each end.
    pub(crate) fn measure(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.arrow(from, to, SOFT, 1.3);
        self.arrow(to, from, SOFT, 1.3);
    }

    /// An arc from one direction to another, with an arrow head at its end; angles in degrees,
    /// counter-clockwise from the right.
    pub(crate) fn angle(&mut self, around: [f64; 2], radius: f64, degrees: [f64; 2], color: &str) {
        let [from, to] = degrees;
        let points: Vec<_> = (0..=40)
            .map(|n| polar(around, radius, from + (to - from) * f64::from(n) / 40.0))
            .collect();
        self.path(&points, &ShapeStyle::line(color, 2.0));
        let ahead = to + 90.0_f64.copysign(to - from);
        // The head of a curved arrow follows the chord, not the tangent.
        let bend = (180.0 / std::f64::consts::PI * HEAD_PX / 2.0 / (radius * self.scale[0]))
            .copysign(to - from);
        self.head(self.pixel(points[40]), -(ahead - bend).to_radians(), color);
    }

    /// A text, vertically centred.
    pub(crate) fn text(&mut self, at: [f64; 2], anchor: Anchor, color: &str, words: &str) {
        self.words(at, anchor, &TextStyle::new(10.0, color), words);
    }

    /// A small text.
    pub(crate) fn note(&mut self, at: [f64; 2], anchor: Anchor, words: &str) {
        self.words(at, anchor, &TextStyle::new(8.8, SOFT), words);
    }

    /// A bold text.
    pub(crate) fn title(&mut self, at: [f64; 2], anchor: Anchor, words: &str) {
        self.words(at, anchor, &TextStyle::new(10.5, INK).bold(), words);
    }

    pub(crate) fn finish(self) -> String {
        self.sheet.finish()
    }

    fn words(&mut self, at: [f64; 2], anchor: Anchor, kind: &TextStyle<'_>, words: &str) {
        let [x, y] = self.pixel(at);
        self.sheet.text([x, y + 5.0], anchor, kind, words);
    }

    /// A filled arrow head; `direction_rad` is clockwise, in pixel coordinates.
    fn head(&mut self, tip: [f64; 2], direction_rad: f64, color: &str) {
        let wing = |side: f64| {
            let angle = direction_rad + std::f64::consts::PI + side;
            [
                tip[0] + HEAD_PX * angle.cos(),
                tip[1] + HEAD_PX * angle.sin(),
            ]
        };
        let corners = [tip, wing(0.33), wing(-0.33)];
        self.sheet.area(&corners, &ShapeStyle::area(color));
    }

    fn pixels(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|point| self.pixel(*point)).collect()
    }

    fn pixel(&self, at: [f64; 2]) -> [f64; 2] {
        [
            self.origin[0] + at[0] * self.scale[0],
            self.origin[1] - at[1] * self.scale[1],
        ]
    }
}

/// A dashed line.
pub(crate) const fn dashed(color: &str, width: f64) -> ShapeStyle<'_> {
    ShapeStyle::line(color, width).dashed("5 5")
}

/// The point at a distance and a direction in degrees, counter-clockwise from the right.
pub(crate) fn polar(around: [f64; 2], radius: f64, direction_deg: f64) -> [f64; 2] {
    let (sin, cos) = direction_deg.to_radians().sin_cos();
    [around[0] + radius * cos, around[1] + radius * sin]
}

pub(crate) const PAPER: &str = "#ffffff";
pub(crate) const INK: &str = "#1f2937";
pub(crate) const SOFT: &str = "#6b7280";
pub(crate) const FAINT: &str = "#d1d5db";
pub(crate) const SHADE: &str = "#eef2ff";
pub(crate) const BLUE: &str = "#2563eb";
pub(crate) const ORANGE: &str = "#ea7317";
pub(crate) const GREEN: &str = "#15803d";
pub(crate) const RED: &str = "#dc2626";
pub(crate) const PURPLE: &str = "#7c3aed";

const HEAD_PX: f64 = 11.0;
