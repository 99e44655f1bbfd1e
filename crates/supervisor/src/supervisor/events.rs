//! Events of the arm, its link and its journal, and the supervisor's reactions.

use std::time::Duration;

use dobot_api::{FleetWideStop, LinkPhase, LinkProblem, News, Reply};
use dobot_motion::LASER_OFF;
use dobot_session::{Address, CommandId, Event, LinkError, NoStatus};

use super::Supervisor;
use super::fleet_stops::SavedFleetStop;
use super::link::{LOST, LinkEnd, cause_of_silence};
use super::request::REASON_LEN;
use super::run::{Effect, Run};
use super::stop_latch::StopLatch;
use super::stop_latch::StoppedBy;
use crate::plain;
use crate::refusal::Refusal;

impl Supervisor {
    /// Handles an opened port: statuses may arrive. Each opening resets a real arm, so an earlier
    /// confirmation does not hold (note N35).
    pub fn handle_link_up(&mut self, now: Duration, address: &str) {
        self.handle_time(now);
        if !matches!(address.parse(), Ok(Address::Virtual)) {
            self.arm.session_mut().distrust(OPENED);
        }
        self.link.handle_up(address);
        self.arm.handle_open();
        self.outgoing.note_change();
    }

    /// Handles a port that is gone or could not be opened.
    pub fn handle_link_down(&mut self, now: Duration, phase: LinkPhase, problem: LinkProblem) {
        self.handle_time(now);
        let problem = self.with_received(problem);
        let end = self.link.handle_down(phase, problem);
        self.outgoing.note_change();
        self.handle_link_end(end);
        if end != LinkEnd::None {
            self.disarm_laser(LOST);
        }
    }

    /// Adds what arrived from a port that was closed before the first status.
    fn with_received(&self, problem: LinkProblem) -> LinkProblem {
        let received = self.arm.session().no_status();
        if !self.link.is_listening() || received == NoStatus::Nothing {
            return problem;
        }
        LinkProblem {
            cause: cause_of_silence(&received),
            text: format!("{}; {received}", problem.text),
            remedy: Some(received.hint().to_owned()),
        }
    }

    /// Handles bytes from the arm.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        self.arm.handle_bytes(bytes);
        self.follow_session();
        // The status that shows the arm at rest is also the permit for the waiting press.
        self.watch_press();
        self.feed();
    }

    /// Handles a stall of the station of this length: reactions due meanwhile happen now, as after
    /// a fault. The watchdog may have acted as well.
    pub fn handle_stall(&mut self, now: Duration, silent: Duration) {
        self.arm.set_time(now);
        self.arm.session_mut().handle_stall(now);
        let why = format!("the station hung for {:.1} s", silent.as_secs_f64());
        self.arm.send_at_once(LASER_OFF);
        self.withdraw(Refusal::LetGo(why.clone()));
        self.notify(
            News::Trouble,
            format!("{why}: the laser was switched off and the button released"),
        );
        self.disarm_laser(&why);
    }

    /// Handles the state of the watchdog: present, or gone and why. Without one, jogging and
    /// burning are refused.
    pub fn handle_watchdog(&mut self, now: Duration, gone: Option<String>) {
        self.arm.set_time(now);
        if let Some(why) = &gone
            && self.unguarded.is_none()
        {
            let refusal = Refusal::Unguarded(why.clone());
            let text = refusal.to_string();
            self.withdraw(refusal);
            self.disarm_laser(&text);
        }
        self.unguarded = gone;
    }

    /// Checks that a watchdog guards the arm or none is needed.
    pub(super) fn check_guarded(&self) -> Result<(), Refusal> {
        let gone = self.unguarded.clone().map(Refusal::Unguarded);
        gone.map_or(Ok(()), Err)
    }

    /// Checks that what was just sent to the arm leaves this computer.
    pub(super) fn check_delivered(&self, what: &'static str) -> Result<Reply, Refusal> {
        // An arm that was never connected does nothing.
        if self.link.is_there() || self.arm.last().is_none() {
            return Ok(Reply::Done);
        }
        Err(Refusal::NotDelivered(what))
    }

    /// Reports every second that a stop was not delivered.
    pub(super) fn watch_delivery(&mut self) {
        if self.stop_latch.is_due(self.arm.now()) {
            self.notify(News::Trouble, NOT_DELIVERED.to_owned());
        }
    }

    /// Restores the stops that held when the station ended: they hold until a person clears them.
    pub fn handle_saved_stops(
        &mut self,
        now: Duration,
        own: Option<StoppedBy>,
        fleet: Vec<SavedFleetStop>,
    ) {
        self.handle_time(now);
        self.stop_latch.handle_saved(self.arm.now(), own, fleet);
        self.outgoing.note_change();
    }

    /// Handles a fleet-wide stop made at this station with the id `origin`: stops this arm and
    /// returns the stop to send to the others. `now_ms` is the time in milliseconds since
    /// 1970-01-01T00:00:00Z.
    pub fn handle_fleet_stop(
        &mut self,
        now: Duration,
        origin: &str,
        by: StoppedBy,
        now_ms: u64,
    ) -> (FleetWideStop, Reply) {
        self.handle_time(now);
        let by = StoppedBy {
            by: plain(&by.by, REASON_LEN),
            reason: by.reason.map(|reason| plain(&reason, REASON_LEN)),
            ..by
        };
        let stop = self.stop_latch.make_fleet_stop(origin, by, now_ms);
        let reply = self.bring_to_rest(&stop.text(), StopLatch::hold);
        self.outgoing.note_change();
        (stop, reply)
    }

    /// Handles the fleet-wide stops that another station knows: a new one stops this arm as well.
    /// An arm that no stop holds any more is released as soon as it is at rest. Returns `None` if
    /// no stop holds it then.
    pub fn handle_fleet_stops(&mut self, now: Duration, stops: &[FleetWideStop]) -> Option<Reply> {
        self.handle_time(now);
        let reply = if self.stop_latch.adopt(stops) {
            self.bring_to_rest("the fleet was stopped", StopLatch::hold)
        } else {
            Reply::Stopping {
                rests_within_s: self.rests_within().as_secs_f64(),
                delivered: self.stop_latch.view().is_none_or(|view| view.delivered),
            }
        };
        self.release_fleet_stop();
        self.outgoing.note_change();
        self.stop_latch.holds().then_some(reply)
    }

    /// Handles the reset of all fleet-wide stops: this arm is released as soon as it is at rest,
    /// unless it has a stop of its own. Returns the stops to send to the others.
    pub fn handle_fleet_reset(&mut self, now: Duration, by: &str) -> Vec<FleetWideStop> {
        self.handle_time(now);
        self.stop_latch.reset_fleet(&plain(by, REASON_LEN));
        self.release_fleet_stop();
        self.outgoing.note_change();
        self.stop_latch.fleet_stops()
    }

    /// Returns whether a stop holds the arm.
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.stop_latch.holds()
    }

    /// Returns the stops to save, if they have changed: this arm's own and those of the fleet.
    pub fn poll_saved_stops(&mut self) -> Option<(Option<StoppedBy>, Vec<SavedFleetStop>)> {
        self.stop_latch.poll_saved()
    }

    /// Releases the arm after its fleet-wide stop was reset elsewhere.
    pub(super) fn release_fleet_stop(&mut self) {
        if self.stop_latch.release(self.arm.last().is_some()) {
            self.stop_sequence.forget();
            let text = "the fleet-wide stop was cleared: the arm may move again".to_owned();
            self.notify(News::StopReset, text);
        }
    }

    /// Handles the end of the station: the laser goes off first, and nothing more is sent.
    pub fn handle_end(&mut self, now: Duration) {
        self.handle_time(now);
        self.stop_sequence.begin(&mut self.arm);
        self.jogging.release();
        self.drop_waiting("the station ended");
        self.interrupt_run("the station ended");
        self.end_detection("the station ended");
    }

    /// Handles the result of an [`Effect`]: it is on the disk, or why it is not. Then the job sends
    /// no more until it is resumed.
    pub fn handle_written(&mut self, now: Duration, effect: &Effect, outcome: Result<(), String>) {
        self.handle_time(now);
        match outcome {
            Ok(()) => self.written(effect),
            Err(why) => self.not_written(effect, &why),
        }
        self.feed();
    }

    fn written(&mut self, effect: &Effect) {
        if self.journal_requests.handle_written(effect) {
            let text = "the journal of jobs can be written again".to_owned();
            self.notify(News::Trouble, text);
        }
        if let Some(run) = &mut self.run {
            run.handle_written(effect);
        }
    }

    fn not_written(&mut self, effect: &Effect, why: &str) {
        let is_news = self
            .journal_requests
            .handle_not_written(self.arm.now(), effect, why);
        let why = format!("the journal of jobs cannot be written: {why}");
        if self.run.as_ref().is_some_and(Run::occupies_arm) {
            self.arm.send_laser_off();
            self.drop_waiting(&why);
            self.interrupt_run(&why);
        }
        if is_news {
            self.notify(News::Trouble, why);
        }
    }

    /// Handles the events of the session.
    pub(super) fn follow_session(&mut self) {
        while let Some(event) = self.arm.session_mut().poll_event() {
            self.outgoing.note_change();
            self.handle_event(event);
        }
    }

    fn handle_event(&mut self, event: Event) {
        match event {
            Event::Status(status) => self.handle_status(status),
            Event::Completed(id) => self.command_over(id, None),
            Event::NotReached { command, .. } => {
                self.command_over(command, Some(failure(event)));
            }
            Event::Pausing {
                command,
                lasts,
                by_default,
            } => self.notify_pause(command, lasts, by_default),
            Event::LinkLost {
                silent_for,
                received,
            } => self.fall_silent(silent_for, &received),
            Event::Reset { evidence, .. } => self.notice_reset(&evidence.to_string()),
            Event::NotSent { command, reason } => {
                self.command_forgotten(command, &Refusal::from(reason).to_string());
            }
            Event::LaserDisarmed(why) => self.laser_disarmed(&why.to_string()),
            Event::LaserOff => self.notify(News::LaserOff, SWITCHED_OFF.into()),
            _ => {}
        }
    }

    /// Disarms the laser: it goes off and stays off; a burning job is paused.
    pub(super) fn disarm_laser(&mut self, why: &str) {
        let (was_armed, forgotten) = self.arm.disarm_laser();
        for id in forgotten {
            self.command_forgotten(id, &Refusal::LaserDisarmed.to_string());
        }
        if was_armed {
            self.laser_disarmed(why);
        }
    }

    /// Handles a disarmed laser: it goes off, and a burning job is paused.
    fn laser_disarmed(&mut self, why: &str) {
        self.arm.send_laser_off();
        self.interrupt_burning(why);
        let text = if self.link.is_there() {
            format!("the laser is off and disarmed: {why}")
        } else {
            format!(
                "the laser is disarmed, but laser off was NOT DELIVERED: {why}; if it burns, switch the arm off"
            )
        };
        self.notify(News::LaserDisarmed, text);
    }

    fn command_over(&mut self, id: CommandId, failed: Option<String>) {
        self.run_command_over(id, failed.as_deref());
        if !self.commands.handle_over(id) {
            return;
        }
        let command = id.0;
        match failed {
            None => self.notify(
                News::CommandDone { command },
                format!("command {command} is done"),
            ),
            Some(why) => {
                self.arm.send_laser_off();
                self.notify(
                    News::CommandFailed { command },
                    format!("command {command}: {why}"),
                );
            }
        }
    }

    pub(super) fn command_forgotten(&mut self, id: CommandId, why: &str) {
        if let Some(run) = &mut self.run {
            run.handle_forgotten(id);
        }
        if self.commands.handle_over(id) {
            let command = id.0;
            self.notify(
                News::CommandFailed { command },
                format!("command {command} was not sent: {why}"),
            );
        }
    }

    /// Drops the commands that have not been sent; returns their ids.
    pub(super) fn drop_waiting(&mut self, why: &str) -> Vec<CommandId> {
        let forgotten = self.arm.session_mut().discard_waiting();
        for id in &forgotten {
            self.command_forgotten(*id, why);
        }
        forgotten
    }

    /// Returns the in-flight and waiting commands of clients and the job.
    fn in_flight(&self) -> Vec<CommandId> {
        let of_clients = self.commands.ids();
        let of_job = self.run.iter().flat_map(Run::in_flight);
        let mut ids: Vec<_> = of_clients.chain(of_job).collect();
        ids.sort_unstable();
        ids
    }

    /// Aborts a detection.
    pub(super) fn end_detection(&mut self, why: &str) {
        if let Some(client) = self.detecting.end() {
            let refusal = Refusal::NotFound(why.to_owned());
            self.outgoing.answer(client, Err(refusal));
        }
    }

    /// Reports a pause, because an arm that stands still without a notice looks dead.
    fn notify_pause(&mut self, command: CommandId, lasts: Duration, by_default: bool) {
        let (command, lasts_s) = (command.0, lasts.as_secs_f64());
        let whose = if by_default {
            "its default pause (state 9, mode 1)".to_owned()
        } else {
            format!("the pause of command {command}")
        };
        self.notify(
            News::Pausing { command, lasts_s },
            format!("the arm waits {lasts_s} s here: {whose}"),
        );
    }

    fn fall_silent(&mut self, silent_for: Duration, received: &NoStatus) {
        let error = LinkError::Silent {
            silent_for,
            received: received.clone(),
        };
        let end = self.link.handle_silence(error.to_string(), received);
        self.handle_link_end(end);
    }

    /// Handles the end of a link: unsent commands are dropped; the arm finishes those it has.
    fn handle_link_end(&mut self, end: LinkEnd) {
        if end != LinkEnd::None {
            self.arm.forget_rest();
            self.arm.send_laser_off();
            // A line that loses statuses may still carry packets.
            self.arm.release_urgently();
            self.jogging.revoke(Refusal::LetGo(LOST.into()));
            self.drop_waiting(LOST);
            let text = self.link.loss(end);
            self.interrupt_run(&text);
            self.end_detection(LOST);
        }
        let Some(cause) = self.link.take_new_cause() else {
            return;
        };
        let news = match end {
            LinkEnd::Lost => News::LinkLost,
            LinkEnd::NeverUp | LinkEnd::None => News::NoLink { cause },
        };
        self.notify(news, self.link.loss(end));
    }

    fn notice_reset(&mut self, evidence: &str) {
        self.jogging
            .revoke(Refusal::LetGo("the arm was reset".into()));
        self.arm.send_laser_off();
        // Nothing is sent again before a person has checked where the arm stands.
        self.interrupt_run("the arm was reset");
        // The session has also dropped its in-flight commands.
        for id in self.in_flight() {
            self.command_over(id, Some("the arm was reset".into()));
        }
        self.end_detection("the arm was reset");
        self.notify(
            News::Reset,
            format!("the arm was reset ({evidence}): its reported position may be wrong; confirm its pose, or set its angles again"),
        );
    }
}

/// Returns the text of a failure event.
fn failure(event: Event) -> String {
    event
        .or_failed()
        .err()
        .map_or_else(String::new, |error| error.to_string())
}

pub(super) const NOT_DELIVERED: &str =
    "the stop was NOT DELIVERED: there is no link to the arm; switch the arm off";
const SWITCHED_OFF: &str =
    "the laser was switched off: no further motion came in time, and it may not burn in one place";
const OPENED: &str = "its port was opened, which resets a stock arm: it then assumes a base angle of 0, wherever it points";
