//! What the keys of `dobot teach` mean, beside those of the pendant.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// What a key means for the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TeachKey {
    /// The point where the arm is, and a step that goes there.
    Capture,
    /// The way of the steps that are taught from now on.
    NextPath,
    /// The step before, or the one behind.
    Cursor {
        /// The one behind.
        down: bool,
    },
    /// The step at the cursor moves.
    Shift {
        /// Behind the next one.
        down: bool,
    },
    /// The step at the cursor goes away.
    Remove,
    /// What the last key changed is taken back.
    Undo,
    /// What was taken back is changed again.
    Redo,
    /// A pause.
    Pause,
    /// The recording of the jogged path begins or ends.
    Record,
    /// The pump is switched, here and in the program.
    Suction(bool),
    /// The program is run once, or goes on.
    Run,
    /// It is run again and again.
    Loop,
    /// It is run from the step at the cursor on.
    RunFromHere,
    /// Its next step is done.
    Step,
    /// What runs is paused.
    PauseJob,
    /// What runs or is paused ends for good.
    CancelJob,
    /// The program is written to its file.
    Save,
    /// The person leaves.
    Quit,
}

/// The meaning of a key that is pressed; `None` where it is one of the pendant.
pub(crate) fn teach_key(key: &KeyEvent) -> Option<TeachKey> {
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        return None;
    }
    Some(match key.code {
        KeyCode::Enter => TeachKey::Capture,
        KeyCode::Delete | KeyCode::Backspace => TeachKey::Remove,
        KeyCode::Char(letter) => return letter_key(letter),
        _ => return None,
    })
}

fn letter_key(letter: char) -> Option<TeachKey> {
    Some(match letter.to_ascii_lowercase() {
        'z' if letter == 'Z' => TeachKey::Redo,
        'm' => TeachKey::NextPath,
        ',' => TeachKey::Cursor { down: false },
        '.' => TeachKey::Cursor { down: true },
        '<' | ';' => TeachKey::Shift { down: false },
        '>' | ':' => TeachKey::Shift { down: true },
        'z' => TeachKey::Undo,
        't' => TeachKey::Pause,
        'v' => TeachKey::Record,
        'u' => TeachKey::Suction(true),
        'j' => TeachKey::Suction(false),
        'g' => TeachKey::Run,
        'l' => TeachKey::Loop,
        'h' => TeachKey::RunFromHere,
        'n' => TeachKey::Step,
        'p' => TeachKey::PauseJob,
        'x' => TeachKey::CancelJob,
        'w' => TeachKey::Save,
        'q' => TeachKey::Quit,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_that_stops_or_moves_the_arm_means_something_else_here() {
        let keys = [' ', 's', 'r', 'f', 'o', 'c', 'y', '0', '5', '9'].map(KeyCode::Char);
        let others = [KeyCode::Esc, KeyCode::Up, KeyCode::PageDown, KeyCode::Tab];
        for code in keys.into_iter().chain(others) {
            let key = KeyEvent::new(code, KeyModifiers::NONE);
            assert_eq!(teach_key(&key), None, "{code:?}");
        }
    }
}
