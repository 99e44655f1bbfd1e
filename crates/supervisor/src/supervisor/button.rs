//! Jog buttons held by clients: press, release and silence.

use std::time::Duration;

use dobot_api::{ClientId, Jog, News, Reply};

use super::jog::{EndedPress, HoldOutcome, JogSilence, Press, act, is_released, moves};
use super::{Supervisor, seconds};
use crate::refusal::Refusal;

impl Supervisor {
    /// Presses or holds a jog button.
    pub(super) fn jog(
        &mut self,
        client: ClientId,
        jog: Jog,
        hold_timeout_s: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        if is_released(jog) {
            self.release_button();
            return Ok(Reply::Done);
        }
        if !moves(jog) {
            return self.command(client, &jog.command());
        }
        if let Some(held) = self.jogging.handle_hold(self.arm.now(), client, jog) {
            return match held? {
                HoldOutcome::Unchanged => Ok(Reply::Done),
                HoldOutcome::SpeedChanged => self.change_speed(jog),
            };
        }
        self.press(client, jog, seconds(hold_timeout_s))
    }

    fn press(&mut self, client: ClientId, jog: Jog, timeout: Duration) -> Result<Reply, Refusal> {
        self.release_button();
        let press = Press {
            client,
            jog,
            timeout,
        };
        let (free, within) = (self.check_free(), self.rests_within());
        let pressed = self
            .jogging
            .handle_press(&mut self.arm, press, free, within);
        if pressed? {
            self.stop_sequence.forget();
        }
        Ok(Reply::Done)
    }

    fn change_speed(&mut self, jog: Jog) -> Result<Reply, Refusal> {
        let changed = self.check_free().and_then(|()| act(&mut self.arm, jog));
        if let Err(why) = changed {
            self.withdraw(why.clone());
            return Err(why);
        }
        self.stop_sequence.forget();
        Ok(Reply::Done)
    }

    /// Checks that nothing prevents moving the arm by hand.
    pub(super) fn check_free(&self) -> Result<(), Refusal> {
        self.link.check()?;
        self.stop_latch.check()?;
        self.check_guarded()?;
        self.detecting.check()?;
        match &self.run {
            Some(run) if run.occupies_arm() => Err(Refusal::JobRunning(run.job())),
            _ => Ok(()),
        }
    }

    /// Starts a waiting press as soon as the arm is at rest.
    pub(super) fn watch_press(&mut self) {
        let waits = self.jogging.waits();
        let Some((client, jog)) = waits.filter(|_| !self.arm.is_busy()) else {
            return;
        };
        match self.check_free().and_then(|()| act(&mut self.arm, jog)) {
            Ok(command) => {
                self.stop_sequence.forget();
                self.jogging.handle_moves(self.arm.now(), command);
            }
            Err(refusal) => {
                self.withdraw(refusal.clone());
                self.notify_refused(client, &refusal);
            }
        }
    }

    pub(super) fn watch_dead_man(&mut self) {
        let Some(JogSilence { client, lasts }) = self.jogging.expired(self.arm.now()) else {
            return;
        };
        let who = client.map_or_else(|| "the arm".into(), |client| self.client_name(client));
        let silent_ms = lasts.as_secs_f64() * 1e3;
        let why = format!("{who} fell silent for {silent_ms:.0} ms");
        let waited = self.jogging.waits();
        if self.withdraw(Refusal::LetGo(why.clone())) {
            self.notify(News::DeadMan, format!("{why}: the button was released"));
        } else if let Some((client, _)) = waited {
            self.notify_lost_press(client);
        }
    }

    /// Releases the client's button, if one is pressed. If the press was too short for the arm to
    /// receive it, a notice says so.
    pub(super) fn release_button(&mut self) {
        let Some(ended) = self.jogging.release() else {
            return;
        };
        if !self.end_press(ended) {
            self.notify_lost_press(ended.client);
        }
    }

    /// Revokes the button, so that the client has to press it again; returns whether the arm had
    /// been given the press.
    pub(super) fn withdraw(&mut self, why: Refusal) -> bool {
        let ended = self.jogging.revoke(why);
        ended.is_some_and(|ended| self.end_press(ended) || ended.command.is_some())
    }

    /// Ends a press; returns whether the arm had been given it.
    fn end_press(&mut self, ended: EndedPress) -> bool {
        let Some(command) = ended.command else {
            return false;
        };
        let forgotten = self.drop_waiting("the button was released");
        self.stop_sequence.release(&mut self.arm);
        !forgotten.contains(&command)
    }

    fn notify_lost_press(&mut self, client: ClientId) {
        let name = self.client_name(client);
        let kind = Refusal::LetGo(String::new()).kind().to_owned();
        let text = format!(
            "refused to {name}: the button was released before the press was sent, so nothing moved; hold it until the arm moves"
        );
        self.notify(News::Refused { client, kind }, text);
    }
}
