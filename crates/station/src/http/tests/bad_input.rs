//! Bad input, generated from the document: what it allows is accepted, and anything else is
//! answered with a problem and not passed on.

use std::cell::Cell;

use axum::body::Body;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use serde_json::Value;

use super::schema::{allows, damaged, instance};
use super::{Answer, Harness};
use crate::http::exchange::document::document;
use crate::http::exchange::messages;
use crate::http::routes::ROUTES;

const CASES: u32 = 200;

fn runner() -> TestRunner {
    TestRunner::new(Config {
        cases: CASES,
        failure_persistence: None,
        ..Config::default()
    })
}

/// Returns all routes with a body: method, path and schema.
fn routes(document: &Value) -> Vec<(String, String, &Value)> {
    let taking = ROUTES.iter().filter(|route| route.takes.is_some());
    taking
        .map(|route| {
            let method = route.method.to_string();
            let operation = &document["paths"][route.path][method.to_lowercase()];
            let schema = &operation["requestBody"]["content"]["application/json"]["schema"];
            (method, route.path.replace("{id}", "7"), schema)
        })
        .collect()
}

/// Sends a body that does not wait for the arm.
fn send(
    runtime: &tokio::runtime::Runtime,
    harness: &Harness,
    method: &str,
    path: &str,
    body: impl Into<Body>,
) -> (Answer, usize) {
    let before = harness.asked().len();
    let answer = runtime.block_on(harness.json(method, path, body));
    (answer, harness.asked().len() - before)
}

fn runtime() -> tokio::runtime::Runtime {
    tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .unwrap()
}

fn without_waiting(mut body: Value) -> Value {
    if body["wait"] == true {
        body["wait"] = false.into();
    }
    body
}

#[test]
fn bodies_allowed_by_the_document_are_accepted_and_others_change_nothing() {
    let document = document();
    let runtime = runtime();
    let (taken, refused) = (Cell::new(0), Cell::new(0));
    for (method, path, schema) in routes(&document) {
        let harness = runtime.block_on(async { Harness::near() });
        let whole = instance(&document, schema);
        let any = prop_oneof![1 => whole.clone(), 4 => whole.prop_flat_map(damaged)];
        runner()
            .run(&any.prop_map(without_waiting), |body| {
                let (answer, asked) = send(&runtime, &harness, &method, &path, body.to_string());
                let what = format!("{method} {path} {body}: {answer:?}");
                if allows(&document, schema, &body, true) {
                    prop_assert!(!matches!(answer.status, 400 | 413 | 415), "{what}");
                    // A text may be no valid program, option of a drawing, policy, scene, fault or
                    // name, touches may determine nothing; some keys of a step exclude each other.
                    let reads = [
                        "/buttons",
                        "/drawings",
                        "/files",
                        "/fleet/work",
                        "/fleet/offers",
                        "/calibration/",
                        "/programs/",
                        "/policy",
                        "/world",
                        "/faults",
                        "/tokens",
                        "/learners",
                        "/virtual-arms",
                    ];
                    let is_text = reads.iter().any(|read| path.contains(read));
                    prop_assert!(is_text || answer.status != 422, "{what}");
                    taken.set(taken.get() + 1);
                } else if !allows(&document, schema, &body, false) {
                    prop_assert!(matches!(answer.status, 400 | 422), "{what}");
                    prop_assert!(!answer.problem().1.is_empty());
                    prop_assert_eq!(asked, 0, "{}", what);
                    refused.set(refused.get() + 1);
                }
                Ok(())
            })
            .unwrap();
    }
    let (taken, refused) = (taken.get(), refused.get());
    assert!(
        taken > 500 && refused > 1000,
        "{taken} taken, {refused} refused"
    );
}

#[test]
fn bodies_that_are_not_json_change_nothing() {
    let document = document();
    let runtime = runtime();
    for (method, path, schema) in routes(&document) {
        let harness = runtime.block_on(async { Harness::near() });
        let bytes = instance(&document, schema)
            .prop_flat_map(|instance| spoiled(instance.to_string().into_bytes()));
        runner()
            .run(&bytes, |bytes| {
                if serde_json::from_slice::<Value>(&bytes).is_err() && !bytes.is_empty() {
                    let (answer, asked) = send(&runtime, &harness, &method, &path, bytes);
                    prop_assert!(matches!(answer.status, 400 | 422), "{:?}", answer);
                    prop_assert!(answer.problem().1.contains(", column "), "{:?}", answer);
                    prop_assert_eq!(asked, 0);
                }
                Ok(())
            })
            .unwrap();
    }
}

/// Text that is cut, has a changed byte, or contains what JSON does not allow.
fn spoiled(bytes: Vec<u8>) -> BoxedStrategy<Vec<u8>> {
    let len = bytes.len();
    let pieces: Vec<&[u8]> = vec![
        b"NaN",
        b"Infinity",
        b"1e999",
        b"\xff\xfe",
        b"\\ud800",
        b"[[[[",
        b"'",
        b"/**/",
        b"\0",
    ];
    let pieces: Vec<Vec<u8>> = pieces.into_iter().map(Into::into).collect();
    (0..len, prop::sample::select(pieces), any::<u8>(), 0..3_u8)
        .prop_map(move |(at, piece, byte, how)| {
            let mut bytes = bytes.clone();
            match how {
                0 => bytes.truncate(at),
                1 => bytes[at] = byte,
                _ => drop(bytes.splice(at..at, piece)),
            }
            bytes
        })
        .boxed()
}

#[test]
fn endless_nesting_is_refused() {
    let lab_runtime = runtime();
    let harness = lab_runtime.block_on(async { Harness::near() });
    for piece in ["[", "{\"a\":"] {
        let (answer, asked) = send(
            &lab_runtime,
            &harness,
            "POST",
            "/api/v1/commands",
            piece.repeat(10_000),
        );
        assert!(matches!(answer.status, 400 | 422), "{answer:?}");
        assert_eq!(asked, 0);
    }
}

#[test]
fn messages_allowed_by_the_document_are_accepted_and_no_others() {
    let document = document();
    let schema = &document["components"]["schemas"]["FromClient"];
    let whole = instance(&document, schema);
    let any = prop_oneof![1 => whole.clone(), 4 => whole.prop_flat_map(damaged)];
    let mut runner = TestRunner::new(Config {
        cases: 4000,
        failure_persistence: None,
        ..Config::default()
    });
    runner
        .run(&any, |message| {
            let read = messages::read(message.to_string().as_bytes());
            if allows(&document, schema, &message, true) {
                prop_assert!(read.is_ok(), "{message}: {read:?}");
            } else if !allows(&document, schema, &message, false) {
                let (id, problem) = read
                    .err()
                    .ok_or_else(|| TestCaseError::fail(message.to_string()))?;
                prop_assert!(matches!(problem.status, 400 | 422));
                prop_assert_eq!(id, message["id"].as_u64());
            }
            Ok(())
        })
        .unwrap();
}
