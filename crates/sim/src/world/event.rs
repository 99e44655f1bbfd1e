//! The events of a world.

use std::fmt;

use dobot_geometry::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An event with its time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct Happened {
    /// The time in seconds since power-up.
    pub at_s: f64,
    /// The event.
    #[serde(flatten)]
    pub event: Event,
}

/// An event in a world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "event", rename_all = "snake_case")]
#[schemars(rename = "WorldEvent")]
#[non_exhaustive]
pub enum Event {
    /// The tool has picked up an object and everything on it.
    PickedUp {
        /// The object.
        object: String,
        /// The number of objects on it.
        with: usize,
    },
    /// The tool cannot lift an object that is too heavy.
    TooHeavy {
        /// The object.
        object: String,
        /// The mass including all objects on it.
        mass_g: f64,
        /// The load limit of the tool.
        lifts_g: f64,
    },
    /// The suction cup overlaps the edge of an object and draws air.
    DrawsAir {
        /// The object.
        object: String,
        /// The overhang of the cup.
        by_mm: f64,
    },
    /// The tool released an object.
    Dropped {
        /// The object.
        object: String,
        /// The object or surface it landed on.
        onto: String,
        /// The height of its fall.
        fell_mm: f64,
    },
    /// A collision deeper than the compliance of the tool. Reported again at twice the depth.
    Collided {
        /// The tool or the held object.
        what: String,
        /// The obstacle.
        with: String,
        /// The depth.
        depth_mm: f64,
        /// The position.
        #[serde(with = "super::place::pair")]
        #[schemars(with = "[f64; 2]")]
        at_mm: Point,
    },
    /// The laser burns in place, which sets paper on fire.
    BurnsOnTheSpot {
        /// The position.
        #[serde(with = "super::place::pair")]
        #[schemars(with = "[f64; 2]")]
        at_mm: Point,
        /// The duration until now.
        time_s: f64,
    },
    /// The pen or the laser has left the paper and marks the table.
    OffPaper {
        /// The position.
        #[serde(with = "super::place::pair")]
        #[schemars(with = "[f64; 2]")]
        at_mm: Point,
    },
    /// A joint angle is not a number, or more than ten turns: the arm stays in place.
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
                "danger: the laser burns in place at {}, for {time_s:.1} s",
                place(at_mm)
            ),
            Self::OffPaper { at_mm } => {
                write!(f, "off the paper at {}: it marks the table", place(at_mm))
            }
            Self::Lost => {
                f.write_str("the position of the arm is unknown: its joint angles are not numbers")
            }
        }
    }
}
