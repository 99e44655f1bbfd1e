//! Configuration: settings and their later effects.

use dobot_arm::Tool;
use dobot_wire::{Frame, Status};

use crate::checks::jog::steady_speed;
use crate::observed_motion::ObservedMotion;
use crate::outcome::Outcome;
use crate::packet::{
    LASER, STOCK_TEACH_DEG_S, STOCK_WRITING_MM_S2, SUCTION_CUP, angles as to_angles, configuration,
    percent, playback, point, teach, tool as tool_packet, vector, writing as acceleration,
};
use crate::rig::{CheckError, Rig, distance, moved, off};

/// Another end effector: X and Y change by 5.5 mm of reach, and nothing moves.
pub(crate) async fn tool(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let before = rig.settled().await?;
    show_tool(rig, false).await?;
    let other = rig.settled().await?;
    show_tool(rig, true).await?;
    let again = rig.settled().await?;
    let sign = if rig.tool() == Tool::Laser { 1.0 } else { -1.0 };
    let by = reach_of(&other) - reach_of(&before);
    let still = (other.z_mm - before.z_mm).abs() < 0.01 && other.rear_deg == before.rear_deg;
    let changes = (by - sign * TOOLS_MM).abs() < 0.02;
    let left = distance(&before, &again);
    let expected = sign * TOOLS_MM;
    let found = if still && changes && left >= 0.02 {
        format!("the reach changes by {by:.3} mm at once, but not back: {left:.3} mm are left")
    } else if still {
        format!("the reach changes by {by:.3} mm at once; {expected:.3} expected")
    } else {
        "the arm moves or reports a motion".into()
    };
    Ok(Outcome::of(still && changes && left < 0.02, found))
}

/// The packet that sets the end effector that the arm does not have.
pub(crate) fn other_tool(rig: &Rig) -> Frame {
    tool_frame(rig, false)
}

/// The packet that sets the end effector: the arm's own, or the other one.
pub(crate) fn tool_frame(rig: &Rig, own: bool) -> Frame {
    let is_laser = (rig.tool() == Tool::Laser) == own;
    tool_packet(if is_laser { LASER } else { SUCTION_CUP })
}

/// Sets the end effector: the arm's own, or the other one.
pub(crate) async fn show_tool(rig: &mut Rig, own: bool) -> Result<(), CheckError> {
    rig.send(tool_frame(rig, own)).await
}

pub(crate) fn reach_of(status: &Status) -> f64 {
    dobot_session::position(status).reach().0
}

/// The joint speed of teaching, and the share of it that a jog asks for.
pub(crate) async fn jog(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(teach(24.0)).await?;
    let speed = steady_speed(rig, 20.0).await?;
    rig.send(teach(STOCK_TEACH_DEG_S)).await?;
    Ok(Outcome::of(
        (speed - 4.8).abs() < 0.24,
        format!("20 % of 24 degrees/s are {speed:.2}; 4.8 expected"),
    ))
}

/// Slow moves take as long as they should, straight or by joints.
pub(crate) async fn moves(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(playback([2.0, 20.0], [10.0, 100.0], 0.0, 5.0))
        .await?;
    let home = rig.home()?;
    let goal = Status {
        base_deg: home.base_deg + TURN_DEG,
        ..home
    };
    let (there, seen) = rig.carry_out(to_angles(&goal, 1.0)).await?;
    rig.be_gentle().await?;
    let took = ObservedMotion::new(&seen).duration_s();
    // Half of what was set (50 %): 1 degree/s and 10 degrees/s², or 5 mm/s and 50 mm/s².
    let joints = trapezoid_s(TURN_DEG.into(), 1.0, 10.0);
    let line = trapezoid_s(distance(&home, &there), 5.0, 50.0);
    let holds = [joints, line]
        .iter()
        .any(|expected| (took - expected).abs() < SLACK_S);
    Ok(Outcome::of(
        holds,
        format!(
            "a slow move took {took:.2} s; {joints:.2} by joints or {line:.2} in a line expected"
        ),
    ))
}

/// A vector with a low acceleration takes as long as it should.
pub(crate) async fn writing(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(acceleration(20.0)).await?;
    let (_, seen) = rig.carry_out(vector([0.0, 5.0, 0.0], 0.0, 20.0)).await?;
    rig.send(acceleration(STOCK_WRITING_MM_S2)).await?;
    let took = ObservedMotion::new(&seen).duration_s();
    let expected = trapezoid_s(5.0, 20.0, 20.0);
    Ok(Outcome::of(
        (took - expected).abs() < SLACK_S,
        format!("5 mm with 20 mm/s² took {took:.2} s; {expected:.2} expected"),
    ))
}

/// The initial angles. They make the base angle 0 too, so the base is turned to 0 before.
pub(crate) async fn angles(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    if home.base_deg.abs() > ROOM_DEG {
        return Ok(Outcome::NotTried(format!(
            "it makes the base angle 0, which is {:.1} degrees: put it within {ROOM_DEG} of 0",
            home.base_deg
        )));
    }
    let level = Status {
        base_deg: 0.0,
        ..home
    };
    let before = rig.go_to(&level).await?;
    // One degree more or less, so that `rear` and `90 - rear` differ.
    let by = if before.rear_deg < 45.0 { -1.0 } else { 1.0 };
    let sent_deg = before.rear_deg + by;
    let after = set_angles(rig, sent_deg, &before).await?;
    let is = |rear: f32| (after.rear_deg - rear).abs() < 0.01;
    let (document, stock) = (is(sent_deg), is(90.0 - sent_deg));
    if document || stock {
        let rear = before.rear_deg;
        let back = if stock { 90.0 - rear } else { rear };
        // A command may get lost, and untrue angles would end everything.
        for _ in 0..3 {
            if (set_angles(rig, back, &before).await?.rear_deg - rear).abs() <= 0.001 {
                break;
            }
        }
    }
    if (rig.settled().await?.rear_deg - before.rear_deg).abs() > 0.001 {
        return Err(CheckError::Untrue);
    }
    let found = format!(
        "float 3 of {sent_deg:.3} makes the rear arm {:.3} degrees, from {:.3}",
        after.rear_deg, before.rear_deg
    );
    Ok(Outcome::vote(document, stock, found))
}

/// Sends initial angles: float 3, and the current forearm angle.
async fn set_angles(rig: &mut Rig, float_3: f32, now: &Status) -> Result<Status, CheckError> {
    let packet = configuration(3.0, &[float_3, now.fore_deg]);
    Ok(rig.carry_out(packet).await?.0)
}

/// Which of the two percentages slows a move down: that of the speed leaves a move with one speed
/// for most of its time, that of the acceleration one that only gathers speed and loses it.
pub(crate) async fn percentages(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(playback([5.0, 25.0], [20.0, 100.0], 0.0, 5.0))
        .await?;
    rig.send(percent(100.0, 20.0)).await?;
    let home = rig.home()?;
    let goal = moved(&home, [0.0, 8.0, 0.0]);
    let (there, seen) = rig.carry_out(point(goal, 1.0, &home)).await?;
    rig.be_gentle().await?;
    rig.send(percent(50.0, 50.0)).await?;
    let way = ObservedMotion::new(&seen);
    let mean = distance(&home, &there) / way.duration_s().max(0.01);
    let ratio = way.peak_mm_s() / mean;
    let arrived = off(&there, goal) < 0.1;
    Ok(Outcome::vote(
        arrived && ratio < 1.35,
        arrived && (1.55..2.4).contains(&ratio),
        if arrived {
            format!("100 and 20: the move is {ratio:.2} times as fast at its peak as on average")
        } else {
            format!("100 and 20: the move ends {:.2} mm off", off(&there, goal))
        },
    ))
}

/// The duration of a motion from rest to rest.
pub(crate) fn trapezoid_s(length: f64, speed: f64, acceleration: f64) -> f64 {
    if length > speed * speed / acceleration {
        length / speed + speed / acceleration
    } else {
        2.0 * (length / acceleration).sqrt()
    }
}

/// A time that is counted in statuses may be off by two of them.
const SLACK_S: f64 = 0.17;
/// How much shorter the laser is (note N32).
const TOOLS_MM: f64 = 5.5;
/// How far the base may be from 0 for the check of the initial angles.
const ROOM_DEG: f32 = 2.0;
const TURN_DEG: f32 = 1.3;
