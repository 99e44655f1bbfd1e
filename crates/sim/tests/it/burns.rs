//! What a laser burns in the world around an arm.

use std::time::Duration;

use dobot_arm::Tool;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::Connection;
use dobot_sim::world::{Scene, World};
use dobot_sim::{InProcess, RECORDING_PERIOD, SerialLine, VirtualArm};
use dobot_wire::{Command, Configuration, JointJog, JointJogAxis, WriteVector};

/// Which way an arm went with its laser on, by its own samples and by the world around it: where that began and ended.
async fn burned(personality: Personality) -> [[f64; 2]; 2] {
    let power_up = PowerUp::new(personality);
    let scene = "[laser]\npower_w = 0.5\nfocus_mm = 25\ndepth_mm = 50";
    let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK)
        .with_world(World::new(Scene::parse(scene).unwrap()));
    arm.record(RECORDING_PERIOD);
    let arm = InProcess::new(arm);
    let mut connection = Connection::over_peer(arm.clone(), Some(personality.dialect()));
    connection.next_status().await.unwrap();
    let tool = Configuration::EndEffector {
        tool: Tool::Laser.into(),
    };
    let even = |it: WriteVector| WriteVector {
        start_speed_mm_s: 40.0,
        end_speed_mm_s: 40.0,
        ..it
    };
    let run_up = WriteVector {
        end_speed_mm_s: 40.0,
        ..WriteVector::by(0.0, 20.0, 0.0, 40.0)
    };
    let off = JointJog::new(JointJogAxis::LaserOff, 0.0);
    let burn = even(WriteVector::by(0.0, 30.0, 0.0, 40.0).burning());
    let commands: [Command; 4] = [tool.into(), run_up.into(), burn.into(), off.into()];
    for command in commands {
        connection.send(command).unwrap();
    }
    connection.pass(Duration::from_secs(12)).await.unwrap();
    let arm = arm.arm();
    let samples = arm.samples();
    let first = samples.iter().position(|it| it.laser).unwrap();
    let last = samples.iter().rposition(|it| it.laser).unwrap();
    let seen = [first - 1, last].map(|i| samples[i].position.y.0);
    let burns = arm.world().unwrap().state().burns;
    let ends = [
        burns[0].points_mm.first(),
        burns[burns.len() - 1].points_mm.last(),
    ];
    let shown = ends.map(|it| it.unwrap().y);
    [seen, shown]
}

#[tokio::test]
async fn a_world_shows_what_a_laser_burns_where_the_arm_is() {
    // In a tick it goes 0.8 mm, and the motors make whole pulses. What an ideal arm's laser burns is known to a tick.
    for (personality, allowed_mm) in [
        (Personality::Firmware11, 0.1),
        (Personality::Specification, 0.9),
    ] {
        let [seen, shown] = burned(personality).await;
        for (seen, shown) in seen.into_iter().zip(shown) {
            let off_mm = (seen - shown).abs();
            assert!(off_mm < allowed_mm, "{personality}: {seen} {shown}");
        }
    }
}
