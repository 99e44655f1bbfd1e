//! Jobs that wait for a person, to change the pen.

use std::time::Duration;

use dobot_api::{JobPause, JobPhase, NewJob, News, Notice, Request};
use dobot_controller::Personality;
use dobot_geometry::{Point, Stroke};

use super::drawing;
use super::strokes::{
    DOWN_MM, PERSONALITIES, assert_drawn_once, finish, pen_job, run_to, started, view,
    wait_until_paused,
};

const MESSAGE: &str = "put the blue pen in";

fn lines() -> [Stroke; 2] {
    [0.0, 20.0].map(|y| Stroke::open(vec![Point::new(200.0, y), Point::new(240.0, y)]))
}

fn two_pens(personality: Personality) -> NewJob {
    let [first, second] = lines();
    pen_job(personality, &[(first, None), (second, Some(MESSAGE))])
}

#[test]
fn a_job_waits_for_the_person_once_and_continues() {
    for personality in PERSONALITIES {
        let planned = two_pens(personality);
        let (mut station, anna, job) = started(personality, &planned);
        wait_until_paused(&mut station, job);
        let paused = view(&station);
        assert_eq!(paused.phase, JobPhase::Paused);
        assert_eq!(paused.reason.as_deref(), Some(MESSAGE));
        assert_eq!(paused.completed, planned.pauses[0].before);
        let z_mm = station.arm().samples().last().unwrap().position.z.0;
        assert!(
            z_mm > DOWN_MM + 4.9,
            "{personality}: the pen is at {z_mm} mm"
        );
        assert!(
            station
                .notices()
                .iter()
                .any(|notice| notice.text.contains(MESSAGE))
        );
        station.run_for(Duration::from_mins(1));
        assert_eq!(view(&station).phase, JobPhase::Paused);
        let sent = station.packets().len();
        for asked in [Request::StartJob { job }, Request::StepJob { job }] {
            let refused = station.ask(anna, asked).unwrap_err();
            assert_eq!(refused.kind(), "needs-a-person");
            assert!(refused.to_string().contains(MESSAGE), "{refused}");
        }
        station.run_for(Duration::from_secs(1));
        assert_eq!(station.packets().len(), sent, "{personality}");
        station.ask(anna, Request::ConfirmJob { job }).unwrap();
        station.ask(anna, Request::StartJob { job }).unwrap();
        finish(&mut station, job);
        let waited = |notice: &&Notice| {
            matches!(notice.news, News::Job { .. }) && notice.text.contains(MESSAGE)
        };
        assert_eq!(station.notices().iter().filter(waited).count(), 1);
        assert_drawn_once(&station, &lines(), 0.1, &personality.to_string());
    }
}

#[test]
fn a_station_that_is_killed_while_a_job_waits_does_not_wait_again() {
    for personality in PERSONALITIES {
        let (mut station, _, job) = started(personality, &two_pens(personality));
        wait_until_paused(&mut station, job);
        station.crash(Duration::from_secs(1)).unwrap();
        station.run_for(Duration::from_secs(2));
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        station.ask(anna, Request::ConfirmPose).unwrap();
        station.start(anna, job).unwrap();
        finish(&mut station, job);
        assert_drawn_once(&station, &lines(), 0.1, &personality.to_string());
    }
}

#[test]
fn a_station_killed_before_the_person_was_asked_still_waits() {
    for personality in PERSONALITIES {
        let planned = two_pens(personality);
        for before_ms in [0, 100, 200, 400] {
            let (mut station, _, job) = started(personality, &planned);
            run_to(&mut station, planned.pauses[0].before - 1);
            station.run_for(Duration::from_millis(before_ms));
            let was_reported = station.job(job).unwrap().history.pauses == 1;
            station.crash(Duration::from_secs(1)).unwrap();
            wait_until_paused(&mut station, job);
            let anna = station.client("Anna");
            station.ask(anna, Request::TakeLease).unwrap();
            station.run_for(Duration::from_secs(2));
            station.ask(anna, Request::ConfirmPose).unwrap();
            station.start(anna, job).unwrap();
            if !was_reported {
                station.run_for(Duration::from_millis(10));
                wait_until_paused(&mut station, job);
                assert_eq!(view(&station).reason.as_deref(), Some(MESSAGE));
                station.start(anna, job).unwrap();
            }
            finish(&mut station, job);
            assert_drawn_once(&station, &lines(), 0.1, &personality.to_string());
        }
    }
}

#[test]
fn a_person_who_pauses_just_before_a_wait_is_still_asked() {
    let personality = Personality::Firmware11;
    let planned = two_pens(personality);
    let (mut station, anna, job) = started(personality, &planned);
    run_to(&mut station, planned.pauses[0].before - 1);
    station.ask(anna, Request::PauseJob).unwrap();
    wait_until_paused(&mut station, job);
    if view(&station).reason.as_deref() != Some(MESSAGE) {
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_millis(10));
        wait_until_paused(&mut station, job);
    }
    assert_eq!(view(&station).reason.as_deref(), Some(MESSAGE));
    station.start(anna, job).unwrap();
    finish(&mut station, job);
}

#[test]
fn a_pause_that_makes_no_sense_is_refused() {
    let personality = Personality::Specification;
    let mut station = drawing::virtual_station(personality);
    let pause = |before, message: &str| JobPause {
        before,
        message: message.to_owned(),
    };
    let planned = two_pens(personality);
    let len = planned.commands.len();
    for (pauses, text) in [
        (
            vec![pause(len, "x")],
            format!("a pause is before command {len}; allowed are 0 to"),
        ),
        (
            vec![pause(3, "x"), pause(3, "x")],
            "a pause is before command 3; allowed are 4 to".into(),
        ),
        (
            vec![pause(3, "")],
            "the message of a pause has 0 characters; allowed are 1 to 200".into(),
        ),
        (
            vec![pause(3, &"x".repeat(201))],
            "the message of a pause has 201 characters".into(),
        ),
        (
            vec![pause(3, "a\u{1b}[2J")],
            "the message of a pause is \"a\\u{1b}[2J\"".into(),
        ),
        (
            vec![pause(3, "x"); 1_001],
            "the job has 1001 pauses; allowed are up to 1000".into(),
        ),
    ] {
        let refused = station
            .submit(&NewJob {
                pauses,
                ..planned.clone()
            })
            .expect_err(&text);
        assert!(refused.to_string().contains(&text), "{refused}");
    }
    let spiral = pen_job(personality, &[(super::strokes::spiral(), None)]);
    let moving = NewJob {
        pauses: vec![pause(40, "x")],
        program: dobot_api::JobProgram::default(),
        ..spiral
    };
    let refused = station.submit(&moving).unwrap_err();
    assert_eq!(refused.kind(), "bad-job");
}
