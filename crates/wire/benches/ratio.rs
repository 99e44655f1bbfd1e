//! Decoding a clean stream against copying it, turn by turn: what the memory's other users take
//! away in one turn they take from both.
//!
//! Prints the median of the ratios. The aim is at most 1.35.

use std::hint::black_box;
use std::time::{Duration, Instant};

use dobot_wire::{Decoder, Dialect, MoveTo, MovingMode};

fn main() {
    // `cargo test` runs this without the word, to see that it works.
    let measuring = std::env::args().any(|word| word == "--bench");
    let (packets, turns) = if measuring {
        (1_000_000, 200)
    } else {
        (1000, 3)
    };
    let bytes = commands(packets);
    let mut copy = vec![0; bytes.len()];
    let mut ratios: Vec<f64> = (0..turns)
        .map(|_| {
            let copying = time(|| copy.copy_from_slice(black_box(&bytes)));
            black_box(&copy);
            let decoding = time(|| assert_eq!(decode(&bytes), packets));
            decoding.as_secs_f64() / copying.as_secs_f64()
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    let [low, median, high] = [10, 50, 90].map(|percent| ratios[turns * percent / 100]);
    println!(
        "decoding takes {median:.2} times as long as copying ({low:.2} to {high:.2} in eight turns of ten)"
    );
}

fn decode(bytes: &[u8]) -> usize {
    let mut decoder = Decoder::commands();
    let mut packets = 0;
    for packet in decoder.feed(black_box(bytes)) {
        black_box(&packet);
        packets += 1;
    }
    packets
}

fn time(run: impl FnOnce()) -> Duration {
    let began = Instant::now();
    run();
    began.elapsed()
}

fn commands(packets: usize) -> Vec<u8> {
    let target = MoveTo {
        rotation_deg: 15.0,
        mode: MovingMode::MovL,
        pause_s: 0.5,
        ..MoveTo::to(200.0, -50.0, 20.0)
    };
    let packet = target.emit(&Dialect::SPECIFICATION).to_bytes();
    packet.repeat(packets)
}
