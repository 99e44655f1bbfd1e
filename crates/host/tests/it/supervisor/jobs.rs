//! Jobs: every vector once.

use std::time::Duration;

use dobot_api::{ClientId, JobPhase, Reply, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;

use super::drawing::{drawn_mm, is_over, spiral, virtual_station, wanted_mm};

const PERSONALITIES: [Personality; 2] = Personality::ALL;

fn close(found_mm: f64, wanted_mm: f64, what: &str) {
    let allowed_mm = 0.3;
    assert!(
        (found_mm - wanted_mm).abs() < allowed_mm,
        "{what}: {found_mm} mm were drawn, wanted are {wanted_mm} mm, {allowed_mm} mm off are allowed"
    );
}

#[test]
fn a_job_is_drawn_once_and_done() {
    for personality in PERSONALITIES {
        let mut station = virtual_station(personality);
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let drawing = spiral(12);
        let job = station.submit(&drawing).unwrap();
        station.start(anna, job).unwrap();
        let planned_s = station.supervisor().job().unwrap().planned_s.unwrap();
        let began = station.now();
        assert!(
            station.run_until(began + Duration::from_mins(2), |station| is_over(
                station, job
            ))
        );
        let took_s = station.now().saturating_sub(began).as_secs_f64();
        assert!(
            (took_s / planned_s - 1.0).abs() < 0.25,
            "{took_s} s, planned {planned_s} s"
        );
        assert_eq!(station.job(job).unwrap().state.to_string(), "done");
        close(
            drawn_mm(&station),
            wanted_mm(&drawing),
            &personality.to_string(),
        );
    }
}

#[test]
fn a_paused_job_lifts_its_pen_and_resumes_where_it_was() {
    for personality in PERSONALITIES {
        let mut station = virtual_station(personality);
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let drawing = spiral(12);
        let job = station.submit(&drawing).unwrap();
        station.start(anna, job).unwrap();
        for _ in 0..3 {
            station.run_for(Duration::from_millis(2_500));
            station.ask(anna, Request::PauseJob).unwrap();
            let minute = station.now() + Duration::from_mins(1);
            let rests = |station: &VirtualStation| {
                station
                    .job(job)
                    .unwrap()
                    .state
                    .to_string()
                    .starts_with("paused")
            };
            assert!(station.run_until(minute, rests), "{personality}");
            station.run_for(Duration::from_secs(2));
            let z_mm = station.supervisor().state().arm.unwrap().status.z_mm;
            assert!(z_mm > -26.0, "{personality}: the pen is at {z_mm} mm");
            assert_eq!(station.supervisor().job().unwrap().phase, JobPhase::Paused);
            station.start(anna, job).unwrap();
        }
        let minutes = station.now() + Duration::from_mins(3);
        assert!(
            station.run_until(minutes, |station| is_over(station, job)),
            "{personality}"
        );
        close(
            drawn_mm(&station),
            wanted_mm(&drawing),
            &personality.to_string(),
        );
    }
}

#[test]
fn a_job_that_leaves_the_policy_is_refused_with_the_command_that_does() {
    let mut station = virtual_station(Personality::Firmware11);
    let refused = station.submit(&spiral(300)).unwrap_err();
    assert_eq!(refused.kind(), "bad-job");
    let text = refused.to_string();
    assert!(text.starts_with("command "), "{text}");
}

#[test]
fn a_job_without_a_start_place_is_refused() {
    let mut station = virtual_station(Personality::Firmware11);
    let mut drawing = spiral(4);
    drawing.commands.remove(2);
    let refused = station.submit(&drawing).unwrap_err().to_string();
    assert!(
        refused.contains("command 2 of the job: the first motion must be a target"),
        "{refused}"
    );
}

#[test]
fn no_other_client_moves_the_arm_while_a_job_runs() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(12)).unwrap();
    station.start(anna, job).unwrap();
    station.run_for(Duration::from_secs(1));
    let command = spiral(1).commands[2];
    let refused = station.ask(anna, Request::Command { command }).unwrap_err();
    assert_eq!(refused.to_string(), format!("job {job} is using the arm"));
}

/// The number of the job that a request answers with.
fn number(station: &mut VirtualStation, who: ClientId, request: Request) -> u64 {
    match station.ask(who, request) {
        Ok(Reply::Job { job }) => job.job,
        other => panic!("it answers with a job, and not with {other:?}"),
    }
}

fn listed(station: &mut VirtualStation) -> Vec<(u64, JobPhase)> {
    let jobs = station.jobs().unwrap();
    jobs.iter().map(|job| (job.job, job.phase)).collect()
}

#[test]
fn a_finished_job_is_queued_and_drawn_again() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let drawing = spiral(12);
    let first = station.submit(&drawing).unwrap();
    station.start(anna, first).unwrap();
    let minute = Duration::from_mins(1);
    assert!(station.run_until(station.now() + minute, |station| is_over(station, first)));
    let once_mm = drawn_mm(&station);
    let again = number(
        &mut station,
        anna,
        Request::QueueAgain {
            job: first,
            key: None,
        },
    );
    assert_ne!(again, first);
    station.start(anna, again).unwrap();
    assert!(station.run_until(station.now() + minute, |station| is_over(station, again)));
    close(drawn_mm(&station), 2.0 * once_mm, "twice");
    assert_eq!(station.jobs().unwrap()[1].title, drawing.title);
}

#[test]
fn queued_jobs_can_be_moved_and_other_jobs_cannot() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let [one, two, three] = [(); 3].map(|()| station.submit(&spiral(2)).unwrap());
    let moved = Request::MoveJob {
        job: three,
        before: Some(one),
    };
    assert_eq!(number(&mut station, anna, moved), three);
    let queued = |job| (job, JobPhase::Queued);
    assert_eq!(listed(&mut station), [three, one, two].map(queued));
    let last = Request::MoveJob {
        job: one,
        before: None,
    };
    number(&mut station, anna, last);
    assert_eq!(listed(&mut station), [three, two, one].map(queued));
    station.ask(anna, Request::CancelJob { job: two }).unwrap();
    let refused = station.ask(
        anna,
        Request::MoveJob {
            job: one,
            before: Some(two),
        },
    );
    assert_eq!(
        refused.unwrap_err().to_string(),
        format!("job {two} is stopped; allowed are jobs that are queued")
    );
}

#[test]
fn a_job_is_deleted_when_over_or_not_started_but_not_while_running() {
    let mut station = virtual_station(Personality::Specification);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let [job, other] = [(); 2].map(|()| station.submit(&spiral(12)).unwrap());
    station.start(anna, job).unwrap();
    station.run_for(Duration::from_secs(1));
    let refused = station.ask(anna, Request::ForgetJob { job }).unwrap_err();
    assert_eq!(
        refused.to_string(),
        format!("job {job} is running; allowed are jobs that are queued, stopped, done or failed")
    );
    station
        .ask(anna, Request::ForgetJob { job: other })
        .unwrap();
    assert_eq!(listed(&mut station), [(job, JobPhase::Running)]);
    assert!(
        station.run_until(station.now() + Duration::from_mins(1), |station| is_over(
            station, job
        ))
    );
    station.ask(anna, Request::ForgetJob { job }).unwrap();
    assert_eq!(listed(&mut station), []);
    let gone = station
        .ask(anna, Request::QueueAgain { job, key: None })
        .unwrap_err();
    assert_eq!(gone.to_string(), format!("there is no job {job}"));
}
