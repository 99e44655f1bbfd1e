//! The arm's parts at one position, and the quantities that the rules measure.

use dobot_arm::{Calibration, FOREARM, REAR_ARM, Tool};
use dobot_motion::ArmPlace;

use crate::distance::distance;

/// The arm at one position, as lines through its links.
///
/// ```text
///       elbow          All lie in one upright plane through the axis of the base.
///        /\
///       /  \ forearm
///      /    \  wrist____ tool
/// pivot               |
///                     | tip
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct Body {
    pivot: [f64; 3],
    pub(crate) elbow: [f64; 3],
    pub(crate) wrist: [f64; 3],
    pub(crate) tool: [f64; 3],
    pub(crate) tip: [f64; 3],
}

/// The quantities that the rules measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    Base,
    Rear,
    Fore,
    Servo,
    Opening,
    X,
    Y,
    Z,
    Reach,
    AboveTable,
}

/// The number of [`Measure`]s.
pub(crate) const MEASURES: usize = 10;

impl Body {
    /// Builds the body of an arm with this calibration at a calibrated position.
    pub(crate) fn new(place: &ArmPlace, tool: Tool, tip_mm: f64, arm: &Calibration) -> Self {
        let position = place.pose.position;
        let [axis_x, axis_y] = arm.axis_mm;
        let (x, y, z) = (position.x.0 - axis_x, position.y.0 - axis_y, position.z.0);
        let reach = x.hypot(y);
        let (cos_base, sin_base) = direction([x, y], reach, place, arm);
        let (sin_rear, cos_rear) = place.joints.rear.0.to_radians().sin_cos();
        let at = |out: f64, z: f64| [axis_x + out * cos_base, axis_y + out * sin_base, z];
        // The hand goes from the wrist to the tool, wherever it is.
        let wrist = if arm.is_none() {
            reach - tool.reach().0
        } else {
            let joints = place.joints;
            let fore_mm = FOREARM.0 * joints.fore.0.to_radians().cos();
            REAR_ARM.0 * sin_rear + fore_mm
        };
        Self {
            pivot: [axis_x, axis_y, 0.0],
            elbow: at(REAR_ARM.0 * sin_rear, REAR_ARM.0 * cos_rear),
            wrist: at(wrist, z),
            tool: [position.x.0, position.y.0, z],
            tip: [position.x.0, position.y.0, z - tip_mm],
        }
    }

    /// Returns the lines of rear arm, forearm, hand and tool.
    pub(crate) const fn lines(&self) -> [[[f64; 3]; 2]; 4] {
        [
            [self.pivot, self.elbow],
            [self.elbow, self.wrist],
            [self.wrist, self.tool],
            [self.tool, self.tip],
        ]
    }

    /// Returns the distance moved by the part that moves most between two bodies.
    pub(crate) fn apart(&self, other: &Self) -> f64 {
        distance(self.elbow, other.elbow)
            .max(distance(self.wrist, other.wrist))
            .max(distance(self.tool, other.tool))
    }
}

/// Returns cosine and sine of the base angle of an arm that reaches `reach` mm to x and y.
fn direction([x, y]: [f64; 2], reach: f64, place: &ArmPlace, arm: &Calibration) -> (f64, f64) {
    if reach == 0.0 {
        return (1.0, 0.0);
    }
    if arm.left_mm == 0.0 {
        return (x / reach, y / reach);
    }
    let (sin, cos) = place.joints.base.0.to_radians().sin_cos();
    (cos, sin)
}

impl Measure {
    /// Returns name and unit.
    pub(crate) const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Base => ("base angle", "°"),
            Self::Rear => ("rear arm angle", "°"),
            Self::Fore => ("forearm angle", "°"),
            Self::Servo => ("servo angle", "°"),
            Self::Opening => ("rear arm minus forearm angle", "°"),
            Self::X => ("x", " mm"),
            Self::Y => ("y", " mm"),
            Self::Z => ("z", " mm"),
            Self::Reach => ("reach", " mm"),
            Self::AboveTable => ("height above the paper", " mm"),
        }
    }
}

/// Returns all measures at a calibrated position, in the order of [`Measure`].
pub(crate) fn measures(place: &ArmPlace, arm: &Calibration) -> [f64; MEASURES] {
    let [base, rear, fore, servo] = place.joints.angles_deg();
    let position = place.pose.position;
    [
        base,
        rear,
        fore,
        servo,
        rear - fore,
        position.x.0,
        position.y.0,
        position.z.0,
        position.reach().0,
        arm.above_table_mm(position).unwrap_or_default(),
    ]
}

/// The pivot of the rear arm of an arm as drawn: the origin.
pub(crate) const PIVOT: [f64; 3] = [0.0; 3];
