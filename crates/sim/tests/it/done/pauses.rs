//! A pause is neither a stall nor a loss.

use super::*;

fn jump(x: f32, y: f32, z: f32, pause_s: f32) -> MoveTo {
    MoveTo {
        pause_s,
        ..move_to(MovingMode::Jump, x, y, z)
    }
}

/// Five targets in one burst, with pauses of seconds: what a program of others was seen to send.
async fn burst(personality: Personality, mode: MovingMode, latency: Duration) {
    let power_up = PowerUp::new(personality);
    let arm = InProcess::new(VirtualArm::new(
        Controller::power_up(power_up),
        SerialLine::STOCK,
    ));
    let late = Late::new(arm.clone(), latency, None);
    let mut connection = Connection::over_peer(late, Some(personality.dialect()));
    connection.next_status().await.expect("a status arrives");
    let targets = [
        jump(220.0, 210.0, 20.0, 3.0),
        jump(130.0, 230.0, 20.0, 2.0),
        jump(130.0, 230.0, 20.0, 3.0),
        jump(220.0, 210.0, 20.0, 2.0),
        jump(265.0, 0.0, 25.0, 3.0),
    ];
    let mut over = Vec::new();
    for target in targets {
        let it = MoveTo { mode, ..target };
        // A stock arm is not sent where it will be by a straight line.
        let _ = connection.send(it);
    }
    let sent = connection.session().waiting() + connection.session().in_flight();
    while over.len() < sent {
        assert!(
            connection.now() < Duration::from_secs(60),
            "{mode:?}: {over:?}"
        );
        match connection.next_event().await.expect("the link is open") {
            Event::Completed(id) => over.push((id.0, connection.now().as_secs_f64())),
            event @ (Event::NotReached { .. } | Event::LinkLost { .. }) => {
                panic!("{personality} {mode:?}: {event:?} behind {over:?}")
            }
            _ => {}
        }
    }
    let reported = connection.now();
    let found = arm.arm().controller().pose_at(reported).position;
    let apart_mm = found.distance(dobot_arm::Position::new(265.0, 0.0, 25.0)).0;
    assert!(apart_mm < 0.05, "{personality} {mode:?}: {found:?}");
    assert!(
        reported > Duration::from_secs(13),
        "{reported:?}: pauses of 13 s"
    );
}

#[tokio::test]
async fn targets_with_pauses_in_one_burst_are_neither_lost_nor_stalled() {
    for personality in Personality::ALL {
        for mode in [MovingMode::Jump, MovingMode::MovJ, MovingMode::MovL] {
            for latency_ms in [0, 100, 200] {
                burst(personality, mode, ms(latency_ms)).await;
            }
        }
    }
}
