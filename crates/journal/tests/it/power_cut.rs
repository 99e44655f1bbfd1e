//! After a power cut everything acknowledged is there, and nothing partial.

use crate::lab::{Disk, START, job};
use dobot_api::JobState;
use dobot_journal::{
    Adjustment, Job, JobHistory, JobId, Journal, JournalError, PlannedJob, Window,
};
use dobot_wire::Command;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_power_cut_loses_nothing_acknowledged_and_leaves_nothing_incomplete(
        acts in proptest::collection::vec(act(), 1..20),
        cut_after in 0_u64..120,
        seed in 1_u64..,
        torn_at in 0.0..=1.0,
    ) {
        let disk = Disk::default();
        let journal = open(&disk).unwrap();
        disk.cut_after(cut_after);
        let mut acknowledged = Content::default();
        let mut under_way = acknowledged.clone();
        for act in &acts {
            under_way.act(act);
            if act.ask(&journal, &acknowledged).is_err() {
                break;
            }
            acknowledged = under_way.clone();
        }
        let left = disk.after_power_cut(coin(seed), torn_at);
        drop(journal);

        let journal = open(&left).unwrap();
        let found = Content::read(&journal);
        prop_assert!(
            found == acknowledged || found == under_way,
            "found {found:#?}\nacknowledged {acknowledged:#?}\nunder way {under_way:#?}"
        );
        prop_assert!(!journal.was_clean());
        // It is a journal as before: new promises are kept as well.
        let id = journal.submit(&job("after the cut", 3)).unwrap();
        prop_assert!(found.jobs.iter().all(|(job, _)| job.id != id));
        let left = left.after_power_cut(|| false, 1.0);
        prop_assert_eq!(open(&left).unwrap().commands(id).unwrap().len(), 3);
    }
}

#[test]
fn a_power_cut_after_a_clean_shutdown_is_clean() {
    let disk = Disk::default();
    let journal = open(&disk).unwrap();
    journal.note_clean_shutdown().unwrap();
    let left = disk.after_power_cut(|| false, 1.0);
    assert!(open(&left).unwrap().was_clean());
}

#[test]
fn a_flipped_bit_on_the_disk_is_reported_or_harmless() {
    let disk = Disk::default();
    let journal = open(&disk).unwrap();
    for commands in [3, 400, 30] {
        journal.submit(&new_job(commands)).unwrap();
    }
    let written = Content::read(&journal);
    let mut reported = 0;
    // JobHistory a crash it would look like a commit that the power cut off.
    drop(journal);
    for offset in (0..512).chain((512..disk.length()).step_by(97)) {
        let left = disk.after_power_cut(|| false, 1.0);
        left.flip(usize::try_from(offset).unwrap());
        let found = left.content();
        match open(&left) {
            Ok(journal) => assert_eq!(Content::read(&journal), written, "byte {offset}"),
            Err(JournalError::Damaged { .. } | JournalError::Foreign { .. }) => {
                assert!(left.content() == found, "byte {offset}");
                reported += 1;
            }
            Err(error) => panic!("byte {offset}: {error}"),
        }
    }
    assert!(reported > 0);
}

fn open(disk: &Disk) -> Result<Journal, JournalError> {
    let disk = disk.clone();
    Journal::with_backend(move || disk.clone())
}

/// Heads or tails, the same for the same seed.
fn coin(mut seed: u64) -> impl FnMut() -> bool {
    move || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        seed & 1 == 1
    }
}

/// Something to ask of a journal; jobs are counted from the oldest one left.
#[derive(Clone, Debug)]
enum Act {
    Submit { commands: u16 },
    Give { nth: usize, more: usize },
    SetState { nth: usize, state: JobState },
    Remove { nth: usize },
    KeepLast { most: usize },
}

fn act() -> impl Strategy<Value = Act> {
    let nth = 0_usize..4;
    prop_oneof![
        3 => prop_oneof![1_u16..40, 400_u16..1200].prop_map(|commands| Act::Submit { commands }),
        5 => (nth.clone(), 0_usize..9).prop_map(|(nth, more)| Act::Give { nth, more }),
        3 => (nth.clone(), state()).prop_map(|(nth, state)| Act::SetState { nth, state }),
        1 => nth.prop_map(|nth| Act::Remove { nth }),
        1 => (0_usize..3).prop_map(|most| Act::KeepLast { most }),
    ]
}

fn state() -> impl Strategy<Value = JobState> {
    let reason = "because".to_owned();
    prop_oneof![
        4 => Just(JobState::Running),
        1 => Just(JobState::Done),
        1 => Just(JobState::Paused { reason: reason.clone() }),
        1 => Just(JobState::Failed { reason }),
    ]
}

impl Act {
    /// `Err` only where the storage failed.
    fn ask(&self, journal: &Journal, content: &Content) -> Result<(), JournalError> {
        let id = |nth: usize| content.jobs.get(nth).map(|(job, _)| job.id);
        match self {
            Self::Submit { commands } => journal.submit(&new_job(*commands)).map(|_| ()),
            Self::Give { nth, more } => match content.next_window(*nth, *more) {
                Some((id, window)) => journal.extend_window(id, &window),
                None => Ok(()),
            },
            Self::SetState { nth, state } => match id(*nth) {
                Some(id) => journal.set_state(id, state),
                None => Ok(()),
            },
            Self::Remove { nth } => match id(*nth).map(|id| journal.remove(id)) {
                None | Some(Err(JournalError::Unfinished { .. })) => Ok(()),
                Some(removed) => removed,
            },
            Self::KeepLast { most } => journal.keep_last(*most).map(|_| ()),
        }
    }
}

/// The promised content of a journal.
#[derive(Clone, Debug, Default)]
struct Content {
    jobs: Vec<(Job, Vec<Command>)>,
    submitted: u64,
}

impl PartialEq for Content {
    fn eq(&self, other: &Self) -> bool {
        self.jobs == other.jobs
    }
}

impl Content {
    fn read(journal: &Journal) -> Self {
        let with_commands = |job: Job| {
            let commands = journal.commands(job.id).unwrap();
            (job, commands)
        };
        Self {
            jobs: journal
                .jobs()
                .unwrap()
                .into_iter()
                .map(with_commands)
                .collect(),
            submitted: 0,
        }
    }

    fn act(&mut self, act: &Act) {
        match act {
            Act::Submit { commands } => self.submit(new_job(*commands)),
            Act::Give { nth, more } => {
                if let Some((_, window)) = self.next_window(*nth, *more) {
                    self.jobs[*nth].0.window = window;
                }
            }
            Act::SetState { nth, state } => {
                if let Some((job, _)) = self.jobs.get_mut(*nth) {
                    job.state = state.clone();
                }
            }
            Act::Remove { nth } => {
                if self
                    .jobs
                    .get(*nth)
                    .is_some_and(|(job, _)| !job.state.is_active())
                {
                    self.jobs.remove(*nth);
                }
            }
            Act::KeepLast { most } => {
                let over = self.jobs.iter().filter(|(job, _)| job.state.is_over());
                let mut old = over.count().saturating_sub(*most);
                self.jobs.retain(|(job, _)| {
                    let goes = job.state.is_over() && old > 0;
                    old -= usize::from(goes);
                    !goes
                });
            }
        }
    }

    fn submit(&mut self, new: PlannedJob) {
        self.submitted += 1;
        let job = Job {
            calibration: dobot_arm::Calibration::NONE,
            id: JobId(self.submitted),
            title: new.title,
            kind: new.kind,
            dialect: new.dialect,
            lift_mm: new.lift_mm,
            created_ms: new.created_ms,
            planned_s: new.planned_s,
            commands: new.commands.len(),
            pauses: new.pauses,
            program: new.program,
            key: new.key,
            adjustment: Adjustment::default(),
            state: JobState::Queued,
            history: JobHistory::default(),
            window: Window::default(),
        };
        self.jobs.push((job, new.commands));
    }

    /// Returns the window after the one of a running job.
    fn next_window(&self, nth: usize, more: usize) -> Option<(JobId, Window)> {
        let (job, commands) = self.jobs.get(nth)?;
        let completed = job.window.upto;
        let window = Window {
            completed,
            upto: (completed + more).min(commands.len()),
            start: (more.is_multiple_of(2)).then_some(START),
        };
        (job.state == JobState::Running).then_some((job.id, window))
    }
}

fn new_job(commands: u16) -> PlannedJob {
    job(&format!("{commands} commands"), commands)
}
