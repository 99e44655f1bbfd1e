//! Where vectors meet.

use dobot_geometry::Point;

/// A place where one vector ends and the next begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) at: Point,
    /// The last point of the stroke that is passed here.
    pub(super) passed: usize,
    /// The corner before it, among those that were gone on from.
    pub(super) before: usize,
}
