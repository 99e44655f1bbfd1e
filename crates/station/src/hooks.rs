//! Webhooks and commands that receive events: the end of a job, a job that waits for a person, a lost
//! link.
//!
//! They run in a thread of their own and share nothing with the arm's thread but the notices, which
//! never wait for a reader. Only the file of the administrator sets them.

mod command;
mod config;
mod event;
mod sign;
mod web;

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{News, Notice};
use dobot_host::StationHandle;
use tokio::runtime;
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{broadcast, mpsc};

pub use self::config::HooksError;
pub(crate) use self::config::{Action, Hook, read};
use self::event::{Event, EventKind, event};

/// Starts the thread of the hooks; it ends with the station. No thread without hooks.
///
/// # Errors
///
/// The operating system's error if there is no thread.
pub(crate) fn start(hooks: Vec<Hook>, handle: StationHandle, page: String) -> std::io::Result<()> {
    if hooks.is_empty() {
        return Ok(());
    }
    // Subscribed before anything can happen.
    let notices = handle.notices();
    let runtime = runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    let work = move || runtime.block_on(follow(hooks, notices, &handle, &page, &RETRIES));
    std::thread::Builder::new()
        .name("dobot-hooks".into())
        .spawn(work)
        .map(drop)
}

/// Sends all events to all hooks until the station ends.
async fn follow(
    hooks: Vec<Hook>,
    mut notices: broadcast::Receiver<Arc<Notice>>,
    handle: &StationHandle,
    page: &str,
    retries: &'static [Duration],
) {
    let hooks = hooks.into_iter();
    let hooks: Vec<_> = hooks.map(|hook| queue(hook, handle, retries)).collect();
    loop {
        let notice = match notices.recv().await {
            Ok(notice) => notice,
            Err(RecvError::Lagged(missed)) => {
                let text = format!("the hooks missed {missed} notices");
                handle.try_report_trouble(text);
                continue;
            }
            Err(RecvError::Closed) => return,
        };
        let Some(event) = of_notice(&notice, handle, page).await else {
            continue;
        };
        offer(&hooks, &event, handle);
    }
}

/// The events that a hook receives, its label, and its queue.
struct QueuedHook {
    on: Vec<EventKind>,
    label: String,
    queue: mpsc::Sender<Event>,
}

/// Starts the task of a hook.
fn queue(hook: Hook, handle: &StationHandle, retries: &'static [Duration]) -> QueuedHook {
    let (queue, events) = mpsc::channel(QUEUE);
    let (on, label) = (hook.on.clone(), hook.label());
    tokio::spawn(deliver(hook, events, handle.clone(), retries));
    QueuedHook { on, label, queue }
}

/// Queues an event for all hooks that receive it.
fn offer(hooks: &[QueuedHook], event: &Event, handle: &StationHandle) {
    for QueuedHook { on, label, queue } in hooks {
        if on.contains(&event.kind) && queue.try_send(event.clone()).is_err() {
            let name = event.kind.name();
            handle.try_report_trouble(format!(
                "{label} does not receive {name}: {QUEUE} events wait for it already"
            ));
        }
    }
}

/// Returns the event of a notice, if it is one.
async fn of_notice(notice: &Notice, handle: &StationHandle, page: &str) -> Option<Event> {
    let job = match notice.news {
        News::Job { job, .. } | News::JobAsks { job } => {
            let jobs = handle.jobs().await.unwrap_or_default();
            jobs.into_iter().find(|view| view.job == job)
        }
        _ => None,
    };
    event(notice, job, page)
}

/// Delivers events in their order.
async fn deliver(
    hook: Hook,
    mut events: mpsc::Receiver<Event>,
    handle: StationHandle,
    retries: &'static [Duration],
) {
    while let Some(event) = events.recv().await {
        let delivered = match &hook.action {
            Action::Web(hook) => web::send(hook, &event, retries).await,
            Action::Command(command) => command::run(command.clone(), event.body.clone()).await,
        };
        if let Err(why) = delivered {
            let (label, name) = (hook.label(), event.kind.name());
            handle.try_report_trouble(format!("{label} did not receive {name}: {why}"));
        }
    }
}

/// The maximum number of events that wait for a hook.
const QUEUE: usize = 32;
/// The pauses before each repetition of a webhook.
const RETRIES: [Duration; 4] = [
    Duration::from_secs(1),
    Duration::from_secs(10),
    Duration::from_secs(60),
    Duration::from_secs(300),
];

#[cfg(test)]
mod tests;
