//! Proof that `wire`, `arm`, `motion` and `controller` need neither the standard library nor a heap.
//!
//! This program has no `std`, no allocator and a panic handler of its own. Were one of the four
//! crates, or anything below them, to ask for `std`, there would be two panic handlers; were one to
//! ask for a heap, there would be no allocator: in both cases it does not link.
//!
//! Its exit code is the number of the part that failed; 0 if none did.

#![no_std]
#![no_main]

use core::ffi::c_int;
use core::panic::PanicInfo;
use core::time::Duration;

use dobot_arm::{Joints, Limits, Pose, Tool, forward};
use dobot_controller::{Controller, PowerUp};
use dobot_motion::{ArmPlace, LineMove, Model, Speeds};
use dobot_wire::{Command, Decoder, Dialect, MoveTo, MovingMode, Packet, Status};

// The one place of the project with `unsafe`: without `std` nobody else gives the C start-up code
// its `main`, and nobody links the C library.
#[unsafe(no_mangle)]
extern "C" fn main() -> c_int {
    for (code, check) in (1..).zip(CHECKS) {
        if check().is_none() {
            return code;
        }
    }
    0
}

#[link(name = "c")]
unsafe extern "C" {
    safe fn abort() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    abort()
}

/// A command goes to bytes and comes back.
fn wire() -> Option<()> {
    let bytes = packet().to_bytes();
    let found = Decoder::commands().feed(&bytes).last()?;
    let command = Command::parse(&found, &DIALECT).ok()?;
    (command == Command::MoveTo(TARGET)).then_some(())
}

/// A pose follows from joint angles, and they from it.
fn arm() -> Option<()> {
    let joints = Joints::new(30.0, 20.0, 25.0, -10.0);
    let pose = forward(&joints, Tool::SuctionCup);
    let again = Limits::STOCK.solve(&pose, Tool::SuctionCup).ok()?;
    ((again.rear.0 - joints.rear.0).abs() < 1e-9).then_some(())
}

/// A line ends where it should.
fn motion() -> Option<()> {
    let from = forward(&Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
    let to = forward(&Joints::new(30.0, 20.0, 25.0, -10.0), Tool::SuctionCup);
    let line = LineMove::new(from, to, &Speeds::STOCK).ok()?;
    let half_way: Pose = line.pose_at(line.duration_s() / 2.0);
    let ends = line.pose_at(line.duration_s()) == to;
    (ends && half_way != from && half_way != to).then_some(())
}

/// A command leads to its target.
fn trajectory() -> Option<()> {
    let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
    let trajectory = Model::standing(DIALECT, here)
        .trajectory(&TARGET.into())
        .ok()?;
    let off_mm = trajectory.end()?.pose.position.x.0 - f64::from(TARGET.x_mm);
    (off_mm.abs() < 1e-9).then_some(())
}

/// A controller goes to a point and reports that.
fn controller() -> Option<()> {
    let mut controller = Controller::power_up(PowerUp::default());
    controller.handle_bytes(Duration::ZERO, &packet().to_bytes());
    let mut status = None;
    for second in 1..=10 {
        controller.handle_time(Duration::from_secs(second));
        while let Some(upload) = controller.poll_bytes() {
            status = Decoder::statuses(|_| true).feed(&upload.bytes).last();
        }
    }
    let status = Status::parse(&status?).ok()?;
    ((status.x_mm - TARGET.x_mm).abs() < 1e-3).then_some(())
}

fn packet() -> Packet {
    Command::from(TARGET).emit(&DIALECT)
}

const CHECKS: [fn() -> Option<()>; 5] = [wire, arm, motion, trajectory, controller];
const DIALECT: Dialect = Dialect::SPECIFICATION;
const TARGET: MoveTo = MoveTo::to(220.0, 40.0, 10.0).with_mode(MovingMode::MovL);
