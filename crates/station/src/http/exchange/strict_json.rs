//! JSON, read strictly: what is wrong is told with its place, and nothing is dropped or guessed.

use std::fmt;
use std::sync::LazyLock;

use dobot_api::problem_kinds::{INVALID, MALFORMED};
use dobot_api::{FromClient, Problem, Recipients};
use schemars::schema_for;
use serde::Deserialize;
use serde::de::{
    self, DeserializeOwned, DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor,
};
use serde_json::Value;

use super::requester::EditPolicy;
use crate::http::fleet_routes::offers::FleetOffer;
use crate::http::fleet_routes::work::FleetWork;
use crate::http::resources::drawings::NewDrawing;
use crate::http::resources::programs::EditProgram;
use crate::http::routes::{NewFaults, NewTouches, PaperTouches};

/// Reads a body or a message.
///
/// # Errors
///
/// [`MALFORMED`] with line and column where it is no JSON, [`INVALID`] with the field where it is
/// not what it has to be: missing, unknown, of another type, too large for the arm's numbers.
pub(crate) fn read<T: DeserializeOwned>(text: &[u8]) -> Result<T, Problem> {
    look_through(text).map_err(|error| not_plain(&error))?;
    parse(text).map_err(|wrong| invalid(text, wrong, |text| parse::<T>(text).err()))
}

fn parse<T: DeserializeOwned>(text: &[u8]) -> Result<T, Wrong> {
    let mut json = serde_json::Deserializer::from_slice(text);
    serde_path_to_error::deserialize(&mut json).map_err(|error| Wrong::new(&error))
}

/// What is wrong with a value, and where.
struct Wrong {
    path: String,
    message: String,
}

impl Wrong {
    fn new(error: &serde_path_to_error::Error<serde_json::Error>) -> Self {
        Self {
            path: error.path().to_string(),
            message: bare(error.inner()),
        }
    }
}

/// What is wrong with a text; `check` reads one as the same type.
fn invalid(text: &[u8], wrong: Wrong, check: fn(&[u8]) -> Option<Wrong>) -> Problem {
    let field = culprit(text, &wrong, check).unwrap_or(wrong.path);
    let message = wrong.message;
    INVALID.problem(match &*field {
        "." => message,
        field => format!("{field}: {message}"),
    })
}

fn not_plain(error: &serde_json::Error) -> Problem {
    let place = format!("line {}, column {}", error.line(), error.column());
    let kind = if error.is_data() { INVALID } else { MALFORMED };
    kind.problem(format!("{place}: {}", bare(error)))
}

/// The message without the place that `serde_json` appends.
fn bare(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    text.strip_suffix(&place).map_or(text.clone(), Into::into)
}

/// The field that is wrong inside of a value whose fields are read out of order, because its type
/// tells how: then the path of the error ends above it.
///
/// Fields are looked at in their order, so the wrong one is the last one whose replacement makes a
/// difference to the message.
fn culprit(text: &[u8], wrong: &Wrong, check: fn(&[u8]) -> Option<Wrong>) -> Option<String> {
    if text.len() > LARGEST_SEARCH || !wrong.message.starts_with("invalid ") {
        return None;
    }
    let body: Value = serde_json::from_slice(text).ok()?;
    let mut leaves = Vec::new();
    collect(&body, String::new(), String::new(), &mut leaves);
    let mut below = leaves
        .into_iter()
        .filter(|leaf| leaf.name.starts_with(wrong.path.trim_start_matches('.')));
    let differs = |leaf: &Leaf| {
        let mut other = body.clone();
        if let Some(value) = other.pointer_mut(&leaf.pointer) {
            *value = Value::Array(vec![Value::Null]);
        }
        check(other.to_string().as_bytes()).is_none_or(|it| it.message != wrong.message)
    };
    below.rfind(differs).map(|leaf| leaf.name)
}

const LARGEST_SEARCH: usize = 4096;

/// A value without values in it.
struct Leaf {
    /// Its place as a JSON pointer.
    pointer: String,
    /// Its place as people write it.
    name: String,
}

fn collect(value: &Value, pointer: String, name: String, leaves: &mut Vec<Leaf>) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                let escaped = key.replace('~', "~0").replace('/', "~1");
                let dot = if name.is_empty() { "" } else { "." };
                collect(
                    value,
                    format!("{pointer}/{escaped}"),
                    format!("{name}{dot}{key}"),
                    leaves,
                );
            }
        }
        Value::Array(items) => {
            for (index, value) in items.iter().enumerate() {
                collect(
                    value,
                    format!("{pointer}/{index}"),
                    format!("{name}[{index}]"),
                    leaves,
                );
            }
        }
        _ => leaves.push(Leaf { pointer, name }),
    }
}

/// Any JSON of which every part can only be meant in one way: numbers that the arm's numbers can hold,
/// and lists only where there are some, since structures could be read from lists too.
#[derive(Clone, Copy)]
struct Plain {
    /// How many lists, one in the other, it may be.
    lists: usize,
}

/// The fields of requests that hold a list, and how many lists there are one in the other, as their types say.
static LISTS: LazyLock<Vec<(String, usize)>> = LazyLock::new(|| {
    let mut lists = Vec::new();
    for schema in [
        schema_for!(FromClient),
        schema_for!(EditPolicy),
        schema_for!(EditProgram),
        schema_for!(NewDrawing),
        schema_for!(FleetWork),
        schema_for!(FleetOffer),
        schema_for!(NewFaults),
        schema_for!(NewTouches),
        schema_for!(PaperTouches),
        schema_for!(Recipients),
    ] {
        collect_lists(schema.as_value(), schema.as_value(), &mut lists);
    }
    lists
});

/// Collects the lists of a part of a schema, whose named types are in `root`.
fn collect_lists(root: &Value, schema: &Value, lists: &mut Vec<(String, usize)>) {
    let fields = schema.get("properties").and_then(Value::as_object);
    let named = fields.into_iter().flatten();
    lists.extend(
        named
            .map(|(name, field)| (name.clone(), lists_in(of_name(root, field))))
            .filter(|(_, lists)| *lists > 0),
    );
    match schema {
        Value::Object(parts) => parts.values().for_each(|it| collect_lists(root, it, lists)),
        Value::Array(parts) => parts.iter().for_each(|it| collect_lists(root, it, lists)),
        _ => {}
    }
}

/// The schema itself, also of a field whose type has a name.
fn of_name<'a>(root: &'a Value, field: &'a Value) -> &'a Value {
    let name = field.get("$ref").and_then(Value::as_str);
    let place = name.and_then(|it| it.strip_prefix('#'));
    place.and_then(|it| root.pointer(it)).unwrap_or(field)
}

fn lists_in(schema: &Value) -> usize {
    let is_list = |name: &Value| name == "array";
    let of_list = || 1 + schema.get("items").map_or(0, lists_in);
    match schema.get("type") {
        Some(Value::Array(types)) if types.iter().any(is_list) => of_list(),
        Some(name) if is_list(name) => of_list(),
        Some(_) => 0,
        None => {
            let choices = ["anyOf", "oneOf"].iter().filter_map(|it| schema.get(it));
            let choices = choices.filter_map(Value::as_array).flatten();
            choices.map(lists_in).max().unwrap_or_default()
        }
    }
}

impl<'de> DeserializeSeed<'de> for Plain {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Plain {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_bool<E>(self, _: bool) -> Result<(), E> {
        Ok(())
    }

    fn visit_u64<E>(self, _: u64) -> Result<(), E> {
        Ok(())
    }

    fn visit_i64<E>(self, _: i64) -> Result<(), E> {
        Ok(())
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<(), E> {
        if number.abs() <= f64::from(f32::MAX) {
            return Ok(());
        }
        Err(E::custom(format_args!(
            "{number:e} is too large; numbers go from -3.4e38 to 3.4e38"
        )))
    }

    fn visit_str<E>(self, _: &str) -> Result<(), E> {
        Ok(())
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        let Some(lists) = self.lists.checked_sub(1) else {
            return Err(de::Error::custom("there is a list; this takes none"));
        };
        while items.next_element_seed(Self { lists })?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<(), A::Error> {
        while let Some(Name(lists)) = fields.next_key()? {
            fields.next_value_seed(Self { lists })?;
        }
        Ok(())
    }
}

const NO_LIST: Plain = Plain { lists: 0 };

/// The name of a field: how many lists it holds, one in the other.
struct Name(usize);

impl<'de> Deserialize<'de> for Name {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;

        impl Visitor<'_> for Reader {
            type Value = Name;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a name")
            }

            fn visit_str<E>(self, name: &str) -> Result<Name, E> {
                let named = LISTS.iter().filter(|it| it.0 == name);
                Ok(Name(named.map(|it| it.1).max().unwrap_or_default()))
            }
        }

        deserializer.deserialize_str(Reader)
    }
}

/// Whether text is JSON of that kind, from its start to its end.
fn look_through(text: &[u8]) -> Result<(), serde_json::Error> {
    let mut json = serde_json::Deserializer::from_slice(text);
    NO_LIST.deserialize(&mut json)?;
    json.end()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::{NewJob, Request};
    use dobot_wire::Command;

    use super::*;

    fn detail<T: DeserializeOwned + fmt::Debug>(text: &str) -> (u16, String) {
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
    fn reads_what_is_right() {
        assert!(matches!(
            read(command("200").as_bytes()).unwrap(),
            Command::MoveTo(target) if target.x_mm == 200.0
        ));
    }

    #[test]
    fn several_stations_of_a_fleet_are_asked_by_their_names() {
        let named = read::<Recipients>(br#"{"members": ["desk-3", "desk-7"]}"#).unwrap();
        let expected = ["desk-3", "desk-7"].map(String::from).to_vec();
        assert_eq!(named, Recipients::Members(expected));
    }

    #[test]
    fn text_that_is_no_json_is_told_with_its_place() {
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
    fn a_wrong_type_is_told_with_its_field() {
        let (status, detail) = detail::<Command>(&command("\"far\""));
        assert_eq!(status, 422);
        assert_eq!(detail, "x_mm: invalid type: string \"far\", expected f32");
    }

    #[test]
    fn the_wrong_one_of_two_equal_values_is_told() {
        let text = command("200").replace("\"rotation_deg\": 0", "\"rotation_deg\": false");
        let (_, detail) = detail::<Command>(&text);
        assert!(
            detail.starts_with("rotation_deg: invalid type: boolean"),
            "{detail}"
        );
    }

    #[test]
    fn a_field_inside_of_a_list_is_told_with_its_number() {
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
    fn fields_that_do_not_exist_are_told_and_not_dropped() {
        let text = command("200").replace("\"x_mm\"", "\"x\": 1, \"x_mm\"");
        let (status, told) = detail::<Command>(&text);
        assert_eq!(status, 422);
        assert!(
            told.starts_with("unknown field `x`, expected one of"),
            "{told}"
        );
        let (_, told) = detail::<Request>(r#"{"type": "start_job", "job": 3, "now": true}"#);
        assert!(told.contains("unknown field `now`"), "{told}");
    }

    #[test]
    fn a_list_is_not_taken_for_the_fields_of_a_structure() {
        for list in [
            r#"["move_to", 200, 0, 50, 0, false, "jump", 0, 0]"#,
            r#"{"type": "voice", "text": ["x"]}"#,
            r#"[[["move_to"]]]"#,
        ] {
            let (status, detail) = detail::<Command>(list);
            assert_eq!(status, 422);
            assert!(
                detail.ends_with("there is a list; this takes none"),
                "{detail}"
            );
        }
        let (status, _) = detail::<NewJob>(r#"["a", "drawing", [["release"]], 0]"#);
        assert_eq!(status, 422);
    }

    #[test]
    fn missing_fields_are_told() {
        let (status, detail) = detail::<Command>(r#"{"type": "move_to"}"#);
        assert_eq!((status, &*detail), (422, "missing field `x_mm`"));
    }

    #[test]
    fn what_is_nested_without_end_is_no_json_of_ours() {
        let deep = "{\"a\":".repeat(100_000);
        assert_eq!(detail::<Command>(&deep).0, 400);
    }

    #[test]
    fn text_after_the_end_is_told() {
        assert_eq!(detail::<Command>(&(command("200") + "x")).0, 400);
    }
}
