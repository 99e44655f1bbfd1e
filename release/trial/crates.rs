//! A program of another project: it asks a virtual arm in its own process where it stands, and compares that with the
//! kinematics.

use std::error::Error;

use dobot_arm::{Joints, Tool, forward};
use dobot_controller::{Controller, PowerUp};
use dobot_session::Connection;
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::Dialect;

#[tokio::main]
async fn main() -> Result<(), Box<dyn Error>> {
    let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
    let mut connection = Connection::over_peer(InProcess::new(arm), Some(Dialect::SPECIFICATION));
    let status = connection.next_status().await?;
    let [base, rear, fore] = [status.base_deg, status.rear_deg, status.fore_deg].map(f64::from);
    let x_mm = forward(&Joints::new(base, rear, fore, 0.0), Tool::SuctionCup).position.x.0;
    let found = f64::from(status.x_mm);
    assert!((x_mm - found).abs() < 0.001, "{x_mm} is not {found}");
    println!("a virtual arm stands at x {x_mm:.2} mm");
    Ok(())
}
