//! Jogging is hold-to-run: a button that nobody holds any more is let go.

use std::time::Duration;

use dobot_api::{ClientId, Jog};
use dobot_session::CommandId;
use dobot_wire::{JointJogAxis, LinearJogAxis};

use super::arm::Arm;
use super::still_moving;
use crate::refusal::Refusal;

/// The button that a client presses, if one does.
#[derive(Debug, Default)]
pub(super) struct Jogging {
    held: Option<Held>,
}

#[derive(Clone, Debug)]
struct Held {
    client: ClientId,
    jog: Jog,
    /// When it was said last.
    last_hold: Duration,
    /// How long its client may be silent.
    timeout: Duration,
    phase: JogPhase,
}

/// A button, and who presses it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Press {
    pub(super) client: ClientId,
    pub(super) jog: Jog,
    /// How long its client may be silent.
    pub(super) timeout: Duration,
}

/// What is done about a button that is still held.
#[derive(Debug)]
pub(super) enum HoldOutcome {
    /// Nothing.
    Unchanged,
    /// The arm is to move at another speed.
    SpeedChanged,
}

/// A button that was pressed and is not any more.
#[derive(Clone, Copy, Debug)]
pub(super) struct EndedPress {
    pub(super) client: ClientId,
    /// What moves the arm by it, sent or to be sent; `None` where it still waited for the arm to rest.
    pub(super) command: Option<CommandId>,
}

/// Who fell silent while a button was held.
#[derive(Debug)]
pub(super) struct JogSilence {
    /// The client; else the arm.
    pub(super) client: Option<ClientId>,
    pub(super) lasts: Duration,
}

/// What a press does.
#[derive(Clone, Debug)]
enum JogPhase {
    /// Nothing yet: the arm still runs down from what was before.
    Waiting,
    /// The arm moves.
    Moving {
        command: CommandId,
        /// When a status showed last where the arm is.
        seen: Duration,
    },
    /// Nothing any more: it was refused, or let go by the station. A new press is needed, be it of the
    /// same button, so that no arm moves again because a client wakes up or a limit moves away.
    Ended {
        why: Refusal,
        /// Those who watch know it.
        reported: bool,
    },
}

impl Held {
    /// When it is let go of: its client or the arm has fallen silent.
    fn times_out_at(&self) -> Option<Duration> {
        let silent = self.last_hold + self.timeout;
        match self.phase {
            JogPhase::Waiting => Some(silent),
            JogPhase::Moving { seen, .. } => Some(silent.min(seen + BLIND)),
            JogPhase::Ended { .. } => None,
        }
    }

    /// The press that ends with it, if it is not over already.
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
    /// Takes that a client holds a button; `None` when it is another than the one that is held.
    pub(super) fn handle_hold(
        &mut self,
        now: Duration,
        client: ClientId,
        jog: Jog,
    ) -> Option<Result<HoldOutcome, Refusal>> {
        let same = |it: &&mut Held| it.client == client && is_same_button(it.jog, jog);
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

    /// Takes that a client presses a button, where nothing but its end hinders the motion before. Where
    /// the arm runs down from that, for so long at the most, the press waits. Says whether the arm moves.
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

    /// The press that waits for the arm to rest.
    pub(super) fn waits(&self) -> Option<(ClientId, Jog)> {
        let held = self.held.as_ref();
        let waits = held.filter(|it| matches!(it.phase, JogPhase::Waiting));
        waits.map(|it| (it.client, it.jog))
    }

    /// Takes that the press that waited moves the arm now.
    pub(super) fn handle_moves(&mut self, now: Duration, command: CommandId) {
        if let Some(held) = &mut self.held {
            held.phase = JogPhase::Moving { command, seen: now };
        }
    }

    /// Lets go of the button, if one is pressed: its client did. Gives the press that ends.
    pub(super) fn release(&mut self) -> Option<EndedPress> {
        self.held.take().and_then(|it| it.ended())
    }

    /// Lets go of the button, and its client has to press it anew. Gives the press that ends.
    pub(super) fn revoke(&mut self, why: Refusal) -> Option<EndedPress> {
        let held = self.held.as_mut()?;
        let ended = held.ended()?;
        held.phase = JogPhase::Ended {
            why,
            reported: false,
        };
        Some(ended)
    }

    /// Whether those who watch know already why a button does nothing, which is said as often as its
    /// client says it; from now on they do.
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

    /// When the button is let go of: its client or the arm has fallen silent.
    pub(super) fn times_out_at(&self) -> Option<Duration> {
        self.held.as_ref().and_then(Held::times_out_at)
    }

    /// Who has fallen silent, so that the button has to be let go of.
    pub(super) fn expired(&self, now: Duration) -> Option<JogSilence> {
        let held = self.held.as_ref()?;
        held.times_out_at().filter(|it| *it <= now)?;
        let of_client = held.last_hold + held.timeout <= now;
        Some(JogSilence {
            client: of_client.then_some(held.client),
            lasts: if of_client { held.timeout } else { BLIND },
        })
    }

    /// With each status: where the arm would come to before it could be stopped has to be allowed.
    /// Says what hinders whose button.
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
        checked.err().map(|it| (held.client, it.into()))
    }
}

/// What a new press does, if it may.
fn begin(arm: &mut Arm, jog: Jog, rests_within: Duration) -> Result<JogPhase, Refusal> {
    if !arm.session().is_moving() {
        let command = act(arm, jog)?;
        let seen = arm.now();
        return Ok(JogPhase::Moving { command, seen });
    }
    // Whoever presses while the arm is at something longer means that, and not what follows it.
    if arm.session().waiting() == 0 && rests_within <= LONGEST_RUN_DOWN {
        return Ok(JogPhase::Waiting);
    }
    Err(still_moving(rests_within))
}

/// Moves the arm by a button, if the way is allowed.
pub(super) fn act(arm: &mut Arm, jog: Jog) -> Result<CommandId, Refusal> {
    arm.send(&jog.command())
}

/// Whether it is the release of a button.
pub(super) const fn is_released(jog: Jog) -> bool {
    match jog {
        Jog::Joint(it) => matches!(it.axis, JointJogAxis::Released),
        Jog::Linear(it) => matches!(it.axis, LinearJogAxis::Released),
    }
}

/// Whether two presses are of one button, perhaps with two speeds.
fn is_same_button(one: Jog, other: Jog) -> bool {
    match (one, other) {
        (Jog::Joint(one), Jog::Joint(other)) => one.axis == other.axis,
        (Jog::Linear(one), Jog::Linear(other)) => one.axis == other.axis,
        _ => false,
    }
}

/// Whether the button has to be held: switches have not.
pub(super) fn moves(jog: Jog) -> bool {
    match jog {
        Jog::Joint(it) => it.axis.moves(),
        Jog::Linear(it) => it.axis.moves(),
    }
}

/// The longest from one status to the next, by when this is looked at again: one may get lost.
const BLIND: Duration = Duration::from_millis(200);
/// So long a press waits for the arm to run down: a jog of the servo at 10 degrees/s2, as the vendor's
/// program sets it, takes 1.6 s.
const LONGEST_RUN_DOWN: Duration = Duration::from_secs(3);
/// A status and a packet on the line, and a bit.
const LINE_S: f64 = 0.12;
