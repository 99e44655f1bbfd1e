//! Jobs that are drawn higher or lower than planned.

use std::time::Duration;

use dobot_api::{ClientId, JobKind, NewJob, Request};
use dobot_controller::Personality;
use dobot_geometry::Stroke;
use dobot_host::VirtualStation;
use dobot_wire::{Command, Packet};
use proptest::prelude::*;

use super::drawing;
use super::strokes::{
    DOWN_MM, PERSONALITIES, assert_drawn_once, finish, is_paused, pen_job, pen_job_at, run_to,
    spiral, started, view, wait_until_paused,
};

/// Returns the highest and lowest height above the plan of the pen on the paper in the last
/// moments.
fn heights_mm(station: &VirtualStation, from: Duration) -> (f64, f64) {
    let samples = station
        .arm()
        .samples()
        .iter()
        .filter(|sample| sample.at >= from);
    let heights = samples.map(|sample| sample.position.z.0 - DOWN_MM);
    let drawing = heights.filter(|height| *height < 2.0);
    drawing.fold((f64::MAX, f64::MIN), |(low, high), height| {
        (low.min(height), high.max(height))
    })
}

fn set(station: &mut VirtualStation, anna: ClientId, offset_mm: f64) {
    station
        .ask(anna, Request::SetJobHeight { offset_mm })
        .unwrap();
}

#[test]
fn a_new_height_is_reached_smoothly_and_stays() {
    for personality in PERSONALITIES {
        let planned = pen_job(personality, &[(spiral(), None)]);
        let (mut station, anna, job) = started(personality, &planned);
        run_to(&mut station, 30);
        set(&mut station, anna, 0.4);
        assert_eq!(view(&station).height_mm, 0.4);
        run_to(&mut station, 70);
        let since = station.now();
        run_to(&mut station, 100);
        let (low, high) = heights_mm(&station, since);
        assert!(
            (low - 0.4).abs() < 0.05 && (high - 0.4).abs() < 0.05,
            "{low} {high}"
        );
        finish(&mut station, job);
        let steepest = station
            .arm()
            .samples()
            .windows(2)
            .map(|pair| [pair[0].position, pair[1].position])
            .filter(|ends| ends.iter().all(|at| (at.z.0 - DOWN_MM).abs() < 0.39))
            .map(|[a, b]| [(b.x.0 - a.x.0).hypot(b.y.0 - a.y.0), (b.z.0 - a.z.0).abs()])
            .filter(|[aside, _]| *aside > 0.1)
            .map(|[aside, up]| up / aside)
            .fold(0.0, f64::max);
        assert!(steepest < 0.08, "{personality}: {steepest}");
    }
}

#[test]
fn a_new_height_set_during_a_pause_applies_from_there_on() {
    for personality in PERSONALITIES {
        for offset_mm in [0.2, -0.3, 1.5] {
            let planned = pen_job(personality, &[(spiral(), None)]);
            let (mut station, anna, job) = started(personality, &planned);
            run_to(&mut station, 50);
            station.ask(anna, Request::PauseJob).unwrap();
            wait_until_paused(&mut station, job);
            set(&mut station, anna, offset_mm);
            station.run_for(Duration::from_secs(1));
            station.start(anna, job).unwrap();
            run_to(&mut station, 70);
            let since = station.now();
            run_to(&mut station, 100);
            let (low, high) = heights_mm(&station, since);
            assert!(
                (low - offset_mm).abs() < 0.05 && (high - offset_mm).abs() < 0.05,
                "{personality}: {low} to {high} mm, wanted {offset_mm} mm"
            );
            finish(&mut station, job);
        }
    }
}

#[test]
fn a_value_out_of_range_is_refused_with_the_allowed_range() {
    let personality = Personality::Firmware11;
    let (mut station, anna, _) = started(personality, &pen_job(personality, &[(spiral(), None)]));
    run_to(&mut station, 20);
    for percent in [9.9, 200.1, -1.0, f64::NAN, f64::INFINITY] {
        let refused = station
            .ask(anna, Request::SetJobSpeed { percent })
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            format!("percent is {percent}; allowed is 10 to 200 %")
        );
    }
    for offset_mm in [5.1, -5.1, f64::NAN] {
        let refused = station.ask(anna, Request::SetJobHeight { offset_mm });
        assert_eq!(
            refused.unwrap_err().to_string(),
            format!("offset_mm is {offset_mm}; allowed is -5 to 5 mm")
        );
    }
    let bert = station.client("Bert");
    let refused = station.ask(bert, Request::SetJobSpeed { percent: 50.0 });
    assert_eq!(refused.unwrap_err().kind(), "no-lease");
}

#[test]
fn a_job_of_targets_keeps_its_speed_and_height() {
    let mut station = drawing::virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let refused = station.ask(anna, Request::SetJobSpeed { percent: 50.0 });
    assert_eq!(refused.unwrap_err().kind(), "no-job-runs");
    let target = drawing::spiral(1).commands[2];
    let program = NewJob {
        kind: JobKind::Program,
        commands: vec![target],
        lift_mm: 0.0,
        ..drawing::spiral(1)
    };
    let job = station.submit(&program).unwrap();
    station.start(anna, job).unwrap();
    let refused = station.ask(anna, Request::SetJobHeight { offset_mm: 1.0 });
    assert_eq!(refused.unwrap_err().kind(), "no-vectors");
}

#[test]
fn a_height_below_the_table_is_refused_at_once_and_the_job_continues() {
    let personality = Personality::Firmware11;
    let mut planned = pen_job(personality, &[(spiral(), None)]);
    for command in &mut planned.commands {
        if let Command::MoveTo(target) = command {
            target.z_mm -= 31.0;
        }
    }
    let (mut station, anna, job) = started(personality, &planned);
    run_to(&mut station, 30);
    let low = Request::SetJobHeight { offset_mm: -4.0 };
    let refused = station.ask(anna, low.clone()).unwrap_err();
    assert_eq!(refused.kind(), "policy", "{refused}");
    assert!(refused.to_string().contains("table allows"), "{refused}");
    assert_eq!(view(&station).height_mm, 0.0);
    set(&mut station, anna, -1.0);
    run_to(&mut station, 50);
    station.ask(anna, Request::PauseJob).unwrap();
    wait_until_paused(&mut station, job);
    assert_eq!(station.ask(anna, low).unwrap_err().kind(), "policy");
    station.run_for(Duration::from_secs(1));
    station.start(anna, job).unwrap();
    finish(&mut station, job);
    assert_eq!(
        station
            .job(job)
            .unwrap()
            .adjustment
            .heights
            .last()
            .unwrap()
            .offset_mm,
        -1.0
    );
}

/// Draws during any actions of a person, and is killed in between.
fn draw_and_kill(personality: Personality, steps: &[(u64, f64, f64, bool)]) {
    let planned = pen_job(personality, &[(spiral(), None)]);
    let (mut station, mut anna, job) = started(personality, &planned);
    for &(ms, percent, offset_mm, pauses) in steps {
        station.run_for(Duration::from_millis(ms));
        // If it is done or coming to rest already, that is refused.
        let _ = station.ask(anna, Request::SetJobSpeed { percent });
        let _ = station.ask(anna, Request::SetJobHeight { offset_mm });
        station.run_for(Duration::from_millis(ms / 3));
        if pauses {
            let _ = station.ask(anna, Request::PauseJob);
            station.run_for(Duration::from_millis(ms / 3));
        }
        if station.job(job).unwrap().state.is_over() {
            break;
        }
        station.crash(Duration::from_millis(400)).unwrap();
        let minute = station.now() + Duration::from_secs(120);
        let rests =
            |station: &VirtualStation| station.supervisor().is_at_rest() && is_paused(station, job);
        assert!(station.run_until(minute, rests), "{:?}", station.job(job));
        anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        station.ask(anna, Request::ConfirmPose).unwrap();
        station.start(anna, job).unwrap();
    }
    finish(&mut station, job);
    assert_sent_once(&station, personality, &planned);
}

#[test]
fn a_height_applies_until_the_journal_is_past_it() {
    // The second crash comes before the journal has recorded how far the job got after the first: the
    // place is looked for from before the first change of height, and the arm rests below the plan.
    draw_and_kill(
        Personality::Firmware11,
        &[
            (306, 104.63, -0.8435, false),
            (1500, 59.794, 0.0, false),
            (300, 10.0, 0.0, false),
        ],
    );
}

#[test]
fn the_slowest_drawing_is_resumed_after_a_crash() {
    // 6 mm/s at 10 %: less than a stock arm gains in a tick.
    for personality in PERSONALITIES {
        let stroke = Stroke::open(spiral().points[..24].to_vec());
        let planned = pen_job_at(6.0, personality, &[(stroke.clone(), None)]);
        let (mut station, anna, job) = started(personality, &planned);
        station
            .ask(anna, Request::SetJobSpeed { percent: 10.0 })
            .unwrap();
        run_to(&mut station, 8);
        station.crash(Duration::from_millis(400)).unwrap();
        let minute = station.now() + Duration::from_secs(60);
        let rests =
            |station: &VirtualStation| station.supervisor().is_at_rest() && is_paused(station, job);
        assert!(station.run_until(minute, rests), "{:?}", station.job(job));
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        station.ask(anna, Request::ConfirmPose).unwrap();
        station.start(anna, job).unwrap();
        finish(&mut station, job);
        assert_drawn_once(&station, &[stroke], 0.05, &personality.to_string());
    }
}

/// At any height, each drawing vector was sent once, in order.
fn assert_sent_once(station: &VirtualStation, personality: Personality, planned: &NewJob) {
    let drawing = |command: Command| match command {
        // The rounding error of a lift draws nothing.
        Command::WriteVector(vector) if vector.x_mm.hypot(vector.y_mm) > 0.001 => {
            Some([vector.x_mm, vector.y_mm])
        }
        _ => None,
    };
    let read = |bytes: &[u8; 42]| {
        let packet = Packet::from_bytes(bytes).unwrap();
        Command::parse(&packet, &personality.dialect()).unwrap()
    };
    let sent = station.packets().iter().map(|(_, bytes)| read(bytes));
    let sent: Vec<_> = sent.filter_map(drawing).collect();
    let wanted: Vec<_> = planned
        .commands
        .iter()
        .copied()
        .filter_map(drawing)
        .collect();
    assert_eq!(sent, wanted);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_killed_station_finds_its_place_at_any_speed_and_height(
        steps in prop::collection::vec(
            (300_u64..6_000, 10.0..200.0_f64, -0.9..0.9_f64, any::<bool>()),
            1..4,
        ),
        twin in any::<bool>(),
    ) {
        draw_and_kill(PERSONALITIES[usize::from(twin)], &steps);
    }
}

#[test]
fn a_drawing_paused_while_it_slows_down_comes_to_rest_soon() {
    // The last vector before the rest would have begun at 0.004 mm/s, and continued like that for
    // 400 s.
    let slower = (2486, 15.419_662_467_478_036, 0.0, true);
    draw_and_kill(Personality::Firmware11, &[slower]);
}
