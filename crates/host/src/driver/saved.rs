//! The files that the driver restores at the start and keeps: stops, time slots, dialect.

use std::io;

use dobot_api::{News, Notice};

use super::{Driver, now_ms};
use crate::jobs::recovery_model;
use crate::known_arms::NewText;
use crate::saved_stop::{Content, SavedStop};

impl Driver {
    /// Restores a job that was running when the previous station was killed.
    ///
    /// # Errors
    ///
    /// The reason of a failure, in one line.
    pub(crate) fn recover(&mut self) -> Result<(), String> {
        if let Some(text) = self.jobs.missing() {
            let now = self.now();
            self.supervisor.handle_jobs_missing(now, text);
        }
        let interrupted = self.jobs.interrupted().map_err(|error| error.to_string())?;
        let Some(job) = interrupted else {
            return Ok(());
        };
        match self.jobs.started_job(&job, recovery_model(&job)) {
            Ok(started) => {
                let now = self.now();
                self.supervisor.handle_recovered(now, started, job.window);
                Ok(())
            }
            Err(refusal) => {
                self.jobs.give_up(&job, &refusal.to_string());
                Err(format!("cannot resume job {}: {refusal}", job.id))
            }
        }
    }

    /// Restores the time slots of the previous station.
    ///
    /// # Errors
    ///
    /// The reason of a failure, in one line; then there are none.
    pub(crate) fn recover_slots(&mut self) -> Result<(), String> {
        let slots = self.slots.read(now_ms());
        let now = self.now();
        let taken = slots.and_then(|slots| {
            let taken = self.supervisor.handle_saved_slots(now, &slots);
            taken.map_err(|refusal| refusal.to_string())
        });
        taken.map_err(|why| format!("the saved time slots were lost: {why}"))
    }

    /// Restores the stops that held when the previous station ended.
    pub(crate) fn recover_stop(&mut self) {
        if let Some(Content { stop, fleet }) = self.stop.as_ref().map(SavedStop::read) {
            let now = self.now();
            self.supervisor.handle_saved_stops(now, stop, fleet);
        }
    }

    /// Saves the stops for the next station.
    pub(super) fn save_stops(&mut self) {
        let kept = self.supervisor.poll_saved_stops();
        if let (Some(file), Some((stop, fleet))) = (&self.stop, kept) {
            let new = file.keep(&Content { stop, fleet });
            self.write_file(new.map(Some), "the stop cannot be kept");
        }
    }

    /// Saves the time slots for the next station.
    pub(super) fn save_slots(&mut self) {
        let slots = self.slots.keep(&self.supervisor.slots(), now_ms());
        self.write_file(slots.map(Some), "the time slots cannot be saved");
    }

    /// Writes a file if there is new content. `problem` states what is lost if that fails.
    pub(super) fn write_file(&mut self, new: io::Result<Option<NewText>>, problem: &'static str) {
        let written = match new {
            Ok(None) => Ok(()),
            Ok(Some(new)) => self.disk.write(new, problem),
            Err(error) => Err(format!("{problem}: {error}")),
        };
        if let Err(trouble) = written {
            let now = self.now();
            self.supervisor.handle_trouble(now, trouble);
        }
    }

    /// Saves the arm's dialect once it is known.
    pub(super) fn remember(&mut self, notice: &Notice) {
        let (News::DialectKnown { dialect }, Some(address)) = (&notice.news, &self.address) else {
            return;
        };
        if self.source.is_virtual() {
            return;
        }
        let finding = self.supervisor.finding();
        let new = self.arms.keep(address, *dialect, finding);
        self.write_file(new, "the dialect of the arm cannot be saved");
    }
}
