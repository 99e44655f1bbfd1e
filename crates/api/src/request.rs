//! Requests to the station.

use std::fmt;

use dobot_wire::{Command, Dialect, JointJog, LinearJog};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};

use crate::{Answer, Button, CalibrationFile, ClientId, Heard, NewJob, Role, TimeSlot};

/// A request to the station.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum Request {
    /// Send one command, if the policy allows its whole path.
    Command {
        /// The command.
        command: Command,
    },
    /// Send a command that comes from a sense, marked as such in log, recording and notices. Each
    /// sense has one: a camera `move_to`, a microphone `voice`, a hand `gesture`; none of them
    /// lights the laser. A spoken order moves at most `voice.largest_mm` of the policy.
    SensedCommand {
        /// The sense.
        sense: Sense,
        /// The command.
        command: Command,
    },
    /// Publish what a microphone heard, before anything moves. No lease is needed.
    Heard {
        /// The client whose audio it was; absent for the listener's own microphone.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        client: Option<ClientId>,
        /// What was understood.
        heard: Heard,
    },
    /// Preview the path a command would take if it were sent now, or return why it would be
    /// refused. Nothing is sent and no notice is published. No lease is needed.
    CheckCommand {
        /// The command.
        command: Command,
    },
    /// Return the policy limits and keep-outs close to a position, however the arm got there.
    /// Nothing is sent and no notice is published. No lease is needed.
    Near {
        /// The distance forward of the base axis, in mm.
        x_mm: f64,
        /// The distance to the left of the base axis, in mm.
        y_mm: f64,
        /// The height of the wrist, in mm.
        z_mm: f64,
        /// The rotation of the tool, in degrees.
        rotation_deg: f64,
    },
    /// Hold a jog button. It is released unless this is repeated within the dead-man time (150 ms
    /// by default).
    Jog {
        /// The button.
        jog: Jog,
    },
    /// Release the jog button.
    #[serde(deserialize_with = "without_fields")]
    Release,
    /// Move by one step of a jog button from where the arm is after all queued commands, if the
    /// policy allows the whole path. Pump and gripper keep their state.
    Step {
        /// The button.
        button: Button,
        /// The distance, in mm or degrees.
        #[schemars(range(min = 0.01, max = 100.0))]
        by: f32,
    },
    /// Stop the arm: the laser goes off first, and nothing more is sent. Any client may, without a
    /// lease.
    Stop {
        /// The reason, shown while the arm is stopped. Text beyond 200 characters is cut: a stop is
        /// never refused.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        reason: Option<String>,
    },
    /// Clear the stop after a person has looked at the arm.
    #[serde(deserialize_with = "without_fields")]
    ResetStop,
    /// Take control if it is free; repeating it renews the lease. An administrator can also take
    /// control from a program on the raw port, which cannot answer requests.
    #[serde(deserialize_with = "without_fields")]
    TakeLease,
    /// Release control.
    #[serde(deserialize_with = "without_fields")]
    ReleaseLease,
    /// Ask the lease holder for control, who can grant or release it.
    #[serde(deserialize_with = "without_fields")]
    AskLease,
    /// Grant control to a client that asked for it.
    GrantLease {
        /// The client that gets control.
        to: ClientId,
    },
    /// Take control from the lease holder.
    #[serde(deserialize_with = "without_fields")]
    SeizeLease,
    /// Lock the arm for administrators: any other client loses control, and a running job is
    /// paused. Repeating it changes the message.
    Lock {
        /// The reason, shown to clients, as in "eyes on me". Text beyond 200 characters is cut.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        message: Option<String>,
    },
    /// Unlock the arm: every client may take control again.
    #[serde(deserialize_with = "without_fields")]
    Unlock,
    /// Set the time slots, replacing all previous ones; with no slots every client may take
    /// control. During a slot only its student and administrators have control: any other client
    /// loses it, and a running job is paused.
    SetSlots {
        /// The slots, in any order: at most 200, not overlapping.
        #[schemars(length(max = 200))]
        slots: Vec<TimeSlot>,
    },
    /// Return the current state.
    #[serde(deserialize_with = "without_fields")]
    ShowState,
    /// Return all time slots.
    #[serde(deserialize_with = "without_fields")]
    ShowSlots,
    /// Send a message to all observers.
    Message {
        /// The message. Text beyond 200 characters is cut.
        text: String,
    },
    /// Mark the recording: an episode of a dataset begins or ends here.
    MarkEpisode {
        /// The mark.
        mark: EpisodeMark,
        /// What the arm does; only with `begin`. Text beyond 200 characters is cut.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        task: Option<String>,
    },
    /// Arm the laser for a while: everyone present wears goggles. For a program on the raw port
    /// that has control, an administrator does this.
    ArmLaser {
        /// The duration, in seconds.
        #[schemars(range(min = 1.0, max = 3600.0))]
        for_s: f64,
    },
    /// Switch the laser off and disarm it.
    #[serde(deserialize_with = "without_fields")]
    DisarmLaser,
    /// Confirm the pose: a person has checked that the arm stands where its statuses say. No lease
    /// is needed.
    #[serde(deserialize_with = "without_fields")]
    ConfirmPose,
    /// Give a calibrated arm its true joint angles (state 9, mode 3), which corrects its zeros
    /// until its next reset. The arm must be at rest with its base straight ahead.
    #[serde(alias = "tell_angles", deserialize_with = "without_fields")]
    SetAngles,
    /// Set the calibration: from then on positions are calibrated ones. It is stored for this arm
    /// together with the previous one.
    Calibrate {
        /// The calibration; without one the arm is assumed to match the drawing.
        calibration: Option<Box<CalibrationFile>>,
    },
    /// Set the dialect that the arm speaks.
    SetDialect {
        /// The dialect.
        dialect: Dialect,
    },
    /// Detect the dialect that the arm speaks, by small slow motions.
    #[serde(deserialize_with = "without_fields")]
    Detect,
    /// Queue a job.
    SubmitJob {
        /// The job.
        job: NewJob,
        /// The idempotency key, 1 to 64 visible characters: a request repeated with the same key
        /// queues no second job.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(length(min = 1, max = 64))]
        key: Option<String>,
    },
    /// Start a queued job or resume a paused one.
    StartJob {
        /// The job number.
        job: u64,
    },
    /// Answer the question of the running job; it continues with the steps for that answer.
    AnswerJob {
        /// The job.
        job: u64,
        /// The number of the question; an answer to an earlier question is refused. Absent: the
        /// current question.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        question: Option<u64>,
        /// The answer.
        answer: Answer,
    },
    /// Confirm that a person has done what a paused job waits for; [`Request::StartJob`] then
    /// resumes it.
    ConfirmJob {
        /// The job number.
        job: u64,
    },
    /// Run the next step of a queued or paused job, then pause.
    StepJob {
        /// The job number.
        job: u64,
    },
    /// Pause the running job after the in-flight commands.
    #[serde(deserialize_with = "without_fields")]
    PauseJob,
    /// Change the speed of the running or paused job, from the next unsent command on: the vectors
    /// of a drawing, the vectors and targets of a program. Targets run at no more than 100 % of the
    /// arm's configured speed.
    SetJobSpeed {
        /// The speed, in percent of the planned speed.
        #[schemars(range(min = 10.0, max = 200.0))]
        percent: f64,
    },
    /// Change the drawing height of the running or paused job, gradually, from the next unsent
    /// command on.
    SetJobHeight {
        /// The height offset from the plan, in millimetres; negative is lower.
        #[schemars(range(min = -5.0, max = 5.0))]
        offset_mm: f64,
    },
    /// End a job permanently.
    CancelJob {
        /// The job number.
        job: u64,
    },
    /// Queue a job again, as a new job that is planned again.
    QueueAgain {
        /// The job number.
        job: u64,
        /// The idempotency key, 1 to 64 visible characters: a request repeated with the same key
        /// queues no second job.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(length(min = 1, max = 64))]
        key: Option<String>,
    },
    /// Move a queued job before another queued one, or to the end.
    MoveJob {
        /// The job number.
        job: u64,
        /// The number of the other job; without it, the job moves to the end.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        before: Option<u64>,
    },
    /// Remove a job that is over or has not started.
    ForgetJob {
        /// The job number.
        job: u64,
    },
}

/// Rejects unknown fields of a request without fields; a derived reader would ignore them.
pub(crate) fn without_fields<'de, D: Deserializer<'de>>(deserializer: D) -> Result<(), D::Error> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Nothing {}

    Nothing::deserialize(deserializer).map(|Nothing {}| ())
}

impl Request {
    /// Returns the least role that may send this request.
    #[must_use]
    pub const fn role(&self) -> Role {
        match self {
            Self::Stop { .. }
            | Self::CheckCommand { .. }
            | Self::Near { .. }
            | Self::ShowSlots
            | Self::ShowState => Role::Watch,
            Self::SubmitJob { .. } | Self::QueueAgain { .. } => Role::Queue,
            Self::SetDialect { .. }
            | Self::Calibrate { .. }
            | Self::SeizeLease
            | Self::Lock { .. }
            | Self::Unlock
            | Self::SetSlots { .. } => Role::Admin,
            Self::Command { .. }
            | Self::SensedCommand { .. }
            | Self::Heard { .. }
            | Self::Jog { .. }
            | Self::Release
            | Self::Step { .. }
            | Self::ResetStop
            | Self::TakeLease
            | Self::ReleaseLease
            | Self::AskLease
            | Self::GrantLease { .. }
            | Self::Message { .. }
            | Self::MarkEpisode { .. }
            | Self::ArmLaser { .. }
            | Self::DisarmLaser
            | Self::ConfirmPose
            | Self::SetAngles
            | Self::Detect
            | Self::StartJob { .. }
            | Self::AnswerJob { .. }
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

/// A mark in the recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum EpisodeMark {
    /// An episode begins; an open one ends.
    Begin,
    /// The episode ends.
    End,
    /// The open episode, or the last one, is left out.
    Discard,
}

/// Where a command comes from, if not from a person's own input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Sense {
    /// A camera, which locates something.
    Camera,
    /// A microphone, which hears an order.
    Microphone,
    /// A hand in front of a camera, which the arm follows.
    Hand,
}

impl fmt::Display for Sense {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Camera => "camera",
            Self::Microphone => "microphone",
            Self::Hand => "hand",
        })
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
    /// Returns the command that presses the button.
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
    fn jobs_are_queued_with_fewer_rights_than_are_needed_to_start_them() {
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
