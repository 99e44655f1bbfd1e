//! Commands that come from a camera, a microphone or a hand.

use std::time::Duration;

use dobot_api::{ClientId, Heard, News, Reply, Request, Sense};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, Gesture, JointJogAxis, MoveTo, MovingMode, Voice, WriteVector};

use super::drawing::virtual_station;
use super::stops::sent_since;
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

fn spoken(station: &mut VirtualStation, client: ClientId, words: &str) -> Result<Reply, Refusal> {
    let command = Voice::new(words).unwrap().into();
    let sense = Sense::Microphone;
    station.ask(client, Request::SensedCommand { sense, command })
}

#[test]
fn a_spoken_order_moves_no_further_than_the_policy_allows() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let refused = spoken(&mut station, anna, "left sixty").unwrap_err();
        assert!(
            refused.to_string().contains(
                "the distance of a spoken order would be 60 mm; voice.largest allows 0 to 50 mm"
            ),
            "{refused}"
        );
        station.run_for(Duration::from_secs(1));
        spoken(&mut station, anna, "left fifty").unwrap();
        station.run_for(Duration::from_secs(5));
        let policy = Policy::from_toml("[voice]\nlargest_mm = 5").unwrap();
        station.set_policy(anna, policy).unwrap();
        spoken(&mut station, anna, "right ten").unwrap_err();
        station.run_for(Duration::from_secs(1));
        spoken(&mut station, anna, "right five").unwrap();
        let texts = station.notices();
        let has = |text: &str| texts.iter().any(|notice| notice.text == text);
        assert!(has("Anna: microphone: left fifty") && has("Anna: microphone: right five"));
    }
}

/// The command that each sense may send.
fn own_commands() -> [(Sense, Command); 3] {
    let hand = Gesture {
        x: 220.0,
        y: 0.0,
        z: 40.0,
        grab: false,
    };
    [
        (Sense::Camera, go([220.0, 30.0, 10.0])),
        (Sense::Microphone, Voice::new("up five").unwrap().into()),
        (Sense::Hand, hand.into()),
    ]
}

#[test]
fn each_sense_sends_only_its_own_command() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let commands = own_commands();
    let laser = WriteVector::by(0.0, 10.0, 0.0, 20.0).burning().into();
    for (sense, _) in commands {
        for (own, command) in commands.into_iter().chain([(Sense::Hand, laser)]) {
            let asked = station.ask(anna, Request::SensedCommand { sense, command });
            let is_allowed = sense == own && command != laser;
            assert_eq!(asked.is_ok(), is_allowed, "{sense}: {command:?}: {asked:?}");
            station.run_for(Duration::from_secs(5));
        }
    }
}

/// Lets every sense try to move the arm and to say "go"; asserts that only what keeps it still is sent.
fn no_sense_moves(station: &mut VirtualStation, client: ClientId) {
    let sent = station.packets().len();
    for (sense, command) in own_commands() {
        let asked = station.ask(client, Request::SensedCommand { sense, command });
        assert!(asked.is_err(), "{sense}: {asked:?}");
    }
    let go = Request::Heard {
        client: Some(client),
        heard: Heard::Go,
    };
    station.ask(client, go).unwrap();
    station.run_for(Duration::from_secs(2));
    let sent = sent_since(station, sent);
    let stills = |command: &Command| matches!(command, Command::JointJog(jog) if matches!(jog.axis, JointJogAxis::LaserOff | JointJogAxis::Released));
    assert!(sent.iter().all(stills), "{sent:?}");
}

#[test]
fn no_sense_clears_a_stop_confirms_a_pose_or_arms_the_laser() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, Request::Stop { reason: None }).unwrap();
    station.run_for(Duration::from_secs(3));
    no_sense_moves(&mut station, anna);
    assert!(station.supervisor().state().stop.is_some());
    station.ask(anna, Request::ResetStop).unwrap();

    station.distrust("its port was opened");
    no_sense_moves(&mut station, anna);
    assert!(!station.supervisor().state().trust.trusted);
    station.ask(anna, Request::ConfirmPose).unwrap();

    for (sense, command) in own_commands() {
        station
            .ask(anna, Request::SensedCommand { sense, command })
            .unwrap();
        station.run_for(Duration::from_secs(5));
        let laser = station.supervisor().state().laser;
        assert!(laser.armed_for_s == 0.0 && !laser.on, "{sense}: {laser:?}");
    }
}

#[test]
fn what_a_microphone_heard_is_shown_to_all_and_moves_nothing() {
    let mut station = virtual_station(Personality::Specification);
    let [anna, listener] = ["Anna", "listener"].map(|name| station.client(name));
    let sent = station.packets().len();
    let heard = Heard::Order {
        words: "left ten".to_owned(),
    };
    let request = Request::Heard {
        client: Some(anna),
        heard: heard.clone(),
    };
    station.ask(listener, request).unwrap();
    let client = Some(anna);
    let notices = station.notices();
    let shown = notices.iter().find(|notice| {
        notice.news
            == News::Heard {
                client,
                heard: heard.clone(),
            }
    });
    assert_eq!(shown.unwrap().text, "Anna: microphone: left ten; go?");
    assert_eq!(station.packets().len(), sent);
    let heard = Heard::Order {
        words: "left\u{202e}".to_owned(),
    };
    let refused = station.ask(listener, Request::Heard { client, heard });
    assert!(matches!(refused, Err(Refusal::Malformed(_))), "{refused:?}");
}
