//! Selection of the moments that are needed to interpolate the others.

use crate::output::trace::{Ink, TracePoint};

/// Returns the moments between which the tool moves straight at constant speed: omitted moments are
/// within 0.05 mm of the interpolation, and their errors within 0.02 mm. Starts and ends of ink are
/// exact.
pub(super) fn thin(moments: &[TracePoint]) -> impl Iterator<Item = &TracePoint> {
    let mut next = Some(0);
    std::iter::from_fn(move || {
        let here = next?;
        next = (here + 1 < moments.len()).then(|| last_before_a_bend(moments, here));
        moments.get(here)
    })
}

/// Returns the farthest moment to which the path from `here` is straight enough.
fn last_before_a_bend(moments: &[TracePoint], here: usize) -> usize {
    let most = (moments.len() - 1).min(here + MAX_SKIPPED);
    let mut last = here + 1;
    while last < most
        && continues(&moments[last], &moments[last + 1])
        && is_straight(&moments[here..=last + 1])
    {
        last += 1;
    }
    last
}

/// Whether no line begins or ends here.
fn continues(here: &TracePoint, next: &TracePoint) -> bool {
    here.ink == next.ink && here.ink != Ink::Begin
}

fn is_straight(way: &[TracePoint]) -> bool {
    let (from, to) = (&way[0], &way[way.len() - 1]);
    // A line begins with the error of its first point, regardless of the travel before.
    let errs = from.ink != Ink::None && to.ink != Ink::None;
    let span_s = to.t_s - from.t_s;
    way.iter().all(|moment| {
        let share = if span_s > 0.0 {
            (moment.t_s - from.t_s) / span_s
        } else {
            1.0
        };
        let between = from.position + (to.position - from.position) * share;
        let error_mm = from.error_mm + (to.error_mm - from.error_mm) * share;
        between.distance(moment.position).0 <= WAY_MM
            && (!errs || (error_mm - moment.error_mm).abs() <= ERROR_MM)
    })
}

/// The maximum number of moments skipped: a row every 1.3 seconds is few enough.
const MAX_SKIPPED: usize = 64;
const WAY_MM: f64 = 0.05;
const ERROR_MM: f64 = 0.02;
