//! Jogging is hold-to-run: a button that nobody holds any more is let go.

use std::time::Duration;

use dobot_client::SendError;
use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis};

use super::{Keeper, seconds};
use crate::words::{ClientId, Jog, News, Refusal, Reply};

/// The button that is held.
#[derive(Clone, Debug)]
pub(super) struct Held {
    client: ClientId,
    jog: Jog,
    /// When it was said last.
    said: Duration,
    /// How long its client may be silent.
    patience: Duration,
    /// When a status showed last where the arm is.
    seen: Duration,
}

impl Held {
    /// What lets go of it.
    pub(super) fn release(&self) -> Command {
        release_of(self.jog)
    }

    /// When it is let go of: its client or the arm has fallen silent.
    pub(super) fn falls_silent(&self) -> Duration {
        (self.said + self.patience).min(self.seen + BLIND)
    }
}

impl Keeper {
    /// Presses a jog button, or holds it.
    pub(super) fn jog(
        &mut self,
        client: ClientId,
        jog: Jog,
        patience_s: f64,
    ) -> Result<Reply, Refusal> {
        if released(jog) {
            self.check_lease(client)?;
            self.let_go();
            return Ok(Reply::Done);
        }
        if !moves(jog) {
            return self.command(client, &jog.command());
        }
        self.check_may_move(client)?;
        if let Some(held) = &mut self.held
            && held.jog == jog
            && held.client == client
        {
            held.said = self.now;
            return Ok(Reply::Done);
        }
        if self.held.is_none() && self.session.is_moving() {
            return Err(self.still_moving());
        }
        self.check_way(&jog.command())?;
        self.session.send(jog.command())?;
        self.halt = None;
        self.held = Some(Held {
            client,
            jog,
            said: self.now,
            patience: seconds(patience_s),
            seen: self.now,
        });
        Ok(Reply::Done)
    }

    /// Lets go of the button, if one is held.
    pub(super) fn let_go(&mut self) {
        if let Some(held) = self.held.take() {
            self.drop_waiting("the button was released");
            self.release_now(held.release());
        }
    }

    pub(super) fn watch_dead_man(&mut self) {
        if let Some(held) = &self.held
            && held.falls_silent() <= self.now
        {
            let silent = held.said + held.patience <= self.now;
            let (who, silence) = if silent {
                (self.name(held.client), held.patience)
            } else {
                ("the arm".into(), BLIND)
            };
            let silent_ms = silence.as_secs_f64() * 1e3;
            let text = format!("{who} fell silent for {silent_ms:.0} ms: the button was released");
            self.let_go();
            self.tell(News::DeadMan, text);
        }
    }

    /// With each status: where the arm would come to before it could be stopped has to be allowed.
    pub(super) fn watch_jog(&mut self) {
        let (Some(held), Some(model)) = (&mut self.held, self.session.seen_model()) else {
            return;
        };
        held.seen = self.now;
        let within_s = held.patience.min(BLIND).as_secs_f64() + LINE_S;
        if let Err(violation) = self.policy.check_jog(&model, &held.jog.command(), within_s) {
            let client = held.client;
            self.let_go();
            self.tell_refused(client, &violation.into());
        }
    }

    /// Whether a client may move the arm by hand now.
    pub(super) fn check_may_move(&self, client: ClientId) -> Result<(), Refusal> {
        self.check_link()?;
        self.check_lease(client)?;
        self.check_stop()?;
        self.check_not_detecting()?;
        match &self.run {
            Some(run) if run.has_the_arm() => Err(Refusal::JobRunning(run.job())),
            _ => Ok(()),
        }
    }

    /// Whether the arm is where it says.
    pub(super) fn check_trust(&self) -> Result<(), Refusal> {
        if self.session.is_trusted() {
            return Ok(());
        }
        Err(Refusal::Send(SendError::Untrusted))
    }

    /// Whether the whole way of a command is allowed.
    pub(super) fn check_way(&self, command: &Command) -> Result<(), Refusal> {
        self.session.check(command)?;
        if let Some(model) = self.session.model() {
            self.policy.check(model, command)?;
        }
        Ok(())
    }
}

/// What lets go of a button: a release of its own kind (note N44).
fn release_of(jog: Jog) -> Command {
    let speed_percent = 0.0;
    match jog {
        Jog::Joint(_) => Command::from(JointJog {
            axis: JointJogAxis::Released,
            speed_percent,
        }),
        Jog::Linear(_) => Command::from(LinearJog {
            axis: LinearJogAxis::Released,
            speed_percent,
        }),
    }
}

const fn released(jog: Jog) -> bool {
    match jog {
        Jog::Joint(it) => matches!(it.axis, JointJogAxis::Released),
        Jog::Linear(it) => matches!(it.axis, LinearJogAxis::Released),
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
/// A status and a packet on the line, and a bit.
const LINE_S: f64 = 0.12;
