//! Random requests of people and programs: good, bad, borderline and absurd.

use std::time::Duration;

use dobot_api::{ClientId, Jog, NewJob, Request};
use dobot_arm::{Position, Tool};
use dobot_host::VirtualStation;
use dobot_wire::{
    Command, Configuration, Dialect, Frame, Gesture, JointJog, JointJogAxis, LinearJog,
    LinearJogAxis, MouseMove, MoveJoints, MoveTo, MovingMode, Packet, PlaybackAdjustment, Voice,
    WriteMode, WriteVector,
};

use super::super::chance::Chance;
use super::super::jobs::Sort;

/// A request or an action.
#[derive(Clone, Debug)]
pub(crate) enum FuzzStep {
    Request(ClientId, Request),
    Packet(ClientId, Packet),
    /// A repeated step, with its count and interval: a series of mouse or hand packets, or a held
    /// button.
    Again(Box<Self>, u64, Duration),
    Submit(NewJob),
    Start(ClientId, u64),
    /// The cable is unplugged for this time.
    Unplug(Duration),
}

/// Those who ask.
#[derive(Debug)]
pub(crate) struct Asking {
    pub people: [ClientId; 3],
    pub watcher: ClientId,
    /// The laser is armed now and then.
    pub burns: bool,
    /// Buttons are held.
    pub jogs: bool,
    pub dialect: Dialect,
    pub jobs: Vec<u64>,
    pub before: Option<FuzzStep>,
    /// The current series of mouse or hand packets.
    pub row: Option<Command>,
}

impl Asking {
    /// Returns the next step.
    pub(crate) fn next(&mut self, chance: &mut Chance, station: &VirtualStation) -> FuzzStep {
        let who = chance.one(&self.people);
        let holder = station
            .supervisor()
            .state()
            .lease
            .map_or(who, |lease| lease.client);
        let who = if chance.below(10) == 0 { who } else { holder };
        let asked = match chance.below(100) {
            0..10 => match &self.before {
                Some(before) => before.clone(),
                None => FuzzStep::Request(who, Request::TakeLease),
            },
            10..35 => self.by(chance, who, |chance| command(chance, station)),
            35..50 => {
                let row = self.row(chance);
                let asked = self.by(chance, who, |_| row);
                let gap = Duration::from_millis(60) + chance.time(Duration::from_millis(240));
                Self::again(chance, asked, gap)
            }
            50..65 if self.jogs => {
                let asked = self.jog(chance, who);
                let gap = chance.time(Duration::from_millis(140));
                Self::again(chance, asked, gap)
            }
            65..70 => FuzzStep::Request(who, Request::Release),
            70..76 => FuzzStep::Packet(who, packet(chance)),
            76..79 => self.by(chance, who, |chance| voice(chance).into()),
            79..84 => self.job(chance, who),
            84..86 => FuzzStep::Request(self.watcher, Request::Stop { reason: None }),
            86..90 => FuzzStep::Request(who, Request::ResetStop),
            90 if station.supervisor().is_at_rest() => {
                FuzzStep::Unplug(chance.time(Duration::from_secs(4)))
            }
            _ => FuzzStep::Request(who, self.plain(chance)),
        };
        self.before = Some(asked.clone());
        asked
    }

    /// Over the API, or as the packet of a raw program.
    fn by(
        &self,
        chance: &mut Chance,
        who: ClientId,
        command: impl FnOnce(&mut Chance) -> Command,
    ) -> FuzzStep {
        let command = command(chance);
        if chance.below(2) == 0 {
            FuzzStep::Request(who, Request::Command { command })
        } else {
            FuzzStep::Packet(who, command.emit(&self.dialect))
        }
    }

    /// Half of the time once, else up to forty times.
    fn again(chance: &mut Chance, asked: FuzzStep, gap: Duration) -> FuzzStep {
        match chance.below(2) {
            0 => asked,
            _ => FuzzStep::Again(Box::new(asked), 2 + chance.below(39), gap),
        }
    }

    /// A series of mouse or hand packets, often with the same numbers.
    fn row(&mut self, chance: &mut Chance) -> Command {
        let command = match self.row {
            Some(row) if chance.below(3) > 0 => row,
            Some(Command::Gesture(_)) | None if chance.below(2) == 0 => mouse(chance),
            _ => hand(chance),
        };
        self.row = Some(command).filter(|_| chance.below(12) > 0);
        command
    }

    fn jog(&self, chance: &mut Chance, who: ClientId) -> FuzzStep {
        let percents = [100.0, 50.0, 7.3, 0.0, 1000.0, f32::NAN];
        let speed_percent = match chance.below(8) {
            0 => chance.one(&percents),
            1 => chance.between(0.0, 100.0),
            _ => 60.0,
        };
        let jog = if chance.below(2) == 0 {
            let axis = chance.one(&JointJogAxis::ALL);
            Jog::Joint(JointJog::new(axis, speed_percent))
        } else {
            let axis = chance.one(&LinearJogAxis::ALL);
            Jog::Linear(LinearJog::new(axis, speed_percent))
        };
        match chance.below(3) {
            0 => FuzzStep::Packet(who, jog.command().emit(&self.dialect)),
            1 => {
                let command = jog.command();
                FuzzStep::Request(who, Request::Command { command })
            }
            _ => FuzzStep::Request(who, Request::Jog { jog }),
        }
    }

    fn job(&self, chance: &mut Chance, who: ClientId) -> FuzzStep {
        let job = match self.jobs.last() {
            Some(last) if chance.below(4) > 0 => *last,
            _ => return FuzzStep::Submit(chance.one(&Sort::ALL).job(chance)),
        };
        let percent = chance.between(5.0, 205.0).into();
        let offset_mm = chance.between(-5.5, 5.5).into();
        match chance.below(6) {
            0 => FuzzStep::Request(who, Request::PauseJob),
            1 => FuzzStep::Request(who, Request::SetJobSpeed { percent }),
            2 => FuzzStep::Request(who, Request::SetJobHeight { offset_mm }),
            3 => FuzzStep::Request(who, Request::CancelJob { job }),
            _ => FuzzStep::Start(who, job),
        }
    }

    /// Requests with no or few numbers.
    fn plain(&self, chance: &mut Chance) -> Request {
        let to = chance.one(&self.people);
        match chance.below(16) {
            0 => Request::ReleaseLease,
            1 => Request::AskLease,
            2 => Request::GrantLease { to },
            3 => Request::SeizeLease,
            4 | 5 => Request::ConfirmPose,
            6 if self.burns => Request::ArmLaser {
                for_s: chance.one(&[0.3, 20.0, 600.0, -1.0, f64::NAN]),
            },
            7 => Request::DisarmLaser,
            8 if chance.below(6) == 0 => Request::Detect,
            9 => Request::Stop {
                reason: Some("by chance".into()),
            },
            10 if chance.below(3) == 0 => Request::Lock { message: None },
            11 => Request::Unlock,
            _ => Request::TakeLease,
        }
    }
}

/// Usually a number in a range, sometimes one that should never be sent.
fn number(chance: &mut Chance, from: f32, to: f32) -> f32 {
    match chance.below(60) {
        0 => chance.one(&ABSURD),
        1..4 => chance.one(&[from, to, 0.0]),
        _ => chance.between(from, to),
    }
}

/// Somewhere in reach, or a little away from where the arm will be.
fn place(chance: &mut Chance, station: &VirtualStation) -> [f32; 3] {
    let model = station.supervisor().session().model();
    let here = model.map_or(Position::new(200.0, 0.0, 0.0), |model| {
        model.place.pose.position
    });
    if chance.below(3) == 0 {
        #[expect(clippy::cast_possible_truncation, reason = "a packet carries no more")]
        return [here.x, here.y, here.z].map(|mm| mm.0 as f32 + step(chance));
    }
    [
        number(chance, 140.0, 310.0),
        number(chance, -120.0, 120.0),
        match chance.below(4) {
            // The stops of mouse and hand.
            0 => chance.one(&[-30.0, 20.0, 135.0]),
            _ => number(chance, -80.0, 130.0),
        },
    ]
}

/// A length that may be none, or next to none.
fn step(chance: &mut Chance) -> f32 {
    match chance.below(8) {
        0..3 => 0.0,
        3 => chance.one(&[1e-7, 1e-4, -2e-4, 0.001, -0.01]),
        4 => chance.one(&ABSURD),
        5 | 6 => chance.between(-5.0, 5.0),
        _ => chance.between(-60.0, 60.0),
    }
}

fn command(chance: &mut Chance, station: &VirtualStation) -> Command {
    let mode = chance.one(&[MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ]);
    let pause_s = match chance.below(6) {
        0 => number(chance, 0.0, 2.0),
        _ => 0.0,
    };
    let suction = chance.below(2) == 0;
    match chance.below(13) {
        0..4 => {
            let [x_mm, y_mm, z_mm] = place(chance, station);
            MoveTo {
                x_mm,
                y_mm,
                z_mm,
                rotation_deg: number(chance, -60.0, 60.0),
                suction,
                mode,
                gripper_deg: number(chance, -90.0, 90.0),
                pause_s,
            }
            .into()
        }
        4 | 5 => MoveJoints {
            base_deg: number(chance, -90.0, 90.0),
            rear_deg: number(chance, -5.0, 80.0),
            fore_deg: number(chance, 0.0, 90.0),
            servo_deg: number(chance, -90.0, 90.0),
            suction,
            mode,
            gripper_deg: 0.0,
            pause_s,
        }
        .into(),
        6..11 => vector(chance),
        11 => configuration(chance),
        _ => PlaybackAdjustment {
            acceleration_percent: number(chance, 1.0, 100.0),
            speed_percent: number(chance, 1.0, 100.0),
            teach_speed_percent: number(chance, 1.0, 100.0),
        }
        .into(),
    }
}

fn vector(chance: &mut Chance) -> Command {
    let fast = chance.one(&[1.0, 10.0, 40.0, 45.0, 90.0, 150.0]);
    let slow = chance.one(&[0.0, 0.0, 0.0, 1.0, 10.0, 40.0]);
    WriteVector {
        mode: chance.one(&[WriteMode::Writing, WriteMode::Writing, WriteMode::Laser]),
        x_mm: step(chance),
        y_mm: step(chance),
        z_mm: if chance.below(2) == 0 {
            0.0
        } else {
            step(chance)
        },
        laser: chance.below(4) == 0,
        start_speed_mm_s: number(chance, 0.0, slow),
        end_speed_mm_s: number(chance, slow, slow),
        max_speed_mm_s: number(chance, fast, fast),
        stop: chance.below(20) == 0,
    }
    .into()
}

/// All but initial angles, which would make the arm's pose wrong.
fn configuration(chance: &mut Chance) -> Command {
    match chance.below(4) {
        0 => Configuration::EndEffector {
            tool: chance.one(&Tool::END_EFFECTORS).into(),
        },
        1 => Configuration::Writing {
            acceleration_mm_s2: chance.one(&[100.0, 200.0, 20.0, 500.0, 0.0, 1e-20, 1e20]),
        },
        2 => Configuration::Teach {
            joint_speed_deg_s: number(chance, 1.0, 60.0),
            joint_acceleration_deg_s2: number(chance, 5.0, 200.0),
            servo_speed_deg_s: number(chance, 1.0, 60.0),
            servo_acceleration_deg_s2: number(chance, 5.0, 200.0),
            linear_speed_mm_s: number(chance, 1.0, 100.0),
            linear_acceleration_mm_s2: number(chance, 5.0, 200.0),
        },
        _ => Configuration::Playback {
            joint_speed_deg_s: number(chance, 1.0, 250.0),
            joint_acceleration_deg_s2: number(chance, 5.0, 300.0),
            servo_speed_deg_s: number(chance, 1.0, 250.0),
            servo_acceleration_deg_s2: number(chance, 5.0, 300.0),
            linear_speed_mm_s: number(chance, 1.0, 150.0),
            linear_acceleration_mm_s2: number(chance, 5.0, 300.0),
            default_pause_s: number(chance, 0.0, 1.0),
            jump_height_mm: number(chance, 0.0, 60.0),
        },
    }
    .into()
}

fn mouse(chance: &mut Chance) -> Command {
    let units = [
        0.0, 0.0, 0.0, 1.0, -1.0, 3.0, -3.0, 6.0, -4.0, -0.01, 1e-6, 40.0,
    ];
    let mut unit = || match chance.below(20) {
        0 => chance.one(&ABSURD),
        _ => chance.one(&units),
    };
    MouseMove {
        y: unit(),
        x: unit(),
        z: unit(),
        rotation_deg: unit(),
        suction: false,
    }
    .into()
}

fn hand(chance: &mut Chance) -> Command {
    let across = [0.0, 0.0, 10.0, -10.0, -40.0, 60.0, 1e-6];
    let up = [200.0, 200.0, 205.0, 195.0, 0.0, -50.0, -5.0, 500.0];
    let absurd = chance.below(30) == 0;
    Gesture {
        x: chance.one(&across),
        y: if absurd {
            chance.one(&ABSURD)
        } else {
            chance.one(&across)
        },
        z: chance.one(&up),
        grab: chance.below(2) == 0,
    }
    .into()
}

fn voice(chance: &mut Chance) -> Voice {
    let texts = [
        "ahead ten",
        "back five",
        "left twenty",
        "right one hundred",
        "up thirty",
        "down sixty",
        "catch",
        "release",
        "",
        "hello",
        "Up",
        "LEFT three hundred and nine",
    ];
    Voice::new(chance.one(&texts)).unwrap_or_else(|_| voice(chance))
}

/// A plausible state with numbers, or arbitrary floats.
fn packet(chance: &mut Chance) -> Packet {
    let states = [
        0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 15.0, 16.0, -1.0,
    ];
    let mut frame = Frame::ZERO.with(1, chance.one(&states));
    for n in 2..=10 {
        let likely = match chance.below(10) {
            0..4 => chance.one(&[0.0, 1.0, 2.0, 3.0, 10.0, 14.0, 15.0]),
            4..8 => chance.between(-100.0, 250.0),
            8 => chance.one(&ABSURD),
            _ => f32::from_bits(u32::try_from(chance.below(1 << 32)).unwrap_or_default()),
        };
        frame = frame.with(n, likely);
    }
    if (frame.float(1), frame.float(2)) == (9.0, 3.0) {
        // Initial angles: a lie, most likely.
        frame = frame.with(2, 4.0);
    }
    frame.into()
}

const ABSURD: [f32; 10] = [
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    f32::MIN_POSITIVE,
    -0.0,
    1e-7,
    1e7,
    -1e7,
    657.0,
];
