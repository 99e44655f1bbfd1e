//! `cargo run -p dobot-examples --example pick_and_place`: a virtual arm picks something up and
//! puts it down elsewhere.
//!
//! With `Connection::open` instead of `Connection::over_peer`, and `Session::confirm_pose` after a
//! person has checked the pose, the same lines move a real arm.

use std::error::Error;

use dobot_controller::{Controller, PowerUp};
use dobot_session::{Connection, LinkError};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::{Dialect, MoveTo};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
    let mut arm = Connection::over_peer(InProcess::new(arm), Some(Dialect::SPECIFICATION));
    arm.next_status().await?;

    go(&mut arm, [220.0, -60.0, -30.0], true).await?;
    go(&mut arm, [220.0, 60.0, -30.0], false).await?;

    let status = arm.next_status().await?;
    let seconds = arm.now().as_secs_f64();
    println!(
        "put down at x {:.1} y {:.1} z {:.1} after {seconds:.1} s on the arm's clock",
        status.x_mm, status.y_mm, status.z_mm
    );
    Ok(())
}

/// Jumps to a point, switches the suction cup there, and waits for half a second.
async fn go(arm: &mut Connection, point: [f32; 3], suction: bool) -> Result<(), LinkError> {
    let [x_mm, y_mm, z_mm] = point;
    let there = arm.send(MoveTo {
        suction,
        pause_s: 0.5,
        ..MoveTo::to(x_mm, y_mm, z_mm)
    })?;
    arm.completed(there).await?;
    println!("suction is {}", if suction { "on" } else { "off" });
    Ok(())
}
