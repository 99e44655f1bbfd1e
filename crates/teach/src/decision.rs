//! Steps that decide: questions, counters, variables, and grips that may fail.

use std::collections::BTreeMap;
use std::fmt;

use dobot_api::AnsweredBy;
use dobot_wire::MovingMode;
use schemars::JsonSchema;
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::number::within;
use crate::place::Place;
use crate::program::Steps;
use crate::step_table::StepTable;

/// A question with answers, each with its own steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Choose {
    /// The question.
    pub question: String,
    /// Who or what answers it.
    pub by: ChosenBy,
    /// The time to answer, and the answer after it.
    pub wait: AnswerWait,
    /// The answers, one or more.
    pub when: Vec<When>,
}

/// Who or what answers a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChosenBy {
    /// A person or another program.
    Asked(AnsweredBy),
    /// A counter: each time that is a multiple of this number gets the first answer, all others the
    /// second one, or nothing.
    Every(u64),
}

/// How long to wait for an answer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnswerWait {
    /// In seconds; without it, until it is answered.
    pub timeout_s: Option<f64>,
    /// The answer after that; without it, the job is paused.
    pub otherwise: Option<String>,
}

/// An answer and its steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct When {
    /// The answer, 1 to 40 characters.
    pub answer: String,
    /// Its steps; none continue with the next step.
    #[serde(default)]
    #[schemars(with = "Vec<StepTable>")]
    pub steps: Steps,
}

/// Variables with their values.
pub type Variables = BTreeMap<String, i64>;

/// A comparison of a variable: `count < 5`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The variable.
    pub variable: String,
    /// How it is compared.
    pub comparison: Comparison,
    /// What it is compared with.
    pub with: Operand,
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `=`
    Equal,
    /// `!=`
    NotEqual,
    /// `>=`
    GreaterOrEqual,
    /// `>`
    Greater,
}

/// A number or a variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Operand {
    /// A whole number.
    Number(i64),
    /// A variable.
    Variable(String),
}

/// Picking up or putting down an object: above the place, down in a straight line, up again.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer {
    /// The place of the object.
    pub at: Place,
    /// The path to the position above it.
    pub path: MovingMode,
    /// The height above the place to come from, in mm.
    pub approach_mm: f64,
    /// The height above the place to go to afterwards, in mm.
    pub retreat_mm: f64,
    /// The time to hold or release the object, in seconds.
    pub settle_s: f64,
    /// The angle of a gripper, in degrees; a suction cup has none.
    pub gripper: Option<f64>,
    /// For picking up: the check of the grip.
    pub missed: Option<Missed>,
}

/// What to do if nothing was picked up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Missed {
    /// Who reports it: `person` (default) or `seen`, a camera or another program.
    #[serde(default)]
    pub by: AnsweredBy,
    /// How often to try again before the steps, 0 to 100; default 0.
    #[serde(default)]
    #[schemars(range(max = 100))]
    pub retries: u32,
    /// The steps if it is still not picked up.
    #[serde(default)]
    #[schemars(with = "Vec<StepTable>")]
    pub steps: Steps,
}

impl Condition {
    /// Returns whether it holds; `None` if a variable does not exist.
    #[must_use]
    pub fn holds(&self, variables: &Variables) -> Option<bool> {
        let found = variables.get(&self.variable)?;
        let with = match &self.with {
            Operand::Number(number) => number,
            Operand::Variable(name) => variables.get(name)?,
        };
        Some(match self.comparison {
            Comparison::Less => found < with,
            Comparison::LessOrEqual => found <= with,
            Comparison::Equal => found == with,
            Comparison::NotEqual => found != with,
            Comparison::GreaterOrEqual => found >= with,
            Comparison::Greater => found > with,
        })
    }

    /// Returns the names of its variables.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let other = match &self.with {
            Operand::Variable(name) => Some(name.as_str()),
            Operand::Number(_) => None,
        };
        std::iter::once(self.variable.as_str()).chain(other)
    }
}

impl Comparison {
    const ALL: [(&'static str, Self); 6] = [
        ("<=", Self::LessOrEqual),
        (">=", Self::GreaterOrEqual),
        ("!=", Self::NotEqual),
        ("<", Self::Less),
        (">", Self::Greater),
        ("=", Self::Equal),
    ];
}

impl std::str::FromStr for Condition {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let bad = || {
            format!(
                "while is {text:?}; allowed is a variable, one of < <= = != >= >, and a whole number or a variable, for example \"count < 5\""
            )
        };
        let find = |(symbol, comparison): (&str, Comparison)| {
            text.split_once(symbol).map(|parts| (parts, comparison))
        };
        let ((variable, with), comparison) =
            Comparison::ALL.into_iter().find_map(find).ok_or_else(bad)?;
        // `==` is understood, too.
        let (variable, with) = (variable.trim(), with.trim_start_matches('=').trim());
        let with = match with.parse() {
            Ok(number) => Operand::Number(number),
            Err(_) if is_variable(with) => Operand::Variable(with.to_owned()),
            Err(_) => return Err(bad()),
        };
        if !is_variable(variable) {
            return Err(bad());
        }
        Ok(Self {
            variable: variable.to_owned(),
            comparison,
            with,
        })
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbol = Comparison::ALL
            .into_iter()
            .find(|(_, comparison)| *comparison == self.comparison)
            .map_or("=", |(symbol, _)| symbol);
        write!(f, "{} {symbol} ", self.variable)?;
        match &self.with {
            Operand::Number(number) => number.fmt(f),
            Operand::Variable(name) => f.write_str(name),
        }
    }
}

impl Serialize for Condition {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Condition {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_str(ConditionVisitor)
    }
}

struct ConditionVisitor;

impl Visitor<'_> for ConditionVisitor {
    type Value = Condition;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a comparison in quotes, for example \"count < 5\"")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Condition, E> {
        text.parse().map_err(E::custom)
    }
}

impl JsonSchema for Condition {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Condition".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A comparison of a variable with a whole number or another variable: `count < 5`; with <, <=, =, !=, >= or >.",
            "type": "string",
        })
    }
}

/// The keys beside `choose`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ChooseKeys {
    pub(crate) by: Option<AnsweredBy>,
    pub(crate) every: Option<u64>,
    pub(crate) timeout: Option<f64>,
    pub(crate) otherwise: Option<String>,
    pub(crate) when: Option<Vec<When>>,
}

impl ChooseKeys {
    /// Returns the step.
    pub(crate) fn choose(self, question: String) -> Result<Choose, String> {
        let when = self.when.unwrap_or_default();
        if when.is_empty() {
            return Err(
                "choose has no answers; add them as [[steps.when]] with answer and steps".into(),
            );
        }
        for (index, one) in when.iter().enumerate() {
            let count = one.answer.chars().count();
            if !(1..=MAX_ANSWER_LEN).contains(&count) {
                return Err(format!(
                    "an answer has {count} letters; allowed are 1 to {MAX_ANSWER_LEN}"
                ));
            }
            if when[..index].iter().any(|other| other.answer == one.answer) {
                return Err(format!(
                    "the answer {:?} appears twice; allowed is once",
                    one.answer
                ));
            }
        }
        check_timeout(self.timeout, self.otherwise.is_some())?;
        let wait = AnswerWait {
            timeout_s: self.timeout,
            otherwise: self.otherwise,
        };
        if let Some(otherwise) = &wait.otherwise
            && !when.iter().any(|one| one.answer == *otherwise)
        {
            let answers: Vec<&str> = when.iter().map(|one| one.answer.as_str()).collect();
            return Err(format!(
                "otherwise is {otherwise:?}; allowed: {}",
                answers.join(", ")
            ));
        }
        let by = match (self.by, self.every) {
            (Some(_), Some(_)) => {
                return Err("choose has by and every; allowed is one of them".into());
            }
            (_, Some(every)) if !(1..=MAX_EVERY).contains(&every) => {
                return Err(format!("every is {every}; allowed are 1 to {MAX_EVERY}"));
            }
            (_, Some(_)) if when.len() > 2 || wait != AnswerWait::default() => {
                return Err("choose with every has one or two answers and no timeout: the first for every such time, the second for all others".into());
            }
            (_, Some(every)) => ChosenBy::Every(every),
            (by, None) if when.len() < 2 => {
                return Err(format!(
                    "choose by {} has one answer; add another one as [[steps.when]]",
                    if by == Some(AnsweredBy::Seen) {
                        "seen"
                    } else {
                        "person"
                    }
                ));
            }
            (by, None) => ChosenBy::Asked(by.unwrap_or_default()),
        };
        Ok(Choose {
            question,
            by,
            wait,
            when,
        })
    }

    /// Returns the keys of a step.
    pub(crate) fn of(choose: &Choose) -> Self {
        let (by, every) = match choose.by {
            ChosenBy::Asked(AnsweredBy::Person) => (None, None),
            ChosenBy::Asked(by) => (Some(by), None),
            ChosenBy::Every(every) => (None, Some(every)),
        };
        Self {
            by,
            every,
            timeout: choose.wait.timeout_s,
            otherwise: choose.wait.otherwise.clone(),
            when: Some(choose.when.clone()),
        }
    }
}

/// Checks the time to wait for an answer.
fn check_timeout(timeout_s: Option<f64>, has_otherwise: bool) -> Result<(), String> {
    match timeout_s {
        Some(timeout) => within("timeout", " s", timeout, 0.1, MAX_TIMEOUT_S).map(drop),
        None if has_otherwise => {
            Err("otherwise is what to do after a timeout; add timeout, in seconds".into())
        }
        None => Ok(()),
    }
}

/// The keys beside `pick` and `place`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct TransferKeys {
    pub(crate) path: Option<MovingMode>,
    pub(crate) approach: Option<f64>,
    pub(crate) retreat: Option<f64>,
    pub(crate) settle: Option<f64>,
    pub(crate) gripper: Option<f64>,
    pub(crate) on_missed: Option<Missed>,
}

impl TransferKeys {
    /// Returns the details of a step.
    pub(crate) fn transfer(self, at: Place) -> Result<Transfer, String> {
        let approach_mm = self.approach.unwrap_or(APPROACH_MM);
        let retreat_mm = self.retreat.unwrap_or(approach_mm);
        let settle_s = self.settle.unwrap_or(SETTLE_S);
        within("approach", " mm", approach_mm, 0.0, MAX_APPROACH_MM)?;
        within("retreat", " mm", retreat_mm, 0.0, MAX_APPROACH_MM)?;
        within("settle", " s", settle_s, 0.0, MAX_SETTLE_S)?;
        if let Some(missed) = &self.on_missed
            && missed.retries > MAX_RETRIES
        {
            return Err(format!(
                "on_missed.retries is {}; allowed are 0 to {MAX_RETRIES}",
                missed.retries
            ));
        }
        Ok(Transfer {
            at,
            path: self.path.unwrap_or(MovingMode::MovJ),
            approach_mm,
            retreat_mm,
            settle_s,
            gripper: self.gripper,
            missed: self.on_missed,
        })
    }

    /// Returns the keys of a step; defaults are omitted.
    pub(crate) fn of(transfer: Transfer) -> Self {
        let Transfer {
            approach_mm,
            retreat_mm,
            settle_s,
            ..
        } = transfer;
        Self {
            path: Some(transfer.path).filter(|path| *path != MovingMode::MovJ),
            approach: Some(approach_mm).filter(|mm| *mm != APPROACH_MM),
            retreat: Some(retreat_mm).filter(|mm| *mm != approach_mm),
            settle: Some(settle_s).filter(|s| *s != SETTLE_S),
            gripper: transfer.gripper,
            on_missed: transfer.missed,
        }
    }
}

/// A position that is given while the program runs.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExternalPlace {
    /// The name under which it is given, 1 to 40 characters.
    pub from: String,
    /// If `from` is `seen`: the marker that a camera looks for, 4 to 49. The name is then `marker 7`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub marker: Option<u16>,
    /// How long to wait for it, in seconds; without it, until it is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub timeout: Option<f64>,
    /// What to do after the timeout.
    #[serde(skip_serializing_if = "is_pause")]
    pub otherwise: AfterTimeout,
}

/// What to do if a position is not given in time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum AfterTimeout {
    /// The job is paused.
    #[default]
    Pause,
    /// The step is skipped.
    Skip,
}

impl ExternalPlace {
    /// Creates a position with this name.
    ///
    /// # Errors
    ///
    /// What was found and what is allowed, in one line.
    pub(crate) fn new(
        from: String,
        marker: Option<u16>,
        timeout: Option<f64>,
        otherwise: Option<AfterTimeout>,
    ) -> Result<Self, String> {
        match (from == SEEN, marker) {
            (true, None) => {
                return Err("from is \"seen\"; add the marker that is looked for: { from = \"seen\", marker = 7 }".into());
            }
            (false, Some(_)) => {
                return Err(format!(
                    "a position has a marker, and from is {from:?}; allowed is \"seen\""
                ));
            }
            (true, Some(marker)) if !MARKERS.contains(&marker) => {
                return Err(format!(
                    "marker is {marker}; allowed are {} to {}: `dobot markers` prints them",
                    MARKERS.start(),
                    MARKERS.end()
                ));
            }
            _ => {}
        }
        let count = from.chars().count();
        if !(1..=MAX_ANSWER_LEN).contains(&count) || from.contains(['/', '?', '#']) {
            return Err(format!(
                "from is {from:?}; allowed is a name of 1 to {MAX_ANSWER_LEN} letters without / ? #"
            ));
        }
        check_timeout(timeout, otherwise.is_some())?;
        Ok(Self {
            from,
            marker,
            timeout,
            otherwise: otherwise.unwrap_or_default(),
        })
    }

    /// Returns the name under which it is asked for and given.
    #[must_use]
    pub fn name(&self) -> String {
        self.marker
            .map_or_else(|| self.from.clone(), |marker| format!("marker {marker}"))
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_pause(otherwise: &AfterTimeout) -> bool {
    *otherwise == AfterTimeout::Pause
}

/// Returns whether a name may be that of a variable: letters, digits and `_`, not first a digit.
pub(crate) fn is_variable(name: &str) -> bool {
    let mut letters = name.chars();
    letters
        .next()
        .is_some_and(|first| first.is_alphabetic() || first == '_')
        && letters.all(|letter| letter.is_alphanumeric() || letter == '_')
        && name.len() <= MAX_ANSWER_LEN
}

/// What `from` says for a position that a camera gives.
const SEEN: &str = "seen";
/// The markers for objects.
const MARKERS: std::ops::RangeInclusive<u16> = 4..=49;
/// The default height above a place, in mm.
const APPROACH_MM: f64 = 20.0;
const MAX_APPROACH_MM: f64 = 300.0;
/// The default time to hold or release, in seconds.
const SETTLE_S: f64 = 0.3;
const MAX_SETTLE_S: f64 = 60.0;
const MAX_RETRIES: u32 = 100;
/// The longest answer or name.
pub(crate) const MAX_ANSWER_LEN: usize = 40;
const MAX_EVERY: u64 = 1_000_000;
const MAX_TIMEOUT_S: f64 = 86_400.0;
