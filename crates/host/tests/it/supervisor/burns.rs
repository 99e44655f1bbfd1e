//! Laser drawings: the burned lines, and nothing burned while a job is paused.

use std::time::Duration;

use dobot_api::{ClientId, JobKind, NewJob, News, Request};
use dobot_controller::Personality;
use dobot_geometry::{Point, Stroke, deviation};
use dobot_host::VirtualStation;
use dobot_plan::{DrawingTool, Laser, Paper, Pass, Plan};

use super::drawing::virtual_station;
use super::strokes::{DOWN_MM, arm_limits, finish, length_mm, run_to, wait_until_paused};
use crate::cases::light::longest_stand_s;

const LINES: [f64; 3] = [-10.0, 0.0, 10.0];

/// Three lines with corners in them.
fn wanted() -> Vec<Stroke> {
    let line = |y: f64| {
        let points = (0..=20).map(|step| {
            let x = f64::from(step) * 2.0;
            Point::new(200.0 + x, y + 1.5 * (x / 6.0).sin())
        });
        Stroke::open(points.collect())
    };
    LINES.map(line).to_vec()
}

fn laser_job(personality: Personality) -> NewJob {
    let pass = Pass::new(DrawingTool::Laser(Laser::default()), wanted());
    let plan = Plan::new(&[pass], &Paper::level(DOWN_MM), &arm_limits(personality)).unwrap();
    NewJob {
        title: "three lines".into(),
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
    }
}

pub(crate) fn armed(personality: Personality) -> (VirtualStation, ClientId, u64) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&laser_job(personality)).unwrap();
    let refused = station.start(anna, job).unwrap_err();
    assert_eq!(refused.kind(), "laser-disarmed");
    station
        .ask(anna, Request::ArmLaser { for_s: 600.0 })
        .unwrap();
    station.start(anna, job).unwrap();
    (station, anna, job)
}

/// What was burned.
fn burned(station: &VirtualStation) -> Vec<Stroke> {
    let samples = station.arm().samples();
    let mut strokes: Vec<Stroke> = Vec::new();
    let mut burns = false;
    for pair in samples.windows(2) {
        let [from, to] = [pair[0].position, pair[1].position]
            .map(|position| Point::new(position.x.0, position.y.0));
        if pair[1].laser && !burns {
            strokes.push(Stroke::open(vec![from]));
        }
        if let Some(stroke) = strokes.last_mut().filter(|_| pair[1].laser) {
            stroke.points.push(to);
        }
        burns = pair[1].laser;
    }
    strokes
}

fn assert_burned_once(station: &VirtualStation, what: &str) {
    let (wanted, burned) = (wanted(), burned(station));
    let off_mm = deviation(&wanted, &burned).largest_mm();
    // A tick at 10 mm/s is 0.2 mm: so exactly can a laser be switched.
    assert!(off_mm < 0.45, "{what}: {off_mm} mm off");
    let (found_mm, wanted_mm) = (length_mm(&burned), length_mm(&wanted));
    assert!(
        (found_mm - wanted_mm).abs() < 0.03 * wanted_mm,
        "{what}: {found_mm} mm were burned, wanted are {wanted_mm} mm"
    );
}

#[test]
fn a_laser_drawing_is_burned_once_and_its_travels_are_not() {
    for personality in Personality::ALL {
        let (mut station, _, job) = armed(personality);
        finish(&mut station, job);
        assert_burned_once(&station, &personality.to_string());
        // Nothing came between two of its vectors that switches the laser off.
        let off = station
            .notices()
            .iter()
            .any(|notice| notice.news == News::LaserOff);
        assert!(!off, "{personality}");
    }
}

#[test]
fn a_laser_drawing_that_is_paused_in_its_lines_burns_no_hole_and_nothing_twice() {
    for personality in Personality::ALL {
        let (mut station, anna, job) = armed(personality);
        for command in [12, 20, 40] {
            run_to(&mut station, command);
            station.ask(anna, Request::PauseJob).unwrap();
            wait_until_paused(&mut station, job);
            assert!(!station.arm().controller().outputs().laser, "{personality}");
            station.run_for(Duration::from_secs(5));
            station.start(anna, job).unwrap();
        }
        finish(&mut station, job);
        assert_burned_once(&station, &personality.to_string());
        let hole_s = longest_stand_s(station.arm().samples(), 0.005);
        assert!(hole_s < 0.3, "{personality}: {hole_s} s");
    }
}

#[test]
fn a_laser_drawing_accepts_a_new_speed_and_keeps_its_height_while_burning() {
    for personality in Personality::ALL {
        let (mut station, anna, job) = armed(personality);
        run_to(&mut station, 10);
        station
            .ask(anna, Request::SetJobSpeed { percent: 60.0 })
            .unwrap();
        run_to(&mut station, 14);
        station
            .ask(anna, Request::SetJobHeight { offset_mm: 0.5 })
            .unwrap();
        finish(&mut station, job);
        assert_burned_once(&station, &personality.to_string());
        let heights = station
            .arm()
            .samples()
            .windows(2)
            .filter(|pair| pair[1].laser);
        let steepest_mm = heights
            .map(|pair| (pair[1].position.z.0 - pair[0].position.z.0).abs())
            .fold(0.0, f64::max);
        assert!(steepest_mm < 0.01, "{personality}: {steepest_mm} mm");
        let last_mm = station.arm().samples().last().unwrap().position.z.0;
        assert!(
            (last_mm - DOWN_MM - 0.5).abs() < 0.05,
            "{personality}: {last_mm} mm"
        );
    }
}
