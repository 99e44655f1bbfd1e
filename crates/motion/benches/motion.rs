//! Benchmarks of planning a motion and of its control ticks.
//!
//! `cargo bench -p dobot-motion --bench motion`: each sample processes a thousand inputs.

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_arm::{Degrees, Joints, Limits, Millimeters, Pose, Position, Tool};
use dobot_motion::{JointMove, Jump, LineMove, Profile, Speeds, Stroke, StrokeSpeeds};

fn main() {
    divan::main();
}

#[divan::bench]
fn plan_joint_move(bencher: Bencher) {
    let moves = thousand(|part| (joints(part), joints(1.0 - 0.7 * part)));
    each(bencher, &moves, |(from, to)| {
        JointMove::new(*from, *to, &Speeds::STOCK)
    });
}

#[divan::bench]
fn plan_line_move(bencher: Bencher) {
    let moves = thousand(|part| (pose(part), pose(1.0 - 0.7 * part)));
    each(bencher, &moves, |(from, to)| {
        LineMove::new(*from, *to, &Speeds::STOCK)
    });
}

#[divan::bench]
fn plan_jump(bencher: Bencher) {
    let moves = thousand(|part| (pose(part), pose(1.0 - 0.7 * part)));
    each(bencher, &moves, |(from, to)| {
        Jump::new(*from, *to, Millimeters(20.0), &Speeds::STOCK)
    });
}

#[divan::bench]
fn plan_stroke(bencher: Bencher) {
    let vectors = thousand(|part| Position::new(part * 3.0, 1.0 - part, 0.0));
    each(bencher, &vectors, |vector| {
        Stroke::new(pose(0.0).position, *vector, &STROKE_SPEEDS)
    });
}

#[divan::bench]
fn profile_distance_at(bencher: Bencher) {
    let profile = Profile::new(100.0, 0.0, 0.0, 50.0, 100.0).expect("the limits are positive");
    each(bencher, &thousand(|part| part * 2.5), |t_s| {
        profile.distance_at(*t_s)
    });
}

#[divan::bench]
fn joint_move_joints_at(bencher: Bencher) {
    let movement =
        JointMove::new(joints(0.0), joints(1.0), &Speeds::STOCK).expect("the limits are positive");
    each(
        bencher,
        &thousand(|part| part * movement.duration_s()),
        |t_s| movement.joints_at(*t_s),
    );
}

/// A control tick on a line: the pose, its joint angles and the limit check.
#[divan::bench]
fn tick_on_line(bencher: Bencher) {
    let line =
        LineMove::new(pose(0.0), pose(1.0), &Speeds::STOCK).expect("the limits are positive");
    let times = thousand(|part| part * line.duration_s());
    assert!(
        times.iter().all(|t_s| solve(&line, *t_s).is_ok()),
        "the line stays inside the limits"
    );
    each(bencher, &times, |t_s| solve(&line, *t_s));
}

/// A control tick on a joint move: the joint angles and the limit check.
#[divan::bench]
fn tick_on_joint_move(bencher: Bencher) {
    let movement =
        JointMove::new(joints(0.0), joints(1.0), &Speeds::STOCK).expect("the limits are positive");
    let times = thousand(|part| part * movement.duration_s());
    each(bencher, &times, |t_s| {
        Limits::STOCK.check(&movement.joints_at(*t_s), TOOL)
    });
}

fn solve(line: &LineMove, t_s: f64) -> Result<Joints, dobot_arm::Unreachable> {
    Limits::STOCK.solve(&line.pose_at(t_s), TOOL)
}

fn each<T: Sync, O>(bencher: Bencher, inputs: &[T], calculate: impl Fn(&T) -> O + Sync) {
    bencher.counter(ItemsCount::new(inputs.len())).bench(|| {
        for input in inputs {
            divan::black_box(calculate(divan::black_box(input)));
        }
    });
}

/// Creates a thousand inputs from shares between 0 and 1.
fn thousand<T>(make: impl Fn(f64) -> T) -> Vec<T> {
    (0..1000)
        .map(|n| make((f64::from(n) * 0.618_03).fract()))
        .collect()
}

fn joints(part: f64) -> Joints {
    Joints::new(
        90.0 * part,
        10.0 + 30.0 * part,
        20.0 + 10.0 * part,
        -30.0 * part,
    )
}

fn pose(part: f64) -> Pose {
    Pose {
        position: Position::new(180.0 + 60.0 * part, 120.0 * part - 60.0, 80.0 * part - 20.0),
        rotation: Degrees(40.0 * part),
    }
}

const TOOL: Tool = Tool::SuctionCup;
const STROKE_SPEEDS: StrokeSpeeds = StrokeSpeeds {
    start_mm_s: 10.0,
    end_mm_s: 12.0,
    max_mm_s: 50.0,
    acceleration_mm_s2: 100.0,
};
