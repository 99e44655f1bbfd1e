//! The progress of planning on a terminal.

use std::io::{IsTerminal, stderr};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use dobot_draw::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::follow::share_style;
use crate::output;

/// Runs work that reports its progress, which a terminal shows if the work takes longer, with the duration of a long
/// drawing. The progress is cleared at the end.
pub(super) fn shown<T>(progress: &Progress, is_hidden: bool, work: impl FnOnce() -> T) -> T {
    if is_hidden || !stderr().is_terminal() {
        return work();
    }
    thread::scope(|scope| {
        // Dropped with the work, even if it panics.
        let (working, over) = channel::<()>();
        scope.spawn(move || {
            let mut screen = Screen {
                bar: None,
                shows_hours: true,
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

/// The progress on the terminal.
struct Screen {
    bar: Option<ProgressBar>,
    /// Whether the hours are still to be shown.
    shows_hours: bool,
}

impl Screen {
    fn show(&mut self, progress: &Progress) {
        let bar = self.bar.get_or_insert_with(|| ProgressBar::new(PARTS));
        if let Some(line) = take_line(&mut self.shows_hours, progress) {
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
        if let Some(line) = take_line(&mut self.shows_hours, progress) {
            eprintln!("{line}");
        }
    }
}

/// Returns the line about a long drawing, once.
fn take_line(shows_hours: &mut bool, progress: &Progress) -> Option<String> {
    let line = progress
        .roughly_s()
        .filter(|_| *shows_hours)
        .and_then(hours);
    *shows_hours &= line.is_none();
    line
}

/// Formats the line about a long drawing.
fn hours(roughly_s: f64) -> Option<String> {
    let hours = roughly_s / 3600.0;
    (hours > 1.0).then(|| {
        let hours = hours.round();
        let hours = output::count(hours, "hour");
        format!("about {hours} of drawing (rough estimate before planning)")
    })
}

/// The update period; shorter work shows nothing.
const PERIOD: Duration = Duration::from_millis(250);
const PARTS: u64 = 1000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_preparations_longer_than_an_hour_are_announced() {
        assert_eq!(hours(3500.0), None);
        for (roughly_s, text) in [
            (4000.0, "about 1 hour of"),
            (147_000.0, "about 41 hours of"),
        ] {
            let line = hours(roughly_s).expect("it is long");
            assert!(line.starts_with(text), "{line}");
        }
    }
}
