//! How far each joint may turn and where the tool may be.

use crate::kinematics::{ROUNDING, reach_and_height};
use crate::{Degrees, Joints, Millimeters, Pose, Position, Quantity, Tool, Unreachable, inverse};

/// Where the arm may go: joint angles and workspace.
///
/// All bounds are included. Rounding may carry a value that stands right on a bound beyond it by
/// up to 1e-9, which is forgiven.
///
/// ```
/// # use dobot_arm::{Limits, Millimeters, Pose, Position, Span, Tool};
/// let table = Millimeters(-60.0);
/// let limits = Limits { z: Span { min: table, ..Limits::STOCK.z }, ..Limits::STOCK };
/// let low = Pose { position: Position::new(200.0, 0.0, -62.5), ..Pose::default() };
/// let error = limits.solve(&low, Tool::SuctionCup).unwrap_err();
/// assert_eq!(error.to_string(), "z is -62.5 mm; the arm allows -60 to 136 mm: 2.5 mm too low");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Joint 1.
    pub base: Span<Degrees>,
    /// Joint 2.
    pub rear: Span<Degrees>,
    /// Joint 3.
    pub fore: Span<Degrees>,
    /// Joint 4.
    pub servo: Span<Degrees>,
    /// Joint 2 minus joint 3: how far the elbow opens.
    pub opening: Span<Degrees>,
    /// The horizontal distance of the tool from the base axis.
    pub reach: Span<Millimeters>,
    /// The height of the wrist.
    pub z: Span<Millimeters>,
}

impl Limits {
    /// The limits of the stock arm; it has no lower limit on z, so nothing keeps a tool out of the
    /// table.
    pub const STOCK: Self = Self {
        base: Span::degrees(-180.0, 180.0),
        rear: Span::degrees(-5.0, 85.0),
        fore: Span::degrees(-10.0, 95.0),
        servo: Span::degrees(-90.0, 90.0),
        opening: Span::degrees(f64::NEG_INFINITY, 35.0),
        reach: Span::millimeters(129.0, 321.0),
        z: Span::millimeters(f64::NEG_INFINITY, 136.0),
    };

    /// Whether the arm may hold these joint angles with this tool.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] with the first limit that is exceeded: the joints first, then the workspace.
    pub fn check(&self, joints: &Joints, tool: Tool) -> Result<(), Unreachable> {
        let [reach_mm, z_mm] = reach_and_height(joints, tool);
        self.check_joints(joints)?;
        self.check_workspace(reach_mm, z_mm)
    }

    /// Like [`check`](Self::check) for a known position of the joint angles.
    ///
    /// The caller answers for `position` being that place.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] with the first limit that is exceeded: the joints first, then the workspace.
    pub fn check_at(&self, joints: &Joints, position: Position) -> Result<(), Unreachable> {
        self.check_joints(joints)?;
        self.check_workspace(position.reach().0, position.z.0)
    }

    /// The joint angles for a pose that the arm can and may take.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] as of [`inverse`] and [`check_at`](Self::check_at).
    pub fn solve(&self, pose: &Pose, tool: Tool) -> Result<Joints, Unreachable> {
        let joints = inverse(pose, tool)?;
        self.check_at(&joints, pose.position)?;
        Ok(joints)
    }

    fn check_joints(&self, joints: &Joints) -> Result<(), Unreachable> {
        let Joints {
            base,
            rear,
            fore,
            servo,
        } = *joints;
        check(Quantity::Base, base.0, self.base.min.0, self.base.max.0)?;
        check(Quantity::Rear, rear.0, self.rear.min.0, self.rear.max.0)?;
        check(Quantity::Fore, fore.0, self.fore.min.0, self.fore.max.0)?;
        check(Quantity::Servo, servo.0, self.servo.min.0, self.servo.max.0)?;
        let opening_deg = rear.0 - fore.0;
        check(
            Quantity::Opening,
            opening_deg,
            self.opening.min.0,
            self.opening.max.0,
        )
    }

    fn check_workspace(&self, reach_mm: f64, z_mm: f64) -> Result<(), Unreachable> {
        check(
            Quantity::Reach,
            reach_mm,
            self.reach.min.0,
            self.reach.max.0,
        )?;
        check(Quantity::Z, z_mm, self.z.min.0, self.z.max.0)
    }
}

/// The least and the most of a quantity; both are allowed.
///
/// An infinite bound is no bound; still only finite values are within.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<T> {
    /// The least.
    pub min: T,
    /// The most.
    pub max: T,
}

impl Span<Degrees> {
    /// From `min_deg` to `max_deg`.
    #[must_use]
    pub const fn degrees(min_deg: f64, max_deg: f64) -> Self {
        Self {
            min: Degrees(min_deg),
            max: Degrees(max_deg),
        }
    }
}

impl Span<Millimeters> {
    /// From `min_mm` to `max_mm`.
    #[must_use]
    pub const fn millimeters(min_mm: f64, max_mm: f64) -> Self {
        Self {
            min: Millimeters(min_mm),
            max: Millimeters(max_mm),
        }
    }
}

fn check(quantity: Quantity, found: f64, min: f64, max: f64) -> Result<(), Unreachable> {
    if found.is_finite() && found >= min - ROUNDING && found <= max + ROUNDING {
        return Ok(());
    }
    Err(if found.is_finite() {
        Unreachable::OutOfRange {
            quantity,
            found,
            min,
            max,
        }
    } else {
        Unreachable::NotFinite { quantity, found }
    })
}
