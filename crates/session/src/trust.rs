//! Whether the pose that an arm tells can be believed: a reset makes it say 0 wherever its base
//! stands (note N35).

use std::time::Duration;

use dobot_arm::Joints;
use dobot_motion::ArmPlace;
use dobot_wire::{Command, Configuration, Status};

use crate::send_error::moves;

/// What shows that an arm was reset: its base angle is 0 by order, rear arm and forearm are read anew
/// from their sensors, and what it was told is forgotten (notes N28 and N35).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResetEvidence {
    /// How long no status came before this one, if that was longer than a few losses explain.
    pub silent_for: Option<Duration>,
    /// The joint angles before.
    pub before: Joints,
    /// The joint angles now.
    pub now: Joints,
    /// Whether they changed more than any motion could have changed them in that time.
    pub jumped: bool,
    /// Whether the base angle is 0, as after every reset.
    pub base_is_zero: bool,
}

impl std::fmt::Display for ResetEvidence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let angles = |it: &Joints| [it.base.0, it.rear.0, it.fore.0];
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

/// Watches the statuses for a reset.
#[derive(Clone, Debug)]
pub(crate) struct ResetDetector {
    /// Why the pose is not trusted, if it is not.
    reason: Option<String>,
    last: Option<(Duration, Status)>,
    /// How long the arm was silent before the statuses that were read last.
    silent_for: Duration,
    /// The time between two statuses.
    period: Duration,
    /// The port was opened since the last status: nobody listened before.
    opened: bool,
    /// The initial angles that were sent and not seen yet, and for how many statuses more they
    /// would explain a jump.
    told: Option<([f32; 2], u32)>,
    /// It was seen at rest, and nothing that moves was sent since.
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
            told: None,
            still: false,
        }
    }

    pub(crate) const fn reason(&self) -> Option<&String> {
        self.reason.as_ref()
    }

    pub(crate) fn confirm(&mut self) {
        self.reason = None;
    }

    /// The port was opened again: until the next status the silence was ours.
    pub(crate) const fn handle_open(&mut self) {
        self.opened = true;
    }

    /// Takes that statuses are read, so many of them behind the first. The arm sent them one period apart: a computer that
    /// stood still reads them late, and the arm was not silent meanwhile.
    pub(crate) fn handle_read(&mut self, now: Duration, behind_the_first: usize, period: Duration) {
        let Some((heard, _)) = self.last else {
            return;
        };
        let behind = u32::try_from(behind_the_first).unwrap_or(u32::MAX);
        let sending = period.saturating_mul(behind);
        self.silent_for = now.saturating_sub(heard).saturating_sub(sending);
        self.period = period;
    }

    pub(crate) fn distrust(&mut self, reason: &str) {
        self.reason = Some(reason.to_owned());
    }

    /// Takes a command that is given to be sent. Where the arm takes itself to be behind new initial
    /// angles, only who gives them knows: a person has to look.
    pub(crate) fn handle_given(&mut self, command: &Command) {
        if let Command::Configuration(Configuration::InitialAngles { .. }) = command {
            self.distrust(TOLD);
        }
    }

    pub(crate) fn handle_sent(&mut self, command: &Command) {
        self.handle_given(command);
        self.still &= !moves(command);
        if let Command::Configuration(Configuration::InitialAngles { rear_deg, fore_deg }) = command
        {
            self.told = Some(([*rear_deg, *fore_deg], AWAITED));
        }
    }

    /// Takes a status; says what shows a reset. A silence that hides one may have another reason, a
    /// full queue, and a command under way may turn the base to just 0: it counts as a reset all the
    /// same, for nothing in the statuses tells the two apart. Only while the port was closed the arm may
    /// have gone on with what it had: `to_zero` tells whether that leads to a base of 0. Of a real arm
    /// the opening itself costs the trust. `at_rest` tells whether nothing is under way: then, and as long as nothing that
    /// moves is sent behind that, an arm that tells the same as before stands as before. (A computer that stood still
    /// switches the laser off before it hears what was told meanwhile.)
    pub(crate) fn handle_status(
        &mut self,
        now: Duration,
        status: &Status,
        to_zero: bool,
        at_rest: bool,
    ) -> Option<ResetEvidence> {
        let went_on = std::mem::take(&mut self.opened) && to_zero;
        self.still |= at_rest;
        let (heard, before) = self.last.replace((now, *status))?;
        if self.told.is_some_and(|(told, _)| shows(status, told)) {
            self.told = None;
            self.distrust(TOLD);
            return None;
        }
        let jumps = self.told.is_some();
        self.told = match self.told {
            Some((told, left)) if left > 0 => Some((told, left - 1)),
            _ => None,
        };
        let silent_for = self.silent_for;
        let deaf = silent_for >= DEAF;
        // Those that are read together were sent one period apart.
        let within = now.saturating_sub(heard).max(self.period);
        let jumped = !jumps && jumped(&before, status, within);
        let base_is_zero = status.base_deg == 0.0;
        // A joint that turned since the last status may have turned alone, and from 0.
        let begun_anew = !went_on && (!self.still || tells_otherwise(&before, status));
        if !(jumped || deaf && base_is_zero && begun_anew) {
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

/// Whether an angle changed that a reset sets or reads anew.
fn tells_otherwise(before: &Status, now: &Status) -> bool {
    let angles = |it: &Status| [it.base_deg, it.rear_deg, it.fore_deg];
    angles(before) != angles(now)
}

fn shows(status: &Status, [rear_deg, fore_deg]: [f32; 2]) -> bool {
    let near = |told: f32, found: f32| (told - found).abs() <= SAME_DEG;
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
    .any(|way| way.abs() > most_deg)
}

const UNCONFIRMED: &str =
    "nobody has confirmed where the arm stands since its port was opened, which resets it";
const TOLD: &str =
    "it was told its initial angles, and nobody has confirmed since that it stands so";
/// Six statuses and a half: many losses in a row, and less than any reset takes.
pub(crate) const DEAF: Duration = Duration::from_millis(520);
/// Half as fast again as a stock arm ever turns on its own, 200 degrees/s.
const FASTEST_DEG_S: f32 = 300.0;
/// A status may be as late as this on its way, and the one before was not.
const LATE_S: f32 = 0.04;
/// Initial angles wait for their turn behind motions: ten minutes of statuses.
const AWAITED: u32 = 7500;
const SAME_DEG: f32 = 0.01;
