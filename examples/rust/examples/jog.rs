//! `cargo run -p dobot-examples --example jog`: holds a jog button for a second.
//!
//! With an address, `-- serial:/dev/ttyUSB0` or `-- tcp:HOST:PORT`, **a real arm moves**, up and
//! down by 3 cm: it says so first, and waits for Enter.

mod connect;

use std::error::Error;
use std::time::Duration;

use dobot_wire::{LinearJog, LinearJogAxis};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arm = connect::arm().await?;
    connect::ask(&mut arm).await?;
    for axis in [LinearJogAxis::ZPlus, LinearJogAxis::ZMinus] {
        let held = LinearJog::new(axis, 50.0);
        let status = arm.jog(held, Duration::from_secs(1)).await?;
        println!("{axis:?}: z {:.2} mm", status.z_mm);
    }
    Ok(())
}
