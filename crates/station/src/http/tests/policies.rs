//! The policy over HTTP: shown, changed, stored.

use dobot_safety::Policy;
use serde_json::json;

use super::Harness;

const LOW: &str = "# our table\n[table]\nz_mm = -60\n";

#[tokio::test]
async fn a_changed_policy_is_in_force_and_is_saved_with_its_comments() {
    let harness = Harness::near();
    let text = harness.get("/api/v1/policy/text").await;
    assert_eq!(text.is(200).body, Policy::DEFAULT_TOML);
    let body = json!({"text": LOW}).to_string();
    harness.json("PUT", "/api/v1/policy", body).await.is(200);
    let policy = harness.get("/api/v1/policy").await.value();
    assert_eq!(policy["table"]["z_mm"], -60.0);
    assert_eq!(harness.get("/api/v1/policy/text").await.body, LOW);
    assert_eq!(
        std::fs::read_to_string(&harness.app.policy_file).unwrap(),
        LOW
    );
}

#[tokio::test]
async fn a_text_that_is_not_a_policy_changes_nothing_and_its_error_is_located() {
    let harness = Harness::near();
    for text in [
        "[table]\nz_mm = \"low\"\n",
        "[table]\nz_mm = 1e9\n",
        "[tabel]\n",
        "nonsense",
    ] {
        let body = json!({"text": text}).to_string();
        let answer = harness.json("PUT", "/api/v1/policy", body).await;
        let (kind, detail) = answer.is(422).problem();
        assert_eq!(kind, "bad-policy");
        assert!(detail.contains("line "), "{detail}");
    }
    let text = harness.get("/api/v1/policy/text").await;
    assert_eq!(text.body, Policy::DEFAULT_TOML);
}

#[tokio::test]
async fn a_policy_may_be_checked_before_it_is_in_force() {
    let harness = Harness::near();
    let body = json!({"text": LOW, "check": true}).to_string();
    let answer = harness.json("PUT", "/api/v1/policy", body).await;
    assert_eq!(answer.is(200).value()["table"]["z_mm"], -60.0);
    let policy = harness.get("/api/v1/policy").await.value();
    assert_ne!(policy["table"]["z_mm"], -60.0);
    assert!(!harness.app.policy_file.exists());
}

#[tokio::test]
async fn a_keep_out_is_changed_in_a_draft_and_the_policy_in_force_is_unchanged() {
    let harness = Harness::near();
    let keep_out = json!({"box": {"x_mm": [200, 260], "y_mm": [80, 140], "z_mm": [-60, 0]}});
    let body = json!({"text": LOW, "edit": {"type": "add", "keep_out": keep_out}});
    let path = "/api/v1/policy/keep-outs";
    let answer = harness.json("POST", path, body.to_string()).await;
    let text = answer.is(200).value()["text"].as_str().unwrap().to_owned();
    assert!(text.starts_with(LOW), "{text}");
    let policy = Policy::from_toml(&text).unwrap();
    assert_eq!(policy.keep_out.len(), 1);
    let held = harness.get("/api/v1/policy/text").await;
    assert_eq!(held.body, Policy::DEFAULT_TOML);
    let body = json!({"text": text, "edit": {"type": "remove", "name": "lamp"}});
    let answer = harness.json("POST", path, body.to_string()).await;
    let (kind, detail) = answer.is(422).problem();
    assert_eq!(kind, "bad-policy");
    assert_eq!(detail, "no keep-out is called \"lamp\"; there are zone_1");
}
