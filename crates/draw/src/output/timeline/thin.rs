//! Which moments are needed so that what lies between them can be told.

use crate::output::trace::{Ink, TracePoint};

/// The moments between which the tool goes straight and evenly: what is left out is never farther
/// than 0.05 mm from where it would be at that time, and its error no more than 0.02 mm from what
/// it would be. Where ink begins and ends is told exactly.
pub(super) fn thin(moments: &[TracePoint]) -> impl Iterator<Item = &TracePoint> {
    let mut next = Some(0);
    std::iter::from_fn(move || {
        let here = next?;
        next = (here + 1 < moments.len()).then(|| last_before_a_bend(moments, here));
        moments.get(here)
    })
}

/// The farthest moment to which the way from `here` may be told as straight.
fn last_before_a_bend(moments: &[TracePoint], here: usize) -> usize {
    let most = (moments.len() - 1).min(here + MOST);
    let mut last = here + 1;
    while last < most
        && goes_on(&moments[last], &moments[last + 1])
        && is_straight(&moments[here..=last + 1])
    {
        last += 1;
    }
    last
}

/// Whether nothing begins or ends here.
fn goes_on(here: &TracePoint, next: &TracePoint) -> bool {
    here.ink == next.ink && here.ink != Ink::Begin
}

fn is_straight(way: &[TracePoint]) -> bool {
    let (from, to) = (&way[0], &way[way.len() - 1]);
    // A line begins with the error of its first point, whatever the way there was.
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

/// So many moments are looked at at most: a row each 1.3 seconds is little enough.
const MOST: usize = 64;
const WAY_MM: f64 = 0.05;
const ERROR_MM: f64 = 0.02;
