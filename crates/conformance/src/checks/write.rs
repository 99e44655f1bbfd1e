//! Write vectors (state 4).

use crate::checks::settings::trapezoid_s;
use crate::observed_motion::ObservedMotion;
use crate::outcome::Outcome;
use crate::packet::{STOCK_WRITING_MM_S2, vector as vector_packet, writing};
use crate::rig::{CheckError, Rig, distance, moved, off};

/// A vector along all axes: where does it lead, and is it straight?
pub(crate) async fn vector(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let packet = vector_packet([5.0, 4.0, 3.0], 0.0, 10.0);
    let (there, seen) = rig.carry_out(packet).await?;
    let strays = ObservedMotion::new(&seen).off_line_mm();
    let straight = strays < 0.02;
    let leads = |by| straight && off(&there, moved(&home, by)) < 0.05;
    let [x, y, z] = [
        there.x_mm - home.x_mm,
        there.y_mm - home.y_mm,
        there.z_mm - home.z_mm,
    ];
    Ok(Outcome::vote(
        leads([5.0, 4.0, 3.0]),
        leads([-5.0, 4.0, 3.0]),
        format!(
            "5, 4, 3 mm lead by {x:.2}, {y:.2}, {z:.2} mm, off a straight line by up to {strays:.3}"
        ),
    ))
}

/// A vector that is to start with its largest speed and end at rest.
pub(crate) async fn start_speed(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    rig.send(writing(10.0)).await?;
    let packet = vector_packet([0.0, 4.5, 0.0], 9.0, 9.0);
    let (there, seen) = rig.carry_out(packet).await?;
    rig.send(writing(STOCK_WRITING_MM_S2)).await?;
    let way = ObservedMotion::new(&seen);
    let (mean, took) = (way.mean_progress().unwrap_or_default(), way.duration_s());
    let length = distance(&home, &there);
    let arrived = (length - 4.5).abs() < 0.05;
    // Braking all the way, two thirds of it are covered on average; from rest to rest, one half.
    let from_rest = trapezoid_s(4.5, 9.0, 10.0);
    Ok(Outcome::vote(
        arrived && mean > 0.60,
        arrived && (0.45..0.55).contains(&mean) && (took - from_rest).abs() < 0.2,
        format!(
            "{length:.2} mm in {took:.2} s, {:.1} % of the way covered on average: {}",
            mean * 100.0,
            if mean > 0.58 {
                "it starts fast"
            } else {
                "it starts from rest"
            }
        ),
    ))
}

/// A vector that float 6 stops.
pub(crate) async fn stop(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let packet = vector_packet([0.0, 4.0, 0.0], 0.0, 10.0).with(6, 1.0);
    let (there, _) = rig.carry_out(packet).await?;
    let moved = distance(&there, &home);
    Ok(Outcome::of(moved < 0.02, format!("it moved {moved:.3} mm")))
}
