//! An arm whose zeros are wrong, and who is known to be so: all places that people speak of are true ones.

use std::time::Duration;

use dobot_api::{
    CalibrationFile, ClientId, JobKind, JobProgram, NewJob, Request, ToolOffset, Zeros,
};
use dobot_arm::{Calibration, Position, Tool};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::{Fault, SerialLine, VirtualArm};
use dobot_supervisor::Refusal;
use dobot_wire::{Command, MoveJoints, MoveTo, MovingMode, WriteVector};

/// An arm that is not where it reports, and a person who knows that.
struct Known {
    station: VirtualStation,
    anna: ClientId,
}

const ZEROS: Zeros = Zeros {
    base: 12.0,
    rear: -9.0,
    fore: 7.0,
};
const TOOL: ToolOffset = ToolOffset {
    out_mm: 6.0,
    left_mm: -4.0,
};

impl Known {
    fn new(personality: Personality, policy: &str) -> Self {
        let power_up = PowerUp::new(personality);
        let Zeros { base, rear, fore } = ZEROS;
        let faults = [("base", base), ("rear", rear), ("fore", fore)]
            .map(|(joint, deg)| format!("zero={joint}:{deg}").parse::<Fault>().unwrap());
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        let arm = arm.with_faults(power_up, &faults, 0);
        let policy = Policy::from_toml(policy).unwrap();
        let mut station = VirtualStation::with_arm(arm, power_up, policy);
        let anna = station.client("Anna");
        station.run_for(Duration::from_secs(1));
        let calibration = CalibrationFile {
            zeros: ZEROS,
            tool: TOOL,
            ..CalibrationFile::default()
        };
        let calibration = Some(Box::new(calibration));
        let answer = station.ask(anna, Request::Calibrate { calibration });
        answer.unwrap();
        station.ask(anna, Request::TakeLease).unwrap();
        Self { station, anna }
    }

    fn ask(&mut self, request: Request) -> Result<(), Refusal> {
        self.station.ask(self.anna, request)?;
        self.station.run_for(Duration::from_secs(12));
        Ok(())
    }

    fn send(&mut self, command: impl Into<Command>) -> Result<(), Refusal> {
        let command = command.into();
        self.ask(Request::Command { command })
    }

    /// Returns the true tool position: by the joints of the machine and the tool mount.
    fn really(&self) -> Position {
        let now = self.station.arm().now();
        let joints = self.station.arm().mechanics().joints_at(now);
        let crooked = Calibration {
            reach_mm: TOOL.out_mm,
            left_mm: TOOL.left_mm,
            ..Calibration::NONE
        };
        crooked.true_place_of(&joints, Tool::SuctionCup)
    }

    /// Returns the reported position.
    fn reported(&self) -> Position {
        let status = self.station.supervisor().state().arm.unwrap().status;
        Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into())
    }

    fn is_at(&self, wanted: [f64; 3]) {
        let [x, y, z] = wanted;
        let wanted = Position::new(x, y, z);
        for (who, found) in [("is", self.really()), ("reports", self.reported())] {
            assert!(
                wanted.distance(found).0 < 0.06,
                "it {who} {found:?} instead of {wanted:?}"
            );
        }
    }
}

fn line(x: f32, y: f32, z: f32) -> MoveTo {
    MoveTo::to(x, y, z).with_mode(MovingMode::MovL)
}

#[test]
fn a_calibrated_arm_goes_to_the_true_place_and_reports_it() {
    for personality in Personality::ALL {
        let mut arm = Known::new(personality, "");
        arm.send(MoveTo::to(220.0, 30.0, 10.0)).unwrap();
        arm.is_at([220.0, 30.0, 10.0]);
        arm.send(line(200.0, -60.0, -20.0)).unwrap();
        arm.is_at([200.0, -60.0, -20.0]);
        arm.send(WriteVector::by(10.0, 20.0, 0.0, 40.0)).unwrap();
        arm.is_at([210.0, -40.0, -20.0]);
        arm.send(MoveJoints::to([0.0, 40.0, 45.0, 0.0])).unwrap();
        let reported = arm.station.supervisor().state().arm.unwrap().status;
        let really = arm
            .station
            .arm()
            .mechanics()
            .joints_at(arm.station.arm().now());
        let reported_deg = [reported.base_deg, reported.rear_deg, reported.fore_deg].map(f64::from);
        for (reported_deg, is) in
            reported_deg
                .into_iter()
                .zip([really.base.0, really.rear.0, really.fore.0])
        {
            assert!(
                (reported_deg - is).abs() < 0.02,
                "{reported_deg} instead of {is}"
            );
        }
        assert!(
            really.base.0.abs() < 0.02 && (really.rear.0 - 40.0).abs() < 0.02,
            "{really:?}"
        );
    }
}

#[test]
fn the_policy_judges_true_places() {
    for personality in Personality::ALL {
        // By its own account it would be elsewhere at each of these.
        let mut arm = Known::new(
            personality,
            "[workspace]\nz_mm = [-20, 100]\n[keep_out]\nlamp = { cylinder = { x_mm = 200, y_mm = 90, radius_mm = 20, z_mm = [-100, 120] } }\n",
        );
        arm.send(line(210.0, 0.0, 0.0)).unwrap();
        arm.send(line(210.0, 0.0, -19.5)).unwrap();
        arm.is_at([210.0, 0.0, -19.5]);
        let refused = arm.send(line(210.0, 0.0, -20.5)).unwrap_err();
        assert!(
            refused.to_string().contains("z would be -20.5"),
            "{refused}"
        );
        let Refusal::Policy(violation) = refused else {
            panic!("the policy forbids it");
        };
        let nearest = violation.nearest.unwrap();
        assert!((nearest[2] + 20.0).abs() < 0.1, "{nearest:?}");
        let refused = arm.send(MoveTo::to(200.0, 90.0, 20.0)).unwrap_err();
        assert!(refused.to_string().contains("keep_out.lamp"), "{refused}");
        arm.is_at([210.0, 0.0, -19.5]);
    }
}

#[test]
fn the_target_of_a_command_is_reported_in_true_places() {
    let mut arm = Known::new(Personality::Firmware11, "");
    let command = Command::from(MoveTo::to(220.0, 30.0, 10.0));
    let way = match arm.station.ask(arm.anna, Request::CheckCommand { command }) {
        Ok(dobot_api::Reply::Way { way }) => way,
        other => panic!("{other:?}"),
    };
    let end = way.path_mm.last().unwrap();
    assert!(
        (end[0] - 220.0).abs() < 0.01 && (end[1] - 30.0).abs() < 0.01,
        "{end:?}"
    );
}

#[test]
fn an_arm_with_its_true_angles_set_needs_no_zeros_until_it_is_reset() {
    for personality in Personality::ALL {
        let mut arm = Known::new(personality, "");
        arm.send(MoveTo::to(220.0, 30.0, 10.0)).unwrap();
        let crooked = arm.ask(Request::SetAngles).unwrap_err();
        assert!(crooked.to_string().contains("straight ahead"), "{crooked}");
        arm.send(MoveJoints::to([0.0, 40.0, 45.0, 0.0])).unwrap();
        arm.ask(Request::SetAngles).unwrap();
        let state = arm.station.supervisor().state();
        assert!(state.calibrated.unwrap().angles_set);
        let reported = state.arm.unwrap().raw.unwrap();
        assert!(
            (reported.rear_deg - 40.0).abs() < 0.02,
            "the arm itself reports {reported:?}"
        );
        // A person confirms that its reported pose is now right.
        arm.ask(Request::ConfirmPose).unwrap();
        arm.send(line(220.0, 30.0, 10.0)).unwrap();
        arm.is_at([220.0, 30.0, 10.0]);
    }
}

#[test]
fn a_job_made_before_the_angles_were_set_is_not_drawn_at_other_places() {
    let mut arm = Known::new(Personality::Firmware11, "");
    arm.send(MoveJoints::to([0.0, 40.0, 45.0, 0.0])).unwrap();
    let job = NewJob {
        title: "there".into(),
        kind: JobKind::Program,
        commands: vec![MoveTo::to(220.0, 0.0, 30.0).into()],
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram::default(),
    };
    let job = arm.station.submit(&job).unwrap();
    arm.ask(Request::SetAngles).unwrap();
    let refused = arm.ask(Request::StartJob { job }).unwrap_err();
    assert!(refused.to_string().contains("submit it again"), "{refused}");
}

#[test]
fn a_calibration_is_accepted_only_at_rest_and_can_be_undone() {
    let mut arm = Known::new(Personality::Specification, "");
    let command = Command::from(MoveTo::to(220.0, 30.0, 10.0));
    arm.station
        .ask(arm.anna, Request::Command { command })
        .unwrap();
    arm.station.run_for(Duration::from_millis(300));
    let refused = arm
        .station
        .ask(arm.anna, Request::Calibrate { calibration: None });
    assert!(
        matches!(refused, Err(Refusal::StillMoving { .. })),
        "{refused:?}"
    );
    arm.station.run_for(Duration::from_secs(12));
    arm.is_at([220.0, 30.0, 10.0]);
    arm.ask(Request::Calibrate { calibration: None }).unwrap();
    let state = arm.station.supervisor().state();
    assert_eq!(state.calibrated, None);
    assert_eq!(state.arm.unwrap().raw, None);
}
