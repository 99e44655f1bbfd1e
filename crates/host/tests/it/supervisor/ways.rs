//! Previews of the path of a command before it is sent.

use std::time::Duration;

use dobot_api::{BoundedQuantity, ClientId, NearLimit, PathPreview, Reply, Request};
use dobot_controller::Personality;
use dobot_geometry::{Point, Stroke};
use dobot_host::VirtualStation;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, MoveTo, MovingMode};

use super::releases::over;
use super::strokes::{PERSONALITIES, pen_job, started, view};

fn asked(
    station: &mut VirtualStation,
    client: ClientId,
    command: Command,
) -> Result<PathPreview, Refusal> {
    match station.ask(client, Request::CheckCommand { command })? {
        Reply::Way { way } => Ok(way),
        other => panic!("{other:?}"),
    }
}

fn line(x_mm: f32, y_mm: f32, z_mm: f32) -> Command {
    MoveTo {
        mode: MovingMode::MovL,
        ..MoveTo::to(x_mm, y_mm, z_mm)
    }
    .into()
}

fn station(personality: Personality) -> (VirtualStation, ClientId) {
    let (mut station, anna) = over(personality, 0);
    station.ask(anna, Request::ReleaseLease).unwrap();
    (station, anna)
}

#[test]
fn the_reported_path_is_the_path_of_the_arm() {
    for personality in PERSONALITIES {
        let (mut station, anna) = station(personality);
        let there = line(210.0, -40.0, 60.0);
        let way = asked(&mut station, anna, there).unwrap();
        station.ask(anna, Request::TakeLease).unwrap();
        station
            .ask(anna, Request::Command { command: there })
            .unwrap();
        let until = station.now() + Duration::from_secs(20);
        while station.now() < until {
            station.run_for(Duration::from_millis(80));
            let at = place(&station);
            let distance_mm = way
                .path_mm
                .windows(2)
                .map(|part| off_mm(at, part[0], part[1]));
            let distance_mm = distance_mm.fold(f64::MAX, f64::min);
            assert!(
                distance_mm < 0.1,
                "{personality}: {at:?} is {distance_mm} mm off the way"
            );
        }
        let end = station.supervisor().state().arm.unwrap().status;
        let reported = [end.base_deg, end.rear_deg, end.fore_deg, end.servo_deg].map(f64::from);
        for (foreseen, reported) in way.joints_deg.iter().zip(reported) {
            assert!(
                (foreseen - reported).abs() < 0.01,
                "{personality}: {way:?}, {end:?}"
            );
        }
    }
}

fn place(station: &VirtualStation) -> [f64; 3] {
    let status = station.supervisor().state().arm.unwrap().status;
    [status.x_mm, status.y_mm, status.z_mm].map(f64::from)
}

/// Returns the distance from a point to the straight line between two others.
fn off_mm(at: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
    let times = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (way, here) = (minus(to, from), minus(at, from));
    let share = (times(here, way) / times(way, way)).clamp(0.0, 1.0);
    let off = minus(here, way.map(|mm| mm * share));
    times(off, off).sqrt()
}

#[test]
fn a_path_query_sends_nothing_needs_no_control_and_reports_nothing() {
    for personality in PERSONALITIES {
        let (mut station, anna) = station(personality);
        let (packets, notices) = (station.packets().len(), station.notices().len());
        asked(&mut station, anna, line(210.0, 0.0, 60.0)).unwrap();
        asked(&mut station, anna, line(400.0, 0.0, 60.0)).unwrap_err();
        station.run_for(Duration::from_secs(1));
        assert_eq!(
            (station.packets().len(), station.notices().len()),
            (packets, notices)
        );
    }
}

#[test]
fn nearby_limits_are_reported_before_the_arm_moves_and_in_its_state_after_it() {
    for personality in PERSONALITIES {
        let (mut station, anna) = station(personality);
        assert!(station.supervisor().state().arm.unwrap().near.is_empty());
        let near_at = |x_mm: f64, z_mm: f64| Request::Near {
            x_mm,
            y_mm: 0.0,
            z_mm,
            rotation_deg: 0.0,
        };
        let Ok(Reply::Near { near }) = station.ask(anna, near_at(220.0, 126.0)) else {
            panic!("it is within reach");
        };
        let height = NearLimit {
            quantity: BoundedQuantity::Z,
            bound: 136.0,
            closeness: 0.5,
        };
        assert!(near.limits.contains(&height), "{near:?}");
        station.ask(anna, Request::TakeLease).unwrap();
        let command = line(220.0, 0.0, 126.0);
        station.ask(anna, Request::Command { command }).unwrap();
        station.run_for(Duration::from_secs(20));
        // An arm is at most one motor step away from there.
        let there = station.supervisor().state().arm.unwrap().near;
        assert_eq!(there.limits.len(), near.limits.len(), "{there:?}");
        for (reported, foreseen) in there.limits.iter().zip(&near.limits) {
            assert_eq!(
                (reported.quantity, reported.bound),
                (foreseen.quantity, foreseen.bound)
            );
            let off = (reported.closeness - foreseen.closeness).abs();
            assert!(off < 0.025, "{there:?}, {near:?}");
        }
        // Beyond the limit the closeness is 1, and where no arm can be there is no answer.
        let Ok(Reply::Near { near }) = station.ask(anna, near_at(220.0, 140.0)) else {
            panic!("the links span it");
        };
        let beyond = NearLimit {
            closeness: 1.0,
            ..height
        };
        assert!(near.limits.contains(&beyond), "{near:?}");
        for (x_mm, z_mm) in [(900.0, 0.0), (f64::NAN, 0.0)] {
            let refused = station.ask(anna, near_at(x_mm, z_mm));
            assert!(matches!(refused, Err(Refusal::Policy(_))), "{refused:?}");
        }
    }
}

#[test]
fn a_place_beyond_reach_is_refused_with_the_last_allowed_one() {
    for personality in PERSONALITIES {
        let (mut station, anna) = station(personality);
        let Err(Refusal::Policy(violation)) = asked(&mut station, anna, line(500.0, 0.0, 60.0))
        else {
            panic!("it is beyond reach");
        };
        let nearest = violation
            .nearest
            .expect("the way begins where the arm may be");
        let reach_mm = nearest[0].hypot(nearest[1]).hypot(nearest[2]);
        assert!(reach_mm > 250.0, "{nearest:?}");
        let [x, y, z] = nearest.map(|mm| mm.to_string().parse().unwrap());
        asked(&mut station, anna, line(x, y, z)).unwrap();
    }
}

#[test]
fn the_marked_path_of_a_job_is_the_line_of_its_pen() {
    for personality in PERSONALITIES {
        let strokes = [
            [(200.0, -30.0), (240.0, -30.0)],
            [(230.0, 20.0), (200.0, 20.0)],
        ]
        .map(|ends| Stroke::open(ends.map(|(x, y)| Point::new(x, y)).to_vec()));
        let planned = pen_job(personality, &strokes.clone().map(|stroke| (stroke, None)));
        let (station, _, job) = started(personality, &planned);
        let path = station.job_path(job).unwrap();
        let marked: f64 = (1..path.path_mm.len())
            .filter(|index| path.marks[*index])
            .map(|index| {
                let [from, to] = [path.path_mm[index - 1], path.path_mm[index]];
                assert!(strokes.iter().any(|stroke| {
                    let ends =
                        [stroke.points[0], stroke.points[1]].map(|point| [point.x, point.y, to[2]]);
                    off_mm(from, ends[0], ends[1]) < 0.05 && off_mm(to, ends[0], ends[1]) < 0.05
                }));
                (from[0] - to[0]).hypot(from[1] - to[1])
            })
            .sum();
        assert!((marked - 70.0).abs() < 0.1, "{personality}: {marked} mm");
        assert_eq!(path.commands.last(), Some(&(planned.commands.len() - 1)));
        let planned_s = view(&station).planned_s.unwrap();
        let until_s = *path.until_s.last().unwrap();
        assert!(
            (until_s - planned_s).abs() < 0.01 * planned_s,
            "{until_s} s, {planned_s} s"
        );
    }
}
