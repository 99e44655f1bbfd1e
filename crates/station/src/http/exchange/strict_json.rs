//! Strict JSON: errors have a location, and nothing is dropped or guessed.

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use dobot_api::Problem;
use dobot_api::problem_kinds::{INVALID, MALFORMED};
use schemars::{JsonSchema, schema_for};
use serde::de::{
    self, DeserializeOwned, DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor,
};
use serde_json::{Map, Value};

/// Parses a body or a message.
///
/// # Errors
///
/// [`MALFORMED`] with line and column if it is not JSON, [`INVALID`] with the field if it is
/// missing, unknown, duplicated, of another type, or too large for the arm's numbers.
pub(crate) fn read<T: DeserializeOwned + JsonSchema>(text: &[u8]) -> Result<T, Problem> {
    let body = plain(text, &lists_of::<T>()).map_err(|error| not_plain(&error))?;
    if text.len() > LARGEST_SEARCH {
        return parse(body).map_err(Wrong::problem);
    }
    parse(&body).map_err(|mut wrong| {
        let differs = |other: &Value| {
            let other = parse::<T>(other).err();
            other.is_none_or(|other| other.message != wrong.message)
        };
        if let Some(field) = culprit(body.clone(), &wrong, differs) {
            wrong.path = field;
        }
        wrong.problem()
    })
}

fn parse<'de, T: DeserializeOwned>(
    body: impl Deserializer<'de, Error = serde_json::Error>,
) -> Result<T, Wrong> {
    serde_path_to_error::deserialize(body).map_err(|error| Wrong {
        path: error.path().to_string(),
        message: error.inner().to_string(),
    })
}

/// A problem with a value, and its location.
struct Wrong {
    path: String,
    message: String,
}

impl Wrong {
    fn problem(self) -> Problem {
        let Self { path, message } = self;
        INVALID.problem(match &*path {
            "." => message,
            path => format!("{path}: {message}"),
        })
    }
}

fn not_plain(error: &serde_json::Error) -> Problem {
    let place = format!("line {}, column {}", error.line(), error.column());
    let text = error.to_string();
    let appended = format!(" at line {} column {}", error.line(), error.column());
    let message = text.strip_suffix(&appended).unwrap_or(&text);
    let kind = if error.is_data() { INVALID } else { MALFORMED };
    kind.problem(format!("{place}: {message}"))
}

/// Finds the invalid field inside a value whose type depends on one of its fields: the path of the
/// error then ends above it.
///
/// Fields are checked in order, so the invalid one is the last one whose replacement changes the
/// message.
fn culprit(mut body: Value, wrong: &Wrong, differs: impl Fn(&Value) -> bool) -> Option<String> {
    if !wrong.message.starts_with("invalid ") {
        return None;
    }
    let mut leaves = Vec::new();
    collect(&body, String::new(), String::new(), &mut leaves);
    let mut below = leaves
        .into_iter()
        .filter(|leaf| leaf.name.starts_with(wrong.path.trim_start_matches('.')));
    let is_culprit = |leaf: &Leaf| {
        let value = body.pointer_mut(&leaf.pointer).expect("found above");
        let found = std::mem::replace(value, Value::Array(vec![Value::Null]));
        let differs = differs(&body);
        *body.pointer_mut(&leaf.pointer).expect("found above") = found;
        differs
    };
    below.rfind(is_culprit).map(|leaf| leaf.name)
}

/// The maximum length of a text in which the invalid field is searched, in bytes.
const LARGEST_SEARCH: usize = 4096;

/// A value without nested values.
struct Leaf {
    /// Its location as a JSON pointer.
    pointer: String,
    /// Its location for messages.
    name: String,
}

fn collect(value: &Value, pointer: String, name: String, leaves: &mut Vec<Leaf>) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                let escaped = key.replace('~', "~0").replace('/', "~1");
                let dot = if name.is_empty() { "" } else { "." };
                let pointer = format!("{pointer}/{escaped}");
                collect(value, pointer, format!("{name}{dot}{key}"), leaves);
            }
        }
        Value::Array(items) => {
            for (index, value) in items.iter().enumerate() {
                let pointer = format!("{pointer}/{index}");
                collect(value, pointer, format!("{name}[{index}]"), leaves);
            }
        }
        _ => leaves.push(Leaf { pointer, name }),
    }
}

/// The list fields of a type, and their nesting depths.
type Lists = HashMap<String, usize>;

/// Returns the list fields of a type, from its schema. Cached: generating a schema takes longer
/// than parsing a message.
fn lists_of<T: JsonSchema>() -> Arc<Lists> {
    static KNOWN: LazyLock<Mutex<HashMap<Cow<'static, str>, Arc<Lists>>>> =
        LazyLock::new(Mutex::default);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let lists = known.entry(T::schema_id()).or_insert_with(|| {
        let mut lists = Lists::new();
        let schema = schema_for!(T);
        collect_lists(schema.as_value(), schema.as_value(), &mut lists);
        Arc::new(lists)
    });
    Arc::clone(lists)
}

/// Collects the list fields of a part of a schema, whose named types are in `root`.
fn collect_lists(root: &Value, schema: &Value, lists: &mut Lists) {
    let fields = schema.get("properties").and_then(Value::as_object);
    let named = fields.into_iter().flatten();
    for (name, field) in named {
        let most = lists.entry(name.clone()).or_default();
        *most = lists_in(of_name(root, field)).max(*most);
    }
    match schema {
        Value::Object(parts) => parts
            .values()
            .for_each(|value| collect_lists(root, value, lists)),
        Value::Array(parts) => parts
            .iter()
            .for_each(|value| collect_lists(root, value, lists)),
        _ => {}
    }
}

/// Resolves the schema of a field with a named type.
fn of_name<'a>(root: &'a Value, field: &'a Value) -> &'a Value {
    let name = field.get("$ref").and_then(Value::as_str);
    let place = name.and_then(|name| name.strip_prefix('#'));
    place.and_then(|place| root.pointer(place)).unwrap_or(field)
}

/// Returns the nesting depth of lists that a schema allows, directly or in an alternative.
fn lists_in(schema: &Value) -> usize {
    let is_list = |name: &Value| name == "array";
    let of_list = || schema.get("items").map_or(0, lists_in).saturating_add(1);
    match schema.get("type") {
        Some(Value::Array(types)) if types.iter().any(is_list) => of_list(),
        Some(name) if is_list(name) => of_list(),
        Some(_) => 0,
        None if is_any(schema) => ANY,
        None => {
            let choices = ["anyOf", "oneOf"]
                .iter()
                .filter_map(|keyword| schema.get(keyword));
            let choices = choices.filter_map(Value::as_array).flatten();
            choices.map(lists_in).max().unwrap_or_default()
        }
    }
}

/// Whether a schema allows every value, as that of a request for another station does.
fn is_any(schema: &Value) -> bool {
    let limits = ["$ref", "allOf", "anyOf", "const", "enum", "oneOf"];
    schema == true || schema.is_object() && limits.iter().all(|name| schema.get(name).is_none())
}

/// The nesting depth of lists in a field that may hold every value.
const ANY: usize = usize::MAX;

/// Parses JSON without ambiguity: numbers within the range of the arm's numbers, no duplicate
/// fields, and lists only where lists are allowed, since structures could be read from lists too.
fn plain(text: &[u8], known: &Lists) -> Result<Value, serde_json::Error> {
    let mut json = serde_json::Deserializer::from_slice(text);
    let value = Plain { lists: 0, known }.deserialize(&mut json)?;
    json.end()?;
    Ok(value)
}

/// A reader of such a value.
#[derive(Clone, Copy)]
struct Plain<'a> {
    /// The allowed nesting depth of lists.
    lists: usize,
    known: &'a Lists,
}

impl<'de> DeserializeSeed<'de> for Plain<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Plain<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_u64<E>(self, number: u64) -> Result<Value, E> {
        Ok(number.into())
    }

    fn visit_i64<E>(self, number: i64) -> Result<Value, E> {
        Ok(number.into())
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<Value, E> {
        if number.abs() <= f64::from(f32::MAX) {
            return Ok(number.into());
        }
        Err(E::custom(format_args!(
            "{number:e} is too large; allowed are -3.4e38 to 3.4e38"
        )))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(text.into())
    }

    fn visit_string<E>(self, text: String) -> Result<Value, E> {
        Ok(text.into())
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let lists = match self.lists {
            0 => return Err(de::Error::custom("found a list, which is not allowed here")),
            ANY => ANY,
            lists => lists - 1,
        };
        let mut list = Vec::new();
        while let Some(item) = items.next_element_seed(Self { lists, ..self })? {
            list.push(item);
        }
        Ok(list.into())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Value, A::Error> {
        let mut map = Map::new();
        while let Some(name) = fields.next_key::<String>()? {
            let lists = match self.lists {
                ANY => ANY,
                _ => self.known.get(&name).copied().unwrap_or_default(),
            };
            if map.contains_key(&name) {
                return Err(de::Error::custom(format_args!("duplicate field `{name}`")));
            }
            let value = fields.next_value_seed(Self { lists, ..self })?;
            map.insert(name, value);
        }
        Ok(map.into())
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::{ApiRequest, NewJob, Recipients, Request};
    use dobot_wire::Command;

    use super::*;

    fn detail<T: DeserializeOwned + JsonSchema + fmt::Debug>(text: &str) -> (u16, String) {
        let problem = read::<T>(text.as_bytes()).unwrap_err();
        (problem.status, problem.detail)
    }

    fn command(x_mm: &str) -> String {
        format!(
            r#"{{"type": "move_to", "x_mm": {x_mm}, "y_mm": 0, "z_mm": 50, "rotation_deg": 0,
                "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0}}"#
        )
    }

    #[test]
    fn reads_correct_json() {
        assert!(matches!(
            read(command("200").as_bytes()).unwrap(),
            Command::MoveTo(target) if target.x_mm == 200.0
        ));
    }

    #[test]
    fn several_stations_of_a_fleet_are_addressed_by_their_names() {
        let named = read::<Recipients>(br#"{"members": ["desk-3", "desk-7"]}"#).unwrap();
        let expected = ["desk-3", "desk-7"].map(String::from).to_vec();
        assert_eq!(named, Recipients::Members(expected));
    }

    #[test]
    fn a_request_for_another_station_may_have_lists_in_its_body() {
        let text = r#"{"method": "PUT", "path": "/api/v1/slots", "body": {"slots": [{"days": [[1, 2]]}]}}"#;
        let body = read::<ApiRequest>(text.as_bytes()).unwrap().body.unwrap();
        assert_eq!(body["slots"][0]["days"][0][1], 2);
        let (_, detail) = detail::<ApiRequest>(&text.replace("[1, 2]]", "[1, 2]], \"days\": []"));
        assert!(detail.ends_with("duplicate field `days`"), "{detail}");
    }

    #[test]
    fn text_that_is_not_json_is_reported_with_its_place() {
        let (status, detail) = detail::<Command>("{\n  \"type\": oops}");
        assert_eq!(
            (status, &*detail),
            (400, "line 2, column 11: expected value")
        );
    }

    #[test]
    fn numbers_too_large_for_the_arm_never_become_infinite() {
        for number in ["1e999", "-1e999", "1e39", "-1e300"] {
            let (status, detail) = detail::<Command>(&command(number));
            assert!(matches!(status, 400 | 422), "{number}: {status} {detail}");
            assert!(detail.contains("line 1, column"), "{detail}");
        }
    }

    #[test]
    fn a_wrong_type_is_reported_with_its_field() {
        let (status, detail) = detail::<Command>(&command("\"far\""));
        assert_eq!(status, 422);
        assert_eq!(detail, "x_mm: invalid type: string \"far\", expected f32");
    }

    #[test]
    fn the_wrong_one_of_two_equal_values_is_reported() {
        let text = command("200").replace("\"rotation_deg\": 0", "\"rotation_deg\": false");
        let (_, detail) = detail::<Command>(&text);
        assert!(
            detail.starts_with("rotation_deg: invalid type: boolean"),
            "{detail}"
        );
    }

    #[test]
    fn a_field_inside_a_list_is_reported_with_its_number() {
        let text = format!(
            r#"{{"title": "a", "kind": "drawing", "commands": [{}, {}]}}"#,
            command("200"),
            command("null")
        );
        let (_, detail) = detail::<NewJob>(&text);
        assert!(
            detail.starts_with("commands[1].x_mm: invalid type: null"),
            "{detail}"
        );
    }

    #[test]
    fn unknown_fields_are_reported_and_not_dropped() {
        let text = command("200").replace("\"x_mm\"", "\"x\": 1, \"x_mm\"");
        let (status, text) = detail::<Command>(&text);
        assert_eq!(status, 422);
        assert!(
            text.starts_with("unknown field `x`, expected one of"),
            "{text}"
        );
        let (_, text) = detail::<Request>(r#"{"type": "start_job", "job": 3, "now": true}"#);
        assert!(text.contains("unknown field `now`"), "{text}");
    }

    #[test]
    fn a_list_is_not_accepted_as_the_fields_of_a_structure() {
        for list in [
            r#"["move_to", 200, 0, 50, 0, false, "jump", 0, 0]"#,
            r#"{"type": "voice", "text": ["x"]}"#,
            r#"[[["move_to"]]]"#,
        ] {
            let (status, detail) = detail::<Command>(list);
            assert_eq!(status, 422);
            assert!(
                detail.ends_with("found a list, which is not allowed here"),
                "{detail}"
            );
        }
        let (status, _) = detail::<NewJob>(r#"["a", "drawing", [["release"]], 0]"#);
        assert_eq!(status, 422);
    }

    #[test]
    fn a_duplicate_field_is_refused() {
        let (status, detail) = detail::<Command>(&command("200, \"x_mm\": 210"));
        assert_eq!(status, 422);
        assert_eq!(detail, "line 1, column 39: duplicate field `x_mm`");
    }

    #[test]
    fn missing_fields_are_reported() {
        let (status, detail) = detail::<Command>(r#"{"type": "move_to"}"#);
        assert_eq!((status, &*detail), (422, "missing field `x_mm`"));
    }

    #[test]
    fn endless_nesting_is_refused() {
        let deep = "{\"a\":".repeat(100_000);
        assert_eq!(detail::<Command>(&deep).0, 400);
    }

    #[test]
    fn text_after_the_end_is_reported() {
        assert_eq!(detail::<Command>(&(command("200") + "x")).0, 400);
    }
}
