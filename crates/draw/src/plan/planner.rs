//! From strokes to vectors: the ways of the tool, chain by chain.

use super::joints::JointSpeeds;
use super::landing::Landing;
use super::lookahead::Run;
use super::pace::{Pace, Speeds};
use super::ticker::Ticker;
use super::ticks::TICK_S;
use super::vector::length;
use super::{Laser, Machine, MoveKind, Paper, Pass, Pen, PlannedVector, Tool};
use crate::point::{Point, Stroke};

/// Plans one way after the other. A chain is a way between two rests.
pub(super) struct Planner<'a> {
    paper: &'a Paper,
    machine: &'a Machine,
    pace: Pace,
    /// Where the arm has ticks.
    ticker: Option<Ticker>,
    /// Where the vectors so far lead, rounding included.
    here: [f64; 3],
    landing: Landing,
    joints: JointSpeeds,
    pub(super) moves: Vec<PlannedVector>,
    /// Which stroke and pass the next vectors belong to.
    stroke: u32,
    pass: u32,
    /// The runs since the last rest; reused.
    chain: Vec<Run>,
}

impl<'a> Planner<'a> {
    pub(super) fn new(
        start: [f64; 3],
        tool: &Tool,
        paper: &'a Paper,
        machine: &'a Machine,
    ) -> Self {
        Self {
            paper,
            machine,
            pace: Pace::new(machine),
            ticker: machine.has_ticks.then(|| Ticker::new(machine, 0.0)),
            here: start,
            landing: Landing::new(machine, tool),
            joints: JointSpeeds::new(machine.joint_speed_deg_s, tool.reach_mm()),
            moves: Vec::new(),
            stroke: 0,
            pass: 0,
            chain: Vec::new(),
        }
    }

    pub(super) fn pass(&mut self, number: u32, pass: &Pass) {
        self.pass = number;
        let strokes = pass.strokes.iter().filter(|it| !it.points.is_empty());
        match &pass.tool {
            Tool::Pen(pen) => strokes.for_each(|stroke| self.draw(stroke, pen)),
            Tool::Laser(laser) => (0..laser.times)
                .flat_map(|_| strokes.clone())
                .for_each(|stroke| self.burn(stroke, laser)),
        }
    }

    /// ```text
    ///   up    ----> Travel ----.                     .---- Travel ---->
    ///                          | Lower          Lift |
    ///   down                   '-- Draw Draw Draw ---'
    /// ```
    fn draw(&mut self, stroke: &Stroke, pen: &Pen) {
        let (first, last) = (stroke.points[0], stroke.points[stroke.points.len() - 1]);
        self.go(MoveKind::Travel, first, pen.lift_mm, pen.travel_speed_mm_s);
        self.rest();
        if pen.touch_mm > 0.0 && pen.touch_mm < pen.lift_mm {
            self.go(MoveKind::Lower, first, pen.touch_mm, pen.lift_speed_mm_s);
            let slow_mm_s = pen.touch_speed_mm_s.min(pen.lift_speed_mm_s);
            self.go(MoveKind::Lower, first, 0.0, slow_mm_s);
        } else {
            self.go(MoveKind::Lower, first, 0.0, pen.lift_speed_mm_s);
        }
        self.rest();
        for &p in &stroke.points[1..] {
            self.go(MoveKind::Draw, p, 0.0, pen.draw_speed_mm_s);
        }
        self.rest();
        self.go(MoveKind::Lift, last, pen.lift_mm, pen.lift_speed_mm_s);
        self.rest();
        self.stroke += 1;
    }

    /// ```text
    ///   off  -- Travel --> RunUp .                   . RunOut Brake -- Travel -->
    ///   on                       '- Burn Burn Burn --'
    /// ```
    fn burn(&mut self, stroke: &Stroke, laser: &Laser) {
        let Laser {
            burn_speed_mm_s: speed,
            travel_speed_mm_s: travel,
            ..
        } = *laser;
        let ways = Ways::of(stroke, self.here, speed, self.machine);
        self.go(MoveKind::Travel, ways.run_up, 0.0, travel);
        self.rest();
        self.go(MoveKind::RunUp, ways.on, 0.0, speed);
        let inner = 1..stroke.points.len().max(2) - 1;
        for &p in &stroke.points[inner] {
            self.go(MoveKind::Burn, p, 0.0, speed);
        }
        self.go(MoveKind::Burn, ways.off, 0.0, speed);
        self.go(MoveKind::RunOut, ways.run_out, 0.0, speed);
        self.go(MoveKind::Brake, ways.brake, 0.0, speed);
        self.rest();
        self.stroke += 1;
    }

    /// A vector to a place so high above the paper.
    fn go(&mut self, kind: MoveKind, to: Point, above_mm: f64, limit_mm_s: f64) {
        let to = [to.x, to.y, self.paper.z_at(to) + above_mm];
        let here = self.here;
        #[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
        let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| (to[i] - here[i]) as f32);
        let way = [x_mm, y_mm, z_mm].map(f64::from);
        let length_mm = length(way);
        if length_mm < LEAST_VECTOR_MM {
            return;
        }
        self.here = self.landing.of(here, [x_mm, y_mm, z_mm]);
        let limit_mm_s = self.joints.cap(here, way, limit_mm_s);
        self.chain.push(Run {
            direction: way.map(|d| d / length_mm),
            length_mm,
            limit_mm_s,
            ease: 1.0,
        });
        self.moves.push(PlannedVector {
            x_mm,
            y_mm,
            z_mm,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 0.0,
            max_speed_mm_s: 0.0,
            duration_s: 0.0,
            kind,
            stroke: self.stroke,
            pass: self.pass,
        });
    }

    /// The chain ends: its speeds can be planned.
    fn rest(&mut self) {
        let begin = self.moves.len() - self.chain.len();
        self.even_burning(begin);
        let speeds = self.pace.plan(&mut self.chain);
        for (vector, speeds) in self.moves[begin..].iter_mut().zip(speeds) {
            match &mut self.ticker {
                Some(ticker) => ticker.set(vector, speeds),
                None => set(vector, speeds),
            }
        }
        self.chain.clear();
    }
}

/// A laser burns more where it is slower. Where a stroke's corners and short vectors allow nearly its
/// speed, all of the stroke is run at the speed that they do allow.
impl Planner<'_> {
    fn even_burning(&mut self, begin: usize) {
        let burns = |vector: &&PlannedVector| vector.kind == MoveKind::Burn;
        let Some(first) = self.moves[begin..].iter().position(|it| burns(&it)) else {
            return;
        };
        let burned = self.moves[begin..].iter().filter(burns).count();
        let limit_mm_s = self.chain[first].limit_mm_s;
        let mut chain = self.chain.clone();
        let mut pace = self.pace.clone();
        let speeds = pace.plan(&mut chain).skip(first).take(burned);
        let slowest_mm_s = speeds
            .map(|it| it.start_mm_s.min(it.end_mm_s).min(it.max_mm_s))
            .fold(limit_mm_s, f64::min);
        if slowest_mm_s * MOST_SPREAD >= limit_mm_s {
            for run in &mut self.chain {
                run.limit_mm_s = run.limit_mm_s.min(slowest_mm_s);
            }
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
fn set(vector: &mut PlannedVector, speeds: Speeds) {
    vector.start_speed_mm_s = round_down(speeds.start_mm_s);
    vector.end_speed_mm_s = round_down(speeds.end_mm_s);
    vector.max_speed_mm_s = round_down(speeds.max_mm_s);
    vector.duration_s = speeds.duration_s as f32;
}

/// Where a laser gets to its speed before a stroke, and where it loses it behind.
struct Ways {
    run_up: Point,
    /// Where it is switched on and off.
    on: Point,
    off: Point,
    run_out: Point,
    brake: Point,
}

impl Ways {
    fn of(stroke: &Stroke, here: [f64; 3], speed_mm_s: f64, machine: &Machine) -> Self {
        let points = &stroke.points;
        let (first, last) = (points[0], points[points.len() - 1]);
        let come = Point::new(first.x - here[0], first.y - here[1]);
        let into = way_of(stroke.segments()).or_else(|| unit(come));
        let into = into.unwrap_or(Point::new(1.0, 0.0));
        let out = way_of(
            stroke
                .points
                .windows(2)
                .rev()
                .map(|pair| (pair[0], pair[1])),
        )
        .unwrap_or(into);
        let end = if points.len() == 1 {
            first + into * DOT_MM
        } else {
            last
        };
        let packet_mm = speed_mm_s * machine.link.period_s * RUN_SPARE;
        let gain_mm = 0.5 * speed_mm_s * speed_mm_s / machine.acceleration_mm_s2 * RUN_SPARE;
        let gain_mm = gain_mm.max(packet_mm);
        // A stock arm switches the laser a tick before its motors begin the vector.
        let early_mm = if machine.has_ticks {
            speed_mm_s * f64::from(TICK_S)
        } else {
            0.0
        };
        let first_mm = stroke
            .segments()
            .next()
            .map_or(DOT_MM, |(a, b)| a.distance(b));
        let off = end + out * early_mm;
        let run_out = off + out * packet_mm.max(LEAST_RUN_OUT_MM);
        Self {
            run_up: first - into * gain_mm,
            on: first + into * early_mm.min(0.5 * first_mm),
            off,
            run_out,
            brake: run_out + out * gain_mm,
        }
    }
}

/// The direction of the first piece that has one.
fn way_of(mut segments: impl Iterator<Item = (Point, Point)>) -> Option<Point> {
    segments.find_map(|(a, b)| unit(b - a))
}

fn unit(way: Point) -> Option<Point> {
    let length = way.length();
    (length >= LEAST_VECTOR_MM).then(|| way * (1.0 / length))
}

/// The largest single-precision number that is not above `value`.
pub(super) fn round_down(value: f64) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "corrected below")]
    let nearest = value as f32;
    if f64::from(nearest) > value {
        nearest.next_down()
    } else {
        nearest
    }
}

pub(super) const LEAST_VECTOR_MM: f64 = 0.001;
/// A laser burns a dot as a line, as long as its spot is wide.
const DOT_MM: f64 = 0.1;
/// How much more may be burned on a millimetre for it to be as much everywhere.
const MOST_SPREAD: f64 = 1.2;
const LEAST_RUN_OUT_MM: f64 = 0.1;
/// Ways to get faster and slower are a little longer than they have to be, for rounding.
const RUN_SPARE: f64 = 1.01;
