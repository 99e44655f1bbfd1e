//! The session engine: what to send when, and what the statuses mean.

mod look;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_course::{Button, CourseError};
use dobot_wire::{Command, Decoder, Dialect, Frame, JointJog, Packet, Status, Statuses};

use crate::belief::Belief;
use crate::completion::{Completion, straight_target};
use crate::quality::Meter;
use crate::scheme::{Heard, Scheme, plausible};
use crate::send_error::moves;
use crate::trust::{DEAF, Trust};
use crate::{Event, SendError};

/// A conversation with one arm, as an engine: it owns no port, no thread and no clock.
///
/// Things happen to it (`handle_*`), it wants things (`poll_*`), and [`Session::poll_wakeup`] says
/// when it next needs the time, which counts from the connect and never goes back. A clone is the same
/// conversation, as far as it has come.
///
/// Each status received is a permit to send one command (note N20): what is given to
/// [`Session::send`] waits here for its turn. The protocol has no stop, so what the arm has got it
/// will do: a command is sent only while those that wait in the arm, behind the one that it
/// executes, take less than [`Session::with_ahead`] (0.5 s).
///
/// A session moves an arm only when a person has confirmed that it stands where it says, and not any
/// more when it sees that the arm was reset (the base angle is 0 then wherever the base stands): see
/// [`Session::is_trusted`].
///
/// ```
/// use std::time::Duration;
/// use dobot_client::{Event, Session};
/// use dobot_wire::{Dialect, JointJog, JointJogAxis};
///
/// let mut session = Session::new(Some(Dialect::SPECIFICATION));
/// session.send(JointJog { axis: JointJogAxis::LaserOff, speed_percent: 0.0 })?;
/// assert_eq!(session.poll_bytes(), None); // no status yet, so no permit
/// session.handle_time(Duration::from_secs(10));
/// assert!(matches!(session.poll_event(), Some(Event::LinkLost { .. })));
/// # Ok::<(), dobot_client::SendError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Session {
    dialect: Option<Dialect>,
    decoder: Decoder<Statuses>,
    scheme: Scheme,
    waiting: VecDeque<(CommandId, Command)>,
    next_id: u64,
    /// A status came and no command has used it yet.
    permit: bool,
    /// When the status came whose permit was used last.
    used: Option<Duration>,
    to_send: VecDeque<Packet>,
    completion: Completion,
    belief: Belief,
    trust: Trust,
    meter: Meter,
    /// How much may wait in the arm behind the command that it executes.
    ahead: Duration,
    status: Option<Status>,
    now: Duration,
    /// When the last status came; at first the connect.
    heard: Duration,
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

    /// The same, with another bound on what waits in the arm behind the command that it executes:
    /// how much longer a stop takes than that command. 0.5 s unless told otherwise;
    /// `Duration::MAX` fills the arm's queue.
    #[must_use]
    pub fn with_ahead(mut self, ahead: Duration) -> Self {
        self.set_ahead(ahead);
        self
    }

    fn begin(dialect: Option<Dialect>, trusted: bool) -> Self {
        Self {
            belief: Belief::new(dialect.as_ref()),
            trust: Trust::new(trusted),
            meter: Meter::default(),
            ahead: AHEAD,
            now: Duration::ZERO,
            dialect,
            decoder: Decoder::statuses(plausible),
            scheme: Scheme::default(),
            waiting: VecDeque::new(),
            next_id: 0,
            permit: false,
            used: None,
            to_send: VecDeque::new(),
            completion: Completion::default(),
            status: None,
            heard: Duration::ZERO,
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
    /// pose. Nothing is sent then.
    pub fn send(&mut self, command: impl Into<Command>) -> Result<CommandId, SendError> {
        let command = command.into();
        self.check(&command)?;
        let id = CommandId(self.next_id);
        self.next_id += 1;
        self.waiting.push_back((id, command));
        self.trust.handle_given(&command);
        self.belief.handle_given(&command);
        self.dispatch();
        Ok(id)
    }

    /// Whether a command would be sent.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn check(&self, command: &Command) -> Result<(), SendError> {
        if !self.is_trusted() && moves(command) {
            return Err(SendError::Untrusted);
        }
        if self.is_on_the_spot(command) {
            return Err(SendError::OnTheSpot);
        }
        self.packet(command).map(|_| ())
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
        self.to_send.push_back(packet);
        Ok(())
    }

    /// Forgets the commands that have not been sent yet; says which they were.
    pub fn forget_waiting(&mut self) -> Vec<CommandId> {
        let forgotten = self.waiting.drain(..).map(|(id, _)| id).collect();
        self.belief.plan_anew([].iter());
        forgotten
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
        self.belief
            .handle_sent(self.now, None, command, Duration::ZERO);
        let waiting = self.waiting.iter().map(|(_, command)| command);
        self.belief.plan_anew(waiting);
    }

    /// Which dialect the arm speaks is known now, or known better.
    pub fn set_dialect(&mut self, dialect: Dialect) {
        self.dialect = Some(dialect);
        let waiting = self.waiting.iter().map(|(_, command)| command);
        self.belief.set_dialect(dialect, waiting);
    }

    /// The port was opened again after a gap: bytes begin anew, the arm has as long for its first
    /// status as after a connect, and no permit is left. What was under way stays believed until
    /// statuses tell otherwise.
    pub fn handle_open(&mut self, now: Duration) {
        self.now = now;
        self.heard = now;
        self.opened = true;
        self.decoder = Decoder::statuses(plausible);
        self.scheme = Scheme::default();
        self.trust.handle_open();
        (self.resyncs, self.skipped) = (0, 0);
        self.to_send.clear();
        self.permit = false;
        self.lost = false;
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
        // The frames borrow the decoder, so they are set aside: a read holds a few at the most.
        let frames: Vec<Frame> = self.decoder.feed(bytes).collect();
        for frame in frames {
            if let Ok(status) = Status::parse(&frame) {
                self.handle_status(now, status);
            }
        }
        self.note_resync();
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        self.now = now;
        if !self.lost && now >= self.poll_wakeup() {
            self.lost = true;
            self.events.push_back(Event::LinkLost {
                silent_for: now.saturating_sub(self.heard),
                noise: self.decoder.counts().skipped_bytes - self.skipped
                    + self.decoder.waiting() as u64,
            });
        }
    }

    /// The packet to send now, if there is one.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        self.to_send.pop_front()
    }

    /// The next thing that happened.
    pub fn poll_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    /// When [`Session::handle_time`] wants to be called next, at the latest.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        if self.lost {
            return Duration::MAX;
        }
        let patience = match self.status {
            _ if self.opened => FIRST_STATUS,
            Some(_) if self.may_be_full() && !self.is_bluetooth() => {
                LINK_TIMEOUT + self.completion.longest_silence()
            }
            Some(_) | None => LINK_TIMEOUT,
        };
        self.heard + patience
    }

    /// Whether the arm's queue may be full, of urgent packets too; then it is silent.
    fn may_be_full(&self) -> bool {
        self.completion.len().max(self.belief.under_way()) >= QUEUE_STALLS_AT
    }

    fn handle_status(&mut self, now: Duration, status: Status) {
        let heard = self.scheme.take(now, status);
        let had_room = self.is_bluetooth() || !self.may_be_full();
        self.heard = now;
        self.lost = false;
        self.opened = false;
        self.meter.handle_status(now, &heard, had_room);
        if heard.tells {
            self.tell(now, &heard);
        }
        // Statuses that come in a heap were kept somewhere on the way: only one of them is news.
        self.permit |= heard.permits
            && self
                .used
                .is_none_or(|used| now.saturating_sub(used) >= SHORTEST_PERIOD);
        self.dispatch();
    }

    fn tell(&mut self, now: Duration, Heard { status, .. }: &Heard) {
        self.status = Some(*status);
        self.events.push_back(Event::Status(*status));
        if !self.note_reset(now, status) {
            self.note_completion(now, status);
        }
        let waiting = self.waiting.iter().map(|(_, command)| command);
        self.belief.handle_status(now, status, waiting);
    }

    /// Whether the status shows a reset; then everything that was told is forgotten.
    fn note_reset(&mut self, now: Duration, status: &Status) -> bool {
        let Some(evidence) = self
            .trust
            .handle_status(now, status, self.belief.comes_to_zero(None))
        else {
            return false;
        };
        let forgotten = self.waiting.len() + self.completion.len();
        self.waiting.clear();
        self.completion = Completion::default();
        self.belief.handle_reset(status);
        self.events.push_back(Event::Reset {
            evidence,
            forgotten,
        });
        true
    }

    fn note_completion(&mut self, now: Duration, status: &Status) {
        let (events, belief) = (&mut self.events, &mut self.belief);
        self.completion.handle_status(now, status, |event| {
            match event {
                Event::Completed(id) => belief.handle_over(now, id),
                Event::NotReached { command, .. } => belief.handle_not_reached(now, command),
                _ => {}
            }
            events.push_back(event);
        });
    }

    fn dispatch(&mut self) {
        if !self.permit || self.belief.behind_the_first(self.now) >= self.ahead {
            return;
        }
        let waits = self.would_hide_a_reset() || self.waits_for_the_port();
        let Some((id, command)) = self.waiting.pop_front_if(|_| !waits) else {
            return;
        };
        let command = self.of_its_kind(command);
        self.permit = false;
        self.used = Some(self.heard);
        let packet = self
            .packet(&command)
            .expect("it was emitted once already, when it was given");
        let dialect = self.dialect.unwrap_or(Dialect::SPECIFICATION);
        let at_rest = self.belief.is_at_rest();
        self.meter.handle_sent(self.heard, at_rest, moves(&command));
        self.trust.handle_sent(&command);
        let leaves = self.leaves_limits(&command);
        let longest = self
            .completion
            .handle_sent(self.heard, id, &command, &dialect, leaves);
        self.belief
            .handle_sent(self.now, Some(id), &command, longest);
        self.to_send.push_back(packet);
        self.events.push_back(Event::Sent(id));
    }

    /// Whether the arm would be silent for so long with the next command in its queue, and its base at
    /// 0 behind that, that nobody could tell it from a reset.
    fn would_hide_a_reset(&self) -> bool {
        let next = self.waiting.front().map(|(_, command)| command);
        self.may_be_full()
            && self.belief.ahead(self.now) + NOT_YET_DEAF >= DEAF
            && self.belief.comes_to_zero(next)
    }

    /// Whether the next command has to wait because of the port that the arm serves: a joint jog until
    /// that is known, since its axes depend on it; over Bluetooth all while the queue may be full, since
    /// messages tell nothing of its room, and a voice order while the arm moves, which it would cut
    /// into (notes N38 and N50).
    fn waits_for_the_port(&self) -> bool {
        let Some((_, command)) = self.waiting.front() else {
            return false;
        };
        if !self.is_bluetooth() {
            let exchanged = |jog: &JointJog| jog.over_bluetooth() != *jog;
            return !self.scheme.is_known()
                && matches!(command, Command::JointJog(jog) if exchanged(jog));
        }
        let says = matches!(command, Command::Voice(_));
        self.may_be_full() || says && !self.belief.is_at_rest()
    }

    /// Whether the way of a command, from where all that was sent leads, leaves the limits.
    fn leaves_limits(&self, command: &Command) -> bool {
        let Some(model) = self.belief.after_sent() else {
            return false;
        };
        match model.course(command).and_then(|it| it.check()) {
            Err(CourseError::Unreachable(_)) => true,
            Ok(()) | Err(_) => false,
        }
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

    /// Whether a straight line has no length and the arm cannot stand that.
    fn is_on_the_spot(&self, command: &Command) -> bool {
        let tool = self.completion.tool();
        let before = match self.waiting.back() {
            Some((_, waiting)) => straight_target(waiting, tool),
            None => self.completion.end(),
        };
        self.dialect.is_some_and(|it| it.loses_pose_on_the_spot)
            && straight_target(command, tool)
                .zip(before)
                .is_some_and(|(to, from)| to.distance(from).0 < ON_THE_SPOT_MM)
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

/// A status comes every 80 ms; a dozen missing are no accident.
const LINK_TIMEOUT: Duration = Duration::from_secs(1);
/// Half of the time between two statuses: what comes sooner was held up on the way.
const SHORTEST_PERIOD: Duration = Duration::from_millis(40);
/// A stock arm is reset by the opening of its port, and is deaf for up to two seconds then.
const FIRST_STATUS: Duration = Duration::from_secs(5);
/// More than twice the time that passes between the end of a command and the next one's arrival: a
/// status, and a packet each way. So an arm never waits for the link, whatever the bound is.
const AHEAD: Duration = Duration::from_millis(500);
/// A status that is later than that has been withheld.
const OVERDUE: Duration = Duration::from_millis(140);
/// A status says where the arm is to that much.
const ON_THE_SPOT_MM: f64 = 0.001;
/// A status period, and as much for what is late.
const NOT_YET_DEAF: Duration = Duration::from_millis(160);
/// With that many commands under way the queue may be full, and a full queue is silent (note N20).
const QUEUE_STALLS_AT: usize = 4;
