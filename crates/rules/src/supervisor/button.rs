//! The button that a client holds: what its press, its end and its silence mean for the arm.

use dobot_api::{ClientId, Jog, News, Reply};

use super::jog::{JogSilence, Press, Still, act, is_released, moves};
use super::{Supervisor, seconds};
use crate::refusal::Refusal;

impl Supervisor {
    /// Presses a jog button, or holds it.
    pub(super) fn jog(
        &mut self,
        client: ClientId,
        jog: Jog,
        patience_s: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        if is_released(jog) {
            self.let_go();
            return Ok(Reply::Done);
        }
        if !moves(jog) {
            return self.command(client, &jog.command());
        }
        if let Some(held) = self.jogging.handle_hold(self.arm.now(), client, jog) {
            return match held? {
                Still::Same => Ok(Reply::Done),
                Still::OtherSpeed => self.change_speed(jog),
            };
        }
        self.let_go();
        let press = Press {
            client,
            jog,
            patience: seconds(patience_s),
        };
        let (free, within) = (self.check_free(), self.rests_within());
        let pressed = self
            .jogging
            .handle_press(&mut self.arm, press, free, within);
        if pressed? {
            self.halt.forget();
        }
        Ok(Reply::Done)
    }

    fn change_speed(&mut self, jog: Jog) -> Result<Reply, Refusal> {
        if let Err(why) = self.check_free().and_then(|()| act(&mut self.arm, jog)) {
            self.withdraw(why.clone());
            return Err(why);
        }
        self.halt.forget();
        Ok(Reply::Done)
    }

    /// Whether nothing hinders the arm from being moved by hand.
    pub(super) fn check_free(&self) -> Result<(), Refusal> {
        self.link.check()?;
        self.stop.check()?;
        self.check_guarded()?;
        self.detecting.check()?;
        match &self.run {
            Some(run) if run.has_the_arm() => Err(Refusal::JobRunning(run.job())),
            _ => Ok(()),
        }
    }

    /// A press that waited acts, as soon as the arm rests.
    pub(super) fn watch_press(&mut self) {
        let waits = self.jogging.waits();
        let Some((client, jog)) = waits.filter(|_| !self.arm.session().is_moving()) else {
            return;
        };
        match self.check_free().and_then(|()| act(&mut self.arm, jog)) {
            Ok(()) => {
                self.halt.forget();
                self.jogging.handle_moves(self.arm.now());
            }
            Err(refusal) => {
                self.withdraw(refusal.clone());
                self.tell_refused(client, &refusal);
            }
        }
    }

    pub(super) fn watch_dead_man(&mut self) {
        let Some(JogSilence { client, lasts }) = self.jogging.silence(self.arm.now()) else {
            return;
        };
        let who = client.map_or_else(|| "the arm".into(), |it| self.client_name(it));
        let silent_ms = lasts.as_secs_f64() * 1e3;
        let why = format!("{who} fell silent for {silent_ms:.0} ms");
        if self.withdraw(Refusal::LetGo(why.clone())) {
            self.notify(News::DeadMan, format!("{why}: the button was released"));
        }
    }

    /// Lets go of the button, if one is pressed: its client did.
    pub(super) fn let_go(&mut self) {
        if self.jogging.let_go() {
            self.release_button();
        }
    }

    /// The station lets go of the button, and its client has to press it anew; says whether the arm
    /// moved by it.
    pub(super) fn withdraw(&mut self, why: Refusal) -> bool {
        let acted = self.jogging.bar(why);
        if acted {
            self.release_button();
        }
        acted
    }

    fn release_button(&mut self) {
        self.drop_waiting("the button was released");
        self.halt.release(&mut self.arm);
    }
}
