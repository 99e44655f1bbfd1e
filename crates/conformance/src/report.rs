//! The report: a table and its summary.

use std::fmt::{self, Write};
use std::time::Duration;

use crate::blocker::Blocker;
use crate::check::Check;
use crate::latency::Latency;
use crate::outcome::Outcome;

/// The outcomes of all checks in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    rows: Vec<Row>,
    is_bluetooth: bool,
    latency: Option<Latency>,
    blocker: Option<Blocker>,
}

/// A check and its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The check.
    pub check: Check,
    /// The outcome.
    pub outcome: Outcome,
    /// The duration on the clock of the link.
    pub took: Duration,
}

/// The dialect of a controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The published specification (`Dialect::SPECIFICATION`).
    Specification,
    /// Stock arms (`Dialect::FIRMWARE_1_1`).
    Firmware11,
    /// A mixture, with the names of the checks.
    Mixed {
        /// Checks that fit the specification.
        specification: Vec<&'static str>,
        /// Checks that fit stock arms.
        firmware_1_1: Vec<&'static str>,
    },
    /// No check distinguished them.
    Unknown,
}

impl Report {
    pub(crate) const fn new(
        rows: Vec<Row>,
        is_bluetooth: bool,
        latency: Option<Latency>,
        blocker: Option<Blocker>,
    ) -> Self {
        Self {
            rows,
            is_bluetooth,
            latency,
            blocker,
        }
    }

    /// All rows, in the order of [`Check::ALL`].
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The outcome of a check.
    #[must_use]
    pub fn outcome(&self, id: &str) -> Option<&Outcome> {
        let row = self.rows.iter().find(|row| row.check.id == id);
        row.map(|row| &row.outcome)
    }

    /// The names of the checks that differ from the protocol.
    #[must_use]
    pub fn differing(&self) -> Vec<&'static str> {
        self.ids(Outcome::differs)
    }

    /// The names of the checks whose repetitions differ or that lost a packet.
    #[must_use]
    pub fn unsteady(&self) -> Vec<&'static str> {
        self.ids(|outcome| matches!(outcome, Outcome::Unsteady(_)))
    }

    /// Whether it is the Bluetooth port of a stock arm, detected from the statuses (note N38).
    #[must_use]
    pub const fn is_bluetooth(&self) -> bool {
        self.is_bluetooth
    }

    /// The latency of the line, if it could be measured.
    #[must_use]
    pub const fn latency(&self) -> Option<Latency> {
        self.latency
    }

    /// The reason why the arm was not moved although nothing differs.
    #[must_use]
    pub const fn blocker(&self) -> Option<&Blocker> {
        self.blocker.as_ref()
    }

    /// The dialect of the controller.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let specification = self.ids(|outcome| matches!(outcome, Outcome::Specification(_)));
        let firmware_1_1 = self.ids(|outcome| matches!(outcome, Outcome::Firmware11(_)));
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

    /// Whether all tried checks hold, in one dialect.
    #[must_use]
    pub fn conforms(&self) -> bool {
        let one_dialect = matches!(self.verdict(), Verdict::Specification | Verdict::Firmware11);
        one_dialect && self.differing().is_empty() && self.unsteady().is_empty()
    }

    /// A one-line summary: `46 hold, 4 not tried; speaks specification`.
    #[must_use]
    pub fn summary(&self) -> String {
        let differ = self.differing().len();
        let untried = self
            .ids(|outcome| matches!(outcome, Outcome::NotTried(_)))
            .len();
        let unsteady = self.unsteady().len();
        let hold = self.rows.len() - differ - untried - unsteady;
        let unsteady = match unsteady {
            0 => String::new(),
            count => format!(" {count} unsteady,"),
        };
        let port = if self.is_bluetooth {
            " over Bluetooth"
        } else {
            ""
        };
        format!(
            "{hold} hold, {differ} differ,{unsteady} {untried} not tried; speaks {}{port}",
            self.verdict()
        )
    }

    /// Returns the report as Markdown; equal outcomes give equal text.
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
            Self::Unknown => f.write_str("no dialect that can be determined"),
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
