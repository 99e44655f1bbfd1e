//! The steps of the jog buttons.

use std::time::Duration;

use dobot_api::{Button, ClientId, Reply, Request};
use dobot_host::VirtualStation;
use dobot_supervisor::Refusal;
use dobot_wire::{JointJog, JointJogAxis, LinearJogAxis, MoveTo, MovingMode, Status};

use super::releases::over;
use super::strokes::PERSONALITIES;

fn step(
    station: &mut VirtualStation,
    client: ClientId,
    button: Button,
    by: f32,
) -> Result<Reply, Refusal> {
    station.ask(client, Request::Step { button, by })
}

/// The status once all is over.
fn rested(station: &mut VirtualStation) -> Status {
    station.run_for(Duration::from_secs(10));
    station.supervisor().state().arm.unwrap().status
}

const LEFT: Button = Button::Linear(LinearJogAxis::YPlus);

#[test]
fn a_second_step_begins_at_the_end_of_the_first_even_if_it_uses_the_other_jog() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        let before = rested(&mut station);
        step(&mut station, anna, LEFT, 10.0).unwrap();
        step(&mut station, anna, LEFT, 10.0).unwrap();
        station.run_for(Duration::from_millis(400));
        step(
            &mut station,
            anna,
            Button::Joint(JointJogAxis::ServoPlus),
            5.0,
        )
        .unwrap();
        let after = rested(&mut station);
        let moved = [
            after.x_mm - before.x_mm,
            after.y_mm - before.y_mm - 20.0,
            after.z_mm - before.z_mm,
        ];
        assert!(
            moved.iter().all(|off| off.abs() < 0.1),
            "{personality}: {moved:?}"
        );
        // The line keeps the direction of the tool, and the step turns it.
        let turned = after.rotation_deg - before.rotation_deg;
        assert!((turned - 5.0).abs() < 0.1, "{personality}: {turned}");
    }
}

#[test]
fn pump_and_gripper_are_unchanged_by_a_step() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        let holds = MoveTo {
            suction: true,
            gripper_deg: 30.0,
            mode: MovingMode::MovJ,
            ..MoveTo::to(220.0, 0.0, 20.0)
        };
        let command = holds.into();
        station.ask(anna, Request::Command { command }).unwrap();
        // Also while the command that switched it on is in flight.
        step(&mut station, anna, LEFT, 10.0).unwrap();
        let mut status = rested(&mut station);
        for button in [LEFT, Button::Joint(JointJogAxis::BaseMinus)] {
            assert!(status.suction, "{personality}");
            assert!((status.gripper_deg - 30.0).abs() < 0.1, "{personality}");
            step(&mut station, anna, button, 1.0).unwrap();
            status = rested(&mut station);
        }
        assert!(status.suction, "{personality}");
    }
}

#[test]
fn a_step_is_judged_by_the_policy_and_the_lease() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        let packets = station.packets().len();
        let far = step(&mut station, anna, LEFT, 100.0)
            .and_then(|_| step(&mut station, anna, LEFT, 100.0));
        let far = far.and_then(|_| step(&mut station, anna, LEFT, 100.0));
        assert!(matches!(far, Err(Refusal::Policy(_))), "{far:?}");
        let bert = station.client("Bert");
        let refused = step(&mut station, bert, LEFT, 1.0);
        assert!(
            matches!(refused, Err(Refusal::NoLease { .. })),
            "{refused:?}"
        );
        assert!(station.packets().len() <= packets + 2);
    }
}

#[test]
fn an_invalid_step_is_refused_with_the_allowed_values() {
    let (mut station, anna) = over(PERSONALITIES[0], 0);
    for by in [0.0, -1.0, 100.1, f32::NAN, f32::INFINITY] {
        let refused = step(&mut station, anna, LEFT, by).unwrap_err();
        assert!(
            refused
                .to_string()
                .ends_with("allowed is 0.01 to 100 mm or degrees"),
            "{refused}"
        );
    }
    let switch = Button::Joint(JointJogAxis::SuctionOn);
    let refused = step(&mut station, anna, switch, 1.0).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the request cannot be understood: the button suction-on has no step; allowed are those of a joint, of an axis and of the servo"
    );
}

#[test]
fn a_step_after_a_released_button_is_refused_until_the_arm_is_at_rest() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        let jog = dobot_api::Jog::Joint(JointJog::new(JointJogAxis::BasePlus, 50.0));
        super::releases::hold(&mut station, anna, jog, 500);
        station.ask(anna, Request::Release).unwrap();
        let refused = step(&mut station, anna, LEFT, 1.0);
        assert!(
            matches!(refused, Err(Refusal::StillMoving { .. })),
            "{refused:?}"
        );
        rested(&mut station);
        step(&mut station, anna, LEFT, 1.0).unwrap();
    }
}
