//! `cargo run -p dobot-sim --example move_to`
//!
//! A virtual arm goes to a point in a straight line, jogs up for a second and comes back, as a real
//! one would with `Arm::open` in place of `Arm::over`.

use std::time::Duration;

use dobot_client::{Arm, Connection};
use dobot_controller::{Controller, PowerUp};
use dobot_sim::{InProcess, Line, VirtualArm};
use dobot_wire::{Dialect, LinearJog, LinearJogAxis, MoveTo, MovingMode};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), dobot_client::LinkError> {
    let virtual_arm = VirtualArm::new(Controller::power_up(PowerUp::default()), Line::STOCK);
    let peer = InProcess::new(virtual_arm);
    let mut arm = Arm::over(Connection::over_peer(peer, Some(Dialect::SPECIFICATION)));

    let there = MoveTo {
        x_mm: 220.0,
        y_mm: 40.0,
        z_mm: 10.0,
        rotation_deg: 0.0,
        suction: false,
        mode: MovingMode::MovL,
        gripper_deg: 0.0,
        pause_s: 0.0,
    };
    let up = LinearJog {
        axis: LinearJogAxis::ZPlus,
        speed_percent: 50.0,
    };
    for step in ["there", "up", "back"] {
        let status = match step {
            "up" => arm.jog(up, Duration::from_secs(1)).await?,
            _ => arm.move_to(there).await?,
        };
        let at = arm.connection().now().as_secs_f64();
        println!(
            "{at:5.2} s  {step:5}  {:.2}, {:.2}, {:.2} mm",
            status.x_mm, status.y_mm, status.z_mm
        );
    }
    Ok(())
}
