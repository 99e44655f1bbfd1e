//! The state published by the station.

use dobot_wire::{Command, Dialect, Status};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{ClientId, Device, FleetWideStop, JobView, LeaseView, LinkCause, NearView, SlotsView};

/// The state of the station at one moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct State {
    /// The time since the station started, in seconds.
    pub at_s: f64,
    /// The link to the arm.
    pub link: LinkView,
    /// The arm's last status; absent until one has arrived.
    pub arm: Option<ArmView>,
    /// The calibration used for positions, if the arm has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibrated: Option<CalibratedView>,
    /// The dialect that the arm speaks, if known.
    pub dialect: Option<Dialect>,
    /// The commands that give the arm's current settings (speeds, heights, pauses and tool) to an
    /// arm that was just switched on; absent if it has the settings of power-up.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub settings: Vec<Command>,
    /// Whether the pose can be trusted.
    pub trust: TrustView,
    /// The command queue.
    pub queue: QueueView,
    /// The lease holder, if any.
    pub lease: Option<LeaseView>,
    /// The administrators' lock, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lock: Option<LockView>,
    /// The current and next time slot, if the arm has any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slots: Option<SlotsView>,
    /// The stop that holds the arm, if any.
    pub stop: Option<StopView>,
    /// The known fleet-wide stops, at most one per station of origin. Stops that were reset are
    /// kept for stations that return and do not know it yet.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fleet_stops: Vec<FleetWideStop>,
    /// The laser's interlock.
    pub laser: LaserView,
    /// The running or paused job.
    pub job: Option<JobView>,
    /// What is missing of the stored jobs and what to do, if their file was damaged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jobs_missing: Option<String>,
    /// The number of connected clients.
    pub clients: usize,
}

impl State {
    /// Returns the state of an arm at rest with control free, for tests and documentation: a minute
    /// after the station started, over a serial port, in the dialect of the specification.
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
                cause: None,
                remedy: None,
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
                raw: None,
                moving: false,
                touch_refused: None,
                near: NearView::default(),
            }),
            calibrated: None,
            dialect: Some(Dialect::SPECIFICATION),
            settings: Vec::new(),
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

    /// Returns the state without what changes all the time: the arm's status, clocks, remaining times and link figures.
    /// Two states that are equal without them differ only in readings.
    #[must_use]
    pub fn without_readings(&self) -> Self {
        let mut state = self.clone();
        state.at_s = 0.0;
        state.link.statuses_per_s = 0.0;
        state.link.lost_statuses = 0;
        state.link.damaged_bytes = 0;
        state.link.latency_ms = None;
        state.queue.ahead_s = 0.0;
        state.laser.armed_for_s = state.laser.armed_for_s.signum().max(0.0);
        if let Some(arm) = &mut state.arm {
            arm.status = NO_STATUS;
            arm.near = NearView::default();
        }
        if let Some(job) = &mut state.job {
            job.left_s = None;
        }
        state
    }
}

/// In the place of a status that does not count.
const NO_STATUS: Status = Status {
    x_mm: 0.0,
    y_mm: 0.0,
    z_mm: 0.0,
    rotation_deg: 0.0,
    base_deg: 0.0,
    rear_deg: 0.0,
    fore_deg: 0.0,
    servo_deg: 0.0,
    suction: false,
    gripper_deg: 0.0,
};

/// The link to the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LinkView {
    /// The address of the arm; absent if there is none yet.
    pub address: Option<String>,
    /// The phase of the link.
    pub phase: LinkPhase,
    /// What is wrong, if anything.
    pub problem: Option<String>,
    /// Its kind, for programs.
    pub cause: Option<LinkCause>,
    /// What to do about it.
    pub remedy: Option<String>,
    /// Whether the link uses the Bluetooth port of a stock arm, as detected from its statuses. Its
    /// joint jogs have other axes, to which jogs are translated.
    #[serde(default)]
    pub bluetooth: bool,
    /// Statuses per second; nominally 12.5, or 18.75 over Bluetooth.
    pub statuses_per_s: f64,
    /// Missing statuses since the link was opened.
    pub lost_statuses: u64,
    /// Bytes that belong to no status, since the link was opened.
    pub damaged_bytes: u64,
    /// The time from a command to the first status that shows it, in milliseconds, if known.
    pub latency_ms: Option<f64>,
}

/// The phase of the link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LinkPhase {
    /// No arm has been found yet.
    Searching,
    /// The port is open, but no status has arrived.
    Listening,
    /// Statuses arrive.
    Up,
    /// Statuses have stopped arriving.
    Lost,
}

/// The arm's last status.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ArmView {
    /// The status; for a calibrated arm, with calibrated positions and angles.
    #[serde(flatten)]
    pub status: Status,
    /// The raw status of a calibrated arm.
    #[serde(default, alias = "told", skip_serializing_if = "Option::is_none")]
    pub raw: Option<Status>,
    /// Whether the arm moves or may still move; otherwise it is at rest: no command waits or is in flight, no
    /// button is held, and the last statuses are equal.
    pub moving: bool,
    /// Why the pose may not be recorded as a touch of a calibration: a joint came from the other side.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub touch_refused: Option<String>,
    /// The policy limits and keep-outs close to the arm.
    #[serde(default, skip_serializing_if = "NearView::is_empty")]
    pub near: NearView,
}

/// The calibration used for positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CalibratedView {
    /// Whether the arm was given its true angles (state 9, mode 3) since it was switched on: then
    /// only its tool is offset from what it reports.
    #[serde(alias = "zeros_told")]
    pub angles_set: bool,
}

/// Whether the pose can be trusted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TrustView {
    /// Whether it can.
    pub trusted: bool,
    /// The reason if not.
    pub reason: Option<String>,
}

/// The command queue.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct QueueView {
    /// Commands waiting in the station.
    pub waiting: usize,
    /// In-flight commands: sent and not yet seen to be over.
    pub under_way: usize,
    /// The remaining time of the in-flight commands, in seconds (motion model).
    pub ahead_s: f64,
}

/// A lock: only an administrator can take control of the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LockView {
    /// Who locked it.
    pub by: String,
    /// The reason, shown to clients that want to move the arm.
    pub message: Option<String>,
    /// When it was set, in seconds since the station started.
    pub at_s: f64,
}

/// A stop that holds the arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StopView {
    /// The name of who stopped it.
    pub by: String,
    /// The device of a page that stopped it; absent for a program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device: Option<Device>,
    /// The client that stopped it, if it was one of this station since it started.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub client: Option<ClientId>,
    /// The reason.
    pub reason: Option<String>,
    /// When it was set, in seconds since the station started.
    pub at_s: f64,
    /// When the arm is due to be at rest, in seconds since the station started.
    pub rests_by_s: f64,
    /// Whether the arm has been seen at rest since.
    pub at_rest: bool,
    /// Whether the stop packets have left this computer: if not, switch the arm off by hand.
    #[serde(default = "delivered")]
    pub delivered: bool,
    /// Whether it is a fleet-wide stop.
    #[serde(default)]
    pub of_fleet: bool,
}

impl StopView {
    /// Returns who stopped the arm and why, as text.
    #[must_use]
    pub fn text(&self) -> String {
        let who = Device::named(&self.by, self.device);
        let by = if self.of_fleet {
            format!("stopped: fleet, by {who}")
        } else {
            format!("stopped by {who}")
        };
        with_reason(by, self.reason.as_deref())
    }
}

/// Appends the reason, if any.
pub(crate) fn with_reason(text: String, reason: Option<&str>) -> String {
    match reason {
        Some(reason) => format!("{text}: {reason}"),
        None => text,
    }
}

/// Older stations do not send this field: their stops count as delivered.
const fn delivered() -> bool {
    true
}

/// The laser's interlock.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LaserView {
    /// The time for which it may still be switched on, in seconds; 0 when it is disarmed.
    pub armed_for_s: f64,
    /// Whether the arm's laser may be on, by its dialect: from the sending of a burning command
    /// until it is over or a laser-off has had time to take effect.
    pub on: bool,
}
