//! The rules in force on a way: those of the policy, wider where the arm stands outside already.

use dobot_arm::{Calibration, Tool, Unreachable};
use dobot_motion::{ArmPlace, Interpolation};

use crate::body::{Body, MEASURES, measures};
use crate::limits::{LASER_AREA, Limit};
use crate::sweep::Sweep;
use crate::{Bounds, KeepOut, Policy};

/// The rules in force on a way.
///
/// An arm that stands outside of a rule may come back in, not go deeper: there the rule in force is
/// as wide as the arm stands outside, and it becomes narrower as the arm comes in; that of a keep-out
/// when the arm has left it.
#[derive(Debug)]
pub(crate) struct Fence<'a> {
    limits: Vec<Gate>,
    keep_outs: Vec<Fenced<'a>>,
    tool: Tool,
    tip_mm: f64,
    arm: Calibration,
}

/// A place on a way, and all that the rules want to know of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PathPoint {
    /// The share of the segment behind it.
    pub(crate) share: f64,
    /// Where the arm says that it is.
    pub(crate) told: ArmPlace,
    /// Where it truly is, by which the rules judge.
    pub(crate) place: ArmPlace,
    pub(crate) measures: [f64; MEASURES],
    pub(crate) body: Body,
}

/// What forbids a place, or the way between two.
#[derive(Clone, Debug)]
pub(crate) enum Broken {
    /// A measure is out of bounds.
    Limit(Limit),
    /// A part of the arm touches a keep-out.
    KeepOut { name: String, part: &'static str },
    /// The arm cannot be there at all.
    Unreachable(Unreachable),
    /// The arm is folded or stretched so far that its joints may turn at any speed.
    Unclear,
}

/// A limit, and what it is now.
#[derive(Debug)]
struct Gate {
    limit: Limit,
    now: Bounds,
}

/// A keep-out, and by how much it is larger now.
#[derive(Debug)]
struct Fenced<'a> {
    name: &'a str,
    keep_out: &'a KeepOut,
    /// The thickness of the arm, and the resolution.
    strict_mm: f64,
    now_mm: f64,
}

impl<'a> Fence<'a> {
    /// The rules of a policy for an arm with this tool, which differs so from the drawing of it.
    pub(crate) fn new(policy: &'a Policy, tool: Tool, arm: Calibration, burning: bool) -> Self {
        let gate = |limit: Limit| Gate {
            limit,
            now: limit.bounds.grown(ROUNDING),
        };
        let strict_mm = policy.arm.radius_mm + RESOLUTION_MM;
        let fenced = |(name, keep_out): (&'a String, &'a KeepOut)| Fenced {
            name,
            keep_out,
            strict_mm,
            now_mm: strict_mm,
        };
        Self {
            limits: policy
                .limits(tool, &arm, burning)
                .into_iter()
                .map(gate)
                .collect(),
            keep_outs: policy.keep_out.iter().map(fenced).collect(),
            tool,
            tip_mm: policy.tool_length.of(tool),
            arm,
        }
    }

    /// Looks at a place that the arm says.
    pub(crate) fn stop(&self, share: f64, told: ArmPlace) -> PathPoint {
        let place = told.calibrated(&self.arm, self.tool);
        PathPoint {
            share,
            told,
            place,
            measures: measures(&place, &self.arm),
            body: Body::new(&place, self.tool, self.tip_mm, &self.arm),
        }
    }

    /// The way begins here: where the arm is outside, the rules are that wide.
    pub(crate) fn begin(&mut self, at: &PathPoint) {
        for gate in &mut self.limits {
            if gate.limit.key != LASER_AREA {
                gate.now = gate.wide_enough_for(at);
            }
        }
        for fenced in &mut self.keep_outs {
            fenced.now_mm = fenced.from(&at.body);
        }
    }

    /// The way came here: the rules become narrower, where they were too wide.
    pub(crate) fn advance(&mut self, to: &PathPoint) {
        for gate in &mut self.limits {
            let still = gate.wide_enough_for(to);
            gate.now.min = gate.now.min.max(still.min);
            gate.now.max = gate.now.max.min(still.max);
        }
        for fenced in &mut self.keep_outs {
            if fenced.now_mm < fenced.strict_mm && fenced.is_clear_at(&to.body) {
                fenced.now_mm = fenced.strict_mm;
            }
        }
    }

    /// All that forbids a place.
    pub(crate) fn broken_at<'b>(&'b self, at: &'b PathPoint) -> impl Iterator<Item = Broken> + 'b {
        let outside =
            |gate: &&'b Gate| !gate.now.contains(at.measures[gate.limit.measure as usize]);
        let limits = self.limits.iter().filter(outside);
        let keep_outs = self.keep_outs.iter().filter_map(|fenced| {
            let lines = at.body.lines();
            let part = lines
                .iter()
                .position(|line| fenced.keep_out.touches(line, fenced.now_mm))?;
            Some(fenced.broken(part))
        });
        limits
            .map(|gate| Broken::Limit(gate.limit))
            .chain(keep_outs)
    }

    /// What may forbid a place between two of a segment; `None` where none is forbidden for sure.
    pub(crate) fn broken_between(
        &self,
        interpolation: Interpolation,
        a: &PathPoint,
        b: &PathPoint,
    ) -> Option<Broken> {
        let Some(sweep) = Sweep::between(interpolation, &a.told, &b.told, self.tool, &self.arm)
        else {
            return Some(Broken::Unclear);
        };
        let outside = |gate: &&Gate| {
            let index = gate.limit.measure as usize;
            let span = sweep.span(gate.limit.measure, a.measures[index], b.measures[index]);
            !(gate.now.contains(span.min) && gate.now.contains(span.max))
        };
        if let Some(gate) = self.limits.iter().find(outside) {
            return Some(Broken::Limit(gate.limit));
        }
        let keep_outs = &self.keep_outs;
        keep_outs
            .iter()
            .find_map(|fenced| fenced.broken_between(&sweep, &a.body, &b.body))
    }
}

impl Gate {
    fn wide_enough_for(&self, at: &PathPoint) -> Bounds {
        let value = at.measures[self.limit.measure as usize];
        let Bounds { min, max } = self.limit.bounds;
        Bounds::new(min.min(value), max.max(value)).grown(ROUNDING)
    }
}

impl PathPoint {
    /// Whether another place is so near that there is no telling between the two.
    pub(crate) fn is_next_to(&self, other: &Self) -> bool {
        let turned = |index: usize| (self.measures[index] - other.measures[index]).abs();
        self.body.apart(&other.body) <= LEAF_MM && (0..4).all(|index| turned(index) <= LEAF_DEG)
    }
}

impl Fenced<'_> {
    /// By how much it is larger for an arm that begins here.
    fn from(&self, body: &Body) -> f64 {
        let room_mm = self.keep_out.room(&body.lines(), self.strict_mm);
        if room_mm < self.strict_mm {
            room_mm - ROOM_MM
        } else {
            self.strict_mm
        }
    }

    fn is_clear_at(&self, body: &Body) -> bool {
        let mut lines = body.lines().into_iter();
        !lines.any(|line| self.keep_out.touches(&line, self.strict_mm))
    }

    fn broken_between(&self, sweep: &Sweep, a: &Body, b: &Body) -> Option<Broken> {
        let (from, to, strays) = (a.lines(), b.lines(), sweep.strays_mm());
        let touched = |&part: &usize| {
            let swept = [from[part], to[part]];
            !self
                .keep_out
                .is_clear_of(&swept, self.now_mm + strays[part])
        };
        (0..PARTS.len()).find(touched).map(|part| self.broken(part))
    }

    fn broken(&self, part: usize) -> Broken {
        Broken::KeepOut {
            name: self.name.to_owned(),
            part: PARTS[part],
        }
    }
}

/// The lines of a [`Body`].
const PARTS: [&str; 4] = ["rear arm", "forearm", "hand", "tool"];

/// What rounding may add to a value right on a bound.
const ROUNDING: f64 = 1e-6;

/// Keep-outs are larger by this: nothing thinner slips through.
const RESOLUTION_MM: f64 = 0.1;

/// What is left of the resolution for an arm that stands right at a keep-out, to get away from it.
const ROOM_MM: f64 = 0.03;

/// Where nothing moves more than this between two places, they are one.
const LEAF_MM: f64 = 0.02;
const LEAF_DEG: f64 = 0.02;
