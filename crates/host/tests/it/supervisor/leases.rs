//! One client has control; everyone may watch and stop.

use std::time::Duration;

use dobot_api::{JobPhase, Jog, Request, Role};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_motion::LASER_OFF;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, LinearJog, LinearJogAxis, Packet};

use super::drawing::{is_over, spiral, virtual_station};
use crate::cases::commands::vector;

const UP: Request = Request::Jog {
    jog: Jog::Linear(LinearJog::new(LinearJogAxis::ZMinus, 20.0)),
};

fn holder(virtual_station: &VirtualStation) -> Option<String> {
    virtual_station
        .supervisor()
        .state()
        .lease
        .map(|lease| lease.name)
}

#[test]
fn a_client_without_control_cannot_move_the_arm() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    let before = station.packets().len();
    let refused = station.ask(anna, UP).unwrap_err();
    assert_eq!(refused, Refusal::NoLease { holder: None });
    assert_eq!(station.packets().len(), before, "nothing was sent");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, UP).unwrap();
}

#[test]
fn a_second_client_learns_who_has_control() {
    let mut station = virtual_station(Personality::Specification);
    let (anna, ben) = (station.client("Anna"), station.client("Ben"));
    station.ask(anna, Request::TakeLease).unwrap();
    let refused = station.ask(ben, Request::TakeLease).unwrap_err();
    assert_eq!(refused.to_string(), "Anna has control of the arm");
    let refused = station.ask(ben, UP).unwrap_err();
    assert_eq!(refused.kind(), "no-lease");
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
}

#[test]
fn control_passes_to_the_requester_when_the_holder_grants_it() {
    let mut station = virtual_station(Personality::Specification);
    let (anna, ben) = (station.client("Anna"), station.client("Ben"));
    station.ask(anna, Request::TakeLease).unwrap();
    let grant = Request::GrantLease { to: ben };
    assert_eq!(
        station.ask(anna, grant.clone()),
        Err(Refusal::NotAsking(ben.0))
    );
    station.ask(ben, Request::AskLease).unwrap();
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
    station.ask(anna, grant).unwrap();
    assert_eq!(holder(&station).as_deref(), Some("Ben"));
}

#[test]
fn control_is_free_after_its_holder_leaves() {
    let mut station = virtual_station(Personality::Specification);
    let (anna, ben) = (station.client("Anna"), station.client("Ben"));
    station.ask(anna, Request::TakeLease).unwrap();
    station.leave(anna);
    assert_eq!(holder(&station), None);
    station.ask(ben, Request::TakeLease).unwrap();
}

#[test]
fn an_administrator_may_take_control_from_another_client() {
    let mut station = virtual_station(Personality::Specification);
    let (anna, ben) = (station.client("Anna"), station.client("Ben"));
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(ben, Request::SeizeLease).unwrap();
    assert_eq!(holder(&station).as_deref(), Some("Ben"));
    assert_eq!(station.ask(anna, UP).unwrap_err().kind(), "no-lease");
}

#[test]
fn a_watcher_may_stop_and_nothing_else() {
    let mut station = virtual_station(Personality::Specification);
    let watcher = station.client_as("the class", Role::Watch);
    assert_eq!(
        station.ask(watcher, Request::TakeLease).unwrap_err().kind(),
        "role"
    );
    station
        .ask(watcher, Request::Stop { reason: None })
        .unwrap();
    assert!(station.supervisor().state().stop.is_some());
}

#[test]
fn a_locked_arm_belongs_to_the_administrators_and_all_others_learn_that() {
    let mut station = virtual_station(Personality::Specification);
    let teacher = station.client("Ms Weber");
    let anna = station.client_as("Anna", Role::Control);
    let ben = station.client_as("Ben", Role::Control);
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(ben, Request::AskLease).unwrap();
    let message = Some("eyes on me".into());
    assert_eq!(
        station
            .ask(anna, Request::Lock { message: None })
            .unwrap_err()
            .kind(),
        "role"
    );
    station.ask(teacher, Request::Lock { message }).unwrap();
    assert_eq!(holder(&station), None);
    for (who, request) in [
        (anna, UP),
        (anna, Request::TakeLease),
        (ben, Request::AskLease),
        (ben, Request::ArmLaser { for_s: 60.0 }),
    ] {
        let refused = station.ask(who, request).unwrap_err();
        assert_eq!(
            refused.to_string(),
            "the arm was locked by Ms Weber: eyes on me"
        );
        assert_eq!(refused.kind(), "locked");
    }
    let before = station.packets().len();
    assert!(station.send_raw(ben, &packet(40.0)).is_err());
    assert_eq!(station.packets().len(), before, "nothing was sent");
    // The teacher has control, and grants it to no client while the arm is locked.
    station.ask(teacher, Request::TakeLease).unwrap();
    station.ask(teacher, UP).unwrap();
    station.ask(anna, Request::Stop { reason: None }).unwrap();
    station.ask(teacher, Request::Unlock).unwrap();
    station.ask(teacher, Request::ReleaseLease).unwrap();
    assert_eq!(station.supervisor().state().lock, None);
    station.ask(anna, Request::TakeLease).unwrap();
}

#[test]
fn a_lock_releases_held_buttons_and_brings_a_drawing_to_rest() {
    let mut station = virtual_station(Personality::Firmware11);
    let teacher = station.client("Ms Weber");
    let anna = station.client_as("Anna", Role::Control);
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, UP).unwrap();
    station.run_for(Duration::from_millis(100));
    station
        .ask(teacher, Request::Lock { message: None })
        .unwrap();
    station.run_for(Duration::from_secs(2));
    let rest = station.supervisor().state().arm.unwrap();
    assert!(!rest.moving);
    station.ask(teacher, Request::Unlock).unwrap();

    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(8)).unwrap();
    station.start(anna, job).unwrap();
    station.run_for(Duration::from_secs(2));
    station
        .ask(teacher, Request::Lock { message: None })
        .unwrap();
    let minute = station.now() + Duration::from_mins(1);
    let paused = |station: &VirtualStation| {
        station
            .supervisor()
            .state()
            .job
            .is_some_and(|job| job.phase == JobPhase::Paused)
    };
    assert!(station.run_until(minute, paused));
    station.run_for(Duration::from_secs(5));
    assert_eq!(station.start(anna, job).unwrap_err().kind(), "locked");
    station.ask(teacher, Request::TakeLease).unwrap();
    station.start(teacher, job).unwrap();
    let minute = station.now() + Duration::from_mins(1);
    assert!(station.run_until(minute, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
}

#[test]
fn a_message_reaches_all_watchers_and_takes_no_control() {
    let mut station = virtual_station(Personality::Specification);
    let teacher = station.client_as("Ms Weber", Role::Control);
    let text = "five more minutes\u{7}".to_owned();
    station.ask(teacher, Request::Message { text }).unwrap();
    let found = station
        .notices()
        .iter()
        .any(|notice| notice.text == "Ms Weber: five more minutes");
    assert!(found, "{:?}", station.notices());
}

#[test]
fn a_pen_drawing_continues_after_the_client_that_started_it_leaves() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(8)).unwrap();
    station.start(anna, job).unwrap();
    station.run_for(Duration::from_secs(2));
    station.leave(anna);
    let minute = station.now() + Duration::from_mins(1);
    assert!(station.run_until(minute, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
}

const RELEASED: JointJog = JointJog::new(JointJogAxis::Released, 0.0);

/// A packet that moves the arm by this many millimetres.
fn packet(y_mm: f32) -> Packet {
    vector([0.0, y_mm, 0.0], false).emit(&Dialect::SPECIFICATION)
}

#[test]
fn a_person_at_this_machine_takes_control_from_a_raw_client_which_cannot_be_asked() {
    let mut station = virtual_station(Personality::Specification);
    let program = station.client("an old program");
    station.send_raw(program, &packet(40.0)).unwrap();
    station.send_raw(program, &packet(-40.0)).unwrap();
    assert_eq!(holder(&station).as_deref(), Some("an old program"));
    let anna = station.client("Anna");
    let refused = station.ask(anna, UP).unwrap_err();
    let hint = refused.hint().unwrap();
    assert!(hint.contains("dobot lease take"), "{hint}");
    station.ask(anna, Request::TakeLease).unwrap();
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
    let found = station
        .notices()
        .iter()
        .any(|notice| notice.text.contains("Anna took it"));
    assert!(found, "{:?}", station.notices());
    // Waiting packets are dropped, and the program does not get control back by sending more.
    assert_eq!(station.supervisor().session().waiting(), 0);
    for _ in 0..20 {
        let refused = station.send_raw(program, &packet(5.0)).unwrap_err();
        assert_eq!(refused.kind(), "no-lease");
        station.run_for(Duration::from_millis(500));
    }
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
    station.ask(anna, Request::ReleaseLease).unwrap();
    station.send_raw(program, &packet(5.0)).unwrap();
    assert_eq!(holder(&station).as_deref(), Some("an old program"));
}

#[test]
fn a_button_held_by_a_raw_client_is_released_when_a_person_takes_control() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let (program, anna) = (station.client("an old program"), station.client("Anna"));
        let pressed = Command::from(JointJog::new(JointJogAxis::BasePlus, 50.0));
        station
            .send_raw(program, &pressed.emit(&personality.dialect()))
            .unwrap();
        station.run_for(Duration::from_millis(400));
        let before = station.packets().len();
        station.ask(anna, Request::TakeLease).unwrap();
        station.run_for(Duration::from_secs(2));
        let sent = station.packets()[before..].iter();
        let commands: Vec<Command> = sent
            .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
            .map(|packet| Command::parse(&packet, &personality.dialect()).unwrap())
            .collect();
        assert!(
            commands.contains(&RELEASED.into()),
            "{personality}: {commands:?}"
        );
        assert!(commands.contains(&LASER_OFF), "{personality}: {commands:?}");
        assert!(station.supervisor().is_at_rest(), "{personality}");
    }
}

#[test]
fn neither_a_raw_client_nor_another_person_takes_control_from_a_person() {
    let mut station = virtual_station(Personality::Specification);
    let (program, anna, ben) = (
        station.client("an old program"),
        station.client("Anna"),
        station.client("Ben"),
    );
    station.ask(anna, Request::TakeLease).unwrap();
    assert!(station.send_raw(program, &packet(5.0)).is_err());
    let refused = station.ask(ben, Request::TakeLease).unwrap_err();
    assert!(refused.hint().unwrap().contains("lease ask"), "{refused}");
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
}

#[test]
fn a_pose_is_confirmed_without_control_while_nothing_may_move() {
    let mut station = virtual_station(Personality::Firmware11);
    station.crash(Duration::from_millis(100)).unwrap();
    let (program, anna) = (station.client("an old program"), station.client("Anna"));
    station.run_for(Duration::from_secs(1));
    station.distrust("its port was opened");
    let packet = vector([0.0, 5.0, 0.0], false).emit(&Dialect::FIRMWARE_1_1);
    let refused = station.send_raw(program, &packet).unwrap_err();
    assert_eq!(refused.kind(), "command");
    assert_eq!(holder(&station).as_deref(), Some("an old program"));
    station.ask(anna, Request::ConfirmPose).unwrap();
    assert!(station.supervisor().state().trust.trusted);
    assert_eq!(holder(&station).as_deref(), Some("an old program"));
    station.send_raw(program, &packet).unwrap();
}
