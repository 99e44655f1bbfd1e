//! The test rig: a link, everything received, and the home position of the checks.

use std::time::Duration;

use dobot_arm::{Joints, Position, Tool, forward};
use dobot_session::{Link, LinkError, PermitScheme, plausible, position};
use dobot_wire::{Counts, Decoder, Frame, PACKET_LEN, Status, Statuses};

use crate::Options;
use crate::blocker::Blocker;
use crate::flow::Flow;
use crate::latency::Latency;
use crate::packet::{
    STOCK_TEACH_DEG_S, STOCK_WRITING_MM_S2, angles, gentle, jog, over_bluetooth, percent, teach,
    writing,
};
use crate::timed_status::TimedStatus;

/// A link to a controller and the findings about it.
#[derive(Debug)]
pub(crate) struct Rig {
    link: Link,
    decoder: Decoder<Statuses>,
    permit_scheme: PermitScheme,
    pub(crate) options: Options,
    /// All received bytes.
    pub(crate) raw: Vec<u8>,
    /// All statuses that come every 80 ms: on USB each of them, over Bluetooth the messages (note N38).
    pub(crate) seen: Vec<TimedStatus>,
    /// All statuses that permit a command: on USB each of them, over Bluetooth one every 160 ms.
    pub(crate) permits: Vec<TimedStatus>,
    /// The time at which the last packet can show an effect.
    reacted: Duration,
    /// The measured latency of the line.
    pub(crate) latency: Option<Latency>,
    /// The reason not to move the arm.
    pub(crate) blocker: Option<Blocker>,
    /// The initial status.
    pub(crate) start: Option<Status>,
    /// Whether a motion was sent.
    pub(crate) moved: bool,
    /// The home position of the checks, slightly above the start.
    pub(crate) home: Option<Status>,
    /// Votes for the specification and for firmware 1.1.
    pub(crate) votes: [u32; 2],
    /// The moving mode of joint motions, if known.
    pub(crate) joint_mode: Option<f32>,
    /// The result of the overfull queue, if tried.
    pub(crate) flow: Option<Flow>,
}

/// The error that ends a check and the following ones.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CheckError {
    #[error("no status arrived for {:.1} s", SILENCE.as_secs_f64())]
    Silent,
    #[error(
        "no status that can be trusted came for {:.1} s: {count} came whose position and angles \
         disagree, by up to {worst:.2} mm or degrees",
        SILENCE.as_secs_f64()
    )]
    Implausible { count: usize, worst: f64 },
    #[error(
        "no status arrived for {:.1} s, only {bytes} bytes that are not a status{}",
        SILENCE.as_secs_f64(),
        if *.lost { ": the pose is NaN" } else { "" }
    )]
    Garbled { bytes: usize, lost: bool },
    #[error(
        "nothing that is sent shows within {:.0} s, neither an end effector nor the pump: the line \
         is too slow, or the controller hears nothing",
        ANSWER.as_secs_f64()
    )]
    Unanswered,
    #[error("the arm did not come to rest within {:.0} s", RESTLESS.as_secs_f64())]
    Restless,
    #[error("the arm did not return to the home position of the checks: it is {off_by:.2} mm away")]
    Astray { off_by: f64 },
    #[error("the arm never reached the home position of the checks")]
    Homeless,
    #[error("the arm does not accept its previous angles; switch it off and on before it moves")]
    Untrue,
    #[error(transparent)]
    Link(#[from] LinkError),
}

impl Rig {
    pub(crate) fn new(link: Link, options: Options) -> Self {
        Self {
            link,
            decoder: Decoder::statuses(plausible),
            permit_scheme: PermitScheme::default(),
            options,
            raw: Vec::new(),
            seen: Vec::new(),
            permits: Vec::new(),
            reacted: Duration::ZERO,
            latency: None,
            blocker: None,
            start: None,
            moved: false,
            home: None,
            votes: [0; 2],
            joint_mode: None,
            flow: None,
        }
    }

    pub(crate) fn now(&self) -> Duration {
        self.link.now()
    }

    /// Whether the arm serves its Bluetooth port, detected from the statuses (note N38).
    pub(crate) fn is_bluetooth(&self) -> bool {
        self.permit_scheme.is_bluetooth()
    }

    /// Sends a packet, with the axis of this port in a joint jog, and waits until the line is free again.
    pub(crate) async fn send(&mut self, frame: Frame) -> Result<(), CheckError> {
        let frame = if self.is_bluetooth() {
            over_bluetooth(frame)
        } else {
            frame
        };
        self.send_raw(&frame.to_bytes()).await
    }

    /// Sends bytes, and waits until the line is free again and has been for the gap that a stock
    /// arm needs (note N26).
    pub(crate) async fn send_raw(&mut self, bytes: &[u8]) -> Result<(), CheckError> {
        self.link.send(bytes);
        let count = u32::try_from(bytes.len()).unwrap_or(u32::MAX);
        let free = self.now() + BYTE * count + self.gap();
        self.reacted = free + REACTION + self.line_delay();
        self.receive_until(free).await
    }

    /// Delays the expected effect of the last packet.
    pub(crate) fn expect_later(&mut self, ms: u64) {
        self.reacted += Duration::from_millis(ms);
    }

    /// Receives for this time.
    pub(crate) async fn pass(&mut self, ms: u64) -> Result<(), CheckError> {
        self.receive_until(self.now() + Duration::from_millis(ms))
            .await
    }

    /// Receives until the last packet can show an effect.
    pub(crate) async fn react(&mut self) -> Result<(), CheckError> {
        self.receive_until(self.reacted.max(self.now())).await
    }

    async fn receive_until(&mut self, until: Duration) -> Result<(), CheckError> {
        loop {
            self.take(until).await?;
            if self.now() >= until {
                return Ok(());
            }
        }
    }

    async fn take(&mut self, until: Duration) -> Result<(), CheckError> {
        let had = self.raw.len();
        let open = self.link.receive(until, &mut self.raw).await?;
        let at = self.link.now();
        let new = self.raw.get(had..).unwrap_or_default();
        let statuses = self.decoder.feed(new).map(|frame| Status::parse(&frame));
        let statuses: Vec<Status> = statuses.flatten().collect();
        for status in statuses {
            self.note(at, status);
        }
        if open {
            Ok(())
        } else {
            Err(LinkError::Closed.into())
        }
    }

    fn note(&mut self, at: Duration, status: Status) {
        let was_bluetooth = self.is_bluetooth();
        let received = self.permit_scheme.classify(at, status);
        if self.is_bluetooth() && !was_bluetooth && self.start.is_none() {
            // Before the first message came at most a permit, which is not one of those every 80 ms.
            self.seen.clear();
        }
        let status = received.status;
        if received.is_regular {
            self.seen.push(TimedStatus { at, status });
        }
        if received.permits {
            self.permits.push(TimedStatus { at, status });
        }
    }

    /// The gap between two packets, so that jitter does not merge them.
    fn gap(&self) -> Duration {
        let jitter = self.latency.map_or(Duration::ZERO, |it| it.jitter());
        GAP + jitter.min(MAX_GAP)
    }

    /// The worst latency of a response.
    fn line_delay(&self) -> Duration {
        self.latency.map_or(Duration::ZERO, |it| it.most)
    }

    /// Waits for the next status.
    pub(crate) async fn next_status(&mut self) -> Result<Status, CheckError> {
        let (had, heard) = (self.seen.len(), self.raw.len());
        let until = self.now() + SILENCE;
        loop {
            if let Some(seen) = self.seen.get(had) {
                return Ok(seen.status);
            }
            if self.now() >= until {
                return Err(silence(self.raw.get(heard..).unwrap_or_default()));
            }
            self.take(until).await?;
        }
    }

    /// Waits until the arm is at rest after the last packet.
    pub(crate) async fn settled(&mut self) -> Result<Status, CheckError> {
        let until = self.now().max(self.reacted) + RESTLESS;
        self.react().await?;
        loop {
            if let Some(status) = self.resting() {
                return Ok(status);
            }
            if self.now() >= until {
                return Err(CheckError::Restless);
            }
            self.next_status().await?;
        }
    }

    /// Sends a packet, waits until the arm is at rest and returns its motion.
    pub(crate) async fn carry_out(
        &mut self,
        frame: Frame,
    ) -> Result<(Status, Vec<TimedStatus>), CheckError> {
        let mark = self.seen.len();
        self.send(frame).await?;
        let end = self.settled().await?;
        Ok((end, self.seen[mark..].to_vec()))
    }

    /// The status at rest: the last three statuses after the effect of the last packet are equal.
    fn resting(&self) -> Option<Status> {
        let [first, second, last] = *self.seen.last_chunk::<3>()?;
        let late = last.at >= self.reacted;
        let same = [first, second]
            .iter()
            .all(|it| still(&it.status, &last.status));
        (late && same).then_some(last.status)
    }

    /// The home position of the checks.
    pub(crate) fn home(&self) -> Result<Status, CheckError> {
        self.home.ok_or(CheckError::Homeless)
    }

    /// Moves to the home position of the checks.
    pub(crate) async fn go_home(&mut self) -> Result<Status, CheckError> {
        let home = self.home()?;
        self.go_to(&home).await
    }

    /// Moves to the joint angles of a status. Sends up to three times because a command may be lost.
    pub(crate) async fn go_to(&mut self, to: &Status) -> Result<Status, CheckError> {
        let mut now = self.settled().await?;
        if turned(&now, to) < AT_REST_DEG {
            return Ok(now);
        }
        for _ in 0..TRIES {
            // A straight line must have a length (note N34), and a JUMP need not.
            let off_by = distance(&now, to);
            let mode = if off_by < AT_REST_MM { 0.0 } else { 1.0 };
            (now, _) = self.carry_out(angles(to, mode)).await?;
            if turned(&now, to) < NEAR_DEG {
                return Ok(now);
            }
        }
        let off_by = distance(&now, to);
        Err(CheckError::Astray { off_by })
    }

    /// Whether the arm is at rest.
    pub(crate) async fn stands(&mut self) -> Result<bool, CheckError> {
        self.react().await?;
        let before = self.next_status().await?;
        let after = self.next_status().await?;
        Ok(still(&before, &after))
    }

    /// Stops a jog with a release and a setting, which both dialects handle only after the jog.
    pub(crate) async fn stop_jog(&mut self) -> Result<(), CheckError> {
        for packet in [jog(2.0, 0.0, 0.0), writing(STOCK_WRITING_MM_S2)] {
            self.send(packet).await?;
        }
        Ok(())
    }

    /// Sends the speeds of the checks.
    pub(crate) async fn be_gentle(&mut self) -> Result<(), CheckError> {
        self.send(gentle(0.0)).await
    }

    /// Sends all settings of the checks.
    pub(crate) async fn settings(&mut self) -> Result<(), CheckError> {
        for packet in [
            gentle(0.0),
            percent(50.0, 50.0),
            teach(STOCK_TEACH_DEG_S),
            writing(STOCK_WRITING_MM_S2),
        ] {
            self.send(packet).await?;
        }
        Ok(())
    }

    /// The end effector whose reach the first status shows.
    pub(crate) fn tool(&self) -> Tool {
        self.start.as_ref().map_or(Tool::SuctionCup, tool_of)
    }

    /// The dialect that all checks until now voted for: specification (0) or firmware 1.1 (1).
    pub(crate) const fn leaning(&self) -> Option<usize> {
        match self.votes {
            [0, 0] => None,
            [_, 0] => Some(0),
            [0, _] => Some(1),
            _ => None,
        }
    }

    /// The counts of trustworthy statuses and of bytes that belong to none.
    pub(crate) fn counts(&self) -> Counts {
        self.decoder.counts()
    }
}

/// Statuses by their form alone, whether their numbers agree or not; without the 1000 mm of a message
/// over Bluetooth (note N38).
pub(crate) fn lenient(raw: &[u8]) -> Vec<Status> {
    let mut decoder = Decoder::statuses(|_: &Frame| true);
    let statuses = decoder.feed(raw).map(|frame| Status::parse(&frame));
    let statuses = statuses.flatten();
    statuses
        .map(|status| status.message().unwrap_or(status))
        .collect()
}

/// The disagreement of position and angles of a status, in millimetres or degrees.
pub(crate) fn disagreement(status: &Status) -> f64 {
    let turn = status.base_deg + status.servo_deg - status.rotation_deg;
    pose_error(status, tool_of(status)).max(turn.abs().into())
}

/// Whether a window of the bytes is a status whose X is NaN.
pub(crate) fn has_nan_pose(raw: &[u8]) -> bool {
    raw.windows(PACKET_LEN).any(|window| {
        let window: Result<&[u8; PACKET_LEN], _> = window.try_into();
        let frame = window.ok().and_then(Frame::from_bytes);
        frame.is_some_and(|it| it.float(1).is_nan())
    })
}

/// The error for a missing trustworthy status.
fn silence(raw: &[u8]) -> CheckError {
    let statuses = lenient(raw);
    if !statuses.is_empty() {
        let worst = statuses.iter().map(disagreement).fold(0.0, f64::max);
        let count = statuses.len();
        return CheckError::Implausible { count, worst };
    }
    match raw.len() {
        0 => CheckError::Silent,
        bytes => CheckError::Garbled {
            bytes,
            lost: has_nan_pose(raw),
        },
    }
}

/// The end effector that best fits a status.
pub(crate) fn tool_of(status: &Status) -> Tool {
    let off = |tool| pose_error(status, tool);
    if off(Tool::Laser) < off(Tool::SuctionCup) {
        Tool::Laser
    } else {
        Tool::SuctionCup
    }
}

/// The distance of the position of a status from that of its angles, in millimetres.
pub(crate) fn pose_error(status: &Status, tool: Tool) -> f64 {
    let there = forward(&joints(status), tool).position;
    position(status).distance(there).0
}

pub(crate) fn joints(status: &Status) -> Joints {
    let angles = [
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
    ];
    let [base, rear, fore, servo] = angles.map(f64::from);
    Joints::new(base, rear, fore, servo)
}

/// The distance between the positions of two statuses, in millimetres.
pub(crate) fn distance(a: &Status, b: &Status) -> f64 {
    position(a).distance(position(b)).0
}

/// The position of a status with an offset in millimetres, as floats of a packet.
pub(crate) fn moved(from: &Status, [x, y, z]: [f32; 3]) -> [f32; 3] {
    [from.x_mm + x, from.y_mm + y, from.z_mm + z]
}

/// The distance of a status from a position in millimetres.
pub(crate) fn off(status: &Status, to: [f32; 3]) -> f64 {
    let [x, y, z] = to.map(f64::from);
    position(status).distance(Position::new(x, y, z)).0
}

/// The largest difference between the joint angles of two statuses, in degrees.
pub(crate) fn turned(a: &Status, b: &Status) -> f32 {
    let angles = |it: &Status| [it.base_deg, it.rear_deg, it.fore_deg, it.servo_deg];
    let pairs = angles(a).into_iter().zip(angles(b));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

fn still(a: &Status, b: &Status) -> bool {
    turned(a, b) < STILL
        && distance(a, b) < f64::from(STILL)
        && (a.gripper_deg - b.gripper_deg).abs() < STILL
}

/// The transmission time of a byte at 9600 baud, rounded up.
pub(crate) const BYTE: Duration = Duration::from_micros(1045);
/// A stock arm may lose a packet after a shorter gap (note N26).
const GAP: Duration = Duration::from_millis(12);
/// Nine packets must arrive during a vector of 1.4 s.
const MAX_GAP: Duration = Duration::from_millis(90);
/// A tick, the tick that a status lags behind, the time between two statuses, and the way of one
/// over the line; twenty more for a serial port over USB.
const REACTION: Duration = Duration::from_millis(200);
const SILENCE: Duration = Duration::from_secs(3);
/// The timeout of the first response.
pub(crate) const ANSWER: Duration = Duration::from_secs(6);
/// The number of attempts to return.
const TRIES: u32 = 3;
const RESTLESS: Duration = Duration::from_secs(8);
const AT_REST_DEG: f32 = 0.005;
const AT_REST_MM: f64 = 0.05;
const NEAR_DEG: f32 = 0.02;
/// Degrees and millimetres from one status to the next.
const STILL: f32 = 0.0005;
