//! Shared by the tests: jobs, and a disk that can lose power and be full.

pub(crate) mod program;

use std::io::{self, ErrorKind};
use std::sync::{Arc, Mutex};

use dobot_api::JobKind;
use dobot_journal::{PlannedJob, StorageBackend};
use dobot_wire::{Command, Configuration, Dialect, Status, WriteVector};

/// A job of this many different commands.
pub(crate) fn job(title: &str, commands: u16) -> PlannedJob {
    PlannedJob {
        title: title.to_owned(),
        kind: JobKind::Drawing,
        calibration: dobot_arm::Calibration::NONE,
        dialect: Dialect::FIRMWARE_1_1,
        lift_mm: Some(5.0),
        created_ms: 1_700_000_000_123,
        planned_s: None,
        commands: (0..commands).map(command).collect(),
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
        key: None,
    }
}

fn command(index: u16) -> Command {
    if index == 0 {
        return Configuration::Writing {
            acceleration_mm_s2: 100.0,
        }
        .into();
    }
    vector(f32::from(index), 0.5, 0.0)
}

/// A pen's way.
pub(crate) fn vector(x_mm: f32, y_mm: f32, z_mm: f32) -> Command {
    WriteVector::by(x_mm, y_mm, z_mm, 40.0).into()
}

/// An arm at rest at some place.
pub(crate) const START: Status = Status {
    x_mm: 200.0,
    y_mm: 0.1,
    z_mm: 50.0,
    rear_deg: 10.0,
    fore_deg: 30.0,
    ..Status::AT_ZERO
};

/// A disk with a cache: written data can be read, synced data survives a power cut.
#[derive(Clone, Debug, Default)]
pub(crate) struct Disk(Arc<Mutex<Platters>>);

#[derive(Debug, Default)]
struct Platters {
    /// The content seen by reads.
    seen: Vec<u8>,
    /// The content left by a power cut, without the changes since the last sync.
    synced: Vec<u8>,
    /// The changes since the last sync.
    unsynced: Vec<Change>,
    /// The number of changes until the power cut.
    changes_left: Option<u64>,
    /// The maximum size of the storage.
    capacity: Option<u64>,
}

#[derive(Clone, Debug)]
enum Change {
    Len(usize),
    Write { offset: usize, data: Vec<u8> },
}

impl Disk {
    /// Cuts the power after this many more changes (writes, changes of the length, syncs).
    pub(crate) fn cut_after(&self, changes: u64) {
        self.lock().changes_left = Some(changes);
    }

    /// Limits the storage to this many bytes; `None` for no limit.
    pub(crate) fn hold(&self, capacity: Option<u64>) {
        self.lock().capacity = capacity;
    }

    /// Returns the size of the storage, in bytes.
    pub(crate) fn length(&self) -> u64 {
        self.lock().seen.len() as u64
    }

    /// All that it holds.
    pub(crate) fn content(&self) -> Vec<u8> {
        self.lock().seen.clone()
    }

    /// Changes a byte without the journal.
    pub(crate) fn flip(&self, offset: usize) {
        self.lock().seen[offset] ^= 0x10;
    }

    /// Returns the content after a power cut: everything synced, and of the later changes those for
    /// which `survives` is true, in order; the last of these is torn.
    pub(crate) fn after_power_cut(&self, mut survives: impl FnMut() -> bool, torn_at: f64) -> Self {
        let platters = self.lock();
        let mut left = platters.synced.clone();
        let kept: Vec<Change> = platters
            .unsynced
            .iter()
            .filter(|_| survives())
            .cloned()
            .collect();
        let last = kept.len().saturating_sub(1);
        for (index, change) in kept.iter().enumerate() {
            change.apply(&mut left, if index == last { torn_at } else { 1.0 });
        }
        Self(Arc::new(Mutex::new(Platters {
            seen: left.clone(),
            synced: left,
            ..Platters::default()
        })))
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Platters> {
        self.0.lock().expect("no test panics with the lock held")
    }
}

impl Platters {
    fn change(&mut self, change: Change) -> io::Result<()> {
        self.power()?;
        if self
            .capacity
            .is_some_and(|capacity| change.end() > capacity)
        {
            return Err(ErrorKind::StorageFull.into());
        }
        change.apply(&mut self.seen, 1.0);
        self.unsynced.push(change);
        Ok(())
    }

    fn power(&mut self) -> io::Result<()> {
        match &mut self.changes_left {
            Some(0) => Err(io::Error::other("the power is off")),
            Some(left) => {
                *left -= 1;
                Ok(())
            }
            None => Ok(()),
        }
    }
}

impl Change {
    /// How long the storage must be for it.
    fn end(&self) -> u64 {
        match self {
            Self::Len(len) => *len as u64,
            Self::Write { offset, data } => (offset + data.len()) as u64,
        }
    }

    /// Does a share of it, from the front.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        clippy::cast_sign_loss,
        reason = "a share of a length is a length"
    )]
    fn apply(&self, bytes: &mut Vec<u8>, share: f64) {
        match self {
            Self::Len(len) => bytes.resize(*len, 0),
            Self::Write { offset, data } => {
                let done = (data.len() as f64 * share) as usize;
                let end = offset + done;
                if bytes.len() < end {
                    bytes.resize(end, 0);
                }
                bytes[*offset..end].copy_from_slice(&data[..done]);
            }
        }
    }
}

impl StorageBackend for Disk {
    fn len(&self) -> io::Result<u64> {
        Ok(self.length())
    }

    fn read(&self, offset: u64, out: &mut [u8]) -> io::Result<()> {
        let offset = usize::try_from(offset).expect("a small disk");
        let platters = self.lock();
        let found = platters.seen.get(offset..offset + out.len());
        out.copy_from_slice(found.ok_or(ErrorKind::UnexpectedEof)?);
        Ok(())
    }

    fn set_len(&self, len: u64) -> io::Result<()> {
        let len = usize::try_from(len).expect("a small disk");
        self.lock().change(Change::Len(len))
    }

    fn sync_data(&self) -> io::Result<()> {
        let mut platters = self.lock();
        platters.power()?;
        let changes = std::mem::take(&mut platters.unsynced);
        for change in changes {
            change.apply(&mut platters.synced, 1.0);
        }
        Ok(())
    }

    fn write(&self, offset: u64, data: &[u8]) -> io::Result<()> {
        let offset = usize::try_from(offset).expect("a small disk");
        let data = data.to_vec();
        self.lock().change(Change::Write { offset, data })
    }
}
