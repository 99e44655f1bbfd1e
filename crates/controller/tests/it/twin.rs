//! Behavior of the stock controller's twin that no recording covers.

use std::time::Duration;

use dobot_controller::{Controller, Hang, Personality, Port, PowerUp, Refused};
use dobot_wire::{Frame, Packet, Voice};

/// A twin on simulated time, and its last status.
struct Twin {
    controller: Controller,
    now: Duration,
    status: Frame,
    refused: Vec<Refused>,
}

impl Twin {
    fn power_up(port: Port) -> Self {
        let power_up = PowerUp::new(Personality::Firmware11).with_port(port);
        Self {
            controller: Controller::power_up(power_up),
            now: Duration::ZERO,
            status: Frame::ZERO,
            refused: Vec::new(),
        }
        .wait_ms(100)
    }

    /// Sends a packet over the line, byte by byte, followed by a gap of 8 ms.
    fn send(self, floats: &[f32]) -> Self {
        self.send_packet(frame(floats)).wait_ms(8)
    }

    fn send_packet(mut self, packet: impl Into<Packet>) -> Self {
        for byte in packet.into().to_bytes() {
            self.now += Duration::from_micros(1040);
            self.controller.handle_bytes(self.now, &[byte]);
        }
        self
    }

    fn wait_ms(mut self, ms: u64) -> Self {
        let until = self.now + Duration::from_millis(ms);
        while self.controller.poll_wakeup() <= until {
            let at = self.controller.poll_wakeup();
            self.controller.handle_time(at);
            while let Some(upload) = self.controller.poll_bytes() {
                self.status = Frame::from_bytes(&upload.bytes).expect("a status is a frame");
            }
            let refused = std::iter::from_fn(|| self.controller.poll_refused());
            self.refused.extend(refused);
        }
        self.now = until;
        self
    }

    /// Base, rear, fore, servo.
    fn angles(&self) -> [f32; 4] {
        [5, 6, 7, 8].map(|n| self.status.float(n))
    }

    #[track_caller]
    fn expect_angles(self, expected: [f32; 4]) -> Self {
        let found = self.angles();
        let is_near = found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 0.01);
        assert!(is_near, "the angles are {found:?}, not {expected:?}");
        self
    }

    fn printed(&mut self) -> String {
        std::iter::from_fn(|| self.controller.poll_other_port())
            .map(char::from)
            .collect()
    }
}

fn frame(floats: &[f32]) -> Frame {
    floats
        .iter()
        .zip(1..)
        .fold(Frame::ZERO, |frame, (value, n)| frame.with(n, *value))
}

fn jog(axis: f32) -> Frame {
    frame(&[2.0, axis, 0.0, 0.0, 0.0, 0.0, 0.0, 100.0])
}

#[test]
fn the_first_limit_is_forgiven_and_the_second_is_not() {
    let to_the_limit = |twin: Twin| twin.send_packet(jog(3.0)).wait_ms(6000);
    let twin = to_the_limit(Twin::power_up(Port::Usb));
    // Rear minus fore may be 35 degrees, which is at 80; the rear arm alone may go to 85.
    let rear = twin.angles()[1];
    assert!((84.7..=85.0).contains(&rear), "{rear}");
    assert_eq!(twin.refused, [Refused::CutShort]);
    let back = twin
        .send_packet(jog(4.0))
        .wait_ms(4000)
        .send_packet(jog(0.0));
    let rear = to_the_limit(back.wait_ms(1000)).angles()[1];
    assert!((79.7..=80.0).contains(&rear), "{rear}");
}

#[test]
fn a_jog_goes_on_until_it_is_released() {
    let twin = Twin::power_up(Port::Usb)
        .send_packet(jog(1.0))
        .wait_ms(10_000);
    let base = twin.angles()[0];
    assert!(base > 140.0, "{base}");
    let released = twin.send_packet(jog(0.0)).wait_ms(1000);
    let rests_at = released.angles();
    assert_eq!(released.wait_ms(1000).angles(), rests_at);
}

#[test]
fn a_target_out_of_reach_is_skipped() {
    let twin = Twin::power_up(Port::Usb)
        .send(&[3.0, 0.0, 400.0, 0.0, 0.0, 0.0, 0.0, 1.0])
        .send(&[6.0, 0.0, 10.0, 45.0, 45.0, 0.0, 0.0, 1.0])
        .wait_ms(2000)
        .expect_angles([10.0, 45.0, 45.0, 0.0]);
    assert_eq!(twin.refused, [Refused::OutOfReach]);
}

#[test]
fn a_joint_move_without_speed_never_ends() {
    let twin = Twin::power_up(Port::Usb)
        .send(&[9.0, 1.0, 0.0, 200.0, 0.0, 200.0, 100.0, 200.0, 0.0, 10.0])
        .send(&[6.0, 0.0, 10.0, 45.0, 45.0, 0.0, 0.0, 1.0])
        .send(&[9.0, 2.0, 100.0])
        .wait_ms(60_000)
        .expect_angles([0.0, 45.0, 45.0, 0.0]);
    assert_eq!(twin.refused, [Refused::Hangs(Hang::NeverArrives)]);
    assert_eq!(twin.controller.counters().begun, 2);
}

#[test]
fn a_pause_beyond_sixteen_bits_of_ticks_never_ends() {
    let paused = |pause_s: f32| {
        Twin::power_up(Port::Usb)
            .send(&[6.0, 0.0, 10.0, 45.0, 45.0, 0.0, 0.0, 1.0, 0.0, pause_s])
            .send(&[6.0, 0.0, 20.0, 45.0, 45.0, 0.0, 0.0, 1.0])
            .wait_ms(2_000_000)
            .angles()[0]
    };
    // 32767 ticks are 655.34 s.
    assert!((paused(655.0) - 20.0).abs() < 0.01);
    assert!((paused(656.0) - 10.0).abs() < 0.01);
}

#[test]
fn steady_mouse_packets_count_more_and_more_up_to_twice_and_a_tenth() {
    let mut twin = Twin::power_up(Port::Usb);
    let mut swings = Vec::new();
    for _ in 0..12 {
        let before = twin.angles()[0];
        twin = twin.send(&[1.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0]).wait_ms(300);
        swings.push((before - twin.angles()[0]) / (4.0 * 0.225));
    }
    // One sample more than is stored counts, and the new one besides: (2n - 1) / n.
    for (n, swing) in (1_u8..=10).zip(&swings) {
        let n = f32::from(n);
        let expected = (2.0 * n - 1.0) / n;
        assert!((swing - expected).abs() < 0.001, "{n}: {swings:?}");
    }
    assert!((swings[10] - 2.1).abs() < 0.001, "{swings:?}");
    assert!((swings[11] - 2.1).abs() < 0.001, "{swings:?}");
}

#[test]
fn another_command_between_makes_the_mouse_forget() {
    let swing = [1.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0];
    Twin::power_up(Port::Usb)
        .send(&swing)
        .wait_ms(300)
        .send(&[9.0, 2.0, 100.0])
        .send(&swing)
        .wait_ms(300)
        .expect_angles([-2.0 * 4.0 * 0.225, 45.0, 45.0, 0.0]);
}

#[test]
fn state_15_follows_one_packet_late_and_from_zero() {
    let follow = [15.0, 0.0, 50.0, 40.0, 10.0];
    Twin::power_up(Port::Usb)
        .send(&follow)
        .wait_ms(300)
        .expect_angles([0.0, 0.0, 0.0, 0.0])
        .send(&follow)
        .wait_ms(300)
        .expect_angles([5.0, 25.0, 20.0, 0.0]);
}

#[test]
fn the_first_gesture_counts_half() {
    let twin = Twin::power_up(Port::Usb)
        .send(&[8.0, 0.0, 0.0, 40.0, 200.0])
        .wait_ms(1000);
    // Half of 40; in whole ticks the last part of the way may be missing.
    let y_mm = twin.status.float(2);
    assert!((18.0..=20.01).contains(&y_mm), "{y_mm}");
}

/// The number of packets lost because the next one followed before the buffer was searched, with a
/// gap after each, as counted by the text on the other port.
fn lost_of_200(case: &Meanwhile, gap_us: u64) -> u32 {
    let idle = Twin::power_up(Port::Usb);
    let mut twin = case.begin.iter().fold(idle, |twin, it| twin.send(it));
    let packet = &case.packet;
    for _ in 0..200 {
        twin = twin.send_packet(frame(packet));
        twin.now += Duration::from_micros(gap_us);
        twin.printed();
    }
    let printed = twin.send(packet).wait_ms(100).printed();
    let counts = printed.lines().last().expect("it counts").to_owned();
    let lost = counts.rsplit(',').next().expect("three of them");
    lost.parse().expect("a number")
}

/// Packets while a command is executed.
struct Meanwhile {
    name: &'static str,
    /// The packet that starts it; it lasts longer than 200 packets.
    begin: Vec<Vec<f32>>,
    packet: Vec<f32>,
}

fn each_kind() -> [Meanwhile; 9] {
    let setting = || vec![9.0, 2.0, 100.0];
    // 130 mm at 1 mm/s, or as many degrees at 2 degrees/s.
    let slow = |mode| {
        let ratios = vec![10.0, 0.0, 1.0, 50.0, 50.0];
        let target = vec![3.0, 0.0, 230.0, 130.0, -17.0, 0.0, 0.0, mode];
        vec![ratios, target]
    };
    let vector = vec![4.0, 0.0, 0.0, 60.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    // Each jog replaces the one before; each mouse and each hand waits for its turn.
    let jog = |state| vec![state, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    [
        ("idle", vec![], setting()),
        ("joint jog", vec![], jog(2.0)),
        ("linear jog", vec![], jog(7.0)),
        ("MOVJ", slow(1.0), setting()),
        ("MOVL", slow(2.0), setting()),
        ("JUMP", slow(0.0), setting()),
        ("writing", vec![vector], setting()),
        ("mouse", vec![], vec![1.0, 0.0, 1.0]),
        ("gesture", vec![], vec![8.0, 0.0, 60.0, 20.0, 200.0]),
    ]
    .map(|(name, begin, packet)| Meanwhile {
        name,
        begin,
        packet,
    })
}

/// Of two hundred packets the real one lost none, 8 % and 15 %.
#[test]
fn packets_without_a_gap_are_lost_by_what_a_tick_calculates() {
    for case in each_kind() {
        let lost = lost_of_200(&case, 0);
        let expected = match case.name {
            "idle" => 0..=0,
            "MOVJ" => 10..=22,
            "MOVL" | "linear jog" | "writing" => 24..=36,
            // No measurement; the longest tick is no longer than 7 ms.
            _ => 0..=60,
        };
        assert!(expected.contains(&lost), "{}: {lost} of 200", case.name);
    }
}

#[test]
fn packets_with_a_gap_of_8_ms_are_never_lost() {
    for gap_us in [8000, 8320, 9700, 13_000] {
        for case in each_kind() {
            let lost = lost_of_200(&case, gap_us);
            assert_eq!(lost, 0, "{}, {gap_us} us", case.name);
        }
    }
}

#[test]
fn a_seventh_spoken_order_locks_the_queue_for_ever() {
    let speak = |twin: Twin| {
        let voice = Voice::new("ahead ten").expect("it fits");
        twin.send_packet(voice)
    };
    // One is obeyed while the others come; it lasts longer than all of them.
    let slowly = Twin::power_up(Port::Bluetooth)
        .send(&[9.0, 1.0, 200.0, 200.0, 200.0, 200.0, 0.5, 200.0, 0.0, 10.0])
        // Fetched while a text begins to arrive, the setting would be taken for voice.
        .wait_ms(100);
    let obeyed = (0..7).fold(slowly, |twin, _| speak(twin));
    let locked = speak(obeyed).wait_ms(200_000);
    assert_eq!(locked.controller.counters().begun, 2, "the setting and one");
}

#[test]
fn the_laser_stays_on_after_its_vector() {
    let burnt = Twin::power_up(Port::Usb)
        .send(&[4.0, 1.0, 10.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 20.0])
        .wait_ms(5000);
    assert!(burnt.controller.laser());
    let stopped = burnt.send(&[4.0, 1.0, 0.0, 0.0, 0.0, 1.0]).wait_ms(100);
    assert!(!stopped.controller.laser());
}

#[test]
fn motors_stand_still_where_the_pose_is_lost() {
    let line_on_the_spot = |twin: Twin| {
        let [x, y, z] = [1, 2, 3].map(|n| twin.status.float(n));
        twin.send(&[3.0, 0.0, x, y, z, 0.0, 0.0, 2.0]).wait_ms(500)
    };
    let twin = line_on_the_spot(Twin::power_up(Port::Usb));
    assert!(twin.status.float(1).is_nan());
    assert_eq!(twin.refused, [Refused::PoseLost]);
    assert_eq!(twin.controller.steps(), [0; 3]);
    let joints = twin.controller.joints_at(twin.now);
    assert_eq!(joints, dobot_arm::Joints::new(0.0, 45.0, 45.0, 0.0));
}
