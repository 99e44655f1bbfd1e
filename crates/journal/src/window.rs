//! Which commands of a job the arm may have done.

use dobot_motion::Model;
use dobot_wire::{Status, single};

/// Which commands of a job the arm may have done: those before `completed` for sure, those in
/// `completed..upto` perhaps, those from `upto` on for sure not. Those of a cycle count each time.
///
/// ```text
///   0          completed            upto           commands
///   |-- done ------|-- perhaps done --|-- not given --|
///                  ^ start
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    /// How many commands are known to be done.
    pub completed: usize,
    /// No command from here on has been given to the arm.
    pub upto: usize,
    /// The arm as command `completed` finds it; `None` where nobody knew, as before the first
    /// command.
    pub start: Option<Status>,
}

impl Window {
    /// The window `completed..upto` of a job whose command `completed` finds the arm as `model`
    /// says.
    #[must_use]
    pub fn at(completed: usize, upto: usize, model: &Model) -> Self {
        Self {
            completed,
            upto,
            start: model.knows_place().then(|| status(model)),
        }
    }
}

/// The status of an arm that stands as the model says.
fn status(model: &Model) -> Status {
    Status {
        suction: model.suction,
        gripper_deg: single(model.gripper_deg),
        ..model.place.status()
    }
}
