//! Shared parts of the examples: the connection to an arm, and its confirmation by a person.

use std::error::Error;
use std::io::stdin;

use dobot_api::{Folders, Request, State, StationAddress};
use dobot_controller::{Personality, PowerUp};
use dobot_host::{LocalArm, StationClient};
use dobot_safety::Policy;

/// Connects to the arm at an address, to that of a station, or to a virtual one.
pub(crate) async fn reach(address: Option<String>) -> Result<StationClient, Box<dyn Error>> {
    let policy = Policy::default();
    Ok(match address.as_deref() {
        None | Some("virtual:") => {
            let power_up = PowerUp::new(Personality::Firmware11);
            StationClient::with_virtual_arm(power_up, policy, "example")
        }
        Some(url) if url.starts_with("http") => {
            StationClient::connect(&StationAddress::new(url)?, "example").await?
        }
        Some(address) => {
            let arm = LocalArm {
                address: address.parse()?,
                dialect: None,
                policy,
                folders: Folders::of_person().ok_or("this user has no home folder")?,
                // This program has no watchdog mode.
                watchdog: None,
            };
            StationClient::open(arm, "example").await?
        }
    })
}

/// Takes control of the arm after its first status; if its pose is not trusted, asks a person.
pub(crate) async fn ready(station: &mut StationClient) -> Result<State, Box<dyn Error>> {
    let mut state = station.state().await?;
    while state.arm.is_none() {
        state = station.state().await?;
    }
    if !state.trust.trusted {
        println!("{}", state.trust.reason.as_deref().unwrap_or_default());
        println!(
            "The arm is going to move. Is its reported pose correct? Press Enter to continue: {:?}",
            state.arm
        );
        stdin().read_line(&mut String::new())?;
        station.request(Request::ConfirmPose).await?;
    }
    station.request(Request::TakeLease).await?;
    Ok(state)
}
