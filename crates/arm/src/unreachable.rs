//! Why the arm cannot, or may not, be somewhere.

use core::fmt;

/// Why the arm cannot or may not take a pose.
///
/// ```
/// # use dobot_arm::{Joints, Limits, Tool};
/// let error = Limits::STOCK.check(&Joints::new(0.0, 88.5, 60.0, 0.0), Tool::Laser).unwrap_err();
/// assert_eq!(error.to_string(), "rear arm angle is 88.5°; the arm allows -5 to 85°: 3.5° too much");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unreachable {
    /// A number of the pose or of the joints is NaN or infinite.
    #[error("{quantity} is {found}; the arm allows finite numbers only")]
    NotFinite {
        /// Which number.
        quantity: Quantity,
        /// NaN or an infinity.
        found: f64,
    },
    /// A quantity lies outside the range that the arm allows.
    #[error("{}", OutOfRange { quantity, found, min, max })]
    OutOfRange {
        /// Which quantity.
        quantity: Quantity,
        /// How much it is, in its unit (degrees or millimetres).
        found: f64,
        /// The least that is allowed; negative infinity where there is no such limit.
        min: f64,
        /// The most that is allowed.
        max: f64,
    },
}

impl Unreachable {
    /// By how much the range is exceeded, in the quantity's unit; NaN where the number is not
    /// finite.
    #[must_use]
    pub const fn excess(&self) -> f64 {
        match *self {
            Self::NotFinite { .. } => f64::NAN,
            Self::OutOfRange { found, min, .. } if found < min => min - found,
            Self::OutOfRange { found, max, .. } => found - max,
        }
    }
}

/// The quantity in an [`Unreachable`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// The coordinate X in millimetres.
    X,
    /// The coordinate Y in millimetres.
    Y,
    /// The coordinate Z in millimetres.
    Z,
    /// The horizontal distance from the base axis in millimetres.
    Reach,
    /// The distance from pivot to wrist in millimetres, which the two links have to bridge.
    Stretch,
    /// The rotation of the tool in degrees.
    Rotation,
    /// Joint 1 in degrees.
    Base,
    /// Joint 2 in degrees.
    Rear,
    /// Joint 3 in degrees.
    Fore,
    /// Joint 4 in degrees.
    Servo,
    /// Rear arm angle minus forearm angle in degrees: how far the elbow is opened.
    Opening,
}

impl Quantity {
    /// Name, unit, "less than allowed" and "more than allowed".
    const fn words(self) -> [&'static str; 4] {
        match self {
            Self::X => ["x", " mm", "too far back", "too far ahead"],
            Self::Y => ["y", " mm", "too far right", "too far left"],
            Self::Z => ["z", " mm", "too low", "too high"],
            Self::Reach => ["reach", " mm", "too near", "too far"],
            Self::Stretch => ["distance from pivot to wrist", " mm", "too near", "too far"],
            Self::Rotation => ["rotation", "°", "too little", "too much"],
            Self::Base => ["base angle", "°", "too little", "too much"],
            Self::Rear => ["rear arm angle", "°", "too little", "too much"],
            Self::Fore => ["forearm angle", "°", "too little", "too much"],
            Self::Servo => ["servo angle", "°", "too little", "too much"],
            Self::Opening => [
                "rear arm minus forearm angle",
                "°",
                "too little",
                "too much",
            ],
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.words()[0])
    }
}

/// The text of [`Unreachable::OutOfRange`].
struct OutOfRange<'a> {
    quantity: &'a Quantity,
    found: &'a f64,
    min: &'a f64,
    max: &'a f64,
}

impl fmt::Display for OutOfRange<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (found, min, max) = (*self.found, *self.min, *self.max);
        let [name, unit, less, more] = self.quantity.words();
        write!(f, "{name} is {}{unit}; the arm allows ", readable(found))?;
        match (min.is_finite(), max.is_finite()) {
            (true, true) => write!(f, "{min} to {max}{unit}")?,
            (false, _) => write!(f, "at most {max}{unit}")?,
            (true, false) => write!(f, "at least {min}{unit}")?,
        }
        let (excess, how) = if found < min {
            (min - found, less)
        } else {
            (found - max, more)
        };
        write!(
            f,
            ": {}{unit} {how}",
            readable(excess.max(1.0 / READABLE_PER_UNIT))
        )
    }
}

/// Four decimals at most, as a person reads a length or an angle.
fn readable(value: f64) -> f64 {
    libm::round(value * READABLE_PER_UNIT) / READABLE_PER_UNIT
}

const READABLE_PER_UNIT: f64 = 1e4;
