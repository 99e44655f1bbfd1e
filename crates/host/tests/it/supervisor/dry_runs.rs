//! Dry runs: their predictions for a program, and the motion of the arm.

use std::time::Duration;

use dobot_api::{ClientId, JobState, NewJob, Reply, Request};
use dobot_controller::{Personality, PowerUp};
use dobot_host::{DryRun, PlannedFor, VirtualStation, dry_run};
use dobot_safety::Policy;
use dobot_teach::{Compiled, NoFiles, Program};
use dobot_wire::{Command, MoveTo, PlaybackAdjustment};
use proptest::prelude::*;

/// The start of a program waits for a status, and its end is seen in one.
const TOLERANCE_S: f64 = 0.3;

fn compiled(text: &str) -> Compiled {
    let program = Program::from_toml(text).expect("it is a program");
    program
        .compile(&mut NoFiles)
        .expect("its points are in reach")
}

/// An arm that was moved and configured before.
struct UsedArm {
    station: VirtualStation,
    client: ClientId,
}

impl UsedArm {
    fn new(personality: Personality, policy: Policy) -> Self {
        let mut station = VirtualStation::new(PowerUp::new(personality), policy);
        station.run_for(Duration::from_secs(1));
        let client = station.client("Anna");
        station.ask(client, Request::TakeLease).expect("it is free");
        Self { station, client }
    }

    fn does(&mut self, command: Command) {
        let asked = self.station.ask(self.client, Request::Command { command });
        assert!(matches!(asked, Ok(Reply::Accepted { .. })), "{asked:?}");
        self.station.run_for(Duration::from_secs(20));
    }

    fn dry_run(&self, program: &Compiled) -> DryRun {
        let state = self.station.supervisor().state();
        dry_run(
            program,
            &PlannedFor::of(self.station.rules().into(), &state),
        )
    }

    /// Runs the program, and returns how long it takes, in seconds; `None` if it is refused.
    fn runs(&mut self, program: &Compiled) -> Option<f64> {
        let job = NewJob {
            title: "a program".to_owned(),
            ..program.job()
        };
        let job = self.station.submit(&job).ok()?;
        self.station.start(self.client, job).ok()?;
        let started = self.station.now();
        let is_over =
            |station: &VirtualStation| station.job(job).is_ok_and(|job| job.state.is_over());
        let latest = started + Duration::from_secs(3600);
        assert!(self.station.run_until(latest, is_over));
        let job = self.station.job(job).expect("it was queued");
        (job.state == JobState::Done)
            .then(|| self.station.now().saturating_sub(started).as_secs_f64())
    }
}

/// A step of a random program, as TOML.
fn step() -> impl Strategy<Value = String> {
    // Some of the points are beyond the reach of the arm or the policy.
    let go = (150.0..290.0_f64, -150.0..150.0_f64, -30.0..120.0_f64);
    let path = prop::sample::select(vec!["jump", "movl", "movj"]);
    (go, path, 0.0..1.0_f64, any::<bool>()).prop_map(|((x, y, z), path, pause, suction)| {
            format!("go = {{ x = {x:.1}, y = {y:.1}, z = {z:.1} }}\npath = \"{path}\"\npause = {pause:.1}\nsuction = {suction}")
        })
}

/// A program whose cycle goes there and back: how long a pause without a motion takes depends on when
/// the statuses come.
fn program() -> impl Strategy<Value = String> {
    let steps = prop::collection::vec(step(), 0..5);
    let speed = prop::option::of(20..100_i32);
    (steps, 20..60_i32, 1..5_u32, speed).prop_map(|(steps, y, times, speed)| {
        let there_and_back = [y, -y].map(|y| format!("go = {{ x = 210, y = {y}, z = 30 }}"));
        let steps = there_and_back.iter().chain(&steps);
        let steps = steps.map(|step| format!("[[steps.steps]]\n{step}\n"));
        let speed = speed.map_or_else(String::new, |percent| {
            format!("[[steps]]\nspeed = {{ percent = {percent} }}\n")
        });
        format!(
            "{speed}[[steps]]\nrepeat = {times}\n{}",
            steps.collect::<String>()
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_dry_run_and_the_arm_agree_on_duration_and_refusals(
        text in program(),
        is_stock in any::<bool>(),
        (x, y, z) in (210.0..250.0_f32, -60.0..60.0_f32, 10.0..40.0_f32),
        percent in prop::option::of(10.0..100.0_f32),
    ) {
        let personality = if is_stock { Personality::Firmware11 } else { Personality::Specification };
        let program = Program::from_toml(&text).expect("it is a program");
        let Ok(program) = program.compile(&mut NoFiles) else { return Ok(()) };
        let mut arm = UsedArm::new(personality, Policy::default());
        arm.does(MoveTo::to(x, y, z).into());
        if let Some(percent) = percent {
            arm.does(PlaybackAdjustment {
                speed_percent: percent,
                acceleration_percent: 50.0,
                teach_speed_percent: 100.0,
            }.into());
        }
        let predicted = arm.dry_run(&program);
        let took_s = arm.runs(&program);
        prop_assert_eq!(predicted.problems.is_empty(), took_s.is_some(), "{:?}", predicted.problems);
        if let (Some(predicted_s), Some(took_s)) = (predicted.total_s, took_s) {
            let off_s = (predicted_s - took_s).abs();
            prop_assert!(off_s < TOLERANCE_S, "predicted {predicted_s} s, took {took_s} s");
        }
    }
}

#[test]
fn a_dry_run_starts_at_the_current_place_of_the_arm() {
    for personality in [Personality::Specification, Personality::Firmware11] {
        let there = compiled("[[steps]]\ngo = { x = 220, y = 60, z = 30 }\npath = \"movj\"");
        let mut arm = UsedArm::new(personality, Policy::default());
        let from_afar = arm.dry_run(&there);
        assert_eq!(from_afar.problems, []);
        arm.does(MoveTo::to(220.0, 55.0, 30.0).into());
        let from_near = arm.dry_run(&there).first_s;
        assert!(
            from_near.is_some() && from_near < from_afar.first_s,
            "{from_near:?} {from_afar:?}"
        );
    }
}

#[test]
fn a_program_with_a_problem_has_no_duration() {
    let far = compiled(
        "[[steps]]\ngo = { x = 200, y = 0, z = 20 }\n[[steps]]\ngo = { x = 400, y = 0, z = 20 }",
    );
    let report = UsedArm::new(Personality::Specification, Policy::default()).dry_run(&far);
    let lines: Vec<_> = report
        .problems
        .iter()
        .map(|problem| (problem.step, problem.line))
        .collect();
    assert_eq!(lines, [(2, 3)]);
    assert_eq!(
        (report.first_s, report.cycle_s, report.total_s),
        (None, None, None)
    );
}

#[test]
fn a_refusal_at_the_first_step_names_step_and_line() {
    let policy = Policy::from_toml("[workspace]\nx_mm = [100, 210]\n").expect("it is a policy");
    let program = compiled("[[steps]]\ngo = { x = 230, y = 0, z = 20 }");
    let report = UsedArm::new(Personality::Specification, policy).dry_run(&program);
    let first = report.problems.first().expect("the policy forbids it");
    assert_eq!((first.step, first.line), (1, 1), "{first}");
    assert!(first.message.contains("100 to 210"), "{first}");
}
