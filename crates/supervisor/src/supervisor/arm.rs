//! The arm as the supervisor has it: the conversation with it, what it may do, and where it was seen.

use std::iter;
use std::time::Duration;

use dobot_api::{CalibratedView, NearView, PathPreview};
use dobot_arm::{Calibration, Pose, Tool};
use dobot_motion::{ArmPlace, Model, Trajectory, TrajectoryError};
use dobot_safety::{Policy, Violation};
use dobot_session::{CommandId, SendError, Session};
use dobot_wire::{Command, Dialect, Packet, Status, single};

use super::near::near;
use super::seconds;
use super::urgent::UrgentQueue;
use crate::refusal::Refusal;

/// The arm, at a time that never goes back. Whatever is sent to it goes this way.
#[derive(Debug)]
pub(super) struct Arm {
    session: Session,
    policy: Policy,
    now: Duration,
    line: UrgentQueue,
    last: Option<Status>,
    /// How it differs from the drawing of it when it has just been switched on.
    calibration: Calibration,
    /// How far base, rear arm and forearm turned last, each when it did, in degrees.
    turned_deg: [f64; 3],
    /// How many statuses in a row told the same place.
    still: u32,
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
            still: 0,
        }
    }

    pub(super) const fn session(&self) -> &Session {
        &self.session
    }

    /// The conversation itself, for the supervisor: the parts only ask it.
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
        // One that holds already may have been told its angles since.
        if calibration != self.calibration {
            self.calibration = calibration;
            self.session.set_calibration(calibration);
        }
    }

    /// How it differs from what it says now.
    pub(super) fn calibration(&self) -> Calibration {
        let model = self.session.model();
        model.map_or(self.calibration, |it| it.calibration)
    }

    pub(super) fn is_calibrated(&self) -> bool {
        !self.calibration.is_none()
    }

    pub(super) fn calibrated_view(&self) -> Option<CalibratedView> {
        let zeros_told = self.calibration() != self.calibration;
        self.is_calibrated()
            .then_some(CalibratedView { zeros_told })
    }

    /// The status with the true places and angles in place of what the arm says.
    pub(super) fn true_status(&self, told: &Status) -> Status {
        let Some(model) = self.session.model().filter(|_| self.is_calibrated()) else {
            return *told;
        };
        let mut place = ArmPlace::of_status(told);
        // A slack joint that was turned back last stands further than its motor says.
        let arm = &model.calibration;
        place.joints = arm.joints_at(&place.joints, self.turned_deg);
        let place = model.calibrated_place(&place);
        Status {
            suction: told.suction,
            gripper_deg: told.gripper_deg,
            ..place.status()
        }
    }

    /// The status of the arm when all that it was given is over, with its true places and angles; `None` before the first
    /// status.
    pub(super) fn end_status(&self) -> Option<Status> {
        if self.is_idle() {
            return self.last.map(|last| self.true_status(&last));
        }
        let model = self.session.model()?;
        Some(Status {
            suction: model.suction,
            gripper_deg: single(model.gripper_deg),
            ..model.calibrated_place(&model.place).status()
        })
    }

    /// The limits and keep-outs that it is near to at a true place.
    pub(super) fn near(&self, place: &ArmPlace) -> NearView {
        near(&self.policy, place, self.tool())
    }

    /// The limits and keep-outs that it would be near to with its tool there.
    pub(super) fn near_at(&self, pose: Pose) -> Result<NearView, Refusal> {
        let place = ArmPlace::at_pose(pose, self.tool()).map_err(|error| {
            Refusal::from(Violation::of_trajectory(&TrajectoryError::Unreachable(
                error,
            )))
        })?;
        Ok(self.near(&place))
    }

    fn tool(&self) -> Tool {
        self.session.model().map_or(Tool::default(), |it| it.tool)
    }

    /// What the arm has to be told for a command that speaks of true places.
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

    /// The status that came last.
    pub(super) const fn last(&self) -> Option<Status> {
        self.last
    }

    /// How many statuses in a row told the same place.
    pub(super) const fn still(&self) -> u32 {
        self.still
    }

    /// Takes what time it is, without doing what is due.
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
        self.still = if self.last == Some(status) {
            self.still + 1
        } else {
            0
        };
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

    /// Nothing tells any more that it rests.
    pub(super) const fn lose_sight(&mut self) {
        self.still = 0;
    }

    /// Whether it was seen at rest for a while, after all that it was sent.
    pub(super) fn is_at_rest(&self) -> bool {
        self.still >= AT_REST && self.session.in_flight() == 0
    }

    /// Whether nothing waits and nothing is under way, as far as the session has told.
    pub(super) fn is_idle(&self) -> bool {
        self.session.in_flight() == 0 && self.session.waiting() == 0
    }

    /// By when it is at rest if nothing more is sent, where what the session does not know of takes so
    /// long; a button that is held is let go now.
    pub(super) fn rests_within(&self, unknown: Duration) -> Duration {
        let within = self.session.rests_within();
        if within < Duration::MAX {
            return within.max(unknown);
        }
        let run_down_s = self.session.model().map_or(0.0, |it| {
            let teach = it.settings.teach;
            let joint_s = teach.joint_deg_s / teach.joint_deg_s2;
            joint_s.max(teach.line_mm_s / teach.line_mm_s2)
        });
        seconds(run_down_s) + HEARD_WITHIN
    }

    /// Whether it is where it says.
    pub(super) fn check_trust(&self) -> Result<(), Refusal> {
        if self.session.is_trusted() {
            return Ok(());
        }
        Err(Refusal::Send(SendError::Untrusted))
    }

    /// Sends a command when its turn comes, if its whole way is allowed.
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

    /// Where a command would lead if it were sent now, if its whole way is allowed.
    pub(super) fn foresee(&self, command: &Command) -> Result<PathPreview, Refusal> {
        self.session.check(command)?;
        let Some(model) = self.session.model() else {
            return Err(Refusal::NoLink("no status has come yet".to_owned()));
        };
        let trajectory = self.policy.check(model, command)?;
        Ok(path_preview(model, &trajectory)?)
    }

    /// Sends a command at once, whatever waits.
    pub(super) fn send_urgent(&mut self, command: Command) {
        if let Ok(packet) = self.session.emit_now(&command) {
            self.session.note_urgent(&command);
            self.line.push(packet);
        }
    }

    /// Sends a packet of a detection. What it configures is believed from now on: a detection that
    /// ends early leaves the arm with it.
    pub(super) fn send_question(&mut self, packet: Packet) {
        let dialect = self.session.dialect().unwrap_or(&Dialect::SPECIFICATION);
        let command = Command::parse(&packet, dialect);
        if let Ok(it @ (Command::Configuration(_) | Command::PlaybackAdjustment(_))) = command {
            self.session.note_urgent(&it);
        }
        self.line.push(packet);
    }

    /// Sends this before all else, without waiting for the line: what was urgent before is forgotten.
    pub(super) fn send_first(&mut self, command: Command) {
        self.line.clear();
        self.send_urgent(command);
        self.line.hurry();
    }

    /// Sends a command at once, without waiting for the line.
    pub(super) fn send_at_once(&mut self, command: Command) {
        self.send_urgent(command);
        self.line.hurry();
    }

    /// What the session has for the line becomes urgent, in its order.
    pub(super) fn hasten(&mut self) {
        while let Some(packet) = self.session.poll_bytes() {
            self.line.push(packet);
        }
    }

    /// Releases the button that was sent last; says whether there was one.
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

    /// When the line is free again, while something waits for that.
    pub(super) fn line_wakeup(&self) -> Option<Duration> {
        self.line.wakeup(self.now)
    }
}

/// A way as those see it who ask where a command would lead.
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
        [at.x, at.y, at.z].map(|it| it.0)
    };
    let joints = end.joints;
    Ok(PathPreview {
        takes_s: trajectory.duration_s(),
        joints_deg: [joints.base, joints.rear, joints.fore, joints.servo].map(|it| it.0),
        path_mm: iter::once(&start).chain(&way).map(point).collect(),
    })
}

/// A joint that turned by less may not have turned, in degrees.
const TURNS_DEG: f32 = 0.005;
/// So many statuses in a row that tell the same: the arm is at rest.
const AT_REST: u32 = 3;
/// Laser off, a gap, the release, said twice, on the line and in a tick of the arm.
const HEARD_WITHIN: Duration = Duration::from_millis(700);
/// In how many parts of equal time a way is shown.
const PATH_PARTS: u32 = 48;
