//! Traps of stock arms (note N34), which only a reset cures: for virtual arms, and last of all.

use dobot_wire::{Frame, PACKET_LEN};

use crate::outcome::Outcome;
use crate::packet::{STOCK_WRITING_MM_S2, vector, writing};
use crate::rig::{Rig, Trouble};

/// A write vector without length: refused, or the end of the pose.
pub(crate) async fn no_length(rig: &mut Rig) -> Result<Outcome, Trouble> {
    rig.send(vector([0.0; 3], 0.0, 10.0)).await?;
    rig.react().await?;
    let (bytes, statuses) = (rig.raw.len(), rig.seen.len());
    rig.pass(500).await?;
    let lost = rig.raw[bytes..].windows(PACKET_LEN).any(tells_no_pose);
    let went_on = rig.seen.len() > statuses;
    Ok(Outcome::vote(
        went_on && !lost,
        lost,
        if lost {
            "the pose becomes NaN"
        } else {
            "nothing happens"
        },
    ))
}

/// An unknown state: refused, or the end of the queue.
pub(crate) async fn unknown_state(rig: &mut Rig) -> Result<Outcome, Trouble> {
    rig.send(Frame::ZERO).await?;
    for _ in 0..5 {
        rig.send(writing(STOCK_WRITING_MM_S2)).await?;
    }
    rig.react().await?;
    let bytes = rig.raw.len();
    rig.pass(1000).await?;
    let hangs = rig.raw.len() == bytes;
    Ok(Outcome::vote(
        !hangs,
        hangs,
        if hangs {
            "what comes after it waits for ever"
        } else {
            "what comes after it is done"
        },
    ))
}

/// Whether a window is a status whose X is not a number.
fn tells_no_pose(window: &[u8]) -> bool {
    let window: Result<&[u8; PACKET_LEN], _> = window.try_into();
    let frame = window.ok().and_then(Frame::from_bytes);
    frame.is_some_and(|it| it.float(1).is_nan())
}
