//! The keys of the pendant.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use dobot_wire::{JointJogAxis, LinearJogAxis};

use dobot_api::{Button, JogFrame};

/// The action of a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum KeyMeaning {
    /// Stop the arm.
    Stop,
    /// Move the arm while the key is held.
    Hold(Button),
    /// Set the speed, in percent of the jog speed.
    Speed(f32),
    /// Switch the pump.
    Suction(bool),
    /// Toggle between joints and axes.
    Frame,
    /// Show the question that must be answered before the arm may move.
    Ask,
    /// Answer yes.
    Yes,
    /// Toggle between steps and continuous motion.
    Steps,
    /// Quit.
    Quit,
    /// No action.
    Nothing,
}

/// Returns the action of a pressed key. `hindered` is an arm that is stopped, or whose pose is not confirmed:
/// no key moves it, and `r` shows the question.
pub(crate) fn meaning(key: &KeyEvent, frame: JogFrame, hindered: bool) -> KeyMeaning {
    let code = folded(key.code);
    if code == KeyCode::Char('c') && key.modifiers.contains(KeyModifiers::CONTROL) {
        return KeyMeaning::Quit;
    }
    match code {
        KeyCode::Char(' ' | 's') | KeyCode::Esc => KeyMeaning::Stop,
        KeyCode::Char('r') if hindered => KeyMeaning::Ask,
        KeyCode::Char('y') => KeyMeaning::Yes,
        KeyCode::Char('q') => KeyMeaning::Quit,
        KeyCode::Char('u') => KeyMeaning::Suction(true),
        KeyCode::Char('j') => KeyMeaning::Suction(false),
        KeyCode::Tab => KeyMeaning::Frame,
        KeyCode::Char('.') => KeyMeaning::Steps,
        KeyCode::Char(digit @ '0'..='9') => KeyMeaning::Speed(speed_percent(digit)),
        code => button(code, frame).map_or(KeyMeaning::Nothing, KeyMeaning::Hold),
    }
}

/// A key without shift, which may be released before the key.
pub(crate) const fn folded(code: KeyCode) -> KeyCode {
    match code {
        KeyCode::Char(letter) => KeyCode::Char(letter.to_ascii_lowercase()),
        code => code,
    }
}

/// The speed of a digit: 1 to 9 are tenths, 0 is 100 %.
fn speed_percent(digit: char) -> f32 {
    match digit.to_digit(10) {
        Some(tenths @ 1..=9) => f32::from(u8::try_from(tenths).unwrap_or(10)) * 10.0,
        _ => 100.0,
    }
}

fn button(code: KeyCode, frame: JogFrame) -> Option<Button> {
    let (_, joint, linear) = BUTTONS.iter().find(|(key, ..)| *key == code)?;
    Some(match frame {
        JogFrame::Joint => Button::Joint(*joint),
        JogFrame::Linear => Button::Linear(*linear),
    })
}

const BUTTONS: [(KeyCode, JointJogAxis, LinearJogAxis); 10] = {
    use JointJogAxis as J;
    use LinearJogAxis as L;
    [
        (KeyCode::Up, J::RearPlus, L::XPlus),
        (KeyCode::Down, J::RearMinus, L::XMinus),
        (KeyCode::Left, J::BasePlus, L::YPlus),
        (KeyCode::Right, J::BaseMinus, L::YMinus),
        (KeyCode::PageUp, J::ForeMinus, L::ZPlus),
        (KeyCode::PageDown, J::ForePlus, L::ZMinus),
        (KeyCode::Char('r'), J::ServoPlus, L::ServoPlus),
        (KeyCode::Char('f'), J::ServoMinus, L::ServoMinus),
        (KeyCode::Char('o'), J::GripperOpen, L::GripperOpen),
        (KeyCode::Char('c'), J::GripperClose, L::GripperClose),
    ]
};

#[cfg(test)]
mod tests {
    use super::*;

    fn key(code: KeyCode) -> KeyEvent {
        KeyEvent::new(code, KeyModifiers::NONE)
    }

    #[test]
    fn space_escape_and_s_always_stop() {
        for code in [KeyCode::Char(' '), KeyCode::Char('s'), KeyCode::Esc] {
            for frame in [JogFrame::Joint, JogFrame::Linear] {
                for hindered in [false, true] {
                    assert_eq!(meaning(&key(code), frame, hindered), KeyMeaning::Stop);
                }
            }
        }
    }

    #[test]
    fn arrows_move_in_their_direction_as_seen_from_behind_the_arm() {
        for (code, axis) in [
            (KeyCode::Up, LinearJogAxis::XPlus),
            (KeyCode::Left, LinearJogAxis::YPlus),
            (KeyCode::PageUp, LinearJogAxis::ZPlus),
        ] {
            let held = KeyMeaning::Hold(Button::Linear(axis));
            assert_eq!(meaning(&key(code), JogFrame::Linear, false), held);
        }
        let left = KeyMeaning::Hold(Button::Joint(JointJogAxis::BasePlus));
        assert_eq!(meaning(&key(KeyCode::Left), JogFrame::Joint, false), left);
    }

    #[test]
    fn digits_are_speeds_and_c_with_control_leaves() {
        let speed = |digit| meaning(&key(KeyCode::Char(digit)), JogFrame::Linear, false);
        assert_eq!(speed('1'), KeyMeaning::Speed(10.0));
        assert_eq!(speed('9'), KeyMeaning::Speed(90.0));
        assert_eq!(speed('0'), KeyMeaning::Speed(100.0));
        let leave = KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL);
        assert_eq!(meaning(&leave, JogFrame::Linear, false), KeyMeaning::Quit);
    }

    #[test]
    fn r_turns_the_tool_and_asks_only_when_the_arm_may_not_move() {
        let r = |hindered| meaning(&key(KeyCode::Char('R')), JogFrame::Linear, hindered);
        let turn = KeyMeaning::Hold(Button::Linear(LinearJogAxis::ServoPlus));
        assert_eq!((r(false), r(true)), (turn, KeyMeaning::Ask));
    }
}
