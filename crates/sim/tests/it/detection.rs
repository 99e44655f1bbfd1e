//! Which dialect a virtual arm speaks, by what it does, in virtual time.

use std::time::Duration;

use dobot_arm::{Joints, Pose, Position, Tool};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Detection, DetectionError, Peer, plausible, position};
use dobot_sim::{Fault, InProcess, SerialLine, VirtualArm};
use dobot_wire::{Command, Decoder, Finding, JointJog, JointJogAxis, Status, Statuses};
use proptest::prelude::*;

/// An arm, and what its line brings.
struct Bench {
    arm: InProcess,
    decoder: Decoder<Statuses>,
    /// How far the tool went from where it stood at first, at the most.
    farthest_mm: f64,
    fastest_mm_s: f64,
}

impl Bench {
    fn new(personality: Personality, rear_deg: f64, fore_deg: f64, faults: &[&str]) -> Self {
        let power_up = PowerUp::new(personality).with_tilt(rear_deg, fore_deg);
        let read = |text: &&str| text.parse::<Fault>().expect("it is a fault");
        let faults: Vec<Fault> = faults.iter().map(read).collect();
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        Self {
            arm: InProcess::new(arm.with_faults(power_up, &faults, 11)),
            decoder: Decoder::statuses(plausible),
            farthest_mm: 0.0,
            fastest_mm_s: 0.0,
        }
    }

    fn statuses(&mut self) -> Vec<Status> {
        let mut bytes = Vec::new();
        let until = self.arm.now() + Duration::from_secs(1);
        self.arm.receive(until, &mut bytes);
        let frames = self.decoder.feed(&bytes);
        frames.filter_map(|it| Status::parse(&it).ok()).collect()
    }

    fn first(&mut self) -> Status {
        loop {
            if let Some(status) = self.statuses().pop() {
                return status;
            }
        }
    }

    fn found(&self) -> Position {
        let arm = self.arm.arm();
        arm.controller().pose_at(arm.now()).position
    }

    fn detect(&mut self) -> Result<Finding, DetectionError> {
        let first = self.first();
        self.go_through(Detection::new(&first, |_| true)?)
    }

    fn go_through(&mut self, mut detection: Detection) -> Result<Finding, DetectionError> {
        let from = self.found();
        let (mut before, mut at) = (from, self.arm.now());
        while self.arm.now() < Duration::from_secs(300) {
            for status in self.statuses() {
                detection.handle_status(self.arm.now(), &status);
            }
            if let Some(packet) = detection.poll_packet() {
                self.arm.send(&packet.to_bytes());
                assert_eq!(detection.poll_packet(), None, "one for each status");
            }
            let (found, now) = (self.found(), self.arm.now());
            let took_s = now.saturating_sub(at).as_secs_f64();
            if took_s > 0.0 {
                let speed_mm_s = found.distance(before).0 / took_s;
                self.fastest_mm_s = self.fastest_mm_s.max(speed_mm_s);
            }
            self.farthest_mm = self.farthest_mm.max(found.distance(from).0);
            (before, at) = (found, now);
            if let Some(outcome) = detection.poll_outcome() {
                return outcome;
            }
        }
        panic!("no end in sight: {detection:?}");
    }
}

/// The arms' angles for a place straight ahead.
fn angles(reach_mm: f64, z_mm: f64) -> (f64, f64) {
    let pose = Pose {
        position: Position::new(reach_mm, 0.0, z_mm),
        ..Pose::default()
    };
    let joints = dobot_arm::inverse(&pose, Tool::SuctionCup).expect("it is in reach");
    (joints.rear.0, joints.fore.0)
}

#[test]
fn both_dialects_are_found_from_where_an_arm_stands_at_power_up() {
    for personality in Personality::ALL {
        let mut bench = Bench::new(personality, 45.0, 45.0, &[]);
        let from = bench.first();
        let finding = bench.detect().expect("nothing is in its way");
        assert_eq!(finding.dialect, personality.dialect(), "{finding:?}");
        assert_eq!(finding.evidence.len(), 3);
        for line in finding.lines() {
            assert!(line.ends_with(personality.name()), "{line}");
        }
        let back_mm = bench.found().distance(position(&from)).0;
        assert!(back_mm < 0.1, "it ended {back_mm} mm from where it began");
        assert!(bench.farthest_mm < 21.0, "{} mm", bench.farthest_mm);
        assert!(bench.fastest_mm_s < 30.0, "{} mm/s", bench.fastest_mm_s);
        let arm = bench.arm.arm();
        assert_eq!(arm.controller().counters().refused, 0);
    }
}

#[test]
fn an_arm_without_room_gets_a_hint_and_no_packet() {
    let (rear_deg, fore_deg) = angles(316.0, 20.0);
    let mut bench = Bench::new(Personality::Firmware11, rear_deg, fore_deg, &[]);
    let error = bench.detect().expect_err("it is stretched out");
    assert!(matches!(error, DetectionError::NoRoom { .. }), "{error}");
    assert!(error.to_string().contains("220, 0, 20 mm"), "{error}");
    assert_eq!(bench.arm.arm().controller().counters().packets, 0);
}

#[test]
fn what_is_not_allowed_is_no_room() {
    let mut bench = Bench::new(Personality::Firmware11, 45.0, 45.0, &[]);
    let status = bench.first();
    let fence = |joints: &Joints| joints.base.0 < 1.0;
    let error = Detection::new(&status, fence).expect_err("it would turn further");
    assert!(error.to_string().contains("is not allowed"), "{error}");
}

#[test]
fn an_arm_that_somebody_else_moves_is_left_alone() {
    for personality in Personality::ALL {
        let mut bench = Bench::new(personality, 45.0, 45.0, &[]);
        let status = bench.first();
        let jog = Command::from(JointJog::new(JointJogAxis::BasePlus, 20.0));
        let packet = jog.emit(&personality.dialect());
        bench.arm.send(&packet.to_bytes());
        let _ = bench.first();
        let _ = bench.first();
        let detection = Detection::new(&status, |_| true).expect("there is room");
        let error = bench.go_through(detection).expect_err("it moves");
        assert!(matches!(error, DetectionError::Moving), "{error}");
    }
}

#[test]
fn an_arm_that_does_not_obey_is_reported() {
    let mut bench = Bench::new(Personality::Firmware11, 45.0, 45.0, &["drop=100%:to"]);
    let error = bench.detect().expect_err("it hears nothing");
    assert!(matches!(error, DetectionError::DidNotMove), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// From anywhere with room, with one status in a hundred lost and one damaged.
    #[test]
    fn the_dialect_is_found_on_a_bad_line_from_anywhere_with_room(
        stock in any::<bool>(),
        reach_mm in 195.0..275.0_f64,
        z_mm in -60.0..70.0_f64,
    ) {
        let personality = if stock { Personality::Firmware11 } else { Personality::Specification };
        let (rear_deg, fore_deg) = angles(reach_mm, z_mm);
        let faults = ["drop=0.024%:from", "flip=0.024%:from"];
        let mut bench = Bench::new(personality, rear_deg, fore_deg, &faults);
        match bench.detect() {
            Ok(finding) => prop_assert_eq!(finding.dialect, personality.dialect()),
            Err(DetectionError::NoRoom { .. }) => return Err(TestCaseError::reject("no room")),
            Err(error) => prop_assert!(false, "{error}"),
        }
    }
}
