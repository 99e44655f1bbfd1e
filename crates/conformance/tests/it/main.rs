//! The suite against good controllers, and against one that is broken in one thing at a time.

mod broken;
mod delayed;
mod details;
mod line;

use std::time::Duration;

use broken::Broken;
use dobot_arm::{Joints, Position, Tool, forward};
use dobot_conformance::{Check, HEADING, Options, Outcome, Report, Suite, Verdict};
use dobot_controller::{Controller, Personality, Port, PowerUp, STEPS_PER_DEG};
use dobot_session::{Link, Peer};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::{Frame, Status};
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
    InProcess::new(VirtualArm::new(controller, SerialLine::STOCK))
}

fn speaking(personality: Personality) -> InProcess {
    arm(PowerUp::new(personality))
}

/// A stock arm on its Bluetooth port (note N38).
fn over_bluetooth() -> InProcess {
    arm(PowerUp::new(Personality::Firmware11).with_port(Port::Bluetooth))
}

/// One arm for each way in which a good controller may behave.
fn good_arms() -> [InProcess; 3] {
    let [document, stock] = Personality::ALL.map(speaking);
    [document, stock, over_bluetooth()]
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
async fn all_holds_of_the_bluetooth_port_of_the_twin() {
    let report = check(over_bluetooth(), ALL).await;
    assert!(report.is_bluetooth());
    assert_eq!(report.verdict(), Verdict::Firmware11, "{}", table(&report));
    assert!(report.conforms(), "{}", table(&report));
    assert_eq!(untried(&report), [""; 0]);
    assert!(
        report
            .summary()
            .ends_with("speaks firmware-1.1 over Bluetooth"),
        "{}",
        report.summary()
    );
}

#[tokio::test]
async fn a_client_that_joins_between_two_statuses_over_bluetooth_finds_that_all_holds() {
    // Each tick of the cycle of 160 ms may be the first one.
    for ticks in 1..=8 {
        let arm = over_bluetooth();
        arm.clone()
            .receive(Duration::from_millis(1000 + 20 * ticks), &mut Vec::new());
        let report = check(arm, ON_A_PORT).await;
        assert!(report.conforms(), "{ticks}: {}", table(&report));
    }
}

#[tokio::test]
async fn permits_that_go_on_over_bluetooth_while_six_commands_wait_are_caught() {
    // A permit is due between two messages; where none came, one is put in.
    let mut messages = 0;
    let broken = Broken::new(over_bluetooth()).says(move |frame| {
        let is_message = frame.float(1) > 500.0;
        messages = if is_message { messages + 1 } else { 0 };
        let mut bytes = Vec::new();
        if messages == 3 {
            bytes.extend(frame.with(1, frame.float(1) - 1000.0).to_bytes());
            messages = 1;
        }
        bytes.extend(frame.to_bytes());
        Some(bytes)
    });
    caught_over_bluetooth(broken, &["flow-silence"]).await;
}

#[tokio::test]
async fn buttons_as_on_usb_are_caught_over_bluetooth() {
    let broken = Broken::new(over_bluetooth()).obeys(|frame| {
        let axis = match (frame.float(1), frame.float(2)) {
            (2.0, axis @ (1.0 | 2.0)) => axis + 2.0,
            (2.0, axis @ (3.0 | 4.0)) => axis - 2.0,
            (_, axis) => axis,
        };
        Some(frame.with(2, axis))
    });
    let report = check(broken, ON_A_PORT).await;
    assert!(
        report.differing().contains(&"jog-release"),
        "{}",
        table(&report)
    );
}

#[tokio::test]
async fn voice_that_is_ignored_over_bluetooth_is_caught() {
    let broken = Broken::new(over_bluetooth()).on_receive(|_, bytes| {
        if bytes.first() == Some(&0xB5) {
            bytes.clear();
        }
    });
    caught_over_bluetooth(broken, &["voice"]).await;
}

#[tokio::test]
async fn messages_without_permits_are_caught_over_bluetooth() {
    let broken = Broken::new(over_bluetooth()).says(|frame| {
        let status = Status::parse(&frame).ok()?;
        let is_message = status.message().is_some();
        is_message.then(|| frame.to_bytes().to_vec())
    });
    let report = check(broken, ON_A_PORT).await;
    assert!(
        report.differing().contains(&"status-period"),
        "{}",
        table(&report)
    );
}

/// The checks that find something wrong with the Bluetooth port, and nothing else.
async fn caught_over_bluetooth(broken: Broken, ids: &[&str]) {
    let report = check(broken, ON_A_PORT).await;
    assert_eq!(report.differing(), ids, "{}", table(&report));
    assert!(!report.conforms());
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
    for arm in good_arms() {
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
    for arm in good_arms() {
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
async fn an_arm_without_space_is_not_moved_and_the_error_says_where_to_stand() {
    let raised = PowerUp::default().with_tilt(60.0, 92.0);
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
async fn a_silent_line_is_reported_and_nothing_is_sent() {
    let silent = good()
        .says(|_| None)
        .on_receive(|_, _| panic!("it was sent something"));
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
        broken.on_receive(|_, _| panic!("it was sent something")),
        &["status-pose"],
    )
    .await;
}

#[tokio::test]
async fn a_wrong_tail_that_is_obeyed_is_caught() {
    let broken = good().on_receive(|_, bytes| {
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
    let broken = good().on_receive(|_, bytes| {
        if bytes.len() > 42 && bytes[0] == 0 {
            bytes.clear();
        }
    });
    caught(broken, &["frame-noise"]).await;
}

#[tokio::test]
async fn a_packet_lost_with_its_second_half_is_caught() {
    let broken = good().on_receive(|_, bytes| {
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
    let broken = good().on_receive(|_, bytes| {
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
    // The slow vector is the only one with a largest speed of 3; the third after it is lost.
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
