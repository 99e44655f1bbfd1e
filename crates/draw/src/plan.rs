//! From strokes to vectors that arm and link can carry.

use dobot_motion::Profile;

use crate::lookahead::{Cornering, Run};
use crate::pen::{LinkRate, Pen, PlanError};
use crate::point::{Point, Stroke};

/// Everything the arm does for a drawing, vector by vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Where the first vector begins, pen up: X, Y, Z in the base frame, in mm. The arm must be
    /// brought here before.
    pub start: [f64; 3],
    /// The vectors in order; each begins where the one before ends.
    pub moves: Vec<PlannedVector>,
    acceleration_mm_s2: f64,
}

impl Plan {
    /// Plans the strokes, given in the base frame, in their order.
    ///
    /// ```text
    ///   up    ----> Travel ----.                     .---- Travel ---->
    ///                          | Lower          Lift |
    ///   down                   '-- Draw Draw Draw ---'
    /// ```
    ///
    /// 1. The pen stands still before and after it is lowered or lifted, and draws each stroke in
    ///    one go, with the corner speeds of [`Cornering::speeds`].
    /// 2. A vector costs one packet: it is never over before the link can bring the next one, so
    ///    short vectors are slow.
    /// 3. Every number is rounded to single precision as the packet will hold it, before speeds
    ///    are planned; each increment aims from where the rounded ones before it really lead, so
    ///    that rounding does not add up.
    /// 4. Speeds are rounded down, and the start speed of a vector is exactly the end speed of
    ///    the one before.
    /// 5. A vector shorter than a micrometre is left out; the next one makes up for it.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where there is nothing to draw or a setting makes no sense.
    pub fn new(strokes: &[Stroke], pen: &Pen, link: LinkRate) -> Result<Self, PlanError> {
        pen.check()?;
        link.check()?;
        let mut strokes = strokes.iter().filter(|s| !s.points.is_empty()).peekable();
        let first = strokes.peek().ok_or(PlanError::NoStrokes)?.points[0];
        let start = [first.x, first.y, pen.up_z_mm];
        let mut planner = Planner::new(start, *pen, link);
        for (id, stroke) in (0..).zip(strokes) {
            planner.stroke(id, stroke);
        }
        Ok(Self {
            start,
            moves: planner.moves,
            acceleration_mm_s2: pen.acceleration_mm_s2,
        })
    }

    /// How long each vector takes, in seconds.
    pub fn durations(&self) -> impl Iterator<Item = f64> {
        let acceleration = self.acceleration_mm_s2;
        self.moves
            .iter()
            .map(move |vector| vector.duration_s(acceleration))
    }

    /// The acceleration that it was planned with, in mm/s2.
    #[must_use]
    pub const fn acceleration_mm_s2(&self) -> f64 {
        self.acceleration_mm_s2
    }

    /// How long the whole plan takes, in seconds.
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        self.durations().sum()
    }

    /// Where each vector leads: X, Y, Z in the base frame, in mm.
    pub fn positions(&self) -> impl Iterator<Item = [f64; 3]> {
        self.moves.iter().scan(self.start, |here, vector| {
            let [x, y, z] = vector.increments();
            *here = [here[0] + x, here[1] + y, here[2] + z];
            Some(*here)
        })
    }

    /// The paths along which the pen goes as `kind`, joined where they follow one another.
    #[must_use]
    pub fn paths(&self, kind: MoveKind) -> Vec<Stroke> {
        let mut paths: Vec<Stroke> = Vec::new();
        let mut here = Point::new(self.start[0], self.start[1]);
        let mut goes_on = false;
        for (vector, [x, y, _]) in self.moves.iter().zip(self.positions()) {
            let there = Point::new(x, y);
            match paths.last_mut().filter(|_| goes_on) {
                _ if vector.kind != kind => {}
                Some(path) => path.points.push(there),
                None => paths.push(Stroke::open(vec![here, there])),
            }
            goes_on = vector.kind == kind;
            here = there;
        }
        paths
    }

    /// The figures of the plan.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let total = |kind| {
            let vectors = self.moves.iter().filter(|vector| vector.kind == kind);
            vectors
                .map(PlannedVector::length_mm)
                .fold(0.0, |sum, length| sum + length)
        };
        Summary {
            strokes: self
                .moves
                .last()
                .map_or(0, |vector| vector.stroke as usize + 1),
            vectors: self.moves.len(),
            drawn_mm: total(MoveKind::Draw),
            travelled_mm: total(MoveKind::Travel),
            duration_s: self.duration_s(),
        }
    }
}

/// One vector of a plan: an increment and its speeds, as a packet holds them (state 4; Table 2.6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedVector {
    /// Forward, in mm.
    pub x_mm: f32,
    /// To the left, in mm.
    pub y_mm: f32,
    /// Up, in mm.
    pub z_mm: f32,
    /// The speed to begin with: the end speed of the vector before, in mm/s.
    pub start_speed_mm_s: f32,
    /// The speed to end with, in mm/s.
    pub end_speed_mm_s: f32,
    /// The speed not to pass in between, in mm/s.
    pub max_speed_mm_s: f32,
    /// What the pen does.
    pub kind: MoveKind,
    /// Which stroke it belongs to, from 0; a travel to the stroke that it leads to.
    pub stroke: u32,
}

impl PlannedVector {
    /// The increments along X, Y and Z in mm.
    #[must_use]
    pub fn increments(&self) -> [f64; 3] {
        [self.x_mm, self.y_mm, self.z_mm].map(f64::from)
    }

    /// The length in mm.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        length(self.increments())
    }

    /// How long it takes in seconds: accelerate, keep the largest speed for a while if it is
    /// reached, brake.
    #[must_use]
    pub(crate) fn duration_s(&self, acceleration_mm_s2: f64) -> f64 {
        let speeds = [
            self.start_speed_mm_s,
            self.end_speed_mm_s,
            self.max_speed_mm_s,
        ];
        let [start, end, max] = speeds.map(f64::from);
        Profile::new(self.length_mm(), start, end, max, acceleration_mm_s2)
            .expect("a plan keeps its own limits")
            .duration_s()
    }
}

/// What the pen does on a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveKind {
    /// Goes to the next stroke, up.
    Travel,
    /// Goes down to the paper.
    Lower,
    /// Draws.
    Draw,
    /// Goes up from the paper.
    Lift,
}

/// The figures of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Summary {
    /// How often the pen is lowered.
    pub strokes: usize,
    /// How many vectors, and so packets.
    pub vectors: usize,
    /// How far the pen goes down on the paper, in mm.
    pub drawn_mm: f64,
    /// How far it goes between strokes, in mm.
    pub travelled_mm: f64,
    /// How long all of it takes, in seconds.
    pub duration_s: f64,
}

struct Planner {
    pen: Pen,
    link: LinkRate,
    cornering: Cornering,
    /// Where the vectors so far lead, rounding included.
    here: [f64; 3],
    moves: Vec<PlannedVector>,
    /// What follows is reused from stroke to stroke.
    chain: Vec<Run>,
    speeds: Vec<f64>,
}

impl Planner {
    fn new(start: [f64; 3], pen: Pen, link: LinkRate) -> Self {
        let cornering = Cornering {
            // The spared part keeps rounded speeds within the acceleration.
            acceleration_mm_s2: pen.acceleration_mm_s2 * (1.0 - 1e-5),
            deviation_mm: pen.corner_deviation_mm,
            stops: pen.stops_at_corners,
        };
        Self {
            pen,
            link,
            cornering,
            here: start,
            moves: Vec::new(),
            chain: Vec::new(),
            speeds: Vec::new(),
        }
    }

    fn stroke(&mut self, id: u32, stroke: &Stroke) {
        let Pen {
            up_z_mm: up,
            down_z_mm: down,
            ..
        } = self.pen;
        let (first, rest) = (&stroke.points[..1], &stroke.points[1..]);
        let last = &stroke.points[stroke.points.len() - 1..];
        self.chain(MoveKind::Travel, id, first, up, self.pen.travel_speed_mm_s);
        self.chain(MoveKind::Lower, id, first, down, self.pen.lift_speed_mm_s);
        self.chain(MoveKind::Draw, id, rest, down, self.pen.draw_speed_mm_s);
        self.chain(MoveKind::Lift, id, last, up, self.pen.lift_speed_mm_s);
    }

    /// Vectors through these points at this height, at rest before and after.
    fn chain(&mut self, kind: MoveKind, stroke: u32, points: &[Point], z_mm: f64, limit_mm_s: f64) {
        self.chain.clear();
        let begin = self.moves.len();
        for p in points {
            self.vector(kind, stroke, [p.x, p.y, z_mm], limit_mm_s);
        }
        self.cornering.speeds(&self.chain, &mut self.speeds);
        for (i, vector) in self.moves[begin..].iter_mut().enumerate() {
            vector.start_speed_mm_s = round_down(self.speeds[i]);
            vector.end_speed_mm_s = round_down(self.speeds[i + 1]);
        }
    }

    fn vector(&mut self, kind: MoveKind, stroke: u32, to: [f64; 3], limit_mm_s: f64) {
        let here = self.here;
        #[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
        let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| (to[i] - here[i]) as f32);
        let way = [x_mm, y_mm, z_mm].map(f64::from);
        let length_mm = length(way);
        if length_mm < LEAST_VECTOR_MM {
            return;
        }
        self.here = [0, 1, 2].map(|i| here[i] + way[i]);
        let max_speed_mm_s = round_down(limit_mm_s.min(length_mm / self.link.period_s));
        self.chain.push(Run {
            direction: way.map(|d| d / length_mm),
            length_mm,
            limit_mm_s: f64::from(max_speed_mm_s),
        });
        self.moves.push(PlannedVector {
            x_mm,
            y_mm,
            z_mm,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 0.0,
            max_speed_mm_s,
            kind,
            stroke,
        });
    }
}

/// The largest single-precision number that is not above `value`.
fn round_down(value: f64) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "corrected below")]
    let nearest = value as f32;
    if f64::from(nearest) > value {
        nearest.next_down()
    } else {
        nearest
    }
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

const LEAST_VECTOR_MM: f64 = 0.001;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const NO_LINK: LinkRate = LinkRate { period_s: 0.0 };

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    fn plan(strokes: &[Stroke], link: LinkRate) -> Plan {
        Plan::new(strokes, &Pen::default(), link).unwrap()
    }

    #[test]
    fn the_pen_is_lowered_for_every_stroke_and_lifted_after_it() {
        use MoveKind::{Draw, Lift, Lower, Travel};
        let strokes = [
            line(&[(200.0, 0.0), (210.0, 0.0), (210.0, 10.0)]),
            line(&[(220.0, 0.0)]),
        ];
        let plan = plan(&strokes, LinkRate::default());
        let kinds: Vec<MoveKind> = plan.moves.iter().map(|v| v.kind).collect();
        assert_eq!(kinds, [Lower, Draw, Draw, Lift, Travel, Lower, Lift]);
        assert_eq!(plan.start, [200.0, 0.0, -30.0]);
        let ends: Vec<[f64; 3]> = plan.positions().collect();
        assert_eq!(ends[0], [200.0, 0.0, -40.0]);
        assert_eq!(ends[6], [220.0, 0.0, -30.0]);
        assert_eq!(plan.paths(Draw), [strokes[0].clone()]);
        assert_eq!(plan.paths(Travel), [line(&[(210.0, 10.0), (220.0, 0.0)])]);
    }

    #[test]
    fn a_lone_line_takes_what_the_trapezoid_says() {
        // 40 mm at 40 mm/s and 100 mm/s2: 0.4 s up, 0.4 s down over 8 mm each, 24 mm at full speed.
        let plan = plan(&[line(&[(200.0, 0.0), (240.0, 0.0)])], NO_LINK);
        let durations: Vec<f64> = plan.durations().collect();
        assert!((durations[1] - 1.4).abs() < 1e-6, "{durations:?}");
        // 10 mm down at the same acceleration never reach 40 mm/s: 2 sqrt(10 / 100) s.
        assert!((durations[0] - 0.632_455_532).abs() < 1e-6, "{durations:?}");
        let summary = plan.summary();
        assert_eq!((summary.strokes, summary.vectors), (1, 3));
        assert_eq!((summary.drawn_mm, summary.travelled_mm), (40.0, 0.0));
    }

    #[test]
    fn short_vectors_are_as_slow_as_the_link() {
        let points: Vec<(f64, f64)> = (0..100)
            .map(|i| (200.0 + 0.1 * f64::from(i), 0.0))
            .collect();
        let plan = plan(&[line(&points)], LinkRate::default());
        assert!(plan.durations().all(|s| s >= 0.084));
        assert!(plan.duration_s() < 0.084 * 102.0 + 2.0);
    }

    #[test]
    fn rounding_to_single_precision_does_not_add_up() {
        let points: Vec<(f64, f64)> = (0..50_000)
            .map(|i| (200.0 + f64::from(i) / 997.0, 0.0))
            .collect();
        let plan = plan(&[line(&points)], NO_LINK);
        let end = plan.positions().last().unwrap();
        assert!((end[0] - points[points.len() - 1].0).abs() < 1e-6);
    }

    #[test]
    fn nothing_to_draw_is_refused() {
        let planned = Plan::new(&[], &Pen::default(), NO_LINK);
        assert_eq!(planned, Err(PlanError::NoStrokes));
    }

    fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
        let point = (150.0..300.0_f64, -100.0..100.0_f64).prop_map(|(x, y)| Point::new(x, y));
        let near = (-0.5..0.5_f64, -0.5..0.5_f64).prop_map(|(x, y)| Point::new(x, y));
        let stroke = (point, proptest::collection::vec(near, 0..40)).prop_map(|(start, steps)| {
            let mut points = vec![start];
            points.extend(steps.iter().scan(start, |here, step| {
                *here = *here + *step;
                Some(*here)
            }));
            Stroke::open(points)
        });
        proptest::collection::vec(stroke, 1..6)
    }

    proptest! {
        #[test]
        fn speeds_meet_and_neither_arm_nor_link_is_overdriven(
            strokes in strokes(),
            period_s in prop_oneof![Just(0.0), Just(0.084)],
        ) {
            let pen = Pen::default();
            let plan = plan(&strokes, LinkRate { period_s });
            let mut speed = 0.0_f32;
            for (vector, duration) in plan.moves.iter().zip(plan.durations()) {
                prop_assert_eq!(vector.start_speed_mm_s, speed);
                speed = vector.end_speed_mm_s;
                if vector.kind != MoveKind::Draw {
                    prop_assert_eq!(speed, 0.0);
                }
                prop_assert!(vector.start_speed_mm_s.max(speed) <= vector.max_speed_mm_s);
                let v2 = |v: f32| f64::from(v) * f64::from(v);
                let needed = (v2(speed) - v2(vector.start_speed_mm_s)).abs() / (2.0 * vector.length_mm());
                prop_assert!(needed <= pen.acceleration_mm_s2, "{needed}");
                prop_assert!(vector.max_speed_mm_s <= 80.0 && duration >= period_s, "{duration}");
                prop_assert!(vector.length_mm() >= LEAST_VECTOR_MM);
            }
            prop_assert_eq!(speed, 0.0);
        }

        #[test]
        fn every_stroke_is_drawn_where_it_was_wanted(strokes in strokes()) {
            let plan = plan(&strokes, NO_LINK);
            let wanted: Vec<Stroke> = strokes.into_iter().filter(|s| s.length_mm() > 1.0).collect();
            let drawn = plan.paths(MoveKind::Draw);
            let missed = crate::deviation(&wanted, &drawn).missed;
            prop_assert!(missed.distance_mm <= 0.0011, "{missed:?}");
        }
    }
}
