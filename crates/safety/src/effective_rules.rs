//! The effective rules on a path: those of the policy, widened if the arm is already outside.

use dobot_arm::{Calibration, Tool, Unreachable};
use dobot_motion::{ArmPlace, Interpolation};

use crate::body::{Body, MEASURES, measures};
use crate::limits::{LASER_AREA, Limit};
use crate::swept_path::SweptPath;
use crate::{Bounds, KeepOut, Policy};

/// The effective rules on a path.
///
/// An arm outside a rule may come back in, but not go deeper: the effective rule is as wide as the
/// arm is outside, and narrows as the arm comes in; a keep-out applies again in full once the arm
/// has left it.
#[derive(Debug)]
pub(crate) struct EffectiveRules<'a> {
    limits: Vec<EffectiveLimit>,
    keep_outs: Vec<EffectiveKeepOut<'a>>,
    tool: Tool,
    tip_mm: f64,
    arm: Calibration,
}

/// A point on a path, with all that the rules need.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PathPoint {
    /// The share of the segment already covered.
    pub(crate) share: f64,
    /// The raw position.
    pub(crate) raw: ArmPlace,
    /// The calibrated position, to which the rules apply.
    pub(crate) place: ArmPlace,
    pub(crate) measures: [f64; MEASURES],
    pub(crate) body: Body,
}

/// What forbids a position, or the path between two.
#[derive(Clone, Debug)]
pub(crate) enum Broken {
    /// A measure is out of bounds.
    Limit(Limit),
    /// A part of the arm touches a keep-out.
    KeepOut { name: String, part: &'static str },
    /// The arm cannot reach the position.
    Unreachable(Unreachable),
    /// The arm is folded or stretched so far that its joints may turn at any speed.
    Unclear,
}

/// A limit and its current bounds.
#[derive(Debug)]
struct EffectiveLimit {
    limit: Limit,
    now: Bounds,
}

/// A keep-out and its current margin.
#[derive(Debug)]
struct EffectiveKeepOut<'a> {
    name: &'a str,
    shape: &'a KeepOut,
    /// The arm's radius plus the resolution.
    strict_mm: f64,
    now_mm: f64,
}

impl<'a> EffectiveRules<'a> {
    /// Returns the rules of a policy for an arm with this tool and calibration.
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

    /// Evaluates a raw position.
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

    /// Starts the path here: where the arm is outside, the rules are widened.
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

    /// Advances along the path: widened rules become narrower.
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

    /// Returns everything that forbids a point.
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

    /// Returns what may forbid a position between two of a segment; `None` if all are certainly
    /// allowed.
    pub(crate) fn broken_between(
        &self,
        interpolation: Interpolation,
        a: &PathPoint,
        b: &PathPoint,
    ) -> Option<Broken> {
        let shares = [a.share, b.share];
        let swept = SweptPath::between(interpolation, shares, &a.raw, &b.raw, self.tool, &self.arm);
        let Some(swept) = swept else {
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
        let mut keep_outs = self.keep_outs.iter();
        keep_outs.find_map(|keep_out| keep_out.broken_between(&swept, &a.body, &b.body))
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
    /// Returns whether another point is indistinguishably close.
    pub(crate) fn is_next_to(&self, other: &Self) -> bool {
        let turned = |index: usize| (self.measures[index] - other.measures[index]).abs();
        self.body.apart(&other.body) <= LEAF_MM && (0..4).all(|index| turned(index) <= LEAF_DEG)
    }
}

impl EffectiveKeepOut<'_> {
    /// Returns the margin for an arm that starts here.
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

/// The rounding error of a value on a bound.
const ROUNDING: f64 = 1e-6;

/// The extra margin of keep-outs: nothing thinner slips through.
const RESOLUTION_MM: f64 = 0.1;

/// The margin left for an arm that stands directly at a keep-out, to move away from it.
const ROOM_MM: f64 = 0.03;

/// Two points between which nothing moves more than this count as one.
const LEAF_MM: f64 = 0.02;
const LEAF_DEG: f64 = 0.02;
