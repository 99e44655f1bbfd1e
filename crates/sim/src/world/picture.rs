//! The picture of a world: from above, from the side, and what happened.

mod marks;
mod side;
mod top;
mod words;

use dobot_lettering::paper_style::{INK, MUTED, PAPER};
use dobot_lettering::{Rectangle, Sheet};

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
        let log = Rectangle {
            left: side.left + side.width + 4.0 * unit,
            width: top.width - side.width - 4.0 * unit,
            ..side
        };
        let page = Rectangle {
            left: top.left - 8.0 * unit,
            top: top.top - 14.0 * unit,
            width: top.width + 16.0 * unit,
            height: top.height + side.height + (14.0 + 4.0 + 18.0) * unit,
        };
        let mut sheet = Sheet::with_background(page);
        sheet.paper(&top, unit, |sheet| top::view(sheet, self, &top, unit));
        sheet.paper(&side, unit, |sheet| side::view(sheet, self, &side, unit));
        sheet.paper(&log, unit, |sheet| words::log(sheet, self, &log, unit));
        words::head(&mut sheet, self, &top, unit);
        let below = [side.left, side.bottom()];
        sheet.figures(below, &words::facts(self), unit);
        sheet.finish()
    }
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
    if light > 150.0 { INK } else { PAPER }
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
const ROD: &str = "#4a5a68";
const STEEL: &str = "#7d8f9b";
const WARM: &str = "#c8553d";
