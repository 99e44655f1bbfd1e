//! Random scripts on the twin and in the motion model, which calculates in double precision and
//! continuous time: a second implementation of what the commands mean.

use std::fmt;

use std::time::Duration;

use dobot_arm::{Joints, Position, TICK, TICK_S, Tool};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_geometry::Random;
use dobot_motion::{ArmPlace, Button, JogTrajectory, Model};
use dobot_wire::{
    Command, Configuration, Dialect, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MoveJoints,
    MoveTo, MovingMode, PlaybackAdjustment, WriteVector, single,
};

/// A kind of scripts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Jogs,
    Joints,
    Lines,
    Jumps,
    Vectors,
    Settings,
    Mixtures,
}

impl Kind {
    pub(crate) const ALL: [Self; 7] = [
        Self::Jogs,
        Self::Joints,
        Self::Lines,
        Self::Jumps,
        Self::Vectors,
        Self::Settings,
        Self::Mixtures,
    ];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Jogs => "jogs of all axes, joint and linear, with their releases",
            Self::Joints => "joint moves (MOVJ) to angles and points",
            Self::Lines => "straight lines (MOVL) to points and angles",
            Self::Jumps => "JUMPs to points and angles",
            Self::Vectors => "write vectors",
            Self::Settings => "settings (states 9 and 10), each followed by a motion",
            Self::Mixtures => "all of these, mixed",
        }
    }
}

/// How far twin and model are apart in one script or several.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Gap {
    pub(crate) motions: u32,
    /// From the path of a jog, or its end.
    pub(crate) jog_mm: f64,
    /// From the path of any other motion, in every fourth tick.
    pub(crate) path_mm: f64,
    /// At its end: position, and angles.
    pub(crate) end_mm: f64,
    pub(crate) end_deg: f64,
    /// The earliest and the latest end.
    pub(crate) early_s: f64,
    pub(crate) late_s: f64,
    /// The first motion that is too far apart.
    pub(crate) mismatch: Option<Command>,
}

impl Gap {
    pub(crate) fn join(self, other: Self) -> Self {
        Self {
            motions: self.motions + other.motions,
            jog_mm: self.jog_mm.max(other.jog_mm),
            path_mm: self.path_mm.max(other.path_mm),
            end_mm: self.end_mm.max(other.end_mm),
            end_deg: self.end_deg.max(other.end_deg),
            early_s: self.early_s.max(other.early_s),
            late_s: self.late_s.max(other.late_s),
            mismatch: self.mismatch.or(other.mismatch),
        }
    }
}

/// One row of the page: a thousand scripts of a kind.
#[derive(Debug)]
pub(crate) struct Row {
    kind: Kind,
    matching: u32,
    gap: Gap,
}

impl Row {
    pub(crate) fn of(kind: Kind) -> Self {
        let gaps = (0..SCRIPTS).map(|number| compare(kind, number));
        let mut row = Self {
            kind,
            matching: 0,
            gap: Gap::default(),
        };
        for gap in gaps {
            row.matching += u32::from(gap.mismatch.is_none());
            row.gap = row.gap.join(gap);
        }
        row
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Gap {
            motions,
            jog_mm,
            path_mm,
            end_mm,
            end_deg,
            late_s,
            ..
        } = self.gap;
        let name = self.kind.name();
        let (matching, late_ms) = (self.matching, late_s * 1000.0);
        write!(f, "| {name} | {matching} of {SCRIPTS} | {motions} | ")?;
        if self.kind == Kind::Jogs {
            write!(f, "| | | {jog_mm:.2} ")?;
        } else {
            write!(f, "{path_mm:.3} | {end_mm:.4} | {end_deg:.4} | ")?;
            if jog_mm > 0.0 {
                write!(f, "{jog_mm:.2} ")?;
            }
        }
        write!(f, "| {late_ms:.0} |")
    }
}

/// Runs the script of a kind with this number.
pub(crate) fn compare(kind: Kind, number: u64) -> Gap {
    let mut random = Random::sequence(kind as u64, number);
    let mut run = ScriptRun::power_up();
    let mut gap = Gap::default();
    for _ in 0..=random.below(MAX_MOTIONS) {
        let kind = match kind {
            Kind::Mixtures => Kind::ALL[random.below(6) as usize],
            kind => kind,
        };
        if kind == Kind::Settings {
            run.set(&setting(&mut random));
        }
        let motion = match kind {
            Kind::Settings => Kind::ALL[random.below(5) as usize],
            kind => kind,
        };
        gap = gap.join(run.make(motion, &mut random).unwrap_or_default());
    }
    gap
}

/// The twin and the model, at the same place with the same settings.
struct ScriptRun {
    controller: Controller,
    tick: u32,
    model: Model,
}

impl ScriptRun {
    fn power_up() -> Self {
        let controller = Controller::power_up(PowerUp::new(Personality::Firmware11));
        let place = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        Self {
            controller,
            tick: 0,
            model: Model::standing(DIALECT, place),
        }
    }

    fn set(&mut self, command: &Command) {
        if let Ok(trajectory) = self.model.trajectory(command) {
            self.obey(command, None);
            self.model = self.model.after(command, &trajectory);
        }
    }

    /// Makes a motion that the model allows; `None` if it allows none.
    fn make(&mut self, kind: Kind, random: &mut Random) -> Option<Gap> {
        (0..TRIES).find_map(|_| match kind {
            Kind::Jogs => self.jog(random),
            _ => self.follow(&command(kind, random)),
        })
    }

    fn follow(&mut self, command: &Command) -> Option<Gap> {
        let trajectory = self.model.trajectory(command).ok()?;
        trajectory.check().ok()?;
        let lasts_s = trajectory.lasts_s()?;
        let path = Path::of(trajectory.motion_s()?, |t_s| trajectory.place_at(t_s).ok())?;
        let passed = self.obey(command, None);
        self.model = self.model.after(command, &trajectory);
        let end = *passed.last()?;
        let mut gap = path.gap(&passed, lasts_s);
        gap.end_mm = end.pose.position.distance(self.model.place.pose.position).0;
        gap.end_deg = turned_deg(&end.joints, &self.model.place.joints);
        let is_near = gap.end_mm <= END_MM && gap.end_deg <= END_DEG && gap.path_mm <= PATH_MM;
        gap.mismatch = (!(is_near && gap.is_in_time())).then_some(*command);
        Some(gap)
    }

    /// Holds a button for a while.
    fn jog(&mut self, random: &mut Random) -> Option<Gap> {
        let held_ticks = 5 + random.below(60);
        let (press, release) = buttons(random);
        let Some(Button::Held { axis, share }) = Button::of(&press) else {
            return None;
        };
        let held_s = f64::from(held_ticks) * TICK_S;
        let jog = JogTrajectory::start(&self.model, axis, share, 0.0).ok()?;
        // The twin may go a little further.
        jog.place_at(held_s + 0.5).ok()?.check().ok()?;
        let mut released = self.model;
        released.place = jog.place_at(held_s).ok()?;
        let run_down = jog.release(&released, held_s).ok()?;
        let lasts_s = held_s + run_down.change_s();
        let path = Path::of(lasts_s, |t_s| match t_s - held_s {
            behind_s if behind_s > 0.0 => run_down.place_at(behind_s).ok(),
            _ => jog.place_at(t_s).ok(),
        })?;
        let passed = self.obey(&press, Some((held_ticks, release)));
        let end = *passed.last()?;
        let mut gap = path.gap(&passed, lasts_s);
        let expected = path.end();
        let end_mm = end.pose.position.distance(expected).0;
        gap.jog_mm = end_mm.max(gap.path_mm);
        gap.path_mm = 0.0;
        // The ticks of both ramps are steps of a slope (note N44).
        let speed = jog.target_speed().abs().max(jog.acceleration() * TICK_S);
        let most_mm = END_MM + JOG_TICKS * TICK_S * speed * LEVER;
        let same = gap.jog_mm <= most_mm && gap.is_in_time();
        gap.mismatch = (!same).then_some(press);
        // Where a jog ends is only observed, by a client too.
        self.model.observe(&end.status());
        Some(gap)
    }

    /// Gives the twin a command, and perhaps a release so many ticks later; returns where it is from
    /// there on in each tick, until it rests.
    fn obey(&mut self, command: &Command, release: Option<(u32, Command)>) -> Vec<ArmPlace> {
        self.send(command);
        let mut passed = vec![self.place()];
        let mut resting = 0;
        while resting < REST_TICKS {
            self.tick += 1;
            self.controller.handle_time(TICK * self.tick);
            let place = self.place();
            resting = if passed.last() == Some(&place) {
                resting + 1
            } else {
                0
            };
            passed.push(place);
            if let Some((ticks, release)) = &release
                && passed.len() == 1 + *ticks as usize
            {
                self.send(release);
            }
        }
        passed.truncate(passed.len() - REST_TICKS);
        while self.controller.poll_bytes().is_some() {}
        passed
    }

    /// Sends in the middle of a tick, when the twin does not calculate.
    fn send(&mut self, command: &Command) {
        let bytes = command.emit(&DIALECT).to_bytes();
        let at: Duration = TICK * self.tick + TICK / 2;
        self.controller.handle_bytes(at, &bytes);
    }

    fn place(&self) -> ArmPlace {
        let joints = self.controller.joints_at(TICK * self.tick);
        ArmPlace::at_joints(joints, self.model.tool)
    }
}

impl Gap {
    fn is_in_time(&self) -> bool {
        self.early_s <= EARLY_S && self.late_s <= LATE_S
    }
}

/// The path of the model, sampled.
struct Path(Vec<Position>);

impl Path {
    fn of(lasts_s: f64, place_at: impl Fn(f64) -> Option<ArmPlace>) -> Option<Self> {
        let count = (lasts_s / SAMPLE_S).ceil().max(1.0);
        let mut points = Vec::new();
        let mut n = 0.0;
        while n <= count {
            points.push(place_at(lasts_s * n / count)?.pose.position);
            n += 1.0;
        }
        Some(Self(points))
    }

    fn end(&self) -> Position {
        *self.0.last().expect("it has two points at least")
    }

    /// Compares the way of the twin, tick by tick from its beginning.
    fn gap(&self, passed: &[ArmPlace], lasts_s: f64) -> Gap {
        let took_s = seconds(passed.len() - 1);
        let of_twin = passed.iter().enumerate().step_by(4);
        // Twin and model may take a different time for the same path.
        let stretch = if took_s > 0.0 { lasts_s / took_s } else { 1.0 };
        let offs = of_twin.map(|(tick, place)| {
            self.off_mm(
                place.pose.position,
                seconds(tick) * stretch / lasts_s.max(TICK_S),
            )
        });
        Gap {
            motions: 1,
            path_mm: offs.fold(0.0, f64::max),
            early_s: (lasts_s - took_s).max(0.0),
            late_s: (took_s - lasts_s).max(0.0),
            ..Gap::default()
        }
    }

    /// How far a position is from the path around this share of it.
    fn off_mm(&self, at: Position, share: f64) -> f64 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "it is an index"
        )]
        let middle = (share * self.0.len() as f64) as usize;
        let low = middle.saturating_sub(NEAR_SAMPLES).min(self.0.len() - 2);
        let high = (middle + NEAR_SAMPLES).min(self.0.len());
        let sides = self.0[low..high].windows(2);
        let offs = sides.map(|side| off_segment_mm(side[0], side[1], at));
        offs.fold(f64::INFINITY, f64::min)
    }
}

fn off_segment_mm(from: Position, to: Position, at: Position) -> f64 {
    let dot = |a: Position, b: Position| a.x.0 * b.x.0 + a.y.0 * b.y.0 + a.z.0 * b.z.0;
    let (way, here) = (to - from, at - from);
    let squared = dot(way, way);
    let share = if squared > 0.0 {
        (dot(way, here) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (here - way * share).length().0
}

fn turned_deg(a: &Joints, b: &Joints) -> f64 {
    let turns = [
        a.base - b.base,
        a.rear - b.rear,
        a.fore - b.fore,
        a.servo - b.servo,
    ];
    turns
        .map(|turn| turn.abs().0)
        .into_iter()
        .fold(0.0, f64::max)
}

fn seconds(ticks: usize) -> f64 {
    f64::from(u32::try_from(ticks).expect("it is a short run")) * TICK_S
}

fn command(kind: Kind, random: &mut Random) -> Command {
    let mode = match kind {
        Kind::Lines => MovingMode::MovL,
        Kind::Jumps => MovingMode::Jump,
        _ => MovingMode::MovJ,
    };
    if kind == Kind::Vectors {
        let [x_mm, y_mm, z_mm] =
            [(-25.0, 25.0), (-25.0, 25.0), (-8.0, 8.0)].map(|range| between(random, range));
        return WriteVector::by(x_mm, y_mm, z_mm, between(random, (2.0, 60.0))).into();
    }
    if random.chance(50.0) {
        let [x_mm, y_mm, z_mm] =
            [(160.0, 290.0), (-150.0, 150.0), (-60.0, 110.0)].map(|range| between(random, range));
        let rotation_deg = between(random, (-60.0, 60.0));
        let target = MoveTo {
            rotation_deg,
            ..MoveTo::to(x_mm, y_mm, z_mm)
        };
        return target.with_mode(mode).into();
    }
    let angles = [(-90.0, 90.0), (0.0, 80.0), (-5.0, 90.0), (-80.0, 80.0)]
        .map(|range| between(random, range));
    MoveJoints::to(angles).with_mode(mode).into()
}

/// A button and its release.
fn buttons(random: &mut Random) -> (Command, Command) {
    let percent = between(random, (1.0, 100.0));
    if random.chance(50.0) {
        let axis = JointJogAxis::ALL[1 + random.below(8) as usize];
        let jog = |axis, percent| Command::from(JointJog::new(axis, percent));
        (jog(axis, percent), jog(JointJogAxis::Released, 0.0))
    } else {
        let axis = LinearJogAxis::ALL[1 + random.below(8) as usize];
        let jog = |axis, percent| Command::from(LinearJog::new(axis, percent));
        (jog(axis, percent), jog(LinearJogAxis::Released, 0.0))
    }
}

fn setting(random: &mut Random) -> Command {
    let values: [f32; 6] = std::array::from_fn(|_| between(random, (10.0, 200.0)));
    match random.below(5) {
        0 => Command::from(Configuration::Teach {
            joint_speed_deg_s: values[0] / 4.0,
            joint_acceleration_deg_s2: values[1],
            servo_speed_deg_s: values[2] / 4.0,
            servo_acceleration_deg_s2: values[3],
            linear_speed_mm_s: values[4] / 2.0,
            linear_acceleration_mm_s2: values[5],
        }),
        1 => Configuration::Playback {
            joint_speed_deg_s: values[0],
            joint_acceleration_deg_s2: values[1],
            servo_speed_deg_s: values[2],
            servo_acceleration_deg_s2: values[3],
            linear_speed_mm_s: values[4],
            linear_acceleration_mm_s2: values[5],
            default_pause_s: 0.0,
            jump_height_mm: between(random, (0.0, 40.0)),
        }
        .into(),
        2 => Configuration::Writing {
            acceleration_mm_s2: values[0],
        }
        .into(),
        3 => {
            let tools = [Tool::SuctionCup, Tool::Laser];
            let tool = tools[random.below(2) as usize];
            Configuration::EndEffector { tool: tool.into() }.into()
        }
        _ => PlaybackAdjustment {
            speed_percent: values[0] / 2.0,
            acceleration_percent: values[1] / 2.0,
            teach_speed_percent: 50.0,
        }
        .into(),
    }
}

fn between(random: &mut Random, (low, high): (f64, f64)) -> f32 {
    single(low + random.share() * (high - low))
}

const DIALECT: Dialect = Dialect::FIRMWARE_1_1;
pub(crate) const SCRIPTS: u64 = 1000;
/// A script has 1 to 6 motions.
const MAX_MOTIONS: u32 = 6;
/// Random motions that are tried until the model allows one.
const TRIES: u32 = 50;
/// An arm that stands so long rests.
const REST_TICKS: usize = 15;
const SAMPLE_S: f64 = 0.005;
/// A tenth of a second before and behind.
const NEAR_SAMPLES: usize = 20;
/// What the rounding of the twin may add to an end, and to a path between ticks.
const END_MM: f64 = 0.01;
const END_DEG: f64 = 0.01;
const PATH_MM: f64 = 0.05;
/// A jog may be so many ticks at its speed longer.
const JOG_TICKS: f64 = 2.0;
/// The length of a degree at the longest reach, in mm; a millimetre is shorter.
const LEVER: f64 = 321.0 * std::f64::consts::PI / 180.0;
/// A tick until the command is taken, and one for each of the three parts of a JUMP.
const EARLY_S: f64 = 0.05;
const LATE_S: f64 = 0.12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_scripts_of_every_kind_do_on_the_twin_what_the_motion_model_says() {
        // Others than those of the page.
        for number in SCRIPTS..SCRIPTS + 100 {
            for kind in Kind::ALL {
                let gap = compare(kind, number);
                assert!(gap.motions > 0, "{kind:?} {number} moves nothing");
                assert!(gap.mismatch.is_none(), "{kind:?} {number}: {gap:?}");
            }
        }
    }
}
