//! Lines, arcs and words in millimetres, written as SVG.

use std::fmt::Write as _;

/// A picture in the making: the caller's units, x to the right, y up.
pub(crate) struct Canvas {
    svg: String,
    /// Pixels where the caller's origin is.
    origin: [f64; 2],
    /// Pixels per unit, right and up.
    scale: [f64; 2],
}

impl Canvas {
    pub(crate) fn new(width: u32, height: u32) -> Self {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="Helvetica, Arial, sans-serif" font-size="15" stroke-linecap="round" stroke-linejoin="round">
<rect width="{width}" height="{height}" rx="10" fill="{PAPER}"/>
"#
        );
        Self {
            svg,
            origin: [0.0, 0.0],
            scale: [1.0, 1.0],
        }
    }

    /// From now on units are counted from this pixel on, with so many pixels each.
    pub(crate) fn place(&mut self, origin: [f64; 2], scale: [f64; 2]) {
        (self.origin, self.scale) = (origin, scale);
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        self.path(&[from, to], stroke);
    }

    pub(crate) fn path(&mut self, points: &[[f64; 2]], stroke: &Stroke) {
        let d = self.outline(points);
        let Stroke { color, width, dash } = stroke;
        let _ = writeln!(
            self.svg,
            r#"<path d="{d}" fill="none" stroke="{color}" stroke-width="{width}" stroke-dasharray="{dash}"/>"#
        );
    }

    pub(crate) fn area(&mut self, points: &[[f64; 2]], color: &str) {
        let d = self.outline(points);
        let _ = writeln!(self.svg, r#"<path d="{d}Z" fill="{color}"/>"#);
    }

    pub(crate) fn dot(&mut self, at: [f64; 2], radius_px: f64, fill: &str, stroke: &str) {
        let [x, y] = self.pixel(at);
        let _ = writeln!(
            self.svg,
            r#"<circle cx="{x:.2}" cy="{y:.2}" r="{radius_px}" fill="{fill}" stroke="{stroke}" stroke-width="2.5"/>"#
        );
    }

    /// An arrow from one point to another.
    pub(crate) fn arrow(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        self.line(from, to, stroke);
        let [a, b] = [self.pixel(from), self.pixel(to)];
        self.head(b, (b[1] - a[1]).atan2(b[0] - a[0]), stroke.color);
    }

    /// A line with an arrow head at each end.
    pub(crate) fn measure(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        self.arrow(from, to, stroke);
        self.arrow(to, from, stroke);
    }

    /// An arc from one direction to another, with an arrow head at its end; angles in degrees,
    /// counter-clockwise from the right.
    pub(crate) fn angle(
        &mut self,
        around: [f64; 2],
        radius: f64,
        degrees: [f64; 2],
        stroke: &Stroke,
    ) {
        let [from, to] = degrees;
        let points: Vec<_> = (0..=40)
            .map(|n| polar(around, radius, from + (to - from) * f64::from(n) / 40.0))
            .collect();
        self.path(&points, stroke);
        let ahead = to + 90.0_f64.copysign(to - from);
        // The head of a bent arrow lies along the chord, not the tangent.
        let bend = (180.0 / std::f64::consts::PI * HEAD_PX / 2.0 / (radius * self.scale[0]))
            .copysign(to - from);
        self.head(
            self.pixel(points[40]),
            -(ahead - bend).to_radians(),
            stroke.color,
        );
    }

    /// Words; `anchor` is `start`, `middle` or `end`.
    pub(crate) fn text(&mut self, at: [f64; 2], anchor: &str, color: &str, words: &str) {
        self.styled(at, anchor, color, "", words);
    }

    /// Small words.
    pub(crate) fn note(&mut self, at: [f64; 2], anchor: &str, words: &str) {
        self.styled(at, anchor, SOFT, r#" font-size="13""#, words);
    }

    /// Bold words.
    pub(crate) fn title(&mut self, at: [f64; 2], anchor: &str, words: &str) {
        self.styled(
            at,
            anchor,
            INK,
            r#" font-weight="bold" font-size="16""#,
            words,
        );
    }

    pub(crate) fn finish(mut self) -> String {
        self.svg.push_str("</svg>\n");
        self.svg
    }

    fn styled(&mut self, at: [f64; 2], anchor: &str, color: &str, style: &str, words: &str) {
        let [x, y] = self.pixel(at);
        let _ = writeln!(
            self.svg,
            r#"<text x="{x:.2}" y="{:.2}" text-anchor="{anchor}" fill="{color}"{style}>{words}</text>"#,
            y + 5.0
        );
    }

    /// A filled arrow head; `direction_rad` as pixels run, clockwise.
    fn head(&mut self, tip: [f64; 2], direction_rad: f64, color: &str) {
        let wing = |side: f64| {
            let angle = direction_rad + std::f64::consts::PI + side;
            [
                tip[0] + HEAD_PX * angle.cos(),
                tip[1] + HEAD_PX * angle.sin(),
            ]
        };
        let [[ax, ay], [bx, by]] = [wing(0.33), wing(-0.33)];
        let _ = writeln!(
            self.svg,
            r#"<path d="M{:.2},{:.2}L{ax:.2},{ay:.2}L{bx:.2},{by:.2}Z" fill="{color}"/>"#,
            tip[0], tip[1]
        );
    }

    fn outline(&self, points: &[[f64; 2]]) -> String {
        let mut d = String::new();
        for (n, point) in points.iter().enumerate() {
            let [x, y] = self.pixel(*point);
            let _ = write!(d, "{}{x:.2},{y:.2}", if n == 0 { 'M' } else { 'L' });
        }
        d
    }

    fn pixel(&self, at: [f64; 2]) -> [f64; 2] {
        [
            self.origin[0] + at[0] * self.scale[0],
            self.origin[1] - at[1] * self.scale[1],
        ]
    }
}

/// How a line looks.
pub(crate) struct Stroke {
    color: &'static str,
    width: f64,
    dash: &'static str,
}

impl Stroke {
    pub(crate) const fn solid(color: &'static str, width: f64) -> Self {
        Self {
            color,
            width,
            dash: "none",
        }
    }

    pub(crate) const fn dashed(color: &'static str, width: f64) -> Self {
        Self {
            color,
            width,
            dash: "5 5",
        }
    }
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
