//! The log of all crates through `tracing`, on standard error.

use std::env::VarError;

use tracing::Level;
use tracing_subscriber::Layer;
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;

use crate::stderr;

/// The format of the log.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum LogFormat {
    /// Lines for people
    #[default]
    Text,
    /// One JSON object per line, for services; level info and above unless `RUST_LOG` sets another
    Json,
}

impl LogFormat {
    /// Starts the log with the levels in the environment variable `RUST_LOG`. An invalid value is reported
    /// and ignored.
    pub(crate) fn start(self) {
        let (targets, problem) = match self.targets(std::env::var("RUST_LOG")) {
            Ok(targets) => (targets, None),
            Err(problem) => (self.default_targets(), Some(problem)),
        };
        let lines = tracing_subscriber::fmt::layer().with_writer(|| stderr::Lines);
        let lines = match self {
            Self::Text => lines.with_ansi(false).boxed(),
            Self::Json => lines.json().flatten_event(true).boxed(),
        };
        tracing_subscriber::registry()
            .with(lines.with_filter(targets))
            .init();
        if let Some(problem) = problem {
            match self {
                Self::Text => stderr::line(&problem),
                Self::Json => tracing::warn!("{problem}"),
            }
        }
    }

    /// Reports what the program does, as a line or as an event.
    pub(crate) fn report(self, text: &str) {
        match self {
            Self::Text => stderr::line(text),
            Self::Json => tracing::info!("{text}"),
        }
    }

    /// Whether to print the notices of a station; not if the log contains them.
    pub(crate) fn shows_notices(self) -> bool {
        self == Self::Text && !tracing::enabled!(target: "dobot_host", Level::INFO)
    }

    fn targets(self, wanted: Result<String, VarError>) -> Result<Targets, String> {
        match wanted {
            Ok(wanted) => wanted
                .parse()
                .map_err(|error| not_understood(&wanted, &error)),
            Err(VarError::NotPresent) => Ok(self.default_targets()),
            Err(error) => Err(not_understood("", &error)),
        }
    }

    fn default_targets(self) -> Targets {
        Targets::new().with_default(match self {
            Self::Text => LevelFilter::OFF,
            Self::Json => LevelFilter::INFO,
        })
    }
}

fn not_understood(wanted: &str, error: &dyn std::error::Error) -> String {
    format!(
        "RUST_LOG is \"{}\", which is invalid ({error}) and is ignored; expected a level (off, error, warn, info, debug, \
         trace), or levels of crates, as in dobot_host=debug,dobot_station=info",
        wanted.escape_debug()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wants(format: LogFormat, wanted: &str, target: &str, level: Level) -> bool {
        let targets = format
            .targets(Ok(wanted.to_owned()))
            .expect("it is understood");
        targets.would_enable(target, &level)
    }

    #[test]
    fn the_log_for_people_is_quiet_by_default() {
        let quiet = LogFormat::Text
            .targets(Err(VarError::NotPresent))
            .expect("it is understood");
        assert!(!quiet.would_enable("dobot_host", &Level::ERROR));
        assert!(wants(LogFormat::Text, "info", "dobot_host", Level::INFO));
        assert!(!wants(LogFormat::Text, "info", "dobot_host", Level::DEBUG));
    }

    #[test]
    fn the_log_of_a_service_starts_at_info() {
        let service = LogFormat::Json
            .targets(Err(VarError::NotPresent))
            .expect("it is understood");
        assert!(service.would_enable("dobot_station::http", &Level::INFO));
        assert!(!service.would_enable("dobot_station::http", &Level::DEBUG));
        assert!(!wants(LogFormat::Json, "warn", "dobot_host", Level::INFO));
    }

    #[test]
    fn each_crate_may_have_its_own_level() {
        let wanted = "warn,dobot_host=debug";
        let (rules, station) = ("dobot_host::driver", "dobot_station::http");
        assert!(wants(LogFormat::Text, wanted, rules, Level::DEBUG));
        assert!(!wants(LogFormat::Text, wanted, station, Level::INFO));
        assert!(wants(LogFormat::Text, wanted, station, Level::WARN));
    }

    #[test]
    fn an_unknown_level_is_reported_with_the_known_ones() {
        let problem = LogFormat::Text
            .targets(Ok("dobot_host=loud".into()))
            .expect_err("it is not");
        assert!(
            problem.contains("\"dobot_host=loud\"") && problem.contains("debug"),
            "{problem}"
        );
    }
}
