//! How much faster than time a virtual arm is: seconds of the arm's time for each second of the
//! computer's, on one core.
//!
//! `cargo bench -p dobot-sim --bench speed`: divan's items per second are those seconds.

use std::time::Duration;

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_sim::{Line, Script, VirtualArm, simulate};

fn main() {
    divan::main();
}

/// A virtual arm that nobody speaks to, its statuses carried over the line.
#[divan::bench(args = Personality::ALL)]
fn idle(bencher: Bencher, personality: Personality) {
    let mut arm = VirtualArm::new(Controller::power_up(PowerUp::new(personality)), Line::STOCK);
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

/// A zigzag of 45,000 vectors on two alternating diagonals, one each 80 ms.
fn hour_of_drawing(personality: Personality) -> String {
    let mut text = format!("!end {}\n", DRAWING_S * 1000);
    let x = if personality.dialect().reverses_write_x {
        -1
    } else {
        1
    };
    for n in 0..DRAWING_S * 1000 / 80 {
        let (x, y) = match n % 4 {
            0 => (x, 1),
            1 => (x, -1),
            2 => (-x, 1),
            _ => (-x, -1),
        };
        text += &format!("credit 4 0 {x} {y} 0 0 0 20 20 20\n");
    }
    text
}

const IDLE_S: u64 = 1000;
const DRAWING_S: u64 = 3600;
