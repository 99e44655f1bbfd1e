//! The encoder from records to messages.

use std::time::Duration;

use data_encoding::HEXLOWER;
use dobot_wire::{Command, Commands, Decoder, Dialect, Packet, Status, Statuses};
use jiff::Timestamp;
use serde::Serialize;
use serde_json::json;

use crate::frames::BASE;
use crate::repeats::{HeldBack, Repeats};
use crate::scene::Scene;
use crate::topic::{FROM_ARM, INK, JOINTS, POSE, RECORDER, TO_ARM, TRANSFORMS};
use crate::{Record, Topic, schema};

/// A sans-IO encoder: records in, messages out.
///
/// It tracks the bytes of each direction, so that each message contains at most one packet, with
/// its meaning, however the bytes were split. A repeated status is held back until something else
/// happens, or for ten seconds, and then written once with all its times. The target and the ink
/// views are computed from the commands and the statuses.
#[derive(Debug)]
pub(crate) struct Encoder {
    /// The start of the records' times, in nanoseconds since 1970.
    start_ns: u64,
    dialect: Option<Dialect>,
    commands: Decoder<Commands>,
    statuses: Decoder<Statuses>,
    /// The last status, if it is complete and everything since repeats it.
    repeats: Option<Repeats>,
    /// The content of the views.
    shown: Option<Status>,
    scene: Scene,
}

/// A message, ready to be written or sent.
#[derive(Debug)]
pub struct Message<'t> {
    /// The topic.
    pub topic: &'t Topic,
    /// The time of the message, in nanoseconds since 1970.
    pub at_ns: u64,
    /// The time of its first event, in nanoseconds since 1970.
    pub(crate) since_ns: u64,
    /// The message itself, a JSON object.
    pub json: Vec<u8>,
}

/// The time of an event in the representations used by messages.
#[derive(Clone, Copy)]
struct MessageTime {
    at: Duration,
    at_ns: u64,
}

impl Encoder {
    /// Creates an encoder for records whose times count from `start`; `None` before 1970 or after
    /// 2500, which recordings cannot represent.
    pub(crate) fn new(start: Timestamp) -> Option<Self> {
        let start_ns = u64::try_from(start.as_nanosecond()).ok()?;
        (start_ns < LATEST_NS).then(|| Self {
            start_ns,
            dialect: None,
            commands: Decoder::commands(),
            statuses: Decoder::statuses(dobot_session::plausible),
            repeats: None,
            shown: None,
            scene: Scene::default(),
        })
    }

    /// Returns the messages for what was held back and for a record; `None` if its time is
    /// centuries in the future.
    pub(crate) fn write<'t>(
        &mut self,
        at: Duration,
        record: &'t Record,
    ) -> Option<Vec<Message<'t>>> {
        let time = self.time(at)?;
        if let Record::FromArm(bytes) = record {
            return Some(self.messages_from_arm(time, bytes));
        }
        let mut messages = self.write_held();
        match record {
            Record::About(about) => {
                self.dialect = about.dialect;
                self.scene.set_dialect(about.dialect);
            }
            Record::Tools(tools) => self.scene.set_tools(tools),
            Record::Pen { below_mm } => self.scene.set_pen(*below_mm),
            Record::ToArm(bytes) => messages.extend(self.messages_to_arm(time, bytes)),
            Record::FromArm(_) => {}
            Record::Json { topic, value } => messages.push(time.message(topic, value)),
        }
        messages.extend(self.news(time));
        Some(messages)
    }

    /// Handles a record like [`Encoder::write`] without creating messages.
    pub(crate) fn follow(&mut self, at: Duration, record: &Record) {
        match record {
            Record::ToArm(bytes) => {
                for packet in self.commands.feed(bytes) {
                    if let Some(Ok(command)) = meaning(&packet, self.dialect) {
                        self.scene.handle_sent(at, &command);
                    }
                }
            }
            Record::FromArm(bytes) => {
                for frame in self.statuses.feed(bytes) {
                    if let Ok(status) = Status::parse(&frame) {
                        self.scene.handle_status(at, &truly(&status));
                    }
                }
            }
            // Other records need no work and are not reported.
            _ => drop(self.write(at, record)),
        }
        if let Some(time) = self.time(at) {
            let _ = self.news(time);
        }
    }

    /// All reported ink that is still kept, for a late subscriber.
    pub(crate) fn ink_so_far(&self, at: Duration) -> Vec<Message<'static>> {
        let Some(time) = self.time(at) else {
            return Vec::new();
        };
        let ink = self.scene.ink_so_far(&time.stamp());
        ink.iter().map(|item| time.own(INK, item)).collect()
    }

    /// Returns the messages for what is held back.
    pub(crate) fn write_held<'t>(&mut self) -> Vec<Message<'t>> {
        let held = self.repeats.as_mut().map(Repeats::take_held);
        // Held-back data starts with a packet: the rest of this one is not held back.
        self.repeats.take_if(|repeat| !repeat.is_between_packets());
        held.map(|held| self.repeat_messages(&held))
            .unwrap_or_default()
    }

    /// Starts over: the next status is written immediately, with the views if `with_views`, even if
    /// it repeats the last one.
    pub(crate) fn forget_repeats(&mut self, with_views: bool) {
        self.repeats = None;
        if with_views {
            self.shown = None;
            self.scene.report_again();
        }
    }

    /// Whether anything is held back.
    pub(crate) fn is_holding(&self) -> bool {
        self.repeats.as_ref().is_some_and(Repeats::is_holding)
    }

    /// The message about lost records.
    pub(crate) fn write_lost(
        &self,
        at: Duration,
        lost: u64,
        reason: &str,
    ) -> Option<Message<'static>> {
        let time = self.time(at)?;
        let value = json!({ "at_s": time.at_s(), "lost": lost, "reason": reason });
        Some(time.own(RECORDER, &value))
    }

    /// A time in nanoseconds since 1970; `None` if it is centuries in the future.
    pub(crate) fn at_ns(&self, at: Duration) -> Option<u64> {
        self.time(at).map(|time| time.at_ns)
    }

    fn time(&self, at: Duration) -> Option<MessageTime> {
        let nanos = u64::try_from(at.as_nanos()).ok()?;
        let at_ns = self
            .start_ns
            .checked_add(nanos)
            .filter(|sum| *sum < LATEST_NS)?;
        Some(MessageTime { at, at_ns })
    }

    /// The changes of the views that were not reported yet.
    fn news<'t>(&mut self, time: MessageTime) -> impl Iterator<Item = Message<'t>> + use<'t> {
        let news = self.scene.poll(time.at, &time.stamp());
        news.map(move |(topic, value)| time.own(topic, &value))
    }

    fn messages_to_arm(&mut self, time: MessageTime, bytes: &[u8]) -> Vec<Message<'static>> {
        let mut messages = Vec::new();
        for (piece, packet) in pieces(&mut self.commands, bytes) {
            let mut message = ToArm {
                at_s: time.at_s(),
                bytes: HEXLOWER.encode(piece),
                ..ToArm::default()
            };
            match packet.and_then(|packet| meaning(&packet, self.dialect)) {
                Some(Ok(command)) => {
                    self.scene.handle_sent(time.at, &command);
                    message.command = Some(command);
                }
                Some(Err(error)) => message.error = Some(error),
                None => {}
            }
            messages.push(time.own(TO_ARM, &message));
        }
        messages
    }

    fn messages_from_arm<'t>(&mut self, time: MessageTime, bytes: &[u8]) -> Vec<Message<'t>> {
        let mut messages = Vec::new();
        for (piece, frame) in pieces(&mut self.statuses, bytes) {
            let (at_ns, is_end) = (time.at_ns, frame.is_some());
            let status = frame.and_then(|frame| Status::parse(&frame).ok());
            if let Some(status) = &status {
                self.scene.handle_status(time.at, &truly(status));
            }
            let repeats = self.repeats.as_mut();
            if repeats.is_some_and(|repeat| repeat.take(at_ns, piece, is_end)) {
                let news: Vec<_> = self.news(time).collect();
                if !news.is_empty() || self.repeats.as_ref().is_some_and(Repeats::is_due) {
                    messages.extend(self.write_held());
                }
                messages.extend(news);
                continue;
            }
            messages.extend(self.write_held());
            messages.push(time.bytes_from_arm(piece, status));
            if let Some(status) = status
                && self.shown.replace(status) != Some(status)
            {
                messages.extend(self.views(time, &status));
            }
            messages.extend(self.news(time));
            let packet = frame.map(|frame| frame.to_bytes());
            self.repeats = packet
                .zip(status)
                .map(|(packet, status)| Repeats::new(packet, status));
        }
        messages
    }

    /// A status in the form of Foxglove's panels.
    fn views<'t>(&mut self, time: MessageTime, status: &Status) -> [Message<'t>; 3] {
        let status = &truly(status);
        let timestamp = time.stamp();
        let pose = json!({
            "timestamp": &timestamp,
            "frame_id": BASE,
            "pose": { "position": position_m(status), "orientation": quaternion(status) },
        });
        let joints = Joints {
            at_s: time.at_s(),
            base_deg: status.base_deg,
            rear_deg: status.rear_deg,
            fore_deg: status.fore_deg,
            servo_deg: status.servo_deg,
            suction: status.suction,
            gripper_deg: status.gripper_deg,
        };
        [
            time.own(POSE, &pose),
            time.own(TRANSFORMS, &self.scene.transforms(status, &timestamp)),
            time.own(JOINTS, &joints),
        ]
    }

    fn repeat_messages<'t>(&mut self, held: &HeldBack) -> Vec<Message<'t>> {
        let mut messages = match held.ends_ns[..] {
            [] => Vec::new(),
            // A single one is written as if it had not been held back.
            [at_ns] => {
                let time = self.time_at(at_ns);
                vec![time.bytes_from_arm(&held.packet, Some(held.status))]
            }
            [first_ns, .., last_ns] => self.merged(held, [first_ns, last_ns]),
        };
        messages.extend(
            held.pieces
                .iter()
                .map(|piece| self.time_at(piece.at_ns).bytes_from_arm(&piece.bytes, None)),
        );
        messages
    }

    /// Returns the message that replaces statuses from the first to the last time, and the views of the
    /// last one.
    fn merged<'t>(&mut self, held: &HeldBack, [first_ns, last_ns]: [u64; 2]) -> Vec<Message<'t>> {
        let time = self.time_at(last_ns);
        let gaps_ns = held.ends_ns.windows(2).map(|pair| pair[1] - pair[0]);
        let message = FromArm {
            gaps_ns: Some(gaps_ns.collect()),
            ..FromArm::new(time.at_s(), &held.packet, Some(held.status))
        };
        let message = Message {
            since_ns: first_ns,
            ..time.own(FROM_ARM, &message)
        };
        let views = self.views(time, &held.status);
        std::iter::once(message).chain(views).collect()
    }

    fn time_at(&self, at_ns: u64) -> MessageTime {
        let at = Duration::from_nanos(at_ns.saturating_sub(self.start_ns));
        MessageTime { at, at_ns }
    }
}

impl MessageTime {
    fn at_s(self) -> f64 {
        self.at.as_secs_f64()
    }

    /// A time in Foxglove's form.
    fn stamp(self) -> serde_json::Value {
        json!({
            "sec": self.at_ns / NANOS_PER_S,
            "nsec": self.at_ns % NANOS_PER_S,
        })
    }

    fn own<'t>(self, topic: &str, value: &impl Serialize) -> Message<'t> {
        let topic = schema::own(topic).expect("it is one of the recorder's own topics");
        self.message(topic, value)
    }

    fn bytes_from_arm<'t>(self, bytes: &[u8], status: Option<Status>) -> Message<'t> {
        self.own(FROM_ARM, &FromArm::new(self.at_s(), bytes, status))
    }

    fn message<'t>(self, topic: &'t Topic, value: &impl Serialize) -> Message<'t> {
        Message {
            topic,
            at_ns: self.at_ns,
            since_ns: self.at_ns,
            json: serde_json::to_vec(value).expect("all maps have names that are text"),
        }
    }
}

/// A message of [`TO_ARM`].
#[derive(Debug, Default, Serialize)]
struct ToArm {
    at_s: f64,
    bytes: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    command: Option<Command>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

/// A message of [`FROM_ARM`].
#[derive(Debug, Serialize)]
struct FromArm {
    at_s: f64,
    bytes: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    gaps_ns: Option<Vec<u64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    status: Option<Status>,
}

impl FromArm {
    fn new(at_s: f64, bytes: &[u8], status: Option<Status>) -> Self {
        Self {
            at_s,
            bytes: HEXLOWER.encode(bytes),
            gaps_ns: None,
            status,
        }
    }
}

/// A message of [`JOINTS`].
#[derive(Debug, Serialize)]
struct Joints {
    at_s: f64,
    base_deg: f32,
    rear_deg: f32,
    fore_deg: f32,
    servo_deg: f32,
    suction: bool,
    gripper_deg: f32,
}

/// Splits bytes after each complete packet.
fn pieces<'b, D: dobot_wire::Direction>(
    decoder: &mut Decoder<D>,
    bytes: &'b [u8],
) -> Vec<(&'b [u8], Option<D::Item>)> {
    let (mut pieces, mut begin) = (Vec::new(), 0);
    for (end, byte) in (1..).zip(bytes.chunks(1)) {
        if let Some(packet) = decoder.feed(byte).last() {
            pieces.push((&bytes[begin..end], Some(packet)));
            begin = end;
        }
    }
    if begin < bytes.len() {
        pieces.push((&bytes[begin..], None));
    }
    pieces
}

/// The meaning of a packet, or why it is not a command; `None` if it depends on an unknown dialect.
///
/// # Errors
///
/// The text of a [`ParseError`](dobot_wire::ParseError) if it is not a command.
#[must_use]
pub fn meaning(packet: &Packet, dialect: Option<Dialect>) -> Option<Result<Command, String>> {
    let read =
        |dialect: Dialect| Command::parse(packet, &dialect).map_err(|error| error.to_string());
    if let Some(dialect) = dialect {
        return Some(read(dialect));
    }
    let [one, other] = Dialect::ALL.map(read);
    let agree = one == other || one.is_err() && other.is_err();
    agree.then_some(one)
}

/// A status, with the place that it contains if it is a message of the Bluetooth port.
fn truly(status: &Status) -> Status {
    status.message().unwrap_or(*status)
}

fn position_m(status: &Status) -> serde_json::Value {
    let metres = |millimetres: f32| f64::from(millimetres) / 1000.0;
    json!({
        "x": metres(status.x_mm),
        "y": metres(status.y_mm),
        "z": metres(status.z_mm),
    })
}

/// The tool rotates about the vertical only.
fn quaternion(status: &Status) -> serde_json::Value {
    let (sine, cosine) = (f64::from(status.rotation_deg).to_radians() / 2.0).sin_cos();
    json!({ "x": 0.0, "y": 0.0, "z": sine, "w": cosine })
}

const NANOS_PER_S: u64 = 1_000_000_000;

/// The latest time: some centuries from now, with room for additions.
const LATEST_NS: u64 = u64::MAX / 10 * 9;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::sync::Arc;

    use dobot_wire::{MoveTo, MovingMode};
    use serde_json::Value;

    use super::*;
    use crate::About;

    fn encoder() -> Encoder {
        Encoder::new("2026-11-21T12:30:00Z".parse().unwrap()).unwrap()
    }

    fn value(message: &Message<'_>) -> Value {
        serde_json::from_slice(&message.json).unwrap()
    }

    fn target(mode: MovingMode) -> [u8; 42] {
        let target = MoveTo::to(200.0, 0.0, 20.0).with_mode(mode);
        target.emit(&Dialect::SPECIFICATION).to_bytes()
    }

    /// Rear arm upright, forearm level, base and tool rotated by 90 degrees.
    fn status() -> Status {
        Status {
            x_mm: 0.0,
            y_mm: 215.07,
            rotation_deg: 90.0,
            base_deg: 90.0,
            suction: true,
            ..Status::AT_ZERO
        }
    }

    #[test]
    fn a_message_holds_one_packet_for_any_chunks_of_bytes() {
        let mut encoder = encoder();
        let two = [target(MovingMode::Jump), target(MovingMode::Jump)].concat();
        let first = Record::ToArm(two[..50].to_vec());
        let messages = encoder.write(Duration::ZERO, &first).unwrap();
        assert_eq!(messages.len(), 2);
        assert_eq!(value(&messages[0])["command"]["x_mm"], 200.0);
        assert_eq!(value(&messages[1]).get("command"), None);
        let second = Record::ToArm(two[50..].to_vec());
        let messages = encoder.write(Duration::ZERO, &second).unwrap();
        assert_eq!(messages.len(), 1);
        assert_eq!(value(&messages[0])["command"]["type"], "move_to");
    }

    #[test]
    fn commands_that_depend_on_the_dialect_are_decoded_only_when_it_is_known() {
        let mut encoder = encoder();
        let record = Record::ToArm(target(MovingMode::MovL).to_vec());
        let messages = encoder.write(Duration::ZERO, &record).unwrap();
        assert_eq!(value(&messages[0]).get("command"), None);
        let about = About {
            dialect: Some(Dialect::FIRMWARE_1_1),
            ..About::default()
        };
        encoder
            .write(Duration::ZERO, &Record::About(Box::new(about)))
            .unwrap();
        let messages = encoder.write(Duration::ZERO, &record).unwrap();
        assert_eq!(value(&messages[0])["command"]["mode"], "movj");
    }

    #[test]
    fn a_packet_that_is_not_a_command_has_the_reason() {
        let mut encoder = encoder();
        let mut packet = target(MovingMode::Jump);
        packet[29..33].copy_from_slice(&7.0_f32.to_le_bytes());
        let record = Record::ToArm(packet.to_vec());
        let messages = encoder.write(Duration::ZERO, &record).unwrap();
        let error = value(&messages[0])["error"].as_str().unwrap().to_owned();
        assert!(error.contains("float 8"), "{error}");
    }

    #[test]
    fn a_status_shows_in_foxglove_in_metres_turned_about_the_vertical() {
        let mut encoder = encoder();
        let record = Record::FromArm(status().emit().to_bytes().to_vec());
        let messages = encoder.write(Duration::from_millis(1500), &record).unwrap();
        let topics: Vec<_> = messages
            .iter()
            .map(|message| message.topic.name())
            .collect();
        assert_eq!(topics, [FROM_ARM, POSE, TRANSFORMS, JOINTS]);
        let pose = value(&messages[1]);
        assert_eq!(pose["timestamp"]["nsec"], 500_000_000);
        let y_m = pose["pose"]["position"]["y"].as_f64().unwrap();
        assert!((y_m - 0.21507).abs() < 1e-6, "{y_m}, not 0.21507");
        // A quarter turn: w = z = cos 45°.
        for part in ["z", "w"] {
            let found = pose["pose"]["orientation"][part].as_f64().unwrap();
            let expected = 0.5_f64.sqrt();
            assert!((found - expected).abs() < 1e-9, "{found}, not {expected}");
        }
        assert_eq!(value(&messages[3])["base_deg"], 90.0);
    }

    #[test]
    fn times_count_from_the_start() {
        let mut encoder = encoder();
        let topic = Topic::new("/events", "dobot.Event", &json!({ "type": "object" })).unwrap();
        let record = Record::Json {
            topic: Arc::new(topic),
            value: json!({ "type": "stopped" }),
        };
        let messages = encoder.write(Duration::from_mins(1), &record).unwrap();
        let expected: Timestamp = "2026-11-21T12:31:00Z".parse().unwrap();
        assert_eq!(i128::from(messages[0].at_ns), expected.as_nanosecond());
        assert_eq!(value(&messages[0])["type"], "stopped");
    }

    #[test]
    fn times_that_have_no_number_are_refused() {
        assert!(Encoder::new("1969-07-20T20:17:00Z".parse().unwrap()).is_none());
        assert!(Encoder::new("9000-01-01T00:00:00Z".parse().unwrap()).is_none());
        assert!(
            encoder()
                .write(Duration::MAX, &Record::ToArm(vec![1]))
                .is_none()
        );
    }
}
