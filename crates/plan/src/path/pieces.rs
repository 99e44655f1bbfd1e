//! Division of long vectors into pieces.
//!
//! The protocol has no stop: an arm finishes all received vectors, so none should be long.
//!
//! ```text
//!   speed     _____________          the same motion in four packets. With ticks each piece is a number
//!     |     /|    |    |   \         of ticks, and none ends while the arm speeds up or brakes: it would
//!     |____/_|____|____|____\_ way   go on with another speed
//! ```

use std::iter;

use dobot_motion::{Profile, TickStroke};
use dobot_wire::single;

use crate::path::commands::write;
use crate::path::endpoint::Endpoint;
use crate::path::planner::round_down;
use crate::ticks::TICK_S;
use crate::ticks::tick_fit::{MIN_BURN_MM_S, MIN_END_MM_S, NEAR};
use crate::ticks::ticker::{Ticker, length};
use crate::{ArmLimits, DrawingTool, MoveKind, PlannedVector};

/// The maximum duration of a burning vector, in s, unless a stock arm only accelerates and brakes
/// in it.
pub const LONGEST_BURN_S: f64 = 0.18;
/// The maximum duration of a drawing pen's vector, in s.
pub const LONGEST_DRAW_S: f64 = 0.34;

/// Divides long vectors into pieces without changing paths, speeds and times.
pub(crate) struct Pieces {
    acceleration_mm_s2: f64,
    /// An arm with ticks executing the whole vectors, and one executing their pieces.
    arms: Option<[TickedArm; 2]>,
}

impl Pieces {
    /// Creates the divider for a plan that begins at this place.
    pub(crate) fn new(arm_limits: &ArmLimits, tool: &DrawingTool, start: [f64; 3]) -> Self {
        let arm = Ticker::of(arm_limits, 0.0).map(|ticker| TickedArm {
            ticker,
            endpoint: Endpoint::new(arm_limits, tool),
            here: start,
        });
        Self {
            acceleration_mm_s2: arm_limits.planned_acceleration_mm_s2(),
            arms: arm.map(|arm| [arm.clone(), arm]),
        }
    }

    /// Returns the pieces of the next vector.
    pub(crate) fn of(
        &mut self,
        vector: &PlannedVector,
        next: Option<&PlannedVector>,
    ) -> Vec<PlannedVector> {
        let longest_s = match vector.kind {
            MoveKind::Burn => LONGEST_BURN_S,
            MoveKind::Draw => LONGEST_DRAW_S,
            _ => f64::INFINITY,
        };
        let Some([planned, divided]) = &mut self.arms else {
            return of_time(vector, longest_s, self.acceleration_mm_s2);
        };
        let whole = planned.run(vector);
        let continues_alike = |pieces: &Vec<PlannedVector>| {
            let mut after = divided.clone();
            after.run_all(pieces);
            next.is_none_or(|next| is_alike(&planned.tick_stroke(next), &after.tick_stroke(next)))
        };
        let pieces =
            of_ticks(vector, longest_s, &whole, (divided, planned.here)).find(continues_alike);
        // A long vector is better than one after which the arm would deviate from the plan.
        let pieces = pieces.unwrap_or_else(|| vec![*vector]);
        divided.run_all(&pieces);
        pieces
    }
}

/// The state of an arm with ticks after some vectors.
#[derive(Clone)]
struct TickedArm {
    ticker: Ticker,
    endpoint: Endpoint,
    here: [f64; 3],
}

impl TickedArm {
    fn run(&mut self, vector: &PlannedVector) -> TickStroke {
        self.here = self.endpoint.after(self.here, vector);
        self.ticker.run(&write(vector))
    }

    fn run_all(&mut self, vectors: &[PlannedVector]) {
        for vector in vectors {
            self.run(vector);
        }
    }

    /// Returns the ticks of a vector without executing it.
    fn tick_stroke(&self, vector: &PlannedVector) -> TickStroke {
        self.ticker.clone().run(&write(vector))
    }
}

/// Divides a vector into pieces of equal duration.
fn of_time(vector: &PlannedVector, longest_s: f64, acceleration_mm_s2: f64) -> Vec<PlannedVector> {
    let whole = vector.profile(acceleration_mm_s2);
    let count = (whole.duration_s() / longest_s - ROUNDING).ceil().max(1.0);
    let each_s = whole.duration_s() / count;
    let mut pieces = Vec::new();
    let (mut rest, mut end_s) = (*vector, each_s);
    while end_s < whole.duration_s() - 0.5 * each_s {
        let [mut piece, mut after] = rest.parts(whole.distance() - whole.distance_at(end_s));
        // Use the rounded length.
        let end_mm_s = speed_before_mm_s(&whole, after.length_mm(), acceleration_mm_s2);
        piece.end_speed_mm_s = round_down(end_mm_s);
        after.start_speed_mm_s = piece.end_speed_mm_s;
        pieces.push(piece);
        (rest, end_s) = (after, end_s + each_s);
    }
    pieces.push(rest);
    for piece in &mut pieces {
        #[expect(clippy::cast_possible_truncation, reason = "as the plan holds it")]
        let duration_s = piece.profile(acceleration_mm_s2).duration_s() as f32;
        piece.duration_s = duration_s;
    }
    pieces
}

/// Returns the speed at a distance before the end of a vector, in mm/s.
fn speed_before_mm_s(whole: &Profile, left_mm: f64, acceleration_mm_s2: f64) -> f64 {
    let reached = |speed_mm_s: f64, way_mm: f64| {
        (speed_mm_s * speed_mm_s + 2.0 * acceleration_mm_s2 * way_mm).sqrt()
    };
    let up_mm_s = reached(whole.start_speed(), whole.distance() - left_mm);
    let down_mm_s = reached(whole.end_speed(), left_mm);
    up_mm_s.min(down_mm_s).min(whole.peak_speed())
}

/// Whether two executions have the same ticks, with a negligible difference in the number of
/// constant-speed ticks.
fn is_alike(a: &TickStroke, b: &TickStroke) -> bool {
    let [[a_up, a_even, a_down], [b_up, b_even, b_down]] = [a.counts, b.counts];
    let apart = f64::from(a_even.abs_diff(b_even));
    a.is_exact() == b.is_exact()
        && (a_up, a_down) == (b_up, b_down)
        && apart <= NEGLIGIBLE_SHARE * f64::from(a.ticks())
}

/// Returns possible divisions into pieces of whole ticks that have the speed of the whole vector in
/// every tick.
///
/// The maximum speed alone determines the number of decelerating ticks before a rest, which may fit
/// only a piece that does little else. The last digit of the speed left by the last piece may
/// change the ticks of the next vector.
fn of_ticks(
    vector: &PlannedVector,
    longest_s: f64,
    whole: &TickStroke,
    (arm, target): (&TickedArm, [f64; 3]),
) -> impl Iterator<Item = Vec<PlannedVector>> {
    let ways = [false, true]
        .into_iter()
        .flat_map(|brakes_apart| SHIFTS_MM.map(|shift_mm| (brakes_apart, shift_mm)));
    ways.filter_map(move |(brakes_apart, shift_mm)| {
        let ends = ends(whole.counts, longest_s, brakes_apart);
        ending_at((&ends, shift_mm), vector, whole, (arm, target))
    })
}

/// Returns the pieces that end at these ticks, shifted by a distance.
fn ending_at(
    (ends, shift_mm): (&[usize], f64),
    vector: &PlannedVector,
    whole: &TickStroke,
    (arm, target): (&TickedArm, [f64; 3]),
) -> Option<Vec<PlannedVector>> {
    if ends.is_empty() {
        return None;
    }
    let (mut arm, start) = (arm.clone(), arm.here);
    let ways_mm = whole.speeds_mm_s().map(|mm_s| f64::from(mm_s * TICK_S));
    let ways_mm: Vec<f64> = ways_mm.collect();
    let length_mm: f64 = ways_mm.iter().sum();
    // Each piece starts at the actual end of those before, so that the arm's rounding does not
    // accumulate.
    let piece_to = |share: f64, arm: &TickedArm| {
        let to = [0, 1, 2].map(|i| start[i] + share * (target[i] - start[i]));
        let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| single(to[i] - arm.here[i]));
        PlannedVector {
            x_mm,
            y_mm,
            z_mm,
            ..*vector
        }
    };
    let mut pieces = Vec::new();
    let [mut up, mut even, down] = whole.counts;
    let mut begin = 0;
    for &end in ends {
        let left_mm = ways_mm[end..].iter().sum::<f64>() + shift_mm;
        let kept = i16::try_from(end - begin).ok()? - up;
        // The piece ends at constant speed.
        let piece = PlannedVector {
            end_speed_mm_s: f32::INFINITY,
            ..piece_to(1.0 - left_mm / length_mm, &arm)
        };
        pieces.push(with_counts(&piece, [up, kept, 0], &mut arm)?);
        (begin, up, even) = (end, 0, even - kept);
    }
    let last = piece_to(1.0, &arm);
    pieces.push(with_counts(&last, [up, even, down], &mut arm)?);
    Some(pieces)
}

/// Returns the ticks at which pieces end: constant-speed ticks, except for the last piece.
fn ends([up, even, down]: [i16; 3], longest_s: f64, brakes_apart: bool) -> Vec<usize> {
    let [up, even, down] = [up, even, down].map(|ticks| usize::try_from(ticks).unwrap_or(0));
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few ticks"
    )]
    let longest = (longest_s / f64::from(TICK_S) + ROUNDING) as usize;
    let ticks = up + even + down;
    if ticks <= longest || even < 2 {
        return Vec::new();
    }
    let last = up + even - 1;
    let until = if brakes_apart { last } else { ticks };
    let (mut ends, mut begin) = (Vec::new(), 0);
    while until - begin > longest && begin < last {
        let left = until - begin;
        let each = left.div_ceil(left.div_ceil(longest));
        begin = (begin + each).clamp(up + 1, last);
        ends.push(begin);
    }
    ends.extend((brakes_apart && begin < last).then_some(last));
    ends
}

/// Finds speeds with which the arm executes a piece in these ticks; their values follow from its
/// length.
fn with_counts(
    piece: &PlannedVector,
    counts: [i16; 3],
    arm: &mut TickedArm,
) -> Option<PlannedVector> {
    let step_mm_s = arm.ticker.step_mm_s();
    let [ups, evens, downs] = counts.map(f32::from);
    let ticks = ups + evens + downs;
    // 50 L = n b + d s, with the initial speed b, a change d per accelerating tick, and s such
    // changes over all ticks.
    let steps = ups * (ups - 1.0) / 2.0 + ups * (evens + downs) - downs * (downs + 1.0) / 2.0;
    let begin_mm_s = (50.0 * length(&write(piece)) - step_mm_s * steps) / ticks;
    let top_mm_s = (begin_mm_s + ups * step_mm_s) * (1.0 - SPARE);
    let least_mm_s = match piece.kind {
        MoveKind::Burn => MIN_BURN_MM_S.min(piece.max_speed_mm_s),
        _ => MIN_END_MM_S,
    };
    // The correction of all ticks makes the arm faster than its packet; the rest needs that speed
    // as its maximum, or it would take more ticks.
    let slower = SLOWER_STEPS.map(|steps| top_mm_s - steps * step_mm_s);
    let tops_mm_s = iter::once(piece.max_speed_mm_s).chain(slower);
    let tried = tops_mm_s.flat_map(|top_mm_s| {
        let max_speed_mm_s = top_mm_s.max(least_mm_s);
        let near_mm_s = max_speed_mm_s - (downs - NEAR) * step_mm_s;
        let near_mm_s = if piece.end_speed_mm_s > 0.0 {
            near_mm_s.max(MIN_END_MM_S)
        } else {
            0.0
        };
        [piece.end_speed_mm_s, near_mm_s].map(|end_speed_mm_s| PlannedVector {
            start_speed_mm_s: arm.ticker.stored_mm_s().clamp(0.0, max_speed_mm_s),
            end_speed_mm_s: end_speed_mm_s.min(max_speed_mm_s),
            max_speed_mm_s,
            duration_s: ticks * TICK_S,
            ..*piece
        })
    });
    let has_counts = |piece: &PlannedVector| {
        let tick_stroke = arm.tick_stroke(piece);
        tick_stroke.counts == counts && tick_stroke.is_exact()
    };
    let found = tried.into_iter().find(has_counts)?;
    arm.run(&found);
    Some(found)
}

/// Changes of the last piece's length, in mm; the first one changes by the opposite.
const SHIFTS_MM: [f64; 5] = [0.0, 4e-5, -4e-5, 2e-4, -2e-4];
/// The share of a speed that is invisible in a drawing.
const NEGLIGIBLE_SHARE: f64 = 0.003;
/// Shares that differ by less are equal.
const ROUNDING: f64 = 1e-3;
/// The share by which an initial speed is lowered, because single precision limits the length of a
/// piece.
const SPARE: f32 = 1e-4;
/// Steps of speed below the fastest tick that are tried as maximum speed.
const SLOWER_STEPS: [f32; 3] = [0.25, 0.0, 0.45];

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke, Vec2};
    use proptest::prelude::*;

    use super::*;
    use crate::{Laser, Paper, Pass, Pen, Plan};

    fn arm_limits(has_ticks: bool) -> ArmLimits {
        ArmLimits {
            has_ticks,
            ..ArmLimits::default()
        }
    }

    fn laser(burn_speed_mm_s: f64) -> DrawingTool {
        DrawingTool::Laser(Laser {
            burn_speed_mm_s,
            ..Laser::default()
        })
    }

    fn pen(draw_speed_mm_s: f64) -> DrawingTool {
        DrawingTool::Pen(Pen {
            draw_speed_mm_s,
            ..Pen::default()
        })
    }

    /// Returns the plan without and with pieces.
    fn plans(strokes: &[Stroke], tool: DrawingTool, arm_limits: &ArmLimits) -> [Plan; 2] {
        let passes = [Pass::new(tool, strokes.to_vec())];
        let paper = Paper::level(-40.0);
        [Plan::whole, Plan::new].map(|plan| plan(&passes, &paper, arm_limits).expect("a plan"))
    }

    /// Returns the position at each tick of a plan, in mm, and the kind of its vector.
    fn motion(plan: &Plan) -> Vec<([f64; 3], MoveKind)> {
        let mut places = Vec::new();
        let mut ticker = Ticker::of(plan.arm_limits(), 0.0);
        let (mut here, mut begin_s) = (plan.start, 0.0);
        let tick_s = f64::from(TICK_S);
        for (vector, there) in plan.moves.iter().zip(plan.positions()) {
            let direction = vector.increments().map(|mm| mm / vector.length_mm());
            let mut ways_mm = Vec::new();
            if let Some(ticker) = &mut ticker {
                let tick_stroke = ticker.run(&write(vector));
                ways_mm.extend(
                    tick_stroke
                        .speeds_mm_s()
                        .scan(0.0, |covered_mm, speed_mm_s| {
                            *covered_mm += f64::from(speed_mm_s * TICK_S);
                            Some(*covered_mm)
                        }),
                );
            } else {
                let profile = vector.profile(plan.arm_limits().acceleration_mm_s2);
                let end_s = begin_s + profile.duration_s();
                let first = (begin_s / tick_s).floor() + 1.0;
                let ticks = (0..).map(|tick| (first + f64::from(tick)) * tick_s);
                let ticks = ticks.take_while(|tick_s| *tick_s <= end_s);
                ways_mm.extend(ticks.map(|tick_s| profile.distance_at(tick_s - begin_s)));
                begin_s = end_s;
            }
            let at = |way_mm: f64| [0, 1, 2].map(|i| here[i] + way_mm * direction[i]);
            places.extend(ways_mm.into_iter().map(|way_mm| (at(way_mm), vector.kind)));
            here = there;
        }
        places
    }

    /// Checks that both plans move the arm equally and that no piece at constant speed takes longer
    /// than this, in s.
    fn check(
        whole: &Plan,
        divided: &Plan,
        kind: MoveKind,
        longest_s: f64,
    ) -> Result<(), TestCaseError> {
        let mut ticker = Ticker::of(divided.arm_limits(), 0.0);
        for piece in &divided.moves {
            let evens = ticker
                .as_mut()
                .map(|ticker| ticker.run(&write(piece)).counts[1]);
            let is_short = f64::from(piece.duration_s) <= 1.002 * longest_s;
            let may_be_long = piece.kind != kind || evens.is_some_and(|even| even < 2);
            prop_assert!(is_short || may_be_long, "{evens:?} {piece:?}");
        }
        let [was_s, is_s] = [whole, divided].map(|plan| {
            let durations_s = plan.moves.iter().map(|vector| f64::from(vector.duration_s));
            durations_s.sum::<f64>()
        });
        prop_assert!((was_s - is_s).abs() < 1e-3 * was_s, "{was_s} s, {is_s} s");
        let [was, is] = [whole, divided].map(motion);
        prop_assert!(
            was.len().abs_diff(is.len()) <= 1,
            "{} and {} ticks",
            was.len(),
            is.len()
        );
        for (tick, (a, b)) in was.iter().zip(&is).enumerate() {
            let off_mm = crate::path::vector::length([0, 1, 2].map(|i| a.0[i] - b.0[i]));
            prop_assert!(off_mm < 0.005, "{off_mm} mm in tick {tick}: {a:?}, {b:?}");
        }
        Ok(())
    }

    fn lines() -> impl Strategy<Value = Vec<Stroke>> {
        let step = (0.0..360.0_f64, prop_oneof![0.1..3.0_f64, 1.0..60.0_f64]);
        let stroke = (-30.0..30.0_f64, proptest::collection::vec(step, 1..8));
        let stroke = stroke.prop_map(|(y, steps)| {
            let mut points = vec![Point::new(220.0, y)];
            points.extend(steps.iter().scan(points[0], |here, (turn_deg, length_mm)| {
                let next = *here + Vec2::from_angle(turn_deg.to_radians()) * *length_mm;
                // Within reach of a pen on the paper.
                let radius_mm = next.to_vec2().length();
                *here = (next.to_vec2() * (radius_mm.clamp(150.0, 300.0) / radius_mm)).to_point();
                Some(*here)
            }));
            Stroke::open(points)
        });
        proptest::collection::vec(stroke, 1..4)
    }

    #[test]
    fn a_long_line_is_burned_in_pieces_that_begin_and_end_at_its_speed() {
        let line = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(200.0, 96.0)]);
        for has_ticks in [false, true] {
            let [whole, divided] = plans(
                std::slice::from_ref(&line),
                laser(3.0),
                &arm_limits(has_ticks),
            );
            let burned = |plan: &Plan| -> Vec<PlannedVector> {
                let burned = plan
                    .moves
                    .iter()
                    .filter(|vector| vector.kind == MoveKind::Burn);
                burned.copied().collect()
            };
            assert_eq!(burned(&whole).len(), 1);
            let pieces = burned(&divided);
            // 32 s, in pieces of 0.18 s.
            assert!((178..=183).contains(&pieces.len()), "{}", pieces.len());
            for piece in &pieces {
                let packet = write(piece);
                let speeds_mm_s = [
                    packet.start_speed_mm_s,
                    packet.end_speed_mm_s,
                    packet.max_speed_mm_s,
                ];
                assert!(
                    speeds_mm_s.iter().all(|mm_s| (mm_s - 3.0).abs() < 0.02),
                    "{packet:?}"
                );
            }
        }
    }

    proptest! {
        #[test]
        fn every_vector_that_burns_is_short_on_both_dialects(
            strokes in lines(), burn_speed_mm_s in 1.0..16.0_f64, has_ticks: bool,
        ) {
            let [whole, divided] = plans(&strokes, laser(burn_speed_mm_s), &arm_limits(has_ticks));
            check(&whole, &divided, MoveKind::Burn, LONGEST_BURN_S)?;
        }

        #[test]
        fn every_vector_that_draws_is_short_on_both_dialects(
            strokes in lines(), draw_speed_mm_s in 5.0..40.0_f64, has_ticks: bool,
        ) {
            let [whole, divided] = plans(&strokes, pen(draw_speed_mm_s), &arm_limits(has_ticks));
            check(&whole, &divided, MoveKind::Draw, LONGEST_DRAW_S)?;
        }
    }
}
