//! What a controller is when it is switched on.

use dobot_wire::Dialect;

/// How a controller behaves where the document leaves room, and what it does with bad input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Personality {
    /// The document's rules: every bad input is refused and counted, no limit is ever passed.
    #[default]
    Specification,
}

impl Personality {
    /// The dialect that it speaks.
    #[must_use]
    pub const fn dialect(self) -> Dialect {
        match self {
            Self::Specification => Dialect::SPECIFICATION,
        }
    }
}

/// What a controller is when it is switched on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerUp {
    /// How it behaves.
    pub personality: Personality,
    /// The packets that it understands.
    pub dialect: Dialect,
    /// What the rear arm's tilt sensor reads, in degrees from the vertical.
    pub rear_deg: f64,
    /// What the forearm's tilt sensor reads, in degrees below the horizontal.
    pub fore_deg: f64,
}

impl PowerUp {
    /// A controller of that personality, speaking its dialect, in the usual pose (note N28).
    #[must_use]
    pub const fn new(personality: Personality) -> Self {
        Self {
            personality,
            dialect: personality.dialect(),
            rear_deg: 45.0,
            fore_deg: 45.0,
        }
    }
}

impl Default for PowerUp {
    fn default() -> Self {
        Self::new(Personality::default())
    }
}
