//! Speed limits of point-to-point moves.

use crate::PlanError;
use crate::plan_error::positive;

/// The maximum speeds and accelerations of target moves (Table 3.9, state 9, mode 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speeds {
    /// Speed of joints 1 to 3.
    pub joint_deg_s: f64,
    /// Acceleration of joints 1 to 3.
    pub joint_deg_s2: f64,
    /// Speed of the servo, joint 4.
    pub servo_deg_s: f64,
    /// Acceleration of the servo, joint 4.
    pub servo_deg_s2: f64,
    /// Speed of the tool.
    pub line_mm_s: f64,
    /// Acceleration of the tool.
    pub line_mm_s2: f64,
}

impl Speeds {
    /// The values of a stock arm after power-up, before its percentages of 50 (state 10) are
    /// applied.
    pub const STOCK: Self = Self::new([200.0, 200.0, 200.0, 200.0, 100.0, 200.0]);

    /// Creates speeds from the numbers of Table 3.9: speed and acceleration of the joints, of the
    /// servo and of the tool.
    #[must_use]
    pub const fn new(numbers: [f64; 6]) -> Self {
        let [
            joint_deg_s,
            joint_deg_s2,
            servo_deg_s,
            servo_deg_s2,
            line_mm_s,
            line_mm_s2,
        ] = numbers;
        Self {
            joint_deg_s,
            joint_deg_s2,
            servo_deg_s,
            servo_deg_s2,
            line_mm_s,
            line_mm_s2,
        }
    }

    /// Returns the numbers as passed to [`Speeds::new`].
    #[must_use]
    pub const fn numbers(&self) -> [f64; 6] {
        [
            self.joint_deg_s,
            self.joint_deg_s2,
            self.servo_deg_s,
            self.servo_deg_s2,
            self.line_mm_s,
            self.line_mm_s2,
        ]
    }

    /// Scales all speeds and accelerations by percentages (Table 3.9, state 10).
    ///
    /// ```
    /// # use dobot_motion::Speeds;
    /// assert_eq!(Speeds::STOCK.scaled(50.0, 25.0).line_mm_s2, 50.0);
    /// ```
    #[must_use]
    pub const fn scaled(&self, speed_percent: f64, acceleration_percent: f64) -> Self {
        let [speed, acceleration] = [speed_percent / 100.0, acceleration_percent / 100.0];
        Self {
            joint_deg_s: self.joint_deg_s * speed,
            joint_deg_s2: self.joint_deg_s2 * acceleration,
            servo_deg_s: self.servo_deg_s * speed,
            servo_deg_s2: self.servo_deg_s2 * acceleration,
            line_mm_s: self.line_mm_s * speed,
            line_mm_s2: self.line_mm_s2 * acceleration,
        }
    }

    /// Checks that a motion can be planned with these speeds.
    ///
    /// # Errors
    ///
    /// [`PlanError::NotPositive`] with the first speed or acceleration that is zero, negative or
    /// not finite.
    pub fn check(&self) -> Result<(), PlanError> {
        positive("joint speed", self.joint_deg_s)?;
        positive("joint acceleration", self.joint_deg_s2)?;
        positive("servo speed", self.servo_deg_s)?;
        positive("servo acceleration", self.servo_deg_s2)?;
        positive("line speed", self.line_mm_s)?;
        positive("line acceleration", self.line_mm_s2)
    }
}
