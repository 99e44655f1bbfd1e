//! The questions while teaching.
//!
//! No key of a question for a letter or a text moves the arm or runs anything; Space and Esc stop it there, too. While
//! places are touched, the arm is jogged as ever.

use std::time::Duration;

use crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use dobot_api::Request;
use dobot_arm::Tool;
use dobot_teach::ProgramError;
use dobot_wire::Configuration;

use super::Teacher;
use crate::pendant::Panel;
use crate::verbs::teach::keys::{TeachKey, teach_key};
use crate::verbs::teach::lesson::{GridUse, TouchedGrid};
use crate::verbs::teach::prompt::{Answer, Input, Outcome, Prompt};
use crate::verbs::teach::screen::times_text;

impl Teacher {
    /// Asks what to add.
    pub(super) fn open_prompt(&mut self) {
        if self.recorded().is_some() {
            let text = "a path is recorded: press v to end it, then a";
            return self.pendant.show(text.into());
        }
        self.pendant.clear();
        self.prompt = Some(Prompt::new(self.lesson.last_point()));
    }

    /// Ends the repeat around the selected step.
    pub(super) fn end_block(&mut self) {
        let text = match self.lesson.end_block() {
            Ok(name) => format!("the {name} ends here; new steps are added after it"),
            Err(error) => error.to_string(),
        };
        self.pendant.show(text);
    }

    /// Handles a pressed key while a question is open.
    pub(super) fn handle_prompt_key(&mut self, now: Duration, event: &Event, key: KeyEvent) {
        let Some(input) = self.prompt.as_ref().map(Prompt::input) else {
            return;
        };
        let stops = match key.code {
            KeyCode::Esc | KeyCode::Char(' ') => true,
            KeyCode::Char('s' | 'S') => input != Input::Text,
            _ => false,
        };
        let is_control = key.modifiers.contains(KeyModifiers::CONTROL);
        let leaves = matches!(key.code, KeyCode::Char('c' | 'C'));
        // Others would jog or switch the pump: Ctrl-U and Ctrl-Left are keys of editors.
        if is_control && input != Input::Place && !stops && !leaves {
            return;
        }
        if stops || is_control {
            if key.code == KeyCode::Esc {
                self.prompt = None;
            }
            return self.pendant.handle_event(now, event);
        }
        // A held key counts once, except for removing letters and for jogging.
        let may_repeat = input == Input::Place || key.code == KeyCode::Backspace;
        if key.kind == KeyEventKind::Repeat && !may_repeat {
            return;
        }
        let is_answer = matches!(
            key.code,
            KeyCode::Enter | KeyCode::Backspace | KeyCode::Delete
        );
        if input == Input::Place && !is_answer {
            return self.handle_key_between_places(now, event, &key);
        }
        self.pendant.release();
        let program = self.lesson.program();
        let prompt = self.prompt.as_mut();
        if let Some(outcome) = prompt.map(|prompt| prompt.handle_key(key.code, &program)) {
            self.handle_outcome(outcome);
            self.held_until = self.prompt.is_none().then_some(now + FIRST_REPEAT);
        }
    }

    /// Whether a key is the Enter of the last answer, which is still held: it adds no point.
    pub(super) fn is_held_enter(&mut self, now: Duration, key: Option<KeyEvent>) -> bool {
        let Some(key) = key else {
            return false;
        };
        let until = self.held_until.take().filter(|until| now < *until);
        let is_held = key.code == KeyCode::Enter && until.is_some();
        self.held_until = is_held.then_some(now + NEXT_REPEAT);
        is_held
    }

    /// Handles pasted text; returns whether a question has taken it.
    pub(super) fn paste(&mut self, text: &str) -> bool {
        let Some(prompt) = &mut self.prompt else {
            return false;
        };
        let outcome = prompt.handle_paste(text);
        self.handle_outcome(outcome);
        true
    }

    /// Keys that move the arm to the next place; those that would run or change the program do nothing.
    fn handle_key_between_places(&mut self, now: Duration, event: &Event, key: &KeyEvent) {
        match teach_key(key) {
            Some(TeachKey::PauseJob | TeachKey::CancelJob | TeachKey::Steps)
                if key.kind == KeyEventKind::Repeat => {}
            Some(meaning @ (TeachKey::PauseJob | TeachKey::CancelJob | TeachKey::Steps)) => {
                self.handle_key(meaning);
            }
            None | Some(TeachKey::Suction(_)) => self.pendant.handle_event(now, event),
            Some(_) => {
                self.pendant.release();
                let text =
                    "this key does nothing here: Enter touches the place, Esc leaves the question";
                self.pendant.show(text.into());
            }
        }
    }

    fn handle_outcome(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Asks => self.pendant.clear(),
            Outcome::Refused(reason) => self.pendant.show(reason),
            Outcome::Cancelled => self.prompt = None,
            Outcome::WantsPlace => match self.place() {
                Ok(place) => {
                    let prompt = self.prompt.as_mut();
                    if let Some(outcome) = prompt.map(|prompt| prompt.handle_place(place)) {
                        self.handle_outcome(outcome);
                    }
                }
                Err(why) => self.pendant.show(format!("not touched: {why}")),
            },
            Outcome::Answered(answer) => match self.teach(answer) {
                Ok(text) => {
                    self.prompt = None;
                    self.pendant.show(text);
                }
                // The answers stay, to be corrected.
                Err(error) => self.pendant.show(error.to_string()),
            },
        }
    }

    /// Puts an answer into the program; returns the text to show.
    fn teach(&mut self, answer: Answer) -> Result<String, ProgramError> {
        match answer {
            Answer::Rename { from, to } => {
                self.lesson.rename_point(&from, &to)?;
                Ok(format!("point {from} is now {to}"))
            }
            Answer::Repeat(times) => {
                let how_often = times_text(times);
                Ok(if self.lesson.begin_repeat(times)? {
                    format!("repeats the following steps {how_often}; e ends it after a step")
                } else {
                    format!("repeats the steps that you add now {how_often}; e ends it")
                })
            }
            Answer::Tool(tool) => {
                let is_risky = self.lesson.add_tool(tool)?;
                // The arm reports its position by the reach of the tool.
                self.mount(tool.kind);
                let label = tool.kind.label();
                Ok(if is_risky {
                    format!(
                        "{label} added; the next steps were taught with another length: check their heights"
                    )
                } else {
                    format!("{label} added; points are now those of its tip")
                })
            }
            Answer::Grid(touched) => self.teach_grid(&touched),
            Answer::Frame(name, points) => {
                let points_up = self.lesson.set_frame(&name, &points)?;
                Ok(if points_up {
                    format!("points are now taught in frame {name}; a f Enter: in the base frame")
                } else {
                    format!(
                        "points are now taught in frame {name}; its z axis points down: its third place is to the right"
                    )
                })
            }
            Answer::UseFrame(name) => {
                let text = match &name {
                    Some(name) => format!("points are now taught in frame {name}"),
                    None => "points are now taught in the base frame".to_owned(),
                };
                self.lesson.use_frame(name);
                Ok(text)
            }
            Answer::Call(file) => {
                let text = format!("calls {file}");
                self.lesson.add_call(file)?;
                Ok(text)
            }
        }
    }

    fn teach_grid(&mut self, touched: &TouchedGrid) -> Result<String, ProgramError> {
        let (used, corner_deg) = self.lesson.add_grid(touched, self.path)?;
        let name = &touched.name;
        let text = match used {
            GridUse::TaughtAgain => format!("grid {name} taught again"),
            GridUse::Visited => {
                format!("grid {name}: what you add now is done at each cell; e ends it")
            }
            GridUse::Joined => format!("grid {name} is visited in step with the each around it"),
        };
        Ok(if (corner_deg - 90.0).abs() > SQUARE_WITHIN_DEG {
            format!("{text}; its corner has {corner_deg:.1}°, not 90°: is each place right?")
        } else {
            text
        })
    }

    /// Sets the tool of the arm.
    fn mount(&mut self, tool: Tool) {
        let tool = tool.into();
        let command = Configuration::EndEffector { tool }.into();
        self.pendant().send(Request::Command { command });
    }
}

/// Longer than the delay of a keyboard before the first repeat, and between two repeats.
const FIRST_REPEAT: Duration = Duration::from_millis(700);
const NEXT_REPEAT: Duration = Duration::from_millis(150);
/// The largest deviation of a tray's corner from a right angle without a remark, in degrees.
const SQUARE_WITHIN_DEG: f64 = 2.0;
