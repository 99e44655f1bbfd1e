//! What a voice command says (note N17).

use dobot_arm::Position;

/// What a voice command wants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spoken {
    /// Move by that much.
    Move(Position),
    /// Switch the suction cup.
    Grab(bool),
}

/// Understands an action word and number words, which say how many millimetres.
pub(crate) fn understand(text: &str) -> Option<Spoken> {
    let action = words(text).find_map(|word| value(&ACTIONS, word))?;
    match action {
        Action::Grab(on) => Some(Spoken::Grab(on)),
        Action::Move(x, y, z) => {
            let way_mm = number(text);
            let by = Position::new(x * way_mm, y * way_mm, z * way_mm);
            (way_mm > 0.0).then_some(Spoken::Move(by))
        }
    }
}

#[derive(Clone, Copy)]
enum Action {
    Move(f64, f64, f64),
    Grab(bool),
}

/// The number words added up; "two hundred" is 200.
fn number(text: &str) -> f64 {
    words(text).fold(0.0, |sum, word| match value(&NUMBERS, word) {
        Some(number) => sum + f64::from(number),
        None if word.eq_ignore_ascii_case("hundred") => sum.max(1.0) * 100.0,
        None => sum,
    })
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|letter: char| !letter.is_ascii_alphabetic())
}

fn value<T: Copy>(list: &[(&str, T)], word: &str) -> Option<T> {
    list.iter()
        .find(|(known, _)| known.eq_ignore_ascii_case(word))
        .map(|&(_, value)| value)
}

const ACTIONS: [(&str, Action); 8] = [
    ("ahead", Action::Move(1.0, 0.0, 0.0)),
    ("back", Action::Move(-1.0, 0.0, 0.0)),
    ("left", Action::Move(0.0, 1.0, 0.0)),
    ("right", Action::Move(0.0, -1.0, 0.0)),
    ("up", Action::Move(0.0, 0.0, 1.0)),
    ("down", Action::Move(0.0, 0.0, -1.0)),
    ("catch", Action::Grab(true)),
    ("release", Action::Grab(false)),
];

const NUMBERS: [(&str, u8); 27] = [
    ("one", 1),
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
    ("seven", 7),
    ("eight", 8),
    ("nine", 9),
    ("ten", 10),
    ("eleven", 11),
    ("twelve", 12),
    ("thirteen", 13),
    ("fourteen", 14),
    ("fifteen", 15),
    ("sixteen", 16),
    ("seventeen", 17),
    ("eighteen", 18),
    ("nineteen", 19),
    ("twenty", 20),
    ("thirty", 30),
    ("forty", 40),
    ("fifty", 50),
    ("sixty", 60),
    ("seventy", 70),
    ("eighty", 80),
    ("ninety", 90),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn adds_number_words_up_to_millimetres_in_the_direction_said() {
        for (text, expected) in [
            ("ahead ten", Position::new(10.0, 0.0, 0.0)),
            ("Back twenty five", Position::new(-25.0, 0.0, 0.0)),
            ("go left seventeen please", Position::new(0.0, 17.0, 0.0)),
            ("right two hundred ten", Position::new(0.0, -210.0, 0.0)),
            ("up hundred", Position::new(0.0, 0.0, 100.0)),
            ("down sixty-six", Position::new(0.0, 0.0, -66.0)),
        ] {
            assert_eq!(understand(text), Some(Spoken::Move(expected)), "{text}");
        }
    }

    #[test]
    fn catches_and_releases_without_a_number() {
        assert_eq!(understand("catch it"), Some(Spoken::Grab(true)));
        assert_eq!(understand("release"), Some(Spoken::Grab(false)));
    }

    #[test]
    fn does_not_guess_what_it_does_not_understand() {
        for text in [
            "",
            "ahead",
            "ten",
            "ahead zero",
            "forward ten",
            "phone rings",
        ] {
            assert_eq!(understand(text), None, "{text}");
        }
    }
}
