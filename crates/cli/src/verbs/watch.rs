//! `dobot watch`: a dashboard in the terminal.

pub(crate) mod dashboard;
pub(crate) mod panels;

use std::io::{IsTerminal, stdout};
use std::time::Duration;

use anyhow::anyhow;
use crossterm::event::{
    DisableBracketedPaste, EnableBracketedPaste, Event, EventStream, KeyCode, KeyEvent,
    KeyEventKind, KeyModifiers,
};
use crossterm::execute;
use dobot_api::{
    ConnectError, EpisodeMark, Notice, Remote, RemoteError, Request, StationAddress, StationEvent,
    fetch,
};
use futures_util::StreamExt;
use ratatui::DefaultTerminal;
use tokio::time::Instant;

use self::dashboard::{View, draw};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::pendant::{IGNORED, PasteFilter, wait_until};
use crate::reach::{Station, client_name};

/// Watch arm, link, job, control and events; stop the arm with a key
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot watch
  dobot watch --station https://lab.example:8642 --fingerprint 5e:aa:...

Keys: s or space stops the arm, r clears the stop (y confirms), q quits;
b begins an episode in the recording, e ends it, x discards it.
If the station goes away, the dashboard waits for it to return.")]
pub(crate) struct Args {
    #[command(flatten)]
    station: Station,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    if !stdout().is_terminal() {
        return Err(Failure::new(
            anyhow!("the dashboard needs a terminal"),
            "use `dobot status --json` in a program",
        ));
    }
    let address = args.station.address_of_running().await?;
    // An unreachable station is reported as by every other verb.
    let connected = connect(&address).await?;
    // From here on, a panic also restores the terminal.
    let terminal = ratatui::try_init()?;
    execute!(stdout(), EnableBracketedPaste)?;
    let left = Watch::new(terminal, address).run(connected).await;
    let _ = execute!(stdout(), DisableBracketedPaste);
    ratatui::restore();
    left
}

/// A connection to a station, and its recent notices.
struct Connected {
    remote: Remote,
    notices: Vec<Notice>,
}

async fn connect(address: &StationAddress) -> Result<Connected, ConnectError> {
    let remote = Remote::connect(address, &client_name("watch")).await?;
    let notices = fetch(address, "/api/v1/notices").await?;
    Ok(Connected { remote, notices })
}

/// The dashboard on a terminal.
struct Watch {
    terminal: DefaultTerminal,
    keys: EventStream,
    address: StationAddress,
    view: View,
}

/// The action of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum KeyAction {
    Stop,
    /// Show the question whether to clear the stop.
    Ask,
    Reset,
    Mark(EpisodeMark),
    Nothing,
    Quit,
}

impl Watch {
    fn new(terminal: DefaultTerminal, address: StationAddress) -> Self {
        Self {
            terminal,
            keys: EventStream::new(),
            view: View {
                station: address.to_string(),
                ..View::default()
            },
            address,
        }
    }

    /// Runs until the person quits; reconnects to a station that goes away.
    async fn run(mut self, connected: Connected) -> Result<(), Failure> {
        let mut interrupt = std::pin::pin!(interrupt());
        let mut remote = Some(self.accept(connected));
        let (began, mut filter) = (Instant::now(), PasteFilter::default());
        loop {
            let mut events = Vec::new();
            self.terminal.draw(|frame| draw(frame, &self.view))?;
            let is_connected = remote.is_some();
            tokio::select! {
                event = next_event(&mut remote) => self.handle_event(&mut remote, event),
                event = self.keys.next() => {
                    let Some(event) = event.transpose()? else { return Ok(()) };
                    events = filter.handle_event(began.elapsed(), event);
                }
                () = wait_until(began, filter.poll_wakeup()) => {
                    events.extend(filter.handle_time(began.elapsed()));
                }
                back = reconnect(&self.address, is_connected) => remote = Some(self.accept(back)),
                () = &mut interrupt => return Ok(()),
            }
            for event in events {
                match action_of(&event, self.view.asks) {
                    KeyAction::Quit => return Ok(()),
                    action => self.perform(&mut remote, action).await,
                }
            }
            if filter.take_discarded() {
                self.view.answer = Some(IGNORED.to_owned());
            }
        }
    }

    fn accept(&mut self, connected: Connected) -> Remote {
        self.view.handle_history(connected.notices);
        connected.remote
    }

    fn handle_event(
        &mut self,
        remote: &mut Option<Remote>,
        event: Result<StationEvent, RemoteError>,
    ) {
        match event {
            Ok(StationEvent::State(state)) => {
                self.view.state = Some(*state);
                self.view.lost = None;
            }
            Ok(StationEvent::Notice(notice)) => self.view.handle_notice(notice),
            Err(error) => self.lose(remote, &error),
        }
    }

    fn lose(&mut self, remote: &mut Option<Remote>, error: &RemoteError) {
        *remote = None;
        self.view.lost = Some(error.to_string());
    }

    /// Carries out the action of a key.
    async fn perform(&mut self, remote: &mut Option<Remote>, action: KeyAction) {
        self.view.asks = action == KeyAction::Ask;
        let request = match action {
            KeyAction::Stop => Request::Stop {
                reason: Some("a key was pressed in `dobot watch`".into()),
            },
            KeyAction::Reset => Request::ResetStop,
            KeyAction::Mark(mark) => Request::MarkEpisode { mark, task: None },
            KeyAction::Ask | KeyAction::Nothing | KeyAction::Quit => return,
        };
        let Some(station) = remote else {
            self.view.answer = Some("not sent: no station".into());
            return;
        };
        self.view.answer = match station.request(request).await {
            Ok(_) => None,
            Err(error @ RemoteError::Refused(_)) => Some(error.to_string()),
            Err(error) => {
                self.lose(remote, &error);
                Some("no answer".into())
            }
        };
    }
}

/// Waits for the next event of the station; forever while there is none.
async fn next_event(remote: &mut Option<Remote>) -> Result<StationEvent, RemoteError> {
    match remote {
        Some(remote) => remote.next().await,
        None => std::future::pending().await,
    }
}

/// Reconnects to the station once it is back.
async fn reconnect(address: &StationAddress, is_connected: bool) -> Connected {
    if is_connected {
        std::future::pending::<()>().await;
    }
    loop {
        tokio::time::sleep(PAUSE).await;
        if let Ok(connected) = connect(address).await {
            return connected;
        }
    }
}

/// Maps a key to its action, depending on whether a question is shown.
fn action_of(event: &Event, asks: bool) -> KeyAction {
    let key = match event {
        Event::Key(key) if key.kind != KeyEventKind::Release => key,
        // A resize answers no question.
        _ if asks => return KeyAction::Ask,
        _ => return KeyAction::Nothing,
    };
    match key.code {
        KeyCode::Char('c') if is_control(key) => KeyAction::Quit,
        KeyCode::Char('s' | 'S' | ' ') => KeyAction::Stop,
        KeyCode::Char('r' | 'R') => KeyAction::Ask,
        KeyCode::Char('y' | 'Y') if asks => KeyAction::Reset,
        KeyCode::Char('q' | 'Q') => KeyAction::Quit,
        KeyCode::Char('b' | 'B') if !asks => KeyAction::Mark(EpisodeMark::Begin),
        KeyCode::Char('e' | 'E') if !asks => KeyAction::Mark(EpisodeMark::End),
        KeyCode::Char('x' | 'X') if !asks => KeyAction::Mark(EpisodeMark::Discard),
        _ => KeyAction::Nothing,
    }
}

fn is_control(key: &KeyEvent) -> bool {
    key.modifiers.contains(KeyModifiers::CONTROL)
}

const PAUSE: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests {
    use super::*;

    fn key(code: KeyCode) -> Event {
        Event::Key(KeyEvent::new(code, KeyModifiers::NONE))
    }

    #[test]
    fn space_and_s_stop_during_any_question() {
        for asks in [false, true] {
            for code in [' ', 's', 'S'] {
                assert_eq!(action_of(&key(KeyCode::Char(code)), asks), KeyAction::Stop);
            }
        }
    }

    #[test]
    fn a_stop_is_reset_only_by_a_yes_to_the_question() {
        assert_eq!(
            action_of(&key(KeyCode::Char('y')), false),
            KeyAction::Nothing
        );
        assert_eq!(action_of(&key(KeyCode::Char('r')), false), KeyAction::Ask);
        assert_eq!(action_of(&key(KeyCode::Char('y')), true), KeyAction::Reset);
        for code in [KeyCode::Char('n'), KeyCode::Enter, KeyCode::Esc] {
            assert_eq!(action_of(&key(code), true), KeyAction::Nothing, "{code:?}");
        }
    }

    #[test]
    fn q_and_control_c_leave() {
        let control_c = KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL);
        assert_eq!(action_of(&Event::Key(control_c), false), KeyAction::Quit);
        assert_eq!(action_of(&key(KeyCode::Char('q')), false), KeyAction::Quit);
    }

    #[test]
    fn a_resize_answers_no_question() {
        assert_eq!(action_of(&Event::Resize(80, 24), false), KeyAction::Nothing);
        assert_eq!(action_of(&Event::Resize(80, 24), true), KeyAction::Ask);
    }
}
