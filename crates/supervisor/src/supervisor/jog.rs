//! Hold-to-run jogging: a button that is no longer held is released.

use std::time::Duration;

use dobot_api::{ClientId, Jog};
use dobot_session::CommandId;
use dobot_wire::{JointJogAxis, LinearJogAxis};

use super::arm::Arm;
use super::still_moving;
use crate::refusal::Refusal;

/// The button that a client holds, if any.
#[derive(Debug, Default)]
pub(super) struct Jogging {
    held: Option<Held>,
}

#[derive(Clone, Debug)]
struct Held {
    client: ClientId,
    jog: Jog,
    /// When the last hold request came.
    last_hold: Duration,
    /// The longest allowed silence of its client.
    timeout: Duration,
    phase: JogPhase,
}

/// A button and the client that presses it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Press {
    pub(super) client: ClientId,
    pub(super) jog: Jog,
    /// The longest allowed silence of its client.
    pub(super) timeout: Duration,
}

/// The outcome of a repeated hold request.
#[derive(Debug)]
pub(super) enum HoldOutcome {
    /// No change.
    Unchanged,
    /// The speed has changed.
    SpeedChanged,
}

/// A press that has ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct EndedPress {
    pub(super) client: ClientId,
    /// The motion command of the press, sent or waiting; `None` if the press still waited for the
    /// arm to rest.
    pub(super) command: Option<CommandId>,
}

/// The party that fell silent while a button was held.
#[derive(Debug)]
pub(super) struct JogSilence {
    /// The client; `None` for the arm.
    pub(super) client: Option<ClientId>,
    pub(super) lasts: Duration,
}

/// The state of a press.
#[derive(Clone, Debug)]
enum JogPhase {
    /// Waiting for the arm to come to rest after the previous motion.
    Waiting,
    /// The arm moves.
    Moving {
        command: CommandId,
        /// When the last status arrived.
        seen: Duration,
    },
    /// Refused, or revoked by the station. A new press is required, even of the same button, so
    /// that the arm does not move again because a client resumes or a limit moves away.
    Ended {
        why: Refusal,
        /// Whether a notice has been published.
        reported: bool,
    },
}

impl Held {
    /// Returns when the button is released because its client or the arm is silent.
    fn times_out_at(&self) -> Option<Duration> {
        let silent = self.last_hold + self.timeout;
        match self.phase {
            JogPhase::Waiting => Some(silent),
            JogPhase::Moving { seen, .. } => Some(silent.min(seen + BLIND)),
            JogPhase::Ended { .. } => None,
        }
    }

    /// Returns the press that ends now, unless it has ended already.
    const fn ended(&self) -> Option<EndedPress> {
        let command = match self.phase {
            JogPhase::Waiting => None,
            JogPhase::Moving { command, .. } => Some(command),
            JogPhase::Ended { .. } => return None,
        };
        Some(EndedPress {
            client: self.client,
            command,
        })
    }
}

impl Jogging {
    /// Handles a client that holds a button; `None` if it is not the button held.
    pub(super) fn handle_hold(
        &mut self,
        now: Duration,
        client: ClientId,
        jog: Jog,
    ) -> Option<Result<HoldOutcome, Refusal>> {
        let same = |held: &&mut Held| held.client == client && is_same_button(held.jog, jog);
        let held = self.held.as_mut().filter(same)?;
        held.last_hold = now;
        let changed = held.jog != jog;
        held.jog = jog;
        Some(match &held.phase {
            JogPhase::Ended { why, .. } => Err(why.clone()),
            JogPhase::Moving { .. } if changed => Ok(HoldOutcome::SpeedChanged),
            JogPhase::Moving { .. } | JogPhase::Waiting => Ok(HoldOutcome::Unchanged),
        })
    }

    /// Handles a new press if nothing but the end of the previous motion (`free`) prevents it.
    /// While the arm comes to rest, within `rests_within`, the press waits. Returns whether the arm
    /// moves.
    pub(super) fn handle_press(
        &mut self,
        arm: &mut Arm,
        press: Press,
        free: Result<(), Refusal>,
        rests_within: Duration,
    ) -> Result<bool, Refusal> {
        let pressed = free.and_then(|()| begin(arm, press.jog, rests_within));
        let refused = pressed.as_ref().err().cloned();
        let held = self.held.insert(Held {
            client: press.client,
            jog: press.jog,
            last_hold: arm.now(),
            timeout: press.timeout,
            phase: pressed.unwrap_or_else(|why| JogPhase::Ended {
                why,
                reported: false,
            }),
        });
        let acts = matches!(held.phase, JogPhase::Moving { .. });
        refused.map_or(Ok(acts), Err)
    }

    /// Returns the press that waits for the arm to come to rest.
    pub(super) fn waits(&self) -> Option<(ClientId, Jog)> {
        let held = self.held.as_ref();
        let waits = held.filter(|held| matches!(held.phase, JogPhase::Waiting));
        waits.map(|held| (held.client, held.jog))
    }

    /// Marks the waiting press as moving the arm.
    pub(super) fn handle_moves(&mut self, now: Duration, command: CommandId) {
        if let Some(held) = &mut self.held {
            held.phase = JogPhase::Moving { command, seen: now };
        }
    }

    /// Releases the button for its client; returns the press that ends.
    pub(super) fn release(&mut self) -> Option<EndedPress> {
        self.held.take().and_then(|held| held.ended())
    }

    /// Revokes the button: its client has to press it again. Returns the press that ends.
    pub(super) fn revoke(&mut self, why: Refusal) -> Option<EndedPress> {
        let held = self.held.as_mut()?;
        let ended = held.ended()?;
        held.phase = JogPhase::Ended {
            why,
            reported: false,
        };
        Some(ended)
    }

    /// Returns whether this refusal, which repeats with each hold request, was already reported,
    /// and marks it as reported.
    pub(super) fn was_reported(&mut self, client: ClientId, refusal: &Refusal) -> bool {
        match &mut self.held {
            Some(Held {
                client: whose,
                phase: JogPhase::Ended { why, reported },
                ..
            }) if *whose == client && why == refusal => std::mem::replace(reported, true),
            _ => false,
        }
    }

    /// Returns when the button is released because its client or the arm is silent.
    pub(super) fn times_out_at(&self) -> Option<Duration> {
        self.held.as_ref().and_then(Held::times_out_at)
    }

    /// Returns the party whose silence requires the release of the button.
    pub(super) fn expired(&self, now: Duration) -> Option<JogSilence> {
        let held = self.held.as_ref()?;
        held.times_out_at().filter(|at| *at <= now)?;
        let of_client = held.last_hold + held.timeout <= now;
        Some(JogSilence {
            client: of_client.then_some(held.client),
            lasts: if of_client { held.timeout } else { BLIND },
        })
    }

    /// Checks with each status that the farthest position before the arm could be stopped is
    /// allowed. Returns the client and the refusal if not.
    pub(super) fn handle_status(&mut self, arm: &Arm) -> Option<(ClientId, Refusal)> {
        let (held, model) = (self.held.as_mut()?, arm.session().seen_model()?);
        let JogPhase::Moving { seen, .. } = &mut held.phase else {
            return None;
        };
        *seen = arm.now();
        let within_s = held.timeout.min(BLIND).as_secs_f64() + LINE_S;
        let checked = arm
            .policy()
            .check_jog(&model, &held.jog.command(), within_s);
        checked
            .err()
            .map(|violation| (held.client, violation.into()))
    }
}

/// Starts a press, if allowed.
fn begin(arm: &mut Arm, jog: Jog, rests_within: Duration) -> Result<JogPhase, Refusal> {
    if !arm.is_busy() {
        let command = act(arm, jog)?;
        let seen = arm.now();
        return Ok(JogPhase::Moving { command, seen });
    }
    // A press during a longer motion was not meant for what follows it.
    if arm.session().waiting() == 0 && rests_within <= LONGEST_RUN_DOWN {
        return Ok(JogPhase::Waiting);
    }
    Err(still_moving(rests_within))
}

/// Starts a jog, if its path is allowed.
pub(super) fn act(arm: &mut Arm, jog: Jog) -> Result<CommandId, Refusal> {
    arm.send(&jog.command())
}

/// Returns whether this is a button release.
pub(super) const fn is_released(jog: Jog) -> bool {
    match jog {
        Jog::Joint(jog) => matches!(jog.axis, JointJogAxis::Released),
        Jog::Linear(jog) => matches!(jog.axis, LinearJogAxis::Released),
    }
}

/// Returns whether two presses are of the same button, possibly at two speeds.
fn is_same_button(one: Jog, other: Jog) -> bool {
    match (one, other) {
        (Jog::Joint(one), Jog::Joint(other)) => one.axis == other.axis,
        (Jog::Linear(one), Jog::Linear(other)) => one.axis == other.axis,
        _ => false,
    }
}

/// Returns whether the button has to be held; switches do not.
pub(super) fn moves(jog: Jog) -> bool {
    match jog {
        Jog::Joint(jog) => jog.axis.moves(),
        Jog::Linear(jog) => jog.axis.moves(),
    }
}

/// The longest time between two statuses, allowing for a lost one.
const BLIND: Duration = Duration::from_millis(200);
/// The longest wait of a press for the arm to come to rest: a servo jog at 10 degrees/s2, as set by
/// the vendor's program, takes 1.6 s.
const LONGEST_RUN_DOWN: Duration = Duration::from_secs(3);
/// A status and a packet on the line, with some margin.
const LINE_S: f64 = 0.12;
