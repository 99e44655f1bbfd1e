//! Places of a program: names or coordinates.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::decision::{AfterTimeout, ExternalPlace};
use crate::number::perhaps;

/// A place: the name of a point or of a grid (for its current cell), or a point itself.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Place {
    /// A name.
    #[schemars(extend("x-names" = ["points", "grids"]))]
    Named(String),
    /// Coordinates or angles.
    At(Point),
    /// A position that is given while the program runs.
    External(ExternalPlace),
}

/// A point: coordinates in mm, or joint angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "PointTable", into = "PointTable")]
pub enum Point {
    /// Coordinates in the base frame or in a frame of the program.
    Cartesian {
        /// x, y and z in mm.
        position: [f64; 3],
        /// The rotation of the tool in degrees, counter-clockwise from the frame's x axis; default
        /// 0.
        rotation: Option<f64>,
        /// The frame; default: the base frame.
        frame: Option<String>,
    },
    /// Angles of base, rear arm, forearm and servo.
    Joints([f64; 4]),
}

impl Point {
    /// A point in the base frame, in mm.
    #[must_use]
    pub const fn xyz(x: f64, y: f64, z: f64) -> Self {
        Self::Cartesian {
            position: [x, y, z],
            rotation: None,
            frame: None,
        }
    }
}

impl From<Point> for Place {
    fn from(point: Point) -> Self {
        Self::At(point)
    }
}

impl From<&str> for Place {
    fn from(name: &str) -> Self {
        Self::Named(name.to_owned())
    }
}

impl<'de> Deserialize<'de> for Place {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(PlaceVisitor)
    }
}

struct PlaceVisitor;

impl<'de> Visitor<'de> for PlaceVisitor {
    type Value = Place;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a point, { x, y, z }, { base, rear, fore } or { from = \"NAME\" }")
    }

    fn visit_str<E>(self, name: &str) -> Result<Place, E> {
        Ok(Place::Named(name.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Place, A::Error> {
        let table = PointTable::deserialize(MapAccessDeserializer::new(map))?;
        table.place().map_err(A::Error::custom)
    }
}

impl JsonSchema for Point {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        PointTable::schema_name()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        PointTable::json_schema(generator)
    }
}

/// A point: x, y and z in mm, with an optional rotation and frame; or base, rear and fore in
/// degrees, with an optional servo.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(
    rename = "Point",
    extend("examples" = [
        {"x": 200, "y": 0, "z": 50},
        {"base": 0, "rear": 45, "fore": 45},
        {"from": "cube"},
    ]),
    extend("x-forms" = [
        ["x", "y", "z", "rotation", "frame"],
        ["base", "rear", "fore", "servo"],
        ["from", "timeout", "otherwise"],
    ])
)]
pub(crate) struct PointTable {
    /// The position forward of the base's axis, or along the frame's x axis, in mm.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    x: Option<f64>,
    /// The position to the left of the base's axis, or along the frame's y axis, in mm.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    y: Option<f64>,
    /// The height above the rear arm's pivot, or the position along the frame's z axis, in mm.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    z: Option<f64>,
    /// The rotation of the tool, counter-clockwise from the frame's x axis, in degrees; default 0.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    rotation: Option<f64>,
    /// The name of a frame; default: the base frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-names" = ["frames"]))]
    frame: Option<String>,
    /// The base's angle in degrees, counter-clockwise seen from above.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    base: Option<f64>,
    /// The rear arm's angle in degrees from the vertical, forward positive.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    rear: Option<f64>,
    /// The forearm's angle in degrees below the horizontal.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    fore: Option<f64>,
    /// The servo's angle in degrees; default 0.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    servo: Option<f64>,
    /// In `go`, `pick` and `place`: the name of a position that is given while the program runs.
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<String>,
    /// If `from` is `seen`: the marker that a camera looks for, 4 to 49.
    #[serde(skip_serializing_if = "Option::is_none")]
    marker: Option<u16>,
    /// How long to wait for that position, in seconds; without it, until it is given.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    timeout: Option<f64>,
    /// What to do after the timeout: `pause` the job (default) or `skip` the step.
    #[serde(skip_serializing_if = "Option::is_none")]
    otherwise: Option<AfterTimeout>,
}

impl TryFrom<PointTable> for Point {
    type Error = String;

    fn try_from(table: PointTable) -> Result<Self, String> {
        match table.place()? {
            Place::At(point) => Ok(point),
            _ => Err("a point has from; a position that is given while the program runs is allowed in go, pick and place".into()),
        }
    }
}

impl PointTable {
    fn place(self) -> Result<Place, String> {
        let found = self.found();
        match self {
            Self {
                x: Some(x),
                y: Some(y),
                z: Some(z),
                rotation,
                frame,
                base: None,
                rear: None,
                fore: None,
                servo: None,
                from: None,
                marker: None,
                timeout: None,
                otherwise: None,
            } => Ok(Place::At(Point::Cartesian {
                position: [x, y, z],
                rotation,
                frame,
            })),
            Self {
                base: Some(base),
                rear: Some(rear),
                fore: Some(fore),
                servo,
                x: None,
                y: None,
                z: None,
                rotation: None,
                frame: None,
                from: None,
                marker: None,
                timeout: None,
                otherwise: None,
            } => Ok(Place::At(Point::Joints([
                base,
                rear,
                fore,
                servo.unwrap_or(0.0),
            ]))),
            Self {
                from: Some(from),
                marker,
                timeout,
                otherwise,
                x: None,
                y: None,
                z: None,
                rotation: None,
                frame: None,
                base: None,
                rear: None,
                fore: None,
                servo: None,
            } => ExternalPlace::new(from, marker, timeout, otherwise).map(Place::External),
            _ => Err(format!(
                "a point has {found}; it needs x, y and z (and may have rotation and frame), or base, rear and fore (and may have servo), or from (and may have timeout and otherwise)"
            )),
        }
    }

    /// The keys of the table, for an error.
    fn found(&self) -> String {
        let keys = [
            ("x", self.x.is_some()),
            ("y", self.y.is_some()),
            ("z", self.z.is_some()),
            ("rotation", self.rotation.is_some()),
            ("frame", self.frame.is_some()),
            ("base", self.base.is_some()),
            ("rear", self.rear.is_some()),
            ("fore", self.fore.is_some()),
            ("servo", self.servo.is_some()),
            ("from", self.from.is_some()),
            ("marker", self.marker.is_some()),
            ("timeout", self.timeout.is_some()),
            ("otherwise", self.otherwise.is_some()),
        ];
        let there: Vec<&str> = keys.iter().filter(|key| key.1).map(|key| key.0).collect();
        if there.is_empty() {
            return "nothing".to_owned();
        }
        there.join(", ")
    }
}

impl From<Point> for PointTable {
    fn from(point: Point) -> Self {
        match point {
            Point::Cartesian {
                position: [x, y, z],
                rotation,
                frame,
            } => Self {
                x: Some(x),
                y: Some(y),
                z: Some(z),
                rotation,
                frame,
                ..Self::default()
            },
            Point::Joints([base, rear, fore, servo]) => Self {
                base: Some(base),
                rear: Some(rear),
                fore: Some(fore),
                servo: Some(servo).filter(|servo| *servo != 0.0),
                ..Self::default()
            },
        }
    }
}
