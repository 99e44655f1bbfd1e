//! JUMP (`MovingMode` 0): up, across and down.

use dobot_wire::Status;

use crate::outcome::Outcome;
use crate::packet::{JUMP_MM, playback, point};
use crate::rig::{CheckError, Rig, moved, off};
use crate::timed_status::TimedStatus;

/// A JUMP of 6 mm, 5 mm high.
pub(crate) async fn lifts(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let goal = moved(&home, [0.0, 6.0, 0.0]);
    let (there, seen) = rig.carry_out(point(goal, 0.0, &home)).await?;
    let heights = seen.iter().map(|timed| timed.status.z_mm - home.z_mm);
    let height = heights.fold(0.0, f32::max);
    let off = off(&there, goal);
    Ok(Outcome::of(
        off < NEAR_MM && (height - JUMP_MM).abs() < 0.3,
        format!("{height:.2} mm up, as set 5; {off:.3} mm off the point"),
    ))
}

/// A JUMP to a higher place. By the document it goes across above the higher end, on a stock arm from
/// as far above the one end to as far above the other.
pub(crate) async fn across(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let goal = moved(&home, [0.0, WIDE_MM, RISE_MM]);
    // So slow that some statuses tell of the way across.
    rig.send(playback([5.0, 25.0], [20.0, 100.0], 0.0, JUMP_MM))
        .await?;
    let (there, seen) = rig.carry_out(point(goal, 0.0, &home)).await?;
    rig.be_gentle().await?;
    let places = seen.iter().filter_map(|it| Across::of(&home, it));
    let places: Vec<_> = places.collect();
    let Some((first, last)) = places.first().zip(places.last()) else {
        return Ok(Outcome::Differs("no status shows the traverse".into()));
    };
    let arrived = off(&there, goal) < NEAR_MM;
    let few = places.len() < FEW;
    let along = |height: fn(f32) -> f32| {
        let mut places = places.iter();
        arrived && !few && places.all(|it| (it.height_mm - height(it.share)).abs() < SLACK_MM)
    };
    Ok(Outcome::vote(
        along(|_| RISE_MM + JUMP_MM),
        along(|share| RISE_MM * share + JUMP_MM),
        format!(
            "{} statuses across, from {:.2} to {:.2} mm above the start, {:.3} mm off the point",
            places.len(),
            first.height_mm,
            last.height_mm,
            off(&there, goal)
        ),
    ))
}

/// Where a JUMP is on its way across.
#[derive(Clone, Copy, Debug)]
struct Across {
    /// Of the way across, 0 to 1.
    share: f32,
    /// Above the start.
    height_mm: f32,
}

impl Across {
    /// `None` above the ends: up and down are not quite upright on a stock arm.
    fn of(home: &Status, seen: &TimedStatus) -> Option<Self> {
        let share = (seen.status.y_mm - home.y_mm) / WIDE_MM;
        (0.1..0.9).contains(&share).then_some(Self {
            share,
            height_mm: seen.status.z_mm - home.z_mm,
        })
    }
}

const WIDE_MM: f32 = 6.0;
const RISE_MM: f32 = 4.0;
const NEAR_MM: f64 = 0.05;
/// Between the two dialects lie up to 3.6 mm.
const SLACK_MM: f32 = 0.3;
/// Statuses below which the way across is not known.
const FEW: usize = 3;
