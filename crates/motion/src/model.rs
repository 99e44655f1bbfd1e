//! The motion model: the state of an arm and the effect of commands on it.

mod button;
mod calibrated;
mod error;
mod follow;
mod followed;
mod hand_scale;
mod jog;
mod laser;
mod left_speed;
mod lifts;
mod motion;
mod place;
mod plan;
mod segment;
mod settings;
mod stretched_move;
mod trajectory;
mod vector;

use dobot_arm::{Calibration, Joints, Tool, forward};
use dobot_wire::{
    Command, Configuration, Dialect, MoveJoints, MoveTo, MovingMode, Status, Voice, VoiceOrder,
    single,
};

use self::followed::Followed;
use self::left_speed::LeftSpeed;

pub use self::button::{Button, JogAxis};
pub use self::calibrated::to_raw;
pub use self::error::{LONGEST_S, TrajectoryError};
pub use self::hand_scale::{HandAxis, HandScale};
pub use self::jog::JogTrajectory;
pub use self::laser::{LASER_OFF, burns};
pub use self::place::ArmPlace;
pub use self::segment::{Interpolation, Segment};
pub use self::settings::ArmSettings;
pub use self::stretched_move::{Stretching, TurnBounds};
pub use self::trajectory::Trajectory;

/// The estimated state of an arm before or after a command: position and settings.
///
/// ```
/// # use dobot_arm::{Joints, Tool};
/// # use dobot_motion::{ArmPlace, Model};
/// # use dobot_wire::{Command, Dialect, WriteVector};
/// let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
/// let model = Model::standing(Dialect::SPECIFICATION, here);
/// let vector = Command::from(WriteVector::by(0.0, 20.0, 0.0, 40.0));
/// let trajectory = model.trajectory(&vector)?;
/// // 8 mm accelerating to 40 mm/s at 100 mm/s2, as much to slow down, 4 mm between.
/// assert!((trajectory.duration_s().unwrap() - 0.9).abs() < 1e-9);
/// let after = model.after(&vector, &trajectory);
/// assert!((after.place.pose.position.y.0 - 20.0).abs() < 1e-9);
/// # Ok::<(), dobot_motion::TrajectoryError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "two switches of the arm, and two things that are known or not"
)]
pub struct Model {
    /// The position of the arm.
    pub place: ArmPlace,
    /// The mounted tool.
    pub tool: Tool,
    /// Whether the pump runs.
    pub suction: bool,
    /// Whether the laser is on.
    pub laser: bool,
    /// The gripper's angle in degrees.
    pub gripper_deg: f64,
    /// The settings from configuration commands.
    pub settings: ArmSettings,
    /// The arm's dialect.
    pub dialect: Dialect,
    /// The calibration; the model itself uses raw positions.
    pub calibration: Calibration,
    /// Whether it serves its Bluetooth port, on which every arm accepts voice (note N38).
    pub is_bluetooth: bool,
    /// Whether `place` is known: not after a jog, until the arm was observed at rest.
    pub(crate) knows_place: bool,
    /// The speed left by the last vector.
    pub(crate) left: LeftSpeed,
    /// The running jog, or the one whose speed the arm keeps.
    pub(crate) jog: Option<JogTrajectory>,
    /// The pause that restarts until another command follows, in seconds (note N47).
    pub(crate) idle_pause_s: f64,
    /// The mouse moves and gestures with which the next one is averaged.
    pub(crate) followed: Followed,
    /// The state left by straight lines.
    pub(crate) lines: Lines,
}

/// The state that a stock arm keeps from its straight lines (note N46).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Lines {
    /// There was no line.
    #[default]
    None,
    /// No state, provided that the last line ran to its end.
    Whole,
    /// A line may have been cut short: the next one would begin with a jump, unless a MOVJ comes
    /// first.
    Cut,
}

impl Model {
    /// Creates the model of an arm that reports a status and has not been configured: stock
    /// settings, and the suction cup unless the status is that of a laser. Earlier commands of
    /// others are unknown.
    #[must_use]
    pub fn new(dialect: Dialect, status: &Status) -> Self {
        let mut model = Self::standing(dialect, ArmPlace::of_status(status));
        model.left = model.left.perhaps();
        model.observe(status);
        model
    }

    /// Creates the model of an unconfigured arm at a position: stock settings, suction cup.
    #[must_use]
    pub fn standing(dialect: Dialect, place: ArmPlace) -> Self {
        Self {
            place,
            tool: Tool::SuctionCup,
            suction: false,
            laser: false,
            gripper_deg: 0.0,
            settings: ArmSettings::stock(&dialect),
            dialect,
            calibration: Calibration::NONE,
            is_bluetooth: false,
            knows_place: true,
            left: LeftSpeed::NOTHING,
            jog: None,
            idle_pause_s: 0.0,
            followed: Followed::default(),
            lines: Lines::None,
        }
    }

    /// Sets the calibration.
    #[must_use]
    pub const fn calibrated(mut self, calibration: Calibration) -> Self {
        self.calibration = calibration;
        self
    }

    /// Adopts position, pump and gripper from the status of an arm at rest, and changes the tool if
    /// the reach requires another one.
    pub fn observe(&mut self, status: &Status) {
        self.place = ArmPlace::of_status(status);
        self.tool = tool_of(&self.place, self.tool);
        self.suction = status.suction;
        self.gripper_deg = status.gripper_deg.into();
        self.knows_place = true;
        self.jog = self.jog.filter(|_| self.dialect.keeps_jog_speed);
    }

    /// Returns the commands that give this tool and these settings to an arm that was just switched
    /// on.
    pub fn configuration(&self) -> impl Iterator<Item = Command> + use<> {
        let tool = (self.tool != Tool::SuctionCup).then(|| {
            Configuration::EndEffector {
                tool: self.tool.into(),
            }
            .into()
        });
        tool.into_iter()
            .chain(self.settings.commands(&self.dialect))
    }

    /// Marks the position as unknown until the arm is observed at rest.
    pub const fn lose_place(&mut self) {
        self.knows_place = false;
        self.left = self.left.perhaps();
        if !matches!(self.lines, Lines::None) {
            self.lines = Lines::Cut;
        }
    }

    /// Whether [`Model::place`] is known: not after a jog or a smoothed motion, until the arm was
    /// [observed](Self::observe) at rest.
    #[must_use]
    pub const fn knows_place(&self) -> bool {
        self.knows_place
    }

    /// Returns how long a late command may wait before the arm takes it, in seconds: a pause that
    /// restarts until another command follows (note N47).
    #[must_use]
    pub const fn idle_pause_s(&self) -> f64 {
        self.idle_pause_s
    }

    /// Returns the status of the arm with this model.
    #[must_use]
    pub fn status(&self) -> Status {
        // The coordinates match exactly the angles in the status.
        Status {
            suction: self.suction,
            gripper_deg: single(self.gripper_deg),
            ..ArmPlace::at_joints(self.place.joints, self.tool).status()
        }
    }

    /// Returns the running jog. A stock arm also keeps the speed of a jog that was stopped by
    /// something other than its release (note N44).
    #[must_use]
    pub const fn jog(&self) -> Option<&JogTrajectory> {
        self.jog.as_ref()
    }

    /// Returns the model at the start of a command: immediate effects (settings, switches) have
    /// happened, effects after the motion have not.
    #[must_use]
    pub fn begun(&self, command: &Command) -> Self {
        let mut model = *self;
        model.idle_pause_s = model.repeated_s(command);
        if !matches!(command, Command::MouseMove(_) | Command::Gesture(_)) {
            model.followed.end_row();
        }
        match command {
            Command::MoveTo(_) | Command::MoveJoints(_) => {}
            Command::WriteVector(write) => model.laser = model.laser_during(write),
            Command::MouseMove(mouse) => {
                model.followed.take_mouse(mouse);
                model.follow(mouse.suction, MOUSE_DEG_S2, |dialect| dialect.mouse_swings);
            }
            Command::Gesture(hand) => {
                model.followed.take_hand(hand);
                model.follow(hand.grab, GESTURE_DEG_S2, |dialect| dialect.scales_gesture);
            }
            Command::Voice(voice) => model.suction = model.suction_after(voice),
            Command::JointJog(_) | Command::LinearJog(_) => model.press(command),
            Command::Configuration(configuration) => model.configure(configuration),
            Command::PlaybackAdjustment(adjustment) => {
                model.settings.adjust(adjustment, &model.dialect);
            }
        }
        model
    }

    /// Returns the model after the command.
    #[must_use]
    pub fn after(&self, command: &Command, trajectory: &Trajectory) -> Self {
        let mut model = self.begun(command);
        model.place = trajectory.to;
        model.knows_place = trajectory.knows_end;
        model.jog = match Button::of(command) {
            Some(Button::Held { .. } | Button::Released) => trajectory.jog(),
            _ => self.jog.filter(|_| self.dialect.keeps_jog_speed),
        };
        model.left = trajectory.left.unwrap_or(model.left);
        match command {
            Command::MoveTo(move_to) => {
                model.note_lines(move_to.mode);
                model.set_tool(move_to.suction, move_to.gripper_deg);
            }
            Command::MoveJoints(move_joints) => {
                model.note_lines(move_joints.mode);
                model.set_tool(move_joints.suction, move_joints.gripper_deg);
            }
            Command::Voice(_) => model.note_lines(MovingMode::MovL),
            // After the last vector the laser switches off, unless the dialect leaves it on (note
            // N36).
            Command::WriteVector(_) if !model.dialect.has_rapid_laser_mode => model.laser = false,
            _ => {}
        }
        model
    }

    /// Returns the pause of a command if it restarts until another command follows: not after a
    /// JUMP.
    fn repeated_s(&self, command: &Command) -> f64 {
        match command {
            Command::MoveTo(MoveTo { mode, .. }) | Command::MoveJoints(MoveJoints { mode, .. })
                if *mode != MovingMode::Jump && self.dialect.repeats_pause =>
            {
                self.pause_s(command)
            }
            _ => 0.0,
        }
    }

    fn suction_after(&self, voice: &Voice) -> bool {
        match VoiceOrder::parse(voice) {
            Some(VoiceOrder::Catch) => true,
            Some(VoiceOrder::Release) => false,
            _ => self.suction,
        }
    }

    /// Updates the state of straight lines: a line is assumed to run to its end, and a MOVJ clears
    /// its state. At a limit the arm is refused the tick in which it would notice the end of the
    /// line.
    fn note_lines(&mut self, mode: MovingMode) {
        self.lines = match (self.lines, mode) {
            (_, MovingMode::MovL) if self.place.is_at_limit() => Lines::Cut,
            (Lines::None, MovingMode::MovL) | (Lines::Cut, MovingMode::MovJ) => Lines::Whole,
            (lines, _) => lines,
        };
    }

    fn set_tool(&mut self, suction: bool, gripper_deg: f32) {
        self.suction = suction;
        self.gripper_deg = gripper_deg.into();
    }

    fn follow(&mut self, grab: bool, acceleration_deg_s2: f64, smooths: fn(&Dialect) -> bool) {
        self.suction = grab;
        if smooths(&self.dialect) {
            self.settings.overwrite_joints(acceleration_deg_s2);
        }
    }

    fn press(&mut self, command: &Command) {
        match Button::of(command) {
            Some(Button::Suction(on)) => self.suction = on,
            Some(Button::Laser(on)) => self.laser = on,
            _ => {}
        }
    }

    fn configure(&mut self, configuration: &Configuration) {
        self.settings.configure(configuration);
        match configuration {
            Configuration::EndEffector { tool } => self.tool = (*tool).into(),
            // From now on it reports its actual angles.
            Configuration::InitialAngles { .. } => {
                self.calibration = self.calibration.without_zeros();
            }
            _ => {}
        }
    }
}

/// Returns the tool with which position and angles of a status agree.
fn tool_of(place: &ArmPlace, believed: Tool) -> Tool {
    let reach_mm = |joints: &Joints, tool| forward(joints, tool).position.reach().0;
    let reported_mm = place.pose.position.reach().0;
    let off_mm = |tool| (reach_mm(&place.joints, tool) - reported_mm).abs();
    if off_mm(believed) <= SAME_REACH_MM {
        return believed;
    }
    Tool::END_EFFECTORS
        .into_iter()
        .find(|&tool| off_mm(tool) <= SAME_REACH_MM)
        .unwrap_or(believed)
}

/// Position and angles of a status agree to 0.01 mm (note N22).
const SAME_REACH_MM: f64 = 0.05;
const MOUSE_DEG_S2: f64 = 100.0;
const GESTURE_DEG_S2: f64 = 500.0;
