//! Simplification to fewer, longer vectors, because the link delivers few.

mod cone;
mod corridor;
mod fastest;
mod search;
mod smooth;
mod snap;
mod spliced;
mod timed;
mod visibility;

#[cfg(test)]
mod oracle;

use corridor::{Corner, Corridor};
use dobot_geometry::{Point, Stroke};
use dobot_plan::DurationEstimator;
use fastest::{fast_ways, fastest, seemingly_fastest};
use search::fewest;
use spliced::spliced;

/// Approximates a stroke with as few vectors as possible that pass its points in order, each within
/// `tolerance_mm`, and so keep the tolerance everywhere. The ends of an open stroke are kept; a
/// closed one stays closed, with its start within the tolerance. A stroke shorter than
/// [`MIN_VECTOR_MM`] becomes a dot.
///
/// Corners need not lie on the stroke: a chord of a curve may swing from one side of it to the
/// other, which makes it longer by a factor of the square root of two. If that costs no vector,
/// corners are moved on to the stroke.
///
/// ```text
///   corner on the curve    _.-----._      free corner   _-'''''-_
///                        .'         '.                *'---------'*
///                       *-------------*              '             '
/// ```
///
/// For short strokes, the result never has more vectors than the best choice among the stroke's own
/// points; for long ones, the work is linear in their points.
#[must_use]
pub fn simplify(stroke: &Stroke, tolerance_mm: f64) -> Stroke {
    fewest_at(stroke, tolerance_mm).stroke
}

/// The minimum length of a vector: shorter ones are merged, because they take as much link time as
/// long ones, and a vector of length zero stops a stock arm permanently.
pub const MIN_VECTOR_MM: f64 = 0.005;

/// Approximates a stroke within `tolerance_mm` with the fastest vectors: few where the link limits
/// the speed, more where the arm does. Of equally fast paths, the one closer to the stroke is
/// chosen. Ends and tolerance are handled as in [`simplify`].
#[must_use]
pub fn simplify_at(stroke: &Stroke, tolerance_mm: f64, estimator: &DurationEstimator) -> Stroke {
    let radius_mm = tolerance_mm - SLACK_MM;
    match fastest(corridor(stroke, radius_mm), estimator) {
        Some(path) if radius_mm > MIN_VECTOR_MM => joined(stroke, places(&path)),
        _ => simplify(stroke, tolerance_mm),
    }
}

/// A candidate for the fastest approximation of a stroke.
#[derive(Clone, Debug)]
pub(crate) struct Approximation {
    pub stroke: Stroke,
    /// Its corners; empty if it was not found in the stroke's corridor.
    path: Vec<Corner>,
}

impl Approximation {
    fn of(stroke: &Stroke, path: Vec<Corner>) -> Self {
        Self {
            stroke: joined(stroke, places(&path)),
            path,
        }
    }
}

/// Returns the fewest vectors of a stroke within `tolerance_mm` with a length of at least
/// `least_mm`; `None` if none were found.
pub(crate) fn fewest_long_at(stroke: &Stroke, tolerance_mm: f64, least_mm: f64) -> Option<Stroke> {
    let corridor = corridor(stroke, tolerance_mm - SLACK_MM).of_vectors(least_mm);
    let path = fewest(&corridor)?;
    Some(joined(stroke, places(&path)))
}

/// Returns the approximation with the fewest vectors within `tolerance_mm`.
pub(crate) fn fewest_at(stroke: &Stroke, tolerance_mm: f64) -> Approximation {
    let radius_mm = tolerance_mm - SLACK_MM;
    let path = if radius_mm > MIN_VECTOR_MM {
        fewest(&corridor(stroke, radius_mm))
    } else {
        None
    };
    let points = match &path {
        Some(path) => places(path),
        None => fewest_without_specks(stroke, radius_mm),
    };
    Approximation {
        stroke: joined(stroke, points),
        path: path.unwrap_or_default(),
    }
}

/// Returns candidates for the fastest approximation within `tolerance_mm`, the preferred first. The
/// one with the fewest vectors is given.
pub(crate) fn fast_ways_at(
    stroke: &Stroke,
    tolerance_mm: f64,
    fewest: Approximation,
    estimator: &DurationEstimator,
) -> Vec<Approximation> {
    if fewest.path.is_empty() {
        return vec![fewest];
    }
    let corridor = corridor(stroke, tolerance_mm - SLACK_MM);
    let ways = fast_ways(corridor, fewest.path, estimator);
    ways.into_iter()
        .map(|path| Approximation::of(stroke, path))
        .collect()
}

/// Returns the estimated fastest approximation within `tolerance_mm`, in a fraction of the time.
/// The one with the fewest vectors is given.
pub(crate) fn seemingly_fastest_at(
    stroke: &Stroke,
    tolerance_mm: f64,
    fewest: Approximation,
    estimator: &DurationEstimator,
) -> Approximation {
    if fewest.path.is_empty() {
        return fewest;
    }
    let corridor = corridor(stroke, tolerance_mm - SLACK_MM);
    Approximation::of(stroke, seemingly_fastest(corridor, fewest.path, estimator))
}

/// An approximation that was planned.
#[derive(Clone, Debug)]
pub(crate) struct PlannedApproximation {
    pub way: Approximation,
    /// The duration of each of its vectors, in s.
    pub durations_s: Vec<f64>,
}

/// Combines the best parts of several approximations, with a cost of `change_s` per switch; `None`
/// if one of them is the best everywhere.
pub(crate) fn spliced_at(
    stroke: &Stroke,
    tolerance_mm: f64,
    estimator: &DurationEstimator,
    ways: &[PlannedApproximation],
    change_s: f64,
) -> Option<Approximation> {
    let corridor = corridor(stroke, tolerance_mm - SLACK_MM);
    let ends = |path: &[Corner]| Some([path.first()?.at, path.last()?.at]);
    let wanted = ends(&ways.first()?.way.path)?;
    let fit = ways.iter().filter(|planned| {
        let path = &planned.way.path;
        ends(path) == Some(wanted) && path.len() == planned.durations_s.len() + 1
    });
    let paths = fit.map(|planned| (&planned.way.path[..], &planned.durations_s[..]));
    let way = spliced(&corridor, paths, change_s, estimator)?;
    Some(Approximation::of(stroke, way))
}

fn corridor(stroke: &Stroke, radius_mm: f64) -> Corridor<'_> {
    Corridor::new(&stroke.points, stroke.closed, radius_mm)
}

/// Returns a stroke with other points that is closed like the given one.
fn joined(stroke: &Stroke, points: Vec<Point>) -> Stroke {
    Stroke {
        closed: stroke.closed && points.len() > 1,
        points,
    }
}

fn places(path: &[Corner]) -> Vec<Point> {
    path.iter().map(|corner| corner.at).collect()
}

/// Returns the fewest vectors within a tolerance if specks permit only a vector that is too short.
fn fewest_without_specks(stroke: &Stroke, tolerance_mm: f64) -> Vec<Point> {
    let points = without_specks(&stroke.points);
    if tolerance_mm <= 2.0 * MIN_VECTOR_MM || points.len() < 3 {
        return points;
    }
    let corridor = Corridor::new(&points, stroke.closed, tolerance_mm - MIN_VECTOR_MM);
    match fewest(&corridor) {
        Some(path) => places(&path),
        None => points,
    }
}

/// Removes points that barely differ from the one before; both ends are kept.
fn without_specks(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for &p in points {
        if kept
            .last()
            .is_none_or(|last| last.distance(p) >= MIN_VECTOR_MM)
        {
            kept.push(p);
        }
    }
    if let [_, .., last] = &mut kept[..] {
        *last = points[points.len() - 1];
    }
    kept
}

/// The share of the tolerance reserved for rounding.
const SLACK_MM: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::oracle::fewest_between_points;
    use super::*;
    use dobot_geometry::{Random, Vec2, deviation};
    use dobot_plan::{ArmLimits, DrawingTool, Paper, Pass, Plan};

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    fn circle(radius: f64, count: u32) -> Stroke {
        let at = |i| TAU * f64::from(i % count) / f64::from(count);
        let points = (0..=count).map(|i| Point::new(at(i).cos() * radius, at(i).sin() * radius));
        Stroke {
            points: points.collect(),
            closed: true,
        }
    }

    /// A wheel of 53 teeth in a ring of 120: 20,000 segments, 118 mm wide.
    fn spirograph() -> Stroke {
        let (ring, wheel, arm) = (120.0, 53.0, 44.0);
        let scale = 59.0 / (ring - wheel + arm);
        let at = |i: u32| {
            let (sin, cos) = (TAU * wheel * f64::from(i % 20_000) / 20_000.0).sin_cos();
            let turned = TAU * (ring - wheel) * f64::from(i % 20_000) / 20_000.0;
            let rolled = Vec2::new(cos, sin) * (ring - wheel);
            let pen = rolled + Vec2::new(turned.cos(), -turned.sin()) * arm;
            (pen * scale).to_point()
        };
        Stroke {
            points: (0..=20_000).map(at).collect(),
            closed: true,
        }
    }

    fn walk(steps: &[(f64, f64)], closed: bool) -> Stroke {
        let mut points = vec![Point::default()];
        for &(x, y) in steps {
            points.push(points[points.len() - 1] + Vec2::new(x, y));
        }
        if closed {
            points.push(points[0]);
        }
        Stroke { points, closed }
    }

    fn steps() -> impl Strategy<Value = Vec<(f64, f64)>> {
        let any_way = proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 1..60);
        let forward = proptest::collection::vec((0.1..1.0_f64, -0.3..0.3_f64), 1..60);
        let back_and_forth = proptest::collection::vec((-0.5..1.0_f64, -0.02..0.02_f64), 1..60);
        prop_oneof![any_way, forward, back_and_forth]
    }

    fn worst_mm(wanted: &Stroke, drawn: &Stroke) -> f64 {
        deviation(std::slice::from_ref(wanted), std::slice::from_ref(drawn)).largest_mm()
    }

    /// A line of 200 mm whose direction swings depending on a seed.
    fn wander(seed: u64) -> Stroke {
        let mut random = Random::new(seed);
        let swings: Vec<[f64; 3]> = [0.5, 1.3, 3.1, 7.0]
            .map(|often| {
                [
                    often * (1.0 + random.share()),
                    TAU * random.share(),
                    3.0 / often,
                ]
            })
            .into();
        let direction = |i: u32| {
            let swing = |[often, begin, size]: &[f64; 3]| {
                size * (TAU * often * f64::from(i) / 1000.0 + begin).sin()
            };
            Vec2::from_angle(swings.iter().map(swing).sum())
        };
        let mut points = vec![Point::new(200.0, 0.0)];
        for i in 0..4000 {
            points.push(points[points.len() - 1] + direction(i) * 0.05);
        }
        Stroke::open(points)
    }

    fn estimator(acceleration_mm_s2: f64, speed_mm_s: f64) -> DurationEstimator {
        let arm_limits = ArmLimits {
            acceleration_mm_s2,
            ..ArmLimits::default()
        };
        DurationEstimator::of(&arm_limits, &DrawingTool::default().at_speed(speed_mm_s))
    }

    /// Returns the planned duration of a stroke without joint limits, in s.
    fn planned_s(stroke: &Stroke, estimator: &DurationEstimator) -> f64 {
        let arm_limits = ArmLimits {
            acceleration_mm_s2: estimator.cornering.acceleration_mm_s2,
            joint_speed_deg_s: 10_000.0,
            ..ArmLimits::default()
        };
        let tool = DrawingTool::default().at_speed(estimator.speed_mm_s);
        let pass = Pass::new(tool, vec![stroke.clone()]);
        let plan = Plan::new(&[pass], &Paper::default(), &arm_limits).expect("a plan");
        plan.duration_s()
    }

    fn fast_ways(
        stroke: &Stroke,
        tolerance_mm: f64,
        estimator: &DurationEstimator,
    ) -> Vec<Approximation> {
        fast_ways_at(
            stroke,
            tolerance_mm,
            fewest_at(stroke, tolerance_mm),
            estimator,
        )
    }

    #[test]
    fn a_coarser_tolerance_is_not_slower_than_a_finer_one() {
        for (seed, estimator) in (1..=4).zip(
            [estimator(100.0, 40.0), estimator(200.0, 100.0)]
                .iter()
                .cycle(),
        ) {
            let stroke = wander(seed);
            // The plan decides among the candidates, as in a drawing.
            let fastest_s = |tolerance_mm| {
                let ways = fast_ways(&stroke, tolerance_mm, estimator).into_iter();
                let fewest = [0.5, 1.0].map(|share| simplify(&stroke, share * tolerance_mm));
                let ways = ways.map(|way| way.stroke).chain(fewest);
                ways.map(|way| planned_s(&way, estimator))
                    .fold(f64::INFINITY, f64::min)
            };
            let times_s = [0.03, 0.06, 0.12, 0.24, 0.48].map(fastest_s);
            let slower = times_s.windows(2).map(|pair| pair[1] / pair[0]);
            let worst = slower.fold(0.0, f64::max);
            assert!(worst <= 1.03, "seed {seed}: {times_s:?} s");
        }
    }

    #[test]
    fn a_circle_is_round_where_the_arm_is_slow() {
        let wanted = circle(30.0, 5000);
        let drawn = simplify_at(&wanted, 0.05, &estimator(100.0, 20.0));
        assert!(worst_mm(&wanted, &drawn) <= 0.01);
        let [few, many] = [simplify(&wanted, 0.05), drawn]
            .map(|stroke| planned_s(&stroke, &estimator(100.0, 20.0)));
        assert!(many <= 1.005 * few, "{many} instead of {few} s");
    }

    #[test]
    fn the_best_parts_of_two_paths_are_combined() {
        let at = |i: u32| Point::new(0.0, 0.0) + Vec2::from_angle(f64::from(i) / 500.0) * 30.0;
        let arc = Stroke::open((0..1500).map(at).collect());
        let estimator = estimator(100.0, 40.0);
        // The first is fast at the start, the second at the end.
        let mut ways = fast_ways(&arc, 0.05, &estimator).into_iter();
        let two = [ways.next(), ways.next()].map(|way| way.expect("a way"));
        let count = |way: &Approximation| way.stroke.points.len() - 1;
        let (first, second) = (count(&two[0]), count(&two[1]));
        let planned = |way: &Approximation, count: usize, is_fast: &dyn Fn(usize) -> bool| {
            PlannedApproximation {
                durations_s: (0..count)
                    .map(|i| if is_fast(i) { 0.2 } else { 0.4 })
                    .collect(),
                way: way.clone(),
            }
        };
        let ways = [
            planned(&two[0], first, &|i| 2 * i < first),
            planned(&two[1], second, &|i| 2 * i > second),
        ];
        let both = spliced_at(&arc, 0.05, &estimator, &ways, 0.1).expect("a new way");
        let points = both.stroke.points;
        let third = points.len() / 3;
        let are_of = |points: &[Point], way: &Approximation| {
            let mut points = points.iter();
            points.all(|p| way.stroke.points.contains(p))
        };
        assert!(are_of(&points[..third], &two[0]));
        assert!(are_of(&points[points.len() - third..], &two[1]));
        assert!(worst_mm(&arc, &Stroke::open(points)) <= 0.05);
        // If a change costs more than it saves, there is none.
        assert!(spliced_at(&arc, 0.05, &estimator, &ways, 100.0).is_none());
    }

    #[test]
    fn a_straight_line_of_many_points_becomes_one_vector() {
        let wobbly = line(&[
            (0.0, 0.0),
            (1.0, 0.04),
            (2.0, -0.04),
            (3.0, 0.03),
            (9.0, 0.0),
        ]);
        assert_eq!(simplify(&wobbly, 0.05), line(&[(0.0, 0.0), (9.0, 0.0)]));
    }

    #[test]
    fn a_line_that_turns_back_keeps_its_farthest_point() {
        let there_and_back = line(&[(0.0, 0.0), (5.0, 0.0), (2.0, 0.0)]);
        assert_eq!(simplify(&there_and_back, 0.05), there_and_back);
    }

    #[test]
    fn corners_without_cost_are_kept() {
        let sides = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)];
        let mut square = line(&sides);
        square.closed = true;
        let halved = square.segments().flat_map(|(a, b)| [a, a.lerp(b, 0.5)]);
        let mut halved = Stroke {
            points: halved.collect(),
            closed: true,
        };
        halved.points.push(square.points[0]);
        assert_eq!(simplify(&halved, 0.05), square);
    }

    #[test]
    fn repeated_points_are_removed_and_a_speck_becomes_a_dot() {
        let repeated = line(&[(0.0, 0.0), (0.0, 0.0), (4.0, 0.0), (4.0, 0.0)]);
        assert_eq!(simplify(&repeated, 0.05), line(&[(0.0, 0.0), (4.0, 0.0)]));
        let speck = line(&[(1.0, 1.0), (1.001, 1.0)]);
        assert_eq!(simplify(&speck, 0.05), line(&[(1.0, 1.0)]));
    }

    #[test]
    fn chords_of_a_circle_alternate_between_its_sides() {
        // A chord that deviates from a circle of radius r by e on both sides has the length 4
        // sqrt(r e).
        for (radius, count) in [(20.0_f64, 20_000), (20.0, 500), (3.0, 1000), (100.0, 3000)] {
            let ideal = TAU * radius / (4.0 * (radius * 0.05).sqrt());
            #[expect(clippy::cast_precision_loss, reason = "a small count")]
            let found = (simplify(&circle(radius, count), 0.05).points.len() - 1) as f64;
            assert!(found <= ideal.ceil() + 1.0, "{found} chords, ideal {ideal}");
        }
    }

    #[test]
    fn a_spirograph_takes_three_quarters_of_the_fewest_vectors_between_its_points() {
        let wanted = spirograph();
        let drawn = simplify(&wanted, 0.05);
        assert!(worst_mm(&wanted, &drawn) <= 0.05);
        assert!(drawn.closed && drawn.points[0] == drawn.points[drawn.points.len() - 1]);
        let fewest = fewest_between_points(&wanted.points, 0.05).expect("a path");
        let found = drawn.points.len() - 1;
        assert!(4 * found <= 3 * fewest, "{found} of {fewest}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn never_leaves_the_stroke_by_more_than_the_tolerance(
            steps in steps(),
            closed: bool,
            tolerance in 0.02..1.0_f64,
        ) {
            let stroke = walk(&steps, closed);
            let simple = simplify(&stroke, tolerance);
            if simple.points.len() > 1 {
                prop_assert!(closed || simple.points[0] == stroke.points[0]);
                prop_assert!(closed || simple.last() == stroke.last());
                let worst = worst_mm(&stroke, &simple);
                prop_assert!(worst <= tolerance, "{worst} > {tolerance}");
            }
            prop_assert_eq!(simple.closed, closed && simple.points.len() > 1);
            prop_assert!(!simple.closed || simple.points[0] == simple.points[simple.points.len() - 1]);
            for (a, b) in simple.segments() {
                prop_assert!(a.distance(b) >= MIN_VECTOR_MM);
            }
        }

        #[test]
        fn never_uses_more_vectors_than_the_best_choice_of_points(
            steps in steps(),
            closed: bool,
            tolerance in 0.02..1.0_f64,
        ) {
            let stroke = walk(&steps, closed);
            let simple = simplify(&stroke, tolerance);
            if let Some(fewest) = fewest_between_points(&stroke.points, tolerance - SLACK_MM) {
                prop_assert!(simple.points.len() - 1 <= fewest, "{simple:?} instead of {fewest}");
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(250))]

        #[test]
        fn the_fastest_vectors_keep_the_tolerance_too(
            steps in steps(),
            closed: bool,
            tolerance in 0.02..1.0_f64,
            speed_mm_s in 1.0..200.0_f64,
        ) {
            let stroke = walk(&steps, closed);
            let estimator = estimator(100.0, speed_mm_s);
            let ways = fast_ways(&stroke, tolerance, &estimator);
            // Pretend that each approximation is the fastest one somewhere.
            let planned: Vec<PlannedApproximation> = ways.iter().enumerate().map(|(n, way)| PlannedApproximation {
                durations_s: (1..way.stroke.points.len()).map(|i| if (i + n) % 3 == 0 { 0.1 } else { 1.0 }).collect(),
                way: way.clone(),
            }).collect();
            let spliced = spliced_at(&stroke, tolerance, &estimator, &planned, 0.0);
            let seems = seemingly_fastest_at(&stroke, tolerance, fewest_at(&stroke, tolerance), &estimator);
            for Approximation { stroke: simple, .. } in ways.into_iter().chain(spliced).chain([seems]) {
                if simple.points.len() > 1 {
                    prop_assert!(closed || simple.points[0] == stroke.points[0]);
                    prop_assert!(closed || simple.last() == stroke.last());
                    let worst = worst_mm(&stroke, &simple);
                    prop_assert!(worst <= tolerance, "{worst} > {tolerance}");
                }
                prop_assert_eq!(simple.closed, closed && simple.points.len() > 1);
                prop_assert!(!simple.closed || Some(&simple.points[0]) == simple.points.last());
                for (a, b) in simple.segments() {
                    prop_assert!(a.distance(b) >= MIN_VECTOR_MM);
                }
            }
        }
    }
}
