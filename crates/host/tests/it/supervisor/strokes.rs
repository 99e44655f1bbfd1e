//! Strokes that are drawn in one go: the effects of a pause, another speed and another height.

use std::f64::consts::TAU;
use std::time::Duration;

use dobot_api::{ClientId, JobKind, JobPause, JobView, NewJob, Request};
use dobot_arm::Position;
use dobot_controller::Personality;
use dobot_geometry::{Deviation, Point, Stroke, deviation};
use dobot_host::VirtualStation;
use dobot_plan::{ArmLimits, DrawingTool, Paper, Pass, Pen, Plan};
use dobot_sim::Sample;

use super::drawing::{is_over, virtual_station};

pub(crate) const PERSONALITIES: [Personality; 2] = Personality::ALL;
pub(crate) const DOWN_MM: f64 = -30.0;

/// A spiral of short vectors, drawn in one go.
pub(crate) fn spiral() -> Stroke {
    let point = |step: i32| {
        let turns = f64::from(step) / 48.0;
        let (sin, cos) = (turns * TAU).sin_cos();
        let radius_mm = 12.0 + 6.0 * turns;
        Point::new(230.0 + radius_mm * cos, radius_mm * sin)
    };
    Stroke::open((0..=144).map(point).collect())
}

/// Passes of a pen as a job, with what a person does before some of them.
pub(crate) fn pen_job(personality: Personality, passes: &[(Stroke, Option<&str>)]) -> NewJob {
    pen_job_at(Pen::default().draw_speed_mm_s, personality, passes)
}

/// A pen job at this speed, in mm/s.
pub(crate) fn pen_job_at(
    draw_speed_mm_s: f64,
    personality: Personality,
    passes: &[(Stroke, Option<&str>)],
) -> NewJob {
    let pen = Pen {
        lift_mm: 5.0,
        draw_speed_mm_s,
        ..Pen::default()
    };
    let pass = |(stroke, message): &(Stroke, Option<&str>)| Pass {
        message: message.map(str::to_owned),
        ..Pass::new(DrawingTool::Pen(pen), vec![stroke.clone()])
    };
    let passes: Vec<Pass> = passes.iter().map(pass).collect();
    let plan = Plan::new(&passes, &Paper::level(DOWN_MM), &arm_limits(personality)).unwrap();
    let pause = |(before, message): (usize, &str)| JobPause {
        before,
        message: message.to_owned(),
    };
    NewJob {
        title: "a spiral".into(),
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: 5.0,
        pauses: plan.breaks_in_commands().map(pause).collect(),
        program: dobot_api::JobProgram::default(),
    }
}

pub(crate) fn arm_limits(personality: Personality) -> ArmLimits {
    ArmLimits::of(personality.dialect())
}

/// A station, a client that has control, and a running job.
pub(crate) fn started(personality: Personality, job: &NewJob) -> (VirtualStation, ClientId, u64) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let id = station.submit(job).unwrap();
    station.start(anna, id).unwrap();
    (station, anna, id)
}

pub(crate) fn view(station: &VirtualStation) -> JobView {
    station.supervisor().job().unwrap()
}

pub(crate) fn is_paused(station: &VirtualStation, job: u64) -> bool {
    station
        .job(job)
        .unwrap()
        .state
        .to_string()
        .starts_with("paused")
}

pub(crate) fn wait_until_paused(station: &mut VirtualStation, job: u64) {
    // A job that was started a moment ago is so for the journal soon.
    station.run_for(Duration::from_millis(10));
    let minute = station.now() + Duration::from_secs(60);
    assert!(
        station.run_until(minute, |station| is_paused(station, job)),
        "{:?}",
        station.job(job).map(|j| j.state)
    );
}

pub(crate) fn finish(station: &mut VirtualStation, job: u64) {
    let minutes = station.now() + Duration::from_secs(600);
    assert!(
        station.run_until(minutes, |station| is_over(station, job)),
        "{:?}",
        station.supervisor().job()
    );
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
}

/// Runs the job until this many of its commands are over.
pub(crate) fn run_to(station: &mut VirtualStation, command: usize) {
    let minutes = station.now() + Duration::from_secs(600);
    let there = |station: &VirtualStation| {
        station
            .supervisor()
            .job()
            .is_some_and(|job| job.completed >= command)
    };
    assert!(
        station.run_until(minutes, there),
        "{:?}",
        station.supervisor().job()
    );
}

/// Returns the ink of the pen on the paper.
pub(crate) fn drawn(station: &VirtualStation) -> Vec<Stroke> {
    let mut strokes: Vec<Stroke> = Vec::new();
    let mut was_down = false;
    for at in station.arm().samples().iter().map(|sample| sample.position) {
        let is_down = at.z.0 <= DOWN_MM + 0.05;
        if is_down && !was_down {
            strokes.push(Stroke::default());
        }
        if is_down && let Some(stroke) = strokes.last_mut() {
            stroke.points.push(Point::new(at.x.0, at.y.0));
        }
        was_down = is_down;
    }
    strokes
}

pub(crate) fn length_mm(strokes: &[Stroke]) -> f64 {
    let step = |pair: &[Point]| (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y);
    let length = |stroke: &Stroke| stroke.points.windows(2).map(step).sum::<f64>();
    strokes.iter().map(length).sum()
}

/// The path was drawn, once, and nothing else.
pub(crate) fn assert_drawn_once(
    station: &VirtualStation,
    wanted: &[Stroke],
    allowed_mm: f64,
    what: &str,
) {
    let drawn = drawn(station);
    let Deviation { astray, missed } = deviation(wanted, &drawn);
    assert!(
        astray.distance_mm < allowed_mm && missed.distance_mm < allowed_mm,
        "{what}: {} mm astray, {} mm missed, {allowed_mm} mm are allowed",
        astray.distance_mm,
        missed.distance_mm
    );
    let (found_mm, wanted_mm) = (length_mm(&drawn), length_mm(wanted));
    assert!(
        (found_mm - wanted_mm).abs() < 0.01 * wanted_mm,
        "{what}: {found_mm} mm were drawn, wanted are {wanted_mm} mm"
    );
}

/// The largest change of speed within a tick while the pen is on the paper, in mm/s. Where an arm
/// stops dead that is all of its speed.
fn roughest_mm_s(samples: &[Sample]) -> f64 {
    let down = |at: Position| at.z.0 < DOWN_MM + 0.5;
    let speed_mm_s = |pair: &[Sample]| {
        let s = pair[1].at.saturating_sub(pair[0].at).as_secs_f64();
        pair[1].position.distance(pair[0].position).0 / s
    };
    samples
        .windows(3)
        .filter(|samples| samples.iter().all(|sample| down(sample.position)))
        .map(|samples| (speed_mm_s(&samples[1..]) - speed_mm_s(&samples[..2])).abs())
        .fold(0.0, f64::max)
}

/// As rough as an undisturbed drawing is.
fn usual_roughness_mm_s(personality: Personality) -> f64 {
    let (mut station, _, job) = started(personality, &pen_job(personality, &[(spiral(), None)]));
    finish(&mut station, job);
    roughest_mm_s(station.arm().samples())
}

fn assert_smooth(station: &VirtualStation, usual_mm_s: f64, what: &str) {
    let found_mm_s = roughest_mm_s(station.arm().samples());
    let allowed_mm_s = 1.5 * usual_mm_s + 2.0;
    assert!(
        found_mm_s < allowed_mm_s,
        "{what}: the speed jumps by {found_mm_s} mm/s, {allowed_mm_s} mm/s are allowed"
    );
}

#[test]
fn a_long_drawing_ends_at_its_place_despite_the_rounding_of_a_stock_arm() {
    let personality = Personality::Firmware11;
    let dash = |i: i32| {
        let (x, y) = (200.0 + f64::from(i % 40), f64::from(i / 40 % 40));
        Stroke::open(vec![Point::new(x, y), Point::new(x + 0.5, y)])
    };
    let dashes: Vec<Stroke> = (0..1600).map(dash).collect();
    let pass = Pass::new(DrawingTool::default(), dashes);
    let plan = Plan::new(&[pass], &Paper::level(DOWN_MM), &arm_limits(personality)).unwrap();
    let planned = NewJob {
        title: "dashes".into(),
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: 5.0,
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
    };
    let (mut station, _, job) = started(personality, &planned);
    let hours = station.now() + Duration::from_secs(7200);
    assert!(station.run_until(hours, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
}

#[test]
fn a_pause_in_a_stroke_brakes_lifts_and_resumes_from_rest() {
    for personality in PERSONALITIES {
        let usual_mm_s = usual_roughness_mm_s(personality);
        let planned = pen_job(personality, &[(spiral(), None)]);
        let (mut station, anna, job) = started(personality, &planned);
        for command in [20, 45, 46, 90] {
            run_to(&mut station, command);
            station.ask(anna, Request::PauseJob).unwrap();
            wait_until_paused(&mut station, job);
            let z_mm = station.arm().samples().last().unwrap().position.z.0;
            assert!(
                (z_mm - DOWN_MM - 5.0).abs() < 0.1,
                "{personality}: {z_mm} mm"
            );
            station.start(anna, job).unwrap();
        }
        finish(&mut station, job);
        let what = personality.to_string();
        assert_smooth(&station, usual_mm_s, &what);
        assert_drawn_once(&station, &[spiral()], 0.1, &what);
    }
}

#[test]
fn a_pen_does_not_rest_on_the_paper_when_a_job_is_paused() {
    for personality in PERSONALITIES {
        let planned = pen_job(personality, &[(spiral(), None)]);
        let (mut station, anna, job) = started(personality, &planned);
        run_to(&mut station, 45);
        station.ask(anna, Request::PauseJob).unwrap();
        wait_until_paused(&mut station, job);
        station.run_for(Duration::from_secs(3));
        station.start(anna, job).unwrap();
        finish(&mut station, job);
        let longest_s = longest_stand_s(station.arm().samples());
        assert!(longest_s < 0.2, "{personality}: {longest_s} s");
    }
}

/// Returns the longest time that the pen rested in one place on the paper, in seconds.
fn longest_stand_s(samples: &[Sample]) -> f64 {
    let mut longest_s: f64 = 0.0;
    let mut since = samples[0];
    for sample in samples {
        let is_there = sample.position.distance(since.position).0 < 0.05;
        if !is_there || sample.position.z.0 > DOWN_MM + 0.05 {
            since = *sample;
        }
        longest_s = longest_s.max(sample.at.saturating_sub(since.at).as_secs_f64());
    }
    longest_s
}

#[test]
fn a_job_at_half_the_speed_takes_twice_as_long_and_draws_the_same() {
    for personality in PERSONALITIES {
        let line = Stroke::open(vec![Point::new(200.0, -90.0), Point::new(200.0, 90.0)]);
        let took_s = |percent: f64| {
            let planned = pen_job(personality, &[(line.clone(), None)]);
            let (mut station, anna, job) = started(personality, &planned);
            station.ask(anna, Request::SetJobSpeed { percent }).unwrap();
            assert_eq!(view(&station).speed_percent, percent);
            finish(&mut station, job);
            assert_drawn_once(
                &station,
                std::slice::from_ref(&line),
                0.1,
                &personality.to_string(),
            );
            drawing_s(station.arm().samples())
        };
        let planned_s = took_s(100.0);
        for (percent, least, most) in [(50.0, 1.85, 2.05), (10.0, 8.5, 10.2), (200.0, 0.4, 0.85)] {
            let share = took_s(percent) / planned_s;
            assert!(
                (least..most).contains(&share),
                "{personality}: at {percent} % it takes {share} times as long"
            );
        }
    }
}

/// Returns how long the pen is on the paper, in seconds.
fn drawing_s(samples: &[Sample]) -> f64 {
    let down = |samples: &&[Sample]| {
        samples
            .iter()
            .all(|sample| sample.position.z.0 < DOWN_MM + 0.02)
    };
    let takes_s = |sample: &[Sample]| sample[1].at.saturating_sub(sample[0].at).as_secs_f64();
    samples.windows(2).filter(down).map(takes_s).sum()
}

#[test]
fn a_speed_change_in_a_stroke_is_smooth_and_draws_the_same() {
    for personality in PERSONALITIES {
        let usual_mm_s = usual_roughness_mm_s(personality);
        let planned = pen_job(personality, &[(spiral(), None)]);
        let (mut station, anna, job) = started(personality, &planned);
        for (command, percent) in [
            (20, 150.0),
            (40, 30.0),
            (60, 200.0),
            (100, 10.0),
            (110, 100.0),
        ] {
            run_to(&mut station, command);
            station.ask(anna, Request::SetJobSpeed { percent }).unwrap();
        }
        finish(&mut station, job);
        let what = personality.to_string();
        assert_smooth(&station, usual_mm_s, &what);
        assert_drawn_once(&station, &[spiral()], 0.1, &what);
    }
}

#[test]
fn a_drawing_killed_lowered_and_paused_in_its_strokes_stays_on_its_lines() {
    for personality in PERSONALITIES {
        let passes = [(spiral(), None), (spiral(), None)];
        let (mut station, _, job) = started(personality, &pen_job(personality, &passes));
        for command in [30, 70, 110, 160, 230] {
            run_to(&mut station, command);
            station.crash(Duration::from_millis(300)).unwrap();
            let anna = station.client("Anna");
            station.ask(anna, Request::TakeLease).unwrap();
            wait_until_paused(&mut station, job);
            station.run_for(Duration::from_secs(3));
            station.ask(anna, Request::ConfirmPose).unwrap();
            station.start(anna, job).unwrap();
            run_to(&mut station, command + 15);
            let offset_mm = -0.001 * f64::from(u16::try_from(command).unwrap());
            station
                .ask(anna, Request::SetJobHeight { offset_mm })
                .unwrap();
            station.ask(anna, Request::PauseJob).unwrap();
            wait_until_paused(&mut station, job);
            station.start(anna, job).unwrap();
        }
        finish(&mut station, job);
        let what = personality.to_string();
        let Deviation { astray, missed } = deviation(&[spiral()], &drawn(&station));
        let off_mm = astray.distance_mm.max(missed.distance_mm);
        assert!(off_mm < 0.1, "{what}: {off_mm} mm off");
        let (found_mm, wanted_mm) = (length_mm(&drawn(&station)), 2.0 * length_mm(&[spiral()]));
        assert!(
            (found_mm - wanted_mm).abs() < 0.01 * wanted_mm,
            "{what}: {found_mm} mm were drawn, wanted are {wanted_mm} mm"
        );
    }
}

#[test]
fn a_job_after_another_one_is_drawn_at_its_place() {
    for personality in PERSONALITIES {
        let planned = pen_job(personality, &[(spiral(), None)]);
        let (mut station, anna, job) = started(personality, &planned);
        run_to(&mut station, 60);
        station.ask(anna, Request::CancelJob { job }).unwrap();
        station.run_for(Duration::from_secs(5));
        let next = station.submit(&planned).unwrap();
        station.start(anna, next).unwrap();
        finish(&mut station, next);
        let Deviation { astray, missed } = deviation(&[spiral()], &drawn(&station));
        let off_mm = astray.distance_mm.max(missed.distance_mm);
        assert!(off_mm < 0.1, "{personality}: {off_mm} mm off");
    }
}

#[test]
fn a_set_speed_applies_to_the_job_and_not_to_the_next() {
    let personality = Personality::Firmware11;
    let planned = pen_job(personality, &[(spiral(), None)]);
    let (mut station, anna, job) = started(personality, &planned);
    run_to(&mut station, 30);
    station
        .ask(anna, Request::SetJobSpeed { percent: 60.0 })
        .unwrap();
    station.ask(anna, Request::PauseJob).unwrap();
    wait_until_paused(&mut station, job);
    assert_eq!(station.job(job).unwrap().adjustment.speed_percent, 60.0);
    station.start(anna, job).unwrap();
    assert_eq!(view(&station).speed_percent, 60.0);
    finish(&mut station, job);
    let next = station.submit(&planned).unwrap();
    station.start(anna, next).unwrap();
    assert_eq!(view(&station).speed_percent, 100.0);
}

#[test]
fn a_finished_job_reports_its_duration_without_pauses() {
    for personality in PERSONALITIES {
        let planned = pen_job(personality, &[(spiral(), None)]);
        let took_s = |pauses: bool| {
            let (mut station, anna, job) = started(personality, &planned);
            if pauses {
                run_to(&mut station, 50);
                station.ask(anna, Request::PauseJob).unwrap();
                wait_until_paused(&mut station, job);
                station.run_for(Duration::from_secs(100));
                station.start(anna, job).unwrap();
            }
            finish(&mut station, job);
            let job = station.job(job).unwrap();
            (job.history.ran_s.unwrap(), job.planned_s.unwrap())
        };
        let (took, planned_s) = took_s(false);
        assert!(
            (took / planned_s - 1.0).abs() < 0.1,
            "{took} s, planned {planned_s} s"
        );
        let (with_pause, _) = took_s(true);
        assert!((with_pause - took).abs() < 2.5, "{with_pause} s, {took} s");
    }
}
