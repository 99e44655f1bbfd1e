//! Parsing, compiling and checking a program of 100,000 steps.

use std::fmt::Write;

use divan::{Bencher, black_box};
use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_teach::{Compiled, NoFiles, Program, check};
use dobot_wire::{Dialect, Status};

fn main() {
    divan::main();
}

/// 100,000 steps to different points, by all three path types.
fn text() -> String {
    let mut text = String::new();
    for n in 0..100_000_u32 {
        let path = ["jump", "movl", "movj"][n as usize % 3];
        let (x, y, z) = (200 + n % 47, f64::from(n % 101) - 50.5, n % 29);
        let _ = write!(
            text,
            "[[steps]]\ngo = {{ x = {x}, y = {y}, z = {z} }}\npath = \"{path}\"\nsuction = {}\npause = 0.1\n\n",
            n % 2 == 0
        );
    }
    text
}

fn compiled(text: &str) -> Compiled {
    let program = Program::from_toml(text).expect("it is a program");
    program.compile(&mut NoFiles).expect("it stands alone")
}

fn checked(compiled: &Compiled) -> usize {
    let start = Model::new(Dialect::FIRMWARE_1_1, &Status::AT_ZERO);
    check(compiled, &Policy::default(), start).problems.len()
}

#[divan::bench(sample_count = 5)]
fn read(bencher: Bencher<'_, '_>) {
    let text = text();
    bencher.bench(|| Program::from_toml(black_box(&text)).expect("it is a program"));
}

#[divan::bench(sample_count = 5)]
fn compile(bencher: Bencher<'_, '_>) {
    let program = Program::from_toml(&text()).expect("it is a program");
    bencher.bench(|| {
        black_box(&program)
            .compile(&mut NoFiles)
            .expect("it stands alone")
    });
}

#[divan::bench(sample_count = 5)]
fn check_way(bencher: Bencher<'_, '_>) {
    let compiled = compiled(&text());
    bencher.bench(|| checked(black_box(&compiled)));
}
