//! Violations of the policy: the rule, the location on the path, and what is allowed.

use std::fmt;

use dobot_arm::{Quantity, Unreachable};
use dobot_motion::TrajectoryError;
use schemars::JsonSchema;
use serde::Serialize;

use crate::Bounds;
use crate::effective_rules::{Broken, PathPoint};
use crate::limits::{BELOW_PAPER, Limit, TABLE};
use crate::path_check::Breach;

/// A violation of the policy: the rule, the location on the path, and what is allowed.
///
/// Its text states all of it in one line.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema, thiserror::Error)]
#[error("{message}")]
pub struct Violation {
    /// The key of the rule in the policy, such as `keep_out.camera`, `joints.base` or `table`;
    /// `arm` if the arm itself cannot do it.
    pub rule: String,
    /// What is wrong, in one line.
    pub message: String,
    /// The value found and the values allowed, if the rule is about a value.
    pub value: Option<Box<RejectedValue>>,
    /// The first forbidden location on the path.
    pub at: Option<Box<Location>>,
    /// The last allowed position on the path: x, y and z in mm.
    pub nearest: Option<[f64; 3]>,
}

/// A value that is not allowed, in the unit of its rule.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RejectedValue {
    /// The value found; on a path, the value farthest outside.
    pub found: f64,
    /// The values allowed.
    pub allowed: Bounds,
    /// The allowed value nearest to what was found.
    pub nearest: f64,
}

/// A location on a path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Location {
    /// x, y and z of the tool in mm, calibrated.
    pub position_mm: [f64; 3],
    /// Base, rear arm, forearm and servo in degrees.
    pub joints_deg: [f64; 4],
    /// The distance along the tool's path, in mm.
    pub along_mm: f64,
    /// The time since the command began, in s; `None` for a jog.
    pub after_s: Option<f64>,
}

impl Violation {
    /// A value that is not allowed, not on a path.
    pub(crate) fn of_value(
        rule: &str,
        name: &str,
        found: f64,
        allowed: Bounds,
        unit: &str,
    ) -> Self {
        let found_here = Distinct {
            found,
            than: allowed.nearest(found),
        };
        let least = Rounded(allowed.min);
        let message = if rule == TABLE || rule == BELOW_PAPER {
            format!(
                "{name} would be {found_here}{unit}; {rule} allows {least}{unit} and more with this tool"
            )
        } else {
            let most = Rounded(allowed.max);
            format!("{name} would be {found_here}{unit}; {rule} allows {least} to {most}{unit}")
        };
        Self {
            value: Some(Box::new(RejectedValue::new(found, allowed))),
            ..Self::of_words(rule, message)
        }
    }

    /// A rule that is not about a value.
    pub(crate) fn of_words(rule: &str, message: String) -> Self {
        Self {
            rule: rule.to_owned(),
            message,
            value: None,
            at: None,
            nearest: None,
        }
    }

    /// A command without a trajectory.
    #[must_use]
    pub fn of_trajectory(error: &TrajectoryError) -> Self {
        match error {
            TrajectoryError::Unreachable(unreachable) => Self::of_arm(unreachable),
            other => Self::of_words(ARM, other.to_string()),
        }
    }

    /// A position that the arm cannot reach; the rule is the one that says so at its widest.
    pub(crate) fn of_arm(error: &Unreachable) -> Self {
        let message = error.to_string();
        match *error {
            Unreachable::OutOfRange {
                quantity,
                found,
                min,
                max,
            } => {
                let allowed = Bounds::new(if min.is_finite() { min } else { LEAST }, max);
                Self {
                    value: Some(Box::new(RejectedValue::new(found, allowed))),
                    ..Self::of_words(key_of(quantity), message)
                }
            }
            _ => Self::of_words(ARM, message),
        }
    }

    /// A path that breaks a rule; `worst` returns the value farthest outside.
    pub(crate) fn of_breach(breach: &Breach, worst: impl Fn(&Limit) -> f64) -> Self {
        let violation = Self::of_broken(&breach.broken, worst);
        let nearest = position(&breach.nearest);
        let [x, y, z] = nearest.map(Rounded);
        let message = format!(
            "{}; the path is free for {} mm{}, up to x {x} y {y} z {z} mm",
            violation.message,
            Rounded(breach.covered_mm),
            Seconds(breach.at_s),
        );
        let location = |point: PathPoint| Location {
            along_mm: breach.covered_mm,
            after_s: breach.at_s,
            ..Location::of(&point)
        };
        Self {
            message,
            at: breach.at.map(location).map(Box::new),
            nearest: Some(nearest),
            ..violation
        }
    }

    /// A position that breaks a rule, without motion.
    pub(crate) fn of_place(broken: &Broken, point: &PathPoint) -> Self {
        Self {
            at: Some(Box::new(Location::of(point))),
            ..Self::of_broken(broken, |limit| point.measures[limit.measure as usize])
        }
    }

    /// Adds that this is about a jog, which continues until it is stopped.
    pub(crate) fn before_a_stop(self) -> Self {
        let message = format!("before the jog can be stopped, {}", self.message);
        Self { message, ..self }
    }

    fn of_broken(broken: &Broken, found: impl Fn(&Limit) -> f64) -> Self {
        match broken {
            Broken::Limit(limit) => {
                let (name, unit) = limit.measure.words();
                Self::of_value(limit.key, name, found(limit), limit.bounds, unit)
            }
            Broken::KeepOut { name, part } => {
                let rule = format!("keep_out.{name}");
                let message = format!("the {part} would touch {rule}");
                Self::of_words(&rule, message)
            }
            Broken::Unreachable(error) => Self::of_arm(error),
            Broken::Unclear => Self::of_words(ARM, UNCLEAR.to_owned()),
        }
    }
}

impl RejectedValue {
    const fn new(found: f64, allowed: Bounds) -> Self {
        Self {
            found,
            allowed,
            nearest: allowed.nearest(found),
        }
    }
}

impl Location {
    const fn of(point: &PathPoint) -> Self {
        Self {
            position_mm: position(point),
            joints_deg: point.place.joints.angles_deg(),
            along_mm: 0.0,
            after_s: None,
        }
    }
}

const fn position(point: &PathPoint) -> [f64; 3] {
    let position = point.place.pose.position;
    [position.x.0, position.y.0, position.z.0]
}

const fn key_of(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Base => "joints.base",
        Quantity::Rear => "joints.rear",
        Quantity::Fore => "joints.fore",
        Quantity::Servo => "joints.servo",
        Quantity::Opening => "joints.opening",
        Quantity::Reach => "workspace.reach",
        Quantity::Z => "workspace.z",
        _ => ARM,
    }
}

/// Formats with at most two decimals.
struct Rounded(f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The sum turns a negative zero into zero.
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}

/// Formats with two decimals, or as many more as needed to differ from another value.
struct Distinct {
    found: f64,
    than: f64,
}

impl fmt::Display for Distinct {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded = |scale: f64| (self.found * scale).round() / scale + 0.0;
        let than = Rounded(self.than).to_string();
        let clear = [1e2, 1e3, 1e4].map(|scale| rounded(scale).to_string());
        let clear = clear.into_iter().find(|text| *text != than);
        f.write_str(&clear.unwrap_or_else(|| self.found.to_string()))
    }
}

struct Seconds(Option<f64>);

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0
            .map_or(Ok(()), |after_s| write!(f, " and {} s", Rounded(after_s)))
    }
}

/// The rule for what the arm itself cannot do.
pub(crate) const ARM: &str = "arm";

/// A lower bound for quantities of the arm without one, in degrees or mm: less than it can ever be.
const LEAST: f64 = -300.0;

const UNCLEAR: &str = "the arm would be folded or stretched so far that a straight line turns its joints at any speed; move it by its joints (movj, joint jog)";
