//! The OpenAPI 3.1 document, generated from the table of routes and the types.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use dobot_api::problem_kinds::{
    ENDING, FORBIDDEN_HOST, FORBIDDEN_ORIGIN, INVALID, LEASE_GONE, MALFORMED, MEDIA_TYPE,
    ProblemKind, ROLE, TIMEOUT, TOO_LARGE, TOO_MANY_REQUESTS, UNAUTHORISED,
};
use dobot_api::{FromClient, Problem, ToClient};
use schemars::SchemaGenerator;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

use crate::http::exchange::requester::{KEY, LEASE};
use crate::http::live::packets::PacketView;
use crate::http::resources::page;
use crate::http::route::{Gives, Query, Route, Takes};
use crate::http::routes::ROUTES;

/// The document as text.
pub(crate) static TEXT: LazyLock<String> = LazyLock::new(|| document().to_string());

/// Generates the document.
pub(crate) fn document() -> Value {
    let settings = SchemaSettings::draft2020_12().with(|generator| {
        generator.definitions_path = "/components/schemas".into();
        generator.meta_schema = None;
    });
    let mut schemas = settings.into_generator();
    let mut paths: Map<String, Value> = Map::new();
    for route in ROUTES.iter().filter(|route| is_documented(route)) {
        let path = paths.entry(route.path).or_insert_with(|| json!({}));
        path[route.method.as_str().to_lowercase()] = operation(route, &mut schemas);
    }
    // Not referenced by a route: they are used over the WebSocket.
    schemas.subschema_for::<ToClient>();
    schemas.subschema_for::<PacketView>();
    schemas.subschema_for::<FromClient>();
    schemas.subschema_for::<Problem>();
    let mut document = json!({
        "openapi": "3.1.1",
        "info": {
            "title": "dobot station",
            "version": env!("CARGO_PKG_VERSION"),
            "summary": "Watch and move a Dobot Arm V1.0",
            "description": ABOUT,
        },
        "paths": paths,
        "components": {
            "schemas": closed(schemas.take_definitions(true)),
            "securitySchemes": {
                "token": {
                    "type": "http",
                    "scheme": "bearer",
                    "description": "A token of the role watch, queue, control or admin. On loopback the station may do without.",
                },
            },
        },
    });
    bound(&mut document);
    document
}

/// States the range of integers of 32 bits, whose format alone does not restrict them.
fn bound(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            if fields
                .get("format")
                .is_some_and(|format| format == "uint32")
            {
                fields.entry("maximum").or_insert_with(|| u32::MAX.into());
            }
            fields.values_mut().for_each(bound);
        }
        Value::Array(items) => items.iter_mut().for_each(bound),
        _ => {}
    }
}

/// Whether a route is in the document: the API and the page itself are, the page's files are not.
pub(crate) fn is_documented(route: &Route) -> bool {
    route.path == "/" || !page::has(route.path)
}

/// A configuration is a choice within the choice of commands: that neither has other fields can
/// only be stated outside of both.
fn closed(mut schemas: Map<String, Value>) -> Map<String, Value> {
    let commands = schemas
        .get_mut("Command")
        .and_then(|schema| schema["oneOf"].as_array_mut());
    for command in commands.into_iter().flatten() {
        if command.get("oneOf").is_some() {
            command["unevaluatedProperties"] = false.into();
        }
    }
    schemas
}

const ABOUT: &str = "One client at a time has control of the arm and may move it: it takes the lease. Everyone may watch, and anyone may stop the arm at any time. Lengths are in millimetres, angles in degrees, times in seconds. A failed request is answered with a problem document (RFC 9457).";

fn operation(route: &Route, schemas: &mut SchemaGenerator) -> Value {
    let mut operation = json!({
        "operationId": operation_id(route),
        "summary": route.summary,
        "security": if route.open { json!([]) } else { json!([{}, {"token": []}]) },
        "parameters": parameters(route, schemas),
    });
    if let Some(takes) = &route.takes {
        operation["requestBody"] = request_body(takes, schemas);
    }
    operation["responses"] = Value::Object(responses(route, schemas));
    operation
}

/// Returns an operation id, as in `post_jobs_id_start`.
fn operation_id(route: &Route) -> String {
    let path = route
        .path
        .trim_start_matches("/api/v1")
        .replace(['{', '}'], "");
    let path = path.replace(['/', '.'], "_");
    let method = route.method.as_str().to_lowercase();
    if path == "_" {
        format!("{method}_page")
    } else {
        method + &path
    }
}

fn parameters(route: &Route, schemas: &mut SchemaGenerator) -> Vec<Value> {
    let mut all: Vec<Value> = route.path.split('/').filter_map(path_parameter).collect();
    let queries = route.queries.iter();
    all.extend(queries.map(|query| query_parameter(query, schemas)));
    if route.asks {
        all.push(json!({
            "name": "Dobot-Lease",
            "in": "header",
            "description": "The token of a lease that was taken with `POST /api/v1/lease`",
            "schema": {"type": "string"},
        }));
        debug_assert_eq!(LEASE, "dobot-lease");
    }
    if route.queues {
        all.push(json!({
            "name": "Idempotency-Key",
            "in": "header",
            "description": "The sender's key of this request: repeated with the same key it queues no second job and returns the existing one",
            "schema": {"type": "string", "minLength": 1, "maxLength": 64},
        }));
        debug_assert_eq!(KEY, "idempotency-key");
    }
    all
}

fn path_parameter(part: &str) -> Option<Value> {
    let name = part.strip_prefix('{')?.strip_suffix('}')?;
    let schema = match name {
        "id" => json!({"type": "integer", "minimum": 0, "maximum": u64::MAX}),
        _ => json!({"type": "string"}),
    };
    Some(json!({"name": name, "in": "path", "required": true, "schema": schema}))
}

fn query_parameter(query: &Query, schemas: &mut SchemaGenerator) -> Value {
    json!({
        "name": query.name,
        "in": "query",
        "description": query.what,
        "schema": (query.schema)(schemas),
    })
}

fn request_body(takes: &Takes, schemas: &mut SchemaGenerator) -> Value {
    let example: Value =
        serde_json::from_str(takes.example).expect("examples are JSON, as a test shows");
    json!({
        "required": takes.required,
        "description": format!("Up to {} KiB", takes.limit / 1024),
        "content": {
            "application/json": {
                "schema": (takes.schema)(schemas),
                "example": example,
            },
        },
    })
}

fn responses(route: &Route, schemas: &mut SchemaGenerator) -> Map<String, Value> {
    let given = route
        .gives
        .iter()
        .map(|gives| (gives.status, answer(gives, schemas)));
    let mut all: BTreeMap<u16, Value> = given.collect();
    let mut problems: BTreeMap<u16, Vec<ProblemKind>> = BTreeMap::new();
    for kind in problems_of(route) {
        let kinds = problems.entry(kind.status).or_default();
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    all.extend(
        problems
            .iter()
            .map(|(&status, kinds)| (status, problem(kinds, schemas))),
    );
    all.into_iter()
        .map(|(status, value)| (status.to_string(), value))
        .collect()
}

/// Returns all problems with which a route can respond.
pub(crate) fn problems_of(route: &Route) -> Vec<ProblemKind> {
    let mut kinds = route.problems.clone();
    kinds.extend([
        MALFORMED,
        UNAUTHORISED,
        FORBIDDEN_HOST,
        FORBIDDEN_ORIGIN,
        TOO_MANY_REQUESTS,
    ]);
    if route.takes.is_some() {
        kinds.extend([TIMEOUT, TOO_LARGE, MEDIA_TYPE, INVALID]);
    }
    if route.asks {
        kinds.extend([ROLE, LEASE_GONE, ENDING]);
    }
    kinds
}

fn answer(gives: &Gives, schemas: &mut SchemaGenerator) -> Value {
    let mut answer = json!({"description": gives.what});
    if let Some((content, schema)) = gives.body {
        answer["content"] = json!({content: {"schema": schema(schemas)}});
    }
    answer
}

fn problem(kinds: &[ProblemKind], schemas: &mut SchemaGenerator) -> Value {
    let lines: Vec<String> = kinds
        .iter()
        .map(|kind| format!("- `{}`: {}", kind.name, kind.title))
        .collect();
    let mut answer = json!({
        "description": lines.join("\n"),
        "content": {
            "application/problem+json": {"schema": schemas.subschema_for::<Problem>()},
        },
    });
    if let Some(headers) = headers(kinds[0].status) {
        answer["headers"] = headers;
    }
    answer
}

fn headers(status: u16) -> Option<Value> {
    let text = |what: &str| json!({"description": what, "schema": {"type": "string"}});
    match status {
        401 => Some(json!({"WWW-Authenticate": text("How to send a token")})),
        429 => Some(json!({"Retry-After": text("How long to wait, in seconds")})),
        _ => None,
    }
}
