//! The units of the protocol: degrees and millimetres.

use core::fmt;
use core::ops::{Add, AddAssign, Mul, Neg, Sub};

use crate::kinematics::RAD_PER_DEG;

macro_rules! unit {
    ($(#[$doc:meta])* $name:ident, $symbol:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
        pub struct $name(pub f64);

        impl $name {
            /// The amount without its sign.
            #[must_use]
            pub const fn abs(self) -> Self {
                Self(self.0.abs())
            }
        }

        impl Add for $name {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl AddAssign for $name {
            fn add_assign(&mut self, other: Self) {
                self.0 += other.0;
            }
        }

        impl Sub for $name {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }

        impl Neg for $name {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Mul<f64> for $name {
            type Output = Self;
            fn mul(self, factor: f64) -> Self {
                Self(self.0 * factor)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(&self.0, f)?;
                f.write_str($symbol)
            }
        }
    };
}

unit! {
    /// An angle in degrees: the only angle unit on the wire and in public APIs.
    Degrees, "°"
}

impl Degrees {
    /// The length of the arc that a point at this distance from the axis goes, with its sign.
    #[must_use]
    pub const fn arc(self, radius: Millimeters) -> Millimeters {
        Millimeters(self.0 * RAD_PER_DEG * radius.0)
    }
}

unit! {
    /// A length in millimetres.
    Millimeters, " mm"
}
