//! Commands that come from a camera, a microphone or a hand, and what a microphone heard.

use dobot_api::{ClientId, Heard, News, Reply, Sense};
use dobot_wire::{Command, Voice, VoiceOrder};

use super::Supervisor;
use crate::refusal::Refusal;

impl Supervisor {
    /// Sends a command that comes from a sense, and publishes where it comes from.
    pub(super) fn sensed_command(
        &mut self,
        client: ClientId,
        sense: Sense,
        command: &Command,
    ) -> Result<Reply, Refusal> {
        let text = match (sense, command) {
            (Sense::Camera, Command::MoveTo(to)) => {
                let (x_mm, y_mm, z_mm) = (to.x_mm, to.y_mm, to.z_mm);
                format!("move to x {x_mm:.1} y {y_mm:.1} z {z_mm:.1}")
            }
            (Sense::Microphone, Command::Voice(voice)) => {
                self.check_spoken(voice)?;
                voice.text().unwrap_or_default().to_owned()
            }
            (Sense::Hand, Command::Gesture(hand)) => {
                let grab = if hand.grab { ", closed" } else { "" };
                format!("x {:.1} y {:.1} z {:.1}{grab}", hand.x, hand.y, hand.z)
            }
            _ => return Err(Refusal::Malformed(not_of(sense))),
        };
        let raw = self.arm.raw_command(command)?;
        let reply = self.command(client, &raw)?;
        if let Reply::Accepted { command, .. } = reply {
            let text = format!("{}: {sense}: {text}", self.client_name(client));
            let news = News::Sensed {
                client,
                sense,
                command,
            };
            self.notify(news, text);
        }
        Ok(reply)
    }

    /// Checks that a spoken order moves no further than the policy allows: it may have been
    /// misunderstood.
    fn check_spoken(&self, voice: &Voice) -> Result<(), Refusal> {
        let Some(VoiceOrder::Move { x_mm, y_mm, z_mm }) = VoiceOrder::parse(voice) else {
            return Ok(()); // An order that is not understood is refused as a command.
        };
        let by_mm = [x_mm, y_mm, z_mm].map(|mm| f64::from(mm.abs()));
        let longest_mm = by_mm.into_iter().fold(0.0, f64::max);
        let checked = self.arm.policy().check_spoken(longest_mm);
        checked.map_err(|violation| Refusal::Policy(Box::new(violation)))
    }

    /// Publishes what a microphone heard; nothing moves.
    pub(super) fn publish_heard(
        &mut self,
        client: ClientId,
        talker: Option<ClientId>,
        heard: Heard,
    ) -> Result<Reply, Refusal> {
        if let Heard::Order { words } = &heard
            && Voice::new(words).is_err()
        {
            let text = format!("the words are {words:?}; allowed are up to 40 ASCII characters");
            return Err(Refusal::Malformed(text));
        }
        let name = self.client_name(talker.unwrap_or(client));
        let text = format!("{name}: {}: {heard}", Sense::Microphone);
        let news = News::Heard {
            client: talker,
            heard,
        };
        self.notify(news, text);
        Ok(Reply::Done)
    }
}

fn not_of(sense: Sense) -> String {
    let allowed = match sense {
        Sense::Camera => "move_to",
        Sense::Microphone => "voice",
        Sense::Hand => "gesture",
    };
    format!("a {sense} may only move the arm; the command has to be {allowed}")
}
