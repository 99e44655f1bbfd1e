//! The session engine: what to send when, and what the statuses mean.

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
use crate::{Disarmed, Event, SendError};

/// A conversation with one arm, as an engine: it owns no port, no thread and no clock.
///
/// Things happen to it (`handle_*`), it wants things (`poll_*`), and [`Session::poll_wakeup`] says
/// when it next needs the time, which counts from the connect and never goes back. A clone is the same
/// conversation, as far as it has come.
///
/// Each status received is a permit to send one command (note N20): what is given to
/// [`Session::send`] waits here for its turn. The protocol has no stop: the arm will do what it has got.
/// So a command is sent only when it should begin within [`Session::with_ahead`] (0.5 s), and no later than
/// that after a stop the arm begins another motion. A vector that burns should even end within that time: otherwise it is
/// sent just in time, about 0.22 s before it begins. Other vectors may take 0.14 s longer.
///
/// A laser is lit only while it is armed ([`Session::arm_laser`]), and switched off where it would burn on
/// the spot ([`Session::set_laser_may_stand`]), as long as somebody tells the time.
///
/// A session moves an arm only when a person has confirmed that it stands where it says, and not any
/// more when it sees that the arm was reset (the base angle is 0 then wherever the base stands): see
/// [`Session::is_trusted`].
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
    /// When bytes came last.
    bytes_came: Duration,
    permit_scheme: PermitScheme,
    next_id: u64,
    /// A status came and no command has used it yet.
    permit: bool,
    /// When the status came whose permit was used last.
    used: Option<Duration>,
    /// When a packet left last.
    left: Option<Duration>,
    to_send: VecDeque<Packet>,
    completion: Completion,
    estimate: ArmEstimate,
    trust: ResetDetector,
    laser: Laser,
    meter: Meter,
    /// How long before a command begins it may be sent.
    ahead: Duration,
    status: Option<Status>,
    now: Duration,
    /// When the last status came; at first the connect.
    heard: Duration,
    /// When this computer went on after it had stood still; zero if it never did.
    stalled: Duration,
    lost: bool,
    /// No status came since the port was opened.
    opened: bool,
    resyncs: u64,
    skipped: u64,
    events: VecDeque<Event>,
}

/// Names a command of a session, from the first one sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CommandId(pub u64);

impl Session {
    /// A session with an arm that speaks `dialect`, if that is known.
    ///
    /// Nobody has confirmed its pose yet, and opening its port resets a stock arm (note N35): it is
    /// sent nothing that moves it until [`Session::confirm_pose`].
    #[must_use]
    pub fn new(dialect: Option<Dialect>) -> Self {
        Self::begin(dialect, false)
    }

    /// The same, with an arm that is known to stand where it says: a virtual one that was not touched.
    #[must_use]
    pub fn trusted(dialect: Option<Dialect>) -> Self {
        Self::begin(dialect, true)
    }

    /// The same, with another bound on how long before a command begins it is sent: so long after a stop
    /// the arm may begin another one. 0.5 s unless told otherwise; `Duration::MAX` fills the arm's queue.
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
            bytes_came: Duration::ZERO,
            permit_scheme: PermitScheme::default(),
            next_id: 0,
            permit: false,
            used: None,
            left: None,
            to_send: VecDeque::new(),
            completion: Completion::default(),
            status: None,
            heard: Duration::ZERO,
            stalled: Duration::ZERO,
            lost: false,
            opened: true,
            resyncs: 0,
            skipped: 0,
            events: VecDeque::new(),
        }
    }

    /// Takes a command; it is sent when the arm permits it, after those given before. The release of
    /// a button leaves as one of the kind of the button that was sent last ([`Session::release`]).
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] where its meaning depends on a dialect that nobody has told,
    /// [`SendError::Invalid`] where a value breaks its table, [`SendError::Untrusted`] where it moves
    /// an arm whose pose is not trusted, [`SendError::OnTheSpot`] where a stock arm would lose its
    /// pose, [`SendError::LaserDisarmed`] where it lights a laser that nobody has armed,
    /// [`SendError::Misheard`] for voice to a stock arm over Bluetooth. Nothing is sent then.
    ///
    /// Voice waits until the arm was seen at rest (note N50).
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

    /// Whether a command would be sent.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn check(&self, command: &Command) -> Result<(), SendError> {
        self.planned(command).map(|_| ())
    }

    /// Where a command leads, if it would be sent; nobody knows before the first status.
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
        match plan.as_ref().and_then(|it| it.trap()) {
            Some(trap) => Err(trap),
            None => Ok(plan),
        }
    }

    /// Sends a command at once and ahead of all others, permit or not and trusted or not: for a stop
    /// (the release of a jog) and for parting words on a link that is failing (laser off, pen up).
    /// Those that wait are forgotten.
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] and [`SendError::Invalid`], as [`Session::send`].
    pub fn send_now(&mut self, command: impl Into<Command>) -> Result<(), SendError> {
        let command = self.of_its_kind(command.into());
        let packet = self.emit_now(&command)?;
        self.forget_waiting();
        self.note_urgent(&command);
        self.left = Some(self.now);
        self.to_send.push_back(packet);
        Ok(())
    }

    /// Forgets the commands that have not been sent yet; says which they were.
    pub fn forget_waiting(&mut self) -> Vec<CommandId> {
        self.estimate.discard_waiting()
    }

    /// The packet of a command that the caller sends itself, at once and beside all others; the
    /// session takes note that it left with [`Session::note_urgent`].
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] and [`SendError::Invalid`], as [`Session::send`].
    pub fn emit_now(&self, command: &Command) -> Result<Packet, SendError> {
        self.packet(command)
    }

    /// Takes note of a command that left beside the session.
    pub fn note_urgent(&mut self, command: &Command) {
        self.trust.handle_sent(command);
        self.note_laser(command);
        self.estimate.handle_urgent(self.now, command);
    }

    /// Which dialect the arm speaks is known now, or known better.
    pub fn set_dialect(&mut self, dialect: Dialect) {
        self.dialect = Some(dialect);
        self.meter.set_period(dialect.status_period());
        self.estimate.set_dialect(dialect);
    }

    /// How the arm differs from the drawing of it, when it has just been switched on: its zeros are right once
    /// it was told its angles (state 9, mode 3), and wrong again after a reset.
    pub fn set_calibration(&mut self, calibration: Calibration) {
        self.estimate.set_calibration(calibration);
    }

    /// The port was opened again after a gap: bytes begin anew, the arm has as long for its first
    /// status as after a connect, no permit is left, and the laser is disarmed. What was under way
    /// stays believed until statuses tell otherwise.
    pub fn handle_open(&mut self, now: Duration) {
        self.now = now;
        self.heard = now;
        self.opened = true;
        self.decoder = Decoder::statuses(plausible);
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

    /// A person says that the arm stands where it tells: its pose is trusted from now on.
    pub fn confirm_pose(&mut self) {
        self.trust.confirm();
    }

    /// The pose that the arm tells is not trusted from now on, for a reason that the session does
    /// not see.
    pub fn distrust(&mut self, reason: &str) {
        self.trust.distrust(reason);
    }

    /// Takes bytes from the arm.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.now = now;
        if !bytes.is_empty() {
            // Whose sender was reset in the middle of a status may not be taken for a whole one.
            if now.saturating_sub(self.bytes_came) >= DEAF {
                self.decoder.give_up_waiting();
            }
            self.bytes_came = now;
        }
        // The frames borrow the decoder, so they are set aside: a read holds a few at the most.
        let frames: Vec<Frame> = self.decoder.feed(bytes).collect();
        let statuses: Vec<Status> = frames.iter().flat_map(Status::parse).collect();
        if let Some(behind_the_first) = statuses.len().checked_sub(1) {
            self.trust
                .handle_read(now, behind_the_first, self.meter.period());
        }
        for status in statuses {
            self.handle_status(now, status);
        }
        self.note_resync();
        self.watch_laser();
    }

    /// This computer stood still until now: what the arm sent meanwhile has not been read yet.
    pub fn handle_stall(&mut self, now: Duration) {
        self.stalled = now;
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        let due = self.dispatch_at();
        self.now = now;
        self.watch_laser();
        if due.is_some_and(|it| it <= now) {
            self.dispatch();
        }
        if now >= self.link_lost_at() {
            self.lost = true;
            self.events.push_back(Event::LinkLost {
                silent_for: now.saturating_sub(self.heard),
                noise: self.decoder.counts().skipped_bytes - self.skipped
                    + self.decoder.waiting() as u64,
            });
            self.lose_laser(Disarmed::LinkLost);
        }
    }

    /// The packet to send now, if there is one.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        self.to_send.pop_front()
    }

    /// Takes note that a packet left only now.
    #[cfg(feature = "io")]
    pub(crate) const fn note_left(&mut self, now: Duration) {
        self.left = Some(now);
    }

    /// The next thing that happened.
    pub fn poll_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    /// When [`Session::handle_time`] wants to be called next, at the latest.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        let wakeups = [self.laser_wakeup(), self.dispatch_at()];
        let first = wakeups.into_iter().flatten().min();
        self.link_lost_at().min(first.unwrap_or(Duration::MAX))
    }

    /// When the link is lost if no status comes.
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
        self.heard.max(self.stalled) + timeout
    }

    /// Whether the arm's queue may be full, of urgent packets too; then it is silent.
    fn may_be_full(&self) -> bool {
        self.estimate.in_flight().len() >= QUEUE_STALLS_AT
    }

    fn handle_status(&mut self, now: Duration, status: Status) {
        let heard = self.permit_scheme.classify(now, status);
        let had_room = self.is_bluetooth() || !self.may_be_full();
        self.heard = now;
        self.lost = false;
        self.opened = false;
        self.meter.handle_status(now, &heard, had_room);
        if heard.is_regular {
            self.note_status(now, &heard);
        }
        // Statuses that come in a heap, with less than half a period between them, were kept
        // somewhere on the way: only one of them is news.
        self.permit |= heard.permits
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

    /// Whether the status shows a reset; then everything that was told is forgotten.
    fn note_reset(&mut self, now: Duration, status: &Status) -> bool {
        let Some(evidence) = self.trust.handle_status(
            now,
            status,
            self.estimate.comes_to_zero(),
            self.estimate.is_at_rest(),
        ) else {
            return false;
        };
        let forgotten = self.estimate.handle_reset(status);
        self.completion = Completion::default();
        self.events.push_back(Event::Reset {
            evidence,
            forgotten,
        });
        self.lose_laser(Disarmed::Reset);
        self.laser.forget();
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
                    let missed = self.estimate.handle_missed(now).and_then(|it| it.id);
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
        self.events.extend(pausing.and_then(|it| {
            Some(Event::Pausing {
                command: it.id?,
                lasts: it.plan.pause,
                by_default: own_pause_s(&it.command) == 0.0,
            })
        }));
    }

    /// How long before it begins the next command may be sent.
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

    /// When the next command becomes due, if there is a permit for it and only its time keeps it back.
    fn dispatch_at(&self) -> Option<Duration> {
        let waits = self.permit && self.estimate.waiting() > 0;
        let early = self
            .estimate
            .in_flight()
            .ahead(self.now)
            .checked_sub(self.next_ahead());
        let early = early.filter(|it| waits && !it.is_zero())?;
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
        let waits = self.would_hide_a_reset()
            || self.waits_for_the_port(&next.command)
            || self.speaks_too_early(&next.command)
            || self.estimate.waits_for_place();
        if waits {
            return;
        }
        if self.parts_from_laser_first(&next.command) {
            self.switch_laser_off();
            return;
        }
        if let Some(reason) = next.trap() {
            for command in self.estimate.discard_from_first(|_| true) {
                self.events.push_back(Event::NotSent { command, reason });
            }
            return;
        }
        let Some(mut given) = self.estimate.pop_next() else {
            return;
        };
        given.command = self.of_its_kind(given.command);
        let command = given.command;
        self.permit = false;
        self.used = Some(self.heard);
        self.left = Some(self.now);
        let packet = self
            .packet(&command)
            .expect("it was emitted once already, when it was given");
        let at_rest = self.estimate.is_at_rest();
        self.meter.handle_sent(self.heard, at_rest, moves(&command));
        self.trust.handle_sent(&command);
        self.note_laser(&command);
        self.events.push_back(Event::Sent(given.id));
        self.estimate.handle_sent(self.now, given);
        self.to_send.push_back(packet);
    }

    /// Whether the arm would be silent for so long with the next command in its queue, and its base at
    /// 0 behind that, that nobody could tell it from a reset.
    fn would_hide_a_reset(&self) -> bool {
        // A status period, and as much for what is late.
        let not_yet_deaf = 2 * self.meter.period();
        let silent = self
            .estimate
            .in_flight()
            .drains_within(QUEUE_STALLS_AT - 1, self.now);
        self.may_be_full()
            && silent + not_yet_deaf >= DEAF
            && (self.estimate.comes_to_zero() || self.estimate.would_come_to_zero())
    }

    /// Whether the next command has to wait because of the port that the arm serves: a joint jog until
    /// that is known, since its axes depend on it; over Bluetooth all while the queue may be full, since
    /// messages tell nothing of its room (note N38).
    fn waits_for_the_port(&self, command: &Command) -> bool {
        if !self.is_bluetooth() {
            let exchanged = |jog: &JointJog| jog.over_bluetooth() != *jog;
            return !self.permit_scheme.is_known()
                && matches!(command, Command::JointJog(jog) if exchanged(jog));
        }
        self.may_be_full()
    }

    /// Whether the next command is voice, and the arm was not seen at rest: an arm that moves would go
    /// on for ever with the pulses of the last tick, or lose its place (note N50).
    fn speaks_too_early(&self, command: &Command) -> bool {
        matches!(command, Command::Voice(_)) && !self.estimate.was_seen_at_rest()
    }

    /// A release as the one of the button that was sent last, whichever kind it was given as.
    fn of_its_kind(&self, command: Command) -> Command {
        match (Button::of(&command), self.release()) {
            (Some(Button::Released), Some(release)) => release,
            _ => command,
        }
    }

    /// The command that the port of this arm takes for this one, and the other way round.
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

/// The pause that a command tells itself, in seconds.
const fn own_pause_s(command: &Command) -> f32 {
    match command {
        Command::MoveTo(it) => it.pause_s,
        Command::MoveJoints(it) => it.pause_s,
        _ => 0.0,
    }
}

/// A dozen statuses missing are no accident.
const LINK_TIMEOUT: Duration = Duration::from_secs(1);
/// What a packet takes on the line, and the 8 ms that a stock arm wants before the next: it loses one
/// that follows without a gap (note N26). The next status permits it again.
const SPACING: Duration = Duration::from_millis(52);
/// A stock arm is reset by the opening of its port, and is deaf for up to two seconds then.
const FIRST_STATUS: Duration = Duration::from_secs(5);
/// More than twice the time that passes between the end of a command and the next one's arrival: a
/// status, and a packet each way. So an arm never waits for the link, whatever the bound is.
const AHEAD: Duration = Duration::from_millis(500);
/// So long before it begins a vector is sent in time on a usual link: its way takes 55 ms, and the computer may be late.
const IN_TIME: Duration = Duration::from_millis(220);
/// From the end of what burns until the laser is off: a packet, a tick, and an error of the prediction.
const LASER_OFF_TAKES: Duration = Duration::from_millis(100);
/// What an arm without a laser has received may take so much longer.
const UNLIT_LONGER: Duration = Duration::from_millis(100);
/// A status that is later than that has been withheld.
const LATE: Duration = Duration::from_millis(60);
/// With that many commands under way the queue may be full, and a full queue is silent (note N20).
const QUEUE_STALLS_AT: usize = 4;
