//! The session engine: what to send when, and what the statuses mean.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Position;
use dobot_wire::{Command, Counts, Decoder, Dialect, Frame, Packet, ParseError, Status, Statuses};

use crate::completion::{Completion, straight_target};

/// A conversation with one arm, as an engine: it owns no port, no thread and no clock.
///
/// Things happen to it (`handle_*`), it wants things (`poll_*`), and [`Session::poll_wakeup`] says
/// when it next needs the time, which counts from the connect and never goes back.
///
/// Each status received is a permit to send one command (note N20): what is given to
/// [`Session::send`] waits here for its turn.
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
#[derive(Debug)]
pub struct Session {
    dialect: Option<Dialect>,
    decoder: Decoder<Statuses>,
    waiting: VecDeque<(CommandId, Command)>,
    next_id: u64,
    /// A status came and no command has used it yet.
    permit: bool,
    /// When the status came whose permit was used last.
    used: Option<Duration>,
    to_send: VecDeque<Packet>,
    completion: Completion,
    status: Option<Status>,
    /// When the last status came; at first the connect.
    heard: Duration,
    lost: bool,
    resyncs: u64,
    skipped: u64,
    events: VecDeque<Event>,
}

/// Names a command of a session, from the first one sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CommandId(pub u64);

/// What happened in a session.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// The arm told its state.
    Status(Status),
    /// A command left for the arm.
    Sent(CommandId),
    /// A command is over: the arm was seen where it leads.
    Completed(CommandId),
    /// The arm came to rest elsewhere than a command leads.
    NotReached {
        /// The command.
        command: CommandId,
        /// Where it leads.
        expected: Position,
        /// Where the arm rests.
        found: Position,
    },
    /// Bytes that belong to no status were skipped, and the stream of statuses was found again.
    Resynced {
        /// How many bytes since the last such event.
        skipped: u64,
    },
    /// No status came for longer than any command under way explains.
    LinkLost {
        /// How long.
        silent_for: Duration,
        /// Bytes that came all the same, but in no status.
        noise: u64,
    },
}

/// Why a command is not sent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SendError {
    /// The arm's dialect is not known and the command means different things in them (note N1).
    #[error("{field} means different things to different arms, and nobody has said which this is")]
    Undecided {
        /// The field in question.
        field: &'static str,
    },
    /// The arm stands there already, and a straight line of no length makes it lose its pose.
    #[error(
        "the arm is there already, and a straight line of no length would make it lose its pose (note N34)"
    )]
    OnTheSpot,
    /// The command breaks a range of its table.
    #[error("the command is not allowed")]
    Invalid(#[source] ParseError),
}

impl Session {
    /// A session with an arm that speaks `dialect`, if that is known.
    #[must_use]
    pub fn new(dialect: Option<Dialect>) -> Self {
        Self {
            dialect,
            decoder: Decoder::statuses(plausible),
            waiting: VecDeque::new(),
            next_id: 0,
            permit: false,
            used: None,
            to_send: VecDeque::new(),
            completion: Completion::default(),
            status: None,
            heard: Duration::ZERO,
            lost: false,
            resyncs: 0,
            skipped: 0,
            events: VecDeque::new(),
        }
    }

    /// Takes a command; it is sent when the arm permits it, after those given before.
    ///
    /// # Errors
    ///
    /// [`SendError::Undecided`] where its meaning depends on a dialect that nobody has told,
    /// [`SendError::Invalid`] where a value breaks its table. Nothing is sent then.
    pub fn send(&mut self, command: impl Into<Command>) -> Result<CommandId, SendError> {
        let command = command.into();
        self.check(&command)?;
        let id = CommandId(self.next_id);
        self.next_id += 1;
        self.waiting.push_back((id, command));
        self.dispatch();
        Ok(id)
    }

    /// Whether a command would be sent.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn check(&self, command: &Command) -> Result<(), SendError> {
        if self.is_on_the_spot(command) {
            return Err(SendError::OnTheSpot);
        }
        self.packet(command).map(|_| ())
    }

    /// Sends a command at once and ahead of all others, permit or not: for parting words on a
    /// link that is failing (laser off, pen up). Those that wait are forgotten.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn send_now(&mut self, command: impl Into<Command>) -> Result<(), SendError> {
        let packet = self.packet(&command.into())?;
        self.forget_waiting();
        self.to_send.push_back(packet);
        Ok(())
    }

    /// Forgets the commands that have not been sent yet; says how many they were.
    pub fn forget_waiting(&mut self) -> usize {
        let count = self.waiting.len();
        self.waiting.clear();
        count
    }

    /// Takes bytes from the arm.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
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
            None => FIRST_STATUS,
            Some(_) if self.completion.len() >= QUEUE_STALLS_AT => {
                LINK_TIMEOUT + self.completion.longest_silence()
            }
            Some(_) => LINK_TIMEOUT,
        };
        self.heard + patience
    }

    /// What the arm told last.
    #[must_use]
    pub const fn status(&self) -> Option<&Status> {
        self.status.as_ref()
    }

    /// The dialect, if it is known.
    #[must_use]
    pub const fn dialect(&self) -> Option<&Dialect> {
        self.dialect.as_ref()
    }

    /// Whether something happened that nobody has been told.
    #[must_use]
    pub fn has_event(&self) -> bool {
        !self.events.is_empty()
    }

    /// Commands that wait for a permit.
    #[must_use]
    pub fn waiting(&self) -> usize {
        self.waiting.len()
    }

    /// Commands sent and not seen to be over.
    #[must_use]
    pub fn under_way(&self) -> usize {
        self.completion.len()
    }

    /// What the decoder has seen.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.decoder.counts()
    }

    fn handle_status(&mut self, now: Duration, status: Status) {
        self.heard = now;
        self.lost = false;
        self.status = Some(status);
        self.events.push_back(Event::Status(status));
        let events = &mut self.events;
        self.completion
            .handle_status(now, &status, |event| events.push_back(event));
        // Statuses that come in a heap were kept somewhere on the way: only one of them is news.
        self.permit |= self
            .used
            .is_none_or(|used| now.saturating_sub(used) >= SHORTEST_PERIOD);
        self.dispatch();
    }

    fn dispatch(&mut self) {
        if !self.permit {
            return;
        }
        let Some((id, command)) = self.waiting.pop_front() else {
            return;
        };
        self.permit = false;
        self.used = Some(self.heard);
        let packet = self
            .packet(&command)
            .expect("it was emitted once already, when it was given");
        let pauses = self.dialect.is_none_or(|it| it.uses_default_pause);
        self.completion
            .handle_sent(self.heard, id, &command, pauses);
        self.to_send.push_back(packet);
        self.events.push_back(Event::Sent(id));
    }

    fn packet(&self, command: &Command) -> Result<Packet, SendError> {
        let dialect = match (&self.dialect, command.dialect_dependent()) {
            (Some(dialect), _) => dialect,
            (None, None) => &Dialect::SPECIFICATION,
            (None, Some(field)) => return Err(SendError::Undecided { field }),
        };
        let packet = command.emit(dialect);
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

/// Whether a frame can be a status: its position agrees with its angles (note N22).
#[must_use]
pub fn plausible(frame: &Frame) -> bool {
    let float = |n| f64::from(frame.float(n));
    dobot_arm::agrees([1, 2, 3].map(float), float(4), [5, 6, 7, 8].map(float))
}

/// A status comes every 80 ms; a dozen missing are no accident.
const LINK_TIMEOUT: Duration = Duration::from_secs(1);
/// Half of the time between two statuses: what comes sooner was held up on the way.
const SHORTEST_PERIOD: Duration = Duration::from_millis(40);
/// A stock arm is reset by the opening of its port, and is deaf for up to two seconds then.
const FIRST_STATUS: Duration = Duration::from_secs(5);
/// A status says where the arm is to that much.
const ON_THE_SPOT_MM: f64 = 0.001;
/// With that many commands under way the queue may be full, and a full queue is silent (note N20).
const QUEUE_STALLS_AT: usize = 4;
