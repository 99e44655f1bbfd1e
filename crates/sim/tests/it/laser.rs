//! The laser of an arm whose client uses the library alone: no policy, no station.

use std::time::Duration;

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Connection, LinkError, SendError};
use dobot_sim::{InProcess, RECORDING_PERIOD, SerialLine, VirtualArm};
use dobot_wire::{Command, JointJog, JointJogAxis, MoveTo, MovingMode, WriteVector};

use crate::light::longest_stand_s;

/// What the laser may stand at the most, in seconds.
const MAX_S: f64 = 0.3;
/// An arm that goes less than that from one sample to the next stands.
const STILL_MM: f64 = 0.001;

fn arm(personality: Personality) -> (InProcess, Connection) {
    let power_up = PowerUp::new(personality);
    let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    arm.record(RECORDING_PERIOD);
    let arm = InProcess::new(arm);
    let connection = Connection::over_peer(arm.clone(), Some(personality.dialect()));
    (arm, connection)
}

fn vector(x_mm: f32, y_mm: f32, laser: bool) -> Command {
    let stroke = WriteVector::by(x_mm, y_mm, 0.0, 40.0);
    if laser { stroke.burning() } else { stroke }.into()
}

/// To a place, with a pause of two seconds there.
fn target(x_mm: f32, y_mm: f32) -> Command {
    MoveTo {
        mode: MovingMode::MovJ,
        pause_s: 2.0,
        ..MoveTo::to(x_mm, y_mm, 30.0)
    }
    .into()
}

/// Sends commands one after the other, waits, and lets the arm move, so that the rest is recorded.
async fn stand_s(personality: Personality, commands: &[Command]) -> f64 {
    let (arm, mut connection) = arm(personality);
    connection.next_status().await.unwrap();
    for command in commands {
        connection.send(*command).unwrap();
    }
    connection.pass(Duration::from_secs(12)).await.unwrap();
    assert!(!arm.arm().controller().laser(), "{personality}: it is off");
    let burnt = arm.arm().samples().iter().any(|it| it.laser);
    assert!(burnt, "{personality}: it burnt");
    // A long silence at a base of 0 costs the trust.
    connection.session_mut().confirm_pose();
    connection.send(vector(-5.0, 0.0, false)).unwrap();
    while connection.session().in_flight() + connection.session().waiting() > 0 {
        connection.next_event().await.unwrap();
    }
    longest_stand_s(arm.arm().samples(), STILL_MM)
}

#[tokio::test]
async fn nothing_that_a_program_sends_leaves_the_laser_burning_on_the_spot() {
    let on = Command::from(JointJog::new(JointJogAxis::LaserOn, 0.0));
    for personality in Personality::ALL {
        for (what, commands) in [
            ("one vector", vec![vector(10.0, 0.0, true)]),
            ("the button", vec![on]),
            (
                "a pause behind it",
                vec![vector(10.0, 0.0, true), target(250.0, 20.0)],
            ),
            (
                "a move behind it",
                vec![
                    vector(10.0, 0.0, true),
                    target(250.0, 20.0),
                    target(240.0, 0.0),
                ],
            ),
            (
                "writing behind it",
                vec![vector(10.0, 0.0, true), vector(0.0, 10.0, false)],
            ),
        ] {
            let stood_s = stand_s(personality, &commands).await;
            println!("{personality}, {what}: {stood_s:.3} s");
            assert!(stood_s <= MAX_S, "{personality}, {what}: {stood_s} s");
        }
    }
}

#[tokio::test]
async fn a_burn_that_ends_at_a_limit_does_not_leave_the_laser_on() {
    for length_mm in [60.0, 90.0, 150.0] {
        let (arm, mut connection) = arm(Personality::Firmware11);
        connection.next_status().await.unwrap();
        // The reach ends at some 317 mm; the arm begins at 264 mm.
        connection.send(vector(-length_mm, 0.0, true)).unwrap();
        connection.pass(Duration::from_secs(12)).await.unwrap();
        connection.send(vector(length_mm, 0.0, true)).unwrap();
        connection.pass(Duration::from_secs(12)).await.unwrap();
        connection.send(vector(-5.0, 0.0, false)).unwrap();
        connection.pass(Duration::from_secs(3)).await.unwrap();
        let stood_s = longest_stand_s(arm.arm().samples(), STILL_MM);
        println!("{length_mm} mm: {stood_s:.3} s");
        assert!(stood_s <= MAX_S, "{length_mm} mm: {stood_s} s");
    }
}

#[tokio::test]
async fn an_arm_that_is_not_in_this_process_burns_only_while_its_laser_is_armed() {
    let (ours, _theirs) = tokio::io::duplex(4096);
    let mut connection = Connection::over_stream(ours, Some(Personality::Firmware11.dialect()));
    connection.session_mut().confirm_pose();
    let refused = connection.send(vector(10.0, 0.0, true)).unwrap_err();
    assert_eq!(refused, SendError::LaserDisarmed);
    assert!(refused.to_string().contains("arm_laser"), "{refused}");
    connection.arm_laser(Duration::from_mins(1));
    connection.send(vector(10.0, 0.0, true)).unwrap();
    connection.session_mut().disarm_laser();
    let refused = LinkError::from(connection.send(vector(10.0, 0.0, true)).unwrap_err());
    assert!(refused.to_string().contains("disarmed"), "{refused}");
}
