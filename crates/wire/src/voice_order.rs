//! The order of a voice command.

use crate::Voice;

/// The order of a voice command (note N17).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VoiceOrder {
    /// A straight line from here, in millimetres.
    Move {
        /// Ahead; negative is back.
        x_mm: f32,
        /// To the left; negative is to the right.
        y_mm: f32,
        /// Up; negative is down.
        z_mm: f32,
    },
    /// The pump on.
    Catch,
    /// The pump off.
    Release,
}

impl VoiceOrder {
    /// The words of numbers in their order: one to nine, ten to nineteen, twenty to ninety.
    pub const NUMBERS: [(&str, u16); 27] = [
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

    /// The words of stock arms, and what each orders; a direction by one millimetre.
    pub const WORDS: [(&str, Self); 8] = [
        ("ahead", step([1.0, 0.0, 0.0])),
        ("back", step([-1.0, 0.0, 0.0])),
        ("left", step([0.0, 1.0, 0.0])),
        ("right", step([0.0, -1.0, 0.0])),
        ("up", step([0.0, 0.0, 1.0])),
        ("down", step([0.0, 0.0, -1.0])),
        ("catch", Self::Catch),
        ("release", Self::Release),
    ];

    /// Multiplies the distance; `None` for a distance of 0.
    #[must_use]
    pub fn times(self, number: u16) -> Option<Self> {
        let Self::Move { x_mm, y_mm, z_mm } = self else {
            return Some(self);
        };
        let by = [x_mm, y_mm, z_mm].map(|mm| mm * f32::from(number));
        (number > 0).then_some(step(by))
    }

    /// Reads the text; `None` where it orders nothing: no word of the list or more than one, or a
    /// direction without a number.
    ///
    /// The words are whole and in any case. Numbers are English words that add up, where `hundred`
    /// multiplies what is before it; other words do not count.
    #[must_use]
    pub fn parse(voice: &Voice) -> Option<Self> {
        let text = voice.text().ok()?;
        let words = || text.split(|letter: char| !letter.is_ascii_alphabetic());
        let mut orders = words().filter_map(|word| find(&Self::WORDS, word));
        let order = orders.next()?;
        if orders.next().is_some() {
            return None;
        }
        order.times(words().fold(0, add_number))
    }
}

/// Adds the next word to a number.
fn add_number(sum: u16, word: &str) -> u16 {
    if word.eq_ignore_ascii_case("hundred") {
        return sum.max(1).saturating_mul(100);
    }
    sum.saturating_add(find(&VoiceOrder::NUMBERS, word).unwrap_or(0))
}

fn find<T: Copy>(list: &[(&str, T)], word: &str) -> Option<T> {
    let is_word = |(entry, _): &&(&str, T)| entry.eq_ignore_ascii_case(word);
    list.iter().find(is_word).map(|&(_, meaning)| meaning)
}

const fn step([x_mm, y_mm, z_mm]: [f32; 3]) -> VoiceOrder {
    VoiceOrder::Move { x_mm, y_mm, z_mm }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn order(text: &str) -> Option<VoiceOrder> {
        VoiceOrder::parse(&Voice::new(text).unwrap())
    }

    #[test]
    fn moves_by_millimetres_in_words() {
        let cases = [
            ("ahead seventeen", [17.0, 0.0, 0.0]),
            ("Back five", [-5.0, 0.0, 0.0]),
            ("go left two hundred and fifty three", [0.0, 253.0, 0.0]),
            ("hundred right", [0.0, -100.0, 0.0]),
            ("Move UP eighty-one, please", [0.0, 0.0, 81.0]),
            ("down ten", [0.0, 0.0, -10.0]),
        ];
        for (text, [x_mm, y_mm, z_mm]) in cases {
            assert_eq!(
                order(text),
                Some(VoiceOrder::Move { x_mm, y_mm, z_mm }),
                "{text}"
            );
        }
    }

    #[test]
    fn switches_the_pump() {
        assert_eq!(order("Catch it"), Some(VoiceOrder::Catch));
        assert_eq!(order("release"), Some(VoiceOrder::Release));
    }

    #[test]
    fn orders_nothing_that_is_not_clear() {
        for text in [
            "",
            "up",
            "up 10",
            "ten",
            "upten",
            "left right ten",
            "setback five",
        ] {
            assert_eq!(order(text), None, "{text}");
        }
    }
}
