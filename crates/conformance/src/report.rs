//! The report: a table, and what it comes to.

use std::fmt::{self, Write};
use std::time::Duration;

use crate::check::Check;
use crate::hindrance::Hindrance;
use crate::latency::Latency;
use crate::outcome::Outcome;

/// What came of all checks, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    rows: Vec<Row>,
    latency: Option<Latency>,
    hindrance: Option<Hindrance>,
}

/// A check and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The check.
    pub check: Check,
    /// What came of it.
    pub outcome: Outcome,
    /// How long it took, by the clock of the link.
    pub took: Duration,
}

/// Which dialect a controller speaks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The published document (`Dialect::SPECIFICATION`).
    Specification,
    /// That of stock arms (`Dialect::FIRMWARE_1_1`).
    Firmware11,
    /// Some of one and some of the other, by the names of the checks.
    Mixed {
        /// As the document says.
        specification: Vec<&'static str>,
        /// As stock arms do.
        firmware_1_1: Vec<&'static str>,
    },
    /// No check told.
    Unknown,
}

impl Report {
    pub(crate) const fn new(
        rows: Vec<Row>,
        latency: Option<Latency>,
        hindrance: Option<Hindrance>,
    ) -> Self {
        Self {
            rows,
            latency,
            hindrance,
        }
    }

    /// All rows, in the order of [`Check::ALL`].
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// What came of a check.
    #[must_use]
    pub fn outcome(&self, id: &str) -> Option<&Outcome> {
        let row = self.rows.iter().find(|row| row.check.id == id);
        row.map(|row| &row.outcome)
    }

    /// The names of the checks that found something else than the protocol says.
    #[must_use]
    pub fn differing(&self) -> Vec<&'static str> {
        self.ids(Outcome::differs)
    }

    /// The names of the checks that did not find the same each time, or found that something got
    /// lost on the way.
    #[must_use]
    pub fn unsteady(&self) -> Vec<&'static str> {
        self.ids(|it| matches!(it, Outcome::Unsteady(_)))
    }

    /// How long the line takes, if that could be measured.
    #[must_use]
    pub const fn latency(&self) -> Option<Latency> {
        self.latency
    }

    /// Why the arm was not moved at all, if it was not although nothing differs.
    #[must_use]
    pub const fn hindrance(&self) -> Option<&Hindrance> {
        self.hindrance.as_ref()
    }

    /// Which dialect the controller speaks.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let specification = self.ids(|it| matches!(it, Outcome::Specification(_)));
        let firmware_1_1 = self.ids(|it| matches!(it, Outcome::Firmware11(_)));
        match (specification.is_empty(), firmware_1_1.is_empty()) {
            (true, true) => Verdict::Unknown,
            (false, true) => Verdict::Specification,
            (true, false) => Verdict::Firmware11,
            (false, false) => Verdict::Mixed {
                specification,
                firmware_1_1,
            },
        }
    }

    /// Whether all that was tried holds, in one dialect.
    #[must_use]
    pub fn conforms(&self) -> bool {
        let one_dialect = matches!(self.verdict(), Verdict::Specification | Verdict::Firmware11);
        one_dialect && self.differing().is_empty() && self.unsteady().is_empty()
    }

    /// What it comes to, in one line: `46 hold, 4 not tried; speaks specification`.
    #[must_use]
    pub fn summary(&self) -> String {
        let differ = self.differing().len();
        let untried = self.ids(|it| matches!(it, Outcome::NotTried(_))).len();
        let unsteady = self.unsteady().len();
        let hold = self.rows.len() - differ - untried - unsteady;
        let unsteady = match unsteady {
            0 => String::new(),
            count => format!(" {count} unsteady,"),
        };
        format!(
            "{hold} hold, {differ} differ,{unsteady} {untried} not tried; speaks {}",
            self.verdict()
        )
    }

    /// The report as a file: Markdown, the same for the same outcomes.
    #[must_use]
    pub fn markdown(&self, address: &str, date: &str) -> String {
        let mut text = format!("{HEADING}\n\n| | |\n|---|---|\n");
        let _ = writeln!(text, "| address | `{address}` |");
        let _ = writeln!(text, "| date | {date} |");
        if let Some(latency) = self.latency {
            let _ = writeln!(text, "| latency | {latency} |");
        }
        let _ = writeln!(text, "| speaks | {} |", self.verdict());
        let _ = writeln!(text, "| outcome | {} |", self.summary());
        text.push_str(LEGEND);
        for row in &self.rows {
            let Check {
                id, title, source, ..
            } = row.check;
            let _ = writeln!(
                text,
                "| `{id}` | {title} | {source} | {} | {} | {:.1} |",
                row.outcome.word(),
                row.outcome.found(),
                row.took.as_secs_f64()
            );
        }
        text
    }

    fn ids(&self, wanted: impl Fn(&Outcome) -> bool) -> Vec<&'static str> {
        let rows = self.rows.iter().filter(|row| wanted(&row.outcome));
        rows.map(|row| row.check.id).collect()
    }
}

impl fmt::Display for Row {
    /// One line of a table: name, outcome, what was found.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (id, word) = (self.check.id, self.outcome.word());
        write!(f, "{id:<16}  {word:<13}  {}", self.outcome.found())
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Specification => f.write_str("specification"),
            Self::Firmware11 => f.write_str("firmware-1.1"),
            Self::Unknown => f.write_str("no dialect that can be told"),
            Self::Mixed {
                specification,
                firmware_1_1,
            } => write!(
                f,
                "a mixture: specification in {}; firmware-1.1 in {}",
                specification.join(", "),
                firmware_1_1.join(", ")
            ),
        }
    }
}

/// The first line of every report.
pub const HEADING: &str = "# Conformance of a Dobot controller";

const LEGEND: &str = "
`holds`: as the protocol says. `specification`, `firmware-1.1`: as only this dialect does. `DIFFERS`: as neither.
`unsteady`: not the same each time, or something got lost on the way.
Tables are those of the published protocol, notes (N1, N2 ...) stand in `docs/protocol.md`. Times are in seconds.

| check | what | by | outcome | found | time |
|---|---|---|---|---|---|
";
