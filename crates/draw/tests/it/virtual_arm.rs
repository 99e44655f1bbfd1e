//! Tests of plans on virtual arms of both personalities: planned time, path, and laser switching.

use std::f64::consts::TAU;
use std::time::Duration;

use dobot_arm::{Position, TICK};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_draw::{Settings, prepare};
use dobot_geometry::{Point, Stroke, Vec2, deviation};
use dobot_import::{Font, Source, StrokeFont, Text};
use dobot_plan::{
    ArmLimits, DrawingTool, Laser, MoveKind, Paper, Pass, Plan, RespeedStart, respeed,
};
use dobot_wire::{Command, WriteVector};

/// The state of the arm after a tick: its position, and whether it burned.
#[derive(Clone, Copy, PartialEq)]
struct Seen {
    place: [f64; 3],
    laser: bool,
}

/// Sends one command per status, each taking its time on the line at 9600 baud, and samples the arm
/// after each tick until it rests, from `start`.
fn drive(commands: &[Command], personality: Personality, start: [f64; 3]) -> Vec<Seen> {
    let mut arm = Controller::power_up(PowerUp::new(personality));
    let (mut now, mut sent, mut rests) = (Duration::ZERO, 0, 0);
    let mut on_the_line: Vec<(Duration, usize)> = Vec::new();
    let mut seen: Vec<Seen> = Vec::new();
    while sent < commands.len() || !on_the_line.is_empty() || rests < 50 {
        now += TICK;
        on_the_line.retain(|&(at, i)| {
            if at <= now {
                arm.handle_bytes(at, &commands[i].emit(&personality.dialect()).to_bytes());
            }
            at > now
        });
        arm.handle_time(now);
        while arm.poll_bytes().is_some() {
            if sent < commands.len() {
                on_the_line.push((now + STATUS_AND_PACKET, sent));
                sent += 1;
            }
        }
        let p = arm.pose_at(now).position;
        let next = Seen {
            place: [p.x.0, p.y.0, p.z.0],
            laser: arm.laser(),
        };
        rests = if seen.last() == Some(&next) {
            rests + 1
        } else {
            0
        };
        seen.push(next);
    }
    assert_eq!(arm.poll_refused(), None);
    let away = |sample: &Seen| distance(sample.place, start);
    let arrived = seen.iter().position(|sample| away(sample) < 0.3);
    let arrived = arrived.expect("it goes to the start");
    let nearest = (arrived..arrived + 12).rev();
    let nearest = nearest.min_by(|&a, &b| away(&seen[a]).total_cmp(&away(&seen[b])));
    seen.split_off(nearest.expect("a dozen"))
}

/// Returns the number of moving ticks.
fn moving(seen: &[Seen]) -> f64 {
    let last = seen[seen.len() - 1].place;
    let ends = seen.iter().rposition(|sample| sample.place != last);
    let ticks = u32::try_from(ends.expect("it moves") + 1);
    f64::from(ticks.expect("a few minutes"))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Returns the paths in which `which` held, seen from above.
fn ways(seen: &[Seen], which: impl Fn(&Seen) -> bool) -> Vec<Stroke> {
    let mut ways: Vec<Stroke> = Vec::new();
    let mut continues = false;
    for pair in seen.windows(2) {
        let [from, to] =
            [pair[0], pair[1]].map(|sample| Point::new(sample.place[0], sample.place[1]));
        match ways.last_mut().filter(|_| continues) {
            _ if !which(&pair[0]) => {}
            Some(way) => way.points.push(to),
            None => ways.push(Stroke::open(vec![from, to])),
        }
        continues = which(&pair[0]);
    }
    ways
}

fn plan(tool: DrawingTool, strokes: Vec<Stroke>, personality: Personality) -> Plan {
    let arm_limits = ArmLimits::of(personality.dialect());
    Plan::new(
        &[Pass::new(tool, strokes)],
        &Paper::level(-40.0),
        &arm_limits,
    )
    .expect("a plan")
}

fn line(points: &[(f64, f64)]) -> Stroke {
    Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
}

/// A spiral of short vectors, a zigzag, a long line with a short vector in it, a dot.
fn strokes() -> Vec<Stroke> {
    let spiral = (0..200_u32).map(|i| {
        let (sin, cos) = (TAU * f64::from(i) / 40.0).sin_cos();
        Point::new(210.0, 0.0) + Vec2::new(cos, sin) * (2.0 + 0.1 * f64::from(i))
    });
    let zigzag = (0..30_u32).map(|i| (180.0 + 1.5 * f64::from(i), 30.0 + 4.0 * f64::from(i % 2)));
    vec![
        Stroke::open(spiral.collect()),
        line(&zigzag.collect::<Vec<_>>()),
        line(&[
            (160.0, -50.0),
            (210.0, -50.0),
            (210.2, -50.1),
            (260.0, -50.1),
            (160.0, -50.0),
        ]),
        line(&[(200.0, 60.0)]),
    ]
}

#[test]
fn the_estimate_is_the_duration_on_the_arm_and_the_pen_stays_on_the_path() {
    for personality in Personality::ALL {
        let plan = plan(DrawingTool::default(), strokes(), personality);
        let seen = drive(
            &plan.commands().collect::<Vec<_>>(),
            personality,
            plan.start,
        );
        let took_s = TICK.as_secs_f64() * moving(&seen);
        // The motions alone: here no station waits for their ends.
        let motions_s = plan.moves.iter().map(|vector| f64::from(vector.duration_s));
        let planned_s: f64 = motions_s.sum();
        assert!(
            (took_s - planned_s).abs() < 0.041,
            "{personality:?}: {took_s} s, planned {planned_s} s"
        );
        let drawn = ways(&seen, |sample| sample.place[2] < -39.999);
        let found = deviation(&strokes(), &drawn);
        // Between two samples a corner is cut.
        assert!(
            found.astray.distance_mm < 0.05,
            "{personality:?}: {found:?}"
        );
        let end = plan.positions().last().expect("vectors");
        let off_mm = distance(seen[seen.len() - 1].place, end);
        assert!(off_mm < 0.002, "{personality:?}: {off_mm} mm");
    }
}

#[test]
fn an_arm_is_at_its_place_after_ten_thousand_vectors() {
    // 250 waves of 40 vectors, all of different lengths.
    let wave = |n: u32| {
        let at = |i: u32| {
            let (x, y) = (f64::from(i) * 0.7 + f64::from(n) * 0.013, f64::from(n % 17));
            Point::new(180.0 + x, 5.0 * y - 40.0 + (x * 1.7).sin())
        };
        Stroke::open((0..=40).map(at).collect())
    };
    for personality in Personality::ALL {
        let waves: Vec<Stroke> = (0..250).map(wave).collect();
        let wanted = waves[249].last();
        let plan = plan(DrawingTool::default(), waves, personality);
        let commands: Vec<Command> = plan.commands().collect();
        assert!(commands.len() > 10_000);
        let seen = drive(&commands, personality, plan.start);
        let [x, y, _] = seen[seen.len() - 1].place;
        let wanted = wanted.expect("points");
        let off_mm = Point::new(x, y).distance(wanted);
        assert!(off_mm < 0.0005, "{personality:?}: {off_mm} mm");
    }
}

#[test]
fn a_stock_arm_draws_the_path_at_any_speed() {
    let personality = Personality::Firmware11;
    let plan = plan(DrawingTool::default(), strokes(), personality);
    let head: Vec<Command> = plan.commands().take(plan.command_of(0)).collect();
    let vectors: Vec<WriteVector> = plan
        .commands()
        .filter_map(|command| match command {
            Command::WriteVector(vector) => Some(vector),
            _ => None,
        })
        .collect();
    for share in [0.1, 0.5, 2.0] {
        let mut commands = head.clone();
        let arm_limits = ArmLimits::of(personality.dialect());
        let begin = RespeedStart {
            speed_mm_s: 0.0,
            position: Position::new(plan.start[0], plan.start[1], plan.start[2]),
            tool: dobot_arm::Tool::SuctionCup,
        };
        let others = respeed(&vectors, &begin, share, &arm_limits);
        commands.extend(others.into_iter().map(Command::from));
        let seen = drive(&commands, personality, plan.start);
        let drawn = ways(&seen, |sample| sample.place[2] < -39.999);
        let found = deviation(&strokes(), &drawn);
        assert!(found.astray.distance_mm < 0.02, "{share}: {found:?}");
    }
}

#[test]
fn the_laser_burns_all_of_each_stroke_and_nothing_else() {
    let laser = Laser {
        burn_speed_mm_s: 10.0,
        ..Laser::default()
    };
    let strokes = strokes()[..3].to_vec();
    for personality in Personality::ALL {
        let plan = plan(DrawingTool::Laser(laser), strokes.clone(), personality);
        let seen = drive(
            &plan.commands().collect::<Vec<_>>(),
            personality,
            plan.start,
        );
        let burned = ways(&seen, |sample| sample.laser);
        let found = deviation(&strokes, &burned);
        // Sampled every 20 ms, in which it moves 0.2 mm. A stock arm switches the laser at a tick,
        // in which it moves 0.005 mm, and each piece of a stroke is rounded as in a packet.
        let has_ticks = personality == Personality::Firmware11;
        let allowed_mm = if has_ticks { 0.006 } else { 0.2 };
        assert!(
            found.missed.distance_mm < allowed_mm,
            "{personality:?}: {found:?}"
        );
        assert!(
            found.astray.distance_mm < allowed_mm,
            "{personality:?}: {found:?}"
        );
        assert_eq!(burned.len(), strokes.len(), "{personality:?}");
        let travels = plan
            .moves
            .iter()
            .filter(|vector| vector.kind == MoveKind::Travel);
        assert_eq!(travels.count(), strokes.len());
        assert!(!seen[seen.len() - 1].laser);
    }
}

/// A stock arm switches the laser a tick before a vector: it burned small letters 0.11 mm off where
/// a corner was directly after that place, or the ticks differed from the estimate.
#[test]
fn a_stock_arm_burns_small_letters_within_the_tolerance() {
    for (height_mm, burn_speed_mm_s) in [(1.0, 3.0), (1.5, 8.0), (1.5, 20.0), (2.0, 30.0)] {
        let laser = Laser {
            burn_speed_mm_s,
            ..Laser::default()
        };
        let settings = Settings {
            arm_limits: ArmLimits::of(Personality::Firmware11.dialect()),
            tool: DrawingTool::Laser(laser),
            paper: Paper::level(-40.0),
            ..Settings::default()
        };
        let text = Text {
            font: Font::Stroke(StrokeFont::Serif),
            height_mm,
            ..Text::new("abgqs 368 RBS")
        };
        let anywhere = |_| Ok::<(), String>(());
        let prepared = prepare(&Source::Text(text), &settings, anywhere).expect("a plan");
        let seen = drive(
            &prepared.plan.commands().collect::<Vec<_>>(),
            Personality::Firmware11,
            prepared.plan.start,
        );
        let burned = ways(&seen, |sample| sample.laser);
        let found = deviation(&prepared.wanted(), &burned);
        // If it is switched at a corner it begins up to 0.04 mm too late or too early along the
        // path, in addition to the lateral error.
        assert!(
            found.largest_mm() <= settings.tolerance_mm.hypot(0.04),
            "{height_mm} mm at {burn_speed_mm_s} mm/s: {found:?}"
        );
    }
}

/// A status and a packet, one after the other, on the line.
const STATUS_AND_PACKET: Duration = Duration::from_millis(88);
