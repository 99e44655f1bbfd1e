//! `cargo run -p dobot-examples --example hello`: prints the state of an arm.
//!
//! With an address, `-- serial:/dev/ttyUSB0` or `-- tcp:HOST:PORT`, it prints the state of that
//! arm. It moves nothing, but opening its port makes a stock arm report its base at 0.

mod connect;

use std::error::Error;

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arm = connect::arm().await?;
    let status = arm.status().await?;
    let [x, y, z] = [status.x_mm, status.y_mm, status.z_mm];
    println!("tool   x {x:.2}, y {y:.2}, z {z:.2} mm");
    let [base, rear, fore] = [status.base_deg, status.rear_deg, status.fore_deg];
    println!("joints base {base:.2}, rear {rear:.2}, fore {fore:.2} degrees");
    let session = arm.connection().session();
    match session.distrust_reason() {
        None => println!("the pose is trusted"),
        Some(reason) => println!("the pose is not trusted: {reason}"),
    }
    Ok(())
}
