//! Places on the table, seen from above: X forward, Y to the left, in mm. States tell them to a
//! thousandth, in JSON as `[x, y]`.

use dobot_geometry::Point;

/// To a thousandth of a millimetre.
pub(crate) fn rounded_place(place: Point) -> Point {
    Point::new(rounded(place.x), rounded(place.y))
}

/// To a thousandth.
pub(crate) fn rounded(value: f64) -> f64 {
    // No `-0`.
    (value * 1000.0).round() / 1000.0 + 0.0
}

/// A place in JSON.
pub(crate) mod pair {
    use dobot_geometry::Point;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(place: &Point, to: S) -> Result<S::Ok, S::Error> {
        [place.x, place.y].serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Point, D::Error> {
        <[f64; 2]>::deserialize(from).map(|[x, y]| Point::new(x, y))
    }
}

/// Places in JSON.
pub(crate) mod pairs {
    use dobot_geometry::Point;
    use serde::{Deserialize, Deserializer, Serializer};

    pub(crate) fn serialize<S: Serializer>(places: &[Point], to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(places.iter().map(|it| [it.x, it.y]))
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<Point>, D::Error> {
        let places = Vec::<[f64; 2]>::deserialize(from)?;
        Ok(places.into_iter().map(|[x, y]| Point::new(x, y)).collect())
    }
}
