//! Buttons that people have added to the page: each sends a command or runs a program.

use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

use dobot_api::problem_kinds::{BAD_BUTTON, BUTTON_FILE, BUTTON_TAKEN, NO_SUCH_BUTTON};
use dobot_api::{Problem, write_private};
use dobot_supervisor::is_plain;
use dobot_teach::Program;
use dobot_wire::{Command, MovingMode};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The buttons, in the order in which they were added, and their file.
#[derive(Debug)]
pub(crate) struct CustomButtons {
    file: PathBuf,
    /// The buttons; `None` until the file is read.
    known: Mutex<Option<Vec<CustomButton>>>,
}

/// A button that a person has added to the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CustomButton {
    /// Its label, different from that of all others: 1 to 30 printable characters.
    name: String,
    /// Its colour.
    color: ButtonColor,
    /// The effect of a press.
    action: ButtonAction,
}

/// The colour of a button. Red is the colour of STOP.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum ButtonColor {
    Grey,
    Blue,
    Green,
    Yellow,
    Purple,
}

/// The effect of a button.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum ButtonAction {
    /// Moves to a position, in the base frame, and leaves the tool as it is.
    Position {
        /// X, in millimetres.
        x_mm: f32,
        /// Y, in millimetres.
        y_mm: f32,
        /// Z, in millimetres.
        z_mm: f32,
        /// The rotation of the tool, in degrees.
        rotation_deg: f32,
        /// The path.
        mode: MovingMode,
    },
    /// Sends a command.
    Command {
        /// The command.
        command: Command,
    },
    /// Runs a program as a job.
    Program {
        /// Its TOML text.
        text: String,
    },
}

impl CustomButtons {
    pub(crate) const fn at(file: PathBuf) -> Self {
        let known = Mutex::new(None);
        Self { file, known }
    }

    /// Returns all buttons.
    pub(crate) fn list(&self) -> Result<Vec<CustomButton>, Problem> {
        self.read(&mut self.known())
    }

    /// Adds a button; returns all.
    pub(crate) fn add(&self, button: CustomButton) -> Result<Vec<CustomButton>, Problem> {
        button.check()?;
        let mut known = self.known();
        let mut all = self.read(&mut known)?;
        if all.iter().any(|other| other.name == button.name) {
            let detail = format!("there is a button with the name {:?}", button.name);
            return Err(BUTTON_TAKEN.problem(detail));
        }
        if all.len() >= MAX_BUTTONS {
            return Err(BAD_BUTTON.problem(format!(
                "there are {MAX_BUTTONS} buttons, the most allowed; remove one first"
            )));
        }
        all.push(button);
        self.write(&mut known, all)
    }

    /// Removes a button; returns the remaining ones.
    pub(crate) fn remove(&self, name: &str) -> Result<Vec<CustomButton>, Problem> {
        let mut known = self.known();
        let mut all = self.read(&mut known)?;
        let at = all.iter().position(|button| button.name == name);
        let at = at.ok_or_else(|| {
            NO_SUCH_BUTTON.problem(format!("there is no button with the name {name:?}"))
        })?;
        all.remove(at);
        self.write(&mut known, all)
    }

    fn known(&self) -> MutexGuard<'_, Option<Vec<CustomButton>>> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn read(&self, known: &mut Option<Vec<CustomButton>>) -> Result<Vec<CustomButton>, Problem> {
        if let Some(all) = known {
            return Ok(all.clone());
        }
        let all = match fs::read_to_string(&self.file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Vec::new(),
            Err(error) => return Err(self.problem(&error.to_string())),
            Ok(text) => {
                serde_json::from_str(&text).map_err(|error| self.problem(&error.to_string()))?
            }
        };
        Ok(known.insert(all).clone())
    }

    fn write(
        &self,
        known: &mut Option<Vec<CustomButton>>,
        all: Vec<CustomButton>,
    ) -> Result<Vec<CustomButton>, Problem> {
        let text = serde_json::to_string_pretty(&all).expect("buttons have JSON keys");
        write_private(&self.file, &text).map_err(|error| self.problem(&error.to_string()))?;
        Ok(known.insert(all).clone())
    }

    fn problem(&self, why: &str) -> Problem {
        BUTTON_FILE.problem(format!("{}: {why}", self.file.display()))
    }
}

impl CustomButton {
    /// Its name.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    fn check(&self) -> Result<(), Problem> {
        let is_seen = !self.name.trim().is_empty() && self.name.chars().all(is_plain);
        if !is_seen || self.name.chars().count() > MAX_NAME {
            let detail = format!("name: allowed are 1 to {MAX_NAME} printable characters");
            return Err(BAD_BUTTON.problem(detail));
        }
        let ButtonAction::Program { text } = &self.action else {
            return Ok(());
        };
        if text.len() > MAX_TEXT {
            return Err(BAD_BUTTON.problem(format!(
                "the program has {} bytes; allowed are {MAX_TEXT}",
                text.len()
            )));
        }
        let program = Program::from_toml(text);
        program.map_err(|error| BAD_BUTTON.problem(format!("the program: {error}")))?;
        Ok(())
    }
}

/// The most buttons.
const MAX_BUTTONS: usize = 48;
/// The most characters of a name.
const MAX_NAME: usize = 30;
/// The largest program, in bytes.
const MAX_TEXT: usize = 64 * 1024;
