//! The motion model: what is known of an arm, and what a command makes of it.

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
mod status;
mod trajectory;
mod vector;

use dobot_arm::{Calibration, Joints, Tool, forward};
use dobot_wire::{
    Command, Configuration, Dialect, MoveJoints, MoveTo, MovingMode, Status, Voice, VoiceOrder,
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
pub use self::segment::{Bend, Segment};
pub use self::settings::ArmSettings;
pub use self::trajectory::Trajectory;

/// What is believed of an arm: where it is and what it was told, before or after a command.
///
/// ```
/// # use dobot_arm::{Joints, Tool};
/// # use dobot_motion::{ArmPlace, Model};
/// # use dobot_wire::{Command, Dialect, WriteVector};
/// let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
/// let model = Model::standing(Dialect::SPECIFICATION, here);
/// let vector = Command::from(WriteVector::by(0.0, 20.0, 0.0, 40.0));
/// let trajectory = model.trajectory(&vector)?;
/// // 8 mm speeding up to 40 mm/s at 100 mm/s2, as much to slow down, 4 mm between.
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
    /// Where the arm is.
    pub place: ArmPlace,
    /// What is mounted.
    pub tool: Tool,
    /// Whether the pump runs.
    pub suction: bool,
    /// Whether the laser is on.
    pub laser: bool,
    /// The gripper's angle in degrees.
    pub gripper_deg: f64,
    /// What configuration has told.
    pub settings: ArmSettings,
    /// How the arm understands commands.
    pub dialect: Dialect,
    /// How it differs from the drawing of it: what is believed are its own words.
    pub calibration: Calibration,
    /// Whether it serves its Bluetooth port, on which every arm hears voice (note N38).
    pub is_bluetooth: bool,
    /// Whether `place` is known: not behind a jog, until the arm was seen at rest.
    pub(crate) knows_place: bool,
    /// What the last vector left.
    pub(crate) left: LeftSpeed,
    /// The jog that goes on, or whose speed the arm keeps.
    pub(crate) jog: Option<JogTrajectory>,
    /// The pause that begins anew as long as nothing follows, in seconds (note N47).
    pub(crate) idle_pause_s: f64,
    /// The mouse moves and gestures with which the next one is averaged.
    pub(crate) followed: Followed,
    /// What may be left of straight lines.
    pub(crate) lines: Lines,
}

/// What a stock arm keeps of its straight lines (note N46).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Lines {
    /// Nothing: there was none.
    #[default]
    None,
    /// Nothing, if the last one was gone to its end.
    Whole,
    /// One may have been cut short: the next one would begin with a jump, unless a MOVJ comes before
    /// it.
    Cut,
}

impl Model {
    /// An arm that tells a status and has not been configured: stock settings, and the suction
    /// cup unless the status is that of a laser. What others told it before is not known.
    #[must_use]
    pub fn new(dialect: Dialect, status: &Status) -> Self {
        let mut model = Self::standing(dialect, ArmPlace::of_status(status));
        model.left = model.left.perhaps();
        model.observe(status);
        model
    }

    /// An arm that stands at a place and has not been configured: stock settings, suction cup.
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

    /// The same arm, which differs so from the drawing of it.
    #[must_use]
    pub const fn calibrated(mut self, calibration: Calibration) -> Self {
        self.calibration = calibration;
        self
    }

    /// Takes over place, pump and gripper from the status of an arm at rest, and the tool where its
    /// reach shows that it is another one.
    pub fn observe(&mut self, status: &Status) {
        self.place = ArmPlace::of_status(status);
        self.tool = tool_of(&self.place, self.tool);
        self.suction = status.suction;
        self.gripper_deg = status.gripper_deg.into();
        self.knows_place = true;
        self.jog = self.jog.filter(|_| self.dialect.keeps_jog_speed);
    }

    /// Takes note that it is unknown where the arm is, until it is seen at rest.
    pub const fn lose_place(&mut self) {
        self.knows_place = false;
        self.left = self.left.perhaps();
        if !matches!(self.lines, Lines::None) {
            self.lines = Lines::Cut;
        }
    }

    /// Whether [`Model::place`] is known: not behind a jog or a smoothed motion, until the arm was
    /// [`seen`](Self::observe) at rest.
    #[must_use]
    pub const fn knows_place(&self) -> bool {
        self.knows_place
    }

    /// How long a command that comes late may wait until it is taken, in seconds: a pause that begins
    /// anew as long as nothing follows (note N47).
    #[must_use]
    pub const fn idle_pause_s(&self) -> f64 {
        self.idle_pause_s
    }

    /// The jog that goes on, if one does. Of a stock arm also one that was stopped by something else
    /// than its release: it keeps the speed for that (note N44).
    #[must_use]
    pub const fn jog(&self) -> Option<&JogTrajectory> {
        self.jog.as_ref()
    }

    /// The model in the moment in which a command begins: what acts at once has acted (settings,
    /// switches), what comes behind the motion has not.
    #[must_use]
    pub fn begun(&self, command: &Command) -> Self {
        let mut model = *self;
        model.idle_pause_s = model.repeated_s(command);
        if !matches!(command, Command::MouseMove(_) | Command::Gesture(_)) {
            model.followed.end_row();
        }
        match command {
            Command::MoveTo(_) | Command::MoveJoints(_) => {}
            Command::WriteVector(it) => model.laser = model.laser_during(it),
            Command::MouseMove(it) => {
                model.followed.take_mouse(it);
                model.follow(it.suction, MOUSE_DEG_S2, |it| it.mouse_swings);
            }
            Command::Gesture(it) => {
                model.followed.take_hand(it);
                model.follow(it.grab, GESTURE_DEG_S2, |it| it.scales_gesture);
            }
            Command::Voice(it) => model.suction = model.suction_after(it),
            Command::JointJog(_) | Command::LinearJog(_) => model.press(command),
            Command::Configuration(it) => model.configure(it),
            Command::PlaybackAdjustment(it) => {
                let dialect = model.dialect;
                model.settings.adjust(it, &dialect);
            }
        }
        model
    }

    /// The model when the command is over.
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
            Command::MoveTo(it) => {
                model.note_lines(it.mode);
                model.set_tool(it.suction, it.gripper_deg);
            }
            Command::MoveJoints(it) => {
                model.note_lines(it.mode);
                model.set_tool(it.suction, it.gripper_deg);
            }
            Command::Voice(_) => model.note_lines(MovingMode::MovL),
            // Behind the last vector the laser goes off, unless the dialect leaves it (note N36).
            Command::WriteVector(_) if !model.dialect.has_rapid_laser_mode => model.laser = false,
            _ => {}
        }
        model
    }

    /// The pause of a command, if it begins anew as long as nothing follows: not behind a JUMP.
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

    /// A line is taken to be gone to its end, and a MOVJ clears away what a line left. At a limit the
    /// arm is refused the tick in which it would notice that the line is gone.
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
            // From now on it says its true angles.
            Configuration::InitialAngles { .. } => {
                self.calibration = self.calibration.without_zeros();
            }
            _ => {}
        }
    }
}

/// The tool by which position and angles of a status belong together.
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
