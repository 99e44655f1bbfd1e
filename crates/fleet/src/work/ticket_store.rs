//! Tickets on the disk: a file for each, and one beside it with the offered job.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use dobot_api::{WorkPhase, make_private, write_private};
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::ticket::Ticket;

/// A folder of tickets. Written tickets survive a power cut.
#[derive(Debug)]
pub(crate) struct TicketStore {
    folder: PathBuf,
}

impl TicketStore {
    /// Opens or creates the folder; returns its tickets, and the problems of invalid files, which
    /// are left unchanged.
    pub(crate) fn open(folder: &Path) -> io::Result<(Self, Vec<Ticket>, Vec<String>)> {
        make_private(folder)?;
        let kept = Self {
            folder: folder.to_owned(),
        };
        let (mut tickets, mut wrong) = (Vec::new(), Vec::new());
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if let Some(id) = name.strip_suffix(TICKET).filter(|id| is_id(id)) {
                match read::<Ticket>(&path) {
                    Ok(ticket) if ticket.id == id => tickets.push(ticket),
                    Ok(_) => wrong.push(format!("{} contains another ticket", path.display())),
                    Err(error) => wrong.push(format!("{}: {error}", path.display())),
                }
            } else if name.contains(".new-") {
                // Left by a kill: the write was not complete.
                fs::remove_file(&path)?;
            }
        }
        Ok((kept, tickets, wrong))
    }

    /// Writes a new ticket and its job.
    pub(crate) fn submit(&self, ticket: &Ticket, offer: &Value) -> io::Result<()> {
        write_private(&self.offer_file(&ticket.id), offer.to_string())?;
        self.keep(ticket)
    }

    /// Writes the current state of a ticket.
    pub(crate) fn keep(&self, ticket: &Ticket) -> io::Result<()> {
        let text = serde_json::to_string(ticket)?;
        write_private(&self.ticket_file(&ticket.id), &text)?;
        self.sync()?;
        // A failed ticket may be moved to another arm.
        if matches!(ticket.phase(), WorkPhase::Done | WorkPhase::Cancelled) {
            remove(&self.offer_file(&ticket.id))?;
        }
        Ok(())
    }

    /// Removes a ticket.
    pub(crate) fn forget(&self, id: &str) -> io::Result<()> {
        remove(&self.ticket_file(id))?;
        remove(&self.offer_file(id))
    }

    /// Returns the offered job.
    pub(crate) fn offer(&self, id: &str) -> io::Result<Value> {
        read(&self.offer_file(id))
    }

    fn ticket_file(&self, id: &str) -> PathBuf {
        self.folder.join(format!("{id}{TICKET}"))
    }

    fn offer_file(&self, id: &str) -> PathBuf {
        self.folder.join(format!("{id}{OFFER}"))
    }

    /// Makes the names in the folder durable.
    fn sync(&self) -> io::Result<()> {
        if cfg!(unix) {
            File::open(&self.folder)?.sync_all()?;
        }
        Ok(())
    }
}

/// Removes a file if it exists.
fn remove(file: &Path) -> io::Result<()> {
    match fs::remove_file(file) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        other => other,
    }
}

fn read<T: DeserializeOwned>(file: &Path) -> io::Result<T> {
    Ok(serde_json::from_slice(&fs::read(file)?)?)
}

fn is_id(text: &str) -> bool {
    text.len() == 32 && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

const TICKET: &str = ".json";
const OFFER: &str = ".offer.json";
