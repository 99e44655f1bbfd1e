//! Voice commands given as text.

use dobot_wire::{ParseError, Voice, VoiceOrder};

/// Checks that a text is one voice command (state 5).
///
/// # Errors
///
/// [`InvalidVoice`] for a text that does not fit a packet, and for one without exactly one order.
pub fn voice_command(text: &str) -> Result<Voice, InvalidVoice> {
    let voice = Voice::new(text)?;
    if VoiceOrder::parse(&voice).is_some() {
        return Ok(voice);
    }
    let words = text.to_ascii_lowercase();
    let mut words = words.split(|letter: char| !letter.is_ascii_alphabetic());
    let direction = words.find_map(|word| DIRECTIONS.into_iter().find(|name| *name == word));
    Err(match direction {
        Some(word) => InvalidVoice::NoNumber { word },
        None => InvalidVoice::NoOrder {
            text: text.to_owned(),
        },
    })
}

/// The error returned for a text that is not one voice command.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidVoice {
    /// The text does not fit a packet.
    #[error(transparent)]
    Unfit(#[from] ParseError),
    /// A direction without one number.
    #[error("`{word}` needs one number in words, for example `{word} ten`")]
    NoNumber {
        /// The direction.
        word: &'static str,
    },
    /// No order.
    #[error("`{text}` contains no order; expected {} with a number, or catch or release", DIRECTIONS.join(", "))]
    NoOrder {
        /// The text.
        text: String,
    },
}

const DIRECTIONS: [&str; 6] = ["ahead", "back", "left", "right", "up", "down"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_without_a_number_is_refused_with_an_example() {
        assert!(voice_command("go up twenty-five").is_ok() && voice_command("catch").is_ok());
        let detail = |text| voice_command(text).expect_err(text).to_string();
        assert!(detail("go left").contains("`left` needs one number"));
        assert!(detail("go left").contains("`left ten`"));
        assert!(detail("hello").contains("no order"));
    }
}
