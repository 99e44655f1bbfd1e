//! `cargo run -p dobot-examples --example move_to`: moves to two points, in a straight line and
//! with a jump.
//!
//! With an address, `-- serial:/dev/ttyUSB0` or `-- tcp:HOST:PORT`, **a real arm moves**, 8 cm to
//! either side in front of it: it says so first, and waits for Enter.

mod connect;

use std::error::Error;

use dobot_wire::{MoveTo, MovingMode};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arm = connect::arm().await?;
    connect::ask(&mut arm).await?;
    for (mode, y_mm) in [(MovingMode::MovL, 40.0), (MovingMode::Jump, -40.0)] {
        let there = MoveTo::to(220.0, y_mm, 10.0).with_mode(mode);
        let status = arm.move_to(there).await?;
        let at = arm.connection().now().as_secs_f64();
        let [x, y, z] = [status.x_mm, status.y_mm, status.z_mm];
        println!("{at:5.2} s  {mode:?}  {x:.2}, {y:.2}, {z:.2} mm");
    }
    Ok(())
}
