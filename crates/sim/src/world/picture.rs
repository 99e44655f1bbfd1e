//! The picture of a world: from above, from the side, and what happened.

mod marks;
mod side;
mod top;
mod words;

use std::fmt::Write as _;

use dobot_geometry::Point;
use dobot_lettering::{Anchor, lettering};

use super::{Object, WorldState};

impl WorldState {
    /// The picture, as the text of an SVG file in true millimetres: from above as a person behind
    /// the arm sees it (X up, Y to the left), below that from the side. It needs no fonts and has a
    /// background of its own.
    #[must_use]
    pub fn picture(&self) -> String {
        let top = top::bounds(self);
        let unit = top.width / 230.0;
        let side = side::bounds(self, &top, unit);
        let log = Frame {
            left: side.left + side.width + 4.0 * unit,
            width: top.width - side.width - 4.0 * unit,
            ..side
        };
        let page = Frame {
            left: top.left - 8.0 * unit,
            top: top.top - 14.0 * unit,
            width: top.width + 16.0 * unit,
            height: top.height + side.height + (14.0 + 4.0 + 18.0) * unit,
        };
        let Frame {
            left,
            top: up,
            width,
            height,
        } = page;
        let mut svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width:.1}mm" height="{height:.1}mm" viewBox="{left:.1} {up:.1} {width:.1} {height:.1}" fill="none" stroke-linecap="round" stroke-linejoin="round">
"#
        );
        svg += &page.rect(0.0, &format!(r#"fill="{DESK}""#));
        svg += &top.panel("top", &top::view(self, &top, unit), unit);
        svg += &side.panel("side", &side::view(self, &side, unit), unit);
        svg += &log.panel("log", &words::log(self, &log, unit), unit);
        svg += &words::head(self, &top, unit);
        let below = side.top + side.height;
        svg += &words::figures(self, Point::new(side.left, below), unit);
        svg + "</svg>\n"
    }
}

/// A rectangle of the page, in mm; down is positive.
#[derive(Clone, Copy, Debug)]
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Frame {
    fn rect(&self, radius: f64, style: &str) -> String {
        let Self {
            left,
            top,
            width,
            height,
        } = self;
        format!(
            "<rect x=\"{left:.2}\" y=\"{top:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" rx=\"{radius:.2}\" {style}/>\n"
        )
    }

    /// A sheet with what lies on it, cut off at its edges.
    fn panel(&self, id: &str, content: &str, unit: f64) -> String {
        let sheet = self.rect(unit, &format!(r#"fill="{SHEET}""#));
        let clip = self.rect(unit, "");
        let edge = self.rect(
            unit,
            &format!(r##"stroke="#c9c3b4" stroke-width="{:.2}""##, 0.12 * unit),
        );
        format!(
            "{sheet}<clipPath id=\"{id}\">{clip}</clipPath><g clip-path=\"url(#{id})\">\n{content}</g>\n{edge}"
        )
    }
}

/// A name: in a colour of its own, with a halo that keeps it apart from what is below it.
fn label(text: &str, anchor: Anchor, at: Point, height: f64, color: &str) -> String {
    let words = lettering(text, anchor, at.x, at.y, height);
    format!(
        "<g stroke=\"{SHEET}\" stroke-width=\"2.6\" stroke-opacity=\".75\">{words}</g><g stroke=\"{color}\" stroke-width=\".85\">{words}</g>\n"
    )
}

/// A length of 50 mm, its right end at a place.
fn scale_bar(at: Point, scale: f64, unit: f64) -> String {
    let long = 50.0 * scale;
    let (x, y, tick) = (at.x - long, at.y, 1.2 * unit);
    let words = lettering(
        "50 mm",
        Anchor::Middle,
        x + long / 2.0,
        y - 2.0 * unit,
        1.6 * unit,
    );
    let mut svg = String::new();
    let _ = writeln!(
        svg,
        r#"<g stroke="{MUTED}" stroke-width="{:.2}"><path d="M{x:.2} {:.2}v{tick:.2}h{long:.2}v-{tick:.2}"/><g stroke-width=".75">{words}</g></g>"#,
        0.14 * unit,
        y - tick
    );
    svg
}

/// A colour between two, each `[red, green, blue]`.
fn mix(from: [f64; 3], to: [f64; 3], share: f64) -> String {
    let part = |i: usize| {
        let value = from[i] + (to[i] - from[i]) * share.clamp(0.0, 1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 255"
        )]
        let byte = value.round().clamp(0.0, 255.0) as u8;
        byte
    };
    format!("#{:02x}{:02x}{:02x}", part(0), part(1), part(2))
}

/// The edge of an object: its colour, darker.
fn edge(object: &Object) -> String {
    mix(rgb(object), [20.0, 24.0, 32.0], 0.45)
}

/// What can be read on an object: dark on a light one, light on a dark one.
fn contrast(object: &Object) -> &'static str {
    let [red, green, blue] = rgb(object);
    let light = 0.3 * red + 0.59 * green + 0.11 * blue;
    if light > 150.0 { INK } else { SHEET }
}

fn rgb(object: &Object) -> [f64; 3] {
    let byte = |at: usize| {
        let digits = object.color.get(at..at + 2).unwrap_or("80");
        u8::from_str_radix(digits, 16).map_or(128.0, f64::from)
    };
    [byte(1), byte(3), byte(5)]
}

/// What may stand in an attribute: a colour, or gray where a state says something else.
fn fill(object: &Object) -> &str {
    let hex = object.color.strip_prefix('#');
    let good = hex.is_some_and(|it| it.len() == 6 && it.bytes().all(|it| it.is_ascii_hexdigit()));
    if good { &object.color } else { "#808080" }
}

/// How near and how far the tool of a stock arm gets from the base axis.
const REACH_MM: [f64; 2] = [129.0, 321.0];
const DESK: &str = "#f4f1e9";
const SHEET: &str = "#fffefb";
const INK: &str = "#1b2a41";
const MUTED: &str = "#75838d";
const STEEL: &str = "#7d8f9b";
const WARM: &str = "#c8553d";
