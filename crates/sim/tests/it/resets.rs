//! A reset is noticed whenever it happens: it makes an arm say that its base is at 0, wherever that
//! stands (note N35).

use std::time::Duration;

use crate::common::{move_to, ms, vector};
use dobot_arm::{Joints, TICK};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Connection, Event, Session};
use dobot_sim::{Fault, InProcess, Script, SerialLine, VirtualArm, simulate_watched};
use dobot_wire::{Command, Decoder, Dialect, Frame, MovingMode, Status, WriteVector};
use proptest::prelude::*;

/// A packet on the line (note N26).
const PACKET: Duration = Duration::from_micros(43_680);
/// From a reset to the first control tick.
const DEAF: Duration = Duration::from_secs(2);

/// What a session hears of a script that the twin carries out.
struct SessionInput {
    power_up: PowerUp,
    /// The statuses, each with the tick that sent it.
    statuses: Vec<(u32, Frame)>,
    /// Where the joints were in each tick.
    joints: Vec<Joints>,
    commands: Vec<Command>,
}

impl SessionInput {
    fn by(script: &Script) -> Self {
        let mut joints = Vec::new();
        let watch = |at, controller: &Controller| joints.push(controller.joints_at(at));
        let reported =
            simulate_watched(script, Personality::Firmware11, watch).expect("it has both");
        let frame = |floats: &[f32; 10]| {
            let with = |frame: Frame, (n, float): (usize, &f32)| frame.with(n, *float);
            (1..).zip(floats).fold(Frame::ZERO, with)
        };
        let statuses = reported.trace.statuses.iter();
        let bytes: Vec<u8> = script
            .lines
            .iter()
            .flat_map(|it| it.bytes.clone())
            .collect();
        let mut decoder = Decoder::commands();
        let read = |packet| Command::parse(&packet, &Dialect::FIRMWARE_1_1).ok();
        Self {
            power_up: PowerUp::new(Personality::Firmware11)
                .with_port(script.port)
                .with_tilt(script.rear_deg, script.fore_deg),
            statuses: statuses.map(|it| (it.tick, frame(&it.floats))).collect(),
            joints,
            commands: decoder.feed(&bytes).filter_map(read).collect(),
        }
    }

    /// Resets the arm in each tick; tells in how many the session noticed it, and in how many there
    /// was nothing to notice.
    fn reset_in_each_tick(&self, name: &str) -> (u32, u32) {
        let mut session = Session::trusted(Some(Dialect::FIRMWARE_1_1));
        let mut statuses = self.statuses.iter().peekable();
        let mut commands = self.commands.iter();
        let (mut noticed, mut same) = (0, 0);
        for (tick, joints) in (0..).zip(&self.joints) {
            while let Some((sent, frame)) =
                statuses.next_if(|it| TICK * it.0 + PACKET < TICK * tick)
            {
                session.handle_bytes(TICK * *sent + PACKET, &frame.to_bytes());
                if let Some(command) = commands.next() {
                    session.note_urgent(command);
                }
            }
            let Some(before) = session.status().copied() else {
                continue;
            };
            let (after, anew) = self.after_a_reset(session.clone(), TICK * tick, joints);
            let angles = |it: &Status| [it.base_deg, it.rear_deg, it.fore_deg];
            if angles(&before) == angles(&anew) {
                same += 1;
                continue;
            }
            assert!(
                !after.is_trusted(),
                "{name}: tick {tick}, {before:?}, {anew:?}"
            );
            noticed += 1;
        }
        (noticed, same)
    }

    /// What a session thinks when it has heard the first statuses of an arm that was reset.
    fn after_a_reset(
        &self,
        mut session: Session,
        at: Duration,
        joints: &Joints,
    ) -> (Session, Status) {
        let mut controller =
            Controller::power_up(self.power_up.with_tilt(joints.rear.0, joints.fore.0));
        controller.handle_time(ms(400));
        while let Some(upload) = controller.poll_bytes() {
            session.handle_bytes(at + DEAF + upload.at + PACKET, &upload.bytes);
        }
        let status = *session.status().expect("a status arrived");
        (session, status)
    }
}

#[test]
fn a_reset_at_every_tick_of_every_recorded_trace_is_noticed() {
    let mut noticed = 0;
    for name in crate::recordings::names() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../vectors/traces");
        let text = std::fs::read_to_string(format!("{folder}/{name}.script")).expect("it is there");
        let script: Script = text.parse().expect("it is a script");
        let (here, _) = SessionInput::by(&script).reset_in_each_tick(&name);
        noticed += here;
    }
    assert!(noticed > 10_000, "{noticed}");
}

/// Programs of which half of all commands lead to where the base is at 0.
fn program() -> impl Strategy<Value = Vec<Command>> {
    let mode = prop_oneof![
        Just(MovingMode::MovL),
        Just(MovingMode::MovJ),
        Just(MovingMode::Jump)
    ];
    let y = prop_oneof![Just(0.0), -80.0..80.0_f32];
    let point = (205.0..255.0_f32, y, -10.0..50.0_f32);
    let target = (mode, point).prop_map(|(mode, (x, y, z))| Command::from(move_to(mode, x, y, z)));
    let along = (-9.0..9.0_f32).prop_map(|x| Command::from(vector(x, 0.0, 10.0)));
    let across = (-8.0..8.0_f32, 1.0..8.0_f32).prop_map(|(x, y)| Command::from(vector(x, y, 20.0)));
    prop::collection::vec(prop_oneof![4 => target, 1 => along, 1 => across], 4..24)
}

/// Runs a program on an arm with a fault; tells whether the session trusts it afterwards, and the
/// statuses with the times at which they came.
fn run(
    personality: Personality,
    faults: &[Fault],
    program: &[Command],
    ahead: Duration,
    until: Duration,
) -> (InProcess, Connection, Vec<(Duration, Status)>) {
    let power_up = PowerUp::new(personality);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    let arm = InProcess::new(arm.with_faults(power_up, faults, 3));
    let mut connection = Connection::over_peer(arm.clone(), Some(personality.dialect()));
    connection.session_mut().set_ahead(ahead);
    let mut statuses = Vec::new();
    let runtime = tokio::runtime::Builder::new_current_thread()
        .build()
        .expect("it is simple");
    runtime.block_on(async {
        connection.next_status().await.expect("a status arrives");
        for command in program {
            // What a stock arm would lose its pose by is refused.
            let _ = connection.send(*command);
        }
        while connection.now() < until {
            connection.pass(TICK).await.expect("it is open");
            let now = connection.now();
            while let Some(event) = connection.session_mut().poll_event() {
                if let Event::Status(status) = event {
                    statuses.push((now, status));
                }
            }
        }
    });
    (arm, connection, statuses)
}

fn personality(stock: bool) -> Personality {
    Personality::ALL[usize::from(stock)]
}

fn ahead(full: bool) -> Duration {
    if full { Duration::MAX } else { ms(500) }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, max_shrink_iters: 100, ..ProptestConfig::default() })]

    #[test]
    fn a_reset_in_a_random_program_is_noticed(
        stock in any::<bool>(),
        full in any::<bool>(),
        program in program(),
        tick in 10_u64..600,
    ) {
        let at = ms(tick * 20);
        let reset: Fault = format!("reset@{}ms", at.as_millis()).parse().expect("it is one");
        let until = at + Duration::from_secs(4);
        let (arm, connection, statuses) =
            run(personality(stock), &[reset], &program, ahead(full), until);
        let before = statuses.iter().rfind(|it| it.0 < at + PACKET + TICK).expect("a status arrived").1;
        let after = statuses.iter().find(|it| it.0 > at + DEAF).expect("a status arrives again").1;
        let angles = |it: &Status| [it.base_deg, it.rear_deg, it.fore_deg];
        if angles(&before) != angles(&after) {
            prop_assert!(!connection.session().is_trusted(), "{before:?}, {after:?}");
        }
        let now = connection.now();
        let truth = arm.arm().mechanics().joints_at(now).base.0;
        prop_assert!(
            !connection.session().is_trusted() || (truth - f64::from(after.base_deg)).abs() < 0.1,
            "it is trusted at {} and stands at {truth}", after.base_deg
        );
    }

    #[test]
    fn a_program_through_the_middle_without_a_reset_costs_no_trust(
        stock in any::<bool>(),
        full in any::<bool>(),
        program in program(),
    ) {
        let until = Duration::from_secs(20);
        let (_, connection, _) = run(personality(stock), &[], &program, ahead(full), until);
        prop_assert!(
            connection.session().is_trusted(),
            "{:?}", connection.session().distrust_reason()
        );
    }

    #[test]
    fn dashes_along_the_middle_cost_no_trust_however_long_the_pen_takes_up_and_down(
        stock in any::<bool>(),
        full in any::<bool>(),
        dashes in prop::collection::vec((3.0..12.0_f32, 0.2..4.0_f32, 15.0..60.0_f32), 5..60),
    ) {
        let by = |x, z, speed| {
            let max_speed_mm_s = speed;
            Command::from(WriteVector { start_speed_mm_s: 1.0, ..WriteVector::by(x, 0.0, z, max_speed_mm_s) })
        };
        let dash = |(n, (lift, along, speed)): (usize, (f32, f32, f32))| {
            let along = if n % 2 == 0 { along } else { -along };
            [by(along, 0.0, speed), by(0.0, lift, speed), by(along, 0.0, speed), by(0.0, -lift, speed)]
        };
        let begin = Command::from(move_to(MovingMode::MovL, 230.0, 0.0, 0.0));
        let program: Vec<Command> =
            std::iter::once(begin).chain(dashes.into_iter().enumerate().flat_map(dash)).collect();
        let until = Duration::from_secs(200);
        let (_, connection, _) = run(personality(stock), &[], &program, ahead(full), until);
        prop_assert!(
            connection.session().is_trusted(),
            "{:?}", connection.session().distrust_reason()
        );
    }
}
