//! Virtual arms for the tests of other programs.

use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

use super::Harness;

const ARMS: &str = "/api/v1/virtual-arms";

/// Starts an arm; returns its number and a connection to it.
async fn start(harness: &Harness, new: Value) -> (Value, TcpStream) {
    let answer = harness.json("POST", ARMS, new.to_string()).await;
    let arm = answer.is(201).value();
    let port = u16::try_from(arm["port"].as_u64().unwrap()).unwrap();
    let connection = TcpStream::connect(("127.0.0.1", port)).await.unwrap();
    (arm["arm"].clone(), connection)
}

/// The base angle of the next status.
async fn base_deg(connection: &mut TcpStream) -> f32 {
    let mut packet = [0; 42];
    connection.read_exact(&mut packet).await.unwrap();
    assert_eq!((packet[0], packet[41]), (0xA5, 0x5A));
    f32::from_le_bytes(packet[17..21].try_into().unwrap())
}

#[tokio::test]
async fn each_request_starts_an_arm_of_its_own_that_ends_with_its_connection() {
    let harness = Harness::near();
    let fast = json!({"personality": "firmware-1.1", "time_factor": "max"});
    let (_, mut one) = start(&harness, fast.clone()).await;
    let (_, mut other) = start(&harness, fast).await;
    // A JUMP to the left (state 3, x, y, z): only that arm turns.
    let floats = [3.0_f32, 0.0, 200.0, 100.0, 30.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let bytes = floats.iter().flat_map(|float| float.to_le_bytes());
    let packet: Vec<u8> = [0xA5].into_iter().chain(bytes).chain([0x5A]).collect();
    base_deg(&mut one).await;
    one.write_all(&packet).await.unwrap();
    while base_deg(&mut one).await < 20.0 {}
    assert!(base_deg(&mut other).await.abs() < 0.1);
    assert_eq!(harness.get(ARMS).await.value().as_array().unwrap().len(), 2);
    drop(one);
    while harness.get(ARMS).await.value().as_array().unwrap().len() > 1 {
        tokio::task::yield_now().await;
    }
    base_deg(&mut other).await;
}

#[tokio::test]
async fn a_deleted_arm_closes_its_connection() {
    let harness = Harness::near();
    let (arm, mut connection) = start(&harness, json!({"faults": ["drop=1%"]})).await;
    base_deg(&mut connection).await;
    let path = format!("{ARMS}/{arm}");
    let left = harness.bare("DELETE", &path).await.is(200).value();
    assert_eq!(left, json!([]));
    let mut rest = Vec::new();
    // Its end, whether the port was reset or closed.
    let _ = connection.read_to_end(&mut rest).await;
    harness
        .bare("DELETE", &path)
        .await
        .is(404)
        .is_problem("no-such-arm");
}

#[tokio::test]
async fn an_arm_that_cannot_be_made_is_refused_with_the_reason() {
    let harness = Harness::near();
    for (new, kind, part) in [
        (json!({"personality": "robot"}), "invalid", "firmware-1.1"),
        (json!({"time_factor": "0"}), "invalid", "time_factor"),
        (json!({"faults": ["drip=1%"]}), "bad-fault", "drop"),
        (json!({"scene": "[pen"}), "bad-scene", "line 1"),
    ] {
        let answer = harness.json("POST", ARMS, new.to_string()).await;
        let (found, detail) = answer.is(422).problem();
        assert_eq!(found, kind);
        assert!(detail.contains(part), "{detail}");
    }
    assert_eq!(harness.get(ARMS).await.value(), json!([]));
}

#[tokio::test]
async fn a_path_without_the_number_of_an_arm_is_reported_as_a_problem() {
    let harness = Harness::near();
    for arm in ["x", "-1", "1.5", "%C3%AB"] {
        let answer = harness.bare("DELETE", &format!("{ARMS}/{arm}")).await;
        answer.is(400).is_problem("malformed");
    }
}
