//! The window of a job: the commands that the arm may have done.

use dobot_motion::Model;
use dobot_wire::{Status, single};

/// The window of a job: commands before `completed` are done, those in `completed..upto` may be
/// done, those from `upto` on are not done. Commands of a cycle count each time.
///
/// ```text
///   0          completed            upto           commands
///   |-- done ------|-- perhaps done --|-- not given --|
///                  ^ start
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    /// The number of commands known to be done.
    pub completed: usize,
    /// No command from this one on has been given to the arm.
    pub upto: usize,
    /// The arm before command `completed`; `None` if unknown, as before the first command.
    pub start: Option<Status>,
}

impl Window {
    /// Creates the window `completed..upto` of a job, with the arm before command `completed` as in
    /// `model`.
    #[must_use]
    pub fn at(completed: usize, upto: usize, model: &Model) -> Self {
        Self {
            completed,
            upto,
            start: model.knows_place().then(|| status(model)),
        }
    }
}

/// Returns the status of an arm at rest as in the model.
fn status(model: &Model) -> Status {
    Status {
        suction: model.suction,
        gripper_deg: single(model.gripper_deg),
        ..model.place.status()
    }
}
