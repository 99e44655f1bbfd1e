//! Jobs that are paused, ended and interrupted in the moments between.

use std::time::Duration;

use dobot_api::{ClientId, JobPhase, Jog, NewJob, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{Command, MoveTo, MovingMode, Packet, WriteVector};

use super::drawing::{drawn_mm, is_over, is_paused, spiral, virtual_station, wanted_mm};

/// A drawing that is at work.
fn drawing() -> (VirtualStation, ClientId, u64, NewJob) {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let drawing = spiral(12);
    let job = station.submit(&drawing).unwrap();
    station.start(anna, job).unwrap();
    station.run_for(Duration::from_secs(3));
    (station, anna, job, drawing)
}

fn wait_until_paused(station: &mut VirtualStation, job: u64) {
    let minute = station.now() + Duration::from_secs(60);
    assert!(station.run_until(minute, |station| is_paused(station, job)));
}

fn finish(station: &mut VirtualStation, anna: ClientId, job: u64, drawing: &NewJob) {
    station.start(anna, job).unwrap();
    let minutes = station.now() + Duration::from_secs(180);
    assert!(station.run_until(minutes, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
    let (found_mm, wanted_mm) = (drawn_mm(station), wanted_mm(drawing));
    assert!(
        (found_mm - wanted_mm).abs() < 0.3,
        "{found_mm} mm were drawn, wanted are {wanted_mm} mm, 0.3 mm off are allowed"
    );
}

/// Returns how often the station lifted the tool, which it does slowly.
fn lifts(station: &VirtualStation) -> usize {
    let dialect = Personality::Firmware11.dialect();
    let command = |bytes: &[u8; 42]| Command::parse(&Packet::from_bytes(bytes).unwrap(), &dialect);
    let lifts = |command: &Command| match command {
        Command::WriteVector(WriteVector {
            z_mm,
            max_speed_mm_s,
            ..
        }) => *z_mm > 0.0 && *max_speed_mm_s == 20.0,
        _ => false,
    };
    let commands = station
        .packets()
        .iter()
        .map(|(_, bytes)| command(bytes).unwrap());
    commands.filter(lifts).count()
}

#[test]
fn a_job_that_is_paused_twice_is_lifted_once() {
    let (mut station, anna, job, drawing) = drawing();
    for _ in 0..12 {
        if station.ask(anna, Request::PauseJob).is_err() {
            break;
        }
        station.run_for(Duration::from_millis(300));
    }
    wait_until_paused(&mut station, job);
    assert_eq!(lifts(&station), 1);
    finish(&mut station, anna, job, &drawing);
}

#[test]
fn a_job_resumed_from_another_place_turns_the_tool_back() {
    let rotation_deg = |moves_away: bool| {
        let (mut station, anna, job, drawing) = drawing();
        station.ask(anna, Request::PauseJob).unwrap();
        wait_until_paused(&mut station, job);
        if moves_away {
            // The tool is turned by 50 degrees, on the other side of the arm.
            let command = Command::from(MoveTo {
                rotation_deg: 20.0,
                ..MoveTo::to(200.0, -120.0, 20.0)
            });
            station.ask(anna, Request::Command { command }).unwrap();
            station.run_for(Duration::from_secs(8));
        }
        finish(&mut station, anna, job, &drawing);
        station
            .supervisor()
            .state()
            .arm
            .unwrap()
            .status
            .rotation_deg
    };
    let (stays, went) = (rotation_deg(false), rotation_deg(true));
    assert!((stays - went).abs() < 0.1, "{stays} and {went} degrees");
}

#[test]
fn a_cable_pulled_while_a_paused_job_comes_to_rest_repeats_nothing() {
    for pull_ms in [0, 60, 120, 180, 240, 300, 600] {
        let (mut station, anna, job, drawing) = drawing();
        station.ask(anna, Request::PauseJob).unwrap();
        station.run_for(Duration::from_millis(pull_ms));
        station.unplug();
        station.run_for(Duration::from_secs(6));
        station.plug();
        wait_until_paused(&mut station, job);
        station.ask(anna, Request::ConfirmPose).unwrap();
        finish(&mut station, anna, job, &drawing);
    }
}

#[test]
fn an_ended_job_is_not_paused_afterwards() {
    let (mut station, anna, job, _) = drawing();
    station.ask(anna, Request::CancelJob { job }).unwrap();
    station.ask(anna, Request::PauseJob).unwrap();
    let minute = station.now() + Duration::from_secs(60);
    assert!(station.run_until(minute, |station| is_over(station, job)));
    assert!(station.supervisor().job().is_none());
}

#[test]
fn a_paused_job_that_is_ended_moves_nothing() {
    let (mut station, anna, job, _) = drawing();
    station.ask(anna, Request::PauseJob).unwrap();
    wait_until_paused(&mut station, job);
    let before = lifts(&station);
    station.ask(anna, Request::CancelJob { job }).unwrap();
    station.run_for(Duration::from_secs(5));
    assert!(is_over(&station, job));
    assert_eq!(lifts(&station), before);
}

#[test]
fn a_pause_while_the_station_detects_where_the_arm_rests_repeats_nothing() {
    for pause_ms in [0, 50, 150, 400, 900, 1_500] {
        let (mut station, _, job, drawing) = drawing();
        station.crash(Duration::from_millis(200)).unwrap();
        station.run_for(Duration::from_millis(pause_ms));
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        // If it is known already, the job is no longer running.
        let _ = station.ask(anna, Request::PauseJob);
        wait_until_paused(&mut station, job);
        station.ask(anna, Request::ConfirmPose).unwrap();
        finish(&mut station, anna, job, &drawing);
    }
}

#[test]
fn a_paused_job_does_not_block_another_one() {
    let (mut station, anna, job, drawing) = drawing();
    station.ask(anna, Request::PauseJob).unwrap();
    wait_until_paused(&mut station, job);
    let between = NewJob {
        commands: vec![spiral(1).commands[2]],
        ..spiral(1)
    };
    let other = station.submit(&between).unwrap();
    station.start(anna, other).unwrap();
    let minute = station.now() + Duration::from_secs(60);
    assert!(station.run_until(minute, |station| is_over(station, other)));
    assert!(is_paused(&station, job));
    finish(&mut station, anna, job, &drawing);
}

#[test]
fn a_laser_whose_arming_time_is_over_does_not_disturb_a_pen() {
    let (mut station, anna, job, drawing) = drawing();
    station.ask(anna, Request::ArmLaser { for_s: 2.0 }).unwrap();
    let minutes = station.now() + Duration::from_secs(180);
    assert!(station.run_until(minutes, |station| is_over(station, job)));
    let (found_mm, wanted_mm) = (drawn_mm(&station), wanted_mm(&drawing));
    assert!(
        (found_mm - wanted_mm).abs() < 0.3,
        "{found_mm} mm, wanted {wanted_mm} mm"
    );
}

#[test]
fn the_time_that_is_left_gets_less_to_the_end() {
    let (mut station, _, job, _) = drawing();
    let mut before_s = f64::INFINITY;
    while !is_over(&station, job) {
        if let Some(view) = station
            .supervisor()
            .job()
            .filter(|job| job.phase == JobPhase::Running)
        {
            let left_s = view.left_s.unwrap();
            assert!(
                left_s <= before_s && left_s >= 0.0,
                "{left_s} s after {before_s} s"
            );
            before_s = left_s;
        }
        station.run_for(Duration::from_millis(100));
    }
    assert!(before_s < 0.001, "{before_s} s");
}

#[test]
fn a_job_moved_away_by_hand_while_its_place_is_unclear_is_not_resumed() {
    let (mut station, _, job, _) = drawing();
    station.crash(Duration::from_millis(200)).unwrap();
    // A person pushes the arm: it rests where no command ends.
    let away = spiral(1).commands[2];
    let moved = Command::MoveTo(dobot_wire::MoveTo {
        x_mm: 200.0,
        y_mm: 40.0,
        ..match away {
            Command::MoveTo(target) => target,
            _ => unreachable!("it is a target"),
        }
    });
    let packet = moved.emit(&Personality::Firmware11.dialect()).to_bytes();
    let now = station.now();
    station.arm_mut().handle_bytes(now, &packet);
    wait_until_paused(&mut station, job);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, Request::ConfirmPose).unwrap();
    station.run_for(Duration::from_secs(5));
    for _ in 0..2 {
        let refused = station.start(anna, job).unwrap_err();
        assert_eq!(refused.kind(), "cannot-resume", "{refused}");
    }
    station.ask(anna, Request::CancelJob { job }).unwrap();
    station.run_for(Duration::from_secs(1));
    assert!(is_over(&station, job));
}

#[test]
fn a_stop_allows_enough_time_while_the_dialect_is_being_detected() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let up = Jog::Linear(dobot_wire::LinearJog::new(
        dobot_wire::LinearJogAxis::Released,
        0.0,
    ));
    station.ask(anna, Request::Jog { jog: up }).unwrap();
    station.run_for(Duration::from_secs(1));
    station.ask(anna, Request::Detect).unwrap();
    station.run_for(Duration::from_millis(5_300));
    station.ask(anna, Request::Stop { reason: None }).unwrap();
    let stop = station.supervisor().state().stop.unwrap();
    station.run_until(Duration::from_secs_f64(stop.rests_by_s), |_| false);
    let there = station.arm().mechanics().joints_at(station.now());
    station.run_for(Duration::from_secs(10));
    assert_eq!(there, station.arm().mechanics().joints_at(station.now()));
}

#[test]
fn a_program_paused_at_the_end_of_its_first_line_resumes_from_there() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let target = |y_mm| {
        Command::from(MoveTo {
            mode: MovingMode::MovL,
            pause_s: 0.5,
            ..MoveTo::to(220.0, y_mm, 20.0)
        })
    };
    let program = NewJob {
        commands: vec![target(0.0), target(40.0)],
        lift_mm: 0.0,
        ..spiral(1)
    };
    let job = station.submit(&program).unwrap();
    station.start(anna, job).unwrap();
    let second = station.now() + Duration::from_secs(1);
    assert!(
        station.run_until(second, |station| station.supervisor().session().in_flight()
            == 1)
    );
    station.ask(anna, Request::PauseJob).unwrap();
    wait_until_paused(&mut station, job);
    assert_eq!(station.supervisor().job().unwrap().completed, 1);
    station.start(anna, job).unwrap();
    let minute = station.now() + Duration::from_secs(60);
    assert!(station.run_until(minute, |station| is_over(station, job)));
}
