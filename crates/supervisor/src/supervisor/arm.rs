//! The supervisor's view of the arm: its session, its policy and where it was seen.

use std::iter;
use std::time::Duration;

use dobot_api::{CalibratedView, NearView, PathPreview};
use dobot_arm::{Calibration, Pose, Tool};
use dobot_calibrate::Approach;
use dobot_motion::{ArmPlace, Model, Trajectory, TrajectoryError};
use dobot_safety::{Policy, Violation};
use dobot_session::{CommandId, SendError, Session};
use dobot_wire::{Command, Dialect, Packet, Status, single};

use super::near::near;
use super::seconds;
use super::urgent::UrgentQueue;
use crate::refusal::Refusal;

/// The arm at the current time, which never decreases. Everything sent to it passes here.
#[derive(Debug)]
pub(super) struct Arm {
    session: Session,
    policy: Policy,
    now: Duration,
    line: UrgentQueue,
    last: Option<Status>,
    /// The calibration that applies after power-up.
    calibration: Calibration,
    /// The last turn of base, rear arm and forearm, each when it last moved, in degrees.
    turned_deg: [f64; 3],
    approach: Approach,
    /// The number of consecutive equal statuses since the last motion was sent.
    still: u32,
    /// The number of motions sent before the last status.
    motions_sent: u64,
}

impl Arm {
    pub(super) fn new(policy: Policy, dialect: Option<Dialect>) -> Self {
        let mut session = Session::trusted(dialect);
        session.set_ahead(seconds(policy.queue.ahead_s));
        session.set_laser_may_stand(policy.laser.standing);
        Self {
            session,
            policy,
            now: Duration::ZERO,
            line: UrgentQueue::default(),
            last: None,
            calibration: Calibration::NONE,
            turned_deg: [0.0; 3],
            approach: Approach::default(),
            still: 0,
            motions_sent: 0,
        }
    }

    pub(super) const fn session(&self) -> &Session {
        &self.session
    }

    /// Returns the session for the supervisor; components use the read-only getter.
    pub(super) const fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    pub(super) const fn policy(&self) -> &Policy {
        &self.policy
    }

    pub(super) fn set_policy(&mut self, policy: Policy) {
        self.session.set_ahead(seconds(policy.queue.ahead_s));
        self.session.set_laser_may_stand(policy.laser.standing);
        self.policy = policy;
    }

    pub(super) const fn now(&self) -> Duration {
        self.now
    }

    pub(super) fn set_calibration(&mut self, calibration: Calibration) {
        // The arm may have been given its angles since this calibration was set.
        if calibration != self.calibration {
            self.calibration = calibration;
            self.session.set_calibration(calibration);
        }
    }

    /// Returns the calibration that applies now.
    pub(super) fn calibration(&self) -> Calibration {
        let model = self.session.model();
        model.map_or(self.calibration, |model| model.calibration)
    }

    pub(super) fn is_calibrated(&self) -> bool {
        !self.calibration.is_none()
    }

    pub(super) fn calibrated_view(&self) -> Option<CalibratedView> {
        let angles_set = self.calibration() != self.calibration;
        self.is_calibrated()
            .then_some(CalibratedView { angles_set })
    }

    /// Returns why the pose may not be recorded as a touch of a calibration.
    pub(super) fn touch_refused(&self) -> Option<String> {
        self.approach.check().err().map(|why| why.to_string())
    }

    /// Returns the status with calibrated positions and angles.
    pub(super) fn calibrated_status(&self, raw: &Status) -> Status {
        let Some(model) = self.session.model().filter(|_| self.is_calibrated()) else {
            return *raw;
        };
        let mut place = ArmPlace::of_status(raw);
        // A joint with backlash that last turned back stands further than its motor reports.
        let arm = &model.calibration;
        place.joints = arm.joints_at(&place.joints, self.turned_deg);
        let place = model.calibrated_place(&place);
        Status {
            suction: raw.suction,
            gripper_deg: raw.gripper_deg,
            ..place.status()
        }
    }

    /// Returns the calibrated status after everything the arm was given; `None` before the first
    /// status.
    pub(super) fn end_status(&self) -> Option<Status> {
        if self.is_idle() {
            return self.last.map(|last| self.calibrated_status(&last));
        }
        let model = self.session.model()?;
        Some(Status {
            suction: model.suction,
            gripper_deg: single(model.gripper_deg),
            ..model.calibrated_place(&model.place).status()
        })
    }

    /// Returns the limits and keep-outs close to a calibrated position.
    pub(super) fn near(&self, place: &ArmPlace) -> NearView {
        near(&self.policy, place, self.tool())
    }

    /// Returns the limits and keep-outs that would be close with the tool at a pose.
    pub(super) fn near_at(&self, pose: Pose) -> Result<NearView, Refusal> {
        let place = ArmPlace::at_pose(pose, self.tool()).map_err(|error| {
            Refusal::from(Violation::of_trajectory(&TrajectoryError::Unreachable(
                error,
            )))
        })?;
        Ok(self.near(&place))
    }

    /// Returns the commands that give the settings and the tool of this arm to one that was just
    /// switched on.
    pub(super) fn settings(&self) -> Vec<Command> {
        let model = self.session.model().into_iter();
        model.flat_map(Model::configuration).collect()
    }

    fn tool(&self) -> Tool {
        self.session
            .model()
            .map_or(Tool::default(), |model| model.tool)
    }

    /// Converts a command with calibrated positions to a raw command.
    pub(super) fn raw_command(&self, command: &Command) -> Result<Command, Refusal> {
        let Some(model) = self.session.model() else {
            return Ok(*command);
        };
        model.to_raw(command).map_err(|error| {
            Refusal::from(Violation::of_trajectory(&TrajectoryError::Unreachable(
                error,
            )))
        })
    }

    /// Returns the last status.
    pub(super) const fn last(&self) -> Option<Status> {
        self.last
    }

    /// Returns the number of consecutive equal statuses since the last motion was sent.
    pub(super) const fn still(&self) -> u32 {
        self.still
    }

    /// Sets the time without doing what is due.
    pub(super) fn set_time(&mut self, now: Duration) {
        self.now = self.now.max(now);
    }

    pub(super) fn handle_time(&mut self, now: Duration) {
        self.set_time(now);
        self.session.handle_time(self.now);
    }

    pub(super) fn handle_bytes(&mut self, bytes: &[u8]) {
        self.session.handle_bytes(self.now, bytes);
    }

    pub(super) fn handle_open(&mut self) {
        self.session.handle_open(self.now);
        self.still = 0;
    }

    pub(super) fn handle_status(&mut self, status: Status) {
        let motions = self.session.motions_sent();
        let is_new_motion = std::mem::replace(&mut self.motions_sent, motions) != motions;
        self.still = if self.last == Some(status) && !is_new_motion {
            self.still + 1
        } else {
            0
        };
        self.approach
            .handle_status(&ArmPlace::of_status(&status).joints);
        if let Some(last) = self.last.replace(status) {
            let turned = [
                status.base_deg - last.base_deg,
                status.rear_deg - last.rear_deg,
                status.fore_deg - last.fore_deg,
            ];
            for (before, turned) in self.turned_deg.iter_mut().zip(turned) {
                if turned.abs() > TURNS_DEG {
                    *before = turned.into();
                }
            }
        }
    }

    /// Forgets that the arm was seen at rest.
    pub(super) const fn forget_rest(&mut self) {
        self.still = 0;
    }

    /// Returns whether the arm is at rest: no command waits or is in flight, no button is held, and the statuses
    /// since the last motion was sent are equal.
    pub(super) fn is_at_rest(&self) -> bool {
        self.still >= AT_REST && self.is_idle() && !self.session.is_jogging()
    }

    /// Returns whether a press has to wait. An arm at rest may still have to receive repetitions of the last
    /// release; a press can follow them as soon as the line is free.
    pub(super) fn is_busy(&self) -> bool {
        self.session.is_moving() && !(self.is_at_rest() && self.line_wakeup().is_none())
    }

    /// Returns whether no command waits or is in flight, as far as the session has reported.
    pub(super) fn is_idle(&self) -> bool {
        self.session.in_flight() == 0 && self.session.waiting() == 0
    }

    /// Returns the time until the arm is at rest if nothing more is sent and a held button is
    /// released now. `unknown` is the duration of motion that the session does not know of.
    pub(super) fn rests_within(&self, unknown: Duration) -> Duration {
        let within = self.session.rests_within();
        if within < Duration::MAX {
            return within.max(unknown);
        }
        let run_down_s = self.session.model().map_or(0.0, |model| {
            let teach = model.settings.teach;
            let joint_s = teach.joint_deg_s / teach.joint_deg_s2;
            joint_s.max(teach.line_mm_s / teach.line_mm_s2)
        });
        seconds(run_down_s) + RELEASE_TIME
    }

    /// Checks that the pose is trusted.
    pub(super) fn check_trust(&self) -> Result<(), Refusal> {
        if self.session.is_trusted() {
            return Ok(());
        }
        Err(Refusal::Send(SendError::Untrusted))
    }

    /// Queues a command if its whole path is allowed.
    pub(super) fn send(&mut self, command: &Command) -> Result<CommandId, Refusal> {
        self.check_way(command)?;
        Ok(self.session.send(*command)?)
    }

    fn check_way(&self, command: &Command) -> Result<(), Refusal> {
        self.session.check(command)?;
        if let Some(model) = self.session.model() {
            self.policy.check(model, command)?;
        }
        Ok(())
    }

    /// Returns the path a command would take if sent now, if all of it is allowed.
    pub(super) fn preview(&self, command: &Command) -> Result<PathPreview, Refusal> {
        self.session.check(command)?;
        let Some(model) = self.session.model() else {
            return Err(Refusal::NoLink("no status has come yet".to_owned()));
        };
        let trajectory = self.policy.check(model, command)?;
        Ok(path_preview(model, &trajectory)?)
    }

    /// Sends a command before all waiting ones.
    pub(super) fn send_urgent(&mut self, command: Command) {
        if let Ok(packet) = self.session.emit_now(&command) {
            self.session.note_urgent(&command);
            self.line.push(packet);
        }
    }

    /// Sends a packet of a detection. Its settings count as applied: a detection that ends early
    /// leaves the arm with them.
    pub(super) fn send_question(&mut self, packet: Packet) {
        let dialect = self.session.dialect().unwrap_or(&Dialect::SPECIFICATION);
        let command = Command::parse(&packet, dialect);
        if let Ok(setting @ (Command::Configuration(_) | Command::PlaybackAdjustment(_))) = command
        {
            self.session.note_urgent(&setting);
        }
        self.line.push(packet);
    }

    /// Sends a command before everything else without waiting for the line; drops earlier urgent
    /// packets.
    pub(super) fn send_first(&mut self, command: Command) {
        self.line.clear();
        self.send_urgent(command);
        self.line.hurry();
    }

    /// Sends an urgent command without waiting for the line.
    pub(super) fn send_at_once(&mut self, command: Command) {
        self.send_urgent(command);
        self.line.hurry();
    }

    /// Makes the session's pending packets urgent, in order.
    pub(super) fn hasten(&mut self) {
        while let Some(packet) = self.session.poll_bytes() {
            self.line.push(packet);
        }
    }

    /// Releases the button sent last; returns whether there was one.
    pub(super) fn release_urgently(&mut self) -> bool {
        let release = self.session.release();
        if let Some(release) = release {
            self.send_urgent(release);
        }
        release.is_some()
    }

    pub(super) fn poll_bytes(&mut self) -> Option<Packet> {
        self.line.poll(self.now, &mut self.session)
    }

    pub(super) fn is_urgent(&self) -> bool {
        !self.line.is_empty()
    }

    /// Returns when the line is free again, while something waits for it.
    pub(super) fn line_wakeup(&self) -> Option<Duration> {
        self.line.wakeup(self.now)
    }
}

/// Builds a path preview.
fn path_preview(model: &Model, trajectory: &Trajectory) -> Result<PathPreview, Violation> {
    let place_at = |t_s| {
        let place = trajectory.place_at(t_s);
        let place = place.map_err(|error| Violation::of_trajectory(&error.into()))?;
        Ok::<_, Violation>(model.calibrated_place(&place))
    };
    let (parts, duration_s) = match trajectory.motion_s() {
        Some(duration_s) if trajectory.moves() => (PATH_PARTS, duration_s),
        _ => (0, 0.0),
    };
    let times = (1..=parts).map(|part| duration_s * f64::from(part) / f64::from(PATH_PARTS));
    let way = times.map(place_at).collect::<Result<Vec<_>, _>>()?;
    let start = model.calibrated_place(&model.place);
    let end = way.last().unwrap_or(&start);
    let point = |place: &ArmPlace| {
        let at = place.pose.position;
        [at.x, at.y, at.z].map(|mm| mm.0)
    };
    let joints = end.joints;
    Ok(PathPreview {
        takes_s: trajectory.duration_s(),
        joints_deg: [joints.base, joints.rear, joints.fore, joints.servo].map(|angle| angle.0),
        path_mm: iter::once(&start).chain(&way).map(point).collect(),
    })
}

/// A joint that turned by less than this, in degrees, may not have turned.
const TURNS_DEG: f32 = 0.005;
/// After this many equal statuses in a row the arm is at rest: a motion shows in the third status after its packet.
const AT_REST: u32 = 3;
/// The time for laser off, a gap and the release, sent twice, on the line and in a tick of the arm.
const RELEASE_TIME: Duration = Duration::from_millis(700);
/// The number of equal time intervals in a path preview.
const PATH_PARTS: u32 = 48;
