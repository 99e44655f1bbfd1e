//! Calibration over HTTP.

use dobot_api::Request;
use dobot_arm::{Calibration, Joints, Position, Tool};
use dobot_calibrate::Sheet;
use serde_json::{Value, json};

use super::Harness;

/// An arm with wrong zeros.
const ARM: Calibration = Calibration {
    base_deg: 6.0,
    rear_deg: -8.0,
    fore_deg: 5.0,
    reach_mm: 4.0,
    left_mm: -2.0,
    axis_mm: [0.0; 2],
    backlash_deg: [0.0; 3],
    table: None,
};

/// The reported angles of that arm at a point of paper that is 45 mm below.
fn reported([x, y]: [f64; 2]) -> Joints {
    let there = Position::new(x, y, -45.0);
    ARM.raw_joints(there, Tool::SuctionCup).unwrap()
}

fn touch(point: [f64; 2]) -> Value {
    let joints = reported(point);
    json!({"place_mm": point, "raw_deg": [joints.base.0, joints.rear.0, joints.fore.0]})
}

/// What the station is asked about touches of a sheet whose bar was measured.
fn question(touches: &[Value]) -> Value {
    let sheet = Sheet::chosen_by(17);
    json!({"touches": touches, "sheet": sheet.number(), "bar_mm": sheet.bar_mm() + 0.2})
}

async fn points(harness: &Harness) -> Vec<[f64; 2]> {
    let answer = harness.get("/api/v1/calibration/points").await;
    serde_json::from_value(answer.is(200).value()["points_mm"].clone()).unwrap()
}

#[tokio::test]
async fn touches_of_the_sheet_show_the_errors_of_the_arm() {
    let harness = Harness::near();
    let touches: Vec<Value> = points(&harness).await.into_iter().map(touch).collect();
    let body = question(&touches).to_string();
    let fit = harness.json("POST", "/api/v1/calibration/fit", body).await;
    let fit = fit.is(200).value();
    assert_eq!(fit["trust"], "good");
    assert!(fit["expected_mm"].as_f64().unwrap() < 0.3);
    assert!(
        fit["away_mm"]
            .as_array()
            .unwrap()
            .iter()
            .all(|value| value.as_f64().unwrap() < 0.2)
    );
    let zeros = &fit["calibration"]["zeros"];
    let turned = zeros["base"].as_f64().unwrap() - ARM.base_deg;
    assert!(turned.abs() < 1.0, "{zeros}");

    // The result of a fit is accepted as a calibration.
    let body = json!({"calibration": fit["calibration"]}).to_string();
    harness
        .json("PUT", "/api/v1/calibration", body)
        .await
        .is(200);
    let asked = harness.asked();
    assert!(matches!(
        asked.last(),
        Some(Request::Calibrate {
            calibration: Some(_)
        })
    ));
}

#[tokio::test]
async fn touches_without_information_are_refused_with_a_remedy() {
    let harness = Harness::near();
    let all = points(&harness).await;
    let three: Vec<Value> = all[..3].iter().copied().map(touch).collect();
    let mut wrong: Vec<Value> = all[..5].iter().copied().map(touch).collect();
    wrong[2] = json!({"place_mm": all[2], "raw_deg": [80.0, 10.0, 10.0]});
    let nine: Vec<Value> = all.iter().copied().map(touch).collect();
    let mut scaled = question(&nine);
    scaled["bar_mm"] = json!(0.97 * Sheet::chosen_by(17).bar_mm());
    for (body, expected) in [
        (question(&[]), "the number of touches is 0"),
        (question(&three), "at least 4"),
        (question(&wrong), "again"),
        (scaled, "100 %"),
        (json!({"touches": nine, "bar_mm": 200}), "print a new sheet"),
        (json!({"touches": nine}), "measure its bar"),
    ] {
        let answer = harness
            .json("POST", "/api/v1/calibration/fit", body.to_string())
            .await;
        let (kind, detail) = answer.is(422).problem();
        assert_eq!(kind, "bad-touches");
        assert!(detail.contains(expected), "{detail}");
    }
    assert!(harness.asked().is_empty(), "nothing is asked of the arm");
}

#[tokio::test]
async fn the_sheet_is_a_printable_image_and_nothing_is_known_at_first() {
    let harness = Harness::near();
    let sheet = harness.get("/api/v1/calibration/sheet").await;
    assert!(sheet.body.starts_with("<svg"));
    assert_eq!(sheet.headers["content-type"], "image/svg+xml");
    let known = harness.get("/api/v1/calibration").await.value();
    assert_eq!(known, json!({"calibration": null, "before": null}));
    harness
        .json("POST", "/api/v1/calibration/angles", "{}".to_owned())
        .await
        .is(200);
    assert!(matches!(harness.asked().last(), Some(Request::SetAngles)));
}

#[tokio::test]
async fn touches_of_the_paper_give_its_plane_which_may_be_saved() {
    let harness = Harness::near();
    let bent = |[x, y]: [f64; 2]| [x, y, -42.0 + 0.01 * x + (y / 100.0).powi(2)];
    let touches: Vec<[f64; 3]> = points(&harness).await.into_iter().map(bent).collect();
    let body = json!({"places_mm": touches}).to_string();
    let found = harness.json("POST", "/api/v1/calibration/paper", body);
    let found = found.await.is(200).value();
    assert_eq!(found["paper"]["heights"].as_array().unwrap().len(), 9);
    let zeros = json!({"base": 0.0, "rear": 0.0, "fore": 0.0});
    let kept = json!({"calibration": {"zeros": zeros, "paper": found["paper"]}});
    let kept = harness.json("PUT", "/api/v1/calibration", kept.to_string());
    kept.await.is(200);
    let asked = harness.asked();
    let Some(Request::Calibrate {
        calibration: Some(kept),
    }) = asked.last()
    else {
        panic!("{asked:?}");
    };
    assert_eq!(kept.paper.as_ref().unwrap().heights.len(), 9);

    let two = json!({"places_mm": touches[..2]}).to_string();
    let answer = harness.json("POST", "/api/v1/calibration/paper", two).await;
    let (kind, detail) = answer.is(422).problem();
    assert_eq!(kind, "bad-touches");
    assert!(detail.contains("a plane needs 3"), "{detail}");
}

#[tokio::test]
async fn the_error_of_each_touch_is_shown_in_a_picture() {
    let harness = Harness::near();
    let touches: Vec<Value> = points(&harness).await.into_iter().map(touch).collect();
    let body = question(&touches).to_string();
    let answer = harness.json("POST", "/api/v1/calibration/picture", body);
    let answer = answer.await;
    assert!(answer.is(200).body.starts_with("<svg"));
}

#[tokio::test]
async fn a_measured_bar_is_checked_before_any_touch() {
    let harness = Harness::near();
    let sheet = Sheet::chosen_by(17);
    for (bar_mm, status) in [(sheet.bar_mm(), 204), (0.99 * sheet.bar_mm(), 422)] {
        let body = json!({"sheet": sheet.number(), "bar_mm": bar_mm}).to_string();
        let answer = harness.json("POST", "/api/v1/calibration/bar", body).await;
        answer.is(status);
    }
}

#[tokio::test]
async fn an_unusual_tool_is_trusted_after_a_person_has_measured_it() {
    let harness = Harness::near();
    let long = Calibration {
        reach_mm: 9.5,
        ..ARM
    };
    let touches = points(&harness).await.into_iter().map(|point| {
        let there = Position::new(point[0], point[1], -45.0);
        let raw = long.raw_joints(there, Tool::SuctionCup).unwrap();
        json!({"place_mm": point, "raw_deg": [raw.base.0, raw.rear.0, raw.fore.0]})
    });
    let mut body = question(&touches.collect::<Vec<_>>());
    for (tool_measured, trust) in [(false, "unmeasured"), (true, "good")] {
        body["tool_measured"] = json!(tool_measured);
        let fit = harness.json("POST", "/api/v1/calibration/fit", body.to_string());
        let fit = fit.await.is(200).value();
        assert_eq!(fit["trust"], trust);
        // From the wrist to a suction cup it is 55.07 mm as drawn.
        let out_mm = fit["tool_mm"][0].as_f64().unwrap();
        assert!((out_mm - 64.57).abs() < 2.0, "{out_mm}");
    }
}
