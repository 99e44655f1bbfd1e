//! The plane of an entity in space, given by its extrusion (210, 220, 230).

use dobot_geometry::Vec2;

use super::entity::Entity;
use crate::error::SourceError;

/// A plane with its unit normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    normal: [f64; 3],
}

impl Plane {
    pub(super) fn of(entity: &Entity<'_>) -> Result<Self, SourceError> {
        let normal = [
            entity.number_or(210, 0.0)?,
            entity.number_or(220, 0.0)?,
            entity.number_or(230, 1.0)?,
        ];
        let normal = unit(normal).unwrap_or([0.0, 0.0, 1.0]);
        Ok(Self { normal })
    }

    /// A spatial vector projected onto the plane, as a unit vector; `None` if nothing remains.
    pub(super) fn within(&self, way: [f64; 3]) -> Option<[f64; 3]> {
        let out: f64 = (0..3).map(|i| way[i] * self.normal[i]).sum();
        unit([0, 1, 2].map(|i| way[i] - self.normal[i] * out))
    }

    /// A vector in the plane, rotated a quarter turn to the left.
    pub(super) fn left_of(&self, way: [f64; 3]) -> [f64; 3] {
        cross(self.normal, way)
    }

    /// The X axis of the plane's own system (arbitrary axis algorithm), rotated by an angle.
    pub(super) fn right(&self, angle_rad: f64) -> [f64; 3] {
        let [x, y, z] = self.normal;
        let is_level = x.abs() < 1.0 / 64.0 && y.abs() < 1.0 / 64.0;
        let axis = if is_level { [z, 0.0, -x] } else { [-y, x, 0.0] };
        let right = unit(axis).unwrap_or([1.0, 0.0, 0.0]);
        let up = self.left_of(right);
        let (sin, cos) = angle_rad.sin_cos();
        [0, 1, 2].map(|i| right[i] * cos + up[i] * sin)
    }
}

/// A spatial vector seen from above.
pub(super) const fn from_above([x, y, _]: [f64; 3]) -> Vec2 {
    Vec2::new(x, y)
}

fn unit(way: [f64; 3]) -> Option<[f64; 3]> {
    let length = way.iter().map(|pair| pair * pair).sum::<f64>().sqrt();
    (length > 0.0).then(|| way.map(|way| way / length))
}

fn cross([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}
