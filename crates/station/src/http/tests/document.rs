//! The document.

use std::collections::BTreeSet;

use serde_json::Value;

use super::Harness;
use crate::http::exchange::document::{document, is_documented, problems_of};
use crate::http::routes::ROUTES;

/// Returns the statuses that the document lists for a route, as in `GET /api/v1/jobs/7`.
pub(super) fn statuses(route: &str) -> Option<Vec<u16>> {
    let (method, path) = route.split_once(' ')?;
    let found = ROUTES
        .iter()
        .find(|route| route.method == *method && matches(route.path, path))?;
    let given = found.gives.iter().map(|response| response.status);
    Some(
        given
            .chain(problems_of(found).iter().map(|kind| kind.status))
            .collect(),
    )
}

/// Parts of a path that are not the number of a job.
const WORDS: [&str; 3] = ["/jobs/pause", "/jobs/speed", "/jobs/height"];

fn matches(pattern: &str, path: &str) -> bool {
    let same = |(pattern, part): (&str, &str)| pattern == part || pattern.starts_with('{');
    pattern.split('/').count() == path.split('/').count()
        && pattern.split('/').zip(path.split('/')).all(same)
        && !(pattern.ends_with("{id}") && WORDS.iter().any(|word| path.ends_with(word)))
}

#[test]
fn every_reference_resolves() {
    let document = document();
    let mut found = 0;
    walk(&document, &mut |value| {
        if let Some(reference) = value.get("$ref").and_then(Value::as_str) {
            found += 1;
            let place = reference.strip_prefix('#').unwrap();
            assert!(document.pointer(place).is_some(), "{reference}");
        }
    });
    assert!(found > 100, "{found}");
}

#[test]
fn the_range_of_every_integer_of_32_bits_is_stated() {
    let mut found = 0;
    walk(&document(), &mut |value| {
        if value.get("format").is_some_and(|format| format == "uint32") {
            found += 1;
            let most = value["maximum"].as_f64();
            assert!(most.is_some_and(|most| most <= u32::MAX.into()), "{value}");
        }
    });
    assert!(found > 10, "{found}");
}

#[test]
fn every_operation_has_a_unique_name() {
    let mut names = BTreeSet::new();
    walk(&document(), &mut |value| {
        if let Some(name) = value.get("operationId") {
            assert!(names.insert(name.to_string()), "{name}");
        }
    });
    let routes = ROUTES.iter().filter(|route| is_documented(route));
    assert_eq!(names.len(), routes.count());
}

#[test]
fn every_example_is_accepted() {
    for route in ROUTES.iter() {
        if let Some(takes) = route.takes {
            let read = (takes.reads)(takes.example.as_bytes());
            assert!(read.is_ok(), "{} {}: {read:?}", route.method, route.path);
        }
    }
}

#[tokio::test]
async fn the_router_has_exactly_the_routes_of_the_document() {
    let harness = Harness::near();
    let document = harness.get("/api/v1/openapi.json").await.is(200).value();
    for (path, operations) in document["paths"].as_object().unwrap() {
        let real = path.replace("{id}", "7").replace("{kind}", "policy");
        let real = real.replace("{name}", "watch");
        let real = real.replace("{work}", "7").replace("{key}", "7");
        for method in ["GET", "POST", "PUT", "DELETE", "PATCH"] {
            let answer = harness.bare(method, &real).await;
            // A route without an item number 7 is known too.
            let unknown = answer.status == 404 && answer.problem().0 == "unknown-path";
            let known = !unknown && answer.status != 405;
            let documented = operations.get(method.to_lowercase()).is_some();
            assert_eq!(known, documented, "{method} {path}: {answer:?}");
        }
    }
}

#[test]
fn every_refusal_of_a_route_is_a_problem_document() {
    let document = document();
    for operations in document["paths"].as_object().unwrap().values() {
        for operation in operations.as_object().unwrap().values() {
            for (status, answer) in operation["responses"].as_object().unwrap() {
                if status.parse::<u16>().unwrap() >= 400 {
                    let schema = &answer["content"]["application/problem+json"]["schema"];
                    assert_eq!(schema["$ref"], "#/components/schemas/Problem", "{answer}");
                }
            }
        }
    }
}

fn walk(value: &Value, see: &mut impl FnMut(&Value)) {
    see(value);
    match value {
        Value::Object(fields) => fields.values().for_each(|value| walk(value, see)),
        Value::Array(items) => items.iter().for_each(|item| walk(item, see)),
        _ => {}
    }
}
