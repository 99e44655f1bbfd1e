//! Students in lessons.

use axum::body::Body;
use dobot_api::Role;

use super::Harness;

const LEARNERS: &str = "/api/v1/learners";
const ANNA: &str = r#"{"student": "Anna", "lesson": "tour", "done": 2, "steps": 12}"#;

#[tokio::test]
async fn a_reported_student_is_shown_to_all_with_lesson_and_step() {
    let harness = Harness::near();
    assert_eq!(
        harness.get(LEARNERS).await.is(200).value(),
        serde_json::json!([])
    );
    harness.json("POST", LEARNERS, ANNA).await.is(200);
    let learners = harness.get(LEARNERS).await.is(200).value();
    let anna = &learners.as_array().unwrap()[0];
    assert_eq!(
        [
            &anna["student"],
            &anna["lesson"],
            &anna["done"],
            &anna["steps"]
        ],
        [&"Anna".into(), &"tour".into(), &2.into(), &12.into()] as [&serde_json::Value; 4]
    );
    assert!(anna["for_s"].as_f64().unwrap() >= 0.0);
}

#[tokio::test]
async fn an_invalid_report_is_refused_with_what_is_allowed() {
    let harness = Harness::near();
    for (body, detail) in [
        (
            r#"{"student": "", "lesson": "tour", "done": 0, "steps": 12}"#,
            "student has 0 characters; allowed are 1 to 60 visible ones",
        ),
        (
            r#"{"student": "Anna", "lesson": "../tour", "done": 0, "steps": 12}"#,
            "lesson is \"../tour\"; allowed are 1 to 40 lowercase letters a to z, digits and underscores, as in tour",
        ),
        (
            r#"{"student": "Anna", "lesson": "tour", "done": 0, "steps": 0}"#,
            "steps is 0; allowed are 1 to 1000",
        ),
        (
            r#"{"student": "Anna", "lesson": "tour", "done": 13, "steps": 12}"#,
            "done is 13; the lesson has 12 steps",
        ),
    ] {
        let answer = harness.json("POST", LEARNERS, body).await;
        assert_eq!(
            answer.is(422).problem(),
            ("invalid".into(), detail.to_owned())
        );
    }
    assert_eq!(
        harness.get(LEARNERS).await.value(),
        serde_json::json!([]),
        "nothing of it is kept"
    );
}

#[tokio::test]
async fn a_watcher_sees_the_students_and_reports_none() {
    let harness = Harness::far();
    let ask = |method: &str, role| {
        let request = harness
            .request(method, LEARNERS)
            .header("authorization", harness.bearer(role))
            .header("content-type", "application/json");
        let body = if method == "POST" { ANNA } else { "" };
        request.body(Body::from(body)).unwrap()
    };
    harness
        .send(ask("POST", Role::Watch))
        .await
        .is(403)
        .is_problem("role");
    harness.send(ask("POST", Role::Queue)).await.is(200);
    harness.send(ask("GET", Role::Watch)).await.is(200);
}
