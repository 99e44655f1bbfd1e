//! What comes from the arm, and what the keeper has its parts do about it.

use std::time::Duration;

use dobot_client::{Address, CommandId, Event};
use dobot_course::LASER_OFF;
use dobot_wire::Status;

use super::{Keeper, Run};
use crate::words::{LinkPhase, News, Refusal, Reply};

impl Keeper {
    /// Takes that the port is open: statuses may come. Each opening resets a real arm, whatever was
    /// confirmed before (note N35).
    pub fn handle_link_up(&mut self, now: Duration, address: &str) {
        self.handle_time(now);
        if !matches!(address.parse(), Ok(Address::Virtual)) {
            self.arm.session_mut().distrust(OPENED);
        }
        self.link.handle_up(address);
        self.arm.handle_open();
        self.outbox.note_change();
    }

    /// Takes that the port is gone, or could not be opened, and why.
    pub fn handle_link_down(&mut self, now: Duration, phase: LinkPhase, problem: Option<String>) {
        self.handle_time(now);
        let lost = self.link.handle_down(phase, problem);
        self.outbox.note_change();
        if lost {
            self.lose_link();
            self.disarm_laser("the link to the arm was lost");
        }
    }

    /// Takes bytes from the arm.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        self.arm.handle_bytes(bytes);
        self.follow_session();
        self.pump();
    }

    /// Takes what happened in the session.
    pub(super) fn follow_session(&mut self) {
        while let Some(event) = self.arm.session_mut().poll_event() {
            self.outbox.note_change();
            match event {
                Event::Status(status) => self.see(status),
                Event::Completed(id) => self.command_over(id, None),
                Event::NotReached { command, .. } => {
                    self.command_over(command, Some(failure(event)));
                }
                Event::Pausing {
                    command,
                    lasts,
                    by_default,
                } => self.tell_pause(command, lasts, by_default),
                Event::LinkLost { .. } => self.fall_silent(event),
                Event::Reset { evidence, .. } => self.notice_reset(&evidence.to_string()),
                Event::NotSent { command, reason } => {
                    self.command_forgotten(command, &Refusal::from(reason).to_string());
                }
                Event::LaserDisarmed(why) => self.laser_disarmed(&why.to_string()),
                Event::LaserOff => self.tell(News::LaserOff, SWITCHED_OFF.into()),
                _ => {}
            }
        }
    }

    fn see(&mut self, status: Status) {
        if self.link.handle_status() {
            self.tell(News::LinkUp, "the arm tells its state".into());
        }
        if self.link.greet() {
            // Whatever was before: a crash, another program, a cable that was out.
            // What was said last may have got lost with the link.
            self.arm.send_urgent(LASER_OFF);
            self.halt.release_again(&self.arm);
        }
        self.outbox.pass_on(status);
        self.arm.handle_status(status);
        if let Some((client, refusal)) = self.jogging.handle_status(&self.arm) {
            self.withdraw(refusal.clone());
            self.tell_refused(client, &refusal);
        }
        let rests = self.arm.is_at_rest();
        self.halt.handle_status(rests);
        if self.stop.handle_status(rests) {
            self.tell(News::AtRest, "the arm is at rest".into());
        }
        self.of_run(Run::handle_status);
        self.watch_detection(&status);
    }

    fn watch_detection(&mut self, status: &Status) {
        let (packet, outcome) = self.detecting.handle_status(self.arm.now(), status);
        if let Some(packet) = packet {
            self.arm.send_urgent_packet(packet);
        }
        if let Some((client, found)) = outcome {
            let answer = found.and_then(|finding| {
                self.set_dialect(finding.dialect)
                    .map(|_| Reply::Found { finding })
            });
            self.outbox.answer((client, answer));
        }
    }

    /// Switches the laser off and keeps it off; a job that burns is paused.
    pub(super) fn disarm_laser(&mut self, why: &str) {
        let (was_armed, forgotten) = self.arm.disarm_laser();
        for id in forgotten {
            self.command_forgotten(id, &Refusal::LaserDisarmed.to_string());
        }
        if was_armed {
            self.laser_disarmed(why);
        }
    }

    /// The laser is disarmed: it goes off, and a job that burns is paused.
    fn laser_disarmed(&mut self, why: &str) {
        self.arm.part_from_laser();
        self.interrupt_burning(why);
        self.tell(
            News::LaserDisarmed,
            format!("the laser is off and disarmed: {why}"),
        );
    }

    /// An arm that stands still without a word looks dead.
    fn tell_pause(&mut self, command: CommandId, lasts: Duration, by_default: bool) {
        let (command, lasts_s) = (command.0, lasts.as_secs_f64());
        let whose = if by_default {
            "its default pause (state 9, mode 1)".to_owned()
        } else {
            format!("the pause of command {command}")
        };
        self.tell(
            News::Pausing { command, lasts_s },
            format!("the arm waits {lasts_s} s here: {whose}"),
        );
    }

    fn fall_silent(&mut self, event: Event) {
        self.link.handle_silence(&failure(event));
        self.lose_link();
    }

    /// What was not sent is forgotten; what the arm has, it does.
    fn lose_link(&mut self) {
        self.arm.lose_sight();
        self.arm.part_from_laser();
        // Statuses may be lost on a line that still carries packets.
        self.arm.release_urgently();
        self.jogging
            .bar(Refusal::LetGo("the link to the arm was lost".into()));
        self.drop_waiting("the link to the arm was lost");
        let text = self.link.loss();
        self.interrupt_run(&text);
        self.end_detection("the link to the arm was lost");
        self.tell(News::LinkLost, text);
    }

    fn notice_reset(&mut self, evidence: &str) {
        self.jogging.bar(Refusal::LetGo("the arm was reset".into()));
        self.arm.part_from_laser();
        // The session has forgotten what was under way, too.
        for id in self.under_way() {
            self.command_over(id, Some("the arm was reset".into()));
        }
        self.interrupt_run("the arm was reset");
        self.end_detection("the arm was reset");
        self.tell(
            News::Reset,
            format!("the arm was reset ({evidence}): it believes to stand where it may not stand; confirm its pose, or set its angles anew"),
        );
    }
}

/// What a failed event says.
fn failure(event: Event) -> String {
    event
        .or_failed()
        .err()
        .map_or_else(String::new, |error| error.to_string())
}

const SWITCHED_OFF: &str = "the laser was switched off: nothing that goes on came in time, and it may not burn on the spot";
const OPENED: &str =
    "its port was opened, which resets a stock arm: its base angle is 0 then, wherever it points";
