//! What a controller is when it is switched on.

use core::fmt;
use core::str::FromStr;

use dobot_wire::Dialect;

/// How a controller behaves where the document leaves room, and what it does with bad input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Personality {
    /// The document's rules: every bad input is refused and counted, no limit is ever passed.
    #[default]
    Specification,
    /// The twin of the controller that stock arms have (firmware 1.1): its rounding, its limits and
    /// its traps.
    Firmware11,
}

impl Personality {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Specification, Self::Firmware11];

    /// The dialect that it speaks.
    #[must_use]
    pub const fn dialect(self) -> Dialect {
        match self {
            Self::Specification => Dialect::SPECIFICATION,
            Self::Firmware11 => Dialect::FIRMWARE_1_1,
        }
    }

    /// The name by which a user chooses it: that of its dialect.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.dialect().name()
    }
}

impl fmt::Display for Personality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Personality {
    type Err = UnknownPersonality;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|it| it.name() == name)
            .ok_or(UnknownPersonality)
    }
}

/// A name that no personality has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no such personality; the names are \"specification\" and \"firmware-1.1\"")]
pub struct UnknownPersonality;

/// The port that a controller serves; a pin tells it at power-up (note N38).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Port {
    /// The cable.
    #[default]
    Usb,
    /// The Bluetooth module, which only the twin of the stock controller has.
    Bluetooth,
}

/// What a controller is when it is switched on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerUp {
    /// How it behaves.
    pub personality: Personality,
    /// The port that it serves. The document knows one only: [`Personality::Specification`] sends
    /// its statuses as over [`Port::Usb`], whatever is said here.
    pub port: Port,
    /// What the rear arm's tilt sensor reads, in degrees from the vertical.
    pub rear_deg: f64,
    /// What the forearm's tilt sensor reads, in degrees below the horizontal.
    pub fore_deg: f64,
}

impl PowerUp {
    /// A controller of that personality, on USB, in the usual pose (note N28).
    #[must_use]
    pub const fn new(personality: Personality) -> Self {
        Self {
            personality,
            port: Port::Usb,
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
