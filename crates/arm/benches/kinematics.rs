//! Kinematics against the library calls that they cannot do without.
//!
//! `cargo bench -p dobot-arm --bench kinematics`: compare `inverse` with `inverse_calls_*`
//! and `forward` with `forward_calls` of the same run. Each sample goes through a thousand poses.

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_arm::{FOREARM, Joints, Limits, Pose, REAR_ARM, Tool, agrees, forward, inverse, stock};

fn main() {
    divan::main();
}

/// Two roots, two arc tangents and two arc cosines, each waiting for the one before.
#[divan::bench]
fn inverse_calls_one_by_one(bencher: Bencher) {
    each(
        bencher,
        &spread(|joints| arguments(&forward(&joints, TOOL))),
        |a| {
            let reach = libm::sqrt(a[0]);
            let distance = libm::sqrt(a[1] + NOTHING * reach);
            let base = libm::atan2(a[2] + NOTHING * distance, a[3]);
            let elevation = libm::atan2(a[4] + NOTHING * base, a[5]);
            let alpha = libm::acos(a[6] + NOTHING * elevation);
            libm::acos(a[7] + NOTHING * alpha)
        },
    );
}

/// The same where each waits only for what the formula makes it wait for.
#[divan::bench]
fn inverse_calls_side_by_side(bencher: Bencher) {
    each(
        bencher,
        &spread(|joints| arguments(&forward(&joints, TOOL))),
        |a| {
            let reach = libm::sqrt(a[0]);
            let distance = libm::sqrt(a[1] + NOTHING * reach);
            [
                libm::atan2(a[2], a[3]),
                libm::atan2(a[4], a[5] + NOTHING * reach),
                libm::acos(a[6] + NOTHING * distance),
                libm::acos(a[7] + NOTHING * distance),
            ]
        },
    );
}

#[divan::bench(name = "inverse")]
fn inverse_whole(bencher: Bencher) {
    each(bencher, &spread(|joints| forward(&joints, TOOL)), |pose| {
        inverse(pose, TOOL)
    });
}

#[divan::bench]
fn forward_calls(bencher: Bencher) {
    each(bencher, &spread(|joints| joints), |joints| {
        [joints.base.0, joints.rear.0, joints.fore.0].map(|angle| libm::sincos(angle * 0.017))
    });
}

#[divan::bench(name = "forward")]
fn forward_whole(bencher: Bencher) {
    each(bencher, &spread(|joints| joints), |joints| {
        forward(joints, TOOL)
    });
}

/// As the stock controller calculates, in 24 digits and a few more.
#[divan::bench]
fn stock_forward(bencher: Bencher) {
    each(bencher, &spread(in_single), |joints| {
        stock::forward(*joints, TOOL_MM)
    });
}

#[divan::bench]
fn stock_inverse(bencher: Bencher) {
    let poses = spread(|joints| stock::forward(in_single(joints), TOOL_MM));
    each(bencher, &poses, |pose| stock::inverse(*pose, TOOL_MM));
}

#[divan::bench]
fn limits_check(bencher: Bencher) {
    each(bencher, &spread(|joints| joints), |joints| {
        Limits::STOCK.check(joints, TOOL)
    });
}

#[divan::bench]
fn limits_check_at(bencher: Bencher) {
    let places = spread(|joints| (joints, forward(&joints, TOOL).position));
    each(bencher, &places, |(joints, position)| {
        Limits::STOCK.check_at(joints, *position)
    });
}

#[divan::bench]
fn status_agrees(bencher: Bencher) {
    let statuses = spread(|joints| {
        let Pose { position, rotation } = forward(&joints, TOOL);
        let position_mm = [position.x.0, position.y.0, position.z.0];
        (position_mm, rotation.0, joints.angles_deg())
    });
    each(bencher, &statuses, |status| {
        agrees(status.0, status.1, status.2)
    });
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the stock controller has no more digits"
)]
fn in_single(joints: Joints) -> stock::StockJoints {
    stock::StockJoints {
        base_deg: joints.base.0 as f32,
        rear_deg: joints.rear.0 as f32,
        fore_deg: joints.fore.0 as f32,
        servo_deg: joints.servo.0 as f32,
    }
}

fn each<T: Sync, O>(bencher: Bencher, inputs: &[T], calculate: impl Fn(&T) -> O + Sync) {
    bencher.counter(ItemsCount::new(inputs.len())).bench(|| {
        for input in inputs {
            divan::black_box(calculate(divan::black_box(input)));
        }
    });
}

/// Things made from a thousand joint angles, spread over the workspace without a pattern.
fn spread<T>(make: impl Fn(Joints) -> T) -> Vec<T> {
    let part = |n: i32, step: f64| (f64::from(n) * step).fract();
    let joints = (0..).map(|n| {
        let [base, rear, fore] = [0.819_17, 0.671_04, 0.549_70].map(|step| part(n, step));
        Joints::new(
            base * 270.0 - 135.0,
            rear * 90.0 - 5.0,
            fore * 105.0 - 10.0,
            base * 60.0,
        )
    });
    let allowed = joints.filter(|joints| Limits::STOCK.check(joints, TOOL).is_ok());
    allowed.take(1000).map(make).collect()
}

/// What the calls of `inverse` are given: two squares, two pairs of sides, two cosines.
fn arguments(pose: &Pose) -> [f64; 8] {
    let [x, y, z] = [pose.position.x.0, pose.position.y.0, pose.position.z.0];
    let reach_v2 = x * x + y * y;
    let across = reach_v2.sqrt() - TOOL.reach().0;
    let distance_v2 = across * across + z * z;
    let [rear, fore] = [REAR_ARM.0, FOREARM.0];
    let cosine = |near: f64, far: f64| {
        (near * near + distance_v2 - far * far) / (2.0 * near * distance_v2.sqrt())
    };
    [
        reach_v2,
        distance_v2,
        y,
        x,
        z,
        across,
        cosine(rear, fore),
        cosine(fore, rear),
    ]
}

/// Makes a call wait for another without changing its argument.
const NOTHING: f64 = 1e-30;

const TOOL: Tool = Tool::SuctionCup;
const TOOL_MM: f32 = 55.07;
