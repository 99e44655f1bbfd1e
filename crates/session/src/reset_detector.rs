//! Detects resets. After a reset the arm reports a base angle of 0 wherever its base stands, so its pose
//! cannot be trusted (note N35).

use std::time::Duration;

use dobot_arm::Joints;
use dobot_motion::ArmPlace;
use dobot_wire::{Command, Configuration, Status};

use crate::send_error::moves;

/// The evidence of a reset: the base angle is set to 0, rear arm and forearm are read from their
/// sensors again, and all settings are lost (notes N28 and N35).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ResetEvidence {
    /// Silence before this status, if it was longer than a few lost statuses.
    pub silent_for: Option<Duration>,
    /// The joint angles before.
    pub before: Joints,
    /// The joint angles now.
    pub now: Joints,
    /// Whether they changed faster than the arm can move.
    pub jumped: bool,
    /// Whether the base angle is 0, as after every reset.
    pub base_is_zero: bool,
}

impl std::fmt::Display for ResetEvidence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let angles = |joints: &Joints| [joints.base.0, joints.rear.0, joints.fore.0];
        let ([b, r, v], [b2, r2, v2]) = (angles(&self.before), angles(&self.now));
        if let Some(silent_for) = self.silent_for {
            write!(
                f,
                "it was silent for {:.1} s and ",
                silent_for.as_secs_f64()
            )?;
        }
        write!(
            f,
            "its angles went from {b:.2}, {r:.2}, {v:.2} to {b2:.2}, {r2:.2}, {v2:.2}°"
        )?;
        if self.jumped {
            f.write_str(", faster than it can move")?;
        }
        Ok(())
    }
}

/// Detects a reset from the statuses.
#[derive(Clone, Debug)]
pub(crate) struct ResetDetector {
    /// Why the pose is not trusted; `None` if it is.
    reason: Option<String>,
    last: Option<(Duration, Status)>,
    /// Silence before the statuses that were read last.
    silent_for: Duration,
    /// The status period.
    period: Duration,
    /// The port was opened after the last status.
    opened: bool,
    /// Initial angles that were sent but have not been seen, and for how many more statuses they
    /// would explain a jump.
    initial_angles: Option<([f32; 2], u32)>,
    /// The arm was seen at rest and no motion was sent since.
    still: bool,
}

impl ResetDetector {
    pub(crate) fn new(trusted: bool) -> Self {
        Self {
            reason: (!trusted).then(|| UNCONFIRMED.to_owned()),
            last: None,
            silent_for: Duration::ZERO,
            period: Duration::ZERO,
            opened: false,
            initial_angles: None,
            still: false,
        }
    }

    pub(crate) const fn reason(&self) -> Option<&String> {
        self.reason.as_ref()
    }

    pub(crate) fn confirm(&mut self) {
        self.reason = None;
    }

    /// The port was opened again: the silence until the next status was on our side.
    pub(crate) const fn handle_open(&mut self) {
        self.opened = true;
    }

    /// Handles a read of several statuses, `more` after the first. The arm sent them one period apart: a
    /// computer that was suspended reads them late, although the arm was not silent.
    pub(crate) fn handle_read(&mut self, now: Duration, more: usize, period: Duration) {
        let Some((received, _)) = self.last else {
            return;
        };
        let more = u32::try_from(more).unwrap_or(u32::MAX);
        let sending = period.saturating_mul(more);
        self.silent_for = now.saturating_sub(received).saturating_sub(sending);
        self.period = period;
    }

    pub(crate) fn distrust(&mut self, reason: &str) {
        self.reason = Some(reason.to_owned());
    }

    /// Handles a command that is queued. Only the sender of new initial angles knows the pose that
    /// results from them, so a person has to confirm it.
    pub(crate) fn handle_given(&mut self, command: &Command) {
        if let Command::Configuration(Configuration::InitialAngles { .. }) = command {
            self.distrust(ANGLES_SET);
        }
    }

    pub(crate) fn handle_sent(&mut self, command: &Command) {
        self.handle_given(command);
        self.still &= !moves(command);
        if let Command::Configuration(Configuration::InitialAngles { rear_deg, fore_deg }) = command
        {
            self.initial_angles = Some(([*rear_deg, *fore_deg], AWAITED));
        }
    }

    /// Handles a status and returns the evidence of a reset, if any.
    ///
    /// Silence and a base angle of 0 count as a reset even though a full queue and a move to 0 look the
    /// same: the statuses do not distinguish the two. There is one exception: the arm may have
    /// continued its in-flight commands while the port was closed (`to_zero`: they lead to a base of 0).
    /// With a real arm, opening the port already ends the trust.
    ///
    /// `at_rest`: there are no in-flight commands. Then, and until a motion is sent, an arm that reports
    /// the same angles as before has not moved. (A computer that was suspended sends "laser off" before it
    /// reads the statuses that arrived in between.)
    pub(crate) fn handle_status(
        &mut self,
        now: Duration,
        status: &Status,
        to_zero: bool,
        at_rest: bool,
    ) -> Option<ResetEvidence> {
        let went_on = std::mem::take(&mut self.opened) && to_zero;
        self.still |= at_rest;
        let (received, before) = self.last.replace((now, *status))?;
        if self
            .initial_angles
            .is_some_and(|(angles, _)| shows(status, angles))
        {
            self.initial_angles = None;
            self.distrust(ANGLES_SET);
            return None;
        }
        let jumps = self.initial_angles.is_some();
        self.initial_angles = match self.initial_angles {
            Some((angles, left)) if left > 0 => Some((angles, left - 1)),
            _ => None,
        };
        let silent_for = self.silent_for;
        let deaf = silent_for >= DEAF;
        // Statuses that are read together were sent one period apart.
        let within = now.saturating_sub(received).max(self.period);
        let jumped = !jumps && jumped(&before, status, within);
        let base_is_zero = status.base_deg == 0.0;
        // A joint that has moved since the last status may have moved from the 0 of a reset.
        let restarted = !went_on && (!self.still || angles_changed(&before, status));
        if !(jumped || deaf && base_is_zero && restarted) {
            return None;
        }
        let evidence = ResetEvidence {
            silent_for: deaf.then_some(silent_for),
            before: ArmPlace::of_status(&before).joints,
            now: ArmPlace::of_status(status).joints,
            jumped,
            base_is_zero,
        };
        self.distrust(&format!("the arm was reset: {evidence}"));
        Some(evidence)
    }
}

/// Whether an angle changed that a reset would change.
fn angles_changed(before: &Status, now: &Status) -> bool {
    let angles = |status: &Status| [status.base_deg, status.rear_deg, status.fore_deg];
    angles(before) != angles(now)
}

fn shows(status: &Status, [rear_deg, fore_deg]: [f32; 2]) -> bool {
    let near = |sent: f32, found: f32| (sent - found).abs() <= SAME_DEG;
    near(rear_deg, status.rear_deg)
        && near(fore_deg, status.fore_deg)
        && status.base_deg.abs() <= SAME_DEG
}

/// Whether a joint changed faster than it can turn.
fn jumped(before: &Status, now: &Status, within: Duration) -> bool {
    let most_deg = FASTEST_DEG_S * (within.as_secs_f32() + LATE_S);
    [
        now.base_deg - before.base_deg,
        now.rear_deg - before.rear_deg,
        now.fore_deg - before.fore_deg,
    ]
    .iter()
    .any(|change| change.abs() > most_deg)
}

const UNCONFIRMED: &str =
    "nobody has confirmed the arm's pose since its port was opened, which resets the arm";
const ANGLES_SET: &str = "its initial angles were set, and nobody has confirmed its pose since";
/// Six and a half status periods: many losses in a row, and shorter than any reset.
pub(crate) const DEAF: Duration = Duration::from_millis(520);
/// 1.5 times the fastest turn of a stock arm, 200 degrees/s.
const FASTEST_DEG_S: f32 = 300.0;
/// The largest difference in delay between two statuses, in s.
const LATE_S: f32 = 0.04;
/// Initial angles wait behind queued motions: ten minutes of statuses.
const AWAITED: u32 = 7500;
const SAME_DEG: f32 = 0.01;
