//! Commands that follow from what a camera has seen.

use std::time::Duration;

use dobot_api::{News, Reply, Request, Sense};
use dobot_controller::Personality;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, MoveTo, MovingMode, WriteVector};

use super::drawing::virtual_station;
use crate::cases::commands::target;

fn sensed(command: Command) -> Request {
    Request::SensedCommand {
        sense: Sense::Camera,
        command,
    }
}

fn go(place: [f32; 3]) -> Command {
    MoveTo {
        mode: MovingMode::MovJ,
        ..target(place)
    }
    .into()
}

#[test]
fn a_move_by_a_camera_is_named_as_such_and_obeys_the_policy() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let reply = station.ask(anna, sensed(go([220.0, 30.0, 10.0]))).unwrap();
    let Reply::Accepted { command, .. } = reply else {
        panic!("{reply:?}");
    };
    let notices = station.notices();
    let sensed_notice = notices
        .iter()
        .find(|notice| matches!(notice.news, News::Sensed { command: of, .. } if of == command));
    assert_eq!(
        sensed_notice.unwrap().text,
        "Anna: camera: move to x 220.0 y 30.0 z 10.0"
    );
    station.run_for(Duration::from_secs(5));
    let refused = station.ask(anna, sensed(go([220.0, 30.0, -150.0])));
    assert!(matches!(refused, Err(Refusal::Policy(_))), "{refused:?}");
}

#[test]
fn a_camera_moves_nothing_without_control_and_never_lights_the_laser() {
    let mut station = virtual_station(Personality::Specification);
    let [anna, ben] = ["Anna", "Ben"].map(|name| station.client(name));
    station.ask(anna, Request::TakeLease).unwrap();
    station
        .ask(ben, sensed(go([220.0, 30.0, 10.0])))
        .unwrap_err();
    let line = WriteVector::by(0.0, 10.0, 0.0, 20.0).burning();
    let refused = station.ask(anna, sensed(line.into())).unwrap_err();
    assert!(
        refused.to_string().contains("has to be move_to"),
        "{refused}"
    );
}
