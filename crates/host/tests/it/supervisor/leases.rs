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
    let mut it = virtual_station(Personality::Specification);
    let anna = it.client("Anna");
    let before = it.packets().len();
    let refused = it.ask(anna, UP).unwrap_err();
    assert_eq!(refused, Refusal::NoLease { holder: None });
    assert_eq!(it.packets().len(), before, "nothing was sent");
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(anna, UP).unwrap();
}

#[test]
fn a_second_client_learns_who_has_control() {
    let mut it = virtual_station(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    let refused = it.ask(ben, Request::TakeLease).unwrap_err();
    assert_eq!(refused.to_string(), "Anna has control of the arm");
    let refused = it.ask(ben, UP).unwrap_err();
    assert_eq!(refused.kind(), "no-lease");
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
}

#[test]
fn control_passes_to_the_requester_when_the_holder_grants_it() {
    let mut it = virtual_station(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    let grant = Request::GrantLease { to: ben };
    assert_eq!(it.ask(anna, grant.clone()), Err(Refusal::NotAsking(ben.0)));
    it.ask(ben, Request::AskLease).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
    it.ask(anna, grant).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Ben"));
}

#[test]
fn control_is_free_after_its_holder_leaves() {
    let mut it = virtual_station(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    it.leave(anna);
    assert_eq!(holder(&it), None);
    it.ask(ben, Request::TakeLease).unwrap();
}

#[test]
fn an_administrator_may_take_control_from_another_client() {
    let mut it = virtual_station(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(ben, Request::SeizeLease).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Ben"));
    assert_eq!(it.ask(anna, UP).unwrap_err().kind(), "no-lease");
}

#[test]
fn a_watcher_may_stop_and_nothing_else() {
    let mut it = virtual_station(Personality::Specification);
    let watcher = it.client_as("the class", Role::Watch);
    assert_eq!(
        it.ask(watcher, Request::TakeLease).unwrap_err().kind(),
        "role"
    );
    it.ask(watcher, Request::Stop { reason: None }).unwrap();
    assert!(it.supervisor().state().stop.is_some());
}

#[test]
fn a_locked_arm_belongs_to_the_administrators_and_all_others_learn_that() {
    let mut it = virtual_station(Personality::Specification);
    let teacher = it.client("Ms Weber");
    let anna = it.client_as("Anna", Role::Control);
    let ben = it.client_as("Ben", Role::Control);
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(ben, Request::AskLease).unwrap();
    let message = Some("eyes on me".into());
    assert_eq!(
        it.ask(anna, Request::Lock { message: None })
            .unwrap_err()
            .kind(),
        "role"
    );
    it.ask(teacher, Request::Lock { message }).unwrap();
    assert_eq!(holder(&it), None);
    for (who, request) in [
        (anna, UP),
        (anna, Request::TakeLease),
        (ben, Request::AskLease),
        (ben, Request::ArmLaser { for_s: 60.0 }),
    ] {
        let refused = it.ask(who, request).unwrap_err();
        assert_eq!(
            refused.to_string(),
            "the arm was locked by Ms Weber: eyes on me"
        );
        assert_eq!(refused.kind(), "locked");
    }
    let before = it.packets().len();
    assert!(it.send_raw(ben, &packet(40.0)).is_err());
    assert_eq!(it.packets().len(), before, "nothing was sent");
    // The teacher has control, and grants it to no client while the arm is locked.
    it.ask(teacher, Request::TakeLease).unwrap();
    it.ask(teacher, UP).unwrap();
    it.ask(anna, Request::Stop { reason: None }).unwrap();
    it.ask(teacher, Request::Unlock).unwrap();
    it.ask(teacher, Request::ReleaseLease).unwrap();
    assert_eq!(it.supervisor().state().lock, None);
    it.ask(anna, Request::TakeLease).unwrap();
}

#[test]
fn a_lock_releases_held_buttons_and_brings_a_drawing_to_rest() {
    let mut it = virtual_station(Personality::Firmware11);
    let teacher = it.client("Ms Weber");
    let anna = it.client_as("Anna", Role::Control);
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(anna, UP).unwrap();
    it.run_for(Duration::from_millis(100));
    it.ask(teacher, Request::Lock { message: None }).unwrap();
    it.run_for(Duration::from_secs(2));
    let rest = it.supervisor().state().arm.unwrap();
    assert!(!rest.moving);
    it.ask(teacher, Request::Unlock).unwrap();

    it.ask(anna, Request::TakeLease).unwrap();
    let job = it.submit(&spiral(8)).unwrap();
    it.start(anna, job).unwrap();
    it.run_for(Duration::from_secs(2));
    it.ask(teacher, Request::Lock { message: None }).unwrap();
    let minute = it.now() + Duration::from_mins(1);
    let paused = |station: &VirtualStation| {
        station
            .supervisor()
            .state()
            .job
            .is_some_and(|job| job.phase == JobPhase::Paused)
    };
    assert!(it.run_until(minute, paused));
    it.run_for(Duration::from_secs(5));
    assert_eq!(it.start(anna, job).unwrap_err().kind(), "locked");
    it.ask(teacher, Request::TakeLease).unwrap();
    it.start(teacher, job).unwrap();
    let minute = it.now() + Duration::from_mins(1);
    assert!(it.run_until(minute, |station| is_over(station, job)));
    assert_eq!(it.job(job).unwrap().state.to_string(), "done");
}

#[test]
fn a_message_reaches_all_watchers_and_takes_no_control() {
    let mut it = virtual_station(Personality::Specification);
    let teacher = it.client_as("Ms Weber", Role::Control);
    let text = "five more minutes\u{7}".to_owned();
    it.ask(teacher, Request::Message { text }).unwrap();
    let told = it
        .notices()
        .iter()
        .any(|notice| notice.text == "Ms Weber: five more minutes");
    assert!(told, "{:?}", it.notices());
}

#[test]
fn a_pen_drawing_continues_after_the_client_that_started_it_leaves() {
    let mut it = virtual_station(Personality::Specification);
    let anna = it.client("Anna");
    it.ask(anna, Request::TakeLease).unwrap();
    let job = it.submit(&spiral(8)).unwrap();
    it.start(anna, job).unwrap();
    it.run_for(Duration::from_secs(2));
    it.leave(anna);
    let minute = it.now() + Duration::from_mins(1);
    assert!(it.run_until(minute, |station| is_over(station, job)));
    assert_eq!(it.job(job).unwrap().state.to_string(), "done");
}

const RELEASED: JointJog = JointJog::new(JointJogAxis::Released, 0.0);

/// A packet that moves the arm by this many millimetres.
fn packet(y_mm: f32) -> Packet {
    vector([0.0, y_mm, 0.0], false).emit(&Dialect::SPECIFICATION)
}

#[test]
fn a_person_at_this_machine_takes_control_from_a_raw_client_which_cannot_be_asked() {
    let mut it = virtual_station(Personality::Specification);
    let program = it.client("an old program");
    it.send_raw(program, &packet(40.0)).unwrap();
    it.send_raw(program, &packet(-40.0)).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("an old program"));
    let anna = it.client("Anna");
    let refused = it.ask(anna, UP).unwrap_err();
    let hint = refused.hint().unwrap();
    assert!(hint.contains("dobot lease take"), "{hint}");
    it.ask(anna, Request::TakeLease).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
    let told = it
        .notices()
        .iter()
        .any(|notice| notice.text.contains("Anna took it"));
    assert!(told, "{:?}", it.notices());
    // Waiting packets are dropped, and the program does not get control back by sending more.
    assert_eq!(it.supervisor().session().waiting(), 0);
    for _ in 0..20 {
        let refused = it.send_raw(program, &packet(5.0)).unwrap_err();
        assert_eq!(refused.kind(), "no-lease");
        it.run_for(Duration::from_millis(500));
    }
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
    it.ask(anna, Request::ReleaseLease).unwrap();
    it.send_raw(program, &packet(5.0)).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("an old program"));
}

#[test]
fn a_button_held_by_a_raw_client_is_released_when_a_person_takes_control() {
    for personality in Personality::ALL {
        let mut it = virtual_station(personality);
        let (program, anna) = (it.client("an old program"), it.client("Anna"));
        let pressed = Command::from(JointJog::new(JointJogAxis::BasePlus, 50.0));
        it.send_raw(program, &pressed.emit(&personality.dialect()))
            .unwrap();
        it.run_for(Duration::from_millis(400));
        let before = it.packets().len();
        it.ask(anna, Request::TakeLease).unwrap();
        it.run_for(Duration::from_secs(2));
        let sent = it.packets()[before..].iter();
        let commands: Vec<Command> = sent
            .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
            .map(|packet| Command::parse(&packet, &personality.dialect()).unwrap())
            .collect();
        assert!(
            commands.contains(&RELEASED.into()),
            "{personality}: {commands:?}"
        );
        assert!(commands.contains(&LASER_OFF), "{personality}: {commands:?}");
        assert!(it.supervisor().is_at_rest(), "{personality}");
    }
}

#[test]
fn neither_a_raw_client_nor_another_person_takes_control_from_a_person() {
    let mut it = virtual_station(Personality::Specification);
    let (program, anna, ben) = (
        it.client("an old program"),
        it.client("Anna"),
        it.client("Ben"),
    );
    it.ask(anna, Request::TakeLease).unwrap();
    assert!(it.send_raw(program, &packet(5.0)).is_err());
    let refused = it.ask(ben, Request::TakeLease).unwrap_err();
    assert!(refused.hint().unwrap().contains("lease ask"), "{refused}");
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
}

#[test]
fn a_pose_is_confirmed_without_control_while_nothing_may_move() {
    let mut it = virtual_station(Personality::Firmware11);
    it.crash(Duration::from_millis(100)).unwrap();
    let (program, anna) = (it.client("an old program"), it.client("Anna"));
    it.run_for(Duration::from_secs(1));
    it.distrust("its port was opened");
    let packet = vector([0.0, 5.0, 0.0], false).emit(&Dialect::FIRMWARE_1_1);
    let refused = it.send_raw(program, &packet).unwrap_err();
    assert_eq!(refused.kind(), "command");
    assert_eq!(holder(&it).as_deref(), Some("an old program"));
    it.ask(anna, Request::ConfirmPose).unwrap();
    assert!(it.supervisor().state().trust.trusted);
    assert_eq!(holder(&it).as_deref(), Some("an old program"));
    it.send_raw(program, &packet).unwrap();
}
