//! What drawings cost: `cargo bench -p dobot-draw`.

mod drawing;
mod shape;

fn main() {
    divan::main();
}
