//! Limits, if they can be tried safely.

use crate::outcome::Outcome;
use crate::packet::{jog as button, point};
use crate::rig::{CheckError, Rig, turned};

/// A point three times as far away. By joints a stock arm does not set out for it; in a straight
/// line it would, and lose its pose (note N34).
pub(crate) async fn far(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let Some(mode) = rig.joint_mode else {
        return Ok(Outcome::NotTried(
            "only a joint move is safe, and the joint mode is unknown".into(),
        ));
    };
    let beyond = [home.x_mm * 3.0, home.y_mm * 3.0, home.z_mm];
    let (there, _) = rig.carry_out(point(beyond, mode, &home)).await?;
    let moved = turned(&there, &home);
    Ok(Outcome::of(
        moved < 0.01,
        format!("it moved by {moved:.3} degrees"),
    ))
}

/// The servo is jogged to its end and beyond.
pub(crate) async fn jog(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(button(2.0, 7.0, 100.0)).await?;
    rig.pass(4000).await?;
    rig.send(button(2.0, 0.0, 0.0)).await?;
    let servo = rig.settled().await?.servo_deg;
    // Back at the same speed.
    rig.send(button(2.0, 8.0, 100.0)).await?;
    rig.pass(2500).await?;
    rig.send(button(2.0, 0.0, 0.0)).await?;
    Ok(Outcome::of(
        (89.0..=90.001).contains(&servo),
        format!("it stops at {servo:.2} degrees"),
    ))
}
