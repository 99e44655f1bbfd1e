//! States 3 and 6 of the stock controller: targets, with a pause and a tool action at the end
//! (notes N45 to N47).

use dobot_arm::stock::{StockJoints, StockPose, forward, inverse, is_out_of_reach, short};
use dobot_wire::Frame;

use super::body::{Body, FORE_DEG, REAR_DEG};
use super::joint_motion::JointMotion;
use super::line::StraightLine;
use super::settings::StockSettings;
use super::{Progress, TickOutcome};
use crate::{Hang, Refused};

/// The motion to a target and the pause at its end.
#[derive(Debug, Default)]
pub(crate) struct Travel {
    way: Option<TargetMove>,
    /// The unfinished JUMP. It outlives a command interrupted by voice.
    jump: Option<Jump>,
    /// Also outlives a command interrupted by voice.
    pause: Option<Pause>,
    /// Whether pump and gripper follow the current command: from the middle of a pause until the next
    /// motion is planned.
    acts: bool,
}

#[derive(Debug)]
enum TargetMove {
    Joints(JointMotion),
    /// Along the shared line; then the servo turns to this angle.
    Line(ServoEnd),
    Jump,
}

/// The form of the servo angle at the end of a line.
#[derive(Clone, Copy, Debug)]
enum ServoEnd {
    Rotation(f32),
    Servo(f32),
}

/// Lift, traverse and descent, each a motion of all joints.
#[derive(Debug)]
struct Jump {
    targets: [StockPose; 3],
    next: usize,
    phase: Option<JointMotion>,
}

/// A pause, counted in ticks with 16 bits.
#[derive(Debug, Default)]
struct Pause {
    ticks: i16,
}

/// Whether a target is given as a pose or as joint angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TargetKind {
    Pose,
    Joints,
}

impl Travel {
    /// Whether a phase of a JUMP began in this tick.
    pub(crate) fn begins_phase(&self) -> bool {
        let jump = self.jump.as_ref().filter(|_| self.pause.is_none());
        let phase = jump.and_then(|jump| jump.phase.as_ref());
        phase.is_some_and(JointMotion::is_begun)
    }

    /// Runs a tick of a target; `is_over` if the command is already finished and none follows.
    pub(crate) fn tick(
        &mut self,
        kind: TargetKind,
        frame: &Frame,
        is_over: bool,
        settings: &StockSettings,
        line: &mut StraightLine,
        body: &mut Body,
    ) -> TickOutcome {
        let outcome = match short(frame.float(8)) {
            // A finished JUMP stays finished; after the other modes the pause starts again (note N47).
            JUMP if is_over => TickOutcome::OVER,
            MOVJ | MOVL if is_over => {
                self.pause = Some(Pause::default());
                self.wait(frame)
            }
            JUMP | MOVJ | MOVL if self.pause.is_some() => self.wait(frame),
            JUMP | MOVJ | MOVL => self.travel(kind, frame, settings, line, body),
            other => TickOutcome::hangs(Hang::MovingMode(other)),
        };
        if self.acts {
            act(frame, body);
        }
        body.turn_head(body.joints.servo_deg);
        outcome
    }

    fn travel(
        &mut self,
        kind: TargetKind,
        frame: &Frame,
        settings: &StockSettings,
        line: &mut StraightLine,
        body: &mut Body,
    ) -> TickOutcome {
        if !body.is_planned {
            self.way = self.plan(kind, frame, settings, line, body);
            body.is_planned = self.way.is_some();
            self.acts &= self.way.is_none();
        }
        let Some(way) = &mut self.way else {
            return TickOutcome::over_with(Refused::OutOfReach);
        };
        let progress = way.tick(&mut self.jump, settings, line, body);
        if progress == Progress::GoesOn {
            let endless = !way.total_s(self.jump.as_ref(), line).is_finite();
            return TickOutcome::hangs_if(endless, Hang::NeverArrives);
        }
        self.arrive(frame, progress)
    }

    /// Begins the pause at the end of a motion.
    fn arrive(&mut self, frame: &Frame, progress: Progress) -> TickOutcome {
        self.jump = None;
        self.pause = Some(Pause::default());
        let waiting = self.wait(frame);
        match progress {
            Progress::CutShort => waiting.with(Refused::CutShort),
            _ => waiting,
        }
    }

    /// Runs a tick of the pause: the tool acts in the middle, the command ends at the end.
    fn wait(&mut self, frame: &Frame) -> TickOutcome {
        let pause_s = frame.float(10);
        let Some(pause) = &mut self.pause else {
            return TickOutcome::OVER;
        };
        pause.ticks = pause.ticks.wrapping_add(1);
        let ticks = f32::from(pause.ticks);
        self.acts |= ticks > 25.0 * pause_s;
        if ticks > 50.0 * pause_s {
            self.pause = None;
            TickOutcome::OVER
        } else {
            TickOutcome::GOES_ON
        }
    }

    /// Plans the motion to a target; `None` if a MOVJ cannot reach it.
    fn plan(
        &mut self,
        kind: TargetKind,
        frame: &Frame,
        settings: &StockSettings,
        line: &mut StraightLine,
        body: &mut Body,
    ) -> Option<TargetMove> {
        let (joints, pose) = target(kind, frame, body.tool_mm);
        match (short(frame.float(8)), kind) {
            (MOVL, _) => {
                let to = [pose.x_mm, pose.y_mm, pose.z_mm];
                line.plan(body, to, settings.line_ramp());
                Some(TargetMove::Line(ServoEnd::of(kind, frame.float(6))))
            }
            (JUMP, _) => {
                self.plan_jump(pose, settings, body);
                Some(TargetMove::Jump)
            }
            (_, TargetKind::Joints) => Some(TargetMove::joints(joints, settings, body)),
            (_, TargetKind::Pose) => Some(TargetMove::joints(solve(pose, body)?, settings, body)),
        }
    }

    /// Plans a JUMP, or resumes an interrupted one.
    fn plan_jump(&mut self, to: StockPose, settings: &StockSettings, body: &mut Body) {
        if let Some(jump) = &mut self.jump {
            jump.resume();
        } else {
            body.begin();
            self.jump = Some(Jump::plan(body.pose, to, settings.jump_height_mm));
        }
    }
}

impl TargetMove {
    /// Plans a joint motion. The servo uses the rear arm's acceleration.
    fn joints(to: StockJoints, settings: &StockSettings, body: &Body) -> Self {
        let mut ramps = settings.joint_ramps();
        ramps[3].acceleration = ramps[1].acceleration;
        Self::Joints(JointMotion::plan(body, to, &ramps))
    }

    fn tick(
        &mut self,
        jump: &mut Option<Jump>,
        settings: &StockSettings,
        line: &mut StraightLine,
        body: &mut Body,
    ) -> Progress {
        match self {
            Self::Joints(way) => {
                let progress = way.tick(body);
                if progress == Progress::Arrived {
                    line.forget_travelled();
                }
                progress
            }
            Self::Line(end) => end.tick(line, body),
            Self::Jump => match jump {
                Some(jump) => jump.tick(settings, body),
                None => Progress::Arrived,
            },
        }
    }

    fn total_s(&self, jump: Option<&Jump>, line: &StraightLine) -> f32 {
        match self {
            Self::Joints(way) => way.total_s,
            Self::Line(_) => line.total_s,
            Self::Jump => {
                let phase = jump.and_then(|jump| jump.phase.as_ref());
                phase.map_or(0.0, |phase| phase.total_s)
            }
        }
    }
}

impl ServoEnd {
    const fn of(kind: TargetKind, angle_deg: f32) -> Self {
        match kind {
            TargetKind::Pose => Self::Rotation(angle_deg),
            TargetKind::Joints => Self::Servo(angle_deg),
        }
    }

    /// Runs a tick of the line at whose end the servo turns.
    fn tick(self, line: &mut StraightLine, body: &mut Body) -> Progress {
        let progress = line.tick(body);
        if progress == Progress::Arrived {
            body.set_servo(match self {
                Self::Rotation(rotation_deg) => rotation_deg - body.joints.base_deg,
                Self::Servo(servo_deg) => servo_deg,
            });
        }
        progress
    }
}

impl Jump {
    fn plan(from: StockPose, to: StockPose, height_mm: f32) -> Self {
        let lifted = |pose: StockPose| StockPose {
            z_mm: pose.z_mm + height_mm,
            ..pose
        };
        Self {
            targets: [lifted(from), lifted(to), to],
            next: 0,
            phase: None,
        }
    }

    /// Restarts the interrupted phase from rest.
    fn resume(&mut self) {
        if self.phase.take().is_some() {
            self.next -= 1;
        }
    }

    /// Advances by one tick. The next phase starts in the tick that detects the end of the last one; a
    /// phase with an unreachable end takes no time.
    fn tick(&mut self, settings: &StockSettings, body: &mut Body) -> Progress {
        loop {
            if let Some(phase) = &mut self.phase
                && phase.tick(body) == Progress::GoesOn
            {
                return Progress::GoesOn;
            }
            let Some(&target) = self.targets.get(self.next) else {
                return Progress::Arrived;
            };
            self.next += 1;
            self.phase =
                solve(target, body).map(|to| JointMotion::plan(body, to, &settings.joint_ramps()));
        }
    }
}

/// The joint angles for a pose, if a MOVJ can reach it.
pub(crate) fn solve(pose: StockPose, body: &Body) -> Option<StockJoints> {
    let joints = inverse(pose, body.tool_mm);
    let refused = is_out_of_reach(pose, body.tool_mm)
        || joints.rear_deg < REAR_DEG[0]
        || joints.rear_deg > REAR_DEG[1]
        || joints.fore_deg < FORE_DEG[0]
        || joints.fore_deg > FORE_DEG[1];
    (!refused).then_some(joints)
}

/// The target of a frame as joint angles and as a pose. The angles count only if the frame has angles.
fn target(kind: TargetKind, frame: &Frame, tool_mm: f32) -> (StockJoints, StockPose) {
    let [first, second, third, last] = [3, 4, 5, 6].map(|n| frame.float(n));
    let joints = StockJoints {
        base_deg: first,
        rear_deg: second,
        fore_deg: third,
        servo_deg: last,
    };
    let pose = match kind {
        TargetKind::Pose => StockPose {
            x_mm: first,
            y_mm: second,
            z_mm: third,
            rotation_deg: last,
        },
        TargetKind::Joints => forward(joints, tool_mm),
    };
    (joints, pose)
}

/// Sets pump and gripper at the end of a motion.
fn act(frame: &Frame, body: &mut Body) {
    let (grabs, gripper_deg) = (frame.float(7), frame.float(9));
    if grabs == 1.0 {
        body.grab(true, gripper_deg);
    } else if grabs == 0.0 {
        body.grab(false, gripper_deg);
    }
    body.gripper_deg = gripper_deg;
}

pub(crate) const JUMP: i16 = 0;
pub(crate) const MOVJ: i16 = 1;
pub(crate) const MOVL: i16 = 2;
