//! Handling of damaged bytes and packets.
//!
//! The packets set the end effector: that shows in X and Y at once, and nothing moves.

use dobot_wire::Status;

use crate::checks::settings::{other_tool, reach_of, show_tool};
use crate::outcome::Outcome;
use crate::packet::angles;
use crate::rig::{CheckError, Rig, distance};

/// Noise, then a packet.
pub(crate) async fn noise(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let packet = other_tool(rig).to_bytes();
    let bytes = [&NOISE, packet.as_slice()].concat();
    let obeyed = obeys(rig, &[&bytes]).await?;
    Ok(Outcome::of(
        obeyed,
        format!(
            "{} bytes of noise; the packet was {}",
            NOISE.len(),
            word(obeyed)
        ),
    ))
}

/// A packet with a wrong tail, and a whole one.
pub(crate) async fn tail(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let mut packet = other_tool(rig).to_bytes();
    packet[41] = 0x5B;
    let obeyed = obeys(rig, &[&packet]).await?;
    let lost = lost_until_obeyed(rig).await?;
    Ok(Outcome::of(
        !obeyed && lost == Some(0),
        format!(
            "it was {}; the next packet was {}",
            word(obeyed),
            word(lost == Some(0))
        ),
    ))
}

/// A packet in two pieces, with a pause in between.
pub(crate) async fn pieces(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let packet = other_tool(rig).to_bytes();
    let (first, second) = packet.split_at(17);
    let obeyed = obeys(rig, &[first, second]).await?;
    Ok(Outcome::of(
        obeyed,
        format!("17 and 25 bytes, 150 ms apart; {}", word(obeyed)),
    ))
}

/// Half a packet, then whole ones: how many of them are lost?
pub(crate) async fn truncated(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let packet = other_tool(rig).to_bytes();
    rig.send_raw(&packet[..20]).await?;
    let lost = lost_until_obeyed(rig).await?;
    Ok(match lost {
        Some(lost) => Outcome::Holds(format!("{lost} whole packets were lost with it")),
        None => Outcome::Differs(format!("{TRIES} whole packets after it were lost")),
    })
}

/// Two packets without a gap: the end effector, and a turn of the base.
pub(crate) async fn pair(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let goal = Status {
        base_deg: home.base_deg + 1.0,
        ..home
    };
    let turn = angles(&goal, 1.0);
    let bytes = [other_tool(rig).to_bytes(), turn.to_bytes()].concat();
    rig.send_raw(&bytes).await?;
    let now = rig.settled().await?;
    let first = (reach_of(&now) - reach_of(&home)).abs() > 1.0;
    let second = (now.base_deg - home.base_deg - 1.0).abs() < 0.02;
    show_tool(rig, true).await?;
    let found = format!("the first was {}, the second {}", word(first), word(second));
    Ok(Outcome::of(first && second, found))
}

/// Sends bytes that hold one packet, 150 ms between them, and returns whether it was obeyed. The end
/// effector is set again afterwards.
async fn obeys(rig: &mut Rig, parts: &[&[u8]]) -> Result<bool, CheckError> {
    let before = rig.settled().await?;
    for (index, part) in parts.iter().enumerate() {
        if index > 0 {
            rig.pass(150).await?;
        }
        rig.send_raw(part).await?;
    }
    rig.react().await?;
    let after = rig.next_status().await?;
    let obeyed = distance(&before, &after) > 1.0;
    if obeyed {
        show_tool(rig, true).await?;
    }
    Ok(obeyed)
}

/// How many whole packets are lost before one is obeyed; none where none is.
async fn lost_until_obeyed(rig: &mut Rig) -> Result<Option<u32>, CheckError> {
    for lost in 0..TRIES {
        let packet = other_tool(rig).to_bytes();
        if obeys(rig, &[&packet]).await? {
            return Ok(Some(lost));
        }
    }
    Ok(None)
}

/// Bytes that belong to no packet.
const NOISE: [u8; 13] = [0, 255, 13, 10, 90, 1, 2, 3, 0x5B, 77, 0, 0, 200];
const TRIES: u32 = 4;

const fn word(obeyed: bool) -> &'static str {
    if obeyed { "obeyed" } else { "not obeyed" }
}
