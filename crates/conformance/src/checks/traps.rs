//! Traps of stock arms (note N34), which only a reset cures: for virtual arms, and last of all.

use dobot_wire::{Frame, PACKET_LEN};

use crate::outcome::Outcome;
use crate::packet::{STOCK_WRITING_MM_S2, vector, writing};
use crate::rig::{CheckError, Rig, has_nan_pose};

/// A write vector without length: refused, or the end of the pose.
pub(crate) async fn no_length(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(vector([0.0; 3], 0.0, 10.0)).await?;
    rig.react().await?;
    let (bytes, statuses) = (rig.raw.len(), rig.seen.len());
    rig.pass(500).await?;
    let lost = has_nan_pose(&rig.raw[bytes..]);
    let went_on = rig.seen.len() > statuses;
    Ok(Outcome::vote(
        went_on && !lost,
        lost,
        if lost {
            "the pose becomes NaN"
        } else {
            "there is no effect"
        },
    ))
}

/// An unknown state: refused, or the end of the queue.
pub(crate) async fn unknown_state(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(Frame::ZERO).await?;
    for _ in 0..QUEUE {
        rig.send(writing(STOCK_WRITING_MM_S2)).await?;
    }
    rig.react().await?;
    let bytes = rig.raw.len();
    rig.pass(1000).await?;
    // Counted in bytes, because the pose may be NaN.
    let statuses = (rig.raw.len() - bytes) / PACKET_LEN;
    let hangs = if rig.is_bluetooth() {
        statuses <= MESSAGES_PER_S
    } else {
        statuses == 0
    };
    Ok(Outcome::vote(
        !hangs,
        hangs,
        if hangs {
            "the following commands wait forever"
        } else {
            "the following commands are executed"
        },
    ))
}

/// As many commands as may wait (note N40): not one status that permits another follows.
const QUEUE: usize = 6;
/// The messages over Bluetooth, which go on while the queue is full; the permits are six more (note N38).
const MESSAGES_PER_S: usize = 14;
