//! How much faster than time a virtual arm is: seconds of the arm's time for each second of the
//! computer's, on one core.
//!
//! `cargo bench -p dobot-sim --bench speed`: divan's items per second are those seconds.

use std::time::Duration;

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_sim::{Script, SerialLine, VirtualArm, simulate};
use dobot_wire::Frame;

fn main() {
    divan::main();
}

/// A virtual arm that nobody speaks to, its statuses carried over the line.
#[divan::bench(args = Personality::ALL)]
fn idle(bencher: Bencher, personality: Personality) {
    let mut arm = VirtualArm::new(
        Controller::power_up(PowerUp::new(personality)),
        SerialLine::STOCK,
    );
    let mut bytes = Vec::new();
    bencher.counter(ItemsCount::new(IDLE_S)).bench_local(|| {
        let until = arm.now() + Duration::from_secs(IDLE_S);
        while arm.now() < until {
            arm.handle_time(arm.poll_wakeup());
            arm.poll_bytes(&mut bytes);
            bytes.clear();
        }
    });
}

/// The controller alone, its statuses fetched.
#[divan::bench(args = Personality::ALL)]
fn idle_controller(bencher: Bencher, personality: Personality) {
    let mut controller = Controller::power_up(PowerUp::new(personality));
    let mut until = Duration::ZERO;
    bencher.counter(ItemsCount::new(IDLE_S)).bench_local(|| {
        until += Duration::from_secs(IDLE_S);
        while controller.poll_wakeup() <= until {
            controller.handle_time(controller.poll_wakeup());
            while let Some(upload) = controller.poll_bytes() {
                divan::black_box(&upload);
            }
        }
    });
}

/// The controller alone, drawing: a vector for each status.
#[divan::bench(args = Personality::ALL, sample_count = 20)]
fn drawing_controller(bencher: Bencher, personality: Personality) {
    let packets = zigzag(personality).map(|[x, y]| {
        let floats = [4.0, 0.0, x, y, 0.0, 0.0, 0.0, 20.0, 20.0, 20.0];
        let frame = floats.iter().zip(1..);
        frame
            .fold(Frame::ZERO, |it, (value, n)| it.with(n, *value))
            .to_bytes()
    });
    bencher.counter(ItemsCount::new(DRAWING_S)).bench_local(|| {
        let mut controller = Controller::power_up(PowerUp::new(personality));
        for (n, packet) in (0..DRAWING_S * 1000 / 80).zip(packets.iter().cycle()) {
            // In the second half of a tick, when no controller calculates.
            let at = Duration::from_millis(80 * n + 13);
            controller.handle_bytes(at, packet);
            while let Some(upload) = controller.poll_bytes() {
                divan::black_box(&upload);
            }
        }
        assert_eq!(controller.counters().refused, 0);
        assert!(controller.counters().begun > DRAWING_S);
    });
}

/// An hour of drawing, a vector for each status: the script is read, executed and traced.
#[divan::bench(args = Personality::ALL, sample_count = 20)]
fn drawing(bencher: Bencher, personality: Personality) {
    let text = hour_of_drawing(personality);
    bencher.counter(ItemsCount::new(DRAWING_S)).bench_local(|| {
        let script = Script::parse(&text).expect("it is one");
        let simulation = simulate(&script, personality).expect("it has the port");
        assert!(simulation.refused.is_empty(), "{:?}", simulation.refused);
        simulation.trace.statuses.len()
    });
}

/// A zigzag of 45,000 vectors.
fn hour_of_drawing(personality: Personality) -> String {
    let ways = zigzag(personality);
    let vectors = (0..DRAWING_S * 1000 / 80)
        .zip(ways.iter().cycle())
        .map(|(_, [x, y])| format!("credit 4 0 {x} {y} 0 0 0 20 20 20\n"));
    std::iter::once(format!("!end {}\n", DRAWING_S * 1000))
        .chain(vectors)
        .collect()
}

/// Two alternating diagonals, there and back.
fn zigzag(personality: Personality) -> [[f32; 2]; 4] {
    let x = if personality.dialect().reverses_write_x {
        -1.0
    } else {
        1.0
    };
    [[x, 1.0], [x, -1.0], [-x, 1.0], [-x, -1.0]]
}

const IDLE_S: u64 = 1000;
const DRAWING_S: u64 = 3600;
