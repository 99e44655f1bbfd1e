//! `cargo run -p dobot-examples --example accuracy`: the ratings and the accuracy of calibrations.
//!
//! Prints the table of `docs/calibration.md`, for two hundred random arms.

#[path = "../../../crates/calibrate/tests/it/arms.rs"]
#[expect(dead_code, reason = "of the module only the table is used")]
mod arms;

fn main() {
    println!(
        "| touches | good | unchecked | unmeasured | doubtful | refused | median | 95 of 100 | worst good arm, 95 of 100 | height, 95 of 100 |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for case in &arms::CASES {
        println!("{}", arms::Row::of(case, ARMS));
    }
}

const ARMS: u64 = 200;
