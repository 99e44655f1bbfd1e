//! How far the planning of a drawing is, on a terminal.

use std::io::{IsTerminal, stderr};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use dobot_draw::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::follow::share_style;

/// Does a piece of work that tells how far it is. Where that takes longer than a moment, a terminal shows it, and how
/// long the arm will take where that is long; what it shows is gone before this is over.
pub(super) fn shown<T>(progress: &Progress, shown: Shown, work: impl FnOnce() -> T) -> T {
    if shown == Shown::Nothing || !stderr().is_terminal() {
        return work();
    }
    thread::scope(|scope| {
        // Gone with the work, even where that panics.
        let (working, over) = channel::<()>();
        scope.spawn(move || {
            let mut screen = Screen {
                bar: None,
                tells_hours: shown == Shown::StepsAndHours,
            };
            while over.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
                screen.show(progress);
            }
            screen.end(progress);
        });
        let done = work();
        drop(working);
        done
    })
}

/// What a terminal is to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shown {
    Nothing,
    /// What is being done, and how far that is.
    Steps,
    /// Also how many hours the arm will take, where nobody has said it yet.
    StepsAndHours,
}

/// What the terminal shows.
struct Screen {
    bar: Option<ProgressBar>,
    /// It is still to be told how long the arm will take.
    tells_hours: bool,
}

impl Screen {
    fn show(&mut self, progress: &Progress) {
        let bar = self.bar.get_or_insert_with(|| ProgressBar::new(PARTS));
        if let Some(line) = untold(&mut self.tells_hours, progress) {
            bar.println(line);
        }
        let step = progress.step();
        if let Some(share) = progress.share() {
            bar.set_style(share_style());
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                clippy::cast_precision_loss,
                reason = "a share of a thousand"
            )]
            bar.set_position((share * PARTS as f64) as u64);
            bar.set_message(format!("{step}, {:.0} %", share * 100.0));
        } else {
            bar.set_style(ProgressStyle::default_spinner());
            bar.set_message(step.to_string());
        }
        bar.tick();
    }

    fn end(&mut self, progress: &Progress) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        if let Some(line) = untold(&mut self.tells_hours, progress) {
            eprintln!("{line}");
        }
    }
}

/// What is to be said of a long drawing, once.
fn untold(tells_hours: &mut bool, progress: &Progress) -> Option<String> {
    let line = progress
        .roughly_s()
        .filter(|_| *tells_hours)
        .and_then(hours);
    *tells_hours &= line.is_none();
    line
}

/// What is said of a long drawing before it is planned.
fn hours(roughly_s: f64) -> Option<String> {
    let hours = roughly_s / 3600.0;
    (hours > 1.0).then(|| {
        let hours = hours.round();
        let plural = if hours > 1.0 { "s" } else { "" };
        format!("about {hours} hour{plural} of drawing, by a rough estimate before it is planned")
    })
}

/// How often it is shown, and what takes no longer is not.
const PERIOD: Duration = Duration::from_millis(250);
const PARTS: u64 = 1000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_takes_longer_than_an_hour_is_told_before_it_is_planned() {
        assert_eq!(hours(3500.0), None);
        for (roughly_s, told) in [
            (4000.0, "about 1 hour of"),
            (147_000.0, "about 41 hours of"),
        ] {
            let line = hours(roughly_s).expect("it is long");
            assert!(line.starts_with(told), "{line}");
        }
    }
}
