//! Programs that ask while they run.

use std::time::Duration;

use dobot_api::{
    Answer, ClientId, GivenPlace, JobPhase, JobState, PendingQuestion, Question, Request,
};
use dobot_controller::Personality;
use dobot_host::{PlannedFor, ProgramStart, VirtualStation, dry_run_program, program_job};
use dobot_supervisor::Refusal;
use dobot_teach::{NoFiles, Program};
use proptest::prelude::*;

use crate::cases::carries::{HERE, THERE, attend, cube_is_at, run_until_rest, station};

const BOTH: [Personality; 2] = [Personality::Specification, Personality::Firmware11];

/// Goes to one of two sides, then back.
const SIDES: &str = r#"
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
choose = "Which side?"
by = "seen"
[[steps.when]]
answer = "left"
[[steps.when.steps]]
go = { x = 200, y = 80, z = 40 }
[[steps.when]]
answer = "right"
[[steps.when.steps]]
go = { x = 200, y = -80, z = 40 }
[[steps]]
choose = "Again?"
timeout = 5
otherwise = "no"
[[steps.when]]
answer = "no"
[[steps.when]]
answer = "yes"
[[steps.when.steps]]
go = { x = 240, y = 0, z = 40 }
"#;

/// Submits the program from a step on, counted from 1.
fn submitted_from(station: &mut VirtualStation, text: &str, step: usize) -> u64 {
    let program = Program::from_toml(text).unwrap();
    let arm = PlannedFor::of(station.rules().into(), &station.supervisor().state());
    let start = ProgramStart::Step(step);
    let mut job = program_job(&program, None, start, &arm, &mut NoFiles).unwrap();
    job.title = "a program".into();
    station.submit(&job).unwrap()
}

fn submitted(station: &mut VirtualStation, text: &str) -> u64 {
    submitted_from(station, text, 1)
}

fn started(station: &mut VirtualStation, anna: ClientId, text: &str) -> u64 {
    let job = submitted(station, text);
    station.start(anna, job).unwrap();
    job
}

fn question(station: &VirtualStation) -> Option<PendingQuestion> {
    station.supervisor().job()?.question
}

/// Runs until the program asks.
#[track_caller]
fn run_until_asked(station: &mut VirtualStation) -> Question {
    let latest = station.now() + Duration::from_secs(600);
    let asked = station.run_until(latest, |station| question(station).is_some());
    assert!(asked, "{:?}", station.supervisor().job());
    question(station).unwrap().question
}

#[track_caller]
fn run_until_over(station: &mut VirtualStation, job: u64) -> JobState {
    let latest = station.now() + Duration::from_secs(600);
    let is_over = |station: &VirtualStation| station.job(job).unwrap().state.is_over();
    assert!(
        station.run_until(latest, is_over),
        "{:?}",
        station.supervisor().job()
    );
    station.job(job).unwrap().state
}

fn answer(station: &mut VirtualStation, job: u64, answer: Answer) -> Result<(), Refusal> {
    // A camera, which does not have control.
    let camera = station.client("camera");
    station.ask(
        camera,
        Request::AnswerJob {
            job,
            question: None,
            answer,
        },
    )?;
    station.leave(camera);
    Ok(())
}

fn choice(text: &str) -> Answer {
    Answer::Choice(text.to_owned())
}

fn place(x_mm: f64, y_mm: f64, z_mm: f64) -> Answer {
    let rotation_deg = 0.0;
    Answer::Place(GivenPlace {
        name: None,
        x_mm,
        y_mm,
        z_mm,
        rotation_deg,
        sense: None,
    })
}

/// The reported x and y, in mm.
fn xy(station: &VirtualStation) -> [f64; 2] {
    let status = station.supervisor().state().arm.unwrap().status;
    [status.x_mm, status.y_mm].map(f64::from)
}

#[track_caller]
fn assert_xy(station: &VirtualStation, expected: [f64; 2]) {
    let found = xy(station);
    let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
    assert!(off < 0.5, "the arm is at {found:?}, expected {expected:?}");
}

#[test]
fn the_arm_waits_at_rest_and_continues_with_the_steps_of_the_answer() {
    for personality in BOTH {
        for (side, y) in [("left", 80.0), ("right", -80.0)] {
            let (mut station, anna) = station(personality, &[], 0);
            let job = started(&mut station, anna, SIDES);
            let asked = run_until_asked(&mut station);
            assert_eq!(asked.to_string(), "Which side? (left, right)");
            assert_xy(&station, [220.0, 0.0]);
            station.run_for(Duration::from_secs(60));
            assert_xy(&station, [220.0, 0.0]);
            answer(&mut station, job, choice(side)).unwrap();
            assert_eq!(
                run_until_asked(&mut station).to_string(),
                "Again? (no, yes)"
            );
            assert_xy(&station, [200.0, y]);
            answer(&mut station, job, choice("yes")).unwrap();
            assert_eq!(run_until_over(&mut station, job), JobState::Done);
            assert_xy(&station, [240.0, 0.0]);
        }
    }
}

#[test]
fn a_program_starts_after_its_first_question_and_asks_the_next_one_also_after_a_crash() {
    for personality in BOTH {
        let (mut station, anna) = station(personality, &[], 0);
        let job = submitted_from(&mut station, SIDES, 2);
        station.start(anna, job).unwrap();
        let asked = run_until_asked(&mut station).to_string();
        assert_eq!(asked, "Again? (no, yes)");
        assert_xy(&station, [200.0, 80.0]);
        station.crash(Duration::from_secs(1)).unwrap();
        attend(&mut station, job);
        run_until_asked(&mut station);
        answer(&mut station, job, choice("yes")).unwrap();
        assert_eq!(run_until_over(&mut station, job), JobState::Done);
        assert_xy(&station, [240.0, 0.0]);
    }
}

#[test]
fn a_second_press_of_an_answer_does_not_answer_the_next_question() {
    let (mut station, anna) = station(Personality::Firmware11, &[], 0);
    let job = started(&mut station, anna, SIDES);
    run_until_asked(&mut station);
    let number = question(&station).unwrap().number;
    let pressed = Request::AnswerJob {
        job,
        question: Some(number),
        answer: choice("left"),
    };
    station.ask(anna, pressed.clone()).unwrap();
    run_until_asked(&mut station);
    let refused = station.ask(anna, pressed).unwrap_err();
    let asked = question(&station).unwrap().number;
    assert_eq!(
        refused,
        Refusal::AnsweredBefore {
            job,
            question: number,
            asked
        }
    );
    assert_xy(&station, [200.0, 80.0]);
}

#[test]
fn an_answer_that_does_not_fit_is_refused_and_the_program_still_waits() {
    let (mut station, anna) = station(Personality::Firmware11, &[], 0);
    let job = submitted(&mut station, SIDES);
    let early = answer(&mut station, job, choice("left")).unwrap_err();
    assert!(matches!(early, Refusal::NoSuchJob(_)), "{early}");
    station.start(anna, job).unwrap();
    let early = answer(&mut station, job, choice("left")).unwrap_err();
    assert_eq!(early, Refusal::NoQuestion(job));
    run_until_asked(&mut station);
    for wrong in [
        choice("up"),
        place(200.0, 0.0, 0.0),
        Answer::Skip,
        Answer::NextCycle,
    ] {
        let refused = answer(&mut station, job, wrong).unwrap_err();
        assert!(matches!(refused, Refusal::BadAnswer(_)), "{refused}");
        assert!(question(&station).is_some());
    }
    answer(&mut station, job, choice("right")).unwrap();
    run_until_asked(&mut station);
    assert_xy(&station, [200.0, -80.0]);
}

#[test]
fn after_the_timeout_the_answer_is_the_given_one() {
    let (mut station, anna) = station(Personality::Specification, &[], 0);
    let job = started(&mut station, anna, SIDES);
    run_until_asked(&mut station);
    answer(&mut station, job, choice("left")).unwrap();
    run_until_asked(&mut station);
    let asked = station.now();
    assert_eq!(run_until_over(&mut station, job), JobState::Done);
    let waited = station.now().saturating_sub(asked).as_secs_f64();
    assert!((4.9..6.0).contains(&waited), "{waited} s");
    assert_xy(&station, [200.0, 80.0]);
}

#[test]
fn without_an_answer_for_the_timeout_the_job_is_paused_and_asks_again_when_resumed() {
    let text = SIDES.replace("by = \"seen\"", "by = \"seen\"\ntimeout = 2");
    let (mut station, anna) = station(Personality::Firmware11, &[], 0);
    let job = started(&mut station, anna, &text);
    run_until_asked(&mut station);
    station.run_for(Duration::from_secs(4));
    let view = station.supervisor().job().unwrap();
    assert_eq!((view.phase, view.question), (JobPhase::Paused, None));
    assert_eq!(
        view.reason.as_deref(),
        Some("nobody answered within 2 s: Which side? (left, right)")
    );
    station.start(anna, job).unwrap();
    run_until_asked(&mut station);
    answer(&mut station, job, choice("left")).unwrap();
    run_until_asked(&mut station);
    assert_xy(&station, [200.0, 80.0]);
}

const FETCH: &str = r#"
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
go = { from = "bottle", timeout = 30, otherwise = "skip" }
[[steps]]
go = { x = 240, y = 0, z = 40 }
"#;

#[test]
fn a_given_position_is_checked_under_the_policy_before_the_arm_goes_there() {
    for personality in BOTH {
        let (mut station, anna) = station(personality, &[], 0);
        let job = started(&mut station, anna, FETCH);
        assert_eq!(
            run_until_asked(&mut station),
            Question::Place {
                name: "bottle".into()
            }
        );
        let packets = station.packets().len();
        for beyond in [
            place(500.0, 0.0, 0.0),
            place(200.0, 0.0, -120.0),
            place(f64::NAN, 0.0, 0.0),
        ] {
            let refused = answer(&mut station, job, beyond).unwrap_err();
            assert!(matches!(refused, Refusal::BadAnswer(_)), "{refused}");
            station.run_for(Duration::from_secs(1));
        }
        let sent = &station.packets()[packets..];
        assert_eq!(sent, [], "nothing is sent");
        answer(&mut station, job, place(190.0, 70.0, 20.0)).unwrap();
        let latest = station.now() + Duration::from_secs(30);
        let is_there = |station: &VirtualStation| {
            let [x, y] = xy(station);
            (x - 190.0).hypot(y - 70.0) < 0.5
        };
        assert!(station.run_until(latest, is_there));
        assert_eq!(run_until_over(&mut station, job), JobState::Done);
    }
}

#[test]
fn a_step_whose_position_is_not_given_in_time_is_skipped() {
    let (mut station, anna) = station(Personality::Specification, &[], 0);
    let job = started(&mut station, anna, FETCH);
    run_until_asked(&mut station);
    assert_eq!(run_until_over(&mut station, job), JobState::Done);
    assert_xy(&station, [240.0, 0.0]);
}

#[test]
fn a_stop_during_a_question_holds_until_a_person_clears_it() {
    let (mut station, anna) = station(Personality::Firmware11, &[], 0);
    let job = started(&mut station, anna, SIDES);
    run_until_asked(&mut station);
    station.ask(anna, Request::Stop { reason: None }).unwrap();
    station.run_for(Duration::from_secs(1));
    answer(&mut station, job, choice("left")).unwrap_err();
    station.run_for(Duration::from_secs(20));
    assert_xy(&station, [220.0, 0.0]);
    station.ask(anna, Request::ResetStop).unwrap();
    station.start(anna, job).unwrap();
    run_until_asked(&mut station);
    answer(&mut station, job, choice("left")).unwrap();
    run_until_asked(&mut station);
    assert_xy(&station, [200.0, 80.0]);
}

/// Runs the next step; returns the place of the arm after it.
#[track_caller]
fn step(station: &mut VirtualStation, anna: ClientId, job: u64) -> [f64; 2] {
    station.ask(anna, Request::StepJob { job }).unwrap();
    run_until_step_is_done(station, job);
    xy(station).map(f64::round)
}

#[track_caller]
fn run_until_step_is_done(station: &mut VirtualStation, job: u64) {
    run_until_rest(station, job);
    let state = station.job(job).unwrap().state;
    assert!(["paused (the step is done)", "done"].contains(&&*state.to_string()));
}

#[test]
fn an_answer_moves_nothing_in_a_program_that_runs_step_by_step() {
    let (mut station, anna) = station(Personality::Specification, &[], 0);
    let job = submitted(&mut station, SIDES);
    station.ask(anna, Request::StepJob { job }).unwrap();
    run_until_asked(&mut station);
    let before = xy(&station);
    answer(&mut station, job, choice("left")).unwrap();
    run_until_step_is_done(&mut station, job);
    assert_eq!(xy(&station), before);
    station.ask(anna, Request::StepJob { job }).unwrap();
    run_until_asked(&mut station);
    assert_xy(&station, [200.0, 80.0]);
    answer(&mut station, job, choice("yes")).unwrap();
    run_until_step_is_done(&mut station, job);
    assert_xy(&station, [200.0, 80.0]);
    assert_eq!(step(&mut station, anna, job), [240.0, 0.0]);
    assert_eq!(station.job(job).unwrap().state, JobState::Done);
}

/// A step that moves nothing, settings before a step, and a loop.
const STEPS: &str = r"
[[steps]]
go = { x = 215, y = -35, z = 25 }
[[steps]]
speed = { percent = 30 }
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
pause = 0.5
[[steps]]
repeat = 2
[[steps.steps]]
go = { x = 230, y = 10, z = 40 }
[[steps.steps]]
go = { x = 240, y = 20, z = 40 }
";

#[test]
fn each_request_runs_one_step_whichever_step_is_the_first() {
    // The place after each step.
    let after = [
        [215.0, -35.0],
        [215.0, -35.0],
        [220.0, 0.0],
        [220.0, 0.0],
        [230.0, 10.0],
        [240.0, 20.0],
        [230.0, 10.0],
        [240.0, 20.0],
    ];
    for personality in BOTH {
        for first in 1..=6 {
            let (mut station, anna) = station(personality, &[], 0);
            // The arm is at the place of the first step already.
            let beside = submitted(&mut station, "[[steps]]\ngo = { x = 215, y = -35, z = 25 }");
            station.start(anna, beside).unwrap();
            run_until_rest(&mut station, beside);
            let job = submitted_from(&mut station, STEPS, first);
            for expected in &after[first - 1..] {
                let found = step(&mut station, anna, job);
                assert_eq!(found, *expected, "{personality:?}, from step {first}");
            }
            assert_eq!(station.job(job).unwrap().state, JobState::Done);
        }
    }
}

/// Every third cycle goes to the right.
const COUNTED: &str = r#"
[variables]
rounds = 0
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
repeat = "forever"
[[steps.steps]]
choose = "every third one"
every = 3
[[steps.steps.when]]
answer = "right"
[[steps.steps.when.steps]]
go = { x = 200, y = -80, z = 40 }
[[steps.steps.when]]
answer = "left"
[[steps.steps.when.steps]]
go = { x = 200, y = 80, z = 40 }
"#;

#[test]
fn an_endless_program_with_a_counter_continues_without_anybody() {
    for personality in BOTH {
        let (mut station, anna) = station(personality, &[], 0);
        let job = started(&mut station, anna, COUNTED);
        let mut sides = String::new();
        for _ in 0..9 {
            let before = station.supervisor().job_progress().unwrap().0;
            let latest = station.now() + Duration::from_secs(60);
            let is_further =
                |station: &VirtualStation| station.supervisor().job_progress().unwrap().0 > before;
            assert!(station.run_until(latest, is_further));
            let y = xy(&station)[1];
            if y.abs() > 1.0 {
                sides.push(if y > 0.0 { 'l' } else { 'r' });
            }
        }
        assert_eq!(&sides[..8], "llrllrll");
        assert_eq!(question(&station), None);
        station.ask(anna, Request::CancelJob { job }).unwrap();
        assert_eq!(run_until_over(&mut station, job).phase(), JobPhase::Stopped);
    }
}

#[test]
fn a_dry_run_checks_the_steps_of_every_answer() {
    let (station, _) = station(Personality::Firmware11, &[], 0);
    let arm = PlannedFor::of(station.rules().into(), &station.supervisor().state());
    let checked = |text: &str| {
        let program = Program::from_toml(text).unwrap();
        dry_run_program(&program, &arm, &mut NoFiles).unwrap().1
    };
    let fine = checked(SIDES);
    assert!(
        fine.problems.is_empty() && fine.depends_on_answers,
        "{fine:?}"
    );
    assert!(
        fine.first_s.is_some_and(|first_s| first_s > 2.0),
        "{fine:?}"
    );
    let far = checked(&SIDES.replace("x = 240, y = 0", "x = 400, y = 0"));
    assert_eq!(far.problems.len(), 1, "{far:?}");
    assert_eq!(
        far.problems[0].line,
        SIDES
            .lines()
            .position(|line| line.contains("x = 240"))
            .unwrap()
    );
    assert_eq!(far.first_s, None);
}

/// A cube that a camera sees is put where it says, three times.
const SORT: &str = r#"
[variables]
moved = 0
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
while = "moved < 3"
[[steps.steps]]
pick = { from = "cube" }
settle = 0.5
on_missed = { by = "seen", retries = 2 }
[[steps.steps]]
choose = "Where to?"
by = "seen"
[[steps.steps.when]]
answer = "here"
[[steps.steps.when.steps]]
place = { x = 200, y = 80, z = -36 }
[[steps.steps.when]]
answer = "there"
[[steps.steps.when.steps]]
place = { x = 240, y = -80, z = -36 }
[[steps.steps]]
add = { moved = 1 }
"#;

/// The camera: it answers what the program asks.
#[derive(Default)]
struct Camera {
    /// The next answers to "Where to?".
    to_here: bool,
    answers: Vec<String>,
}

impl Camera {
    fn answer(&mut self, station: &mut VirtualStation, job: u64) {
        let Some(pending) = question(station) else {
            return;
        };
        let given = match &pending.question {
            Question::Place { .. } => {
                let [x, y, z] = if cube_is_at(station, HERE) {
                    HERE
                } else {
                    THERE
                };
                place(x.into(), y.into(), z.into())
            }
            Question::Choice { text, .. } if text.starts_with("Was") => choice("yes"),
            _ => {
                let to = if self.to_here { "here" } else { "there" };
                self.to_here = !self.to_here;
                choice(to)
            }
        };
        self.answers.push(given.to_string());
        answer(station, job, given).unwrap();
    }
}

fn sorts(personality: Personality, kills_ms: &[u64], away_ms: u64) {
    let (mut station, anna) = station(personality, &[], 0);
    let job = started(&mut station, anna, SORT);
    let mut camera = Camera::default();
    let mut kills = kills_ms.iter();
    let mut until = kills
        .next()
        .map(|kill_ms| station.now() + Duration::from_millis(*kill_ms));
    while !station.job(job).unwrap().state.is_over() {
        assert!(
            station.now() < Duration::from_secs(3600),
            "{:?}",
            station.supervisor().job()
        );
        station.run_for(Duration::from_millis(100));
        if until.is_some_and(|until| station.now() > until) {
            station.crash(Duration::from_millis(away_ms)).unwrap();
            attend(&mut station, job);
            let next = kills.next();
            until = next.map(|kill_ms| station.now() + Duration::from_millis(*kill_ms));
        }
        camera.answer(&mut station, job);
    }
    assert_eq!(station.job(job).unwrap().state, JobState::Done);
    // Nine answers: nothing was asked twice, and nothing left out.
    assert_eq!(camera.answers.len(), 9, "{:?}", camera.answers);
    assert!(
        cube_is_at(&station, THERE),
        "it was put there, here, and there"
    );
}

#[test]
fn a_cube_is_picked_up_where_the_camera_sees_it_and_put_where_it_says() {
    for personality in BOTH {
        sorts(personality, &[], 0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_answer_and_no_grip_is_lost_or_repeated_whenever_the_station_is_killed(
        kills_ms in prop::collection::vec(0_u64..20_000, 1..5),
        away_ms in 1_u64..5_000,
        is_stock in any::<bool>(),
    ) {
        sorts(BOTH[usize::from(is_stock)], &kills_ms, away_ms);
    }
}
