//! The simple solids that parts are made of.

/// A solid in the frame of its part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shape {
    pub(crate) solid: Solid,
    /// Its middle, in mm.
    pub(crate) at_mm: [f64; 3],
    pub(crate) colour: Colour,
}

/// A solid about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Solid {
    /// A box with these edges along X, Y and Z.
    Box { size_mm: [f64; 3] },
    /// A cylinder along Y.
    Pin { radius_mm: f64, long_mm: f64 },
    /// A cylinder along Z.
    Post { radius_mm: f64, long_mm: f64 },
}

/// The shape of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Colour {
    Metal,
    Dark,
    Accent,
}

impl Colour {
    pub(crate) const ALL: [Self; 3] = [Self::Metal, Self::Dark, Self::Accent];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Metal => "metal",
            Self::Dark => "dark",
            Self::Accent => "accent",
        }
    }

    /// Red, green, blue and opacity, 0 to 1.
    pub(crate) const fn rgba(self) -> [f64; 4] {
        match self {
            Self::Metal => [0.75, 0.77, 0.8, 1.0],
            Self::Dark => [0.2, 0.21, 0.23, 1.0],
            Self::Accent => [0.93, 0.45, 0.1, 1.0],
        }
    }
}

/// A box from one corner to the opposite one, in mm.
pub(crate) fn cuboid(from: [f64; 3], to: [f64; 3], colour: Colour) -> Shape {
    let each = |of: fn(f64, f64) -> f64| [0, 1, 2].map(|n| of(from[n], to[n]));
    Shape {
        solid: Solid::Box {
            size_mm: each(|a, b| b - a),
        },
        at_mm: each(f64::midpoint),
        colour,
    }
}

/// A cylinder along Y, at X and Z, from one Y to another, in mm.
pub(crate) fn pin(radius_mm: f64, [x, z]: [f64; 2], [from, to]: [f64; 2], colour: Colour) -> Shape {
    Shape {
        solid: Solid::Pin {
            radius_mm,
            long_mm: to - from,
        },
        at_mm: [x, f64::midpoint(from, to), z],
        colour,
    }
}

/// A cylinder along Z through the origin, from one Z to another, in mm.
pub(crate) fn post(radius_mm: f64, [from, to]: [f64; 2], colour: Colour) -> Shape {
    Shape {
        solid: Solid::Post {
            radius_mm,
            long_mm: to - from,
        },
        at_mm: [0.0, 0.0, f64::midpoint(from, to)],
        colour,
    }
}
