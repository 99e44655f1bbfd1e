//! The keys of `dobot teach`, in addition to those of the pendant.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// The action of a key on the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TeachKey {
    /// Add the current point, and a step that moves there.
    Capture,
    /// Change the path of new steps.
    NextPath,
    /// Select the previous or next step.
    Cursor {
        /// The next one.
        down: bool,
    },
    /// Move the selected step.
    Shift {
        /// After the next one.
        down: bool,
    },
    /// Remove the selected step.
    Remove,
    /// Undo the last change.
    Undo,
    /// Redo the last undone change.
    Redo,
    /// Add a pause.
    Pause,
    /// Ask what else to add: a name, a repeat, a tool, a grid, a frame or a call.
    Add,
    /// End the repeat around the selected step.
    EndBlock,
    /// Toggle between steps and continuous motion.
    Steps,
    /// Start or end the recording of the jogged path.
    Record,
    /// Switch the pump, also in the program.
    Suction(bool),
    /// Run the program once, or resume it.
    Run,
    /// Run it repeatedly.
    Loop,
    /// Run it from the selected step on.
    RunFromHere,
    /// Run its next step.
    Step,
    /// Pause it.
    PauseJob,
    /// End it.
    CancelJob,
    /// Save the program.
    Save,
    /// Quit.
    Quit,
}

/// Returns the action of a pressed key; `None` for a key of the pendant.
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
        'a' => TeachKey::Add,
        'e' => TeachKey::EndBlock,
        // In `dobot jog` it is the key beside, which selects a step here.
        '/' => TeachKey::Steps,
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
