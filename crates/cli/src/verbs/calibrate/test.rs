//! `dobot calibrate --test`: how well an arm finds the same place again, as ISO 9283 defines it.

use std::io::IsTerminal;

use anyhow::{anyhow, bail};
use dobot_arm::{Position, Tool};
use dobot_calibrate::{Repeatability, SHEET_POINTS, repeatability};
use dobot_host::StationClient;
use dobot_wire::{MoveTo, MovingMode, single};

use crate::connect::To;
use crate::control::{self, carry_out, check_pose, line_entered, take_control};
use crate::failure::Failure;
use crate::output;

/// How often a test goes to its place.
pub(crate) fn times(text: &str) -> anyhow::Result<u32> {
    match text.parse() {
        Ok(times) if (2..=100).contains(&times) => Ok(times),
        _ => bail!("allowed are 2 to 100; ISO 9283 has 30"),
    }
}

/// Goes to the middle of the sheet again and again, each time from another side, and tells how far apart it comes.
/// Of a virtual arm in this process it is known where it is; at a real one a person reads a gauge.
pub(super) async fn test(station: &mut StationClient, to: &To, times: u32) -> Result<(), Failure> {
    let is_seen = station.virtual_arm().is_some();
    if !is_seen && !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("nobody is there to read the gauge"),
            "run it in a terminal",
        ));
    }
    check_pose(station, to.pose_confirmed).await?;
    take_control(station).await?;
    let z_mm = f64::from(control::status(station).await?.z_mm);
    let [x_mm, y_mm] = SHEET_POINTS[0];
    let place = Position::new(x_mm, y_mm, z_mm);
    if !is_seen {
        output::line(&format!(
            "The tip goes to {x_mm}, {y_mm} at this height, {times} times, each time from another side. Set a gauge there; \
             enter what it reads each time, in millimetres: one number, or x, y and z."
        ))?;
    }
    let mut attained = Vec::new();
    for time in 0..times {
        carry_out(station, line(beside(place, time)).into()).await?;
        carry_out(station, line(place).into()).await?;
        control::rest(station).await?;
        attained.push(match seen(station) {
            Some(place) => place,
            None => read(time + 1).await?,
        });
    }
    let found = repeatability(&attained).ok_or_else(|| anyhow!("one place alone tells nothing"))?;
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

/// A place beside and above, on another side each time.
fn beside(place: Position, time: u32) -> Position {
    let (sin, cos) = (f64::from(time) * SIDES_DEG).to_radians().sin_cos();
    place
        + Position::new(
            BESIDE_MM * cos,
            BESIDE_MM * sin,
            ABOVE_MM * f64::from(time % 3),
        )
}

/// Where the tip of a virtual arm really is.
fn seen(station: &StationClient) -> Option<[f64; 3]> {
    let arm = station.virtual_arm()?;
    let joints = arm.mechanics().joints_at(arm.now());
    let at = dobot_arm::forward(&joints, Tool::SuctionCup).position;
    Some([at.x.0, at.y.0, at.z.0])
}

/// What a person reads.
async fn read(time: u32) -> Result<[f64; 3], Failure> {
    loop {
        output::line(&format!("{time}: what does the gauge read?"))?;
        let Some(line) = line_entered().await else {
            return Err(anyhow!("nothing was entered").into());
        };
        match reading(&line) {
            Some(place) => return Ok(place),
            None => output::line("expected are one number, or three, in millimetres")?,
        }
    }
}

fn reading(line: &str) -> Option<[f64; 3]> {
    let words = line.split([' ', ',', '\t']).map(str::trim);
    let numbers: Option<Vec<f64>> = words.filter(|it| !it.is_empty()).map(number).collect();
    match *numbers? {
        [along] => Some([along, 0.0, 0.0]),
        [x, y, z] => Some([x, y, z]),
        _ => None,
    }
}

fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|it: &f64| it.abs() < 1000.0)
}

/// Between one side and the next: no two of the first hundred are the same.
const SIDES_DEG: f64 = 137.508;
const BESIDE_MM: f64 = 20.0;
const ABOVE_MM: f64 = 5.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gauge_is_read_in_one_number_or_three() {
        assert_eq!(reading(" 0.12\n"), Some([0.12, 0.0, 0.0]));
        assert_eq!(reading("0.1, -0.2 3"), Some([0.1, -0.2, 3.0]));
        for wrong in ["", "x", "1 2", "1 2 3 4", "nan", "1e9"] {
            assert_eq!(reading(wrong), None, "{wrong:?}");
        }
    }
}
