//! A pendant in the terminal: keys that are held move the arm, and it stops when they are let go.

mod gamepad;
mod hold;
mod keys;
mod mouse;
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
pub(crate) use self::mouse::{Mouse, kept_rotation_deg};
pub(crate) use self::screen::{alarm, answer, held, key_line, move_lines};
pub(crate) use self::session::{Panel, run};
pub(crate) use self::terminal::check_terminal;

/// The pendant as an engine: events of the terminal and of the station go in, requests come out. The
/// caller passes the time since it began.
#[derive(Debug)]
pub(crate) struct Pendant {
    client: ClientId,
    hold: HoldToRun<Source, Button>,
    pad: Gamepad,
    /// The share of the speed at which the gamepad is held.
    pad_share: f32,
    drive: Drive,
    frame: JogFrame,
    /// How far a press moves the arm, in mm or degrees; `None` where it moves for as long as it is held.
    step: Option<f32>,
    speed_percent: f32,
    state: Option<State>,
    asks: Option<Question>,
    answer: Option<String>,
    requests: VecDeque<Request>,
    is_over: bool,
}

/// By what a key that is held moves the arm.
#[derive(Debug)]
pub(crate) enum Drive {
    /// Jogs (states 2 and 7).
    Jog,
    /// Mouse packets (state 1).
    Mouse(Mouse),
}

/// With what a button is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    Key(KeyCode),
    Pad,
}

/// What a person is asked before the arm may move again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Question {
    /// Whether a stop is to end.
    Reset,
    /// Whether the arm stands where it says.
    Confirm,
}

impl Pendant {
    /// The pendant of a client, at half the speed. `dead_man` is how long a jog button stays pressed
    /// without being said again.
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

    /// Takes what the terminal tells.
    pub(crate) fn handle_event(&mut self, now: Duration, event: &Event) {
        match event {
            Event::Key(key) if key.kind == KeyEventKind::Release => {
                self.hold.handle_release(&Source::Key(folded(key.code)));
            }
            Event::Key(key) => self.handle_key(now, key),
            // Who does not look at this window does not see what its keys do.
            Event::FocusLost => self.hold.let_go(),
            _ => {}
        }
    }

    /// Takes what the gamepad tells; `None` where it is gone.
    pub(crate) fn handle_pad(&mut self, now: Duration, event: Option<[u8; EVENT_LEN]>) {
        let Some(event) = event else {
            self.hold.handle_release(&Source::Pad);
            self.answer = Some("the gamepad is gone".into());
            return;
        };
        match self.pad.handle(event) {
            Some(PadAction::Hold(button, share)) => {
                self.pad_share = share;
                self.press(now, Source::Pad, button);
            }
            Some(PadAction::Release) => self.hold.handle_release(&Source::Pad),
            Some(PadAction::Suction(on)) => {
                self.hold.let_go();
                self.switch_suction(on);
            }
            Some(PadAction::Stop) => {
                self.hold.let_go();
                self.stop();
            }
            None => {}
        }
    }

    /// Takes what the station tells all the time.
    pub(crate) fn handle_state(&mut self, state: State) {
        self.state = Some(state);
    }

    /// Takes that something happened.
    pub(crate) fn handle_notice(&mut self, notice: Notice) {
        if let Drive::Mouse(mouse) = &mut self.drive {
            mouse.handle_news(&notice.news);
        }
        let hinders = match notice.news {
            News::Refused { client, .. } => client == self.client,
            News::DeadMan | News::LinkLost | News::Stopped | News::CommandFailed { .. } => true,
            _ => false,
        };
        if hinders {
            self.hold.handle_refused();
            self.answer = Some(notice.text);
        }
    }

    /// Takes what the station answers.
    pub(crate) fn handle_reply(&mut self, reply: &Reply) {
        if let (Drive::Mouse(mouse), Reply::Accepted { command, .. }) = (&mut self.drive, reply) {
            mouse.handle_accepted(*command);
        }
    }

    /// Takes that the station refuses a request.
    pub(crate) fn handle_refused(&mut self, request: &Request, why: String) {
        if matches!(request, Request::Jog { .. } | Request::Command { .. }) {
            self.hold.handle_refused();
        }
        self.answer = Some(why);
    }

    /// Asks the station for something.
    pub(crate) fn ask(&mut self, request: Request) {
        self.requests.push_back(request);
    }

    /// Tells the person something.
    pub(crate) fn tell(&mut self, text: String) {
        self.answer = Some(text);
    }

    /// Lets go of whatever is held.
    pub(crate) fn let_go(&mut self) {
        self.hold.let_go();
    }

    /// What the station told last.
    pub(crate) const fn state(&self) -> Option<&State> {
        self.state.as_ref()
    }

    /// What an arm tells that rests, and is where it says; or why not, in these words where it cannot be trusted.
    pub(crate) fn resting(&self, untrusted: &'static str) -> Result<&Status, &'static str> {
        let state = self.state().ok_or("the arm has not told yet")?;
        if !state.trust.trusted {
            return Err(untrusted);
        }
        match &state.arm {
            Some(arm) if arm.moving => Err("the arm still moves"),
            Some(arm) => Ok(&arm.status),
            None => Err("the arm has not told yet"),
        }
    }

    /// Takes the passing of time.
    pub(crate) fn handle_time(&mut self, now: Duration) {
        // A stick tells only that it moved; the device says when it is gone.
        self.hold.handle_still(now, &Source::Pad);
        self.hold.handle_time(now);
    }

    /// The person, or the system, wants to leave: what is held is let go.
    pub(crate) fn quit(&mut self) {
        self.hold.let_go();
        self.is_over = true;
    }

    /// What the station is asked for next.
    pub(crate) fn poll_request(&mut self, now: Duration) -> Option<Request> {
        loop {
            if let Some(request) = self.requests.pop_front() {
                return Some(request);
            }
            let beat = self.hold.poll(now)?;
            self.requests.extend(self.driven(beat));
        }
    }

    /// When [`handle_time`](Self::handle_time) wants to be called next.
    pub(crate) fn poll_wakeup(&self) -> Option<Duration> {
        self.hold.poll_wakeup()
    }

    /// Whether the person has left, and all was asked for that this takes.
    pub(crate) const fn is_over(&self) -> bool {
        self.is_over
    }

    fn handle_key(&mut self, now: Duration, key: &KeyEvent) {
        let meaning = meaning(key, self.frame, self.hindrance().is_some());
        let asked = self.asks.take();
        if !matches!(meaning, KeyMeaning::Hold(_) | KeyMeaning::Speed(_)) {
            self.hold.let_go();
        }
        match meaning {
            KeyMeaning::Stop => self.stop(),
            KeyMeaning::Hold(button) => match self.step {
                None => self.press(now, Source::Key(folded(key.code)), button),
                Some(size) if key.kind == KeyEventKind::Press => self.step(button, size),
                // A key that is held goes one step.
                Some(_) => {}
            },
            KeyMeaning::Steps => self.change_step(),
            KeyMeaning::Speed(percent) => self.speed_percent = percent,
            KeyMeaning::Suction(on) => self.switch_suction(on),
            KeyMeaning::Frame => self.change_frame(),
            KeyMeaning::Ask => self.asks = self.hindrance(),
            KeyMeaning::Yes => self.requests.extend(asked.map(Question::request)),
            KeyMeaning::Quit => self.quit(),
            KeyMeaning::Nothing => {}
        }
    }

    /// What hinders the arm from moving until a person has looked at it.
    fn hindrance(&self) -> Option<Question> {
        let state = self.state.as_ref()?;
        if state.stop.is_some() {
            return Some(Question::Reset);
        }
        (state.arm.is_some() && !state.trust.trusted).then_some(Question::Confirm)
    }

    /// A stop goes before all that was asked for and is not sent.
    fn stop(&mut self) {
        self.requests.clear();
        self.requests.push_back(Request::Stop {
            reason: Some("a key of the pendant was pressed".into()),
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
        self.ask(Request::Command { command });
    }

    /// Moves an arm that rests by one step.
    fn step(&mut self, button: Button, size: f32) {
        let untrusted = "the pose is not trusted; press r, look, and press y";
        match self.resting(untrusted) {
            Ok(status) if button.step(status, size).is_some() => {
                self.answer = None;
                self.ask(Request::Step { button, by: size });
            }
            Ok(_) => self.tell("no step: this key has to be held; . ends the steps".into()),
            Err(why) => self.tell(format!("no step: {why}")),
        }
    }

    fn change_step(&mut self) {
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

    /// In percent: a stick that is held half-way is half as fast.
    fn speed_now(&self) -> f32 {
        let by_pad = self.hold.is_held_by(&Source::Pad);
        let share = if by_pad { self.pad_share } else { 1.0 };
        (self.speed_percent * share).max(1.0)
    }

    /// What the station is asked for because a button is held or let go.
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

/// How far a press moves the arm, in mm or degrees: the second to touch a point.
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
    fn an_arrow_jogs_until_it_repeats_no_more() {
        let mut it = pendant(Drive::Jog);
        assert_eq!(keyed(&mut it, Duration::ZERO, KeyCode::Up), [forward(50.0)]);
        assert_eq!(it.poll_wakeup(), Some(DEAD_MAN / 3));
        assert_eq!(asked(&mut it, DEAD_MAN), [Request::Release]);
        assert_eq!(it.poll_wakeup(), None);
    }

    #[test]
    fn a_stop_goes_out_first_and_nothing_follows_it() {
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
    fn a_speed_counts_from_the_next_beat_on() {
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
    fn leaving_the_window_or_the_pendant_lets_go() {
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
    fn a_jog_that_the_station_refuses_is_told_and_asked_for_no_more() {
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
    fn a_stick_jogs_until_it_is_back_or_the_gamepad_is_gone() {
        for end in [Some(stick(0)), None] {
            let mut it = pendant(Drive::Jog);
            it.handle_pad(Duration::ZERO, Some(stick(-32767)));
            assert_eq!(asked(&mut it, Duration::ZERO), [forward(50.0)]);
            // It tells nothing while it stays where it is.
            assert_eq!(asked(&mut it, DEAD_MAN / 10 * 9), [forward(50.0)]);
            it.handle_pad(DEAD_MAN, end);
            assert_eq!(asked(&mut it, DEAD_MAN), [Request::Release], "{end:?}");
            assert_eq!(asked(&mut it, DEAD_MAN * 2), []);
        }
    }

    #[test]
    fn a_stick_that_is_held_half_way_is_half_as_fast() {
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
    fn a_mouse_has_two_packets_under_way_at_the_most() {
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
    fn left_is_left_with_a_mouse_whatever_the_dialect() {
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
