//! What the station tells all the time.

use dobot_wire::{Dialect, Status};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{FleetWideStop, JobView, LeaseView, NearView, SlotsView};

/// All that the station knows at one moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct State {
    /// The time since the station started, in seconds.
    pub at_s: f64,
    /// The way to the arm.
    pub link: LinkView,
    /// What the arm told last; absent until it has told anything.
    pub arm: Option<ArmView>,
    /// The calibration by which places are told, if the arm has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibrated: Option<CalibratedView>,
    /// The dialect that the arm speaks, if that is known.
    pub dialect: Option<Dialect>,
    /// Whether the pose can be trusted.
    pub trust: TrustView,
    /// What the arm has still to do.
    pub queue: QueueView,
    /// Who has control, if anybody has.
    pub lease: Option<LeaseView>,
    /// The lock that holds the arm for administrators, if one does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lock: Option<LockView>,
    /// Whose time it is now and next, where the arm has time slots.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slots: Option<SlotsView>,
    /// The stop that holds the arm, if one does.
    pub stop: Option<StopView>,
    /// The stops of the whole fleet that the station knows of, at most one of each station that made one. Those that were
    /// reset are kept too, for stations that come back and do not know it yet.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fleet_stops: Vec<FleetWideStop>,
    /// The laser's interlock.
    pub laser: LaserView,
    /// The job that runs or is paused.
    pub job: Option<JobView>,
    /// What is missing of the kept jobs and what to do, if the file in which they are kept was damaged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jobs_missing: Option<String>,
    /// How many clients are connected.
    pub clients: usize,
}

impl State {
    /// An arm at rest that nobody controls, for tests and documentation: a minute after the station started, over a serial
    /// port, in the dialect of the specification.
    ///
    /// ```
    /// use dobot_api::State;
    ///
    /// let state = State { clients: 2, ..State::sample() };
    /// assert!(state.trust.trusted && state.stop.is_none());
    /// ```
    #[must_use]
    pub fn sample() -> Self {
        Self {
            at_s: 61.0,
            link: LinkView {
                address: Some("serial:/dev/ttyUSB0@9600".to_owned()),
                phase: LinkPhase::Up,
                problem: None,
                bluetooth: false,
                statuses_per_s: 12.5,
                lost_statuses: 0,
                damaged_bytes: 0,
                latency_ms: Some(46.0),
            },
            arm: Some(ArmView {
                status: Status {
                    x_mm: 220.0,
                    y_mm: 0.0,
                    z_mm: 30.0,
                    rotation_deg: 15.0,
                    base_deg: 0.0,
                    rear_deg: 40.0,
                    fore_deg: 45.0,
                    servo_deg: 15.0,
                    suction: true,
                    gripper_deg: 12.0,
                },
                told: None,
                moving: false,
                near: NearView::default(),
            }),
            calibrated: None,
            dialect: Some(Dialect::SPECIFICATION),
            trust: TrustView {
                trusted: true,
                reason: None,
            },
            queue: QueueView {
                waiting: 0,
                under_way: 0,
                ahead_s: 0.0,
            },
            lease: None,
            lock: None,
            slots: None,
            stop: None,
            fleet_stops: Vec::new(),
            laser: LaserView {
                armed_for_s: 0.0,
                on: false,
            },
            job: None,
            jobs_missing: None,
            clients: 1,
        }
    }
}

/// The way to the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LinkView {
    /// Where the arm is reached: an address, or nothing yet.
    pub address: Option<String>,
    /// How far the link is.
    pub phase: LinkPhase,
    /// What is wrong with it and what to do, if anything is.
    pub problem: Option<String>,
    /// Whether it leads to the Bluetooth port of a stock arm: its statuses tell so, and joint jogs have
    /// other axes there, to which they are translated.
    #[serde(default)]
    pub bluetooth: bool,
    /// Statuses in a second, of 12.5; of 18.75 over Bluetooth.
    pub statuses_per_s: f64,
    /// Statuses that should have come and did not, since the connect.
    pub lost_statuses: u64,
    /// Bytes that belong to no status, since the connect.
    pub damaged_bytes: u64,
    /// From a command to the first status that shows it, in milliseconds, where that is known.
    pub latency_ms: Option<f64>,
}

/// How far the link is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LinkPhase {
    /// No arm has been found yet.
    Searching,
    /// The port is open, but no status has come.
    Listening,
    /// Statuses come.
    Up,
    /// Statuses came, and do not any more.
    Lost,
}

/// What the arm told last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ArmView {
    /// The status; of a calibrated arm with its true places and angles.
    #[serde(flatten)]
    pub status: Status,
    /// What a calibrated arm says itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub told: Option<Status>,
    /// Whether it moves.
    pub moving: bool,
    /// The limits and keep-outs of the policy that it is near to.
    #[serde(default, skip_serializing_if = "NearView::is_empty")]
    pub near: NearView,
}

/// By which calibration places are told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CalibratedView {
    /// Whether the arm was told its true angles (state 9, mode 3) since it was switched on: then only its tool
    /// is elsewhere than it says.
    pub zeros_told: bool,
}

/// Whether the pose can be trusted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TrustView {
    /// It can.
    pub trusted: bool,
    /// Why not.
    pub reason: Option<String>,
}

/// What the arm has still to do.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct QueueView {
    /// Commands that wait in the station.
    pub waiting: usize,
    /// Commands sent and not seen to be over.
    pub under_way: usize,
    /// How long those under way still take, in seconds, by the motion model.
    pub ahead_s: f64,
}

/// A lock: only an administrator gets control of the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LockView {
    /// Who locked it.
    pub by: String,
    /// Why, for those who want to move the arm.
    pub message: Option<String>,
    /// When, in seconds since the station started.
    pub at_s: f64,
}

/// A stop that holds the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StopView {
    /// Who stopped it.
    pub by: String,
    /// Why.
    pub reason: Option<String>,
    /// When, in seconds since the station started.
    pub at_s: f64,
    /// By when the arm was promised to be at rest, in seconds since the station started.
    pub rests_by_s: f64,
    /// Whether it has been seen at rest since.
    pub at_rest: bool,
    /// Whether the packets that stop it have left this computer: if not, it has to be switched off by hand.
    #[serde(default = "delivered")]
    pub delivered: bool,
    /// Whether it is a stop of the whole fleet.
    #[serde(default)]
    pub of_fleet: bool,
}

impl StopView {
    /// Who stopped the arm and why, as a person reads it.
    #[must_use]
    pub fn text(&self) -> String {
        let by = if self.of_fleet {
            format!("stopped: fleet, by {}", self.by)
        } else {
            format!("stopped by {}", self.by)
        };
        with_reason(by, self.reason.as_deref())
    }
}

/// A text, followed by its reason if there is one.
pub(crate) fn with_reason(text: String, reason: Option<&str>) -> String {
    match reason {
        Some(reason) => format!("{text}: {reason}"),
        None => text,
    }
}

/// A station of before this field says nothing else.
const fn delivered() -> bool {
    true
}

/// The laser's interlock.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LaserView {
    /// For how long it may still be switched on, in seconds; 0 when it is disarmed.
    pub armed_for_s: f64,
    /// Whether the laser of the arm may be on, as its dialect has it: from when it was sent what burns
    /// until that is over, or what switches the laser off had time to act.
    pub on: bool,
}
