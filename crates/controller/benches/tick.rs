//! The cost of one control tick: idle and in each kind of motion.
//!
//! `cargo bench -p dobot-controller --bench tick`: each sample is 500 ticks of 20 ms, with
//! the statuses fetched as a host does. The aim: below 150 ns a tick while moving.

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_arm::TICK;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_wire::{
    Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MoveTo, MovingMode,
    PlaybackAdjustment, WriteVector,
};

fn main() {
    divan::main();
}

#[divan::bench(args = Personality::ALL)]
fn idle(bencher: Bencher, personality: Personality) {
    bench(bencher, personality, None, SPED_UP);
}

#[divan::bench(args = Personality::ALL)]
fn movl(bencher: Bencher, personality: Personality) {
    bench(
        bencher,
        personality,
        Some(target(MovingMode::MovL)),
        SPED_UP,
    );
}

#[divan::bench(args = Personality::ALL)]
fn movj(bencher: Bencher, personality: Personality) {
    bench(
        bencher,
        personality,
        Some(target(MovingMode::MovJ)),
        SPED_UP,
    );
}

#[divan::bench(args = Personality::ALL)]
fn jump(bencher: Bencher, personality: Personality) {
    bench(
        bencher,
        personality,
        Some(target(MovingMode::Jump)),
        across(personality),
    );
}

#[divan::bench(args = Personality::ALL)]
fn write_vector(bencher: Bencher, personality: Personality) {
    let vector = WriteVector::by(-10.0, 80.0, 0.0, 3.0);
    bench(bencher, personality, Some(vector.into()), SPED_UP);
}

#[divan::bench(args = Personality::ALL)]
fn joint_jog(bencher: Bencher, personality: Personality) {
    let jog = JointJog::new(JointJogAxis::BasePlus, 10.0);
    bench(bencher, personality, Some(jog.into()), SPED_UP);
}

#[divan::bench(args = Personality::ALL)]
fn linear_jog(bencher: Bencher, personality: Personality) {
    let jog = LinearJog::new(LinearJogAxis::YPlus, 5.0);
    bench(bencher, personality, Some(jog.into()), SPED_UP);
}

/// Measures the ticks that follow the first `from`.
fn bench(bencher: Bencher, personality: Personality, command: Option<Command>, from: u32) {
    let mut last = in_flight(personality, command, from);
    tick(&mut last, from);
    let end = TICK * (from + TICKS);
    assert_eq!(
        last.pose_at(end) != last.pose_at(end + TICK / 2),
        command.is_some(),
        "the arm moves until after the last tick, if it does"
    );
    bencher
        .counter(ItemsCount::new(TICKS))
        .with_inputs(|| in_flight(personality, command, from))
        .bench_local_refs(|controller| tick(controller, from));
}

/// A controller that has started the command.
fn in_flight(personality: Personality, command: Option<Command>, until: u32) -> Controller {
    let mut controller = Controller::power_up(PowerUp::new(personality));
    for (command, ticks) in [Some(SLOWLY), command].into_iter().flatten().zip(0..) {
        let packet = command.emit(&personality.dialect());
        // In the middle of a tick, when it is not calculating.
        controller.handle_bytes(TICK * ticks + TICK / 2, &packet.to_bytes());
    }
    controller.handle_time(TICK * until);
    while controller.poll_bytes().is_some() {}
    controller
}

fn tick(controller: &mut Controller, from: u32) {
    for n in 1..=TICKS {
        controller.handle_time(TICK * (from + n));
        while let Some(status) = controller.poll_bytes() {
            divan::black_box(&status);
        }
    }
}

fn target(mode: MovingMode) -> Command {
    Command::MoveTo(MoveTo {
        rotation_deg: 10.0,
        mode,
        ..MoveTo::to(180.0, 160.0, -20.0)
    })
}

/// Slow enough for a sample within one motion.
const SLOWLY: Command = Command::PlaybackAdjustment(PlaybackAdjustment {
    speed_percent: 1.0,
    acceleration_percent: 50.0,
    teach_speed_percent: 50.0,
});
const TICKS: u32 = 500;
/// The ticks after which a motion has its speed.
const SPED_UP: u32 = 10;
/// The number of ticks of the rise of a jump: 20 mm straight up, or 3 degrees for 10 mm.
const fn across(personality: Personality) -> u32 {
    match personality {
        Personality::Firmware11 => 200,
        _ => 1500,
    }
}
