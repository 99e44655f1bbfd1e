//! The session engine: decides when to send what, and interprets the statuses.

mod laser;
mod queries;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Calibration;
use dobot_motion::Button;
use dobot_wire::{Command, Decoder, Dialect, Frame, JointJog, Packet, Status, Statuses};

use self::laser::Laser;
use crate::arm_estimate::ArmEstimate;
use crate::completion::{Completion, Verdict};
use crate::permit_scheme::{PermitScheme, ReceivedStatus, plausible};
use crate::plan::{Plan, position};
use crate::quality::Meter;
use crate::reset_detector::{DEAF, ResetDetector};
use crate::send_error::moves;
use crate::{Disarmed, Event, SendError, StatusWait};

/// The connection to one arm, as an engine: it owns no port, no thread and no clock.
///
/// It receives events through `handle_*` and returns outputs through `poll_*`. [`Session::poll_wakeup`]
/// returns when it next needs the time, which counts from the connect and never decreases. A clone
/// continues from the same state.
///
/// Each status is a permit to send one command (note N20); commands given to [`Session::send`] wait
/// for it. The protocol has no stop: the arm executes what it has received. So a command is sent only
/// when it should start within [`Session::with_ahead`] (0.5 s); that bounds when the arm still starts a motion
/// after a stop. A vector that burns should also end within that time; a longer one is sent about 0.22 s
/// before it starts. Other vectors may take 0.14 s longer.
///
/// The laser burns only while it is armed ([`Session::arm_laser`]). It is switched off where it would
/// burn without moving ([`Session::set_laser_may_stand`]), provided that the time is kept up to date.
///
/// A session moves the arm only after a person has confirmed its pose, and until it detects a reset
/// (after which the base angle is 0 wherever the base stands): see [`Session::is_trusted`].
///
/// ```
/// use std::time::Duration;
/// use dobot_session::{Event, Session};
/// use dobot_wire::{Dialect, JointJog, JointJogAxis};
///
/// let mut session = Session::new(Some(Dialect::SPECIFICATION));
/// session.send(JointJog::new(JointJogAxis::LaserOff, 0.0))?;
/// assert_eq!(session.poll_bytes(), None); // no status yet, so no permit
/// session.handle_time(Duration::from_secs(10));
/// assert!(matches!(session.poll_event(), Some(Event::LinkLost { .. })));
/// # Ok::<(), dobot_session::SendError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Session {
    dialect: Option<Dialect>,
    decoder: Decoder<Statuses>,
    /// When the last bytes arrived.
    bytes_arrived: Duration,
    permit_scheme: PermitScheme,
    next_id: u64,
    /// A status arrived that no command has used yet.
    permit: bool,
    /// When the status of the last used permit arrived.
    used: Option<Duration>,
    /// When the last packet was sent.
    left: Option<Duration>,
    to_send: VecDeque<Packet>,
    completion: Completion,
    estimate: ArmEstimate,
    trust: ResetDetector,
    laser: Laser,
    meter: Meter,
    /// How long before its start a command may be sent.
    ahead: Duration,
    status: Option<Status>,
    now: Duration,
    /// When the last status arrived; initially the time of the connect.
    status_arrived: Duration,
    /// When this computer resumed after a suspension; zero if it never was suspended.
    stalled: Duration,
    lost: bool,
    /// No status has arrived since the port was opened.
    opened: bool,
    resyncs: u64,
    skipped: u64,
    /// What has arrived since the last status.
    status_wait: StatusWait,
    events: VecDeque<Event>,
}

/// Identifies a command of a session, counted from the first one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CommandId(pub u64);

impl Session {
    /// Creates a session with an arm that speaks `dialect`, if known.
    ///
    /// Opening the port resets a stock arm (note N35), so its pose is not confirmed: no motion is
    /// sent until [`Session::confirm_pose`].
    #[must_use]
    pub fn new(dialect: Option<Dialect>) -> Self {
        Self::begin(dialect, false)
    }

    /// Creates a session with an arm whose pose is known, such as a new virtual arm.
    #[must_use]
    pub fn trusted(dialect: Option<Dialect>) -> Self {
        Self::begin(dialect, true)
    }

    /// Sets how long before its start a command may be sent (default 0.5 s). The arm may start another
    /// motion until this time after a stop. `Duration::MAX` fills the arm's queue.
    #[must_use]
    pub fn with_ahead(mut self, ahead: Duration) -> Self {
        self.set_ahead(ahead);
        self
    }

    fn begin(dialect: Option<Dialect>, trusted: bool) -> Self {
        Self {
            estimate: ArmEstimate::new(dialect.as_ref()),
            trust: ResetDetector::new(trusted),
            laser: Laser::default(),
            meter: Meter::new(dialect.unwrap_or(Dialect::SPECIFICATION).status_period()),
            ahead: AHEAD,
            now: Duration::ZERO,
            dialect,
            decoder: Decoder::statuses(plausible),
            bytes_arrived: Duration::ZERO,
            permit_scheme: PermitScheme::default(),
            next_id: 0,
            permit: false,
            used: None,
            left: None,
            to_send: VecDeque::new(),
            completion: Completion::default(),
            status: None,
            status_arrived: Duration::ZERO,
            stalled: Duration::ZERO,
            lost: false,
            opened: true,
            resyncs: 0,
            skipped: 0,
            status_wait: StatusWait::default(),
            events: VecDeque::new(),
        }
    }

    /// Queues a command. It is sent when the arm permits it, after all earlier ones. The release of a
    /// button is sent as the kind of the last pressed button ([`Session::release`]).
    ///
    /// # Errors
    ///
    /// Nothing is sent in these cases: [`SendError::Undecided`] if the meaning depends on the dialect, which is
    /// unknown; [`SendError::Invalid`] if a value is outside its table; [`SendError::Untrusted`] for a
    /// motion of an arm whose pose is not trusted; [`SendError::OnTheSpot`] if a stock arm would lose its
    /// pose; [`SendError::LaserDisarmed`] for burning while the laser is not armed;
    /// [`SendError::Misheard`] for voice to a stock arm over Bluetooth.
    ///
    /// Voice waits until the arm is seen at rest (note N50).
    pub fn send(&mut self, command: impl Into<Command>) -> Result<CommandId, SendError> {
        let command = command.into();
        let plan = self.planned(&command)?;
        let id = CommandId(self.next_id);
        self.next_id += 1;
        self.trust.handle_given(&command);
        self.estimate.push(id, command, plan);
        self.dispatch();
        Ok(id)
    }

    /// Checks whether a command would be sent.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn check(&self, command: &Command) -> Result<(), SendError> {
        self.planned(command).map(|_| ())
    }

    /// Checks and predicts a command; the prediction is `None` before the first status.
    fn planned(&self, command: &Command) -> Result<Option<Box<Plan>>, SendError> {
        self.check_laser(command)?;
        if !self.is_trusted() && moves(command) {
            return Err(SendError::Untrusted);
        }
        if matches!(command, Command::Voice(_)) && self.is_bluetooth() {
            return Err(SendError::Misheard);
        }
        self.packet(command)?;
        let plan = self.estimate.plan(command);
        match plan.as_ref().and_then(|plan| plan.trap()) {
            Some(trap) => Err(trap),
            None => Ok(plan),
        }
    }

    /// Sends a command immediately, ahead of all others and regardless of permit and trust. It is for stops
    /// (the release of a jog) and for the last commands on a failing link (laser off, pen up). The waiting
    /// commands are discarded.
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] and [`SendError::Invalid`], as [`Session::send`].
    pub fn send_now(&mut self, command: impl Into<Command>) -> Result<(), SendError> {
        let command = self.matching_release(command.into());
        let packet = self.emit_now(&command)?;
        self.discard_waiting();
        self.note_urgent(&command);
        self.left = Some(self.now);
        self.to_send.push_back(packet);
        Ok(())
    }

    /// Discards the commands that have not been sent and returns their ids.
    pub fn discard_waiting(&mut self) -> Vec<CommandId> {
        self.estimate.discard_waiting()
    }

    /// Encodes a command that the caller sends itself, ahead of all others, and then reports with
    /// [`Session::note_urgent`].
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] and [`SendError::Invalid`], as [`Session::send`].
    pub fn emit_now(&self, command: &Command) -> Result<Packet, SendError> {
        self.packet(command)
    }

    /// Records a command that the caller sent itself.
    pub fn note_urgent(&mut self, command: &Command) {
        self.trust.handle_sent(command);
        self.note_laser(command);
        self.estimate.handle_urgent(self.now, command);
    }

    /// Sets the dialect of the arm, when it becomes known or is corrected.
    pub fn set_dialect(&mut self, dialect: Dialect) {
        self.dialect = Some(dialect);
        self.meter.set_period(dialect.status_period());
        self.estimate.set_dialect(dialect);
    }

    /// Sets how the arm, after power-up, differs from its nominal dimensions. Its zeros become right when
    /// its initial angles are set (state 9, mode 3), and wrong again after a reset.
    pub fn set_calibration(&mut self, calibration: Calibration) {
        self.estimate.set_calibration(calibration);
    }

    /// Handles that the port was opened again: the decoder starts again, the arm has as long for its first
    /// status as after a connect, the permit is void, and the laser is disarmed. In-flight commands
    /// stay in flight until statuses show otherwise.
    pub fn handle_open(&mut self, now: Duration) {
        self.now = now;
        self.status_arrived = now;
        self.opened = true;
        self.decoder = Decoder::statuses(plausible);
        self.status_wait = StatusWait::default();
        self.permit_scheme = PermitScheme::default();
        self.trust.handle_open();
        (self.resyncs, self.skipped) = (0, 0);
        self.to_send.clear();
        self.permit = false;
        self.lost = false;
        self.lose_laser(Disarmed::LinkLost);
    }

    /// Sets the bound of [`Session::with_ahead`].
    pub fn set_ahead(&mut self, ahead: Duration) {
        self.ahead = ahead;
        self.dispatch();
    }

    /// A person confirms the pose that the arm reports: it is trusted from now on.
    pub fn confirm_pose(&mut self) {
        self.trust.confirm();
    }

    /// Ends the trust in the reported pose, for a reason that the session cannot detect itself.
    pub fn distrust(&mut self, reason: &str) {
        self.trust.distrust(reason);
    }

    /// Handles bytes from the arm.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.now = now;
        if !bytes.is_empty() {
            // The arm may have been reset in the middle of a status: do not complete it with new bytes.
            if now.saturating_sub(self.bytes_arrived) >= DEAF {
                self.decoder.give_up_waiting();
            }
            self.bytes_arrived = now;
        }
        // The frames borrow the decoder, so they are collected: a read holds a few at most.
        let frames: Vec<Frame> = self.decoder.feed(bytes).collect();
        let statuses: Vec<Status> = frames.iter().flat_map(Status::parse).collect();
        if statuses.is_empty() {
            self.status_wait.handle_bytes(bytes);
        }
        if let Some(more) = statuses.len().checked_sub(1) {
            self.status_wait = StatusWait::default();
            self.trust.handle_read(now, more, self.meter.period());
        }
        for status in statuses {
            self.handle_status(now, status);
        }
        self.note_resync();
        self.watch_laser();
    }

    /// Handles that this computer was suspended until now: the statuses sent in the meantime are still unread.
    pub fn handle_stall(&mut self, now: Duration) {
        self.stalled = now;
    }

    /// Advances to `now`.
    pub fn handle_time(&mut self, now: Duration) {
        let due = self.dispatch_at();
        self.now = now;
        self.watch_laser();
        if due.is_some_and(|due| due <= now) {
            self.dispatch();
        }
        if now >= self.link_lost_at() {
            self.lost = true;
            self.events.push_back(Event::LinkLost {
                silent_for: now.saturating_sub(self.status_arrived),
                received: self.status_wait.no_status(),
            });
            self.lose_laser(Disarmed::LinkLost);
        }
    }

    /// Returns the next packet to send.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        self.to_send.pop_front()
    }

    /// Records that a packet was sent only now.
    #[cfg(feature = "io")]
    pub(crate) const fn note_left(&mut self, now: Duration) {
        self.left = Some(now);
    }

    /// Returns the next event.
    pub fn poll_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    /// Returns the latest time for the next call of [`Session::handle_time`].
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        let wakeups = [self.laser_wakeup(), self.dispatch_at()];
        let first = wakeups.into_iter().flatten().min();
        self.link_lost_at().min(first.unwrap_or(Duration::MAX))
    }

    /// When the link counts as lost if no status arrives.
    fn link_lost_at(&self) -> Duration {
        if self.lost {
            return Duration::MAX;
        }
        let timeout = match self.status {
            _ if self.opened => FIRST_STATUS,
            Some(_) if self.may_be_full() && !self.is_bluetooth() => {
                LINK_TIMEOUT.saturating_add(self.estimate.in_flight().longest_silence())
            }
            Some(_) | None => LINK_TIMEOUT,
        };
        self.status_arrived.max(self.stalled) + timeout
    }

    /// Whether the arm's queue may be full (urgent packets count too), which makes it silent.
    fn may_be_full(&self) -> bool {
        self.estimate.in_flight().len() >= QUEUE_STALLS_AT
    }

    fn handle_status(&mut self, now: Duration, status: Status) {
        let received = self.permit_scheme.classify(now, status);
        let had_room = self.is_bluetooth() || !self.may_be_full();
        self.status_arrived = now;
        self.lost = false;
        self.opened = false;
        self.meter.handle_status(now, &received, had_room);
        if received.is_regular {
            self.note_status(now, &received);
        }
        // Statuses less than half a period apart were delayed on the way: together they are one permit.
        self.permit |= received.permits
            && self
                .used
                .is_none_or(|used| now.saturating_sub(used) >= self.meter.period() / 2)
            && self.has_line();
        self.watch_laser();
        self.dispatch();
    }

    fn note_status(&mut self, now: Duration, ReceivedStatus { status, .. }: &ReceivedStatus) {
        self.see_laser(status);
        self.status = Some(*status);
        self.events.push_back(Event::Status(*status));
        if !self.note_reset(now, status) {
            self.note_completion(now, status);
        }
        self.estimate.handle_status(now, status);
        if self.is_bluetooth() {
            self.estimate.note_bluetooth();
        }
    }

    /// Detects a reset; it discards all commands and settings.
    fn note_reset(&mut self, now: Duration, status: &Status) -> bool {
        let Some(evidence) = self.trust.handle_status(
            now,
            status,
            self.estimate.comes_to_zero(),
            self.estimate.is_at_rest(),
        ) else {
            return false;
        };
        let lost = self.estimate.handle_reset(status);
        self.completion = Completion::default();
        self.events.push_back(Event::Reset {
            evidence,
            forgotten: lost,
        });
        self.lose_laser(Disarmed::Reset);
        self.laser.handle_reset();
        true
    }

    fn note_completion(&mut self, now: Duration, status: &Status) {
        self.completion.handle_status(now, status);
        let answer = self.meter.answer();
        while let Some(verdict) = self.completion.poll(now, answer, self.estimate.in_flight()) {
            match verdict {
                Verdict::Over(count) => {
                    let over = (0..count).filter_map(|_| self.estimate.handle_over(now)?.id);
                    self.events.extend(over.map(Event::Completed));
                }
                Verdict::Pauses => self.note_pause(),
                Verdict::Missed(reason, expected) => {
                    let missed = self.estimate.handle_missed(now).and_then(|sent| sent.id);
                    self.events.extend(missed.map(|command| Event::NotReached {
                        command,
                        reason,
                        expected,
                        found: position(status),
                    }));
                }
            }
        }
    }

    fn note_pause(&mut self) {
        let pausing = self.estimate.in_flight().first();
        self.events.extend(pausing.and_then(|sent| {
            Some(Event::Pausing {
                command: sent.id?,
                lasts: sent.plan.pause,
                by_default: own_pause_s(&sent.command) == 0.0,
            })
        }));
    }

    /// How long before its start the next command may be sent.
    fn next_ahead(&self) -> Duration {
        let Some((burns, motion)) = self.estimate.next_vector() else {
            return self.ahead;
        };
        let ends_within = if burns {
            self.ahead.saturating_sub(LASER_OFF_TAKES)
        } else {
            self.ahead.saturating_add(UNLIT_LONGER)
        };
        let in_time = IN_TIME + self.extra_latency();
        self.ahead
            .min(ends_within.saturating_sub(motion).max(in_time))
    }

    /// When the next command becomes due, if it has a permit and waits only for its time.
    fn dispatch_at(&self) -> Option<Duration> {
        let waits = self.permit && self.estimate.waiting() > 0;
        let early = self
            .estimate
            .in_flight()
            .ahead(self.now)
            .checked_sub(self.next_ahead());
        let early = early.filter(|early| waits && !early.is_zero())?;
        self.now.checked_add(early)
    }

    fn dispatch(&mut self) {
        let begins_in = self.estimate.in_flight().ahead(self.now);
        let follows = |left| self.now.saturating_sub(left) < SPACING;
        if !self.permit || begins_in > self.next_ahead() || self.left.is_some_and(follows) {
            return;
        }
        let Some(next) = self.estimate.next() else {
            return;
        };
        let waits = self.would_look_like_reset()
            || self.waits_for_port(&next.command)
            || self.speaks_too_early(&next.command)
            || self.estimate.waits_for_place();
        if waits {
            return;
        }
        if self.needs_laser_off_first(&next.command) {
            self.switch_laser_off();
            return;
        }
        if let Some(reason) = next.trap() {
            for command in self.estimate.discard_from_first(|_| true) {
                self.events.push_back(Event::NotSent { command, reason });
            }
            return;
        }
        let Some(mut next) = self.estimate.pop_next() else {
            return;
        };
        next.command = self.matching_release(next.command);
        let command = next.command;
        self.permit = false;
        self.used = Some(self.status_arrived);
        self.left = Some(self.now);
        let packet = self
            .packet(&command)
            .expect("it was encoded before, when it was queued");
        let at_rest = self.estimate.is_at_rest();
        self.meter
            .handle_sent(self.status_arrived, at_rest, moves(&command));
        self.trust.handle_sent(&command);
        self.note_laser(&command);
        self.events.push_back(Event::Sent(next.id));
        self.estimate.handle_sent(self.now, next);
        self.to_send.push_back(packet);
    }

    /// Whether the next command would make the arm look as if it had been reset: silent for long with a full
    /// queue, and then with its base at 0.
    fn would_look_like_reset(&self) -> bool {
        // A status period and the same again for delays.
        let not_yet_deaf = 2 * self.meter.period();
        let silent = self
            .estimate
            .in_flight()
            .drains_within(QUEUE_STALLS_AT - 1, self.now);
        self.may_be_full()
            && silent + not_yet_deaf >= DEAF
            && (self.estimate.comes_to_zero() || self.estimate.would_come_to_zero())
    }

    /// Whether the next command has to wait because of the port. A joint jog waits until the port is
    /// known, because its axes depend on it. Over Bluetooth all commands wait while the queue may be full,
    /// because messages do not show whether it has room (note N38).
    fn waits_for_port(&self, command: &Command) -> bool {
        if !self.is_bluetooth() {
            let exchanged = |jog: &JointJog| jog.over_bluetooth() != *jog;
            return !self.permit_scheme.is_known()
                && matches!(command, Command::JointJog(jog) if exchanged(jog));
        }
        self.may_be_full()
    }

    /// Whether the next command is voice and the arm was not seen at rest. A moving arm would repeat the
    /// pulses of the last tick forever, or lose its place (note N50).
    fn speaks_too_early(&self, command: &Command) -> bool {
        matches!(command, Command::Voice(_)) && !self.estimate.was_seen_at_rest()
    }

    /// Replaces a release by that of the last pressed button, whichever kind it was given as.
    fn matching_release(&self, command: Command) -> Command {
        match (Button::of(&command), self.release()) {
            (Some(Button::Released), Some(release)) => release,
            _ => command,
        }
    }

    /// Translates a command between its meaning and what the port of this arm expects, in either direction.
    fn on_this_port(&self, command: Command) -> Command {
        match command {
            Command::JointJog(jog) if self.is_bluetooth() => jog.over_bluetooth().into(),
            _ => command,
        }
    }

    fn packet(&self, command: &Command) -> Result<Packet, SendError> {
        let dialect = match (&self.dialect, command.dialect_dependent()) {
            (Some(dialect), _) => dialect,
            (None, None) => &Dialect::SPECIFICATION,
            (None, Some(field)) => return Err(SendError::Undecided { field }),
        };
        let packet = self.on_this_port(*command).emit(dialect);
        match Command::parse(&packet, dialect) {
            Ok(_) => Ok(packet),
            Err(error) => Err(SendError::Invalid(error)),
        }
    }

    fn note_resync(&mut self) {
        let counts = self.decoder.counts();
        if counts.resyncs > self.resyncs {
            self.events.push_back(Event::Resynced {
                skipped: counts.skipped_bytes - self.skipped,
            });
            self.resyncs = counts.resyncs;
            self.skipped = counts.skipped_bytes;
        }
    }
}

/// The pause that a command itself contains, in seconds.
const fn own_pause_s(command: &Command) -> f32 {
    match command {
        Command::MoveTo(target) => target.pause_s,
        Command::MoveJoints(target) => target.pause_s,
        _ => 0.0,
    }
}

/// Twelve status periods: more than losses explain.
const LINK_TIMEOUT: Duration = Duration::from_secs(1);
/// The time of a packet on the line and the 8 ms gap that a stock arm needs: it loses a packet that follows
/// without it (note N26). The next status permits the command again.
const SPACING: Duration = Duration::from_millis(52);
/// Opening its port resets a stock arm, which then ignores input for up to two seconds.
const FIRST_STATUS: Duration = Duration::from_secs(5);
/// More than twice the time from the end of a command to the arrival of the next one: a status and a packet
/// each way. So the arm never waits for the link.
const AHEAD: Duration = Duration::from_millis(500);
/// How long before its start a vector is sent on a usual link: 55 ms of transmission and what the computer may be late.
const IN_TIME: Duration = Duration::from_millis(220);
/// Time from the end of burning until the laser is off: a packet, a tick and the error of the prediction.
const LASER_OFF_TAKES: Duration = Duration::from_millis(100);
/// How much longer than the limit a vector may take if it does not burn.
const UNLIT_LONGER: Duration = Duration::from_millis(100);
/// A status that is later than this was withheld.
const LATE: Duration = Duration::from_millis(60);
/// With this number of in-flight commands the queue may be full; the arm is then silent (note N20).
const QUEUE_STALLS_AT: usize = 4;
