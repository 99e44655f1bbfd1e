//! What a client can ask for.

use dobot_wire::{Command, Dialect, JointJog, LinearJog};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};

use crate::{Button, CalibrationFile, ClientId, NewJob, Role, TimeSlot};

/// What a client can ask of the station.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum Request {
    /// Send one command, if the policy allows its whole way.
    Command {
        /// The command.
        command: Command,
    },
    /// Say where a command would lead if it were sent now, or why it would be refused. Nothing is sent, and nobody is
    /// told; it takes no lease.
    CheckCommand {
        /// The command.
        command: Command,
    },
    /// Say which limits and keep-outs of the policy an arm at a place would be near to, however it got there. Nothing is sent,
    /// and nobody is told; it takes no lease.
    Near {
        /// Forward of the axis of the base, in mm.
        x_mm: f64,
        /// To the left of it, in mm.
        y_mm: f64,
        /// The height of the wrist, in mm.
        z_mm: f64,
        /// The rotation of the tool, in degrees.
        rotation_deg: f64,
    },
    /// Hold a jog button. It is released when this is not said again within the dead-man time
    /// (150 ms by default).
    Jog {
        /// The button.
        jog: Jog,
    },
    /// Release the jog button.
    #[serde(deserialize_with = "without_fields")]
    Release,
    /// Move by one step of a jog button, from where the arm is when all that it was given is over, if the policy allows its
    /// whole way. Pump and gripper stay as they are.
    Step {
        /// The button.
        button: Button,
        /// How far, in mm or degrees.
        #[schemars(range(min = 0.01, max = 100.0))]
        by: f32,
    },
    /// Stop the arm: laser off first, nothing more is sent. Anyone may, without a lease.
    Stop {
        /// Why, for those who find the arm stopped. What is longer than 200 characters is cut: a stop
        /// is not refused.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        reason: Option<String>,
    },
    /// Let the arm move again after a stop: a person has looked at it.
    #[serde(deserialize_with = "without_fields")]
    ResetStop,
    /// Take control, if nobody has it; said again it renews the lease. From a program on the raw port,
    /// which cannot be asked, an administrator takes it so too.
    #[serde(deserialize_with = "without_fields")]
    TakeLease,
    /// Give control back.
    #[serde(deserialize_with = "without_fields")]
    ReleaseLease,
    /// Ask the holder for control; he grants it, or releases it.
    #[serde(deserialize_with = "without_fields")]
    AskLease,
    /// Give control to one who asked.
    GrantLease {
        /// Who gets it.
        to: ClientId,
    },
    /// Take control from whoever has it.
    #[serde(deserialize_with = "without_fields")]
    SeizeLease,
    /// Keep the arm for administrators: whoever else has control loses it, and a job that runs is paused. Said again, it
    /// changes the message.
    Lock {
        /// Why, for those who want to move the arm, as in "eyes on me". What is longer than 200 characters is cut.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        message: Option<String>,
    },
    /// Let everyone take control again.
    #[serde(deserialize_with = "without_fields")]
    Unlock,
    /// Say whose the arm is and when, in place of all that was said before; with no slots it is everyone's. While a slot is under
    /// way only its student and administrators have control: whoever else has it loses it, and a job that runs is paused.
    SetSlots {
        /// The slots, in any order: up to 200, none of which overlaps another one.
        #[schemars(length(max = 200))]
        slots: Vec<TimeSlot>,
    },
    /// Tell all time slots.
    #[serde(deserialize_with = "without_fields")]
    ShowSlots,
    /// Tell something to all who watch.
    Message {
        /// What. What is longer than 200 characters is cut.
        text: String,
    },
    /// Let the laser be switched on for a while: a person has put the goggles on. For a program on the raw
    /// port that has control an administrator says so.
    ArmLaser {
        /// For how long, in seconds.
        #[schemars(range(min = 1.0, max = 3600.0))]
        for_s: f64,
    },
    /// Switch the laser off and keep it off.
    #[serde(deserialize_with = "without_fields")]
    DisarmLaser,
    /// The arm stands where its statuses say: a person has looked. This takes no lease.
    #[serde(deserialize_with = "without_fields")]
    ConfirmPose,
    /// Tell a calibrated arm its true joint angles (state 9, mode 3), which corrects its zeros until its next
    /// reset. It has to rest, with its base straight ahead.
    #[serde(deserialize_with = "without_fields")]
    TellAngles,
    /// Say how the arm differs from the drawing of it: from then on places are true ones. It is kept for this arm, and
    /// what was known before is kept beside it.
    Calibrate {
        /// What is known of the arm; nothing takes it to be as drawn.
        calibration: Option<Box<CalibrationFile>>,
    },
    /// Say which dialect the arm speaks.
    SetDialect {
        /// The dialect.
        dialect: Dialect,
    },
    /// Find out which dialect the arm speaks, by small slow motions.
    #[serde(deserialize_with = "without_fields")]
    Detect,
    /// Queue a job.
    SubmitJob {
        /// The job.
        job: NewJob,
        /// What the sender calls this request, 1 to 64 visible characters: sent again with the same key, it queues no
        /// other job.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(length(min = 1, max = 64))]
        key: Option<String>,
    },
    /// Start a queued job, or go on with a paused one.
    StartJob {
        /// Its number.
        job: u64,
    },
    /// Say that a person has done what a paused job waits for; it goes on with [`Request::StartJob`].
    ConfirmJob {
        /// Its number.
        job: u64,
    },
    /// Do the next step of a queued or paused job, and pause behind it.
    StepJob {
        /// Its number.
        job: u64,
    },
    /// Pause the running job after what the arm has got already.
    #[serde(deserialize_with = "without_fields")]
    PauseJob,
    /// Do the job that runs or is paused faster or slower than planned, from the next command on that is not
    /// sent yet: the vectors of a drawing, the vectors and targets of a program. To its targets an arm goes at
    /// 100 % of its configured speed at the most.
    SetJobSpeed {
        /// In percent of the planned speed.
        #[schemars(range(min = 10.0, max = 200.0))]
        percent: f64,
    },
    /// Draw the job that runs or is paused higher or lower than planned, gently, from the next
    /// command on that is not sent yet.
    SetJobHeight {
        /// How far above the plan, in millimetres; below 0 is lower.
        #[schemars(range(min = -5.0, max = 5.0))]
        offset_mm: f64,
    },
    /// End a job for good.
    CancelJob {
        /// Its number.
        job: u64,
    },
    /// Queue what a job does once more, as a new job that is planned anew.
    QueueAgain {
        /// Its number.
        job: u64,
        /// What the sender calls this request, 1 to 64 visible characters: sent again with the same key, it queues no
        /// other job.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(length(min = 1, max = 64))]
        key: Option<String>,
    },
    /// Put a queued job before another queued one, or behind all of them.
    MoveJob {
        /// Its number.
        job: u64,
        /// The number of the other one; without it the job comes last.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        before: Option<u64>,
    },
    /// Forget a job that is over, or that has not begun.
    ForgetJob {
        /// Its number.
        job: u64,
    },
}

/// What is left of a request that has no fields; a derived reader passes over what it does not know there.
fn without_fields<'de, D: Deserializer<'de>>(deserializer: D) -> Result<(), D::Error> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Nothing {}

    Nothing::deserialize(deserializer).map(|Nothing {}| ())
}

impl Request {
    /// Who may ask for this.
    #[must_use]
    pub const fn role(&self) -> Role {
        match self {
            Self::Stop { .. } | Self::CheckCommand { .. } | Self::Near { .. } | Self::ShowSlots => {
                Role::Watch
            }
            Self::SubmitJob { .. } | Self::QueueAgain { .. } => Role::Queue,
            Self::SetDialect { .. }
            | Self::Calibrate { .. }
            | Self::SeizeLease
            | Self::Lock { .. }
            | Self::Unlock
            | Self::SetSlots { .. } => Role::Admin,
            Self::Command { .. }
            | Self::Jog { .. }
            | Self::Release
            | Self::Step { .. }
            | Self::ResetStop
            | Self::TakeLease
            | Self::ReleaseLease
            | Self::AskLease
            | Self::GrantLease { .. }
            | Self::Message { .. }
            | Self::ArmLaser { .. }
            | Self::DisarmLaser
            | Self::ConfirmPose
            | Self::TellAngles
            | Self::Detect
            | Self::StartJob { .. }
            | Self::ConfirmJob { .. }
            | Self::StepJob { .. }
            | Self::PauseJob
            | Self::SetJobSpeed { .. }
            | Self::SetJobHeight { .. }
            | Self::CancelJob { .. }
            | Self::MoveJob { .. }
            | Self::ForgetJob { .. } => Role::Control,
        }
    }
}

/// A jog button.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "frame", rename_all = "snake_case")]
pub enum Jog {
    /// One joint (state 2).
    Joint(JointJog),
    /// One axis of the base frame (state 7).
    Linear(LinearJog),
}

impl Jog {
    /// The command that presses the button.
    #[must_use]
    pub fn command(self) -> Command {
        match self {
            Self::Joint(jog) => jog.into(),
            Self::Linear(jog) => jog.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jobs_are_queued_with_less_than_it_takes_to_start_them() {
        let again = Request::QueueAgain { job: 1, key: None };
        assert_eq!(again.role(), Role::Queue);
        for request in [
            Request::StartJob { job: 1 },
            Request::StepJob { job: 1 },
            Request::ResetStop,
            Request::TakeLease,
            Request::ConfirmPose,
        ] {
            assert_eq!(request.role(), Role::Control, "{request:?}");
        }
        assert_eq!(Request::Stop { reason: None }.role(), Role::Watch);
    }
}
