//! Jogs of a given duration, one directly after the other.

use std::future::pending;
use std::time::Duration;

use dobot_api::{Jog, Request};
use dobot_controller::{Personality, PowerUp};
use dobot_host::StationClient;
use dobot_safety::Policy;
use dobot_wire::{JointJog, JointJogAxis};

/// 50 % of 15 degrees/s (table 3.9).
const SPEED_DEG_S: f32 = 7.5;
const SPEED_PERCENT: f32 = 50.0;

async fn station(personality: Personality) -> StationClient {
    let power_up = PowerUp::new(personality);
    let mut station = StationClient::with_virtual_arm(power_up, Policy::default(), "test");
    station.first_state().await.unwrap();
    station.request(Request::TakeLease).await.unwrap();
    station
}

fn base(axis: JointJogAxis) -> Jog {
    Jog::Joint(JointJog::new(axis, SPEED_PERCENT))
}

#[tokio::test]
async fn each_of_two_hundred_jogs_moves_as_far_as_its_time_and_speed_imply() {
    for personality in Personality::ALL {
        let mut station = station(personality).await;
        let period_s = personality.dialect().status_period().as_secs_f32();
        let mut base_deg = station.rest().await.unwrap().status.base_deg;
        for number in 0..200_u16 {
            let (axis, sign) = if number % 2 == 0 {
                (JointJogAxis::BasePlus, 1.0)
            } else {
                (JointJogAxis::BaseMinus, -1.0)
            };
            let time_s = 0.3 + 0.1 * f32::from(number % 4);
            let time = Duration::from_secs_f32(time_s);
            let end = station.jog_for(base(axis), time, pending()).await.unwrap();
            let moved_deg = sign * (end.arm.status.base_deg - base_deg);
            base_deg = end.arm.status.base_deg;
            // A ramp that braking repeats does not change the distance.
            let extra_s = moved_deg / SPEED_DEG_S - time_s;
            assert!(
                extra_s.abs() < period_s,
                "jog {number} of {time_s} s on {}: {extra_s} s",
                personality.dialect().name()
            );
        }
    }
}
