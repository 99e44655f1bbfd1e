//! The cost of a durable window: `cargo bench -p dobot-journal`.

use divan::Bencher;
use dobot_api::{JobKind, JobState};
use dobot_journal::{JobId, Journal, PlannedJob, Window};
use dobot_wire::{Command, Configuration, Dialect, Status};

fn main() {
    divan::main();
}

/// One window given, on the disk when it returns.
#[divan::bench(args = [100, 50_000])]
fn give_one_window(bencher: Bencher<'_, '_>, commands: usize) {
    let folder = tempfile::tempdir().expect("a folder for the file");
    let journal = Journal::open(&folder.path().join("journal.redb")).expect("a new journal");
    let id = running_job(&journal, commands);
    let window = Window {
        completed: 0,
        upto: 32,
        start: Some(START),
    };
    bencher.bench_local(|| journal.extend_window(id, divan::black_box(&window)));
}

/// A large drawing taken.
#[divan::bench]
fn submit_50_000_commands(bencher: Bencher<'_, '_>) {
    let folder = tempfile::tempdir().expect("a folder for the file");
    let journal = Journal::open(&folder.path().join("journal.redb")).expect("a new journal");
    let job = job(50_000);
    bencher.bench_local(|| journal.submit(divan::black_box(&job)));
}

fn running_job(journal: &Journal, commands: usize) -> JobId {
    let id = journal.submit(&job(commands)).expect("a job");
    let running = journal.set_state(id, &JobState::Running);
    running.expect("a job that runs");
    id
}

fn job(commands: usize) -> PlannedJob {
    let command = Command::from(Configuration::Writing {
        acceleration_mm_s2: 100.0,
    });
    PlannedJob {
        title: "bench".into(),
        kind: JobKind::Drawing,
        calibration: dobot_arm::Calibration::NONE,
        dialect: Dialect::FIRMWARE_1_1,
        lift_mm: Some(5.0),
        created_ms: 0,
        planned_s: None,
        commands: vec![command; commands],
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
        key: None,
    }
}

const START: Status = Status {
    x_mm: 200.0,
    z_mm: 50.0,
    rear_deg: 10.0,
    fore_deg: 30.0,
    ..Status::AT_ZERO
};
