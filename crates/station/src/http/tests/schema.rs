//! Values that a JSON Schema allows, and values that it does not.

use proptest::prelude::*;
use serde_json::{Map, Value, json};

/// Values that a schema of the document allows; recursive types are nested once.
pub(super) fn instance(document: &Value, schema: &Value) -> BoxedStrategy<Value> {
    within(document, schema, &[]).expect("a value need not stand in itself")
}

/// Values within referenced schemas; `None` if a type would be nested in itself.
fn within(document: &Value, schema: &Value, outer: &[&str]) -> Option<BoxedStrategy<Value>> {
    if let Some(target) = reference(document, schema) {
        let name = schema["$ref"].as_str()?;
        let inner = [outer, &[name]].concat();
        return (!outer.contains(&name))
            .then(|| within(document, target, &inner))
            .flatten();
    }
    if let Some(constant) = schema.get("const") {
        return Some(Just(constant.clone()).boxed());
    }
    if let Some(values) = schema["enum"].as_array() {
        return Some(prop::sample::select(values.clone()).boxed());
    }
    let strategies: Vec<_> = match choices(schema) {
        Some(choices) => choices
            .iter()
            .filter_map(|choice| within(document, choice, outer))
            .collect(),
        None => types(schema)
            .iter()
            .filter_map(|kind| of_type(document, schema, kind, outer))
            .collect(),
    };
    (!strategies.is_empty()).then(|| proptest::strategy::Union::new(strategies).boxed())
}

fn of_type(
    document: &Value,
    schema: &Value,
    name: &str,
    outer: &[&str],
) -> Option<BoxedStrategy<Value>> {
    Some(match name {
        "null" => Just(Value::Null).boxed(),
        "boolean" => any::<bool>().prop_map(Value::from).boxed(),
        "integer" => (0_u64..1_000_000).prop_map(Value::from).boxed(),
        "number" => (1_u8..=100).prop_map(|n| json!(f64::from(n) + 0.5)).boxed(),
        "string" => "[a-z][a-z ]{0,20}".prop_map(Value::from).boxed(),
        "array" => {
            let items = within(document, &schema["items"], outer)?;
            prop::collection::vec(items, 1..3)
                .prop_map(Value::from)
                .boxed()
        }
        "object" => object(document, schema, outer)?,
        other => panic!("no value of type {other}"),
    })
}

fn object(document: &Value, schema: &Value, outer: &[&str]) -> Option<BoxedStrategy<Value>> {
    let no_fields = Map::new();
    let fields = schema["properties"].as_object().unwrap_or(&no_fields);
    let mut strategies = Vec::new();
    for (name, field) in fields {
        let value = match within(document, field, outer) {
            Some(value) if requires(schema, name) => value.prop_map(Some).boxed(),
            Some(value) => prop::option::of(value).boxed(),
            None if requires(schema, name) => return None,
            None => continue,
        };
        strategies.push((Just(name.clone()), value));
    }
    let named = strategies.prop_map(|fields| {
        fields
            .into_iter()
            .filter_map(|(name, value)| Some((name, value?)))
            .collect()
    });
    Some(named.boxed())
}

/// Whether a schema allows a value, regarding types, fields and choices; `closely` includes lengths
/// and ranges.
pub(super) fn allows(document: &Value, schema: &Value, value: &Value, closely: bool) -> bool {
    if let Some(target) = reference(document, schema) {
        return allows(document, target, value, closely);
    }
    let allowed = |choice: &Value| allows(document, choice, value, closely);
    choices(schema).is_none_or(|choices| choices.iter().any(allowed))
        && schema.get("const").is_none_or(|constant| constant == value)
        && schema["enum"]
            .as_array()
            .is_none_or(|kinds| kinds.contains(value))
        && is_of_type(schema, value)
        && has_fields(document, schema, value, closely)
        && has_items(document, schema, value, closely)
        && in_range(schema, value, closely)
}

fn is_of_type(schema: &Value, value: &Value) -> bool {
    let types = types(schema);
    types.is_empty()
        || types.into_iter().any(|name| match name {
            "null" => value.is_null(),
            "boolean" => value.is_boolean(),
            "integer" => value.is_u64() || value.is_i64(),
            "number" => value
                .as_f64()
                .is_some_and(|number| number.abs() <= f64::from(f32::MAX)),
            "string" => value.is_string(),
            "array" => value.is_array(),
            "object" => value.is_object(),
            other => panic!("no type {other}"),
        })
}

fn has_fields(document: &Value, schema: &Value, value: &Value, closely: bool) -> bool {
    let (Some(value), true) = (value.as_object(), choices(schema).is_none()) else {
        return true;
    };
    let more = &schema["additionalProperties"];
    let known = |(name, field): (&String, &Value)| match schema["properties"].get(name) {
        Some(schema) => allows(document, schema, field, closely),
        None if more.is_object() => allows(document, more, field, closely),
        None => *more != false,
    };
    let needed = schema["required"].as_array().map_or(&[][..], Vec::as_slice);
    value.iter().all(known)
        && needed
            .iter()
            .all(|name| value.contains_key(name.as_str().unwrap()))
}

fn has_items(document: &Value, schema: &Value, value: &Value, closely: bool) -> bool {
    let (Some(items), Some(schema)) = (value.as_array(), schema.get("items")) else {
        return true;
    };
    items
        .iter()
        .all(|item| allows(document, schema, item, closely))
}

fn in_range(schema: &Value, value: &Value, closely: bool) -> bool {
    let limit = |name: &str| schema[name].as_f64();
    let length = |name: &str| schema[name].as_u64();
    // Negative integers are of the wrong type; other numbers are checked by the driver.
    let is_whole = types(schema).contains(&"integer");
    if let Some(number) = value.as_f64().filter(|_| closely || is_whole) {
        return limit("minimum").is_none_or(|least| number >= least)
            && limit("maximum").is_none_or(|limit| number <= limit);
    }
    let len = match value {
        Value::String(text) => text.len(),
        Value::Array(items) => items.len(),
        _ => return true,
    };
    let len = len as u64;
    let least = length("minLength").or(length("minItems"));
    let most = length("maxLength").or(length("maxItems"));
    !closely || (least.is_none_or(|least| len >= least) && most.is_none_or(|most| len <= most))
}

/// A value with a change that may make it invalid.
pub(super) fn damaged(value: Value) -> BoxedStrategy<Value> {
    let mut places = Vec::new();
    list(&value, String::new(), &mut places);
    (prop::sample::select(places), anything(), 0..4_u8)
        .prop_map(move |(place, other, how)| damage(value.clone(), &place, other, how))
        .boxed()
}

fn damage(mut value: Value, place: &str, other: Value, how: u8) -> Value {
    let (parent, key) = place.rsplit_once('/').unwrap_or(("", ""));
    if how == 0 {
        if let Some(fields) = value.pointer_mut(parent).and_then(Value::as_object_mut) {
            fields.shift_remove(key);
        }
    } else if let Some(found) = value.pointer_mut(place) {
        match found {
            Value::Object(fields) if how == 1 => {
                fields.insert("oops".into(), other);
            }
            found => *found = other,
        }
    }
    value
}

fn list(value: &Value, place: String, places: &mut Vec<String>) {
    match value {
        Value::Object(fields) => fields
            .iter()
            .for_each(|(key, value)| list(value, format!("{place}/{key}"), places)),
        Value::Array(items) => {
            items
                .iter()
                .enumerate()
                .for_each(|(n, value)| list(value, format!("{place}/{n}"), places));
        }
        _ => {}
    }
    places.push(place);
}

fn anything() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        prop::sample::select(vec![1e39, -1e300, 0.5, 1e-320, f64::MAX])
            .prop_map(|number| json!(number)),
        Just(json!(u64::MAX)),
        "[ -~]{0,80}".prop_map(Value::from),
        Just(json!([])),
        Just(json!({})),
        Just(json!([{"type": "move_to"}])),
        Just((0..100).fold(json!(1), |inner, _| json!([inner]))),
    ]
}

fn reference<'a>(document: &'a Value, schema: &Value) -> Option<&'a Value> {
    document.pointer(schema["$ref"].as_str()?.strip_prefix('#')?)
}

/// Returns the alternatives of a schema, each with the common parts.
fn choices(schema: &Value) -> Option<Vec<Value>> {
    let choices = schema["oneOf"]
        .as_array()
        .or_else(|| schema["anyOf"].as_array())?;
    Some(
        choices
            .iter()
            .map(|choice| with_common(choice.clone(), schema))
            .collect(),
    )
}

fn with_common(mut choice: Value, schema: &Value) -> Value {
    let Some(fields) = schema["properties"].as_object() else {
        return choice;
    };
    for (name, field) in fields {
        choice["properties"][name] = field.clone();
    }
    for name in schema["required"].as_array().map_or(&[][..], Vec::as_slice) {
        choice["required"]
            .as_array_mut()
            .unwrap()
            .push(name.clone());
    }
    if schema["unevaluatedProperties"] == false {
        choice["additionalProperties"] = false.into();
    }
    choice
}

fn types(schema: &Value) -> Vec<&str> {
    match &schema["type"] {
        Value::String(name) => vec![name],
        Value::Array(names) => names.iter().filter_map(Value::as_str).collect(),
        _ => Vec::new(),
    }
}

fn requires(schema: &Value, name: &str) -> bool {
    let needed = schema["required"].as_array();
    needed.is_some_and(|needed| needed.iter().any(|required| required == name))
}
