//! The driver's lines in the log (`tracing`).

use dobot_api::{News, Notice};

/// Logs a notice: as a warning if a person should look at the arm, and the end of each command at
/// debug level.
pub(super) fn log(notice: &Notice) {
    let Notice {
        number, news, text, ..
    } = notice;
    match news {
        News::LinkLost
        | News::NoLink { .. }
        | News::Reset
        | News::CommandFailed { .. }
        | News::Stopped
        | News::DeadMan
        | News::Trouble => tracing::warn!(notice = number, ?news, "{text}"),
        News::CommandDone { .. } => tracing::debug!(notice = number, ?news, "{text}"),
        _ => tracing::info!(notice = number, ?news, "{text}"),
    }
}
