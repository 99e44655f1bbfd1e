//! The suite against good controllers, and against one that is broken in one thing at a time.

mod broken;
mod delayed;

use std::time::Duration;

use broken::Broken;
use delayed::Delayed;
use dobot_arm::{Joints, Position, Tool, forward};
use dobot_client::{Link, Peer};
use dobot_conformance::{Check, HEADING, Hindrance, Options, Outcome, Report, Suite, Verdict};
use dobot_controller::{Controller, Personality, PowerUp, STEPS_PER_DEG};
use dobot_sim::{InProcess, Line, VirtualArm};
use dobot_wire::Frame;
use tokio::io::{AsyncReadExt, AsyncWriteExt, DuplexStream};
use tokio::time::{Instant, sleep_until, timeout};

const ALL: Options = Options {
    laser: true,
    traps: true,
    fresh: true,
};

const ON_A_PORT: Options = Options {
    laser: false,
    traps: false,
    fresh: false,
};

fn arm(power_up: PowerUp) -> InProcess {
    let controller = Controller::power_up(power_up);
    InProcess::new(VirtualArm::new(controller, Line::STOCK))
}

fn speaking(personality: Personality) -> InProcess {
    arm(PowerUp::new(personality))
}

fn good() -> Broken {
    Broken::new(speaking(Personality::Specification))
}

async fn check(peer: impl Peer + 'static, options: Options) -> Report {
    let link = Link::over_peer(peer);
    Suite::new(link, options).run(|_| {}).await
}

/// The checks that find something wrong with a controller, and nothing else.
async fn caught(broken: Broken, ids: &[&str]) {
    let report = check(
        broken,
        Options {
            traps: false,
            ..ALL
        },
    )
    .await;
    assert_eq!(report.differing(), ids, "{}", table(&report));
    assert!(!report.conforms());
}

fn table(report: &Report) -> String {
    let rows = report.rows().iter();
    rows.fold(report.summary(), |text, row| format!("{text}\n{row}"))
}

fn untried(report: &Report) -> Vec<&'static str> {
    let rows = report.rows().iter();
    rows.filter(|row| matches!(row.outcome, Outcome::NotTried(_)))
        .map(|row| row.check.id)
        .collect()
}

const fn is_release(frame: &Frame) -> bool {
    matches!(frame.float(1), 2.0 | 7.0) && frame.float(2) == 0.0
}

#[tokio::test]
async fn all_holds_of_the_specification() {
    let report = check(speaking(Personality::Specification), ALL).await;
    assert_eq!(
        report.verdict(),
        Verdict::Specification,
        "{}",
        table(&report)
    );
    assert!(report.conforms(), "{}", table(&report));
    assert_eq!(untried(&report), [""; 0]);
}

#[tokio::test]
async fn all_holds_of_the_twin_of_the_stock_controller() {
    let report = check(speaking(Personality::Firmware11), ALL).await;
    assert_eq!(report.verdict(), Verdict::Firmware11, "{}", table(&report));
    assert!(report.conforms(), "{}", table(&report));
    assert_eq!(untried(&report), [""; 0]);
}

#[tokio::test]
async fn laser_and_traps_are_not_tried_unless_asked_for() {
    let report = check(speaking(Personality::Specification), ON_A_PORT).await;
    let dangerous = ["laser", "limit-jog", "trap-no-length", "trap-state"];
    assert_eq!(untried(&report), dangerous);
    assert!(report.conforms(), "{}", table(&report));
}

#[tokio::test]
async fn a_laser_is_never_on_unless_asked_for() {
    let arm = speaking(Personality::Firmware11);
    let seen = arm.clone();
    let watched = Broken::new(arm).says(move |frame| {
        assert!(!seen.arm().controller().laser());
        Some(frame.to_bytes().to_vec())
    });
    check(watched, ON_A_PORT).await;
}

#[tokio::test]
async fn a_stock_arm_that_may_remember_hand_positions_is_shown_none() {
    let report = check(speaking(Personality::Firmware11), ON_A_PORT).await;
    assert!(untried(&report).contains(&"gesture"));
    assert_eq!(report.verdict(), Verdict::Firmware11, "{}", table(&report));
    assert!(report.conforms(), "{}", table(&report));
}

/// Where the motors have brought the tool, whatever the controller believes.
fn true_position(arm: &InProcess) -> Position {
    let steps = arm.arm().controller().steps();
    let turned = |joint: usize| {
        let steps = i32::try_from(steps[joint]).expect("it is a short run");
        f64::from(steps) / STEPS_PER_DEG[joint]
    };
    let joints = Joints::new(turned(0), 45.0 + turned(1), 45.0 + turned(2), 0.0);
    forward(&joints, Tool::SuctionCup).position
}

#[tokio::test]
async fn the_arm_stays_near_its_start_and_never_goes_below_it() {
    for personality in Personality::ALL {
        let arm = speaking(personality);
        let watched = arm.clone();
        let start = true_position(&arm);
        let peer = Broken::new(arm).says(move |frame| {
            let off = true_position(&watched) - start;
            assert!(off.x.0.abs() < 11.0 && off.y.0.abs() < 11.0, "{off:?}");
            // A motor step is 0.03 mm.
            assert!((-0.05..20.0).contains(&off.z.0), "{off:?}");
            Some(frame.to_bytes().to_vec())
        });
        let report = check(peer, ON_A_PORT).await;
        assert!(report.conforms(), "{}", table(&report));
    }
}

#[tokio::test]
async fn the_arm_ends_where_it_began() {
    for personality in Personality::ALL {
        let arm = speaking(personality);
        let before = arm.arm().controller().joints_at(Duration::ZERO);
        check(arm.clone(), ON_A_PORT).await;
        let arm = arm.arm();
        let after = arm.controller().joints_at(arm.now());
        assert!((after.rear - before.rear).abs().0 < 0.02, "{after:?}");
        assert!((after.fore - before.fore).abs().0 < 0.02, "{after:?}");
        assert!((after.base - before.base).abs().0 < 0.02, "{after:?}");
    }
}

#[tokio::test]
async fn an_arm_without_room_is_not_moved_and_told_where_to_stand() {
    let raised = PowerUp {
        rear_deg: 60.0,
        fore_deg: 92.0,
        ..PowerUp::default()
    };
    let report = check(arm(raised), ON_A_PORT).await;
    let outcome = report.outcome("move-point").expect("it is one");
    assert!(
        outcome.found().contains("forearm is 92.0 degrees"),
        "{outcome}"
    );
    assert!(matches!(outcome, Outcome::NotTried(_)), "{outcome}");
    assert!(!report.conforms());
}

#[tokio::test]
async fn a_deaf_line_is_told_and_nothing_is_sent() {
    let silent = good()
        .says(|_| None)
        .hears(|_, _| panic!("it was sent something"));
    caught(silent, &["status-form"]).await;
}

#[tokio::test]
async fn a_missing_tail_is_caught() {
    let broken = good().says(|frame| Some(frame.to_bytes()[..41].to_vec()));
    caught(broken, &["status-form"]).await;
}

#[tokio::test]
async fn a_status_every_100_ms_is_caught() {
    let report = check(good().every(Duration::from_millis(100)), ON_A_PORT).await;
    assert!(
        report.differing().contains(&"status-period"),
        "{}",
        table(&report)
    );
}

#[tokio::test]
async fn a_z_with_the_wrong_sign_is_caught_and_nothing_is_sent() {
    let broken = good().says(|frame| {
        let z = frame.float(3);
        Some(frame.with(3, -z).to_bytes().to_vec())
    });
    caught(
        broken.hears(|_, _| panic!("it was sent something")),
        &["status-pose"],
    )
    .await;
}

#[tokio::test]
async fn a_wrong_tail_that_is_obeyed_is_caught() {
    let broken = good().hears(|_, bytes| {
        if let Some(tail) = bytes.get_mut(41) {
            *tail = 0x5A;
        }
    });
    let report = check(broken, ON_A_PORT).await;
    assert!(
        report.differing().contains(&"frame-tail"),
        "{}",
        table(&report)
    );
}

#[tokio::test]
async fn a_packet_lost_behind_noise_is_caught() {
    let broken = good().hears(|_, bytes| {
        if bytes.len() > 42 && bytes[0] == 0 {
            bytes.clear();
        }
    });
    caught(broken, &["frame-noise"]).await;
}

#[tokio::test]
async fn a_packet_lost_with_its_second_half_is_caught() {
    let broken = good().hears(|_, bytes| {
        if bytes.len() == 25 {
            bytes.clear();
        }
    });
    let report = check(broken, ON_A_PORT).await;
    assert!(
        report.differing().contains(&"frame-pieces"),
        "{}",
        table(&report)
    );
}

#[tokio::test]
async fn the_second_of_two_packets_lost_is_caught() {
    let broken = good().hears(|_, bytes| {
        if bytes.len() == 84 {
            bytes.truncate(42);
        }
    });
    caught(broken, &["frame-pair"]).await;
}

#[tokio::test]
async fn an_end_effector_that_is_ignored_is_caught() {
    let broken = good().obeys(|frame| {
        let is_tool = frame.float(1) == 9.0 && frame.float(2) == 4.0;
        (!is_tool).then_some(frame)
    });
    caught(broken, &["set-tool"]).await;
}

#[tokio::test]
async fn ignored_releases_are_caught_and_no_other_button_is_pressed() {
    let broken = good().obeys(|frame| (!is_release(&frame)).then_some(frame));
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.differing(), ["jog-release"], "{}", table(&report));
    assert!(untried(&report).contains(&"jog-rear"), "{}", table(&report));
}

#[tokio::test]
async fn exchanged_buttons_of_rear_arm_and_forearm_are_caught() {
    let broken = good().obeys(|frame| {
        let axis = match frame.float(2) {
            axis @ (3.0 | 4.0) => axis + 2.0,
            axis @ (5.0 | 6.0) => axis - 2.0,
            axis => axis,
        };
        Some(if frame.float(1) == 2.0 {
            frame.with(2, axis)
        } else {
            frame
        })
    });
    caught(broken, &["jog-rear", "jog-fore"]).await;
}

#[tokio::test]
async fn exchanged_buttons_of_x_are_caught() {
    let broken = good().obeys(|frame| {
        let axis = match frame.float(2) {
            1.0 => 2.0,
            2.0 => 1.0,
            axis => axis,
        };
        Some(if frame.float(1) == 7.0 {
            frame.with(2, axis)
        } else {
            frame
        })
    });
    caught(broken, &["line-x"]).await;
}

#[tokio::test]
async fn a_pump_that_cannot_be_switched_is_caught() {
    let broken = good().obeys(|frame| {
        let is_pump = frame.float(1) == 2.0 && frame.float(2) == 9.0;
        (!is_pump).then_some(frame)
    });
    caught(broken, &["jog-pump"]).await;
}

#[tokio::test]
async fn the_third_of_the_waiting_commands_lost_is_caught() {
    // The slow vector is the only one with a largest speed of 3; the third behind it is lost.
    let mut behind = u32::MAX;
    let broken = good().obeys(move |frame| {
        behind = behind.saturating_add(1);
        if frame.float(1) == 4.0 && frame.float(10) == 3.0 {
            behind = 0;
        }
        (behind != 3).then_some(frame)
    });
    caught(broken, &["flow-six"]).await;
}

#[tokio::test]
async fn statuses_that_are_never_withheld_are_caught() {
    caught(good().talkative(), &["flow-silence"]).await;
}

#[tokio::test]
async fn pauses_that_are_ignored_are_caught() {
    let broken = good().obeys(|frame| {
        let moves = matches!(frame.float(1), 3.0 | 6.0);
        Some(if moves { frame.with(10, 0.0) } else { frame })
    });
    caught(broken, &["move-pause"]).await;
}

#[tokio::test]
async fn a_jump_that_does_not_lift_is_caught() {
    let broken = good().obeys(|frame| {
        let jumps = frame.float(1) == 3.0 && frame.float(8) == 0.0;
        Some(if jumps { frame.with(8, 1.0) } else { frame })
    });
    caught(broken, &["move-jump"]).await;
}

#[tokio::test]
async fn speeds_that_are_ignored_are_caught() {
    let broken = good().obeys(|frame| {
        let sets = frame.float(1) == 9.0 && frame.float(2) < 3.0;
        (!sets).then_some(frame)
    });
    let report = check(broken, ON_A_PORT).await;
    for id in ["set-jog", "set-moves", "set-writing", "move-jump"] {
        assert!(report.differing().contains(&id), "{id}: {}", table(&report));
    }
}

#[tokio::test]
async fn angles_that_are_not_taken_back_end_the_run_without_another_move() {
    let arm = speaking(Personality::Specification);
    let broken = Broken::new(arm.clone()).obeys(|frame| {
        let is_angles = frame.float(1) == 9.0 && frame.float(2) == 3.0;
        let rear = frame.float(3) + 3.0;
        Some(if is_angles {
            frame.with(3, rear)
        } else {
            frame
        })
    });
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.differing(), ["set-angles"], "{}", table(&report));
    assert!(untried(&report).contains(&"return"), "{}", table(&report));
    // It still stands 10 mm higher than at the start.
    let height = true_position(&arm).z.0 + 17.68;
    assert!((height - 10.0).abs() < 0.1, "{height}");
}

#[tokio::test]
async fn exchanged_ways_to_move_alone_make_a_mixed_dialect() {
    let broken = good().obeys(|frame| {
        let moves = matches!(frame.float(1), 3.0 | 6.0);
        let mode = match frame.float(8) {
            1.0 => 2.0,
            2.0 => 1.0,
            mode => mode,
        };
        Some(if moves { frame.with(8, mode) } else { frame })
    });
    let report = check(broken, ON_A_PORT).await;
    let Verdict::Mixed { firmware_1_1, .. } = report.verdict() else {
        panic!("{}", table(&report));
    };
    assert_eq!(firmware_1_1, ["move-modes"]);
    assert_eq!(report.differing(), [""; 0], "{}", table(&report));
    assert!(!report.conforms());
}

#[tokio::test]
async fn a_reversed_x_of_write_vectors_alone_makes_a_mixed_dialect() {
    let broken = good().obeys(|frame| {
        let x = frame.float(3);
        Some(if frame.float(1) == 4.0 {
            frame.with(3, -x)
        } else {
            frame
        })
    });
    let report = check(broken, ON_A_PORT).await;
    let Verdict::Mixed { firmware_1_1, .. } = report.verdict() else {
        panic!("{}", table(&report));
    };
    assert_eq!(firmware_1_1, ["write-vector"]);
}

#[tokio::test]
async fn the_report_names_every_check_once_and_is_the_same_every_time() {
    let peer = || speaking(Personality::Firmware11);
    let first = check(peer(), ALL).await.markdown("virtual:", "2016-02-26");
    let second = check(peer(), ALL).await.markdown("virtual:", "2016-02-26");
    assert_eq!(first, second);
    assert!(first.starts_with(HEADING));
    assert!(first.contains("| speaks | firmware-1.1 |"), "{first}");
    for check in Check::ALL {
        let cell = format!("| `{}` | {} |", check.id, check.title);
        assert_eq!(first.matches(&cell).count(), 1, "{cell}");
    }
}

/// Serves an arm over a stream, by tokio's clock.
async fn serve(arm: InProcess, mut stream: DuplexStream) {
    let opened = Instant::now();
    let mut bytes = [0; 256];
    loop {
        let wakeup = opened + arm.arm().poll_wakeup();
        tokio::select! {
            read = stream.read(&mut bytes) => match read {
                Ok(count) if count > 0 => arm.arm().handle_bytes(opened.elapsed(), &bytes[..count]),
                _ => return,
            },
            () = sleep_until(wakeup) => arm.arm().handle_time(opened.elapsed()),
        }
        let mut out = Vec::new();
        arm.arm().poll_bytes(&mut out);
        if stream.write_all(&out).await.is_err() {
            return;
        }
    }
}

fn over_stream(arm: &InProcess) -> Link {
    let (near, far) = tokio::io::duplex(1024);
    tokio::spawn(serve(arm.clone(), far));
    Link::over_stream(near)
}

#[tokio::test(start_paused = true)]
async fn all_holds_over_a_stream_too() {
    let arm = speaking(Personality::Firmware11);
    let report = Suite::new(over_stream(&arm), ON_A_PORT).run(|_| {}).await;
    assert_eq!(report.verdict(), Verdict::Firmware11, "{}", table(&report));
    assert!(report.conforms(), "{}", table(&report));
}

#[tokio::test(start_paused = true)]
async fn whenever_a_run_is_stopped_the_arm_goes_back_to_where_it_was() {
    for personality in Personality::ALL {
        for tenths in (5..600).step_by(97) {
            let arm = speaking(personality);
            let mut suite = Suite::new(over_stream(&arm), ON_A_PORT);
            let run = suite.run(|_| {});
            let cut = timeout(Duration::from_millis(100 * tenths), run).await;
            assert!(
                cut.is_err(),
                "the run was over before {tenths} tenths of a second"
            );
            suite.stop().await.expect("the arm is there");
            let arm = arm.arm();
            let joints = arm.controller().joints_at(arm.now());
            let off = (joints.rear.0 - 45.0).abs() + (joints.fore.0 - 45.0).abs();
            assert!(off < 0.04, "{personality}, {tenths}: {joints:?}");
            assert!(!arm.controller().suction(), "{personality}, {tenths}");
        }
    }
}

const fn ms(ms: u64) -> Duration {
    Duration::from_millis(ms)
}

#[tokio::test]
async fn all_holds_behind_a_line_of_up_to_250_ms_each_way_and_its_latency_is_told() {
    for personality in Personality::ALL {
        for one_way in (0..=250).step_by(5) {
            let peer = Delayed::by(speaking(personality), ms(one_way));
            let report = check(peer, ALL).await;
            assert!(report.conforms(), "{one_way} ms: {}", table(&report));
            assert_eq!(untried(&report), [""; 0]);
            let told = report.latency().expect("it was measured").least;
            let off = told.abs_diff(ms(2 * one_way));
            assert!(off <= ms(25), "{one_way} ms each way, told {told:?}");
            let text = report.markdown("virtual:", "2016-02-26");
            assert!(text.contains(&format!("| latency | {} ms", told.as_millis())));
        }
    }
}

#[tokio::test]
async fn a_line_that_is_now_fast_and_now_slow_is_waited_for() {
    for personality in Personality::ALL {
        let late = [20, 90, 35, 110, 60, 25, 80].map(ms).to_vec();
        let report = check(Delayed::in_turn(speaking(personality), late), ON_A_PORT).await;
        assert_eq!(report.differing(), [""; 0], "{}", table(&report));
    }
}

#[tokio::test]
async fn a_line_too_slow_is_told_and_nothing_is_moved() {
    for (one_way, told) in [(350, 700), (900, 1800), (2500, 5000)] {
        let arm = speaking(Personality::Firmware11);
        let report = check(Delayed::by(arm.clone(), ms(one_way)), ON_A_PORT).await;
        assert_eq!(report.differing(), [""; 0], "{}", table(&report));
        let Some(Hindrance::Slow(took)) = report.hindrance() else {
            panic!("{}", table(&report));
        };
        assert!(took.abs_diff(ms(told)) <= ms(25), "{took:?}");
        let outcome = report.outcome("move-point").expect("it is one");
        assert!(
            outcome.found().starts_with("the line is too slow ("),
            "{outcome}"
        );
        assert!(outcome.found().contains("at most 600 ms"), "{outcome}");
        assert_eq!(arm.arm().controller().steps(), [0; 3]);
    }
}

#[tokio::test]
async fn a_controller_that_hears_nothing_is_told_so() {
    let deaf = good().hears(|_, bytes| bytes.clear());
    let report = check(deaf, ON_A_PORT).await;
    assert_eq!(report.differing(), ["line-delay"], "{}", table(&report));
    let outcome = report.outcome("line-delay").expect("it is one");
    assert!(
        outcome.found().starts_with("nothing that is sent shows"),
        "{outcome}"
    );
}

#[tokio::test]
async fn exchanged_angles_in_the_status_are_said_to_disagree_with_the_position() {
    let broken = good().says(|frame| {
        let (rear, fore) = (frame.float(6), frame.float(7));
        Some(frame.with(6, fore).with(7, rear).to_bytes().to_vec())
    });
    let report = check(broken, ON_A_PORT).await;
    let outcome = report.outcome("move-point").expect("it is one");
    assert!(outcome.differs(), "{outcome}");
    assert!(
        outcome
            .found()
            .contains("whose position and angles disagree"),
        "{outcome}"
    );
}

/// A small generator of chances, the same every time.
fn every_so_often(seed: u64, percent: u64) -> impl FnMut() -> bool + Send {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state % 100 < percent
    }
}

#[tokio::test]
async fn a_line_that_loses_commands_makes_no_good_controller_differ() {
    for personality in Personality::ALL {
        for seed in 1..=12 {
            let mut lost = every_so_often(seed, 3);
            let broken =
                Broken::new(speaking(personality)).obeys(move |frame| (!lost()).then_some(frame));
            let report = check(broken, ON_A_PORT).await;
            assert_eq!(report.differing(), [""; 0], "{seed}: {}", table(&report));
            assert!(!matches!(report.verdict(), Verdict::Mixed { .. }));
        }
    }
}

#[tokio::test]
async fn a_line_that_loses_statuses_is_told_and_makes_no_good_controller_differ() {
    for personality in Personality::ALL {
        for seed in 1..=12 {
            let mut lost = every_so_often(seed, 2);
            let broken = Broken::new(speaking(personality))
                .says(move |frame| (!lost()).then(|| frame.to_bytes().to_vec()));
            let report = check(broken, ON_A_PORT).await;
            assert_eq!(report.differing(), [""; 0], "{seed}: {}", table(&report));
        }
    }
}

#[tokio::test]
async fn a_check_that_holds_at_the_second_time_only_is_unsteady() {
    let mut jumps = 0;
    let broken = good().obeys(move |frame| {
        let is_jump = frame.float(1) == 3.0 && frame.float(8) == 0.0;
        jumps += u32::from(is_jump);
        (!is_jump || jumps > 1).then_some(frame)
    });
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.unsteady(), ["move-jump"], "{}", table(&report));
    assert_eq!(report.differing(), [""; 0]);
    assert!(!report.conforms());
    assert!(
        report.summary().contains("1 unsteady"),
        "{}",
        report.summary()
    );
}

#[tokio::test]
async fn a_pump_that_runs_is_said_to_hinder() {
    let broken = good().says(|frame| Some(frame.with(9, 1.0).to_bytes().to_vec()));
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.hindrance(), Some(&Hindrance::Pump));
}

/// The checks that say something else of a broken arm than of a good one, where both were tried.
async fn told_apart(personality: Personality, broken: Broken, ids: &[&str]) {
    let (good, broken) = (
        check(speaking(personality), ON_A_PORT).await,
        check(broken, ON_A_PORT).await,
    );
    let rows = good.rows().iter().zip(broken.rows());
    let others = rows.filter(|(good, broken)| {
        let tried = !matches!(broken.outcome, Outcome::NotTried(_));
        tried && good.outcome.word() != broken.outcome.word()
    });
    let others: Vec<_> = others.map(|(good, _)| good.check.id).collect();
    assert_eq!(others, ids, "{}", table(&broken));
    assert!(!broken.conforms());
}

/// Packets sent right behind each other instead of one.
fn instead(
    personality: Personality,
    change: impl Fn(&Frame) -> Option<Vec<Frame>> + Send + 'static,
) -> Broken {
    Broken::new(speaking(personality)).hears(move |_, bytes| {
        let frame = bytes.first_chunk().and_then(Frame::from_bytes);
        let frames = frame
            .filter(|_| bytes.len() == 42)
            .and_then(|it| change(&it));
        if let Some(frames) = frames {
            *bytes = frames.iter().flat_map(Frame::to_bytes).collect();
        }
    })
}

#[tokio::test]
async fn a_jump_that_crosses_in_another_way_is_caught() {
    // The target that is higher than the arm stands for all other checks.
    let rises = |frame: &Frame| {
        let jumps = frame.float(1) == 3.0 && frame.float(8) == 0.0;
        jumps && frame.float(5) > -5.0
    };
    let straight = instead(Personality::Firmware11, move |frame| {
        rises(frame).then(|| vec![frame.with(8, 1.0)])
    });
    told_apart(Personality::Firmware11, straight, &["jump-across"]).await;
    // Up, across and down by joints, by as much at either end: 6 mm to the left and 4 mm up.
    let lifts = instead(Personality::Specification, move |frame| {
        let (y, z) = (frame.float(4), frame.float(5));
        let by_joints = frame.with(8, 2.0);
        rises(frame).then(|| {
            vec![
                by_joints.with(4, y - 6.0).with(5, z - 4.0 + 5.0),
                by_joints.with(5, z + 5.0),
                by_joints,
            ]
        })
    });
    told_apart(Personality::Specification, lifts, &["jump-across"]).await;
}

#[tokio::test]
async fn a_release_of_the_other_kind_that_takes_the_acceleration_of_its_own_is_caught() {
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(|frame| {
        let is_teach = frame.float(1) == 9.0 && frame.float(2) == 0.0;
        let (joint, line) = (frame.float(4), frame.float(8));
        Some(if is_teach {
            frame.with(4, line).with(8, joint)
        } else {
            frame
        })
    });
    told_apart(Personality::Firmware11, broken, &["release-kind"]).await;
}

#[tokio::test]
async fn a_release_of_the_other_kind_that_is_ignored_is_caught() {
    for personality in Personality::ALL {
        let mut held = 0.0;
        let broken = Broken::new(speaking(personality)).obeys(move |frame| {
            let is_jog = matches!(frame.float(1), 2.0 | 7.0);
            if is_jog && !is_release(&frame) {
                held = frame.float(1);
            }
            (!is_release(&frame) || frame.float(1) == held).then_some(frame)
        });
        told_apart(personality, broken, &["release-kind"]).await;
    }
}

#[tokio::test]
async fn a_stock_arm_that_runs_down_where_it_is_makes_a_mixed_dialect() {
    let mut held = 2.0;
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(move |frame| {
        let is_jog = matches!(frame.float(1), 2.0 | 7.0);
        if is_jog && !is_release(&frame) {
            held = frame.float(1);
        }
        Some(if is_release(&frame) {
            frame.with(1, held)
        } else {
            frame
        })
    });
    let report = check(broken, ON_A_PORT).await;
    let Verdict::Mixed { specification, .. } = report.verdict() else {
        panic!("{}", table(&report));
    };
    assert_eq!(specification, ["release-kind"]);
}

#[tokio::test]
async fn a_run_down_with_an_acceleration_that_was_set_behind_the_press_is_caught() {
    // By the document: the acceleration of the setting counts from the beginning.
    let broken = good().obeys(|frame| {
        let is_slow = frame.float(1) == 9.0 && frame.float(2) == 0.0 && frame.float(6) == 8.0;
        Some(if is_slow { frame.with(6, 80.0) } else { frame })
    });
    told_apart(Personality::Specification, broken, &["release-settings"]).await;
    // On a stock arm: the button acts once more, with what was set.
    let button = Frame::ZERO.with(1, 2.0).with(2, 7.0).with(8, 20.0);
    let press = std::sync::Mutex::new(false);
    let broken = instead(Personality::Firmware11, move |frame| {
        let mut pressed = press.lock().expect("nobody else has it");
        let is_fast = frame.float(1) == 9.0 && frame.float(6) == 80.0;
        *pressed |= is_fast;
        (*pressed && is_release(frame)).then(|| {
            *pressed = false;
            vec![button, *frame]
        })
    });
    told_apart(Personality::Firmware11, broken, &["release-settings"]).await;
}

#[tokio::test]
async fn a_move_of_whole_ticks_that_takes_another_number_of_them_is_caught() {
    // A trifle less of a turn: a stock arm needs no tick more for it.
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(|frame| {
        let base = frame.float(3);
        Some(if frame.float(1) == 6.0 {
            frame.with(3, base - 4e-6)
        } else {
            frame
        })
    });
    told_apart(Personality::Firmware11, broken, &["move-ticks"]).await;
    // A tick of rest behind each move.
    let broken = good().obeys(|frame| {
        let pauses = frame.float(1) == 6.0;
        Some(if pauses { frame.with(10, 0.02) } else { frame })
    });
    told_apart(Personality::Specification, broken, &["move-ticks"]).await;
}

#[tokio::test]
async fn whichever_command_gets_lost_no_good_controller_differs_or_loses_its_pose() {
    for personality in Personality::ALL {
        for lost in (0..420).step_by(3) {
            let arm = speaking(personality);
            let mut count = 0;
            let broken = Broken::new(arm.clone()).obeys(move |frame| {
                count += 1;
                (count != lost).then_some(frame)
            });
            let report = check(broken, ON_A_PORT).await;
            assert_eq!(report.differing(), [""; 0], "{lost}: {}", table(&report));
            let arm = arm.arm();
            let joints = arm.controller().joints_at(arm.now());
            assert!((joints.rear.0 - 45.0).abs() < 0.05, "{lost}: {joints:?}");
        }
    }
}

#[tokio::test]
async fn where_a_move_got_lost_no_line_without_length_follows_it() {
    let mut lost = 0;
    let broken = Broken::new(speaking(Personality::Firmware11)).obeys(move |frame| {
        let [state, servo, mode] = [1, 6, 8].map(|n| frame.float(n));
        // Only `move-joints` turns the servo by 4 degrees, and goes back in a line.
        assert!(lost == 0 || state != 6.0 || mode != 2.0);
        let is_lost = state == 6.0 && servo > 3.0;
        lost += u32::from(is_lost);
        (!is_lost).then_some(frame)
    });
    caught(broken, &["move-joints"]).await;
}

#[test]
fn the_page_lists_every_check_once_in_order() {
    let page = include_str!("../../../../docs/conformance.md");
    let rows = page.lines().filter(|line| line.starts_with("| `"));
    let ids: Vec<_> = rows
        .clone()
        .filter_map(|row| row.split('`').nth(1))
        .collect();
    let checks: Vec<_> = Check::ALL.iter().map(|it| it.id).collect();
    assert_eq!(ids, checks);
    for (row, check) in rows.zip(Check::ALL) {
        let expected = format!("| {} | {} |", check.title, check.source);
        assert!(row.contains(&expected), "{row}: {expected}");
    }
}
