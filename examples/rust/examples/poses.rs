//! `cargo run -p dobot-examples --example poses -- pen`: a thousand poses of the arm, as CSV, to
//! verify a model.
//!
//! Each has joint angles, the resulting position and rotation of the tool, and whether the stock
//! arm may be there.

use dobot_arm::{Joints, Limits, Span, Tool, forward};
use dobot_geometry::Random;

fn main() {
    let name = std::env::args().nth(1);
    let name = name.as_deref().unwrap_or(Tool::SuctionCup.short());
    let Some(tool) = Tool::named(name) else {
        let allowed = Tool::ALL.map(Tool::short).join(", ");
        eprintln!("error: the tool is `{name}`; allowed are {allowed}");
        std::process::exit(2);
    };
    println!("base_deg,rear_deg,fore_deg,servo_deg,x_mm,y_mm,z_mm,rotation_deg,allowed");
    let mut random = Random::new(1);
    // Slightly beyond the ranges of the joints, to include refused poses.
    let mut within = |span: Span<_>| {
        let (min, max): (dobot_arm::Degrees, dobot_arm::Degrees) = (span.min, span.max);
        (max - min) * (1.1 * random.share() - 0.05) + min
    };
    for _ in 0..1000 {
        let joints = Joints {
            base: within(Limits::STOCK.base),
            rear: within(Limits::STOCK.rear),
            fore: within(Limits::STOCK.fore),
            servo: within(Limits::STOCK.servo),
        };
        let pose = forward(&joints, tool);
        let allowed = Limits::STOCK.check(&joints, tool).is_ok();
        println!(
            "{},{},{},{},{},{},{},{},{allowed}",
            joints.base.0,
            joints.rear.0,
            joints.fore.0,
            joints.servo.0,
            pose.position.x.0,
            pose.position.y.0,
            pose.position.z.0,
            pose.rotation.0
        );
    }
}
