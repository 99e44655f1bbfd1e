//! Texts from clients, shown in terminals and on pages.

/// Makes a text safe to show on one line, with at most this many characters: removes control
/// characters, characters that change the text direction, and invisible ones.
#[must_use]
pub fn plain(text: &str, most: usize) -> String {
    text.chars()
        .filter(|character| is_plain(*character))
        .take(most)
        .collect()
}

/// Returns whether a character is safe to show.
#[must_use]
pub fn is_plain(character: char) -> bool {
    let turns = matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let is_unseen = matches!(character, '\u{ad}' | '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{2064}' | '\u{feff}');
    let ends_line = matches!(character, '\u{2028}' | '\u{2029}');
    !(character.is_control() || turns || is_unseen || ends_line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_of_terminals_and_pages_are_removed_and_all_else_stays() {
        assert_eq!(plain("t\u{1b}]0;x\u{7}\n\u{9b}2J", 40), "t]0;x2J");
        assert_eq!(
            plain("rest \u{202e}.tser\u{2066} a\u{200b}b\u{feff}", 40),
            "rest .tser ab"
        );
        assert_eq!(plain("Zoë übt 絵を描く", 40), "Zoë übt 絵を描く");
        assert_eq!(plain("abc", 2), "ab");
    }
}
