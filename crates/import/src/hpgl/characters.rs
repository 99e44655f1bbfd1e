//! The shape of label characters: SI, SR, DI, DR, SL, ES, LO.
//!
//! ```text
//!   + - - - - - - - - +     a cell: 1.5 characters wide, 2 high; ES adds to it
//!   |                 |
//!   +-----------+     |
//!   | #       # |     |
//!   | ######### |           a character: as wide and tall as SI says
//!   | #       # |     |
//!   o-----------+ - - +     o: where the pen stands (LO 1), which goes on to the next cell
//! ```

use dobot_geometry::{Point, Vec2};

use super::transform::{PlotTransform, UNIT_MM};
use crate::text::{CAPITAL, Pose};

/// The character settings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Characters {
    pub(super) size: Size,
    pub(super) direction: Direction,
    /// The tangent of the slant to the right.
    pub(super) slant: f64,
    /// The extra space of a cell, in cells.
    pub(super) extra: Point,
    pub(super) origin: Origin,
}

/// Width and height of a character; below 0 it is mirrored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Size {
    /// The default.
    Default,
    /// In centimetres.
    Absolute(Vec2),
    /// In percent of the distance from P1 to P2.
    Relative(Vec2),
}

/// The direction of the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Direction {
    Absolute(Vec2),
    /// In percent of the distance from P1 to P2.
    Relative(Vec2),
}

/// The label origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Origin {
    /// The fraction of the label before the pen, and below it: 0, 0.5 or 1.
    share: Vec2,
    /// The distance to the pen, in heights of a character.
    gap: f64,
}

/// The cell of a character, as vectors on the paper in millimetres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// The unit vector along the label, and the one up from it.
    units: [Vec2; 2],
    /// The character's width and height.
    pub(super) across: Vec2,
    pub(super) up: Vec2,
    /// The vector to the next character.
    pub(super) advance: Vec2,
    /// The vector to the line above.
    pub(super) line: Vec2,
    slant: f64,
    origin: Origin,
}

impl Default for Characters {
    fn default() -> Self {
        Self {
            size: Size::Default,
            direction: Direction::Absolute(Vec2::new(1.0, 0.0)),
            slant: 0.0,
            extra: Point::default(),
            origin: Origin::PEN,
        }
    }
}

impl Characters {
    pub(super) fn cell(&self, transform: &PlotTransform) -> Cell {
        let [p1, p2] = transform.corners;
        let percent = |vec2: Vec2| Vec2::new(vec2.x * (p2.x - p1.x), vec2.y * (p2.y - p1.y)) * 0.01;
        let size_mm = match self.size {
            Size::Default => DEFAULT_CM * MM_PER_CM,
            Size::Absolute(cm) => cm * MM_PER_CM,
            Size::Relative(share) => percent(share) * UNIT_MM,
        };
        let way = match self.direction {
            Direction::Absolute(way) => way,
            Direction::Relative(share) => percent(share),
        };
        let right = transform.turned(way * (1.0 / way.length()));
        let units = [right, right.turn_90()];
        let (across, up) = (units[0] * size_mm.x, units[1] * size_mm.y);
        Cell {
            units,
            across,
            up,
            advance: across * (1.5 * (1.0 + self.extra.x)),
            line: up * (2.0 * (1.0 + self.extra.y)),
            slant: self.slant,
            origin: self.origin,
        }
    }
}

impl Origin {
    /// The start of the label on the base line.
    const PEN: Self = Self {
        share: Vec2::ZERO,
        gap: 0.0,
    };

    /// ```text
    ///   3   6   9         13  16  19
    ///   2   5   8         12  15  18     the same, half a character away
    ///   1   4   7         11  14  17
    /// ```
    ///
    /// The position of the pen relative to the label.
    pub(super) fn of(number: f64) -> Option<Self> {
        let gap = if number > 10.0 { 0.5 } else { 0.0 };
        let base = number - 20.0 * gap;
        let base = (1..=9_u8).find(|&i| f64::from(i) == base)? - 1;
        let share = Vec2::new(f64::from(base / 3), f64::from(base % 3)) * 0.5;
        Some(Self { share, gap })
    }
}

impl Cell {
    /// The vector from the pen to the start of a label with this many columns.
    pub(super) fn start(&self, columns: f64) -> Vec2 {
        let Origin { share, gap } = self.origin;
        let gap_mm = gap * self.up.length();
        let away = |share: f64| (1.0 - 2.0 * share) * gap_mm;
        let aside = self.units[0] * away(share.x) + self.units[1] * away(share.y);
        aside - self.length(columns) * share.x - self.up * share.y
    }

    /// Whether labels follow each other; otherwise each is placed separately.
    pub(super) const fn continues(&self) -> bool {
        self.origin.share.x == 0.0
    }

    /// The width of a label, without the gap after its last character.
    fn length(&self, columns: f64) -> Vec2 {
        if columns > 0.0 {
            self.advance * (columns - 1.0) + self.across
        } else {
            Vec2::ZERO
        }
    }

    /// A letter in its cell: narrow ones are centered, wide ones are compressed.
    pub(super) fn pose(&self, at: Point, ink: [f64; 2]) -> Pose {
        let width = ink[1] - ink[0];
        let unit = 1.0 / width.max(CAPITAL_WIDTH);
        let before = (1.0 - width * unit) / 2.0 - ink[0] * unit;
        let leaning = self.units[0] * (self.slant * self.up.dot(self.units[1]));
        Pose {
            at: at + self.across * before,
            across: self.across * unit,
            up: (self.up + leaning) * (1.0 / CAPITAL),
        }
    }
}

/// The default size on a sheet of A4 or smaller.
const DEFAULT_CM: Vec2 = Vec2::new(0.187, 0.269);
const MM_PER_CM: f64 = 10.0;
/// The ink of H, on the letters' grid.
const CAPITAL_WIDTH: f64 = 14.0;
