//! A program that crashes at any moment, started again and again: no vector is lost, none repeated.

use crate::lab::Disk;
use crate::lab::program::{self, LIFT_MM, lifted};
use dobot_api::{JobKind, JobState};
use dobot_arm::{Position, Tool};
use dobot_journal::{
    JobId, Journal, PlannedJob, SPACING_MM, Window, locate, model_at, prelude, window_end,
};
use dobot_motion::{ArmPlace, Model};
use dobot_wire::{Command, Dialect};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn a_job_that_is_interrupted_anywhere_is_done_exactly_once(
        (dialect, commands) in program::dialect()
            .prop_flat_map(|dialect| (Just(dialect), program::commands(dialect, 40))),
        lives in proptest::collection::vec(life(), 0..12),
    ) {
        let disk = Disk::default();
        let mut arm = Arm::new(program::model(dialect).place.pose.position);
        let wanted = arm.path_of(&commands);
        let id = submit(&open(&disk), dialect, &commands);
        let mut disk = disk;
        for life in &lives {
            let journal = open(&disk);
            live(&journal, id, &mut arm, life);
            disk = disk.after_power_cut(|| false, 1.0);
        }
        live(&open(&disk), id, &mut arm, &Life::UNDISTURBED);

        prop_assert_eq!(open(&disk).job(id).unwrap().state, JobState::Done);
        let (found, wanted) = (without_lifts(&arm.path), without_lifts(&wanted));
        let is_as_wanted = found.iter().zip(&wanted).all(|(a, b)| is_near(*a, *b));
        prop_assert!(
            found.len() == wanted.len() && is_as_wanted,
            "found {found:?}\nexpected {wanted:?}\nto {} mm", SPACING_MM / 4.0
        );
    }
}

/// One run of the program, up to its crash.
#[derive(Clone, Debug)]
struct Life {
    /// The number of commands that the arm does between two checks by the program.
    done_between: Vec<usize>,
    /// The number of given commands that the arm still does after the crash.
    done_after: usize,
    /// Whether the program has the pen lifted as its last act.
    lifts: bool,
    /// The maximum number of commands of a window.
    most: usize,
}

impl Life {
    const UNDISTURBED: Self = Self {
        done_between: Vec::new(),
        done_after: usize::MAX,
        lifts: false,
        most: 8,
    };
}

fn life() -> impl Strategy<Value = Life> {
    (
        proptest::collection::vec(0_usize..5, 0..6),
        0_usize..9,
        any::<bool>(),
        1_usize..17,
    )
        .prop_map(|(done_between, done_after, lifts, most)| Life {
            done_between,
            done_after,
            lifts,
            most,
        })
}

/// Finds the progress of the job and resumes it until the crash.
fn live(journal: &Journal, id: JobId, arm: &mut Arm, life: &Life) {
    let (job, commands) = (journal.job(id).unwrap(), journal.commands(id).unwrap());
    if job.state == JobState::Done {
        return;
    }
    let dialect = job.dialect;
    let mut window = resume(journal, id, arm);
    arm.done = window.completed;
    let mut rounds = life.done_between.iter();
    loop {
        window = next_window(dialect, &commands, arm, &window, life.most);
        journal.extend_window(id, &window).unwrap();
        if window.completed == commands.len() {
            return journal.set_state(id, &JobState::Done).unwrap();
        }
        match rounds.next() {
            Some(&count) => arm.work(&commands[..window.upto], count),
            None if life.done_after == usize::MAX => {
                arm.work(&commands[..window.upto], usize::MAX);
            }
            None => break,
        }
    }
    arm.work(&commands[..window.upto], life.done_after);
    if life.lifts {
        arm.lift(LIFT_MM);
    }
}

/// The commands that may be given next: those of before stay given.
fn next_window(
    dialect: Dialect,
    commands: &[Command],
    arm: &Arm,
    before: &Window,
    most: usize,
) -> Window {
    let model = arm.model(dialect, &commands[..arm.done]);
    let upto = window_end(commands, arm.done, &model, Some(LIFT_MM), most);
    Window::at(arm.done, upto.max(before.upto), &model)
}

/// Returns the completed commands, by where the arm rests; a person is asked if that is unclear.
fn resume(journal: &Journal, id: JobId, arm: &mut Arm) -> Window {
    let (job, commands) = (journal.job(id).unwrap(), journal.commands(id).unwrap());
    let window = job.window;
    let Some(model) = model_at(job.dialect, &commands[..window.completed], &window) else {
        return window;
    };
    let (next, is_lifted) = match locate(&commands, &window, &model, job.lift_mm, arm.at) {
        Ok(located) => (located.next, located.lifted),
        Err(error) => {
            assert_eq!(window.upto, window.completed + 1, "{error}");
            (arm.done, arm.at != arm.end)
        }
    };
    if is_lifted {
        arm.lift(-LIFT_MM);
    }
    Window {
        completed: next,
        upto: next,
        start: None,
    }
}

/// An arm that executes its commands, and the places of its pen.
struct Arm {
    at: Position,
    /// The end of the last command.
    end: Position,
    done: usize,
    path: Vec<Position>,
}

impl Arm {
    fn new(at: Position) -> Self {
        Self {
            at,
            end: at,
            done: 0,
            path: vec![at],
        }
    }

    fn work(&mut self, given: &[Command], count: usize) {
        let last = self.done.saturating_add(count).min(given.len());
        for command in &given[self.done..last] {
            self.at = program::end(self.at, command);
            self.path.push(self.at);
        }
        self.end = self.at;
        self.done = last;
    }

    fn lift(&mut self, lift_mm: f32) {
        self.at = self.at + Position::new(0.0, 0.0, lift_mm.into());
        self.path.push(self.at);
    }

    fn path_of(&self, commands: &[Command]) -> Vec<Position> {
        let mut twin = Self::new(self.at);
        twin.work(commands, usize::MAX);
        twin.path
    }

    /// Returns the program's model: the last report and the settings sent before.
    fn model(&self, dialect: Dialect, commands: &[Command]) -> Model {
        let mut pose = program::model(dialect).place.pose;
        pose.position = self.at;
        let place = ArmPlace::at_pose(pose, Tool::SuctionCup).unwrap();
        let model = Model::standing(dialect, place);
        let commands = prelude(commands);
        commands
            .iter()
            .fold(model, |model, command| model.begun(command))
    }
}

/// The corners of a path, without the lifts of a pen from and back to one place.
fn without_lifts(path: &[Position]) -> Vec<Position> {
    let mut corners: Vec<Position> = Vec::new();
    for &at in path {
        match corners[..] {
            [.., last] if is_near(last, at) => {}
            [.., first, up] if is_near(first, at) && is_near(lifted(first), up) => {
                corners.pop();
            }
            _ => corners.push(at),
        }
    }
    corners
}

fn is_near(a: Position, b: Position) -> bool {
    a.distance(b).0 < SPACING_MM / 4.0
}

fn submit(journal: &Journal, dialect: Dialect, commands: &[Command]) -> JobId {
    let id = journal
        .submit(&PlannedJob {
            title: "a picture".into(),
            kind: JobKind::Drawing,
            calibration: dobot_arm::Calibration::NONE,
            dialect,
            lift_mm: Some(LIFT_MM),
            created_ms: 0,
            planned_s: None,
            commands: commands.to_vec(),
            pauses: Vec::new(),
            program: dobot_api::JobProgram::default(),
            key: None,
        })
        .unwrap();
    journal.set_state(id, &JobState::Running).unwrap();
    id
}

fn open(disk: &Disk) -> Journal {
    let disk = disk.clone();
    Journal::with_backend(move || disk.clone()).unwrap()
}
