//! The speed that a vector leaves for the next one.

/// The end speed of the last vector in mm/s, with which the next one starts where the dialect does not
/// use its start speed (notes N5 and N48); where it does, this has no effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LeftSpeed {
    pub(crate) believed_mm_s: f32,
    /// What it may be instead where it is unknown: of an arm that others used before, or behind a vector
    /// that may have been cut short.
    pub(crate) perhaps_mm_s: Option<[f32; 3]>,
}

impl LeftSpeed {
    /// At power-up.
    pub(crate) const NOTHING: Self = Self::known(0.0);

    pub(crate) const fn known(believed_mm_s: f32) -> Self {
        Self {
            believed_mm_s,
            perhaps_mm_s: None,
        }
    }

    /// Whether it is that, near enough.
    pub(crate) fn is_known(self) -> bool {
        let mut perhaps = self.perhaps_mm_s.iter().flatten();
        perhaps.all(|it| (it - self.believed_mm_s).abs() <= KNOWN_MM_S)
    }

    /// Whether what begins with it and gets no faster might creep.
    pub(crate) fn may_creep(self) -> bool {
        let mut perhaps = self.perhaps_mm_s.iter().flatten();
        perhaps.any(|it| f64::from(*it) < CREEPS_MM_S)
    }

    /// The same, where it is unknown whether it is so.
    pub(crate) const fn perhaps(self) -> Self {
        Self {
            perhaps_mm_s: Some(LEFT_BY_OTHERS_MM_S),
            ..self
        }
    }
}

/// What a vector that was braked to rest leaves, in mm/s: a little less than nothing.
const LEFT_BY_OTHERS_MM_S: [f32; 3] = [-0.01, -0.1, -0.3];
/// What may have been left is known as well as that, in mm/s.
const KNOWN_MM_S: f32 = 0.05;
/// With less a vector takes for ever, or none of it is done.
pub(crate) const CREEPS_MM_S: f64 = 0.1;
