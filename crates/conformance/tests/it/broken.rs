//! A controller that is broken in one thing.

use std::collections::VecDeque;
use std::fmt;
use std::time::Duration;

use dobot_session::Peer;
use dobot_sim::InProcess;
use dobot_wire::{Frame, PACKET_LEN};

/// A virtual arm, and what is wrong with it.
pub(crate) struct Broken {
    arm: InProcess,
    /// Changes the bytes of one send on their way to the arm; the time is that of the arm.
    #[expect(clippy::type_complexity, reason = "it is written here alone")]
    to_arm: Box<dyn FnMut(Duration, &mut Vec<u8>) + Send>,
    /// Changes a status on its way from the arm, or drops it.
    from_arm: Box<dyn FnMut(Frame) -> Option<Vec<u8>> + Send>,
    /// Statuses leave no sooner than this after each other.
    period: Duration,
    /// Whether it tells where it is even while the queue is full.
    talks: bool,
    /// Bytes of the arm that are no whole status yet.
    partial: Vec<u8>,
    /// Statuses that wait, with the time when they leave.
    outgoing: VecDeque<(Duration, Vec<u8>)>,
    last: Duration,
}

impl Broken {
    /// An arm with nothing wrong yet.
    pub(crate) fn new(arm: InProcess) -> Self {
        Self {
            arm,
            to_arm: Box::new(|_, _| {}),
            from_arm: Box::new(|frame| Some(frame.to_bytes().to_vec())),
            period: Duration::ZERO,
            talks: false,
            partial: Vec::new(),
            outgoing: VecDeque::new(),
            last: Duration::ZERO,
        }
    }

    /// What comes in is changed.
    pub(crate) fn on_receive(
        mut self,
        change: impl FnMut(Duration, &mut Vec<u8>) + Send + 'static,
    ) -> Self {
        self.to_arm = Box::new(change);
        self
    }

    /// Whole packets that come in are changed, or dropped.
    pub(crate) fn obeys(
        self,
        mut change: impl FnMut(Frame) -> Option<Frame> + Send + 'static,
    ) -> Self {
        self.on_receive(move |_, bytes| {
            let packet: Option<&[u8; PACKET_LEN]> = bytes.as_slice().try_into().ok();
            if let Some(frame) = packet.and_then(Frame::from_bytes) {
                let changed = change(frame).map(|it| it.to_bytes().to_vec());
                *bytes = changed.unwrap_or_default();
            }
        })
    }

    /// What goes out is changed.
    pub(crate) fn says(
        mut self,
        change: impl FnMut(Frame) -> Option<Vec<u8>> + Send + 'static,
    ) -> Self {
        self.from_arm = Box::new(change);
        self
    }

    /// Statuses leave this much after each other, not sooner.
    pub(crate) fn every(mut self, period: Duration) -> Self {
        self.period = period;
        self
    }

    /// A status comes every 85 ms at least, whether the queue has room or not.
    pub(crate) fn talkative(mut self) -> Self {
        self.talks = true;
        self
    }

    /// When it will say something by itself.
    fn due(&self) -> Option<Duration> {
        let said = (self.talks && self.last > Duration::ZERO).then(|| self.last + SILENCE);
        self.outgoing.front().map(|(at, _)| *at).or(said)
    }

    /// What it says at that time.
    fn say(&mut self) -> Vec<u8> {
        if let Some((_, bytes)) = self.outgoing.pop_front() {
            return bytes;
        }
        self.last = self.arm.now();
        status(&self.arm).to_bytes().to_vec()
    }

    fn take(&mut self, at: Duration, bytes: &[u8]) {
        self.partial.extend_from_slice(bytes);
        while let Some(packet) = self.partial.first_chunk::<PACKET_LEN>() {
            let frame = Frame::from_bytes(packet).expect("the arm itself sends good statuses");
            self.partial.drain(..PACKET_LEN);
            if let Some(bytes) = (self.from_arm)(frame) {
                self.last = at.max(self.last + self.period);
                self.outgoing.push_back((self.last, bytes));
            }
        }
    }
}

impl Peer for Broken {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        if bytes.is_empty() {
            return;
        }
        let mut bytes = bytes.to_vec();
        (self.to_arm)(self.arm.now(), &mut bytes);
        self.arm.send(&bytes);
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        loop {
            let now = self.arm.now();
            let due = self.due();
            if due.is_some_and(|at| at <= now) {
                bytes.extend(self.say());
                return true;
            }
            if now >= until {
                return true;
            }
            let next = due.map_or(until, |at| until.min(at));
            let mut new = Vec::new();
            self.arm.receive(next, &mut new);
            self.take(self.arm.now(), &new);
        }
    }
}

/// Where the arm is, as a status of its own.
fn status(arm: &InProcess) -> Frame {
    let arm = arm.arm();
    let joints = arm.controller().joints_at(arm.now());
    let pose = arm.controller().pose_at(arm.now());
    let numbers = [
        pose.position.x.0,
        pose.position.y.0,
        pose.position.z.0,
        pose.rotation.0,
        joints.base.0,
        joints.rear.0,
        joints.fore.0,
        joints.servo.0,
    ];
    let numbered = (1..).zip(numbers);
    numbered.fold(Frame::ZERO, |frame, (n, value)| {
        frame.with(n, narrow(value))
    })
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "a status carries single precision"
)]
const fn narrow(value: f64) -> f32 {
    value as f32
}

/// A bit more than the time between two statuses.
const SILENCE: Duration = Duration::from_millis(85);

impl fmt::Debug for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Broken").finish_non_exhaustive()
    }
}
