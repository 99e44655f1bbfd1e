//! A pendant in the terminal: the arm moves while a key is held, and stops when it is released.

mod gamepad;
mod hold;
mod keys;
mod mouse;
mod paste;
mod screen;
mod session;
mod terminal;

use std::collections::VecDeque;
use std::time::Duration;

use crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind};
use dobot_api::{Button, ClientId, JogFrame, News, Notice, Reply, Request, State};
use dobot_wire::{JointJog, JointJogAxis, Status};

use self::gamepad::{EVENT_LEN, Gamepad, PadAction};
use self::hold::{Beat, HoldToRun};
use self::keys::{KeyMeaning, folded, meaning};

pub(crate) use self::gamepad::PadArgs;
pub(crate) use self::hold::KeyReports;
pub(crate) use self::mouse::Mouse;
pub(crate) use self::paste::{IGNORED, PasteFilter};
pub(crate) use self::screen::{answer, draw_top, key_line, move_lines};
pub(crate) use self::session::{Panel, run, wait_until};
pub(crate) use self::terminal::check_terminal;

/// The pendant as an engine: it takes events of the terminal and of the station, and returns requests.
/// The caller passes the time since the start.
#[derive(Debug)]
pub(crate) struct Pendant {
    client: ClientId,
    hold: HoldToRun<Source, Button>,
    pad: Gamepad,
    /// The fraction of the speed that the gamepad asks for.
    pad_share: f32,
    drive: Drive,
    frame: JogFrame,
    /// The step of a press in mm or degrees; `None` if the arm moves while a key is held.
    step: Option<f32>,
    speed_percent: f32,
    state: Option<State>,
    asks: Option<Question>,
    answer: Option<String>,
    requests: VecDeque<Request>,
    is_over: bool,
}

/// The kind of commands that move the arm.
#[derive(Debug)]
pub(crate) enum Drive {
    /// Jogs (states 2 and 7).
    Jog,
    /// Mouse packets (state 1).
    Mouse(Mouse),
}

/// The input device that holds a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    Key(KeyCode),
    Pad,
}

/// A question to the person before the arm may move again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Question {
    /// Whether to clear the stop.
    Reset,
    /// Whether the arm has the pose that it reports.
    Confirm,
}

impl Pendant {
    /// Creates the pendant of a client, at half speed. `dead_man` is the time after which a jog button is
    /// released without a further request.
    pub(crate) const fn new(
        client: ClientId,
        keys: KeyReports,
        dead_man: Duration,
        drive: Drive,
    ) -> Self {
        Self {
            client,
            hold: HoldToRun::new(keys, dead_man),
            pad: Gamepad::new(),
            pad_share: 1.0,
            drive,
            frame: JogFrame::Linear,
            step: None,
            speed_percent: 50.0,
            state: None,
            asks: None,
            answer: None,
            requests: VecDeque::new(),
            is_over: false,
        }
    }

    /// Handles an event of the terminal.
    pub(crate) fn handle_event(&mut self, now: Duration, event: &Event) {
        match event {
            Event::Key(key) if key.kind == KeyEventKind::Release => {
                self.hold.handle_release(&Source::Key(folded(key.code)));
            }
            Event::Key(key) => self.handle_key(now, key),
            // Without focus the person does not see this window.
            Event::FocusLost => self.hold.release(),
            _ => {}
        }
    }

    /// Handles an event of the gamepad; `None` after it was disconnected.
    pub(crate) fn handle_pad(&mut self, now: Duration, event: Option<[u8; EVENT_LEN]>) {
        let Some(event) = event else {
            self.hold.handle_release(&Source::Pad);
            self.answer = Some("the gamepad was disconnected".into());
            return;
        };
        match self.pad.handle(event) {
            Some(PadAction::Hold(button, share)) => {
                self.pad_share = share;
                self.press(now, Source::Pad, button);
            }
            Some(PadAction::Release) => self.hold.handle_release(&Source::Pad),
            Some(PadAction::Suction(on)) => {
                self.hold.release();
                self.switch_suction(on);
            }
            Some(PadAction::Stop) => {
                self.hold.release();
                self.stop();
            }
            None => {}
        }
    }

    /// Handles a state of the station.
    pub(crate) fn handle_state(&mut self, state: State) {
        self.state = Some(state);
    }

    /// Handles a notice of the station.
    pub(crate) fn handle_notice(&mut self, notice: Notice) {
        if let Drive::Mouse(mouse) = &mut self.drive {
            mouse.handle_news(&notice.news);
        }
        let hinders = match notice.news {
            News::Refused { client, .. } => client == self.client,
            News::DeadMan
            | News::LinkLost
            | News::NoLink { .. }
            | News::Stopped
            | News::CommandFailed { .. } => true,
            _ => false,
        };
        if hinders {
            self.hold.handle_refused();
            self.answer = Some(notice.text);
        }
    }

    /// Handles a reply of the station.
    pub(crate) fn handle_reply(&mut self, reply: &Reply) {
        if let (Drive::Mouse(mouse), Reply::Accepted { command, .. }) = (&mut self.drive, reply) {
            mouse.handle_accepted(*command);
        }
    }

    /// Handles the refusal of a request.
    pub(crate) fn handle_refused(&mut self, request: &Request, why: String) {
        if matches!(request, Request::Jog { .. } | Request::Command { .. }) {
            self.hold.handle_refused();
        }
        self.answer = Some(why);
    }

    /// Queues a request to the station.
    pub(crate) fn send(&mut self, request: Request) {
        self.requests.push_back(request);
    }

    /// Shows a text to the person.
    pub(crate) fn show(&mut self, text: String) {
        self.answer = Some(text);
    }

    /// Removes the shown text.
    pub(crate) fn clear(&mut self) {
        self.answer = None;
    }

    /// Releases the held button.
    pub(crate) fn release(&mut self) {
        self.hold.release();
    }

    /// The last state of the station.
    pub(crate) const fn state(&self) -> Option<&State> {
        self.state.as_ref()
    }

    /// Returns the status of an arm that is at rest with a confirmed pose, or the reason why there is none.
    pub(crate) fn status_at_rest(&self, untrusted: &'static str) -> Result<&Status, &'static str> {
        let state = self.state().ok_or("no status of the arm yet")?;
        if !state.trust.trusted {
            return Err(untrusted);
        }
        match &state.arm {
            Some(arm) if arm.moving => Err("the arm is moving"),
            Some(arm) => Ok(&arm.status),
            None => Err("no status of the arm yet"),
        }
    }

    /// Advances to a time.
    pub(crate) fn handle_time(&mut self, now: Duration) {
        // A held stick sends no events, but the device reports when it is disconnected.
        self.hold.handle_still(now, &Source::Pad);
        self.hold.handle_time(now);
    }

    /// Ends the pendant, and releases the held button.
    pub(crate) fn quit(&mut self) {
        self.hold.release();
        self.is_over = true;
    }

    /// Returns the next request to the station.
    pub(crate) fn poll_request(&mut self, now: Duration) -> Option<Request> {
        loop {
            if let Some(request) = self.requests.pop_front() {
                return Some(request);
            }
            let beat = self.hold.poll(now)?;
            self.requests.extend(self.driven(beat));
        }
    }

    /// Returns the time at which to call [`handle_time`](Self::handle_time) next.
    pub(crate) fn poll_wakeup(&self) -> Option<Duration> {
        self.hold.poll_wakeup()
    }

    /// Whether the person has quit and no request is left.
    pub(crate) const fn is_over(&self) -> bool {
        self.is_over
    }

    fn handle_key(&mut self, now: Duration, key: &KeyEvent) {
        let meaning = meaning(key, self.frame, self.question().is_some());
        let asked = self.asks.take();
        if !matches!(meaning, KeyMeaning::Hold(_) | KeyMeaning::Speed(_)) {
            self.hold.release();
        }
        match meaning {
            KeyMeaning::Stop => self.stop(),
            KeyMeaning::Hold(button) => match self.step {
                None => self.press(now, Source::Key(folded(key.code)), button),
                Some(size) if key.kind == KeyEventKind::Press => self.step(button, size),
                // A repeated key makes no further step.
                Some(_) => {}
            },
            KeyMeaning::Steps => self.change_step(),
            KeyMeaning::Speed(percent) => self.speed_percent = percent,
            KeyMeaning::Suction(on) => self.switch_suction(on),
            KeyMeaning::Frame => self.change_frame(),
            KeyMeaning::Ask => self.asks = self.question(),
            KeyMeaning::Yes => self.requests.extend(asked.map(Question::request)),
            KeyMeaning::Quit => self.quit(),
            KeyMeaning::Nothing => {}
        }
    }

    /// The question that must be answered before the arm may move.
    fn question(&self) -> Option<Question> {
        let state = self.state.as_ref()?;
        if state.stop.is_some() {
            return Some(Question::Reset);
        }
        (state.arm.is_some() && !state.trust.trusted).then_some(Question::Confirm)
    }

    /// Stops the arm; requests that were not sent yet are dropped.
    fn stop(&mut self) {
        self.requests.clear();
        self.requests.push_back(Request::Stop {
            reason: Some("a key was pressed on the pendant".into()),
        });
        self.answer = None;
    }

    fn press(&mut self, now: Duration, source: Source, button: Button) {
        if let (Drive::Mouse(_), Err(why)) = (&self.drive, Mouse::check(button)) {
            self.answer = Some(why.to_owned());
            return;
        }
        if self.hold.button() != Some(button) {
            self.answer = None;
        }
        self.hold.handle_press(now, source, button);
    }

    /// Switches the pump.
    pub(crate) fn switch_suction(&mut self, on: bool) {
        let axis = if on {
            JointJogAxis::SuctionOn
        } else {
            JointJogAxis::SuctionOff
        };
        let command = JointJog::new(axis, 0.0).into();
        self.send(Request::Command { command });
    }

    /// Moves an arm at rest by one step.
    fn step(&mut self, button: Button, size: f32) {
        let untrusted = "the pose is not confirmed; press r, look, and press y";
        match self.status_at_rest(untrusted) {
            Ok(status) if button.step(status, size).is_some() => {
                self.answer = None;
                self.send(Request::Step { button, by: size });
            }
            Ok(_) => self.show("no step: this key must be held; press . to leave step mode".into()),
            Err(why) => self.show(format!("no step: {why}")),
        }
    }

    /// Toggles between steps and continuous motion.
    pub(crate) fn change_step(&mut self) {
        self.step = match self.step {
            None if matches!(self.drive, Drive::Jog) => Some(STEPS[0]),
            Some(size) if size == STEPS[0] => Some(STEPS[1]),
            _ => None,
        };
    }

    fn change_frame(&mut self) {
        self.frame = match self.frame {
            JogFrame::Linear if matches!(self.drive, Drive::Jog) => JogFrame::Joint,
            _ => JogFrame::Linear,
        };
    }

    /// The current speed in percent; proportional to the deflection of a stick.
    fn speed_now(&self) -> f32 {
        let by_pad = self.hold.is_held_by(&Source::Pad);
        let share = if by_pad { self.pad_share } else { 1.0 };
        (self.speed_percent * share).max(1.0)
    }

    /// The request for a button that is held or released.
    fn driven(&self, beat: Beat<Button>) -> Option<Request> {
        match (&self.drive, beat) {
            (Drive::Jog, Beat::Hold(button)) => Some(Request::Jog {
                jog: button.jog(self.speed_now()),
            }),
            (Drive::Jog, Beat::Release) => Some(Request::Release),
            (Drive::Mouse(mouse), Beat::Hold(button)) => {
                let command = mouse.packet(button, self.speed_now(), self.state.as_ref()?)?;
                Some(Request::Command { command })
            }
            (Drive::Mouse(_), Beat::Release) => None,
        }
    }
}

impl Question {
    const fn request(self) -> Request {
        match self {
            Self::Reset => Request::ResetStop,
            Self::Confirm => Request::ConfirmPose,
        }
    }
}

/// The step sizes in mm or degrees; the second one is for touching a point.
const STEPS: [f32; 2] = [1.0, 0.1];

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use crossterm::event::KeyModifiers;
    use dobot_api::Jog;
    use dobot_wire::{Command, Dialect, LinearJog, LinearJogAxis, MouseMove};

    use super::*;

    fn pendant(drive: Drive) -> Pendant {
        Pendant::new(ClientId(7), KeyReports::Presses, DEAD_MAN, drive)
    }

    fn press(code: KeyCode) -> Event {
        Event::Key(KeyEvent::new(code, KeyModifiers::NONE))
    }

    /// All that is asked for at a time.
    fn asked(it: &mut Pendant, now: Duration) -> Vec<Request> {
        it.handle_time(now);
        std::iter::from_fn(|| it.poll_request(now)).collect()
    }

    /// All that is asked for after a key.
    fn keyed(it: &mut Pendant, now: Duration, code: KeyCode) -> Vec<Request> {
        it.handle_event(now, &press(code));
        asked(it, now)
    }

    fn forward(speed_percent: f32) -> Request {
        let jog = Jog::Linear(LinearJog::new(LinearJogAxis::XPlus, speed_percent));
        Request::Jog { jog }
    }

    #[test]
    fn an_arrow_jogs_until_it_stops_repeating() {
        let mut it = pendant(Drive::Jog);
        assert_eq!(keyed(&mut it, Duration::ZERO, KeyCode::Up), [forward(50.0)]);
        assert_eq!(it.poll_wakeup(), Some(DEAD_MAN / 3));
        assert_eq!(asked(&mut it, DEAD_MAN), [Request::Release]);
        assert_eq!(it.poll_wakeup(), None);
    }

    #[test]
    fn a_stop_is_sent_first_and_nothing_follows_it() {
        let mut it = pendant(Drive::Jog);
        it.handle_event(Duration::ZERO, &press(KeyCode::Char('u')));
        it.handle_event(Duration::ZERO, &press(KeyCode::Up));
        let all = keyed(&mut it, Duration::ZERO, KeyCode::Char(' '));
        assert!(
            matches!(all[..], [Request::Stop { .. }, Request::Release]),
            "{all:?}"
        );
        assert_eq!(asked(&mut it, DEAD_MAN), []);
    }

    #[test]
    fn a_new_speed_applies_from_the_next_beat() {
        let mut it = pendant(Drive::Jog);
        keyed(&mut it, Duration::ZERO, KeyCode::Char('3'));
        assert_eq!(keyed(&mut it, Duration::ZERO, KeyCode::Up), [forward(30.0)]);
        keyed(&mut it, Duration::ZERO, KeyCode::Char('9'));
        assert_eq!(asked(&mut it, DEAD_MAN / 3), [forward(90.0)]);
    }

    #[test]
    fn steps_move_the_arm_once_by_each_press_and_a_moving_arm_not_at_all() {
        let mut it = pendant(Drive::Jog);
        it.handle_state(State::sample());
        keyed(&mut it, Duration::ZERO, KeyCode::Char('.'));
        keyed(&mut it, Duration::ZERO, KeyCode::Char('.'));
        let down = Button::Linear(LinearJogAxis::ZMinus);
        let asked = keyed(&mut it, Duration::ZERO, KeyCode::PageDown);
        assert_eq!(
            asked,
            [Request::Step {
                button: down,
                by: 0.1
            }]
        );
        // Joints too.
        keyed(&mut it, Duration::ZERO, KeyCode::Tab);
        let left = Button::Joint(JointJogAxis::BasePlus);
        let asked = keyed(&mut it, Duration::ZERO, KeyCode::Left);
        assert_eq!(
            asked,
            [Request::Step {
                button: left,
                by: 0.1
            }]
        );
        let mut moving = State::sample();
        moving.arm.as_mut().unwrap().moving = true;
        it.handle_state(moving);
        assert_eq!(keyed(&mut it, Duration::ZERO, KeyCode::Left), []);
        // The third press ends it.
        it.handle_state(State::sample());
        keyed(&mut it, Duration::ZERO, KeyCode::Char('.'));
        let asked = keyed(&mut it, Duration::ZERO, KeyCode::Left);
        assert!(matches!(asked[..], [Request::Jog { .. }]), "{asked:?}");
    }

    #[test]
    fn leaving_the_window_or_the_pendant_releases_the_button() {
        for event in [Event::FocusLost, press(KeyCode::Char('q'))] {
            let mut it = pendant(Drive::Jog);
            keyed(&mut it, Duration::ZERO, KeyCode::Up);
            it.handle_event(Duration::ZERO, &event);
            assert_eq!(
                asked(&mut it, Duration::ZERO),
                [Request::Release],
                "{event:?}"
            );
        }
    }

    #[test]
    fn a_jog_refused_by_the_station_is_reported_and_not_repeated() {
        let mut it = pendant(Drive::Jog);
        let all = keyed(&mut it, Duration::ZERO, KeyCode::Up);
        it.handle_refused(&all[0], "x is 320 mm".into());
        assert_eq!(asked(&mut it, DEAD_MAN / 2), []);
        assert_eq!(it.answer.as_deref(), Some("x is 320 mm"));
        let notice = |client| Notice {
            number: 1,
            at_s: 0.0,
            news: News::Refused {
                client: ClientId(client),
                kind: "policy".into(),
            },
            text: format!("refused to {client}"),
        };
        keyed(&mut it, DEAD_MAN * 4, KeyCode::Down);
        it.handle_notice(notice(8));
        assert!(it.hold.button().is_some(), "it was another client's");
        it.handle_notice(notice(7));
        assert_eq!(it.hold.button(), None);
    }

    #[test]
    fn the_arm_moves_again_only_after_a_yes_to_the_question() {
        let mut it = pendant(Drive::Jog);
        let mut lost = State::sample();
        lost.trust.trusted = false;
        it.handle_state(lost);
        let now = Duration::ZERO;
        assert_eq!(keyed(&mut it, now, KeyCode::Char('y')), []);
        assert_eq!(keyed(&mut it, now, KeyCode::Char('r')), []);
        assert_eq!(keyed(&mut it, now, KeyCode::Char('n')), []);
        assert_eq!(keyed(&mut it, now, KeyCode::Char('y')), []);
        keyed(&mut it, now, KeyCode::Char('r'));
        let confirmed = keyed(&mut it, now, KeyCode::Char('y'));
        assert_eq!(confirmed, [Request::ConfirmPose]);
    }

    #[test]
    fn the_arrows_move_joints_after_tab() {
        let mut it = pendant(Drive::Jog);
        keyed(&mut it, Duration::ZERO, KeyCode::Tab);
        let all = keyed(&mut it, Duration::ZERO, KeyCode::Left);
        let jog = Jog::Joint(JointJog::new(JointJogAxis::BasePlus, 50.0));
        assert_eq!(all, [Request::Jog { jog }]);
    }

    /// An event of the joystick driver: the left stick's up and down.
    fn stick(value: i16) -> [u8; EVENT_LEN] {
        let [low, high] = value.to_ne_bytes();
        [0, 0, 0, 0, low, high, 2, 1]
    }

    #[test]
    fn a_stick_jogs_until_it_is_centred_or_the_gamepad_is_unplugged() {
        for end in [Some(stick(0)), None] {
            let mut it = pendant(Drive::Jog);
            it.handle_pad(Duration::ZERO, Some(stick(-32767)));
            assert_eq!(asked(&mut it, Duration::ZERO), [forward(50.0)]);
            // It sends no events while it is held in place.
            assert_eq!(asked(&mut it, DEAD_MAN / 10 * 9), [forward(50.0)]);
            it.handle_pad(DEAD_MAN, end);
            assert_eq!(asked(&mut it, DEAD_MAN), [Request::Release], "{end:?}");
            assert_eq!(asked(&mut it, DEAD_MAN * 2), []);
        }
    }

    #[test]
    fn a_stick_held_half_way_is_half_as_fast() {
        let mut it = pendant(Drive::Jog);
        // The dead zone is a quarter: 0.625 is half of the rest.
        it.handle_pad(Duration::ZERO, Some(stick(-20479)));
        let all = asked(&mut it, Duration::ZERO);
        let [
            Request::Jog {
                jog: Jog::Linear(jog),
            },
        ] = all[..]
        else {
            panic!("{all:?} is no jog");
        };
        assert!((jog.speed_percent - 25.0).abs() < 0.1, "{jog:?}");
    }

    fn mouse_packet(all: &[Request]) -> MouseMove {
        match all {
            [
                Request::Command {
                    command: Command::MouseMove(packet),
                },
            ] => *packet,
            other => panic!("{other:?} is no mouse packet"),
        }
    }

    #[test]
    fn a_mouse_has_at_most_two_packets_in_flight() {
        let mut it = pendant(Drive::Mouse(Mouse::new()));
        it.handle_state(State::sample());
        let beat = |at: u32| DEAD_MAN / 3 * at;
        for at in 0..2 {
            let packet = mouse_packet(&keyed(&mut it, beat(at), KeyCode::Up));
            assert_eq!((packet.x, packet.y, packet.z), (2.5, 0.0, 0.0));
            assert_eq!((packet.rotation_deg, packet.suction), (15.0, true));
            let command = at.into();
            it.handle_reply(&Reply::Accepted {
                command,
                takes_s: None,
            });
        }
        assert_eq!(keyed(&mut it, beat(2), KeyCode::Up), []);
        it.handle_notice(Notice {
            number: 1,
            at_s: 0.0,
            news: News::CommandDone { command: 0 },
            text: String::new(),
        });
        mouse_packet(&keyed(&mut it, beat(3), KeyCode::Up));
        assert_eq!(
            asked(&mut it, beat(9)),
            [],
            "a mouse has nothing to release"
        );
    }

    #[test]
    fn left_is_left_with_a_mouse_in_both_dialects() {
        let mut it = pendant(Drive::Mouse(Mouse::new()));
        for (dialect, y) in [(Dialect::SPECIFICATION, 2.5), (Dialect::FIRMWARE_1_1, -2.5)] {
            let mut state = State::sample();
            state.dialect = Some(dialect);
            it.handle_state(state);
            it.handle_event(Duration::ZERO, &Event::FocusLost);
            let packet = mouse_packet(&keyed(&mut it, Duration::ZERO, KeyCode::Left));
            assert_eq!(packet.y, y, "{dialect}");
        }
    }

    const DEAD_MAN: Duration = Duration::from_millis(150);
}
