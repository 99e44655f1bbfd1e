//! An interrupted program resumes where the arm is, and reports its progress truthfully.

use std::time::Duration;

use dobot_api::{ClientId, JobKind, JobProgram, JobState, NewJob, Request};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_wire::{Command, MoveTo, MovingMode, Packet};

use super::drawing::virtual_station;

fn target([x_mm, y_mm, z_mm]: [f32; 3], mode: MovingMode, suction: bool) -> MoveTo {
    MoveTo {
        mode,
        suction,
        pause_s: 0.3,
        ..MoveTo::to(x_mm, y_mm, z_mm)
    }
}

fn program(targets: &[MoveTo]) -> NewJob {
    NewJob {
        title: "a program".into(),
        kind: JobKind::Program,
        commands: targets
            .iter()
            .map(|target| Command::from(*target))
            .collect(),
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram::default(),
    }
}

fn begin(station: &mut VirtualStation, job: &NewJob) -> (ClientId, u64) {
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, Request::ConfirmPose).unwrap();
    let number = station.submit(job).unwrap();
    station.start(anna, number).unwrap();
    (anna, number)
}

/// Waits until the job is paused in the journal.
fn paused(station: &mut VirtualStation, job: u64) {
    let latest = station.now() + Duration::from_secs(60);
    let is_paused = |station: &VirtualStation| {
        let state = station.job(job).unwrap().state;
        matches!(state, JobState::Paused { .. }) && station.supervisor().is_at_rest()
    };
    assert!(
        station.run_until(latest, is_paused),
        "{:?}",
        station.job(job).unwrap().state
    );
}

/// Resumes to the end; each target with a pause was sent this often.
fn finish(station: &mut VirtualStation, job: u64, wanted: &NewJob) -> Vec<usize> {
    let anna = station.client("Anna");
    station.ask(anna, Request::SeizeLease).unwrap();
    station.ask(anna, Request::ConfirmPose).unwrap();
    station.start(anna, job).unwrap();
    let latest = station.now() + Duration::from_secs(60);
    let is_done = |station: &VirtualStation| station.job(job).unwrap().state == JobState::Done;
    assert!(
        station.run_until(latest, is_done),
        "{:?}",
        station.job(job).unwrap().state
    );
    let dialect = station.job(job).unwrap().dialect;
    let sent: Vec<Command> = station
        .packets()
        .iter()
        .map(|(_, bytes)| Packet::from_bytes(bytes).unwrap())
        .filter_map(|packet| Command::parse(&packet, &dialect).ok())
        .collect();
    let times = |command: &Command| sent.iter().filter(|other| *other == command).count();
    wanted.commands.iter().map(times).collect()
}

#[test]
fn a_straight_first_line_that_is_already_done_does_not_keep_the_rest_from_resuming() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let wanted = program(&[
            target([200.0, -60.0, 25.0], MovingMode::MovL, false),
            target([230.0, 0.0, 25.0], MovingMode::MovJ, false),
        ]);
        let (_, job) = begin(&mut station, &wanted);
        station.run_for(Duration::from_millis(400));
        station.crash(Duration::from_secs(4)).unwrap();
        paused(&mut station, job);
        assert_eq!(finish(&mut station, job, &wanted), [1, 1], "{personality}");
    }
}

#[test]
fn a_grip_seen_only_after_the_link_is_restored_counts_as_done() {
    for personality in Personality::ALL {
        for away_ms in (900..2_000).step_by(50) {
            let mut station = virtual_station(personality);
            let wanted = program(&[
                target([200.0, -60.0, 25.0], MovingMode::MovL, true),
                target([230.0, 0.0, 25.0], MovingMode::MovL, true),
            ]);
            let (_, job) = begin(&mut station, &wanted);
            station.run_for(Duration::from_millis(400));
            station.unplug();
            station.run_for(Duration::from_millis(away_ms));
            station.plug();
            paused(&mut station, job);
            let times = finish(&mut station, job, &wanted);
            assert_eq!(times, [1, 1], "{personality}, {away_ms} ms");
        }
    }
}

#[test]
fn a_station_that_was_suspended_while_the_arm_continued_sends_nothing_twice() {
    for personality in Personality::ALL {
        for stalled_ms in [300, 700, 1_100, 1_900] {
            let mut station = virtual_station(personality);
            let wanted = program(&[
                target([230.0, 0.0, 10.0], MovingMode::Jump, false),
                target([240.0, 30.0, 10.0], MovingMode::MovJ, false),
            ]);
            let (_, job) = begin(&mut station, &wanted);
            station.run_for(Duration::from_millis(300));
            station.stall(Duration::from_millis(stalled_ms));
            station.run_for(Duration::from_millis(100));
            let trust = station.supervisor().state().trust;
            assert!(trust.trusted, "{personality}, {stalled_ms} ms: {trust:?}");
            let over = station.now() + Duration::from_secs(20);
            let rests = |station: &VirtualStation| {
                station.supervisor().is_at_rest()
                    && station.job(job).unwrap().state != JobState::Running
            };
            assert!(
                station.run_until(over, rests),
                "{personality}, {stalled_ms} ms"
            );
            let times = if station.job(job).unwrap().state == JobState::Done {
                continue;
            } else {
                finish(&mut station, job, &wanted)
            };
            assert_eq!(times, [1, 1], "{personality}, {stalled_ms} ms");
        }
    }
}

#[test]
fn a_program_whose_arm_was_reset_is_paused_and_sends_nothing_until_a_person_has_checked() {
    for personality in Personality::ALL {
        let power_up = PowerUp::new(personality);
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        let arm = arm.with_faults(power_up, &["reset@2s".parse().unwrap()], 1);
        let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
        station.run_for(Duration::from_secs(1));
        let wanted = program(&[
            target([200.0, -60.0, 10.0], MovingMode::MovJ, false),
            target([230.0, 0.0, 25.0], MovingMode::MovJ, false),
        ]);
        let (_, job) = begin(&mut station, &wanted);
        // It is frozen while the arm is reset, so that the link is not lost.
        station.run_for(Duration::from_millis(500));
        station.stall(Duration::from_secs(3));
        let before = station.packets().len();
        paused(&mut station, job);
        let texts = station.notices().iter().map(|notice| &*notice.text);
        let lies: Vec<_> = texts.filter(|text| text.contains("sent again")).collect();
        assert!(lies.is_empty(), "{personality}: {lies:?}");
        let moves = station.packets()[before..]
            .iter()
            .filter(|(_, bytes)| bytes[4] == 3);
        assert_eq!(moves.count(), 0, "{personality}");
    }
}

#[test]
fn after_a_straight_line_that_may_have_been_cut_short_a_movj_is_sent_before_the_next() {
    // The cable is pulled while the line waits until laser off has passed.
    for unplugged_ms in [5, 20, 40, 47, 60, 100] {
        let mut station = virtual_station(Personality::Firmware11);
        let wanted = program(&[
            target([200.0, -60.0, 25.0], MovingMode::MovJ, false),
            target([230.0, 0.0, 25.0], MovingMode::MovL, false),
        ]);
        let (anna, job) = begin(&mut station, &wanted);
        station.run_for(Duration::from_millis(500));
        station.ask(anna, Request::PauseJob).unwrap();
        paused(&mut station, job);
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_millis(unplugged_ms));
        station.unplug();
        station.run_for(Duration::from_secs(5));
        station.plug();
        paused(&mut station, job);
        assert_eq!(
            finish(&mut station, job, &wanted),
            [1, 1],
            "{unplugged_ms} ms"
        );
    }
}
