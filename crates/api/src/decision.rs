//! Questions that a running program asks, and their answers.

use std::collections::BTreeMap;
use std::fmt;

use dobot_wire::Command;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Sense;

/// A program that asks while it runs. Its job has the commands up to the next question; the answer
/// adds the commands up to the one after it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AskingProgram {
    /// Its TOML text.
    pub text: String,
    /// The texts of the programs that it calls, by the names used in it.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub files: BTreeMap<String, String>,
    /// The commands of its drawings, by file and options.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drawings: BTreeMap<String, Vec<Command>>,
    /// The step that it starts at, counted from 0.
    #[serde(default)]
    pub from_step: usize,
    /// The answers given, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 100_000))]
    pub answers: Vec<Answer>,
    /// The question asked after the last command; absent if the program ends there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub question: Option<PendingQuestion>,
}

/// A question that the job asks after its last command.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PendingQuestion {
    /// Its number in the job, from 1.
    #[serde(default)]
    pub number: u64,
    /// The question.
    #[serde(flatten)]
    pub question: Question,
    /// How long the job waits for the answer, in seconds; absent: until it is answered.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub timeout_s: Option<f64>,
    /// The answer after the timeout; absent: the job is paused then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub otherwise: Option<Answer>,
}

/// A question of a program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "asks", rename_all = "snake_case")]
pub enum Question {
    /// Which of these answers?
    Choice {
        /// The text shown to people.
        text: String,
        /// The possible answers, two or more.
        answers: Vec<String>,
        /// Who may answer.
        by: AnsweredBy,
    },
    /// Where is this?
    Place {
        /// The name of the position.
        name: String,
    },
    /// None: the station itself adds the next cycle of the program.
    NextCycle,
}

/// Who may answer a question.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum AnsweredBy {
    /// A person.
    #[default]
    Person,
    /// A person, a camera or another program.
    Seen,
}

/// The answer to a question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Answer {
    /// One of the possible answers.
    Choice(String),
    /// A position.
    Place(GivenPlace),
    /// The steps that need the answer are skipped.
    Skip,
    /// The next cycle.
    NextCycle,
}

/// A position given to a program: that of the tool's tip in the base frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GivenPlace {
    /// The name under which the program asks for it; if given, it has to be that name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The distance forward of the base axis, in mm.
    pub x_mm: f64,
    /// The distance to the left of the base axis, in mm.
    pub y_mm: f64,
    /// The height above the rear arm's pivot, in mm.
    pub z_mm: f64,
    /// The rotation of the tool, in degrees; default 0.
    #[serde(default)]
    pub rotation_deg: f64,
    /// The sense that has located it, if it is no person's own input.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sense: Option<Sense>,
}

impl Question {
    /// Returns whether only a person may answer it.
    #[must_use]
    pub const fn is_for_person(&self) -> bool {
        matches!(
            self,
            Self::Choice {
                by: AnsweredBy::Person,
                ..
            }
        )
    }
}

impl PendingQuestion {
    /// Checks that an answer fits the question.
    ///
    /// # Errors
    ///
    /// What was found and what is allowed, in one line.
    pub fn check(&self, answer: &Answer) -> Result<(), String> {
        match (&self.question, answer) {
            (Question::Choice { answers, .. }, Answer::Choice(found)) => {
                if answers.contains(found) {
                    return Ok(());
                }
                Err(format!(
                    "the answer is {found:?}; allowed: {}",
                    answers.join(", ")
                ))
            }
            (Question::Place { name }, Answer::Place(place)) => match &place.name {
                Some(given) if given != name => Err(format!(
                    "the position is {given:?}; the program asks for {name:?}"
                )),
                _ => place.check(),
            },
            (Question::NextCycle, Answer::NextCycle) => Ok(()),
            (_, Answer::Skip) if self.otherwise == Some(Answer::Skip) => Ok(()),
            (question, _) => Err(format!("the program asks {question}")),
        }
    }
}

impl GivenPlace {
    fn check(&self) -> Result<(), String> {
        for (name, found) in [
            ("x_mm", self.x_mm),
            ("y_mm", self.y_mm),
            ("z_mm", self.z_mm),
            ("rotation_deg", self.rotation_deg),
        ] {
            if found.is_nan() || found.abs() > MAX_COORDINATE {
                return Err(format!(
                    "{name} is {found}; allowed are -{MAX_COORDINATE} to {MAX_COORDINATE}"
                ));
            }
        }
        Ok(())
    }
}

/// Formats for people, in one line.
impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Choice { text, answers, .. } => write!(f, "{text} ({})", answers.join(", ")),
            Self::Place { name } => write!(f, "for the position {name:?}"),
            Self::NextCycle => f.write_str("for its next cycle"),
        }
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Choice(answer) => f.write_str(answer),
            Self::Place(place) => {
                let GivenPlace {
                    x_mm,
                    y_mm,
                    z_mm,
                    sense,
                    ..
                } = place;
                if let Some(sense) = sense {
                    write!(f, "{sense}: ")?;
                }
                write!(f, "x {x_mm:.1} y {y_mm:.1} z {z_mm:.1}")
            }
            Self::Skip => f.write_str("skip"),
            Self::NextCycle => f.write_str("next cycle"),
        }
    }
}

/// The largest coordinate, in mm or degrees; the policy allows far less.
const MAX_COORDINATE: f64 = 1e4;
