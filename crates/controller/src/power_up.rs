//! The power-up configuration of a controller.

use core::fmt;
use core::str::FromStr;

use dobot_wire::Dialect;

/// The behavior of a controller where the specification leaves it open, and on bad input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Personality {
    /// The published specification: every bad input is refused and counted, no limit is passed.
    #[default]
    Specification,
    /// The twin of the stock controller (firmware 1.1), with its rounding, limits and traps.
    Firmware11,
}

impl Personality {
    /// All personalities.
    pub const ALL: [Self; 2] = [Self::Specification, Self::Firmware11];

    /// The dialect of the personality.
    #[must_use]
    pub const fn dialect(self) -> Dialect {
        match self {
            Self::Specification => Dialect::SPECIFICATION,
            Self::Firmware11 => Dialect::FIRMWARE_1_1,
        }
    }

    /// The name, which is that of its dialect.
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
            .find(|personality| personality.name() == name)
            .ok_or(UnknownPersonality)
    }
}

/// The error returned for an unknown personality name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown personality; allowed are \"specification\" and \"firmware-1.1\"")]
pub struct UnknownPersonality;

/// The port that a controller serves; selected by a pin at power-up (note N38).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Port {
    /// The USB cable.
    #[default]
    Usb,
    /// The Bluetooth module; only the twin of the stock controller has one.
    Bluetooth,
}

/// The power-up configuration of a controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PowerUp {
    /// The personality.
    pub personality: Personality,
    /// The served port. The specification has only one: [`Personality::Specification`] always sends its
    /// statuses as over [`Port::Usb`].
    pub port: Port,
    /// The reading of the rear arm's tilt sensor, in degrees from the vertical.
    pub rear_deg: f64,
    /// The reading of the forearm's tilt sensor, in degrees below the horizontal.
    pub fore_deg: f64,
}

impl PowerUp {
    /// Creates the configuration of a personality, on USB, in the usual pose (note N28).
    #[must_use]
    pub const fn new(personality: Personality) -> Self {
        Self {
            personality,
            port: Port::Usb,
            rear_deg: 45.0,
            fore_deg: 45.0,
        }
    }

    /// The same on another port.
    #[must_use]
    pub const fn with_port(self, port: Port) -> Self {
        Self { port, ..self }
    }

    /// The same in another pose, by the tilt sensors: the rear arm in degrees from the vertical, the
    /// forearm in degrees below the horizontal.
    #[must_use]
    pub const fn with_tilt(self, rear_deg: f64, fore_deg: f64) -> Self {
        Self {
            rear_deg,
            fore_deg,
            ..self
        }
    }
}

impl Default for PowerUp {
    fn default() -> Self {
        Self::new(Personality::default())
    }
}
