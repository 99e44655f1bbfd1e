//! `cargo run -p dobot-examples --example hello`: what an arm tells of itself.
//!
//! With an address behind it, `-- serial:/dev/ttyUSB0` or `-- tcp:HOST:PORT`, that arm is asked. It
//! moves nothing; but opening its port makes a stock arm say that its base is at 0.

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
        None => println!("it is trusted to stand there"),
        Some(reason) => println!("it need not stand there: {reason}"),
    }
    Ok(())
}
