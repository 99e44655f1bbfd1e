//! The facts of the arm.

use dobot_arm::{FOREARM, REAR_ARM, Tool};
use dobot_wire::Dialect;
use serde_json::{Value, json};

use super::Harness;
use crate::sample::state;

async fn facts(harness: &Harness, dialect: Option<Dialect>) -> Value {
    let mut state = state(7.5);
    state.dialect = dialect;
    harness.publisher.ends.publish_state(state);
    harness.get("/api/v1/arm").await.is(200).value()
}

#[tokio::test]
async fn the_lengths_and_periods_are_those_that_the_station_uses() {
    let facts = facts(&Harness::near(), None).await;
    let lengths = &facts["dimensions"];
    assert_eq!(lengths["rear_arm_mm"], REAR_ARM.0);
    assert_eq!(lengths["forearm_mm"], FOREARM.0);
    for (kind, tool) in [
        ("suction_cup", Tool::SuctionCup),
        ("gripper", Tool::Gripper),
        ("pen", Tool::SuctionCup),
        ("laser", Tool::Laser),
    ] {
        let tools = facts["tools"].as_array().unwrap();
        let served = tools.iter().find(|tool| tool["kind"] == kind).unwrap();
        assert_eq!(served["reach_mm"], tool.reach().0, "{kind}");
    }
    let seconds = ["status_period_s", "tick_s", "packet_gap_s"].map(|name| facts[name].clone());
    assert_eq!(seconds, [0.08, 0.02, 0.06]);
}

#[tokio::test]
async fn limits_and_lengths_of_tools_follow_the_policy() {
    let harness = Harness::near();
    let before = facts(&harness, None).await;
    assert_eq!(before["joints"]["base_deg"], json!([-135.0, 135.0]));
    let text = "[joints]\nbase_deg = [-90, 45]\n[workspace]\nreach_mm = [140, 300]\n[tool_length]\nlaser_mm = 51\n";
    let body = json!({"text": text}).to_string();
    harness.json("PUT", "/api/v1/policy", body).await.is(200);
    let after = facts(&harness, None).await;
    assert_eq!(after["joints"]["base_deg"], json!([-90.0, 45.0]));
    assert_eq!(after["workspace"]["reach_mm"], json!([140.0, 300.0]));
    assert_eq!(after["tools"][3]["length_mm"], 51.0);
}

#[tokio::test]
async fn the_meaning_of_mouse_and_gesture_packets_is_served_once_the_dialect_is_known() {
    let harness = Harness::near();
    let unknown = facts(&harness, None).await;
    assert_eq!(unknown["dialect"], Value::Null);
    assert_eq!(unknown["tools"][0]["gesture"], Value::Null);
    let document = facts(&harness, Some(Dialect::SPECIFICATION)).await;
    let expected = json!({"name": "specification", "mouse_swings": false, "gesture_samples": 1});
    assert_eq!(document["dialect"], expected);
    let mm = json!({"zero_mm": 0.0, "units_per_mm": 1.0});
    assert_eq!(
        document["tools"][0]["gesture"],
        json!({"x": mm, "y": mm, "z": mm})
    );
    let stock = facts(&harness, Some(Dialect::FIRMWARE_1_1)).await;
    let expected = json!({"name": "firmware-1.1", "mouse_swings": true, "gesture_samples": 10});
    assert_eq!(stock["dialect"], expected);
    // X is 230 mm plus half of the number; Z half of the part above 200, above the lowest height.
    let x = json!({"zero_mm": 230.0, "units_per_mm": 2.0});
    for (tool, lowest_mm) in [(0, -30.0), (1, 20.0), (2, -30.0), (3, -30.0)] {
        let z = json!({"zero_mm": lowest_mm - 100.0, "units_per_mm": 2.0});
        let gesture = &stock["tools"][tool]["gesture"];
        assert_eq!(gesture, &json!({"x": x, "y": mm, "z": z}), "tool {tool}");
    }
}
