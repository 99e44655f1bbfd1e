//! The speed that a vector leaves for the next one.

/// The end speed of the last vector in mm/s. The next vector starts with it if the dialect ignores
/// its start speed (notes N5 and N48); otherwise it has no effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LeftSpeed {
    pub(crate) believed_mm_s: f32,
    /// Possible other values if the speed is unknown: because others used the arm before, or after
    /// a vector that may have been cut short.
    pub(crate) perhaps_mm_s: Option<[f32; 3]>,
}

impl LeftSpeed {
    /// The speed at power-up.
    pub(crate) const NOTHING: Self = Self::known(0.0);

    pub(crate) const fn known(believed_mm_s: f32) -> Self {
        Self {
            believed_mm_s,
            perhaps_mm_s: None,
        }
    }

    /// Whether the value is known closely enough.
    pub(crate) fn is_known(self) -> bool {
        let mut perhaps = self.perhaps_mm_s.iter().flatten();
        perhaps.all(|mm_s| (mm_s - self.believed_mm_s).abs() <= KNOWN_MM_S)
    }

    /// Whether a vector that begins with this speed and does not accelerate might creep.
    pub(crate) fn may_creep(self) -> bool {
        let mut perhaps = self.perhaps_mm_s.iter().flatten();
        perhaps.any(|mm_s| f64::from(*mm_s) < CREEPS_MM_S)
    }

    /// Returns the same speed as one of several possible values.
    pub(crate) const fn perhaps(self) -> Self {
        Self {
            perhaps_mm_s: Some(LEFT_BY_OTHERS_MM_S),
            ..self
        }
    }
}

/// The speeds left by a vector that was braked to rest, in mm/s: slightly below zero.
const LEFT_BY_OTHERS_MM_S: [f32; 3] = [-0.01, -0.1, -0.3];
/// The tolerance within which values count as known, in mm/s.
const KNOWN_MM_S: f32 = 0.05;
/// Below this speed a vector takes forever, or none of it is executed.
pub(crate) const CREEPS_MM_S: f64 = 0.1;
