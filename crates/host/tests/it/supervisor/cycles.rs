//! A program that is done again and again: a cube is carried there and back.

use std::time::Duration;

use dobot_api::{JobPause, JobPhase, NewJob, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;

use crate::cases::carries::{HERE, THERE, attend, cube_is_at, run_until_rest, shuttle, station};

const BOTH: [Personality; 2] = [Personality::Specification, Personality::Firmware11];

#[test]
fn a_cycle_is_repeated_as_often_as_requested() {
    for personality in BOTH {
        let (mut station, anna) = station(personality, &[], 0);
        let job = station.submit(&shuttle(Some(7))).unwrap();
        station.start(anna, job).unwrap();
        run_until_rest(&mut station, job);
        let job = station.job(job).unwrap();
        assert_eq!(job.state.to_string(), "done");
        assert_eq!(job.window.completed, 1 + 7 * 8);
        assert!(cube_is_at(&station, HERE));
        let carried = station
            .notices()
            .iter()
            .filter(|notice| notice.text.contains("sent again"));
        assert_eq!(carried.count(), 0);
    }
}

#[test]
fn cycles_are_counted_and_timed_while_they_run() {
    for personality in BOTH {
        let (mut station, anna) = station(personality, &[], 0);
        let job = station.submit(&shuttle(None)).unwrap();
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_secs(300));
        let view = station.supervisor().job().unwrap();
        let program = view.program.unwrap();
        assert_eq!(
            (view.phase, program.cycles, view.left_s),
            (JobPhase::Running, None, None)
        );
        assert!(program.cycles_done > 10, "{program:?}");
        let (planned_s, mean_s) = (
            program.planned_cycle_s.unwrap(),
            program.mean_cycle_s.unwrap(),
        );
        // Each of the four grips waits for the motion before it to be seen to end, and is itself seen.
        assert!(
            (planned_s..planned_s + 4.0).contains(&mean_s),
            "{planned_s} {mean_s}"
        );
        station.ask(anna, Request::PauseJob).unwrap();
        station.run_for(Duration::from_secs(20));
        let paused = station.supervisor().job().unwrap();
        assert_eq!(paused.phase, JobPhase::Paused);
        let done = paused.program.unwrap().cycles_done;
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_secs(120));
        let running = station.supervisor().job().unwrap().program.unwrap();
        assert!(running.cycles_done > done + 3, "{running:?}");
        station.ask(anna, Request::CancelJob { job }).unwrap();
        run_until_rest(&mut station, job);
        assert_eq!(station.job(job).unwrap().state.phase(), JobPhase::Stopped);
    }
}

#[test]
fn a_program_advances_step_by_step_on_request() {
    let (mut station, anna) = station(Personality::Firmware11, &[], 0);
    let job = station.submit(&shuttle(Some(2))).unwrap();
    let mut seen = Vec::new();
    for _ in 0..40 {
        if station.ask(anna, Request::StepJob { job }).is_err() {
            break;
        }
        run_until_rest(&mut station, job);
        seen.push(station.job(job).unwrap().window.completed);
    }
    assert_eq!(seen, [1, 3, 5, 7, 9, 11, 13, 15, 17]);
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
    assert!(cube_is_at(&station, HERE));
}

#[test]
fn a_program_waits_for_the_person_in_every_cycle() {
    let (mut station, anna) = station(Personality::Specification, &[], 0);
    let pauses = vec![JobPause {
        before: 5,
        message: "turn the cube".into(),
    }];
    let job = NewJob {
        pauses,
        ..shuttle(Some(5))
    };
    let job = station.submit(&job).unwrap();
    for cycle in 0..5 {
        station.start(anna, job).unwrap();
        run_until_rest(&mut station, job);
        let kept = station.job(job).unwrap();
        assert_eq!(kept.state.to_string(), "paused (turn the cube)");
        assert_eq!(kept.window.completed, 5 + cycle * 8);
        assert!(cube_is_at(&station, THERE));
    }
    station.start(anna, job).unwrap();
    run_until_rest(&mut station, job);
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
}

#[test]
fn no_object_is_lost_or_misplaced_by_damaged_packets() {
    for personality in BOTH {
        let faults = ["flip=0.05%", "drop=0.02%"];
        let (mut station, anna) = station(personality, &faults, 7);
        let job = station.submit(&shuttle(Some(60))).unwrap();
        station.start(anna, job).unwrap();
        run_until_rest(&mut station, job);
        let state = station.job(job).unwrap().state;
        assert_eq!(state.to_string(), "done");
        let again = station
            .notices()
            .iter()
            .filter(|notice| notice.text.contains("sent again"))
            .count();
        assert!(again > 0, "nothing was lost: the faults are too few");
        assert!(cube_is_at(&station, HERE));
    }
}

#[test]
fn no_carry_is_lost_or_done_twice_whenever_the_station_is_killed() {
    for personality in BOTH {
        for seed in 0..6 {
            let (mut station, anna) = station(personality, &[], seed);
            let job = station.submit(&shuttle(Some(12))).unwrap();
            station.start(anna, job).unwrap();
            for kill in 0..12 {
                station.run_for(Duration::from_millis(5000 + 1370 * kill + 217 * seed));
                if station.job(job).unwrap().state.is_over() {
                    break;
                }
                station.crash(Duration::from_millis(300 * kill)).unwrap();
                attend(&mut station, job);
            }
            run_until_rest(&mut station, job);
            let kept = station.job(job).unwrap();
            assert_eq!(
                kept.state.to_string(),
                "done",
                "seed {seed} on {personality:?}"
            );
            assert!(cube_is_at(&station, HERE));
        }
    }
}

#[test]
fn a_program_runs_faster_and_slower_while_it_is_running() {
    for personality in BOTH {
        let (mut station, anna) = station(personality, &[], 0);
        let job = station.submit(&shuttle(None)).unwrap();
        station.start(anna, job).unwrap();
        let mut mean_s = [100.0, 25.0, 200.0].map(|percent| {
            station.ask(anna, Request::SetJobSpeed { percent }).unwrap();
            station.run_for(Duration::from_secs(100));
            let before = cycles_done(&station);
            station.run_for(Duration::from_secs(400));
            let after = cycles_done(&station);
            400.0 / f64::from(u32::try_from(after - before).unwrap())
        });
        mean_s.rotate_right(1);
        assert!(mean_s.is_sorted(), "{mean_s:?}");
        // The default of an arm is 50 %, so twice as fast is the maximum.
        let refused = station
            .ask(anna, Request::SetJobSpeed { percent: 201.0 })
            .unwrap_err();
        assert!(refused.to_string().contains("10 to 200 %"), "{refused}");
    }
}

fn cycles_done(station: &VirtualStation) -> u64 {
    let job = station.supervisor().job().unwrap();
    job.program.unwrap().cycles_done
}
