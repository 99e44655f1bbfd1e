//! The plan of a job, checked as a whole before anything moves.

mod cycle;
mod height;

use std::ops::Range;
use std::sync::Arc;

use dobot_api::JobProgram;
use dobot_arm::{Calibration, Joints, Position, Tool};
use dobot_journal::HeightChange;
use dobot_motion::{ArmPlace, Model, ReturnWait, Trajectory, burns};
use dobot_safety::{Policy, Violation};
use dobot_session::position;
use dobot_wire::{
    Command, Configuration, Dialect, JointJogAxis, PlaybackAdjustment, Status, WriteVector, single,
};

use self::cycle::Cycle;
use self::height::Height;
use crate::Refusal;

/// A job whose whole path has been checked, with the end and the duration of each command.
#[derive(Clone, Debug)]
pub struct JobPlan {
    /// The commands as submitted.
    planned: Arc<[Command]>,
    /// The commands to draw, with height changes.
    commands: Arc<[Command]>,
    steps: Arc<[Step]>,
    /// From this command on, the commands are as submitted except for their height.
    altered_until: usize,
    /// The settings in force, each with the first command they apply to.
    settings: Vec<(usize, DrawnWith)>,
    burns: bool,
    lift_mm: f32,
    /// The lowest planned height, in raw coordinates.
    lowest_mm: f64,
    /// The calibration of the arm.
    arm: Calibration,
    /// The repeated commands.
    cycle: Option<Cycle>,
}

/// The settings that apply to a command.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawnWith {
    pub(super) acceleration_mm_s2: f64,
    pub(super) tool: Tool,
    /// The speed of targets.
    pub(super) playback: PlaybackAdjustment,
}

/// One command of a job.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// The arm after the command.
    end: Status,
    /// The height above the plan, in mm.
    raised_mm: f64,
    /// A further height offset from a later change by a person.
    higher_mm: f64,
    moves: bool,
    /// The change of held objects.
    grips: Grips,
    /// The time until the end of the command, in seconds.
    until_s: f64,
}

/// The change that a command makes to held objects. A switched pump may have been on already.
#[derive(Clone, Copy, Debug)]
struct Grips {
    suction: bool,
    gripper: bool,
}

impl Grips {
    const fn any(self) -> bool {
        self.suction || self.gripper
    }
}

impl JobPlan {
    /// Checks every command of a job, starting where the arm is, at the heights that a person has
    /// set. The path to its first target is not checked if the arm was already given it: some of
    /// the commands below `given` may be done. A cycle is checked until it repeats itself, and is
    /// unrolled here as far as a journal window may reach.
    ///
    /// # Errors
    ///
    /// [`Refusal::BadJob`] with the first forbidden command and the reason.
    pub fn new(
        policy: &Policy,
        model: Model,
        commands: Vec<Command>,
        heights: &[HeightChange],
        lift_mm: f32,
        given: usize,
        program: &JobProgram,
    ) -> Result<Self, Refusal> {
        let first = check_first_motion(&commands)?;
        let cycle = Cycle::of(program, commands.len());
        let commands = cycle.map_or(commands.clone(), |cycle| cycle.unroll(commands));
        let burns = commands.iter().any(burns);
        let mut look = PlanWalk {
            policy,
            model,
            height: Height::planned(burns),
            unjudged: (given > first).then_some(first),
            until_s: 0.0,
            return_wait: ReturnWait::new(model.dialect.status_period().as_secs_f64()),
        };
        let mut plan = Self {
            planned: Arc::default(),
            commands: Arc::default(),
            steps: Arc::default(),
            altered_until: 0,
            settings: vec![(0, look.drawn_with())],
            burns,
            lift_mm,
            lowest_mm: f64::MAX,
            arm: model.calibration,
            cycle,
        };
        let mut steps: Vec<Step> = Vec::with_capacity(commands.len());
        let mut drawn = Vec::with_capacity(commands.len());
        let mut changes = heights.iter().peekable();
        for (index, command) in commands.iter().enumerate() {
            if let Some(change) = changes.next_if(|change| change.from == index) {
                look.change(change, steps.last_mut());
            }
            drawn.push(look.height.apply(command));
            steps.push(look.step(index, &drawn[index])?);
            plan.note(index, command, &drawn[index], look.drawn_with());
        }
        plan.planned = commands.into();
        plan.commands = drawn.into();
        plan.steps = steps.into();
        let moved = &plan.steps[plan.first_motion()..];
        let heights = moved
            .iter()
            .map(|step| f64::from(step.end.z_mm) - step.raised_mm);
        plan.lowest_mm = heights.fold(f64::MAX, f64::min);
        Ok(plan)
    }

    fn note(&mut self, index: usize, planned: &Command, drawn: &Command, with: DrawnWith) {
        if drawn != planned {
            self.altered_until = index + 1;
        }
        if matches!(
            planned,
            Command::Configuration(_) | Command::PlaybackAdjustment(_)
        ) {
            self.settings.push((index + 1, with));
        }
    }

    /// Changes the height of all commands from one on. The paths are not checked again here: each
    /// is checked before it is sent.
    pub fn change_height(&mut self, change: &HeightChange) {
        let mut height = Height::planned(self.burns);
        (height.raised_mm, height.offset_mm) = (change.begin_mm, change.offset_mm);
        let commands = Arc::make_mut(&mut self.commands);
        let steps = Arc::make_mut(&mut self.steps);
        if let Some(last) = change
            .from
            .checked_sub(1)
            .and_then(|from| steps.get_mut(from))
        {
            last.higher_mm = change.begin_mm - last.raised_mm;
        }
        self.altered_until = change.from.min(self.altered_until);
        for (index, command) in self.planned.iter().enumerate().skip(change.from) {
            commands[index] = height.apply(command);
            steps[index].higher_mm = height.raised_mm - steps[index].raised_mm;
            if commands[index] != *command {
                self.altered_until = index + 1;
            }
        }
    }

    /// Checks that the arm may be as low as it gets from a command on.
    ///
    /// # Errors
    ///
    /// [`Violation`] with the rule that forbids it.
    pub fn check_lowest(&self, policy: &Policy, from: usize) -> Result<(), Violation> {
        let ends = self.steps[from.min(self.len())..].iter().enumerate();
        let ends: Vec<_> = ends.map(|(n, step)| (from + n, step.now())).collect();
        let above_table_mm = |at: &Status| {
            let place = ArmPlace::of_status(at).pose.position;
            self.arm.above_table_mm(place).unwrap_or_default()
        };
        let lowest = [
            ends.iter()
                .min_by(|(_, a), (_, b)| a.z_mm.total_cmp(&b.z_mm)),
            ends.iter()
                .min_by(|(_, a), (_, b)| above_table_mm(a).total_cmp(&above_table_mm(b))),
        ];
        lowest
            .into_iter()
            .flatten()
            .try_for_each(|(index, status)| {
                let tool = self.drawn_with(*index).tool;
                policy.check_place(&ArmPlace::of_status(status), tool, &self.arm)
            })
    }

    /// Returns the height above the plan before a command, in millimetres.
    #[must_use]
    pub fn raised_mm(&self, index: usize) -> f64 {
        let last = index.checked_sub(1).and_then(|index| self.steps.get(index));
        last.map_or(0.0, |last| last.raised_mm + last.higher_mm)
    }

    /// Returns whether this command or a later one was changed, so that its speeds may not fit.
    #[must_use]
    pub const fn is_altered(&self, index: usize) -> bool {
        index < self.altered_until
    }

    /// Returns whether there is a vector.
    #[must_use]
    pub fn has_vectors(&self) -> bool {
        let vector = |command: &Command| matches!(command, Command::WriteVector(_));
        self.planned.iter().any(vector)
    }

    /// Returns the vectors from a command on that are drawn without a rest: up to the first that
    /// ends at rest.
    pub fn chain(&self, index: usize) -> impl Iterator<Item = &WriteVector> {
        let mut rests = false;
        self.commands[index.min(self.len())..]
            .iter()
            .map_while(move |command| match command {
                Command::WriteVector(vector) if !vector.stop && !rests => {
                    rests = vector.end_speed_mm_s == 0.0;
                    Some(vector)
                }
                _ => None,
            })
    }

    /// Returns the settings that apply to a command.
    pub(super) fn drawn_with(&self, index: usize) -> DrawnWith {
        let later = self.settings.partition_point(|setting| setting.0 <= index);
        self.settings[later.saturating_sub(1)].1
    }

    /// Returns the repeated commands.
    #[must_use]
    pub(super) const fn cycle(&self) -> Option<&Cycle> {
        self.cycle.as_ref()
    }

    /// Returns whether a command changes what pump or gripper hold.
    pub(super) fn grips(&self, index: usize) -> bool {
        self.steps.get(index).is_some_and(|step| step.grips.any())
    }

    /// Returns whether a command does so without a motion.
    pub(super) fn grips_in_place(&self, index: usize) -> bool {
        self.steps
            .get(index)
            .is_some_and(|step| step.grips.any() && !step.moves)
    }

    /// Returns whether a status shows the effect of a command on pump and gripper.
    pub(super) fn shows_grip(&self, index: usize, status: &Status) -> bool {
        self.steps.get(index).is_none_or(|step| {
            let off_deg = (status.gripper_deg - step.end.gripper_deg).abs();
            (!step.grips.suction || status.suction == step.end.suction)
                && (!step.grips.gripper || off_deg < SAME_GRIP_DEG)
        })
    }

    /// Returns the highest speed of targets, in percent of the configured speed.
    pub(super) fn fastest_percent(&self) -> f64 {
        let percents = self
            .settings
            .iter()
            .map(|setting| f64::from(setting.1.playback.speed_percent));
        percents.fold(0.0, f64::max)
    }

    /// Returns the number of commands, including the unrolled cycles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.commands.len()
    }

    /// Returns whether there are no commands.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.commands.is_empty()
    }

    /// Returns the commands.
    #[must_use]
    pub fn commands(&self) -> &[Command] {
        &self.commands
    }

    /// Returns the settings commands before a command.
    pub(super) fn settings_before(&self, index: usize) -> impl Iterator<Item = &Command> {
        let indices = self.settings.iter().skip(1).map(|setting| setting.0 - 1);
        indices
            .take_while(move |start| *start < index)
            .map(|index| &self.commands[index])
    }

    /// Returns whether the laser burns anywhere.
    #[must_use]
    pub const fn burns(&self) -> bool {
        self.burns
    }

    /// Returns the height by which the tool is lifted in a pause, in millimetres.
    #[must_use]
    pub const fn lift_mm(&self) -> f32 {
        self.lift_mm
    }

    /// Returns the lift, if it is not 0.
    #[must_use]
    pub fn lift(&self) -> Option<f32> {
        Some(self.lift_mm).filter(|lift_mm| *lift_mm > 0.0)
    }

    /// Returns the tool height below which a pen draws, in millimetres and raw coordinates, if
    /// drawn this far above the plan; `None` if the pen is not lifted.
    #[must_use]
    pub fn draws_below_mm(&self, raised_mm: f64) -> Option<f64> {
        let lift_mm = self.lift()?;
        Some(draws_below_mm(self.lowest_mm + raised_mm, lift_mm.into()))
    }

    /// Returns the arm before a command; `None` before the first motion, which starts wherever the
    /// arm is.
    #[must_use]
    pub fn start(&self, index: usize) -> Option<Status> {
        let before = index.min(self.steps.len());
        let moved = before > self.first_motion();
        let last = before.checked_sub(1).filter(|_| moved)?;
        self.steps.get(last).map(Step::now)
    }

    /// Returns the tool position before a command.
    #[must_use]
    pub fn start_position(&self, index: usize) -> Option<Position> {
        self.start(index).as_ref().map(position)
    }

    fn first_motion(&self) -> usize {
        let first = self.steps.iter().position(|step| step.moves);
        first.unwrap_or(self.steps.len())
    }

    /// Returns the total duration, in seconds; `None` if it repeats until it is ended.
    #[must_use]
    pub fn planned_s(&self) -> Option<f64> {
        let Some(cycle) = &self.cycle else {
            return Some(self.until_s(self.len()));
        };
        #[expect(clippy::cast_precision_loss, reason = "2^53 cycles are out of reach")]
        let more = cycle.times?.saturating_sub(1) as f64;
        Some(self.until_s(cycle.end()) + self.cycle_s().unwrap_or(0.0) * more)
    }

    /// Returns the duration of a repeated cycle, in seconds; `None` if there is none.
    #[must_use]
    pub fn cycle_s(&self) -> Option<f64> {
        let cycle = self.cycle.as_ref()?;
        let second = cycle.end() + cycle.len;
        (second <= self.len()).then(|| self.until_s(second) - self.until_s(cycle.end()))
    }

    /// Returns the duration of a range of commands, in seconds.
    #[must_use]
    pub fn takes_s(&self, commands: Range<usize>) -> f64 {
        self.until_s(commands.end) - self.until_s(commands.start)
    }

    fn until_s(&self, index: usize) -> f64 {
        let over = index.min(self.len()).checked_sub(1);
        over.map_or(0.0, |over| self.steps[over].until_s)
    }
}

impl Step {
    /// Returns the arm after the command, at the current height.
    fn now(&self) -> Status {
        if self.higher_mm == 0.0 {
            return self.end;
        }
        raised(&self.end, self.higher_mm)
    }
}

/// Walks through a job command by command.
struct PlanWalk<'a> {
    policy: &'a Policy,
    model: Model,
    height: Height,
    /// The command whose path is not checked.
    unjudged: Option<usize>,
    until_s: f64,
    return_wait: ReturnWait,
}

impl PlanWalk<'_> {
    /// Applies a height change from here on; the last step ends at the new height.
    fn change(&mut self, change: &HeightChange, last: Option<&mut Step>) {
        let higher_mm = change.begin_mm - self.height.raised_mm;
        (self.height.raised_mm, self.height.offset_mm) = (change.begin_mm, change.offset_mm);
        if let Some(last) = last.filter(|_| higher_mm != 0.0) {
            let status = raised(&self.model.status(), higher_mm);
            self.model.place = ArmPlace::of_status(&status);
            (last.end, last.raised_mm) = (status, change.begin_mm);
        }
    }

    fn step(&mut self, index: usize, command: &Command) -> Result<Step, Refusal> {
        let trajectory = self.trajectory(index, command)?;
        let takes_s = trajectory.duration_s().ok_or_else(|| {
            let why = "a jog lasts until it is released; a job may not contain one";
            Refusal::bad_job(index, why)
        })?;
        let before = self.model;
        self.model = self.model.after(command, &trajectory);
        self.until_s += self.return_wait.before(&before, &trajectory, &self.model) + takes_s;
        Ok(Step {
            end: self.model.status(),
            grips: Grips {
                suction: before.suction != self.model.suction || is_pump_switch(command),
                gripper: before.gripper_deg != self.model.gripper_deg,
            },
            raised_mm: self.height.raised_mm,
            higher_mm: 0.0,
            moves: trajectory.moves(),
            until_s: self.until_s,
        })
    }

    /// Returns the trajectory of a command whose path is allowed.
    fn trajectory(&mut self, index: usize, command: &Command) -> Result<Trajectory, Refusal> {
        if self.unjudged == Some(index) {
            // Already being in a forbidden position is no reason to refuse past commands.
            self.model.place = somewhere(self.model.tool);
            let trajectory = self.model.trajectory(command);
            return trajectory.map_err(|error| Refusal::bad_job(index, error.to_string()));
        }
        let checked = self.policy.check(&self.model, command);
        checked.map_err(|violation| Refusal::BadJob {
            index,
            why: violation.to_string(),
            rule: Some(violation.rule),
        })
    }

    fn drawn_with(&self) -> DrawnWith {
        DrawnWith {
            acceleration_mm_s2: self.model.settings.write_acceleration_mm_s2,
            tool: self.model.tool,
            playback: PlaybackAdjustment {
                speed_percent: single(self.model.settings.speed_percent),
                acceleration_percent: single(self.model.settings.acceleration_percent),
                teach_speed_percent: single(self.model.settings.teach_percent),
            },
        }
    }
}

const fn is_pump_switch(command: &Command) -> bool {
    matches!(command, Command::JointJog(jog) if matches!(jog.axis, JointJogAxis::SuctionOn | JointJogAxis::SuctionOff))
}

/// A gripper this close to its target has reached it, in degrees.
const SAME_GRIP_DEG: f32 = 0.5;

/// Returns the arm raised by this much; if it cannot be there, the path to it will be refused.
fn raised(status: &Status, by_mm: f64) -> Status {
    // A status means the same in every dialect.
    let mut model = Model::new(Dialect::SPECIFICATION, status);
    let mut pose = model.place.pose;
    pose.position.z.0 += by_mm;
    match ArmPlace::at_pose(pose, model.tool) {
        Ok(place) => {
            model.place = place;
            model.status()
        }
        Err(_) => *status,
    }
}

/// A position from which every target can be reached.
fn somewhere(tool: Tool) -> ArmPlace {
    ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), tool)
}

/// Returns the index of the first motion. It must be a target, because relative motions need a
/// known start, wherever the arm was before.
fn check_first_motion(commands: &[Command]) -> Result<usize, Refusal> {
    let calm = |command: &Command| {
        matches!(
            command,
            Command::Configuration(_) | Command::PlaybackAdjustment(_) | Command::JointJog(_)
        )
    };
    let first = commands.iter().position(|command| !calm(command));
    let bad = |index, why: &str| Err(Refusal::bad_job(index, why));
    match first.map(|index| (index, &commands[index])) {
        None => bad(0, "no command moves the arm"),
        Some((index, Command::MoveTo(_) | Command::MoveJoints(_))) => {
            check_no_references(commands).map(|()| index)
        }
        Some((index, _)) => bad(
            index,
            "the first motion must be a target (state 3 or 6), which sets where the job begins",
        ),
    }
}

/// After new initial angles, the arm's position no longer follows from earlier positions.
fn check_no_references(commands: &[Command]) -> Result<(), Refusal> {
    let reference = |command: &Command| {
        matches!(
            command,
            Command::Configuration(Configuration::InitialAngles { .. })
        )
    };
    match commands.iter().position(reference) {
        None => Ok(()),
        Some(index) => {
            let why = "initial angles are set by hand, not in a job";
            Err(Refusal::bad_job(index, why))
        }
    }
}

/// Returns the height below which a pen draws, in mm: half of its lift above its lowest position.
#[must_use]
pub const fn draws_below_mm(lowest_mm: f64, lift_mm: f64) -> f64 {
    lowest_mm + lift_mm / 2.0
}
