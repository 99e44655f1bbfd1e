//! Corrections of the common mistakes that make a text invalid, so that its other mistakes can be
//! found, too.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::DeTable;

use crate::ProgramError;
use crate::lines::Lines;

/// Returns the text with its common mistakes corrected, and each of them with the correct line:
/// decimal commas as in `x = 200,5`, texts without quotes, tables and texts that are not closed. It
/// has the same lines.
pub(crate) fn corrected(text: &str) -> (String, Vec<ProgramError>) {
    let mut text = text.to_owned();
    let mut mistakes = Vec::new();
    for _ in 0..MAX_CORRECTIONS {
        let (_, errors) = DeTable::parse_recoverable(&text);
        let lines = Lines::of(&text);
        let starts = errors.iter().filter_map(|error| Some(error.span()?.start));
        let mut found = BTreeMap::new();
        for number in starts.map(|start| lines.at(start)) {
            let is_blank = |line: &usize| text[lines.range(*line, &text)].trim().is_empty();
            let before = (1..number).rev().find(|line| !is_blank(line));
            for line in before.into_iter().chain([number]) {
                let here = Line::new(&text, &lines, line);
                for correction in here.corrections(line == number) {
                    found.insert(correction.at.start, (line, correction));
                }
            }
        }
        if found.is_empty() {
            break;
        }
        for (line, correction) in found.values() {
            mistakes.push(ProgramError::at(*line, correction.reason.clone()));
        }
        for (_, correction) in found.into_values().rev() {
            text.replace_range(correction.at, &correction.with);
        }
    }
    (text, mistakes)
}

/// What a word for a switch means, whatever its case.
pub(crate) fn switch(word: &str) -> Option<bool> {
    match word.to_ascii_lowercase().as_str() {
        "on" | "true" | "yes" => Some(true),
        "off" | "false" | "no" => Some(false),
        _ => None,
    }
}

/// A correction of a part of a text.
struct Correction {
    at: Range<usize>,
    with: String,
    reason: String,
}

/// A line of a text.
struct Line<'a> {
    text: &'a str,
    /// Where it begins in the text.
    start: usize,
    /// Whether a table or the end of the text follows it.
    is_last: bool,
}

impl<'a> Line<'a> {
    fn new(text: &'a str, lines: &Lines, number: usize) -> Self {
        let range = lines.range(number, text);
        let next = text[range.end..].trim_start();
        Self {
            text: text[range.clone()].trim_end(),
            start: range.start,
            is_last: next.is_empty() || next.starts_with('['),
        }
    }

    /// Returns the corrections; a line that the parser does not complain about may only have an
    /// open table.
    fn corrections(&self, is_wrong: bool) -> Vec<Correction> {
        if !is_wrong {
            return self.open_table().into_iter().collect();
        }
        let mut found: Vec<_> = self.values().filter_map(|at| self.value(at)).collect();
        if found.is_empty() {
            found.extend(self.open_text().or_else(|| self.open_table()));
        }
        found
    }

    /// The characters outside texts and comments, with their positions.
    fn outside(&self) -> impl Iterator<Item = (usize, char)> {
        let mut is_text = false;
        let code = self.text.char_indices().take_while(move |(_, letter)| {
            is_text ^= *letter == '"';
            is_text || *letter != '#'
        });
        let mut is_text = false;
        code.filter(move |(_, letter)| {
            is_text ^= *letter == '"';
            !is_text && *letter != '"'
        })
    }

    /// The positions after each `=`.
    fn values(&self) -> impl Iterator<Item = usize> {
        let equals = self.outside().filter(|(_, letter)| *letter == '=');
        equals.map(|(at, _)| at + 1)
    }

    /// Corrects the value at a position.
    fn value(&self, at: usize) -> Option<Correction> {
        let value = self.text[at..].trim_start();
        let start = self.start + self.text.len() - value.len();
        if let Some(number) = comma_number(value) {
            let at = start + number.find(',')?;
            let point = number.replace(',', ".");
            return Some(Correction {
                at: at..at + 1,
                with: ".".to_owned(),
                reason: format!(
                    "the number {number} has a decimal comma; write {point}, with a point"
                ),
            });
        }
        let word = bare_word(value)?;
        let key = self.text[..at - 1].trim_end();
        let key = key.rsplit(['{', ',', ' ']).next().unwrap_or(key);
        let switched = switch(word).filter(|_| matches!(key, "suction" | "laser"));
        let with = switched.map_or_else(|| format!("{word:?}"), |is_on| is_on.to_string());
        let what = match switched {
            Some(_) => format!("{key} is true or false"),
            None => "a text must be in quotes".to_owned(),
        };
        Some(Correction {
            at: start..start + word.len(),
            reason: format!("{what}; write {key} = {with}"),
            with,
        })
    }

    /// The number of tables that the line opens without closing them.
    fn open_tables(&self) -> isize {
        let count = |(_, letter)| match letter {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        self.outside().map(count).sum()
    }

    fn open_table(&self) -> Option<Correction> {
        let has_open_text = self.text.matches('"').count() % 2 == 1;
        if !self.is_last || has_open_text || self.open_tables() != 1 {
            return None;
        }
        let code = self.outside().filter(|(_, letter)| !letter.is_whitespace());
        let (last, letter) = code.last()?;
        // A text at the end of the line is not seen here.
        let end = self.text[last + letter.len_utf8()..].trim_end();
        let end = if end.starts_with('#') || end.is_empty() {
            last + letter.len_utf8()
        } else if end.contains('#') {
            return None;
        } else {
            self.text.len()
        };
        Some(self.insert(end, " }", "the table is not closed; write } at its end"))
    }

    fn open_text(&self) -> Option<Correction> {
        let is_plain = !self.text.contains("\"\"\"") && !self.text.contains(['\'', '\\', '#']);
        if !is_plain || self.text.matches('"').count() != 1 {
            return None;
        }
        let closes_table = self.open_tables() > 0 && self.text.ends_with('}');
        let text = self.text.strip_suffix('}').filter(|_| closes_table);
        let end = text.map_or(self.text, str::trim_end).len();
        Some(self.insert(end, "\"", "the text is not closed; write \" at its end"))
    }

    fn insert(&self, at: usize, with: &str, reason: &str) -> Correction {
        let at = self.start + at;
        Correction {
            at: at..at,
            with: with.to_owned(),
            reason: reason.to_owned(),
        }
    }
}

/// The number with a comma at the start of a text: `200,5, y`.
fn comma_number(text: &str) -> Option<&str> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let sign = usize::from(text.starts_with(['-', '+']));
    let whole = digits(&text[sign..]);
    let rest = text[sign + whole..].strip_prefix(',')?;
    let decimals = digits(rest);
    (whole > 0 && decimals > 0).then(|| &text[..sign + whole + 1 + decimals])
}

/// The word at the start of a text that is a whole value but lacks its quotes.
fn bare_word(text: &str) -> Option<&str> {
    let is_of_word = |letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '-');
    let len = text
        .find(|letter| !is_of_word(letter))
        .unwrap_or(text.len());
    let (word, rest) = text.split_at(len);
    let is_whole = matches!(
        rest.trim_start().chars().next(),
        None | Some(',' | '}' | ']' | '#')
    );
    let is_word = word.starts_with(char::is_alphabetic);
    let is_value = matches!(word, "true" | "false" | "inf" | "nan");
    (is_word && is_whole && !is_value).then_some(word)
}

/// The number of times that a text is corrected and read again.
const MAX_CORRECTIONS: usize = 20;
