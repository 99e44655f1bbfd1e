//! The station's own virtual arm over HTTP.

use serde_json::json;

use super::Harness;

const CUBE: &str = "[suction-cup]\ndown_z_mm = -40\n\n[[box]]\nname = \"cube\"\nsize_mm = [25, 25, 25]\nat_mm = [200, 60]\n";

#[tokio::test]
async fn an_arm_is_placed_in_another_world() {
    let harness = Harness::near();
    harness
        .get("/api/v1/world")
        .await
        .is(409)
        .is_problem("not-virtual");
    let body = json!({"scene": CUBE}).to_string();
    harness.json("PUT", "/api/v1/world", body).await.is(200);
    let world = harness.get("/api/v1/world?strokes_from=3").await;
    assert_eq!(world.is(200).value()["objects"][0]["name"], "cube");
    let body = json!({"scene": CUBE.replace("25, 25, 25", "25, -1, 25")}).to_string();
    let (kind, detail) = harness
        .json("PUT", "/api/v1/world", body)
        .await
        .is(422)
        .problem();
    assert_eq!(kind, "bad-scene");
    assert!(detail.starts_with("line 6"), "{detail}");
    harness
        .get("/api/v1/world?marks=3")
        .await
        .is(400)
        .is_problem("malformed");
}

#[tokio::test]
async fn faults_begin_and_end_on_request() {
    let harness = Harness::near();
    let body = json!({"faults": ["drop=1%", "reset@3s"], "seed": 4}).to_string();
    harness.json("PUT", "/api/v1/faults", body).await.is(200);
    let faults = harness.get("/api/v1/faults").await.value();
    assert_eq!(faults, json!(["drop=1%", "reset@3s"]));
    for (fault, part) in [
        ("drip=1%", "allowed are drop"),
        ("zero=fore:2", "switched on"),
    ] {
        let body = json!({"faults": [fault]}).to_string();
        let (kind, detail) = harness
            .json("PUT", "/api/v1/faults", body)
            .await
            .is(422)
            .problem();
        assert_eq!(kind, "bad-fault");
        assert!(detail.contains(part), "{detail}");
    }
    assert_eq!(harness.get("/api/v1/faults").await.value(), faults);
    harness
        .json("PUT", "/api/v1/faults", r#"{"faults": []}"#)
        .await
        .is(200);
    assert_eq!(harness.get("/api/v1/faults").await.value(), json!([]));
}
