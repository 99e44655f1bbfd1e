//! The cost of checking one command.
//!
//! `cargo bench -p dobot-safety --bench check`: each sample goes through a hundred commands from
//! places all over the workspace; the time is that of one.

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_arm::{Joints, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::Policy;
use dobot_wire::{Command, Dialect, LinearJog, LinearJogAxis, MoveTo, MovingMode, WriteVector};

fn main() {
    divan::main();
}

/// A vector of a drawing: 2 mm.
#[divan::bench(args = POLICIES)]
fn write_vector(bencher: Bencher, policy: Named) {
    each(bencher, policy, |part| vector(2.0 * part, 1.5));
}

/// A stroke of 100 mm.
#[divan::bench(args = POLICIES)]
fn long_stroke(bencher: Bencher, policy: Named) {
    each(bencher, policy, |part| vector(40.0 * part, 100.0));
}

#[divan::bench(args = POLICIES)]
fn movl(bencher: Bencher, policy: Named) {
    each(bencher, policy, |part| target(MovingMode::MovL, part));
}

#[divan::bench(args = POLICIES)]
fn movj(bencher: Bencher, policy: Named) {
    each(bencher, policy, |part| target(MovingMode::MovJ, part));
}

#[divan::bench(args = POLICIES)]
fn jump(bencher: Bencher, policy: Named) {
    each(bencher, policy, |part| target(MovingMode::Jump, part));
}

#[divan::bench(args = POLICIES)]
fn jog(bencher: Bencher, policy: Named) {
    each(bencher, policy, |_| {
        LinearJog::new(LinearJogAxis::YPlus, 50.0).into()
    });
}

/// The trajectory without any check: the part contained in the numbers above.
#[divan::bench]
fn trajectory_alone(bencher: Bencher) {
    let pairs = hundred(|part| target(MovingMode::MovL, part));
    bencher.counter(ItemsCount::new(pairs.len())).bench(|| {
        for (model, command) in &pairs {
            divan::black_box(model.trajectory(command).is_ok());
        }
    });
}

fn each(bencher: Bencher, policy: Named, command: fn(f64) -> Command) {
    let policy = Policy::from_toml(policy.text()).expect("it is a policy");
    let pairs = hundred(command);
    let allowed = pairs
        .iter()
        .filter(|(model, command)| policy.check(model, command).is_ok());
    assert!(
        allowed.count() > 90,
        "a refusal is not what is to be measured"
    );
    bencher.counter(ItemsCount::new(pairs.len())).bench(|| {
        for (model, command) in &pairs {
            divan::black_box(policy.check(model, command).is_ok());
        }
    });
}

#[derive(Clone, Copy, Debug)]
enum Named {
    Default,
    FourKeepOuts,
}

impl Named {
    const fn text(self) -> &'static str {
        match self {
            Self::Default => "",
            Self::FourKeepOuts => FOUR_KEEP_OUTS,
        }
    }
}

const POLICIES: [Named; 2] = [Named::Default, Named::FourKeepOuts];

/// A crowded desk: all are near the places of the bench, and none is touched.
const FOUR_KEEP_OUTS: &str = "
[keep_out]
camera = { box = { x_mm = [330, 400], y_mm = [-40, 40], z_mm = [-103, 100] } }
lamp = { cylinder = { x_mm = 150, y_mm = 260, radius_mm = 30, z_mm = [-103, 136] } }
cup = { cylinder = { x_mm = 150, y_mm = -260, radius_mm = 40, z_mm = [-103, 0] } }
shelf = { box = { x_mm = [-300, 300], y_mm = [-300, 300], z_mm = [200, 220] } }
";

fn hundred(command: fn(f64) -> Command) -> Vec<(Model, Command)> {
    (0..100)
        .map(|index| f64::from(index) / 100.0)
        .map(|part| {
            let joints = Joints::new(40.0 * part - 20.0, 30.0 + 10.0 * part, 40.0, 0.0);
            let place = ArmPlace::at_joints(joints, Tool::SuctionCup);
            (Model::standing(Dialect::FIRMWARE_1_1, place), command(part))
        })
        .collect()
}

#[expect(clippy::cast_possible_truncation, reason = "as a client would send it")]
fn vector(x: f64, y: f64) -> Command {
    WriteVector::by(-x as f32, y as f32, 0.0, 40.0).into()
}

#[expect(clippy::cast_possible_truncation, reason = "as a client would send it")]
fn target(mode: MovingMode, part: f64) -> Command {
    MoveTo::to(
        200.0 + (30.0 * part) as f32,
        80.0 - (160.0 * part) as f32,
        10.0,
    )
    .with_mode(mode)
    .into()
}
