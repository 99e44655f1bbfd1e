//! The arm of an example: at the address in the first argument, or a virtual one.

#![allow(dead_code, reason = "examples that move nothing do not ask")]

use std::error::Error;

use dobot_controller::{Controller, PowerUp};
use dobot_session::{Address, Arm, Connection};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::Dialect;

/// Connects to `virtual:` (default), `serial:/dev/ttyUSB0` or `tcp:HOST:PORT`.
pub(crate) async fn arm() -> Result<Arm, Box<dyn Error>> {
    let address = std::env::args().nth(1).unwrap_or("virtual:".into());
    let address: Address = address.parse()?;
    if address != Address::Virtual {
        return Ok(Arm::open(&address, Some(Dialect::FIRMWARE_1_1)).await?);
    }
    let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
    let connection = Connection::over_peer(InProcess::new(arm), Some(Dialect::SPECIFICATION));
    Ok(Arm::over(connection))
}

/// A real arm is moved only after a person has checked its pose.
pub(crate) async fn ask(arm: &mut Arm) -> Result<(), Box<dyn Error>> {
    let status = arm.status().await?;
    if arm.connection().session().is_trusted() {
        return Ok(());
    }
    println!(
        "This moves a real arm. It reports its base at {:.1} degrees, its rear arm at {:.1} and its forearm at {:.1}.",
        status.base_deg, status.rear_deg, status.fore_deg
    );
    println!("Is that correct, and is the path free? Enter: yes, move it. Ctrl-C: no.");
    if std::io::stdin().read_line(&mut String::new())? == 0 {
        return Err("the pose of the arm was not confirmed".into());
    }
    arm.confirm_pose();
    Ok(())
}
