//! Jogging is hold-to-run: a button that nobody holds any more is let go.

use std::time::Duration;

use dobot_wire::{JointJogAxis, LinearJogAxis};

use super::{Keeper, seconds};
use crate::words::{ClientId, Jog, News, Refusal, Reply};

/// The button that a client presses.
#[derive(Clone, Debug)]
pub(super) struct Held {
    client: ClientId,
    jog: Jog,
    /// When it was said last.
    said: Duration,
    /// How long its client may be silent.
    patience: Duration,
    phase: Phase,
}

/// What a press does.
#[derive(Clone, Debug)]
enum Phase {
    /// Nothing yet: the arm still runs down from what was before.
    Waits,
    /// The arm moves.
    Acts {
        /// When a status showed last where the arm is.
        seen: Duration,
    },
    /// Nothing any more: it was refused, or let go by the station. A new press is needed, be it of the
    /// same button, so that no arm moves again because a client wakes up or a limit moves away.
    Over {
        why: Refusal,
        /// Those who watch know it.
        told: bool,
    },
}

impl Held {
    /// When it is let go of: its client or the arm has fallen silent.
    pub(super) fn falls_silent(&self) -> Option<Duration> {
        let silent = self.said + self.patience;
        match self.phase {
            Phase::Waits => Some(silent),
            Phase::Acts { seen } => Some(silent.min(seen + BLIND)),
            Phase::Over { .. } => None,
        }
    }

    const fn acts(&self) -> bool {
        matches!(self.phase, Phase::Acts { .. })
    }
}

impl Keeper {
    /// Presses a jog button, or holds it. Where the arm runs down from the last motion, the press waits
    /// for its end.
    pub(super) fn jog(
        &mut self,
        client: ClientId,
        jog: Jog,
        patience_s: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        if released(jog) {
            self.let_go();
            return Ok(Reply::Done);
        }
        if !moves(jog) {
            return self.command(client, &jog.command());
        }
        let same = |it: &&mut Held| it.client == client && is_same_button(it.jog, jog);
        if let Some(held) = self.held.as_mut().filter(same) {
            held.said = self.arm.now();
            let changed = held.jog != jog;
            held.jog = jog;
            return match &held.phase {
                Phase::Over { why, .. } => Err(why.clone()),
                Phase::Acts { .. } if changed => self.change_speed(jog),
                Phase::Acts { .. } | Phase::Waits => Ok(Reply::Done),
            };
        }
        self.let_go();
        let pressed = self.press(jog);
        let refused = pressed.as_ref().err().cloned();
        self.held = Some(Held {
            client,
            jog,
            said: self.arm.now(),
            patience: seconds(patience_s),
            phase: pressed.unwrap_or_else(|why| Phase::Over { why, told: false }),
        });
        refused.map_or(Ok(Reply::Done), Err)
    }

    /// What a new press does, if it may.
    fn press(&mut self, jog: Jog) -> Result<Phase, Refusal> {
        if self.arm.session().is_moving() {
            self.check_free()?;
            // Whoever presses while the arm is at something longer means that, and not what follows it.
            let runs_down =
                self.arm.session().waiting() == 0 && self.rests_within() <= LONGEST_RUN_DOWN;
            return if runs_down {
                Ok(Phase::Waits)
            } else {
                Err(self.still_moving())
            };
        }
        self.act(jog)?;
        Ok(Phase::Acts {
            seen: self.arm.now(),
        })
    }

    fn change_speed(&mut self, jog: Jog) -> Result<Reply, Refusal> {
        let changed = self.act(jog);
        if let Err(why) = &changed {
            self.withdraw(why.clone());
        }
        changed.map(|()| Reply::Done)
    }

    fn act(&mut self, jog: Jog) -> Result<(), Refusal> {
        self.check_free()?;
        self.arm.check_way(&jog.command())?;
        self.arm.session_mut().send(jog.command())?;
        self.halt.forget();
        Ok(())
    }

    /// A press that waited acts, as soon as the arm rests.
    pub(super) fn watch_press(&mut self) {
        let Some(held) = &self.held else { return };
        if !matches!(held.phase, Phase::Waits) || self.arm.session().is_moving() {
            return;
        }
        let (client, jog) = (held.client, held.jog);
        if let Err(refusal) = self.act(jog) {
            self.withdraw(refusal.clone());
            self.tell_refused(client, &refusal);
        } else if let Some(held) = &mut self.held {
            held.phase = Phase::Acts {
                seen: self.arm.now(),
            };
        }
    }

    /// Lets go of the button, if one is pressed: its client did.
    pub(super) fn let_go(&mut self) {
        if self.held.take().is_some_and(|it| it.acts()) {
            self.release_button();
        }
    }

    /// The station lets go of the button, and its client has to press it anew.
    pub(super) fn withdraw(&mut self, why: Refusal) {
        if self.bar(why) {
            self.release_button();
        }
    }

    /// The same of an arm that is told otherwise to come to rest; says whether the button moved it.
    pub(super) fn bar(&mut self, why: Refusal) -> bool {
        let Some(held) = &mut self.held else {
            return false;
        };
        let acted = held.acts();
        if !matches!(held.phase, Phase::Over { .. }) {
            held.phase = Phase::Over { why, told: false };
        }
        acted
    }

    fn release_button(&mut self) {
        self.drop_waiting("the button was released");
        self.halt.release(&mut self.arm);
    }

    /// Whether those who watch know already why a button does nothing, which is said as often as its
    /// client says it; from now on they do.
    pub(super) fn is_told(&mut self, client: ClientId, refusal: &Refusal) -> bool {
        match &mut self.held {
            Some(Held {
                client: whose,
                phase: Phase::Over { why, told },
                ..
            }) if *whose == client && why == refusal => std::mem::replace(told, true),
            _ => false,
        }
    }

    pub(super) fn watch_dead_man(&mut self) {
        let Some(held) = &self.held else { return };
        if held.falls_silent().is_none_or(|it| it > self.arm.now()) {
            return;
        }
        let silent = held.said + held.patience <= self.arm.now();
        let (who, silence) = if silent {
            (self.name(held.client), held.patience)
        } else {
            ("the arm".into(), BLIND)
        };
        let silent_ms = silence.as_secs_f64() * 1e3;
        let why = format!("{who} fell silent for {silent_ms:.0} ms");
        let acted = held.acts();
        self.withdraw(Refusal::LetGo(why.clone()));
        if acted {
            self.tell(News::DeadMan, format!("{why}: the button was released"));
        }
    }

    /// With each status: where the arm would come to before it could be stopped has to be allowed.
    pub(super) fn watch_jog(&mut self) {
        let (Some(held), Some(model)) = (&mut self.held, self.arm.session().seen_model()) else {
            return;
        };
        let Phase::Acts { seen } = &mut held.phase else {
            return;
        };
        *seen = self.arm.now();
        let within_s = held.patience.min(BLIND).as_secs_f64() + LINE_S;
        if let Err(violation) = self
            .arm
            .policy()
            .check_jog(&model, &held.jog.command(), within_s)
        {
            let client = held.client;
            let refusal = Refusal::from(violation);
            self.withdraw(refusal.clone());
            self.tell_refused(client, &refusal);
        }
    }

    /// Whether a client may move the arm by hand now.
    pub(super) fn check_may_move(&self, client: ClientId) -> Result<(), Refusal> {
        self.leases.check(client)?;
        self.check_free()
    }

    /// Whether nothing hinders the arm from being moved by hand.
    fn check_free(&self) -> Result<(), Refusal> {
        self.check_link()?;
        self.stop.check()?;
        self.check_not_detecting()?;
        match &self.run {
            Some(run) if run.has_the_arm() => Err(Refusal::JobRunning(run.job())),
            _ => Ok(()),
        }
    }
}

const fn released(jog: Jog) -> bool {
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
fn moves(jog: Jog) -> bool {
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
