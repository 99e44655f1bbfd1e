//! Answers of the station.

use dobot_wire::Finding;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Calibrations, JobView, LeaseView, NearView, PathPreview, State, TimeSlot};

/// The answer to an accepted request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Reply {
    /// Done.
    Done,
    /// The command is queued; a notice reports when it is over.
    Accepted {
        /// The command number.
        command: u64,
        /// The time until it is over, including all commands before it, in seconds, if it can be
        /// estimated.
        takes_s: Option<f64>,
    },
    /// The path the command would take; nothing was sent.
    Way {
        /// The path.
        way: PathPreview,
    },
    /// The limits and keep-outs close to the given position.
    Near {
        /// The limits and keep-outs.
        near: NearView,
    },
    /// The arm is stopping; the stop packets are on their way if `delivered`.
    Stopping {
        /// The time within which the arm is at rest, in seconds; meaningless if not delivered.
        rests_within_s: f64,
        /// Whether a link accepts the packets. If not, they are sent as soon as there is one;
        /// switch the arm off by hand.
        delivered: bool,
    },
    /// The current lease.
    Lease {
        /// The lease holder, if any.
        lease: Option<LeaseView>,
    },
    /// The current state.
    State {
        /// The state.
        state: Box<State>,
    },
    /// The current and upcoming time slots, in order.
    Slots {
        /// The slots.
        slots: Vec<TimeSlot>,
    },
    /// The job in its current state.
    Job {
        /// The job.
        job: JobView,
    },
    /// The current and the previous calibration.
    Calibrated {
        /// Both calibrations.
        calibrations: Box<Calibrations>,
    },
    /// The dialect that the arm speaks.
    Found {
        /// The finding and its evidence.
        finding: Finding,
    },
}
