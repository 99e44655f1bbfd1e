//! `cargo run -p dobot-sim --example fidelity` holds the twin against every recording of the stock controller.
//!
//! With `> docs/fidelity.md` behind it, it writes that file anew.

mod recordings;
mod report;

fn main() {
    print!("{}", report::report());
}
