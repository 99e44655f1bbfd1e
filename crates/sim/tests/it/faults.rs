//! What goes wrong on demand, in virtual time.

use std::time::Duration;

use crate::common::{button, completed, move_to, ms, playback, program, run};
use dobot_arm::Joints;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Connection, Event, LinkError, Peer};
use dobot_sim::{Fault, FaultEffect, InProcess, SerialLine, VirtualArm};
use dobot_wire::{Command, Decoder, Dialect, JointJogAxis, MovingMode, Status};
use proptest::prelude::*;

fn faulty(faults: &[&str], seed: u64) -> VirtualArm {
    faulty_one(Personality::Specification, faults, seed)
}

fn faulty_one(personality: Personality, faults: &[&str], seed: u64) -> VirtualArm {
    let read = |text: &&str| text.parse().unwrap_or_else(|error| panic!("{error}"));
    let faults: Vec<Fault> = faults.iter().map(read).collect();
    let power_up = PowerUp::new(personality);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    arm.with_faults(power_up, &faults, seed)
}

fn bytes(command: impl Into<Command>) -> [u8; 42] {
    command.into().emit(&Dialect::SPECIFICATION).to_bytes()
}

fn s(s: u64) -> Duration {
    Duration::from_secs(s)
}

/// Base and arms in one move that lasts a few seconds at 20 degrees per second.
fn slow_move() -> Vec<u8> {
    let there = move_to(MovingMode::MovJ, 200.0, 100.0, 0.0);
    [bytes(playback(20.0)), bytes(there)].concat()
}

/// What comes from the arm up to a time, byte by byte as it does.
fn listen(arm: &mut VirtualArm, until: Duration) -> Vec<u8> {
    let mut received = Vec::new();
    while arm.now() < until {
        arm.handle_time(arm.poll_wakeup().min(until));
        arm.poll_bytes(&mut received);
    }
    received
}

fn statuses(bytes: &[u8]) -> Vec<Status> {
    let mut decoder = Decoder::statuses(dobot_session::plausible);
    let frames = decoder.feed(bytes);
    frames.filter_map(|it| Status::parse(&it).ok()).collect()
}

fn truth(arm: &VirtualArm) -> Joints {
    arm.mechanics().joints_at(arm.now())
}

/// What the controller believes.
fn believed(arm: &VirtualArm) -> Joints {
    arm.controller().joints_at(arm.controller_time(arm.now()))
}

/// What the machine stands away from what is believed: base, rear, fore and servo.
fn apart(arm: &VirtualArm) -> [f64; 4] {
    let (truth, believed) = (truth(arm), believed(arm));
    [
        truth.base.0 - believed.base.0,
        truth.rear.0 - believed.rear.0,
        truth.fore.0 - believed.fore.0,
        truth.servo.0 - believed.servo.0,
    ]
}

#[track_caller]
fn assert_apart(arm: &VirtualArm, expected: [f64; 4]) {
    // A pulse is 0.01125 degrees, a step of the servo's signal 0.18.
    for ((found, expected), tolerance) in apart(arm)
        .into_iter()
        .zip(expected)
        .zip([0.02, 0.02, 0.02, 0.2])
    {
        assert!(
            (found - expected).abs() < tolerance,
            "{:?} is not {expected:?}",
            apart(arm)
        );
    }
}

fn reported(arm: &mut VirtualArm) -> Vec<String> {
    std::iter::from_fn(|| arm.poll_struck())
        .map(|it| it.to_string())
        .collect()
}

mod machine {
    use super::*;

    #[test]
    fn without_faults_the_machine_is_where_the_controller_believes_it() {
        let mut arm = faulty(&[], 0);
        arm.handle_bytes(ms(0), &slow_move());
        arm.handle_time(s(20));
        assert!(believed(&arm).base.0 > 20.0);
        assert_apart(&arm, [0.0; 4]);
    }

    #[test]
    fn lost_pulses_shift_the_machine_but_not_what_the_status_says() {
        let run = |faults: &[&str]| {
            let mut arm = faulty(faults, 0);
            arm.handle_bytes(ms(0), &slow_move());
            let received = listen(&mut arm, s(20));
            (arm, statuses(&received))
        };
        let (right, reported_right) = run(&[]);
        let (arm, reported) = run(&["lose=base:100@1s"]);
        assert_eq!(reported, reported_right);
        assert_apart(&right, [0.0; 4]);
        // 100 pulses of 1.8 / 160 degrees; the base turned in positive direction.
        assert_apart(&arm, [-1.125, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn a_share_of_the_pulses_is_lost_all_along_the_way() {
        let mut arm = faulty(&["lose=base:10%"], 3);
        arm.handle_bytes(ms(0), &slow_move());
        arm.handle_time(s(20));
        let (truth, believed) = (truth(&arm).base.0, believed(&arm).base.0);
        let share = truth / believed;
        assert!((0.88..0.92).contains(&share), "{truth} of {believed}");
    }

    #[test]
    fn a_slack_base_comes_back_by_so_much_too_little() {
        let mut arm = faulty(&["backlash=base:0.5"], 0);
        arm.handle_bytes(ms(0), &slow_move());
        arm.handle_time(s(20));
        assert_apart(&arm, [0.0; 4]);
        arm.handle_bytes(s(20), &bytes(move_to(MovingMode::MovJ, 200.0, 0.0, 0.0)));
        arm.handle_time(s(40));
        assert_apart(&arm, [0.5, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn a_joint_with_its_zero_off_stays_off_wherever_it_goes() {
        let mut arm = faulty(&["zero=fore:2", "zero=base:-1.5", "zero=servo:4"], 0);
        assert_apart(&arm, [-1.5, 0.0, 2.0, 4.0]);
        arm.handle_bytes(ms(0), &slow_move());
        arm.handle_time(s(20));
        assert_apart(&arm, [-1.5, 0.0, 2.0, 4.0]);
    }
}

mod controller {
    use super::*;

    #[test]
    fn a_reset_makes_the_base_zero_and_what_is_believed_untrue() {
        let mut arm = faulty(&["reset=rear:1.5,fore:-0.8@12s"], 0);
        arm.handle_bytes(ms(0), &slow_move());
        let before = statuses(&listen(&mut arm, s(12)));
        let turned_deg = truth(&arm).base.0;
        assert!(turned_deg > 20.0);
        let heard = listen(&mut arm, s(14) + ms(60));
        assert!(heard.is_empty(), "it is deaf and dumb");
        let after = statuses(&listen(&mut arm, s(16)));
        assert_eq!(after[0].base_deg, 0.0);
        let shift = after[0].rear_deg - before.last().expect("there are some").rear_deg;
        assert!((shift - 1.5).abs() < 0.02, "{shift}");
        assert_apart(&arm, [turned_deg, -1.5, 0.8, 0.0]);
        assert_eq!(
            reported(&mut arm),
            ["12.000 s: fault reset=rear:1.5,fore:-0.8@12s"]
        );
    }

    #[test]
    fn a_controller_that_starts_is_deaf_for_two_seconds_and_then_as_after_power_up() {
        let mut arm = faulty(&["reset@12s"], 0);
        arm.handle_bytes(ms(0), &bytes(button(JointJogAxis::LaserOn, 0.0)));
        arm.handle_bytes(s(11), &bytes(button(JointJogAxis::SuctionOn, 0.0)));
        arm.handle_time(ms(11_999));
        assert!(arm.controller().laser() && arm.controller().suction());
        arm.handle_time(s(12));
        assert!(!arm.controller().laser() && !arm.controller().suction());
        // Whole before the first tick: lost. A byte after it: not.
        arm.handle_bytes(s(13), &bytes(button(JointJogAxis::LaserOn, 0.0)));
        arm.handle_bytes(s(14), &bytes(button(JointJogAxis::SuctionOn, 0.0)));
        // The first status comes with the fourth tick.
        let packet_takes = ms(44);
        listen(&mut arm, s(14) + ms(60));
        assert_eq!(listen(&mut arm, s(14) + ms(60) + packet_takes).len(), 42);
        arm.handle_time(s(15));
        assert!(!arm.controller().laser() && arm.controller().suction());
        assert_eq!(arm.controller().counters().packets, 1);
    }

    #[test]
    fn opening_the_port_resets_an_arm_that_does_so_each_time() {
        let mut arm = faulty(&["reset@open"], 0);
        for opened in [s(1), s(5)] {
            listen(&mut arm, opened);
            arm.handle_open(opened);
            assert!(listen(&mut arm, opened + s(2) + ms(60)).is_empty());
            assert_eq!(listen(&mut arm, opened + s(2) + ms(104)).len(), 42);
        }
    }

    #[test]
    fn power_cut_in_a_move_leaves_the_machine_where_it_was() {
        let mut arm = faulty(&["power@2s..5s"], 0);
        arm.handle_bytes(ms(0), &slow_move());
        listen(&mut arm, s(2));
        let stood = truth(&arm);
        assert!((5.0..26.0).contains(&stood.base.0), "{stood:?}");
        arm.handle_bytes(s(3), &slow_move());
        assert!(listen(&mut arm, s(7)).is_empty());
        assert_eq!(truth(&arm), stood);
        let status = statuses(&listen(&mut arm, s(8)))[0];
        assert_eq!(status.base_deg, 0.0);
        assert!((f64::from(status.rear_deg) - stood.rear.0).abs() < 1e-4);
        assert_apart(&arm, [stood.base.0, 0.0, 0.0, 0.0]);
        assert_eq!(
            reported(&mut arm),
            [
                "2.000 s: fault power@2s..5s",
                "5.000 s: fault power@2s..5s is over"
            ]
        );
    }

    #[test]
    fn a_fault_can_wait_for_a_packet_or_a_status() {
        let mut arm = faulty(&["reset@packet2", "withhold@status30..+1s"], 0);
        arm.handle_bytes(ms(0), &slow_move());
        arm.handle_time(s(10));
        let at: Vec<Duration> = std::iter::from_fn(|| arm.poll_struck())
            .map(|it| it.at)
            .collect();
        // Two packets have arrived after 87.36 ms: the tick after that is the fifth.
        // The second controller starts at 2.1 s; one status came before, the 29th of its own comes
        // with its tick 115.
        assert_eq!(at, [ms(100), ms(2100 + 115 * 20), ms(3100 + 115 * 20)]);
    }
}

mod link {
    use super::*;

    #[test]
    fn a_count_of_bytes_is_lost_on_the_way_it_is_meant_for() {
        let mut arm = faulty(&["drop=3:from@1s", "drop=1:to@1s"], 0);
        let right = listen(&mut faulty(&[], 0), s(3));
        assert_eq!(listen(&mut arm, s(3)).len(), right.len() - 3);
        arm.handle_bytes(s(3), &bytes(button(JointJogAxis::SuctionOn, 0.0)));
        arm.handle_bytes(s(3), &bytes(button(JointJogAxis::LaserOn, 0.0)));
        arm.handle_time(s(4));
        assert_eq!(arm.controller().counters().packets, 1);
        assert!(arm.controller().laser() && !arm.controller().suction());
    }

    #[test]
    fn flipped_bytes_differ_by_a_bit_and_doubled_ones_come_twice() {
        let right = listen(&mut faulty(&[], 0), s(60));
        let flipped = listen(&mut faulty(&["flip=1%"], 5), s(60));
        assert_eq!(flipped.len(), right.len());
        let bits: Vec<u32> = flipped
            .iter()
            .zip(&right)
            .map(|(a, b)| (a ^ b).count_ones())
            .filter(|&it| it > 0)
            .collect();
        assert!(bits.iter().all(|&it| it == 1));
        let expected = right.len() / 100;
        assert!(bits.len().abs_diff(expected) < expected / 5, "{bits:?}");
        let doubled = listen(&mut faulty(&["duplicate=100%"], 5), s(3));
        let right = listen(&mut faulty(&[], 5), s(3));
        let twice: Vec<u8> = right.iter().flat_map(|&it| [it, it]).collect();
        assert_eq!(doubled, twice);
    }

    #[test]
    fn delayed_bytes_come_late_in_their_order_and_none_is_lost() {
        let arrivals = |arm: &mut VirtualArm| {
            let (mut at, mut all) = (Vec::new(), Vec::new());
            while arm.now() < s(60) {
                let had = all.len();
                arm.handle_time(arm.now() + ms(1));
                arm.poll_bytes(&mut all);
                at.resize(at.len() + all.len() - had, arm.now());
            }
            (at, all)
        };
        let (right_at, right) = arrivals(&mut faulty(&[], 0));
        let (late_at, late) = arrivals(&mut faulty(&["delay=50ms"], 1));
        assert_eq!(late[..], right[..late.len()]);
        assert!(right.len() - late.len() <= 84);
        let delays = || {
            late_at
                .iter()
                .zip(&right_at)
                .map(|(late, right)| late.saturating_sub(*right))
        };
        let longest = delays().max().expect("there are some");
        assert!((ms(45)..=ms(51)).contains(&longest), "{longest:?}");
        assert!(delays().min().expect("there are some") < ms(5));
    }

    #[test]
    fn withheld_statuses_never_come() {
        let mut arm = faulty(&["withhold@10s..12s"], 0);
        let right = listen(&mut faulty(&[], 0), s(20)).len();
        // One status every 80 ms in two seconds.
        assert_eq!(listen(&mut arm, s(20)).len(), right - 25 * 42);
    }

    #[tokio::test]
    async fn a_port_that_closes_ends_the_connection_and_can_be_opened_again() {
        let arm = InProcess::new(faulty(&["close@2s..4s"], 0));
        let connect = || Connection::over_peer(arm.clone(), Some(Dialect::SPECIFICATION));
        let mut connection = connect();
        let error = loop {
            if let Err(error) = connection.next_event().await {
                break error;
            }
        };
        assert!(matches!(error, LinkError::Closed), "{error}");
        assert_eq!(arm.now(), s(2));
        let error = connect().next_event().await.expect_err("it is closed");
        assert!(matches!(error, LinkError::Closed), "{error}");
        arm.arm().handle_time(s(4));
        arm.reopen();
        let status = connect().next_status().await.expect("it is open again");
        assert_eq!(status.rear_deg, 45.0);
        assert!(arm.now() < s(4) + ms(130));
    }

    #[test]
    fn hits_are_reported_at_one_ten_a_hundred_and_at_the_end() {
        let mut arm = faulty(&["drop=100%:from@0s..10s"], 0);
        listen(&mut arm, s(20));
        let hits: Vec<FaultEffect> = std::iter::from_fn(|| arm.poll_struck())
            .map(|it| it.what)
            .collect();
        // Statuses are sent from 60 ms on, every 80 ms: of the 125 by then the last one comes whole.
        let by_ten_seconds = 124 * 42;
        assert_eq!(
            hits[..4],
            [
                FaultEffect::Hit(1),
                FaultEffect::Hit(10),
                FaultEffect::Hit(100),
                FaultEffect::Hit(1000)
            ]
        );
        let FaultEffect::Over(hits) = hits[4] else {
            panic!("{hits:?}");
        };
        assert!(
            (by_ten_seconds..=by_ten_seconds + 42).contains(&hits),
            "{hits}"
        );
    }
}

mod client {
    use super::*;

    #[tokio::test]
    async fn damage_on_the_way_from_the_arm_costs_a_client_nothing_but_time() {
        let program = program();
        for seed in 0..30 {
            for fault in [
                "drop=0.5%:from",
                "flip=0.5%:from",
                "duplicate=0.5%:from",
                "delay=50ms",
            ] {
                let arm = InProcess::new(faulty(&[fault], seed));
                let mut connection =
                    Connection::over_peer(arm.clone(), Some(Dialect::SPECIFICATION));
                let events = run(&mut connection, &program).await;
                let all: Vec<u64> = (0..program.len() as u64).collect();
                assert_eq!(completed(&events), all, "{fault} {seed}: {events:?}");
                let now = arm.now();
                let position = arm.arm().controller().pose_at(now).position;
                let apart_mm = position
                    .distance(dobot_arm::Position::new(200.0, 0.0, 0.0))
                    .0;
                assert!(apart_mm < 1e-6, "{fault} {seed}: {position:?}");
            }
        }
    }

    #[tokio::test]
    async fn damage_on_the_way_to_the_arm_is_noticed_where_a_command_is_lost() {
        let mut failed = 0;
        for seed in 0..30 {
            let arm = InProcess::new(faulty(&["drop=2:to@packet1"], seed));
            let mut connection = Connection::over_peer(arm.clone(), Some(Dialect::SPECIFICATION));
            let program: Vec<Command> = vec![
                move_to(MovingMode::MovJ, 240.0, 40.0, 20.0).into(),
                move_to(MovingMode::MovJ, 200.0, 0.0, 0.0).into(),
            ];
            let events = run(&mut connection, &program).await;
            failed += u32::from(matches!(events.last(), Some(Event::NotReached { .. })));
        }
        assert_eq!(failed, 30);
    }

    /// An hour of jogs and moves by a client that goes on whatever happens; what the arm and the
    /// client know at the end.
    async fn an_hour(seed: u64) -> String {
        let arm = InProcess::new(faulty(&["drop=1%", "lose=rear:0.1%"], seed));
        let mut connection = Connection::over_peer(arm.clone(), Some(Dialect::SPECIFICATION));
        let mut statuses = 0_u64;
        let mut sum_mm = 0.0;
        while arm.now() < s(3600) {
            if connection.session().waiting() == 0 {
                for command in [
                    button(JointJogAxis::BasePlus, 50.0).into(),
                    button(JointJogAxis::Released, 0.0).into(),
                    Command::from(move_to(MovingMode::MovJ, 220.0, 40.0, 20.0)),
                    move_to(MovingMode::Jump, 210.0, -20.0, 0.0).into(),
                ] {
                    connection.send(command).expect("it is allowed");
                }
            }
            if let Event::Status(status) = connection.next_event().await.expect("it is open") {
                statuses += 1;
                sum_mm += f64::from(status.x_mm);
            }
        }
        assert!(statuses > 3_000, "{statuses}");
        let arm = arm.arm();
        let counts = connection.session().counts();
        let counters = arm.controller().counters();
        format!(
            "{statuses} {sum_mm} {counts:?} {counters:?} {:?}",
            truth(&arm)
        )
    }

    #[tokio::test]
    async fn an_hour_of_work_ends_the_same_for_the_same_seed() {
        let first = an_hour(1).await;
        assert_eq!(an_hour(1).await, first);
        assert_ne!(an_hour(2).await, first);
    }
}

const EVERYTHING: [&str; 12] = [
    "drop=2%@1s..4s",
    "flip=1%:to",
    "duplicate=1%:from",
    "delay=30ms:to",
    "delay=20ms:from@packet2",
    "withhold@status20..+500ms",
    "close@3s..3500ms",
    "reset=rear:0.5@packet3",
    "power@5s..6s",
    "lose=base:5%",
    "backlash=rear:0.3",
    "zero=fore:1",
];

/// What comes of a program when time is sliced so; packets are handed over in pieces.
fn sliced(
    personality: Personality,
    slices_us: &[u64],
    pieces: usize,
    seed: u64,
) -> (Vec<u8>, String) {
    let mut arm = faulty_one(personality, &EVERYTHING, seed);
    let mut input = (0..40_u64).map(|n| (ms(250 * n), slow_move()));
    let mut next = input.next();
    let mut received = Vec::new();
    let mut slices = slices_us.iter().cycle();
    while arm.now() < s(12) {
        let slice = Duration::from_micros(*slices.next().expect("there are some"));
        let mut until = arm.now() + slice;
        if let Some((at, bytes)) = &next
            && *at <= until
        {
            until = *at;
            for piece in bytes.chunks(pieces) {
                arm.handle_bytes(until, piece);
            }
            next = input.next();
        }
        arm.handle_time(until.min(s(12)));
        arm.poll_bytes(&mut received);
    }
    let reported = reported(&mut arm);
    let end = format!("{:?} {reported:?}", truth(&arm));
    (received, end)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn results_depend_neither_on_slices_of_time_nor_on_chunks_of_bytes(
        slices in proptest::collection::vec(1_u64..300_000, 1..20),
        pieces in 1_usize..100,
        seed in any::<u64>(),
    ) {
        for personality in Personality::ALL {
            let whole = sliced(personality, &[1_000_000], 84, seed);
            let (bytes, end) = sliced(personality, &slices, pieces, seed);
            prop_assert_eq!(end, whole.1);
            prop_assert!(bytes == whole.0);
        }
    }
}

#[test]
fn a_client_reads_what_was_sent_before_the_port_closed() {
    let mut arm = InProcess::new(faulty(&["close@110ms..1s"], 0));
    let mut bytes = Vec::new();
    while arm.receive(s(5), &mut bytes) {}
    // The first status is sent at 60 ms and has arrived at 103.68 ms.
    assert_eq!(bytes.len(), 42);
    assert_eq!(arm.now(), ms(110));
}

#[test]
fn faults_that_come_later_count_from_then_on_and_end_those_before() {
    let mut arm = faulty(&["withhold"], 1);
    arm.handle_open(Duration::ZERO);
    assert_eq!(statuses(&listen(&mut arm, s(5))), []);
    let power_up = PowerUp::new(Personality::Specification);
    arm.set_faults(
        power_up,
        &["withhold@2s".parse().expect("it is a fault")],
        1,
    )
    .expect("it may come now");
    let heard = statuses(&listen(&mut arm, s(7))).len();
    assert!((22..=26).contains(&heard), "{heard} statuses in 2 s");
    assert_eq!(statuses(&listen(&mut arm, s(9))), []);
    arm.set_faults(power_up, &[], 1).expect("it may come now");
    assert!(statuses(&listen(&mut arm, s(11))).len() > 20);
}

#[test]
fn an_arm_without_power_has_it_again_when_its_faults_are_over() {
    let power_up = PowerUp::new(Personality::Specification);
    let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    arm.handle_open(Duration::ZERO);
    arm.handle_time(s(1));
    let off = "power@0s..1h".parse().expect("it is a fault");
    arm.set_faults(power_up, &[off], 1)
        .expect("it may come now");
    listen(&mut arm, s(2));
    assert_eq!(statuses(&listen(&mut arm, s(4))), []);
    arm.set_faults(power_up, &[], 1).expect("it may come now");
    // A controller that starts anew is deaf for two seconds.
    listen(&mut arm, s(7));
    assert!(statuses(&listen(&mut arm, s(9))).len() > 20);
}

#[test]
fn a_joint_that_becomes_slack_is_stiff_again_when_that_is_over() {
    let power_up = PowerUp::new(Personality::Specification);
    let moved = |faults: &[&str]| {
        let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        arm.handle_open(Duration::ZERO);
        arm.handle_time(s(1));
        let slack: Fault = "backlash=base:3".parse().expect("it is a fault");
        arm.set_faults(power_up, &[slack], 1)
            .expect("it may come now");
        let faults: Vec<Fault> = faults
            .iter()
            .map(|it| it.parse().expect("it is a fault"))
            .collect();
        arm.set_faults(power_up, &faults, 1)
            .expect("it may come now");
        for y_mm in [100.0, -100.0] {
            let there = move_to(MovingMode::MovJ, 200.0, y_mm, 0.0);
            arm.handle_bytes(arm.now(), &bytes(there));
            let until = arm.now() + s(20);
            listen(&mut arm, until);
        }
        truth(&arm).base.0
    };
    let (stiff, slack) = (moved(&[]), moved(&["backlash=base:3"]));
    assert!((slack - stiff - 3.0).abs() < 0.02, "{stiff} {slack}");
    let zero: Fault = "zero=base:3".parse().expect("it is a fault");
    let mut arm = faulty(&[], 1);
    let refused = arm
        .set_faults(power_up, &[zero], 1)
        .expect_err("a joint cannot be askew all at once");
    assert!(refused.to_string().contains("switched on"), "{refused}");
}
