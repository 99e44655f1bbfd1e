//! Decoding against copying: a million packets, 42,000,000 bytes.
//!
//! The aim: a clean stream decodes in at most 1.35 times the time of copying it, in one run.

use std::hint::black_box;
use std::sync::LazyLock;

use divan::Bencher;
use divan::counter::BytesCount;
use dobot_wire::{Decoder, Dialect, Direction, Frame, MoveTo, MovingMode, PACKET_LEN, Status};

fn main() {
    divan::main();
}

#[divan::bench(sample_count = 30)]
fn copy(bencher: Bencher) {
    let bytes = COMMANDS.as_slice();
    let mut copy = vec![0; bytes.len()];
    bencher
        .counter(BytesCount::of_slice(bytes))
        .bench_local(|| {
            copy.copy_from_slice(black_box(bytes));
            black_box(&mut copy);
        });
}

#[divan::bench(sample_count = 30)]
fn commands_clean(bencher: Bencher) {
    bench(bencher, &Decoder::commands(), &COMMANDS);
}

#[divan::bench(sample_count = 30)]
fn commands_one_percent_damaged(bencher: Bencher) {
    bench(bencher, &Decoder::commands(), &damaged(COMMANDS.clone()));
}

#[divan::bench(sample_count = 30)]
fn statuses_clean_with_a_trivial_check(bencher: Bencher) {
    bench(bencher, &Decoder::statuses(|_| true), &STATUSES);
}

#[divan::bench(sample_count = 30)]
fn statuses_clean_with_kinematics(bencher: Bencher) {
    bench(
        bencher,
        &Decoder::statuses(agrees_with_its_angles),
        &STATUSES,
    );
}

#[divan::bench(sample_count = 30)]
fn statuses_one_percent_damaged_with_kinematics(bencher: Bencher) {
    bench(
        bencher,
        &Decoder::statuses(agrees_with_its_angles),
        &damaged(STATUSES.clone()),
    );
}

fn bench<D: Direction + Clone>(bencher: Bencher, decoder: &Decoder<D>, bytes: &[u8]) {
    bencher
        .counter(BytesCount::of_slice(bytes))
        .bench_local(|| {
            let mut decoder = decoder.clone();
            for packet in decoder.feed(black_box(bytes)) {
                black_box(&packet);
            }
            decoder.counts()
        });
}

/// A thousand commands, a thousand times: where in memory they lie is the same for all.
static COMMANDS: LazyLock<Vec<u8>> = LazyLock::new(|| {
    (0..1000)
        .flat_map(|n| command(n).to_bytes())
        .collect::<Vec<_>>()
        .repeat(1000)
});

fn command(n: u16) -> Frame {
    let step = f32::from(n) / 10.0;
    let target = MoveTo {
        x_mm: 150.0 + step,
        y_mm: 50.0 - step,
        z_mm: step / 3.0,
        rotation_deg: step / 7.0,
        suction: n.is_multiple_of(2),
        mode: MovingMode::MovL,
        gripper_deg: 0.0,
        pause_s: 0.5,
    };
    target.emit(&Dialect::SPECIFICATION)
}

/// A thousand statuses, a thousand times.
static STATUSES: LazyLock<Vec<u8>> = LazyLock::new(|| {
    (0..1000)
        .flat_map(|n| status(n).emit().to_bytes())
        .collect::<Vec<_>>()
        .repeat(1000)
});

fn status(n: u16) -> Status {
    let step = f32::from(n) / 1000.0;
    let (base_deg, rear_deg, fore_deg) = (90.0 * step - 45.0, 60.0 * step, 70.0 - 60.0 * step);
    let (x_mm, y_mm, z_mm) = forward(base_deg, rear_deg, fore_deg);
    Status {
        x_mm,
        y_mm,
        z_mm,
        rotation_deg: base_deg + 10.0,
        base_deg,
        rear_deg,
        fore_deg,
        servo_deg: 10.0,
        suction: n.is_multiple_of(2),
        gripper_deg: 0.0,
    }
}

/// Whether X, Y, Z and rHead follow from the angles.
fn agrees_with_its_angles(frame: &Frame) -> bool {
    let [x, y, z, rotation, base, rear, fore, servo, ..] = *frame.floats();
    let (x_wanted, y_wanted, z_wanted) = forward(base, rear, fore);
    let near = |found: f32, wanted: f32| (found - wanted).abs() <= 0.01;
    near(x, x_wanted) && near(y, y_wanted) && near(z, z_wanted) && near(rotation, servo + base)
}

fn forward(base_deg: f32, rear_deg: f32, fore_deg: f32) -> (f32, f32, f32) {
    let (base_sin, base_cos) = base_deg.to_radians().sin_cos();
    let (rear_sin, rear_cos) = rear_deg.to_radians().sin_cos();
    let (fore_sin, fore_cos) = fore_deg.to_radians().sin_cos();
    let reach = 135.0 * rear_sin + 160.0 * fore_cos + 55.07;
    (
        reach * base_cos,
        reach * base_sin,
        135.0 * rear_cos - 160.0 * fore_sin,
    )
}

/// Flips one byte of every hundredth packet, at a place that wanders through it.
fn damaged(mut bytes: Vec<u8>) -> Vec<u8> {
    for (n, packet) in bytes.chunks_mut(PACKET_LEN).step_by(100).enumerate() {
        packet[n * 5 % PACKET_LEN] ^= 0xFF;
    }
    bytes
}
