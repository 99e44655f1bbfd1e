//! The disk of the journal is full in the middle of a job.

use std::io::{self, ErrorKind};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use dobot_api::JobState;
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_journal::{Journal, StorageBackend};

use super::chance::Chance;
use super::jobs::Sort;
use super::scene::{Scene, Wrong, burns, cases};
use super::spread::Spread;

/// The outcome of jobs whose journal could not be written.
#[derive(Debug, Default)]
pub(crate) struct Disks {
    /// The number of jobs.
    pub jobs: usize,
    /// The job was paused for it, with the reason.
    pub paused: usize,
    /// It no longer needed the disk.
    pub done: usize,
    /// Commands that the arm was never given.
    pub lost: usize,
    /// Commands that it was given again.
    pub repeated: usize,
    /// From the pause to the end of the light, in seconds, where it burnt.
    pub dark_s: Spread,
    /// Violations.
    pub wrong: Vec<String>,
}

/// Fills the disk in this many jobs.
pub(crate) fn run(jobs: u64) -> Disks {
    let mut figures = Disks::default();
    for (personality, sort, seed) in cases(jobs) {
        if let Err(wrong) = one(&mut figures, personality, sort, seed) {
            figures
                .wrong
                .push(format!("{personality}, {sort}, seed {seed}: {wrong}"));
        }
    }
    figures
}

fn one(figures: &mut Disks, personality: Personality, sort: Sort, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let disk = Disk::default();
    let storage = disk.clone();
    let journal = Journal::with_backend(move || storage.clone())?;
    let mut scene = Scene::with_journal(personality, &[], seed, journal)?;
    let drawing = sort.job(&mut chance);
    let job = scene.begin(&drawing)?;
    let planned = scene.planned();
    scene.station.run_for(chance.time(planned));
    disk.fill(true);
    wait(figures, &mut scene);
    disk.fill(false);
    // The journal is asked again every second.
    scene.station.run_for(Duration::from_millis(1_100));
    match scene.settle(job)? {
        JobState::Done => figures.done += 1,
        JobState::Paused { reason } if reason.contains("journal") => figures.paused += 1,
        other => return Err(Wrong(format!("the job is {other}"))),
    }
    scene.finish(job)?;
    let given = scene.given(&drawing);
    figures.jobs += 1;
    figures.lost += given.lost;
    figures.repeated += given.repeated;
    scene.check(&drawing)
}

/// Runs until a little after the end of the job, and returns whether the laser is off.
fn wait(figures: &mut Disks, scene: &mut Scene) {
    let latest = scene.station.now() + Duration::from_secs(60);
    let works = |station: &VirtualStation| {
        station
            .supervisor()
            .job()
            .is_some_and(|job| job.reason.is_none())
    };
    scene.station.run_until(latest, |station| !works(station));
    let (paused, burnt) = (scene.station.now(), scene.burns());
    scene
        .station
        .run_until(paused + Duration::from_secs(20), |station| !burns(station));
    if burnt {
        figures.dark_s.add_time(paused, scene.station.now());
    }
    scene.station.run_for(Duration::from_secs(5));
}

/// A disk that can be full.
#[derive(Clone, Debug, Default)]
struct Disk(Arc<Mutex<Platter>>);

#[derive(Debug, Default)]
struct Platter {
    bytes: Vec<u8>,
    full: bool,
}

impl Disk {
    fn fill(&self, full: bool) {
        self.with(|disk| disk.full = full);
    }

    fn with<T>(&self, what: impl FnOnce(&mut Platter) -> T) -> T {
        what(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn change(&self, end: u64, what: impl FnOnce(&mut Vec<u8>, usize)) -> io::Result<()> {
        let end = usize::try_from(end).map_err(io::Error::other)?;
        self.with(|disk| {
            if disk.full {
                return Err(ErrorKind::StorageFull.into());
            }
            what(&mut disk.bytes, end);
            Ok(())
        })
    }
}

impl StorageBackend for Disk {
    fn len(&self) -> io::Result<u64> {
        Ok(self.with(|disk| disk.bytes.len() as u64))
    }

    fn read(&self, offset: u64, out: &mut [u8]) -> io::Result<()> {
        let offset = usize::try_from(offset).map_err(io::Error::other)?;
        self.with(|disk| {
            let found = disk.bytes.get(offset..offset + out.len());
            out.copy_from_slice(found.ok_or(ErrorKind::UnexpectedEof)?);
            Ok(())
        })
    }

    fn set_len(&self, len: u64) -> io::Result<()> {
        self.change(len, |bytes, len| bytes.resize(len, 0))
    }

    fn sync_data(&self) -> io::Result<()> {
        self.change(0, |_, _| ())
    }

    fn write(&self, offset: u64, data: &[u8]) -> io::Result<()> {
        self.change(offset + data.len() as u64, |bytes, end| {
            bytes.resize(bytes.len().max(end), 0);
            bytes[end - data.len()..end].copy_from_slice(data);
        })
    }
}
