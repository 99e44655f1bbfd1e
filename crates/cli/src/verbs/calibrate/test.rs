//! `dobot calibrate --test`: measures the repeatability of an arm (ISO 9283).

use std::io::IsTerminal;

use anyhow::{anyhow, bail};
use dobot_arm::{Position, Tool};
use dobot_calibrate::{Repeatability, SHEET_POINTS, repeatability};
use dobot_host::StationClient;
use dobot_wire::{MoveTo, MovingMode, single};

use crate::connect::To;
use crate::control::{self, check_pose, line_entered, run_command, take_control};
use crate::failure::Failure;
use crate::output;

/// Parses the number of moves of a test.
pub(crate) fn times(text: &str) -> anyhow::Result<u32> {
    match text.parse() {
        Ok(times) if (2..=100).contains(&times) => Ok(times),
        _ => bail!("expected 2 to 100; ISO 9283 uses 30"),
    }
}

/// Moves to the middle of the sheet repeatedly from different sides, and prints the repeatability. The position of a
/// virtual arm in this process is known; with a real one a person reads a gauge.
pub(super) async fn test(station: &mut StationClient, to: &To, times: u32) -> Result<(), Failure> {
    let is_known = station.virtual_arm().is_some();
    if !is_known && !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("reading the gauge needs a terminal"),
            "run it in a terminal",
        ));
    }
    check_pose(station, to.pose_confirmed).await?;
    take_control(station).await?;
    let z_mm = f64::from(control::status(station).await?.z_mm);
    let [x_mm, y_mm] = SHEET_POINTS[0];
    let place = Position::new(x_mm, y_mm, z_mm);
    if !is_known {
        output::line(&format!(
            "The tip moves to {x_mm}, {y_mm} at this height {times} times, from different sides. Place a gauge there, and \
             enter its reading each time, in millimetres: one number, or x, y and z."
        ))?;
    }
    let mut attained = Vec::new();
    for time in 0..times {
        run_command(station, line(beside(place, time)).into()).await?;
        run_command(station, line(place).into()).await?;
        control::wait_for_rest(station).await?;
        attained.push(match true_position(station) {
            Some(place) => place,
            None => read(time + 1).await?,
        });
    }
    let found = repeatability(&attained).ok_or_else(|| anyhow!("one position is not enough"))?;
    let Repeatability {
        mean_mm,
        spread_mm,
        rp_mm,
    } = found;
    Ok(output::line(&format!(
        "repeatability RP {rp_mm:.3} mm (ISO 9283: mean {mean_mm:.3} + 3 x {spread_mm:.3}), {times} times from all sides"
    ))?)
}

fn line(to: Position) -> MoveTo {
    MoveTo::to(single(to.x.0), single(to.y.0), single(to.z.0)).with_mode(MovingMode::MovL)
}

/// A position beside and above, on a different side each time.
fn beside(place: Position, time: u32) -> Position {
    let (sin, cos) = (f64::from(time) * SIDES_DEG).to_radians().sin_cos();
    place
        + Position::new(
            BESIDE_MM * cos,
            BESIDE_MM * sin,
            ABOVE_MM * f64::from(time % 3),
        )
}

/// The true position of a virtual arm's tip.
fn true_position(station: &StationClient) -> Option<[f64; 3]> {
    let arm = station.virtual_arm()?;
    let joints = arm.mechanics().joints_at(arm.now());
    let at = dobot_arm::forward(&joints, Tool::SuctionCup).position;
    Some([at.x.0, at.y.0, at.z.0])
}

/// Reads the gauge from the person.
async fn read(time: u32) -> Result<[f64; 3], Failure> {
    loop {
        output::line(&format!("{time}: reading of the gauge?"))?;
        let Some(line) = line_entered().await else {
            return Err(anyhow!("nothing was entered").into());
        };
        match reading(&line) {
            Some(place) => return Ok(place),
            None => output::line("expected one number or three, in millimetres")?,
        }
    }
}

fn reading(line: &str) -> Option<[f64; 3]> {
    let words = line.split([' ', ',', '\t']).map(str::trim);
    let numbers: Option<Vec<f64>> = words.filter(|word| !word.is_empty()).map(number).collect();
    match *numbers? {
        [along] => Some([along, 0.0, 0.0]),
        [x, y, z] => Some([x, y, z]),
        _ => None,
    }
}

fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|mm: &f64| mm.abs() < 1000.0)
}

/// The angle between two sides, so that the first hundred sides all differ.
const SIDES_DEG: f64 = 137.508;
const BESIDE_MM: f64 = 20.0;
const ABOVE_MM: f64 = 5.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gauge_is_read_as_one_number_or_three() {
        assert_eq!(reading(" 0.12\n"), Some([0.12, 0.0, 0.0]));
        assert_eq!(reading("0.1, -0.2 3"), Some([0.1, -0.2, 3.0]));
        for wrong in ["", "x", "1 2", "1 2 3 4", "nan", "1e9"] {
            assert_eq!(reading(wrong), None, "{wrong:?}");
        }
    }
}
