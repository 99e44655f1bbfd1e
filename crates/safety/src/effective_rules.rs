//! The rules in force on a way: those of the policy, wider where the arm stands outside already.

use dobot_arm::{Calibration, Tool, Unreachable};
use dobot_motion::{ArmPlace, Interpolation};

use crate::body::{Body, MEASURES, measures};
use crate::limits::{LASER_AREA, Limit};
use crate::swept_path::SweptPath;
use crate::{Bounds, KeepOut, Policy};

/// The rules in force on a way.
///
/// An arm that stands outside of a rule may come back in, not go deeper: there the rule in force is
/// as wide as the arm stands outside, and it becomes narrower as the arm comes in; that of a keep-out
/// when the arm has left it.
#[derive(Debug)]
pub(crate) struct EffectiveRules<'a> {
    limits: Vec<EffectiveLimit>,
    keep_outs: Vec<EffectiveKeepOut<'a>>,
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
    pub(crate) raw: ArmPlace,
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
struct EffectiveLimit {
    limit: Limit,
    now: Bounds,
}

/// A keep-out, and by how much it is larger now.
#[derive(Debug)]
struct EffectiveKeepOut<'a> {
    name: &'a str,
    shape: &'a KeepOut,
    /// The thickness of the arm, and the resolution.
    strict_mm: f64,
    now_mm: f64,
}

impl<'a> EffectiveRules<'a> {
    /// The rules of a policy for an arm with this tool, which differs so from the drawing of it.
    pub(crate) fn new(policy: &'a Policy, tool: Tool, arm: Calibration, burning: bool) -> Self {
        let effective = |limit: Limit| EffectiveLimit {
            limit,
            now: limit.bounds.grown(ROUNDING),
        };
        let strict_mm = policy.arm.radius_mm + RESOLUTION_MM;
        let effective_keep_out = |(name, keep_out): (&'a String, &'a KeepOut)| EffectiveKeepOut {
            name,
            shape: keep_out,
            strict_mm,
            now_mm: strict_mm,
        };
        Self {
            limits: policy
                .limits(tool, &arm, burning)
                .into_iter()
                .map(effective)
                .collect(),
            keep_outs: policy.keep_out.iter().map(effective_keep_out).collect(),
            tool,
            tip_mm: policy.tool_length.of(tool),
            arm,
        }
    }

    /// Looks at a place that the arm says.
    pub(crate) fn point_at(&self, share: f64, raw: ArmPlace) -> PathPoint {
        let place = raw.calibrated(&self.arm, self.tool);
        PathPoint {
            share,
            raw,
            place,
            measures: measures(&place, &self.arm),
            body: Body::new(&place, self.tool, self.tip_mm, &self.arm),
        }
    }

    /// The way begins here: where the arm is outside, the rules are that wide.
    pub(crate) fn begin(&mut self, at: &PathPoint) {
        for effective in &mut self.limits {
            if effective.limit.key != LASER_AREA {
                effective.now = effective.wide_enough_for(at);
            }
        }
        for keep_out in &mut self.keep_outs {
            keep_out.now_mm = keep_out.from(&at.body);
        }
    }

    /// The way came here: the rules become narrower, where they were too wide.
    pub(crate) fn advance(&mut self, to: &PathPoint) {
        for effective in &mut self.limits {
            let allowed = effective.wide_enough_for(to);
            effective.now.min = effective.now.min.max(allowed.min);
            effective.now.max = effective.now.max.min(allowed.max);
        }
        for keep_out in &mut self.keep_outs {
            if keep_out.now_mm < keep_out.strict_mm && keep_out.is_clear_at(&to.body) {
                keep_out.now_mm = keep_out.strict_mm;
            }
        }
    }

    /// All that forbids a place.
    pub(crate) fn broken_at<'b>(&'b self, at: &'b PathPoint) -> impl Iterator<Item = Broken> + 'b {
        let outside = |effective: &&'b EffectiveLimit| {
            !effective
                .now
                .contains(at.measures[effective.limit.measure as usize])
        };
        let limits = self.limits.iter().filter(outside);
        let keep_outs = self.keep_outs.iter().filter_map(|keep_out| {
            let lines = at.body.lines();
            let part = lines
                .iter()
                .position(|line| keep_out.shape.touches(line, keep_out.now_mm))?;
            Some(keep_out.broken(part))
        });
        limits
            .map(|effective| Broken::Limit(effective.limit))
            .chain(keep_outs)
    }

    /// What may forbid a place between two of a segment; `None` where none is forbidden for sure.
    pub(crate) fn broken_between(
        &self,
        interpolation: Interpolation,
        a: &PathPoint,
        b: &PathPoint,
    ) -> Option<Broken> {
        let Some(swept) = SweptPath::between(interpolation, &a.raw, &b.raw, self.tool, &self.arm)
        else {
            return Some(Broken::Unclear);
        };
        let outside = |effective: &&EffectiveLimit| {
            let index = effective.limit.measure as usize;
            let span = swept.span(
                effective.limit.measure,
                a.measures[index],
                b.measures[index],
            );
            !(effective.now.contains(span.min) && effective.now.contains(span.max))
        };
        if let Some(effective) = self.limits.iter().find(outside) {
            return Some(Broken::Limit(effective.limit));
        }
        let keep_outs = &self.keep_outs;
        keep_outs
            .iter()
            .find_map(|keep_out| keep_out.broken_between(&swept, &a.body, &b.body))
    }
}

impl EffectiveLimit {
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

impl EffectiveKeepOut<'_> {
    /// By how much it is larger for an arm that begins here.
    fn from(&self, body: &Body) -> f64 {
        let room_mm = self.shape.room(&body.lines(), self.strict_mm);
        if room_mm < self.strict_mm {
            room_mm - ROOM_MM
        } else {
            self.strict_mm
        }
    }

    fn is_clear_at(&self, body: &Body) -> bool {
        let mut lines = body.lines().into_iter();
        !lines.any(|line| self.shape.touches(&line, self.strict_mm))
    }

    fn broken_between(&self, swept: &SweptPath, a: &Body, b: &Body) -> Option<Broken> {
        let (from, to, strays) = (a.lines(), b.lines(), swept.strays_mm());
        let touched = |&part: &usize| {
            let swept = [from[part], to[part]];
            !self.shape.is_clear_of(&swept, self.now_mm + strays[part])
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
