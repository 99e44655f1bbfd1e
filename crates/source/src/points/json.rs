//! Points in JSON.
//!
//! ```text
//!   [[[0, 0], [10, 0]], [{"x": 5, "y": 5}]]            strokes of points
//!   {"strokes": [{"layer": "red", "color": "#ff0000", "closed": true, "points": [..]}, ..]}
//! ```

use std::fmt;
use std::marker::PhantomData;

use dobot_geometry::Point;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor};

use crate::artwork::{Artwork, Layer};
use crate::error::SourceError;
use crate::limits::LIMIT_MM;
use crate::options::ReadOptions;
use crate::place::Place;
use crate::place::{excerpt, printable};
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;

/// Reads points in JSON.
pub(crate) fn read(
    text: &str,
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut sketch = Sketch::new(text.as_bytes(), options)?;
    let text = text.trim_start_matches('\u{FEFF}');
    for JsonStroke(stroke) in parse(text)?.0 {
        sketch.use_layer(Layer {
            name: stroke
                .layer
                .map(String::from)
                .or(stroke.color.as_ref().map(|it| it.name.clone()))
                .unwrap_or_default(),
            color: stroke.color.map(|it| it.parts),
            ..Layer::default()
        })?;
        let mut points: Vec<Point> = stroke.points.0.into_iter().map(|it| it.0).collect();
        if stroke.closed && points.len() > 2 && points.first() != points.last() {
            points.extend(points.first().copied());
        }
        sketch.stroke(points)?;
    }
    sketch.finish(Y::Down, "no strokes in the file")
}

fn parse(text: &str) -> Result<Strokes, SourceError> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let strokes = serde_path_to_error::deserialize(&mut deserializer).map_err(|error| {
        let path = error.path().to_string();
        refused(text, &path, error.inner())
    })?;
    let end = deserializer.end();
    end.map_err(|error| refused(text, ".", &error))
        .map(|()| strokes)
}

/// What the JSON reader says, in the words of the other readers.
fn refused(text: &str, path: &str, error: &serde_json::Error) -> SourceError {
    let place = Place::new(error.line().max(1), error.column().max(1));
    let message = error.to_string();
    let problem = message.split(" at line ").next().unwrap_or(&message);
    let inside = if path == "." {
        String::new()
    } else {
        format!(" in {path}")
    };
    let (found, expected) = match problem.split_once(", expected ") {
        Some((found, expected)) => {
            let found = found
                .trim_start_matches("invalid type: ")
                .trim_start_matches("invalid value: ");
            let expected = if expected == "f64" {
                "a number"
            } else {
                expected
            };
            (found.to_owned(), expected.to_owned())
        }
        None if error.is_eof() => (
            "the end of the file".to_owned(),
            "the rest of the JSON text".to_owned(),
        ),
        None if error.is_data() => (problem.to_owned(), SHAPE.to_owned()),
        None => (
            excerpt(text.as_bytes(), offset(text, error)),
            format!("JSON ({problem})"),
        ),
    };
    SourceError::Found {
        place,
        found: printable(&(found + &inside)),
        expected,
    }
}

fn offset(text: &str, error: &serde_json::Error) -> usize {
    let lines = text
        .split_inclusive('\n')
        .take(error.line().saturating_sub(1));
    let before: usize = lines.map(str::len).sum();
    before + error.column().saturating_sub(1)
}

/// Everything that the file holds.
struct Strokes(Vec<JsonStroke>);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    strokes: Vec<JsonStroke>,
}

impl From<Document> for Strokes {
    fn from(document: Document) -> Self {
        Self(document.strokes)
    }
}

impl From<Vec<JsonStroke>> for Strokes {
    fn from(strokes: Vec<JsonStroke>) -> Self {
        Self(strokes)
    }
}

impl<'de> Deserialize<'de> for Strokes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ListOr::<Self, Vec<JsonStroke>, Document>::new(SHAPE))
    }
}

/// A line with what belongs to it.
struct JsonStroke(StrokeFields);

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct StrokeFields {
    // Most strokes have neither, and there may be a million of them.
    layer: Option<Box<str>>,
    color: Option<Box<Color>>,
    #[serde(default)]
    closed: bool,
    points: Points,
}

impl From<StrokeFields> for JsonStroke {
    fn from(fields: StrokeFields) -> Self {
        Self(fields)
    }
}

impl From<Points> for JsonStroke {
    fn from(points: Points) -> Self {
        Self(StrokeFields {
            points,
            ..StrokeFields::default()
        })
    }
}

impl<'de> Deserialize<'de> for JsonStroke {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expected = "a stroke: a list of points, or an object with points";
        deserializer.deserialize_any(ListOr::<Self, Points, StrokeFields>::new(expected))
    }
}

/// At least one point.
#[derive(Default)]
struct Points(Vec<JsonPoint>);

impl<'de> Deserialize<'de> for Points {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut points = Vec::deserialize(deserializer)?;
        if points.is_empty() {
            return Err(D::Error::custom(
                "a stroke without points, expected at least one point",
            ));
        }
        // There may be many of them, with room for more.
        points.shrink_to_fit();
        Ok(Self(points))
    }
}

struct JsonPoint(Point);

#[derive(Deserialize)]
#[serde(expecting = "two numbers [x, y]")]
struct NumberPair(Millimetres, Millimetres);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NamedPoint {
    x: Millimetres,
    y: Millimetres,
}

impl From<NumberPair> for JsonPoint {
    fn from(NumberPair(x, y): NumberPair) -> Self {
        Self(Point::new(x.0, y.0))
    }
}

impl From<NamedPoint> for JsonPoint {
    fn from(NamedPoint { x, y }: NamedPoint) -> Self {
        Self(Point::new(x.0, y.0))
    }
}

impl<'de> Deserialize<'de> for JsonPoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expected = r#"a point: [x, y] or {"x": .., "y": ..}"#;
        deserializer.deserialize_any(ListOr::<Self, NumberPair, NamedPoint>::new(expected))
    }
}

struct Millimetres(f64);

impl<'de> Deserialize<'de> for Millimetres {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let number = f64::deserialize(deserializer)?;
        if number.abs() <= LIMIT_MM {
            return Ok(Self(number));
        }
        let expected = &"a number from -1000000 to 1000000 (mm)";
        Err(D::Error::invalid_value(Unexpected::Float(number), expected))
    }
}

/// `#ff0000`
struct Color {
    name: String,
    parts: [u8; 3],
}

impl<'de> Deserialize<'de> for Color {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        match parts(&name) {
            Some(parts) => Ok(Self { name, parts }),
            None => Err(D::Error::invalid_value(
                Unexpected::Str(&name),
                &"a color such as #ff8000",
            )),
        }
    }
}

fn parts(color: &str) -> Option<[u8; 3]> {
    let digits = color.strip_prefix('#')?;
    let is_hex = digits.len() == 6 && digits.bytes().all(|it| it.is_ascii_hexdigit());
    let number = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex)?;
    let [_, red, green, blue] = number.to_be_bytes();
    Some([red, green, blue])
}

/// Reads a `T` from a list, which reads as `L`, or from an object, which reads as `M`.
struct ListOr<T, L, M> {
    expected: &'static str,
    kinds: PhantomData<(T, L, M)>,
}

impl<T, L, M> ListOr<T, L, M> {
    const fn new(expected: &'static str) -> Self {
        Self {
            expected,
            kinds: PhantomData,
        }
    }
}

impl<'de, T, L, M> Visitor<'de> for ListOr<T, L, M>
where
    T: From<L> + From<M>,
    L: Deserialize<'de>,
    M: Deserialize<'de>,
{
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<T, A::Error> {
        L::deserialize(SeqAccessDeserializer::new(list)).map(T::from)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
        M::deserialize(MapAccessDeserializer::new(map)).map(T::from)
    }
}

const SHAPE: &str = r#"a list of strokes, or {"strokes": [..]}"#;
