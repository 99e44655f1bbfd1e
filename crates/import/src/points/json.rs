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
use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor};
use serde_path_to_error::Track;

use crate::artwork::{Artwork, Layer};
use crate::error::SourceError;
use crate::limits::{LIMIT_MM, MAX_SEGMENTS};
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
    draw(text, &mut sketch)?;
    sketch.finish(Y::Down, "no strokes in the file")
}

fn draw(text: &str, sketch: &mut Sketch<'_>) -> Result<(), SourceError> {
    let mut reader = StrokeReader {
        sketch,
        refused: None,
    };
    let mut json = serde_json::Deserializer::from_str(text);
    let mut track = Track::new();
    let tracked = serde_path_to_error::Deserializer::new(&mut json, &mut track);
    if let Err(error) = tracked.deserialize_any(&mut reader) {
        let refusal = reader.refused.take();
        return Err(refusal.unwrap_or_else(|| refused(text, &track.path().to_string(), &error)));
    }
    let end = json.end();
    end.map_err(|error| refused(text, ".", &error))
}

/// Draws each stroke once it is read, because all of them together would fill the memory.
struct StrokeReader<'s, 'a> {
    sketch: &'s mut Sketch<'a>,
    /// The error of the last stroke.
    refused: Option<SourceError>,
}

impl StrokeReader<'_, '_> {
    fn all<'de, A: SeqAccess<'de>>(&mut self, mut list: A) -> Result<(), A::Error> {
        while let Some(JsonStroke(stroke)) = list.next_element()? {
            self.draw(stroke).map_err(|error| {
                self.refused = Some(error);
                A::Error::custom("a stroke that cannot be drawn")
            })?;
        }
        Ok(())
    }

    fn draw(&mut self, stroke: StrokeFields) -> Result<(), SourceError> {
        self.sketch.use_layer(Layer {
            name: stroke
                .layer
                .or(stroke.color.as_ref().map(|color| color.name.clone()))
                .unwrap_or_default(),
            color: stroke.color.map(|color| color.parts),
            ..Layer::default()
        })?;
        // Without spare capacity, for there may be a million of them.
        let list = stroke.points.0;
        let mut points = Vec::with_capacity(list.len() + usize::from(stroke.closed));
        points.extend(list.into_iter().map(|entry| entry.0));
        if stroke.closed && points.len() > 2 && points.first() != points.last() {
            points.extend(points.first().copied());
        }
        self.sketch.stroke(points)
    }
}

impl<'de> Visitor<'de> for &mut StrokeReader<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(SHAPE)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<(), A::Error> {
        self.all(list)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let mut is_found = false;
        while let Some(DocumentField::Strokes) = map.next_key()? {
            if std::mem::replace(&mut is_found, true) {
                return Err(A::Error::duplicate_field("strokes"));
            }
            map.next_value_seed(StrokeList(&mut *self))?;
        }
        is_found
            .then_some(())
            .ok_or_else(|| A::Error::missing_field("strokes"))
    }
}

/// The keys of an object that is a drawing.
#[derive(Deserialize)]
#[serde(field_identifier, rename_all = "lowercase")]
enum DocumentField {
    Strokes,
}

/// The list of strokes in such an object.
struct StrokeList<'r, 's, 'a>(&'r mut StrokeReader<'s, 'a>);

impl<'de> DeserializeSeed<'de> for StrokeList<'_, '_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for StrokeList<'_, '_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<(), A::Error> {
        self.0.all(list)
    }
}

/// The error of the JSON parser, in the form of the other readers.
fn refused(text: &str, path: &str, error: &serde_json::Error) -> SourceError {
    let place = Place::new(error.line().max(1), error.column().max(1));
    let message = error.to_string();
    let problem = message.split(" at line ").next().unwrap_or(&message);
    let inside = if path == "." {
        String::new()
    } else {
        format!(" in {path}")
    };
    let (found, expected) = found_and_expected(text, problem, error);
    SourceError::Found {
        place,
        found: printable(&(found + &inside)),
        expected,
    }
}

fn found_and_expected(text: &str, problem: &str, error: &serde_json::Error) -> (String, String) {
    match problem.rsplit_once(", expected ") {
        _ if error.is_eof() => (
            "the end of the file".to_owned(),
            "the rest of the JSON text".to_owned(),
        ),
        Some((problem, expected)) => (plain_problem(problem), plain_type(expected).to_owned()),
        None if error.is_data() => (plain_problem(problem), SHAPE.to_owned()),
        None => (
            excerpt(text.as_bytes(), offset(text, error)),
            format!("JSON ({problem})"),
        ),
    }
}

/// A problem of the JSON parser without its names of types: ``string "a"`` is `text "a"`.
fn plain_problem(problem: &str) -> String {
    let problem = ["invalid type: ", "invalid value: "]
        .iter()
        .find_map(|start| problem.strip_prefix(start))
        .unwrap_or(problem);
    let number = ["integer `", "floating point `"];
    if let Some(number) = number.iter().find_map(|start| problem.strip_prefix(start)) {
        return format!("the number {}", number.trim_end_matches('`'));
    }
    let replaced = [
        ("invalid length ", "a list of length "),
        ("missing field ", "no key "),
        ("unknown field ", "the unknown key "),
        ("string ", "the text "),
    ];
    for (start, plain) in replaced {
        if let Some(rest) = problem.strip_prefix(start) {
            return format!("{plain}{rest}");
        }
    }
    if let Some(key) = problem.strip_prefix("duplicate field ") {
        return format!("the key {key} twice");
    }
    if let Some(boolean) = problem.strip_prefix("boolean `") {
        return boolean.trim_end_matches('`').to_owned();
    }
    match problem {
        "map" => "an object".to_owned(),
        "sequence" => "a list".to_owned(),
        other => other.to_owned(),
    }
}

/// A Rust type in the terms of JSON.
fn plain_type(expected: &str) -> &str {
    match expected {
        "f64" => "a number",
        "a sequence" => "a list",
        "a string" => "a text",
        "a boolean" => "true or false",
        "a map" => "an object",
        _ if expected.starts_with("struct ") => "an object",
        other => other,
    }
}

fn offset(text: &str, error: &serde_json::Error) -> usize {
    let lines = text
        .split_inclusive('\n')
        .take(error.line().saturating_sub(1));
    let before: usize = lines.map(str::len).sum();
    before + error.column().saturating_sub(1)
}

/// A stroke with its attributes.
struct JsonStroke(StrokeFields);

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct StrokeFields {
    layer: Option<String>,
    color: Option<Color>,
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
        deserializer.deserialize_seq(PointList)
    }
}

/// The list of points of a stroke.
struct PointList;

impl<'de> Visitor<'de> for PointList {
    type Value = Points;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Points, A::Error> {
        let mut points = Vec::new();
        while let Some(point) = list.next_element()? {
            // Before the rest of them fills the memory.
            if points.len() == MAX_SEGMENTS {
                return Err(A::Error::custom(format!(
                    "a stroke of more than {MAX_SEGMENTS} points, expected at most that in a drawing; simplify it"
                )));
            }
            points.push(point);
        }
        if points.is_empty() {
            return Err(A::Error::custom(
                "a stroke without points, expected at least one point",
            ));
        }
        Ok(Points(points))
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
    let is_hex = digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    let number = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex)?;
    let [_, red, green, blue] = number.to_be_bytes();
    Some([red, green, blue])
}

/// Reads a `T` from a list by `L`, or from an object by `M`.
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
