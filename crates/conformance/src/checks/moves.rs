//! Targets: points and joint angles (states 3 and 6).

use dobot_wire::Status;

use crate::checks::settings::show_tool;
use crate::observed_motion::ObservedMotion;
use crate::outcome::Outcome;
use crate::packet::{
    JUMP_MM, STOCK_TEACH_DEG_S, STOCK_WRITING_MM_S2, angles, gentle, percent, playback, point,
    teach, writing,
};
use crate::rig::{CheckError, Rig, distance, moved, off, turned};

/// Sets slow speeds and lifts the arm to the home position.
pub(crate) async fn lift(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let start = rig.start.ok_or(CheckError::Homeless)?;
    rig.settings().await?;
    let above = moved(&start, [0.0, 0.0, LIFT_MM]);
    rig.moved = true;
    let (there, _) = rig.carry_out(point(above, 1.0, &start)).await?;
    let off = off(&there, above);
    if off < NEAR_MM {
        rig.home = Some(there);
    }
    Ok(Outcome::of(
        off < NEAR_MM,
        format!("{off:.3} mm off the point"),
    ))
}

/// Moves to one point by mode 1 and by mode 2 to find the straight one.
pub(crate) async fn modes(rig: &mut Rig) -> Result<Outcome, CheckError> {
    // So slow that some statuses tell of the way, and never at the largest speed: where one joint
    // reaches it and the others do not, a stock arm strays from the way of all joints together.
    rig.send(playback([200.0, 20.0], [200.0, 60.0], 0.0, JUMP_MM))
        .await?;
    let first = straight(rig, 1.0).await?;
    rig.go_home().await?;
    let second = straight(rig, 2.0).await?;
    rig.be_gentle().await?;
    rig.joint_mode = match (first, second) {
        (Some(false), Some(true)) => Some(1.0),
        (Some(true), Some(false)) => Some(2.0),
        _ => None,
    };
    let word = |path| match path {
        Some(true) => "straight",
        Some(false) => "by joints",
        None => "neither straight nor by joints",
    };
    Ok(Outcome::vote(
        (first, second) == (Some(true), Some(false)),
        (first, second) == (Some(false), Some(true)),
        format!("1 goes {}, 2 {}", word(first), word(second)),
    ))
}

/// Whether a mode is straight, by joints or neither.
async fn straight(rig: &mut Rig, mode: f32) -> Result<Option<bool>, CheckError> {
    let home = rig.home()?;
    let goal = moved(&home, [-4.0, 7.0, 5.0]);
    let (there, seen) = rig.carry_out(point(goal, mode, &home)).await?;
    let way = ObservedMotion::new(&seen);
    let (line, joints) = (way.off_line_mm(), way.off_joints_mm(rig.tool()));
    if off(&there, goal) > NEAR_MM {
        return Ok(None);
    }
    Ok(match (line < ON_THE_WAY_MM, joints < ON_THE_WAY_MM) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    })
}

/// Joint angles by mode 1, and back by mode 2.
pub(crate) async fn joints(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let there = Status {
        base_deg: home.base_deg + 1.5,
        rear_deg: home.rear_deg - 1.5,
        fore_deg: home.fore_deg - 1.0,
        servo_deg: home.servo_deg + 4.0,
        ..home
    };
    let mut worst = 0.0_f32;
    let mut now = home;
    for (goal, mode) in [(there, 1.0), (home, 2.0)] {
        // Where the first got lost, the second would be a line without length (note N34).
        if turned(&now, &goal) < 1.0 {
            break;
        }
        (now, _) = rig.carry_out(angles(&goal, mode)).await?;
        worst = worst.max(turned(&now, &goal));
    }
    Ok(Outcome::of(worst < 0.02, format!("{worst:.4} degrees off")))
}

/// A pause of one second between two moves.
pub(crate) async fn pause(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let rest = rest_s(rig, 1.0).await?;
    Ok(Outcome::of(
        (rest - 1.0).abs() < 0.17,
        format!("set to 1 s, it waited {rest:.2} s"),
    ))
}

/// The pause of 9/1 for moves without their own pause.
pub(crate) async fn default_pause(rig: &mut Rig) -> Result<Outcome, CheckError> {
    rig.send(gentle(0.8)).await?;
    let rest = rest_s(rig, 0.0).await?;
    rig.be_gentle().await?;
    Ok(Outcome::vote(
        (rest - 0.8).abs() < 0.17,
        rest < 0.3,
        format!("set to 0.8 s, a move without one waited {rest:.2} s"),
    ))
}

/// The rest time after a move with this pause, before a second move.
async fn rest_s(rig: &mut Rig, pause_s: f32) -> Result<f64, CheckError> {
    let home = rig.home()?;
    let mark = rig.seen.len();
    let points = [[0.0, 3.0, 0.0], [0.0, 3.0, 3.0]].map(|by| moved(&home, by));
    for (goal, pause_s) in points.into_iter().zip([pause_s, 0.0]) {
        rig.send(point(goal, 1.0, &home).with(10, pause_s)).await?;
    }
    // The arm rests in between: wait for the second point.
    let until = rig.now() + std::time::Duration::from_secs(6);
    while off(&rig.next_status().await?, points[1]) > NEAR_MM && rig.now() < until {}
    rig.settled().await?;
    Ok(ObservedMotion::new(&rig.seen[mark..]).rest_s(points[0]))
}

/// Pump and gripper, once there.
pub(crate) async fn tool(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let grabbing = Status {
        suction: true,
        gripper_deg: home.gripper_deg + 5.0,
        ..home
    };
    let goal = moved(&home, [0.0, 4.0, 0.0]);
    let mark = rig.seen.len();
    rig.send(point(goal, 1.0, &grabbing).with(10, 0.2)).await?;
    rig.settled().await?;
    rig.pass(300).await?;
    let there = rig.next_status().await?;
    let mut on_the_way = rig.seen[mark..].iter().map(|timed| &timed.status);
    let early = on_the_way.any(|it| it.suction && off(it, goal) > NEAR_MM);
    rig.send(angles(&home, 1.0)).await?;
    // A stock arm takes it up only when its pause is over once more (note N47).
    rig.expect_later(300);
    rig.settled().await?;
    let back = rig.next_status().await?;
    let gripper = there.gripper_deg - home.gripper_deg;
    let set = there.suction && (gripper - 5.0).abs() < 0.01;
    let reset = !back.suction && (back.gripper_deg - home.gripper_deg).abs() < 0.01;
    let word = |on| if on { "on" } else { "off" };
    Ok(Outcome::of(
        set && reset && !early,
        format!(
            "pump {}{}, gripper by {gripper:.3} degrees (sent: on, 5.000), then {} and {:.3}",
            word(there.suction),
            if early { " too early" } else { "" },
            word(back.suction),
            back.gripper_deg - home.gripper_deg,
        ),
    ))
}

/// Returns to the start and restores the power-up settings of a stock arm.
pub(crate) async fn back(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let start = rig.start.ok_or(CheckError::Homeless)?;
    rig.be_gentle().await?;
    show_tool(rig, true).await?;
    let there = rig.go_to(&start).await?;
    let jump_mm = if rig.leaning() == Some(1) { 10.0 } else { 20.0 };
    for packet in [
        playback([200.0, 200.0], [100.0, 200.0], 0.0, jump_mm),
        teach(STOCK_TEACH_DEG_S),
        writing(STOCK_WRITING_MM_S2),
        percent(50.0, 50.0),
    ] {
        rig.send(packet).await?;
    }
    let off = distance(&there, &start);
    Ok(Outcome::of(
        off < NEAR_MM,
        format!("{off:.3} mm off; speeds and percentages are those of power-up"),
    ))
}

const LIFT_MM: f32 = 10.0;
const NEAR_MM: f64 = 0.05;
/// The distance of statuses from the path of the arm; the two paths are at least 0.05 mm apart.
const ON_THE_WAY_MM: f64 = 0.006;
