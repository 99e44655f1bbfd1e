//! Done means done: what a session tells to be over is over on the arm, whatever it was, on links of
//! any latency and at any phase of the status period.

mod late;
mod pauses;

use std::time::Duration;

use crate::common::{button, move_to, ms, playback};
use dobot_arm::Tool;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_geometry::Random;
use dobot_session::{CommandId, Connection, Event, SendError};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::{
    Command, Configuration, Gesture, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MouseMove,
    MoveJoints, MoveTo, MovingMode, PlaybackAdjustment, Voice, WriteVector,
};

use self::late::Late;

/// What is tried: a state of the protocol, and what of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CommandKind {
    Mouse,
    Point,
    Turn,
    Vector,
    Voice,
    Hand,
    JointRelease,
    LinearRelease,
    Switch,
    Settings,
    Angles,
    Tool,
    Percent,
}

const COMMAND_KINDS: [CommandKind; 13] = [
    CommandKind::Mouse,
    CommandKind::Point,
    CommandKind::Turn,
    CommandKind::Vector,
    CommandKind::Voice,
    CommandKind::Hand,
    CommandKind::JointRelease,
    CommandKind::LinearRelease,
    CommandKind::Switch,
    CommandKind::Settings,
    CommandKind::Angles,
    CommandKind::Tool,
    CommandKind::Percent,
];

#[derive(Debug)]
struct Dice(Random);

impl Dice {
    fn below(&mut self, most: u64) -> u64 {
        self.0.number() % most
    }

    #[expect(clippy::cast_precision_loss, reason = "a share of it is enough")]
    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.below(1 << 20) as f32 / (1 << 20) as f32)
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[usize::try_from(self.below(all.len() as u64)).expect("there are few")]
    }

    fn mode(&mut self) -> MovingMode {
        self.one_of(&[MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ])
    }

    /// Somewhere, or one of few places, to which others lead too.
    fn point(&mut self) -> MoveTo {
        if self.below(3) == 0 {
            let y = self.one_of(&[-20.0, 0.0, 20.0]);
            return move_to(self.mode(), 230.0, y, 20.0);
        }
        let [x, y, z] = [(205.0, 255.0), (-60.0, 60.0), (-10.0, 50.0)]
            .map(|(low, high)| self.between(low, high));
        move_to(self.mode(), x, y, z)
    }

    /// A pause that is mostly none.
    fn pause_s(&mut self) -> f32 {
        if self.below(3) == 0 {
            self.between(0.1, 2.0)
        } else {
            0.0
        }
    }

    fn sign(&mut self) -> f32 {
        self.one_of(&[-1.0, 1.0])
    }

    fn command(&mut self, kind: CommandKind, stock: bool) -> Command {
        match kind {
            CommandKind::Mouse => {
                let most = if stock { 25.0 } else { 12.0 };
                let [x, y, z] = [0, 1, 2].map(|_| self.sign() * self.between(3.0, most));
                Command::from(MouseMove {
                    x,
                    y,
                    z: z / 2.0,
                    rotation_deg: self.between(-20.0, 20.0),
                    suction: self.below(2) == 0,
                })
            }
            CommandKind::Point => Command::from(MoveTo {
                rotation_deg: self.one_of(&[0.0, 15.0]),
                suction: self.below(2) == 0,
                pause_s: self.pause_s(),
                ..self.point()
            }),
            CommandKind::Turn => Command::from(MoveJoints {
                base_deg: self.between(-30.0, 30.0),
                rear_deg: self.between(35.0, 48.0),
                fore_deg: self.between(38.0, 50.0),
                servo_deg: self.between(-20.0, 20.0),
                suction: self.below(2) == 0,
                mode: self.mode(),
                gripper_deg: self.between(-10.0, 10.0),
                pause_s: self.pause_s(),
            }),
            CommandKind::Vector => {
                let [x_mm, y_mm] = [0, 1].map(|_| self.sign() * self.between(1.0, 15.0));
                Command::from(WriteVector::by(x_mm, y_mm, 0.0, self.between(10.0, 60.0)))
            }
            CommandKind::Voice => {
                let text = self.one_of(&["left ten", "right ten", "up ten", "down ten", "catch"]);
                Command::Voice(Voice::new(text).expect("it is short"))
            }
            CommandKind::Hand => self.hand(stock),
            CommandKind::JointRelease => released_joint(),
            CommandKind::LinearRelease => {
                Command::from(LinearJog::new(LinearJogAxis::Released, 0.0))
            }
            CommandKind::Switch => self.switch(),
            CommandKind::Settings => self.settings(),
            CommandKind::Angles => Command::from(Configuration::InitialAngles {
                rear_deg: self.between(40.0, 50.0),
                fore_deg: self.between(40.0, 50.0),
            }),
            CommandKind::Tool => Command::from(Configuration::EndEffector {
                tool: self.one_of(&[Tool::SuctionCup, Tool::Laser]).into(),
            }),
            CommandKind::Percent => Command::from(PlaybackAdjustment {
                speed_percent: self.between(30.0, 100.0),
                acceleration_percent: self.between(30.0, 100.0),
                teach_speed_percent: 100.0,
            }),
        }
    }

    fn hand(&mut self, stock: bool) -> Command {
        let [x, y, z] = if stock {
            [(-80.0, 80.0), (-80.0, 80.0), (200.0, 280.0)]
        } else {
            [(205.0, 255.0), (-60.0, 60.0), (-10.0, 50.0)]
        }
        .map(|(low, high)| self.between(low, high));
        let grab = self.below(2) == 0;
        Command::from(Gesture { x, y, z, grab })
    }

    fn switch(&mut self) -> Command {
        let axis = self.one_of(&[
            JointJogAxis::SuctionOn,
            JointJogAxis::SuctionOff,
            JointJogAxis::LaserOff,
        ]);
        button(axis, 0.0).into()
    }

    fn settings(&mut self) -> Command {
        if self.below(2) == 0 {
            let acceleration_mm_s2 = self.between(50.0, 300.0);
            return Command::from(Configuration::Writing { acceleration_mm_s2 });
        }
        playback(self.between(100.0, 200.0)).into()
    }

    /// A button to be held before it is released.
    fn pressed(&mut self, kind: CommandKind) -> Option<Command> {
        use JointJogAxis as J;
        use LinearJogAxis as L;
        let speed_percent = self.between(10.0, 60.0);
        match kind {
            CommandKind::JointRelease => {
                let all = [J::BasePlus, J::BaseMinus, J::ServoPlus, J::GripperOpen];
                let axis = self.one_of(&all);
                Some(Command::from(JointJog::new(axis, speed_percent)))
            }
            CommandKind::LinearRelease => {
                let axis = self.one_of(&[L::YPlus, L::YMinus, L::ZPlus, L::ZMinus]);
                Some(Command::from(LinearJog::new(axis, speed_percent)))
            }
            _ => None,
        }
    }
}

fn released_joint() -> Command {
    button(JointJogAxis::Released, 0.0).into()
}

/// An arm, a session with it over a link of some latency, and the dice.
struct Trial {
    arm: InProcess,
    connection: Connection,
    dice: Dice,
    personality: Personality,
    sent: u64,
    /// How long it took at the most from the end of something to the word of it.
    latest: Duration,
}

/// What an arm is doing, to compare with what it does later.
#[derive(Clone, Debug, PartialEq)]
struct Shown {
    joints: dobot_arm::Joints,
    servos: [u16; 2],
    pump: bool,
}

impl Trial {
    fn new(personality: Personality, seed: u64) -> Self {
        let power_up = PowerUp::new(personality);
        let arm = InProcess::new(VirtualArm::new(
            Controller::power_up(power_up),
            SerialLine::STOCK,
        ));
        let mut dice = Dice(Random::new(seed));
        let latency = ms(dice.below(3) * dice.below(101));
        let jitter = (dice.below(3) == 0).then(|| Dice(Random::new(seed + 1000)));
        let late = Late::new(arm.clone(), latency, jitter);
        Self {
            connection: Connection::over_peer(late, Some(personality.dialect())),
            arm,
            dice,
            personality,
            sent: 0,
            latest: Duration::ZERO,
        }
    }

    fn is_stock(&self) -> bool {
        self.personality == Personality::Firmware11
    }

    fn shown(&self) -> Shown {
        let arm = self.arm.arm();
        let controller = arm.controller();
        let outputs = controller.outputs();
        Shown {
            joints: controller.joints_at(arm.now()),
            servos: [outputs.head_servo, outputs.gripper_servo],
            pump: outputs.pump,
        }
    }

    /// Lets time pass and forgets what happened meanwhile.
    async fn pass(&mut self, time: Duration) {
        self.connection.pass(time).await.expect("the link is open");
        while self.connection.session().has_event() {
            self.connection.next_event().await.expect("there is one");
        }
    }

    /// Something that the arm refuses, and the laser off that follows a refusal in a station.
    async fn refuse(&mut self) {
        // Initial angles cost the trust.
        self.connection.session_mut().confirm_pose();
        let far = self
            .connection
            .send(move_to(MovingMode::MovJ, 400.0, 0.0, 0.0));
        let far = far.expect("nobody has looked along its way");
        let reported = self.connection.completed(far).await;
        reported.expect_err("it is out of reach");
        self.pass(ms(700)).await;
        self.sent = self.arm.arm().controller().counters().begun;
        let laser_off = button(JointJogAxis::LaserOff, 0.0);
        let session = self.connection.session_mut();
        session.send_now(laser_off).expect("it is allowed");
        self.sent += 1;
        self.pass(ms(60)).await;
    }

    /// Sends a command and waits for its end; panics if it is reported too early or never.
    async fn run(&mut self, kind: CommandKind) {
        self.connection.session_mut().confirm_pose();
        let phase = Duration::from_micros(self.dice.below(80_000));
        self.pass(phase).await;
        if let Some(pressed) = self.dice.pressed(kind) {
            self.connection.send(pressed).expect("it is allowed");
            self.sent += 1;
            let held = ms(100 + self.dice.below(400));
            self.pass(held).await;
        }
        let command = self.dice.command(kind, self.is_stock());
        let id = match self.connection.send(command) {
            Ok(id) => id,
            Err(SendError::OnTheSpot | SendError::Trap(_)) => return,
            Err(error) => panic!("{command:?}: {error}"),
        };
        self.sent += 1;
        self.wait_for(id, &command).await;
        self.check_over(&command).await;
        self.come_back().await;
    }

    /// Sends some commands in one go and waits for their ends, each in its turn.
    async fn run_all(&mut self, count: u64) {
        let phase = Duration::from_micros(self.dice.below(80_000));
        self.pass(phase).await;
        let mut given = Vec::new();
        for _ in 0..count {
            let kind = self.dice.one_of(&TOGETHER);
            let command = self.dice.command(kind, self.is_stock());
            // Where a stock arm is not sent it need not go.
            if let Ok(id) = self.connection.send(command) {
                given.push((id, command));
            }
        }
        for (id, command) in &given {
            self.sent += 1;
            self.wait_for(*id, command).await;
            let begun = self.arm.arm().controller().counters().begun;
            assert!(begun >= self.sent, "{command:?} is reported as completed");
        }
        if let Some((_, last)) = given.last() {
            self.check_over(last).await;
        }
        self.come_back().await;
    }

    /// Nothing of what was sent goes on.
    async fn check_over(&mut self, command: &Command) {
        let begun = self.arm.arm().controller().counters().begun;
        assert_eq!(begun, self.sent, "{command:?} is reported as completed");
        let then = self.shown();
        let until = self.connection.now() + ms(1200);
        while self.connection.now() < until {
            self.pass(ms(20)).await;
            let now = self.shown();
            assert_eq!(then, now, "{command:?} was reported as completed");
        }
    }

    /// Back to where every trial has its room, once in a while without a word about a link.
    async fn come_back(&mut self) {
        let middle = move_to(MovingMode::MovJ, 230.0, 0.0, 20.0);
        let Ok(id) = self.connection.send(middle) else {
            return;
        };
        self.sent += 1;
        self.wait_for(id, &middle.into()).await;
    }

    async fn wait_for(&mut self, id: CommandId, command: &Command) {
        let began = self.connection.now();
        let mut before = self.shown();
        let mut moved = began;
        while self.connection.now() < began + Duration::from_secs(30) {
            let event = self.connection.next_event().await;
            let now = self.shown();
            if now != before {
                moved = self.connection.now();
                before = now;
            }
            match event.expect("the link is open") {
                Event::Completed(over) if over == id => {
                    self.latest = self.latest.max(self.connection.now().saturating_sub(moved));
                    return;
                }
                event @ (Event::NotReached { .. }
                | Event::LinkLost { .. }
                | Event::Reset { .. }) => {
                    panic!("{command:?}: {event:?}")
                }
                _ => {}
            }
        }
        panic!("{command:?} is never reported as completed");
    }
}

/// What leads somewhere and some way further, and some between that does not move the arm.
const TOGETHER: [CommandKind; 7] = [
    CommandKind::Point,
    CommandKind::Point,
    CommandKind::Turn,
    CommandKind::Vector,
    CommandKind::Switch,
    CommandKind::Settings,
    CommandKind::Percent,
];

/// One kind, or several commands in one go.
async fn try_it(personality: Personality, kind: Option<CommandKind>, seed: u64) -> Duration {
    let mut trial = Trial::new(personality, seed);
    trial
        .connection
        .next_status()
        .await
        .expect("a status arrives");
    // Half of the sessions have seen how fast the link is.
    if seed.is_multiple_of(2) {
        trial.come_back().await;
    }
    for _ in 0..EACH {
        if trial.dice.below(3) == 0 {
            trial.refuse().await;
        }
        if let Some(kind) = kind {
            trial.run(kind).await;
        } else {
            let count = 2 + trial.dice.below(7);
            trial.run_all(count).await;
        }
    }
    trial.latest
}

/// So many of each kind with each personality, with another latency each.
const TRIALS: u64 = 12;
/// So many in a row.
const EACH: u64 = 3;

#[test]
fn a_reported_completion_is_true_at_any_phase_and_latency() {
    let trials = std::env::var("DOBOT_TRIALS").map_or(TRIALS, |it| it.parse().expect("a number"));
    let runtime = tokio::runtime::Builder::new_current_thread()
        .build()
        .expect("it needs nothing");
    let mut failures = Vec::new();
    for personality in Personality::ALL {
        for kind in COMMAND_KINDS.map(Some).into_iter().chain([None]) {
            // A stock arm hears no voice on this port (note N17).
            if kind == Some(CommandKind::Voice) && personality == Personality::Firmware11 {
                continue;
            }
            let mut wrong = Vec::new();
            let mut latest = Duration::ZERO;
            for seed in 0..trials {
                let run = std::panic::AssertUnwindSafe(|| {
                    runtime.block_on(try_it(personality, kind, seed))
                });
                match std::panic::catch_unwind(run) {
                    Ok(it) => latest = latest.max(it),
                    Err(_) => wrong.push(seed),
                }
            }
            println!("{personality} {kind:?}: reported {latest:?} late at most, wrong: {wrong:?}");
            if !wrong.is_empty() {
                failures.push((personality, kind, wrong));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}
