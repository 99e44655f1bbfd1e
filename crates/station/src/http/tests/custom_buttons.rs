//! Buttons that people have added to the page.

use dobot_api::Role;
use serde_json::{Value, json};

use super::Harness;
use crate::http::resources::custom_buttons::CustomButtons;

const PATH: &str = "/api/v1/buttons";

fn lift() -> Value {
    json!({"name": "Lift", "color": "blue", "action": {"type": "program", "text": "[[steps]]\ngo = { x = 200, y = 0, z = 80 }\n"}})
}

#[tokio::test]
async fn a_button_is_kept_until_it_is_removed_and_each_name_exists_once() {
    let harness = Harness::near();
    let made = harness.json("POST", PATH, lift().to_string()).await;
    assert_eq!(made.is(201).value(), json!([lift()]));
    let again = harness.json("POST", PATH, lift().to_string()).await;
    again.is(409).is_problem("button-taken");
    assert_eq!(harness.get(PATH).await.is(200).value(), json!([lift()]));
    let later = CustomButtons::at(harness.folder.path().join("buttons.json"));
    assert_eq!(
        serde_json::to_value(later.list().unwrap()).unwrap(),
        json!([lift()])
    );
    let gone = harness.bare("DELETE", "/api/v1/buttons/Lift").await;
    assert_eq!(gone.is(200).value(), json!([]));
    let gone = harness.bare("DELETE", "/api/v1/buttons/Lift").await;
    gone.is(404).is_problem("no-such-button");
}

#[tokio::test]
async fn a_button_with_a_bad_name_or_a_program_that_cannot_be_read_is_not_added() {
    let harness = Harness::near();
    let mut unnamed = lift();
    unnamed["name"] = json!(" ");
    let mut turned = lift();
    turned["name"] = json!("\u{202e}tfiL");
    let mut unreadable = lift();
    unreadable["action"]["text"] = json!("[[steps]\n");
    for bad in [unnamed, turned, unreadable] {
        let refused = harness.json("POST", PATH, bad.to_string()).await;
        refused.is(422).is_problem("bad-button");
    }
    assert_eq!(harness.get(PATH).await.is(200).value(), json!([]));
}

#[tokio::test]
async fn only_those_who_may_control_the_arm_change_the_buttons() {
    let harness = Harness::far();
    for (role, status) in [(Role::Watch, 403), (Role::Queue, 403), (Role::Control, 201)] {
        let request = harness
            .request("POST", PATH)
            .header("authorization", harness.bearer(role))
            .header("content-type", "application/json");
        let request = request.body(lift().to_string().into()).unwrap();
        harness.send(request).await.is(status);
    }
}

#[tokio::test]
async fn buttons_that_cannot_be_read_are_reported_and_not_overwritten() {
    let harness = Harness::near();
    let file = harness.folder.path().join("buttons.json");
    std::fs::write(&file, "[{").unwrap();
    let refused = harness.json("POST", PATH, lift().to_string()).await;
    refused.is(500).is_problem("button-file");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "[{");
}
