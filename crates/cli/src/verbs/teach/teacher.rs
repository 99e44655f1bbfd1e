//! Teaching as an engine: the pendant, the program, and the job that runs it.

mod prompting;
mod running;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use crossterm::event::{Event, KeyEvent, KeyEventKind};
use dobot_api::{Reply, Request, State};
use dobot_host::Rules;
use dobot_teach::{ProgramError, RecordedPlace, simplified};
use dobot_wire::MovingMode;
use ratatui::Frame;

use self::running::{JobStart, TaughtJob};
use super::keys::{TeachKey, teach_key};
use super::lesson::{Lesson, Part};
use super::prompt::Prompt;
use super::screen;
use crate::output;
use crate::pendant::{Panel, Pendant};

/// Teaches a program with keys.
#[derive(Debug)]
pub(crate) struct Teacher {
    pub(super) pendant: Pendant,
    pub(super) lesson: Lesson,
    pub(super) path: MovingMode,
    pub(super) file: PathBuf,
    /// The open question.
    pub(super) prompt: Option<Prompt>,
    /// The time until which Enter may still be held since the last answer.
    held_until: Option<Duration>,
    settings: Settings,
    recording: Option<Vec<RecordedPlace>>,
    captured: Option<RecordedPlace>,
    job: Option<TaughtJob>,
    /// How the submitted job is started, once the station has replied with its number.
    submitting: Option<JobStart>,
    /// The request that starts the job as soon as the arm is at rest.
    starting: Option<Request>,
    /// The number of refused starts because the arm was still moving.
    tries: u8,
    is_saving: bool,
    quits_unsaved: bool,
}

/// The settings of the command line.
#[derive(Debug)]
pub(crate) struct Settings {
    /// The maximum deviation of the steps of a jogged path, in mm.
    pub(crate) tolerance_mm: f64,
    /// The rules for the program.
    pub(crate) rules: Arc<Rules>,
    /// The time to arm the laser for a program that burns.
    pub(crate) arm_laser: Option<Duration>,
}

impl Teacher {
    /// Teaches a program in a file, which may not exist yet.
    pub(crate) const fn new(
        pendant: Pendant,
        lesson: Lesson,
        file: PathBuf,
        settings: Settings,
    ) -> Self {
        Self {
            pendant,
            lesson,
            path: MovingMode::Jump,
            file,
            prompt: None,
            held_until: None,
            settings,
            recording: None,
            captured: None,
            job: None,
            submitting: None,
            starting: None,
            tries: 0,
            is_saving: false,
            quits_unsaved: false,
        }
    }

    /// The number of recorded positions of a jogged path; `None` if nothing is recorded.
    pub(super) fn recorded(&self) -> Option<usize> {
        self.recording.as_ref().map(Vec::len)
    }

    fn handle_key(&mut self, key: TeachKey) {
        self.pendant.release();
        let captured = self.captured.take();
        let quits_unsaved = std::mem::take(&mut self.quits_unsaved);
        match key {
            TeachKey::Capture => self.capture(captured),
            TeachKey::NextPath => self.path = next_path(self.path),
            TeachKey::Cursor { down } => self.lesson.move_cursor(down),
            TeachKey::Shift { down } => {
                let done = self.lesson.shift(down);
                self.show_error(done);
            }
            TeachKey::Remove => {
                let done = self.lesson.remove();
                self.show_error(done);
            }
            TeachKey::Undo => self.undo(),
            TeachKey::Redo => self.redo(),
            TeachKey::Pause => {
                let done = self.lesson.pause();
                self.show_error(done);
            }
            TeachKey::Add => self.open_prompt(),
            TeachKey::EndBlock => self.end_block(),
            TeachKey::Steps => self.pendant.change_step(),
            TeachKey::Record => self.record(),
            TeachKey::Suction(on) => self.switch_suction(on),
            TeachKey::Run => self.run(Part::All, JobStart::Run),
            TeachKey::Loop => self.run(Part::Loop, JobStart::Run),
            TeachKey::RunFromHere => self.run(Part::FromHere, JobStart::Run),
            TeachKey::Step => self.run(Part::All, JobStart::Step),
            TeachKey::PauseJob => self.pendant.send(Request::PauseJob),
            TeachKey::CancelJob => self.cancel(),
            TeachKey::Save => self.is_saving = true,
            TeachKey::Quit => self.quit(quits_unsaved),
        }
    }

    /// The position of an arm at rest with a confirmed pose.
    fn place(&self) -> Result<RecordedPlace, &'static str> {
        let untrusted = "the pose is not confirmed, so that a point taught now would be wrong";
        let status = self.pendant.status_at_rest(untrusted)?;
        Ok(RecordedPlace::of(status))
    }

    /// Adds the current position once, even if Enter repeats.
    fn capture(&mut self, before: Option<RecordedPlace>) {
        let place = match self.place() {
            Ok(place) => place,
            Err(why) => return self.pendant.show(format!("not taught: {why}")),
        };
        if before != Some(place) {
            match self.lesson.capture(&place, self.path) {
                Ok(name) => self.pendant.show(format!("added {name}")),
                Err(error) => self.pendant.show(error.to_string()),
            }
        }
        self.captured = Some(place);
    }

    fn undo(&mut self) {
        if !self.lesson.undo() {
            self.pendant.show("nothing to undo".into());
        }
    }

    fn redo(&mut self) {
        if !self.lesson.redo() {
            self.pendant.show("nothing to redo".into());
        }
    }

    fn record(&mut self) {
        let Some(places) = self.recording.take() else {
            self.recording = Some(Vec::new());
            return self
                .pendant
                .show("recording the path: jog, then press v again".into());
        };
        let kept = simplified(&places, self.settings.tolerance_mm);
        if kept.len() < 2 {
            return self
                .pendant
                .show("nothing was jogged; no steps were added".into());
        }
        let text = format!(
            "{} became {}, within {} mm",
            output::count(places.len(), "position"),
            output::count(kept.len(), "step"),
            self.settings.tolerance_mm
        );
        match self.lesson.add_path(&kept) {
            Ok(()) => self.pendant.show(text),
            Err(error) => self.pendant.show(error.to_string()),
        }
    }

    /// Switches the pump, also in the program; recorded positions contain it.
    fn switch_suction(&mut self, on: bool) {
        self.pendant.switch_suction(on);
        if self.recording.is_none() {
            let done = self.lesson.switch_suction(on).map(|_| ());
            self.show_error(done);
        }
    }

    fn quit(&mut self, quits_unsaved: bool) {
        if self.lesson.is_changed() && !quits_unsaved {
            self.quits_unsaved = true;
            return self.pendant.show(
                "the program is not saved: press w to save, q to quit without saving".into(),
            );
        }
        self.pendant.quit();
    }

    fn show_error(&mut self, done: Result<(), ProgramError>) {
        if let Err(error) = done {
            self.pendant.show(error.to_string());
        }
    }
}

impl Panel for Teacher {
    fn pendant(&mut self) -> &mut Pendant {
        &mut self.pendant
    }

    fn handle_event(&mut self, now: Duration, event: &Event) {
        let pressed = |key: &KeyEvent| key.kind != KeyEventKind::Release;
        let key = event.as_key_event().filter(pressed);
        if let Some(key) = key.filter(|_| self.prompt.is_some()) {
            return self.handle_prompt_key(now, event, key);
        }
        if self.is_held_enter(now, key) {
            return;
        }
        match key.and_then(|key| teach_key(&key)) {
            // A held key counts once, except for moving the cursor.
            Some(meaning) if is_meant(key, meaning) => self.handle_key(meaning),
            Some(_) => {}
            None => {
                if key.is_some() {
                    self.captured = None;
                    self.quits_unsaved = false;
                }
                self.pendant.handle_event(now, event);
            }
        }
    }

    fn handle_paste(&mut self, text: &str) -> bool {
        self.paste(text)
    }

    fn handle_state(&mut self, state: State) {
        if let (Some(places), Some(arm)) = (&mut self.recording, &state.arm) {
            let place = RecordedPlace::of(&arm.status);
            if places.last() != Some(&place) && places.len() < MAX_PLACES {
                places.push(place);
            }
        }
        self.start_at_rest(&state);
        self.pendant.handle_state(state);
    }

    fn handle_reply(&mut self, reply: &Reply) {
        if let Reply::Job { job } = reply {
            self.handle_submitted(job.job);
        }
        self.pendant.handle_reply(reply);
    }

    fn handle_refused(&mut self, request: &Request, kind: Option<&str>, why: String) {
        if !self.tries_again(request, kind) {
            self.pendant.handle_refused(request, why);
        }
    }

    fn poll_file(&mut self) -> Option<(PathBuf, String)> {
        let wanted = std::mem::take(&mut self.is_saving);
        wanted.then(|| (self.file.clone(), self.lesson.text()))
    }

    fn handle_saved(&mut self, text: String, saved: std::io::Result<()>) {
        let name = self.file.display();
        match saved {
            Ok(()) => {
                self.pendant.show(format!("saved {name}"));
                self.lesson.handle_saved(text);
            }
            Err(error) => self.pendant.show(format!("cannot write {name}: {error}")),
        }
    }

    fn draw(&self, frame: &mut Frame) {
        screen::draw(frame, self);
    }
}

fn is_meant(key: Option<KeyEvent>, meaning: TeachKey) -> bool {
    let repeats = key.is_some_and(|key| key.kind == KeyEventKind::Repeat);
    !repeats || matches!(meaning, TeachKey::Cursor { .. })
}

const fn next_path(path: MovingMode) -> MovingMode {
    match path {
        MovingMode::Jump => MovingMode::MovL,
        MovingMode::MovL => MovingMode::MovJ,
        MovingMode::MovJ => MovingMode::Jump,
    }
}

/// An hour of statuses.
const MAX_PLACES: usize = 45_000;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests;
