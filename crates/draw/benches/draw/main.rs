//! Benchmarks of drawings: `cargo bench -p dobot-draw`.

mod drawing;
mod shape;

fn main() {
    divan::main();
}
