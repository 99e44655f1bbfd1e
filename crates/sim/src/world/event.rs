//! What happens in a world.

use std::fmt;

use dobot_geometry::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Something that happened, and when.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Happened {
    /// When, in seconds since power-up.
    pub at_s: f64,
    /// What.
    #[serde(flatten)]
    pub event: Event,
}

/// What may happen in a world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "event", rename_all = "snake_case")]
#[schemars(rename = "WorldEvent")]
#[non_exhaustive]
pub enum Event {
    /// The tool has an object in its grip, and whatever stands on that.
    PickedUp {
        /// The object.
        object: String,
        /// How many others stand on it.
        with: usize,
    },
    /// The tool has hold of an object that is too heavy.
    TooHeavy {
        /// The object.
        object: String,
        /// What it weighs, with all that stands on it.
        mass_g: f64,
        /// What the tool lifts.
        lifts_g: f64,
    },
    /// The suction cup sits on the edge of an object and draws air.
    DrawsAir {
        /// The object.
        object: String,
        /// How far the cup stands out.
        by_mm: f64,
    },
    /// The tool let an object go.
    Dropped {
        /// The object.
        object: String,
        /// What it came to rest on.
        onto: String,
        /// How far it fell.
        fell_mm: f64,
    },
    /// Something is pressed into something else, farther than the tool gives. Told again when it is
    /// pressed in twice as deep.
    Collided {
        /// The tool, or the object that it holds.
        what: String,
        /// What is in the way.
        with: String,
        /// How deep.
        depth_mm: f64,
        /// Where.
        #[serde(with = "super::place::pair")]
        #[schemars(with = "[f64; 2]")]
        at_mm: Point,
    },
    /// The laser burns on the spot: that sets paper on fire.
    BurnsOnTheSpot {
        /// Where.
        #[serde(with = "super::place::pair")]
        #[schemars(with = "[f64; 2]")]
        at_mm: Point,
        /// For how long it has by now.
        time_s: f64,
    },
    /// The pen or the laser has left the paper and marks the table.
    OffPaper {
        /// Where.
        #[serde(with = "super::place::pair")]
        #[schemars(with = "[f64; 2]")]
        at_mm: Point,
    },
    /// A joint angle is not a number, or farther than ten turns: the arm stays where it was.
    Lost,
}

impl fmt::Display for Happened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.2} s: {}", self.at_s, self.event)
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = |at: &Point| format!("x {:.1} y {:.1}", at.x, at.y);
        match self {
            Self::PickedUp { object, with: 0 } => write!(f, "picked up {object}"),
            Self::PickedUp { object, with } => {
                write!(f, "picked up {object} with {with} on it")
            }
            Self::TooHeavy {
                object,
                mass_g,
                lifts_g,
            } => write!(
                f,
                "{object} is too heavy: it weighs {mass_g:.0} g, the tool lifts {lifts_g:.0} g"
            ),
            Self::DrawsAir { object, by_mm } => write!(
                f,
                "{object} is not held: the cup stands {by_mm:.1} mm over its edge"
            ),
            Self::Dropped {
                object,
                onto,
                fell_mm,
            } if *fell_mm < 0.5 => write!(f, "put {object} down on {onto}"),
            Self::Dropped {
                object,
                onto,
                fell_mm,
            } => write!(f, "dropped {object}: it fell {fell_mm:.1} mm onto {onto}"),
            Self::Collided {
                what,
                with,
                depth_mm,
                at_mm,
            } => write!(
                f,
                "{what} is {depth_mm:.1} mm deep in {with} at {}",
                place(at_mm)
            ),
            Self::BurnsOnTheSpot { at_mm, time_s } => write!(
                f,
                "danger: the laser burns on the spot at {}, for {time_s:.1} s by now",
                place(at_mm)
            ),
            Self::OffPaper { at_mm } => {
                write!(f, "off the paper at {}: it marks the table", place(at_mm))
            }
            Self::Lost => {
                f.write_str("nobody knows where the arm is: its joint angles are no numbers")
            }
        }
    }
}
