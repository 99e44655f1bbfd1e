//! Estimated masses: those of the shapes if they were of water. Nobody has measured them.

use crate::shape::{Shape, Solid};

/// The mass of a part and its distribution, in kg and m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Inertia {
    pub(crate) mass_kg: f64,
    /// The centre of mass in the frame of the part.
    pub(crate) at_m: [f64; 3],
    /// Moments of inertia about the centre of mass, in kg m2: xx, yy, zz.
    pub(crate) moments: [f64; 3],
    /// Products of inertia there, as URDF has them: xy, xz, yz.
    pub(crate) products: [f64; 3],
}

impl Inertia {
    /// A part without a shape: 5 g, and more inert than that, as solvers that go step by step need between two joints.
    pub(crate) const SHAPELESS: Self = Self {
        mass_kg: 0.005,
        at_m: [0.0; 3],
        moments: [1e-5; 3],
        products: [0.0; 3],
    };

    /// The inertia of shapes, which count twice where they overlap.
    pub(crate) fn of(shapes: &[Shape]) -> Self {
        if shapes.is_empty() {
            return Self::SHAPELESS;
        }
        let each: Vec<Self> = shapes.iter().map(Self::of_one).collect();
        let mass_kg: f64 = each.iter().map(|one| one.mass_kg).sum();
        let at_m = center_of_mass(&each, mass_kg);
        let (mut moments, mut products) = ([0.0; 3], [0.0; 3]);
        for one in &each {
            // The parallel axis theorem.
            let [x, y, z] = [0, 1, 2].map(|axis| one.at_m[axis] - at_m[axis]);
            let squares = [y * y + z * z, x * x + z * z, x * x + y * y];
            let mixed = [x * y, x * z, y * z];
            for axis in 0..3 {
                moments[axis] += one.moments[axis] + one.mass_kg * squares[axis];
                products[axis] -= one.mass_kg * mixed[axis];
            }
        }
        Self {
            mass_kg,
            at_m,
            moments,
            products,
        }
    }

    fn of_one(shape: &Shape) -> Self {
        let (volume_mm3, squares) = match shape.solid {
            Solid::Box { size_mm: [x, y, z] } => {
                let squares = [y * y + z * z, x * x + z * z, x * x + y * y];
                (x * y * z, squares.map(|square| square / 12.0))
            }
            Solid::Pin { radius_mm, long_mm } => {
                let [along, across] = of_cylinder(radius_mm, long_mm);
                (volume(radius_mm, long_mm), [across, along, across])
            }
            Solid::Post { radius_mm, long_mm } => {
                let [along, across] = of_cylinder(radius_mm, long_mm);
                (volume(radius_mm, long_mm), [across, across, along])
            }
        };
        let mass_kg = volume_mm3 * WATER_KG_PER_MM3;
        Self {
            mass_kg,
            at_m: shape.at_mm.map(|mm| mm / 1000.0),
            moments: squares.map(|mm2| mass_kg * mm2 / 1e6),
            products: [0.0; 3],
        }
    }
}

fn volume(radius_mm: f64, long_mm: f64) -> f64 {
    std::f64::consts::PI * radius_mm * radius_mm * long_mm
}

/// The squared radii of gyration along and across the axis.
fn of_cylinder(radius_mm: f64, long_mm: f64) -> [f64; 2] {
    let square = radius_mm * radius_mm;
    [square / 2.0, square / 4.0 + long_mm * long_mm / 12.0]
}

const WATER_KG_PER_MM3: f64 = 1e-6;

/// The center of mass of bodies, in metres.
fn center_of_mass(bodies: &[Inertia], mass_kg: f64) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let moments = bodies.iter().map(|body| body.mass_kg * body.at_m[axis]);
        moments.sum::<f64>() / mass_kg
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Colour, cuboid, post};

    fn near(found: [f64; 3], expected: [f64; 3]) {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    #[test]
    fn a_cube_in_two_halves_is_as_heavy_and_inert_as_the_whole() {
        // A litre: 1 kg, and m a^2 / 6 about each axis.
        let half = |from: f64, to: f64| cuboid([from, 0.0, 0.0], [to, 100.0, 100.0], Colour::Dark);
        let found = Inertia::of(&[half(-50.0, 0.0), half(0.0, 50.0)]);
        assert!((found.mass_kg - 1.0).abs() < 1e-12, "{found:?}");
        near(found.at_m, [0.0, 0.05, 0.05]);
        near(found.moments, [0.01 / 6.0; 3]);
        near(found.products, [0.0; 3]);
    }

    #[test]
    fn two_posts_side_by_side_turn_as_algebra_says() {
        // A post of 1 kg on each side along the diagonal of x and y: products of inertia of -m x y each.
        let one = post(50.0, [-50.0, 50.0], Colour::Dark);
        let mass_kg = Inertia::of(&[one]).mass_kg;
        let shifted = |by: f64| Shape {
            at_mm: [by, by, 0.0],
            ..one
        };
        let found = Inertia::of(&[shifted(100.0), shifted(-100.0)]);
        near(found.products, [-2.0 * mass_kg * 0.01, 0.0, 0.0]);
        let along = mass_kg * 0.05 * 0.05 / 2.0;
        near(
            [found.moments[2], 0.0, 0.0],
            [2.0 * (along + mass_kg * 0.02), 0.0, 0.0],
        );
    }
}
