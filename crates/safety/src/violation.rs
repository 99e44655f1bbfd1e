//! Which rule forbids a command, where on its way, and what would be allowed.

use std::fmt;

use dobot_arm::{Quantity, Unreachable};
use dobot_course::CourseError;
use schemars::JsonSchema;
use serde::Serialize;

use crate::Bounds;
use crate::fence::{Broken, Stop};
use crate::limits::Limit;
use crate::walk::Breach;

/// Which rule forbids a command, where on its way, and what would be allowed.
///
/// As text it is one line that says all of it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema, thiserror::Error)]
#[error("{message}")]
pub struct Violation {
    /// The key of the rule in the policy, such as `keep_out.camera`, `joints.base` or `table`;
    /// `arm` where the arm itself cannot do it.
    pub rule: String,
    /// What is wrong, in one line.
    pub message: String,
    /// What the rule found, in its unit: the value farthest from what is allowed, where it is about
    /// a value.
    pub found: Option<f64>,
    /// What the rule allows, in its unit.
    pub allowed: Option<Bounds>,
    /// The allowed value nearest to what was found.
    pub nearest_value: Option<f64>,
    /// The first place on the way that is forbidden.
    pub at: Option<Spot>,
    /// The last place on the way that is allowed: x, y and z in mm.
    pub nearest: Option<[f64; 3]>,
}

/// A place on a way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Spot {
    /// x, y and z of the tool in mm, as the arm tells them.
    pub position_mm: [f64; 3],
    /// Base, rear arm, forearm and servo in degrees.
    pub joints_deg: [f64; 4],
    /// How far along the way of the tool, in mm.
    pub along_mm: f64,
    /// How long after the command began, in s; `None` for a jog.
    pub after_s: Option<f64>,
}

impl Violation {
    /// A value that is not allowed, at no place on a way.
    pub(crate) fn of_value(
        rule: &str,
        name: &str,
        found: f64,
        allowed: Bounds,
        unit: &str,
    ) -> Self {
        let message = format!(
            "{name} would be {}{unit}; {rule} allows {}",
            Told(found),
            Allowed(allowed, unit)
        );
        Self {
            found: Some(found),
            allowed: Some(allowed),
            nearest_value: Some(allowed.nearest(found)),
            ..Self::of_words(rule, message)
        }
    }

    /// A rule that is not about a value.
    pub(crate) fn of_words(rule: &str, message: String) -> Self {
        Self {
            rule: rule.to_owned(),
            message,
            found: None,
            allowed: None,
            nearest_value: None,
            at: None,
            nearest: None,
        }
    }

    /// A command that leads nowhere.
    pub(crate) fn of_course(error: &CourseError) -> Self {
        match error {
            CourseError::Unreachable(unreachable) => Self::of_arm(unreachable),
            other => Self::of_words(ARM, other.to_string()),
        }
    }

    /// A place where the arm cannot be; the rule is the one that says so at its widest.
    pub(crate) fn of_arm(error: &Unreachable) -> Self {
        let message = error.to_string();
        let Unreachable::OutOfRange {
            quantity,
            found,
            min,
            max,
        } = *error
        else {
            return Self::of_words(ARM, message);
        };
        let allowed = Bounds::new(min, max);
        Self {
            found: Some(found),
            allowed: Some(allowed),
            nearest_value: Some(allowed.nearest(found)),
            ..Self::of_words(key_of(quantity), message)
        }
    }

    /// A way that breaks a rule; `worst` is its value farthest from what the rule allows.
    pub(crate) fn of_breach(breach: &Breach, worst: impl Fn(&Limit) -> f64) -> Self {
        let told = Self::of_broken(&breach.broken, worst);
        let nearest = position(&breach.nearest);
        let [x, y, z] = nearest.map(Told);
        let message = format!(
            "{}; the way is free for {} mm{}, as far as x {x} y {y} z {z} mm",
            told.message,
            Told(breach.gone_mm),
            Seconds(breach.at_s),
        );
        let at = breach.at.map(|stop| Spot {
            along_mm: breach.gone_mm,
            after_s: breach.at_s,
            ..Spot::of(&stop)
        });
        Self {
            message,
            at,
            nearest: Some(nearest),
            ..told
        }
    }

    /// A place that breaks a rule, while nothing moves.
    pub(crate) fn of_place(broken: &Broken, stop: &Stop) -> Self {
        Self {
            at: Some(Spot::of(stop)),
            ..Self::of_broken(broken, |limit| stop.measures[limit.measure as usize])
        }
    }

    fn of_broken(broken: &Broken, found: impl Fn(&Limit) -> f64) -> Self {
        match broken {
            Broken::Limit(limit) => {
                let (name, unit) = limit.measure.words();
                Self::of_value(limit.key, name, found(limit), limit.bounds, unit)
            }
            Broken::Zone { name, part } => {
                let rule = format!("keep_out.{name}");
                let message = format!("the {part} would touch {rule}");
                Self::of_words(&rule, message)
            }
            Broken::Unreachable(error) => Self::of_arm(error),
            Broken::Unclear => Self::of_words(ARM, UNCLEAR.to_owned()),
        }
    }
}

impl Spot {
    const fn of(stop: &Stop) -> Self {
        let joints = stop.place.joints;
        Self {
            position_mm: position(stop),
            joints_deg: [joints.base.0, joints.rear.0, joints.fore.0, joints.servo.0],
            along_mm: 0.0,
            after_s: None,
        }
    }
}

const fn position(stop: &Stop) -> [f64; 3] {
    let position = stop.place.pose.position;
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

/// Two decimals at most.
struct Told(f64);

impl fmt::Display for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The sum turns a negative zero into zero.
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}

struct Allowed<'a>(Bounds, &'a str);

impl fmt::Display for Allowed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(Bounds { min, max }, unit) = *self;
        match (min.is_finite(), max.is_finite()) {
            (true, true) => write!(f, "{} to {}{unit}", Told(min), Told(max)),
            (true, false) => write!(f, "{}{unit} and more", Told(min)),
            (false, _) => write!(f, "{}{unit} and less", Told(max)),
        }
    }
}

struct Seconds(Option<f64>);

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0
            .map_or(Ok(()), |after_s| write!(f, " and {} s", Told(after_s)))
    }
}

/// The rule of what the arm itself cannot do.
pub(crate) const ARM: &str = "arm";

const UNCLEAR: &str = "the arm would be folded or stretched so far that a straight line turns its joints at any speed; move it by its joints (movj, joint jog)";
