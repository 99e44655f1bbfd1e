//! Hand guidance: gesture, mouse and voice (states 8, 1 and 5).

use dobot_wire::{Frame, Status, Voice};

use crate::checks::settings::reach_of;
use crate::outcome::Outcome;
use crate::rig::{CheckError, Rig, distance, moved, off};

/// A hand position: the place itself, or a scaled one in front of the arm.
pub(crate) async fn gesture(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let goal = moved(&home, [3.0, 4.0, 5.0]);
    let hand = match rig.leaning() {
        Some(0) => goal,
        Some(_) if rig.options.fresh => scaled(goal),
        Some(_) => {
            return Ok(Outcome::NotTried(
                "a stock arm mixes in old hand positions: where it would move is unknown".into(),
            ));
        }
        None => return Ok(undecided()),
    };
    let [x, y, z] = hand;
    let frame = Frame::ZERO.with(1, 8.0).with(3, x).with(4, y).with(5, z);
    let (there, _) = rig.carry_out(frame).await?;
    rig.be_gentle().await?;
    let off = off(&there, goal);
    let specification = rig.leaning() == Some(0);
    Ok(Outcome::vote(
        specification && off < NEAR_MM,
        // A stock arm stops up to a fifth short of the way.
        !specification && off < distance(&home, &there).max(5.0) * 0.35,
        format!("{off:.2} mm off the position of the hand"),
    ))
}

/// The hand position that moves a stock arm to a position right after power-up.
fn scaled([x, y, z]: [f32; 3]) -> [f32; 3] {
    [(x - 230.0) * 4.0, y * 2.0, (z + 30.0) * 2.0 + 200.0]
}

/// Increments: millimetres of Y, X and Z, or a swing of the base, reach and height.
pub(crate) async fn mouse(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let turn = match rig.leaning() {
        Some(0) => home.rotation_deg,
        Some(_) => home.servo_deg,
        None => return Ok(undecided()),
    };
    if home.z_mm < MIN_Z_MM {
        return Ok(Outcome::NotTried(format!(
            "a stock arm would rise to -30 mm at once: put it above {MIN_Z_MM:.0} mm"
        )));
    }
    let [y, x, z] = [4.0, 3.0, 5.0];
    let frame = Frame::ZERO
        .with(1, 1.0)
        .with(3, y)
        .with(4, x)
        .with(5, z)
        .with(6, turn);
    let (there, _) = rig.carry_out(frame).await?;
    rig.be_gentle().await?;
    let by = |value: f64, expected: f64| (value - expected).abs() < NEAR_MM;
    let rise = f64::from(there.z_mm - home.z_mm);
    let swing = f64::from(there.base_deg - home.base_deg);
    let reach = reach_of(&there) - reach_of(&home);
    let swings = by(swing, -0.225 * f64::from(y)) && by(reach, 0.4 * f64::from(x));
    Ok(Outcome::vote(
        off(&there, moved(&home, [x, y, z])) < NEAR_MM,
        swings && by(rise, 0.4 * f64::from(z)),
        format!(
            "4, 3, 5 move by {:.2}, {:.2}, {rise:.2} mm: {reach:.2} mm of reach, {swing:.2} degrees of the base",
            there.x_mm - home.x_mm,
            there.y_mm - home.y_mm,
        ),
    ))
}

/// A voice command, which a stock arm receives on its Bluetooth port only.
pub(crate) async fn voice(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let Ok(order) = Voice::new("up five") else {
        return Ok(Outcome::NotTried(
            "the voice command does not fit a packet".into(),
        ));
    };
    rig.send_raw(&order.to_bytes()).await?;
    let there: Status = rig.settled().await?;
    let heard = off(&there, moved(&home, [0.0, 0.0, 5.0])) < NEAR_MM;
    Ok(if heard {
        Outcome::Holds("\"up five\" moves 5 mm up".into())
    } else if distance(&home, &there) < NEAR_MM && rig.is_bluetooth() {
        Outcome::Differs("it ignores voice, which a stock arm obeys over Bluetooth".into())
    } else if distance(&home, &there) < NEAR_MM {
        Outcome::Firmware11("it ignores voice, as a stock arm on USB".into())
    } else {
        Outcome::Differs(format!(
            "\"up five\" moves {:.2} mm up, {:.2} mm in all",
            there.z_mm - home.z_mm,
            distance(&home, &there)
        ))
    })
}

fn undecided() -> Outcome {
    Outcome::NotTried("the dialect is mixed: where it would move is unknown".into())
}

const NEAR_MM: f64 = 0.05;
/// A stock arm keeps a mouse above -30 mm.
const MIN_Z_MM: f32 = -28.0;
