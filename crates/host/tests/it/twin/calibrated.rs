//! An old arm before and after its calibration: where its pen really goes.

use std::time::Duration;

use dobot_api::{Backlash, CalibrationFile, ClientId, JobKind, JobPhase, NewJob, Request};
use dobot_arm::{Calibration, Joints, Limits, Plane, Pose, Position, Tool};
use dobot_calibrate::{COMB_STEP_DEG, Procedure, SHEET_POINTS, SlackJoint, comb, found};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_draw::{Prepared, Settings, prepare};
use dobot_geometry::{Deviation, Point, Random, Stroke, deviation};
use dobot_host::VirtualStation;
use dobot_plan::{ArmLimits, Paper};
use dobot_safety::Policy;
use dobot_sim::{Fault, SerialLine, VirtualArm};
use dobot_wire::{Command, MoveJoints, MovingMode};

/// An arm with wrong zeros, a crooked tool and paper that is not level.
struct OldArm {
    station: VirtualStation,
    client: ClientId,
    personality: Personality,
    backlash_deg: [f64; 3],
}

/// The errors of the arm's reports.
const TRUTH: Calibration = Calibration {
    base_deg: 4.0,
    rear_deg: -4.0,
    fore_deg: 4.0,
    reach_mm: 7.0,
    left_mm: -3.0,
    axis_mm: [0.0, 0.0],
    backlash_deg: [0.0; 3],
    table: None,
};
/// The tool without the joints: a virtual arm has its zeros itself.
const TOOL_ONLY: Calibration = Calibration {
    base_deg: 0.0,
    rear_deg: 0.0,
    fore_deg: 0.0,
    ..TRUTH
};
/// The part of a calibration about its joints.
const ZEROS: Calibration = Calibration {
    reach_mm: 0.0,
    left_mm: 0.0,
    ..TRUTH
};
const HARBOUR: &str = include_str!("../../../../../examples/drawings/harbour.svg");

#[test]
fn a_calibrated_old_arm_draws_the_harbour_at_the_place_on_the_sheet() {
    for personality in Personality::ALL {
        let mut arm = OldArm::new(personality, [0.0; 3]);
        let known = arm.calibrate();
        let after = arm.draw(Some(known)).largest_mm();
        let before = OldArm::new(personality, [0.0; 3]).draw(None).largest_mm();
        assert!(
            after < 0.3,
            "{personality:?}: {after} mm after the calibration"
        );
        assert!(before > 10.0, "{personality:?}: {before} mm before it");
    }
}

#[test]
fn the_backlash_of_an_old_arm_is_taken_up_when_its_joints_turn_back() {
    let slack = [0.3, 0.25, 0.3];
    for personality in Personality::ALL {
        let mut arm = OldArm::new(personality, slack);
        let known = arm.calibrate();
        let stiff = CalibrationFile {
            backlash: Backlash::default(),
            ..known.clone()
        };
        let with = arm.draw(Some(known));
        let without = OldArm::new(personality, slack).draw(Some(stiff));
        // The missing and the extra ink, including where the pen comes down and goes up.
        let missed = |deviation: &Deviation| deviation.missed.distance_mm;
        assert!(
            missed(&with) < missed(&without) / 2.0,
            "{with:?}, {without:?}"
        );
        assert!(
            with.largest_mm() < without.largest_mm(),
            "{with:?}, {without:?}"
        );
    }
}

#[test]
fn a_person_reads_the_backlash_of_each_joint_from_its_comb() {
    let slack = [0.3, 0.2, 0.45];
    let joints = [SlackJoint::Base, SlackJoint::Rear, SlackJoint::Fore];
    for (joint, wanted) in joints.into_iter().zip(slack) {
        let mut arm = OldArm::new(Personality::Firmware11, slack);
        let level = |_| -44.0;
        let commands = comb(joint, &ZEROS, level, TOOL).unwrap();
        // Where the two lines of each pair are, by the joint that came to them.
        let mut lines = Vec::new();
        for command in commands {
            let is_target = !matches!(command, Command::PlaybackAdjustment(_));
            arm.station
                .ask(arm.client, Request::Command { command })
                .unwrap();
            arm.station.run_for(Duration::from_secs(5));
            if is_target {
                let now = arm.station.arm().now();
                let at = arm.station.arm().mechanics().joints_at(now);
                lines.push(match joint {
                    SlackJoint::Base => at.base.0,
                    SlackJoint::Rear => at.rear.0,
                    SlackJoint::Fore => at.fore.0,
                });
            }
        }
        let apart = lines.chunks(10).map(|pair| (pair[2] - pair[7]).abs());
        let meets = apart.zip(0..).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        let read_deg = f64::from(meets.1) * COMB_STEP_DEG;
        assert!(
            (read_deg - wanted).abs() < 0.03,
            "{joint:?}: {read_deg} instead of {wanted}"
        );
    }
}

impl OldArm {
    fn new(personality: Personality, backlash_deg: [f64; 3]) -> Self {
        let power_up = PowerUp::new(personality);
        let joints = ["base", "rear", "fore"];
        let zeros = [TRUTH.base_deg, TRUTH.rear_deg, TRUTH.fore_deg];
        let zeros = joints
            .iter()
            .zip(zeros)
            .map(|(joint, deg)| format!("zero={joint}:{deg}"));
        let slack = joints.iter().zip(backlash_deg);
        let slack = slack.map(|(joint, deg)| format!("backlash={joint}:{deg}"));
        let faults: Vec<Fault> = zeros
            .chain(slack)
            .map(|fault| fault.parse().unwrap())
            .collect();
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        let arm = arm.with_faults(power_up, &faults, 0);
        let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
        let client = station.client("a person");
        station.run_for(Duration::from_secs(1));
        station.ask(client, Request::TakeLease).unwrap();
        Self {
            station,
            client,
            personality,
            backlash_deg,
        }
    }

    /// A person brings the tip to each point of the sheet, and misses it by a tenth of a millimetre.
    fn calibrate(&mut self) -> CalibrationFile {
        let mut procedure = Procedure::new(TOOL);
        let mut random = Random::new(16);
        for _ in SHEET_POINTS {
            let (_, [x, y]) = procedure.next_point();
            let [dx, dy, dz] = [0; 3].map(|_| (random.share() - 0.5) * 0.3);
            let place = Position::new(x + dx, y + dy, paper_z_mm(Point::new(x, y)) + dz);
            let joints = TRUTH.raw_joints(place, TOOL).unwrap();
            // From the right and from above: each joint turns on to the point.
            let beside = Joints::new(
                joints.base.0 - 3.0,
                joints.rear.0 - 0.8,
                joints.fore.0 - 0.8,
                0.0,
            );
            self.go(beside);
            self.go(joints);
            procedure.touch(self.reported(), 0.0);
        }
        let [base, rear, fore] = self.backlash_deg;
        found(&procedure.outcome().unwrap(), Backlash { base, rear, fore })
    }

    #[expect(clippy::cast_possible_truncation, reason = "as a command holds it")]
    fn go(&mut self, to: Joints) {
        let angles = [to.base, to.rear, to.fore, to.servo].map(|angle| angle.0 as f32);
        let command = MoveJoints::to(angles).with_mode(MovingMode::MovJ).into();
        self.station
            .ask(self.client, Request::Command { command })
            .unwrap();
        self.station.run_for(Duration::from_secs(6));
    }

    fn reported(&self) -> Joints {
        let at = self.station.supervisor().state().arm.unwrap().status;
        Joints::new(
            at.base_deg.into(),
            at.rear_deg.into(),
            at.fore_deg.into(),
            0.0,
        )
    }

    /// Draws the harbour; returns how far the true ink is from the drawing in the file.
    fn draw(&mut self, known: Option<CalibrationFile>) -> Deviation {
        let wanted = prepared(self.personality, None).wanted();
        // The rules know it too: they judge true places, and take no job that is meant for another arm.
        let calibration = known.clone().map(Box::new);
        self.station
            .ask(self.client, Request::Calibrate { calibration })
            .unwrap();
        let Prepared { plan, .. } = prepared(self.personality, known);
        #[expect(clippy::cast_possible_truncation, reason = "as a job holds it")]
        let job = NewJob {
            title: "harbour".to_owned(),
            kind: JobKind::Drawing,
            commands: plan.commands().collect(),
            lift_mm: plan.lift_mm() as f32,
            pauses: Vec::new(),
            program: dobot_api::JobProgram::default(),
        };
        let job = self.station.submit(&job).unwrap();
        self.station.start(self.client, job).unwrap();
        let mut ink: Vec<Stroke> = Vec::new();
        let mut is_down = true;
        // The position before it drew is not ink.
        let mut has_begun = false;
        loop {
            let now = self.station.arm().now();
            let joints = self.station.arm().mechanics().joints_at(now);
            let at = TOOL_ONLY.true_place_of(&joints, TOOL);
            let place = Point::new(at.x.0, at.y.0);
            let above_mm = at.z.0 - paper_z_mm(place);
            has_begun |= above_mm > 3.0 && place.distance(wanted[0].points[0]) < 40.0;
            // A pen gives by this much.
            let writes = above_mm < 0.4;
            if writes && has_begun {
                if !is_down {
                    ink.push(Stroke::default());
                }
                ink.last_mut().unwrap().points.push(place);
            }
            is_down = writes && has_begun;
            let job = self
                .station
                .jobs()
                .unwrap()
                .into_iter()
                .find(|view| view.job == job);
            match job.unwrap().phase {
                JobPhase::Done => return deviation(&wanted, &ink),
                JobPhase::Running => self.station.run_for(Duration::from_millis(5)),
                other => panic!("the drawing is {other:?}"),
            }
        }
    }
}

fn prepared(personality: Personality, calibration: Option<CalibrationFile>) -> Prepared {
    let paper = Paper::sloping(Plane {
        z0_mm: Z0_MM,
        slope_x: SLOPE_X,
        slope_y: SLOPE_Y,
    });
    let paper = match &calibration {
        Some(known) => {
            let found = known.paper.as_ref().unwrap();
            let paper = Paper::sloping(found.plane());
            paper.to_raw(known.arm(), TOOL)
        }
        None => paper,
    };
    let settings = Settings {
        paper,
        calibration,
        arm_limits: ArmLimits::of(personality.dialect()),
        ..Settings::default()
    };
    let reachable = |position| {
        let pose = Pose {
            position,
            ..Pose::default()
        };
        Limits::STOCK.solve(&pose, TOOL).map(|_| ())
    };
    prepare(&HARBOUR.into(), &settings, reachable).unwrap()
}

/// The paper as it really lies.
fn paper_z_mm(place: Point) -> f64 {
    Z0_MM + SLOPE_X * place.x + SLOPE_Y * place.y
}

const TOOL: Tool = Tool::SuctionCup;
const Z0_MM: f64 = -44.0;
const SLOPE_X: f64 = 0.02;
const SLOPE_Y: f64 = -0.02;
