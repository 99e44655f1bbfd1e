//! The report: findings, as text or JSON.

use std::fmt;

use dobot_api::Folders;
use serde::Serialize;

/// What was found on this machine.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Report {
    /// Program, system and processor.
    pub(super) machine: String,
    pub(super) findings: Vec<Finding>,
}

/// The result of one check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Finding {
    pub(super) check: &'static str,
    pub(super) health: Health,
    pub(super) text: String,
    /// What to do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) remedy: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Health {
    Ok,
    /// It may become a problem.
    Note,
    Bad,
}

impl Finding {
    pub(super) fn ok(check: &'static str, text: impl Into<String>) -> Self {
        Self {
            check,
            health: Health::Ok,
            text: text.into(),
            remedy: None,
        }
    }

    pub(super) fn note(
        check: &'static str,
        text: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            health: Health::Note,
            remedy: Some(remedy.into()),
            ..Self::ok(check, text)
        }
    }

    pub(super) fn bad(
        check: &'static str,
        text: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            health: Health::Bad,
            ..Self::note(check, text, remedy)
        }
    }
}

impl Report {
    /// The number of failed checks.
    pub(super) fn failed(&self) -> usize {
        let bad = |finding: &&Finding| finding.health == Health::Bad;
        self.findings.iter().filter(bad).count()
    }

    /// Replaces the data folder and the home folder, whose names may be those of people.
    pub(super) fn without_paths(self, folders: &Folders) -> Self {
        let home = std::env::home_dir().map(|home| home.display().to_string());
        let mut names = vec![(folders.data().display().to_string(), "DATA")];
        names.extend(home.filter(|home| home.len() > 1).map(|home| (home, "~")));
        let plain = |text: String| {
            let replaced = names.iter();
            replaced.fold(text, |text, (name, mark)| text.replace(name, mark))
        };
        let findings = self.findings.into_iter().map(|finding| Finding {
            text: plain(finding.text),
            remedy: finding.remedy.map(plain),
            ..finding
        });
        Self {
            findings: findings.collect(),
            ..self
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.machine)?;
        for finding in &self.findings {
            let health = match finding.health {
                Health::Ok => "ok",
                Health::Note => "note",
                Health::Bad => "bad",
            };
            write!(f, "\n{health:4}  {:12}  {}", finding.check, finding.text)?;
            if let Some(remedy) = &finding.remedy {
                write!(f, "\n{:18}  {remedy}", "")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_names_no_folder_of_a_person() {
        let report = Report {
            machine: "dobot 0.1.0".into(),
            findings: vec![Finding::bad(
                "disk",
                "/srv/anna/journal.redb is full",
                "move /srv/anna to another disk",
            )],
        };
        let text = report.without_paths(&Folders::at("/srv/anna")).to_string();
        assert_eq!(
            text,
            "dobot 0.1.0\nbad   disk          DATA/journal.redb is full\n                    move DATA to another disk"
        );
    }
}
