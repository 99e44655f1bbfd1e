//! A program played at a bare arm, and at the raw port of a station.

use std::fmt;
use std::time::Duration;

use dobot_api::{ClientId, News};
use dobot_controller::{Controller, Personality, PowerUp, Refused};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_session::plausible;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_wire::{Decoder, Frame, Statuses};

use super::recorded::{Program, RecordedPacket, Within};

const PERSONALITY: Personality = Personality::Firmware11;
const STEP_MS: u64 = 5;
/// The number of steps after which an arm counts as at rest: shorter than half of the shortest
/// pause.
const REST_STEPS: u32 = 40;

/// The position of an arm and the state of its tool.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Look {
    /// X, Y and Z.
    mm: [f64; 3],
    /// Base, rear arm, forearm, servo, and the gripper as far as its servo turns.
    deg: [f64; 5],
    pump: bool,
    laser: bool,
}

impl Look {
    fn of(arm: &VirtualArm) -> Self {
        let controller = arm.controller();
        let now = arm.controller_time(arm.now());
        let at = controller.pose_at(now).position;
        let joints = controller.joints_at(now);
        let outputs = controller.outputs();
        let gripper_deg = (f64::from(outputs.gripper_servo) - 500.0) * 0.18;
        Self {
            mm: [at.x.0, at.y.0, at.z.0],
            deg: [
                joints.base.0,
                joints.rear.0,
                joints.fore.0,
                joints.servo.0,
                gripper_deg.clamp(-90.0, 90.0),
            ],
            pump: outputs.pump,
            laser: outputs.laser,
        }
    }

    pub(super) fn is_near(&self, other: &Self, within: Within) -> bool {
        let apart = |one: &[f64], other: &[f64]| {
            let pairs = one.iter().zip(other);
            pairs.fold(0.0, |most: f64, (one, other)| most.max((one - other).abs()))
        };
        apart(&self.mm, &other.mm) <= within.mm
            && apart(&self.deg, &other.deg) <= within.deg
            && (self.pump, self.laser) == (other.pump, other.laser)
    }
}

impl fmt::Debug for Look {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mm, deg) = (self.mm, self.deg);
        let (pump, laser) = (self.pump, self.laser);
        write!(
            f,
            "{mm:.3?} mm, {deg:.3?} degrees, pump {pump}, laser {laser}"
        )
    }
}

/// Where an arm came to rest, in order, and where it was at the observations.
#[derive(Debug, Default)]
pub(super) struct Seen {
    pub(super) rests: Vec<Look>,
    pub(super) looks: Vec<Look>,
    last: Option<Look>,
    still: u32,
}

impl Seen {
    fn watch(&mut self, look: Look, within: Within, is_look: bool) {
        if is_look {
            self.looks.push(look);
        }
        self.still = if self.last == Some(look) {
            self.still + 1
        } else {
            0
        };
        self.last = Some(look);
        let is_another = |last: &Look| !last.is_near(&look, within);
        if self.still == REST_STEPS && self.rests.last().is_none_or(is_another) {
            self.rests.push(look);
        }
    }
}

/// Plays a program's packets step by step.
struct Play<'a> {
    /// The last one first.
    packets: Vec<&'a RecordedPacket>,
    one_per_status: bool,
}

impl<'a> Play<'a> {
    fn new(program: &'a Program, is_played: impl Fn(&RecordedPacket) -> bool) -> Self {
        let packets = program.packets.iter().rev();
        Self {
            packets: packets.filter(|packet| is_played(packet)).collect(),
            one_per_status: program.one_per_status,
        }
    }

    /// Returns the packets due at that time, after this many statuses.
    fn due(&mut self, now: Duration, statuses: usize) -> Vec<&'a RecordedPacket> {
        let most = if self.one_per_status {
            statuses
        } else {
            usize::MAX
        };
        let mut due = Vec::new();
        while due.len() < most {
            let is_due = |packet: &mut &RecordedPacket| Duration::from_millis(packet.at_ms) <= now;
            match self.packets.pop_if(is_due) {
                Some(packet) => due.push(packet),
                None => break,
            }
        }
        due
    }
}

fn steps(program: &Program) -> impl Iterator<Item = (Duration, bool)> + use<'_> {
    let times = (0..=program.end_ms / STEP_MS).map(|step| step * STEP_MS);
    times.map(|ms| (Duration::from_millis(ms), program.looks_ms.contains(&ms)))
}

fn power_up(program: &Program) -> PowerUp {
    let [rear_deg, fore_deg] = program.pose_deg;
    PowerUp::new(PERSONALITY).with_tilt(rear_deg, fore_deg)
}

/// Plays the program on an arm without a station, leaving out what a station would refuse.
pub(super) fn at_a_bare_arm(program: &Program) -> (Seen, Vec<Refused>) {
    at_an_arm(program, |packet| packet.refused.is_none())
}

/// Returns whether a program up to a packet makes a stock arm hang or lose its pose, but not
/// without that packet.
pub(super) fn is_trapped_by(program: &Program, trap: &RecordedPacket) -> bool {
    let before = |packet: &RecordedPacket| packet.refused.is_none() && packet.at_ms <= trap.at_ms;
    let is_lost = |refused: &Refused| matches!(refused, Refused::Hangs(_) | Refused::PoseLost);
    let with_it = |packet: &RecordedPacket| before(packet) || std::ptr::eq(packet, trap);
    !at_an_arm(program, before).1.iter().any(is_lost)
        && at_an_arm(program, with_it).1.iter().any(is_lost)
}

/// Returns the observations of an arm, and what it did not do.
fn at_an_arm(
    program: &Program,
    is_played: impl Fn(&RecordedPacket) -> bool,
) -> (Seen, Vec<Refused>) {
    let controller = Controller::power_up(power_up(program));
    let mut arm = VirtualArm::new(controller, SerialLine::STOCK);
    let mut decoder: Decoder<Statuses> = Decoder::statuses(plausible);
    let mut play = Play::new(program, is_played);
    let mut seen = Seen::default();
    for (now, is_look) in steps(program) {
        arm.handle_time(now);
        let mut bytes = Vec::new();
        arm.poll_bytes(&mut bytes);
        let statuses = decoder.feed(&bytes).count();
        for packet in play.due(now, statuses) {
            arm.handle_bytes(now, &packet.frame().to_bytes());
        }
        seen.watch(Look::of(&arm), program.within, is_look);
    }
    let refused = std::iter::from_fn(|| arm.poll_refused()).collect();
    (seen, refused)
}

/// The station's handling of a program.
pub(super) struct Served {
    pub(super) seen: Seen,
    /// The packets that the arm got since the program connected.
    pub(super) got: Vec<Frame>,
    /// The reports for each packet: whether it was refused, and the texts.
    pub(super) reports: Vec<(bool, Vec<String>)>,
    /// All that was amended, refused or failed.
    pub(super) troubles: Vec<String>,
}

/// Plays the program at the raw port of a station with the default policy.
pub(super) fn at_a_station(program: &Program) -> Served {
    let mut station = VirtualStation::new(power_up(program), Policy::default());
    let client = station.client("a raw program");
    let mut play = Play::new(program, |_| true);
    let mut served = Served {
        seen: Seen::default(),
        got: Vec::new(),
        reports: Vec::new(),
        troubles: Vec::new(),
    };
    for (now, is_look) in steps(program) {
        if now > station.now() {
            station.run_for(Duration::from_millis(STEP_MS));
        }
        let permits = usize::from(station.poll_status() && station.supervisor().permits_raw());
        for packet in play.due(now, permits) {
            served.reports.push(send(&mut station, client, packet));
        }
        served
            .seen
            .watch(Look::of(station.arm()), program.within, is_look);
    }
    served.got = station
        .packets()
        .iter()
        .map(|(_, bytes)| Frame::from_bytes(bytes).expect("no voice"))
        .collect();
    served.troubles = troubles(&station, 0);
    served
}

fn send(
    station: &mut VirtualStation,
    client: ClientId,
    packet: &RecordedPacket,
) -> (bool, Vec<String>) {
    let before = station.notices().len();
    let is_refused = station.send_raw(client, &packet.frame().into()).is_err();
    (is_refused, troubles(station, before))
}

fn troubles(station: &VirtualStation, from: usize) -> Vec<String> {
    let is_trouble = |news: &News| {
        matches!(
            news,
            News::Amended { .. }
                | News::Refused { .. }
                | News::CommandFailed { .. }
                | News::DeadMan
                | News::LinkLost
                | News::NoLink { .. }
                | News::Reset
                | News::Trouble
        )
    };
    let notices = station.notices()[from..].iter();
    let troubles = notices.filter(|notice| is_trouble(&notice.news));
    troubles.map(|notice| notice.text.clone()).collect()
}
