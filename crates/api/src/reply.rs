//! What the station answers.

use dobot_wire::Finding;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Calibrations, JobView, LeaseView, NearView, PathPreview, TimeSlot};

/// The answer to a request that was granted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Reply {
    /// It is done.
    Done,
    /// The command waits for its turn; a notice tells when it is over.
    Accepted {
        /// Its number.
        command: u64,
        /// How long it and all before it take, in seconds, where that can be told.
        takes_s: Option<f64>,
    },
    /// Where the command would lead; nothing was sent.
    Way {
        /// The way.
        way: PathPreview,
    },
    /// What an arm at the place would be near to.
    Near {
        /// The limits and keep-outs.
        near: NearView,
    },
    /// The arm is stopped; what stops it is on its way, if `delivered`.
    Stopping {
        /// By when the arm is at rest at the latest, in seconds; without a meaning where nothing was delivered.
        rests_within_s: f64,
        /// Whether a link takes the packets. If not, they are sent as soon as there is one: the arm has to be switched
        /// off by hand.
        delivered: bool,
    },
    /// The lease, as it is now.
    Lease {
        /// Who has it, if anybody has.
        lease: Option<LeaseView>,
    },
    /// The time slots that are not over, in their order.
    Slots {
        /// The slots.
        slots: Vec<TimeSlot>,
    },
    /// The job, as it is now.
    Job {
        /// The job.
        job: JobView,
    },
    /// Which calibration holds, and which one did before.
    Calibrated {
        /// Both.
        calibrations: Box<Calibrations>,
    },
    /// Which dialect the arm speaks.
    Found {
        /// What was found, and by which evidence.
        finding: Finding,
    },
}
