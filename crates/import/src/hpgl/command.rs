//! The commands of a plot file: two letters and parameters.

use crate::error::SourceError;
use crate::number::{decimal, real};

/// A command with its parameters.
#[derive(Debug)]
pub(super) struct Command<'a> {
    /// The position in the text.
    pub(super) at: usize,
    /// The two letters, in upper case.
    pub(super) name: [u8; 2],
    pub(super) numbers: Vec<f64>,
    /// The text of PE, LB or SM.
    pub(super) bytes: &'a [u8],
}

impl Command<'_> {
    pub(super) fn number(&self, index: usize) -> Option<f64> {
        self.numbers.get(index).copied()
    }

    /// The command as in the file.
    pub(super) fn text(&self) -> String {
        let numbers: Vec<String> = self.numbers.iter().map(f64::to_string).collect();
        format!("{} {}", self.letters(), numbers.join(","))
            .trim_end()
            .to_owned()
    }

    pub(super) fn letters(&self) -> String {
        self.name.iter().copied().map(char::from).collect()
    }
}

/// The commands of a file, in order.
pub(super) fn commands(text: &[u8]) -> impl Iterator<Item = Result<Command<'_>, SourceError>> {
    let mut lexer = CommandLexer {
        text,
        at: 0,
        label_end: ETX,
        writes_end: false,
    };
    std::iter::from_fn(move || {
        let command = lexer.next_command().transpose();
        if matches!(command, Some(Err(_))) {
            lexer.at = text.len();
        }
        command
    })
}

/// The number at the start of a text; some programs write exponents, with which no command can
/// start.
fn number(text: &[u8]) -> Option<(f64, usize)> {
    let plain = decimal(text)?;
    Some(real(text).filter(|x| x.1 > plain.1).unwrap_or(plain))
}

struct CommandLexer<'a> {
    text: &'a [u8],
    at: usize,
    /// The terminator of labels (DT).
    label_end: u8,
    /// Whether the terminator belongs to the label.
    writes_end: bool,
}

impl<'a> CommandLexer<'a> {
    fn next_command(&mut self) -> Result<Option<Command<'a>>, SourceError> {
        self.skip_between()?;
        let at = self.at;
        let Some(rest) = self.text.get(at..).filter(|rest| !rest.is_empty()) else {
            return Ok(None);
        };
        let [a, b, ..] = *rest else {
            return Err(self.found(COMMAND));
        };
        if !a.is_ascii_alphabetic() || !b.is_ascii_alphabetic() {
            return Err(self.found(COMMAND));
        }
        self.at += 2;
        let name = [a, b].map(|value| value.to_ascii_uppercase());
        let mut command = Command {
            at,
            name,
            numbers: Vec::new(),
            bytes: &[],
        };
        match &name {
            b"PE" => command.bytes = self.until(b';'),
            b"LB" | b"BL" => command.bytes = self.label(at)?,
            b"WD" => _ = self.until(self.label_end),
            b"CO" => self.comment(),
            b"DT" => self.set_label_end()?,
            b"SM" => command.bytes = self.character(),
            _ => command.numbers = self.numbers()?,
        }
        if matches!(&name, b"IN" | b"DF") {
            (self.label_end, self.writes_end) = (ETX, false);
        }
        Ok(Some(command))
    }

    /// Skips what may be between two commands.
    fn skip_between(&mut self) -> Result<(), SourceError> {
        while let Some(&byte) = self.text.get(self.at) {
            match byte {
                ESC => self.escape()?,
                b';' | b' ' | 0..0x20 | 0x7F => self.at += 1,
                _ => break,
            }
        }
        Ok(())
    }

    /// Skips a sequence for the device.
    ///
    /// ```text
    ///   ESC . I 81 ; ; 17 :     the plotter's line     (HP-GL)
    ///   ESC % 0 B, ESC E        into HP-GL/2, reset    (PCL)
    ///   ESC & l 1 o 2 A         the printer's paper    (PCL)
    ///   ESC % -12345 X @PJL ..  lines for the printer  (PJL)
    /// ```
    fn escape(&mut self) -> Result<(), SourceError> {
        let rest = &self.text[self.at..];
        let digits = |from: usize| {
            let rest = rest.get(from..).unwrap_or_default();
            from + rest
                .iter()
                .take_while(|byte| b"-0123456789;".contains(byte))
                .count()
        };
        match rest.get(1) {
            Some(b'.') => {
                let end = digits(3);
                let colon = usize::from(rest.get(end) == Some(&b':'));
                self.at += (end + colon).min(rest.len());
            }
            Some(b'%') => {
                self.at += (digits(2) + 1).min(rest.len());
                self.skip_printer_lines();
            }
            Some(b'E') => self.at += 2,
            Some(b'&' | b'*' | b'(' | b')') => self.at += self.printer_setting(rest)?,
            _ => return Err(self.found("an escape sequence of a plotter: ESC . or ESC %")),
        }
        Ok(())
    }

    /// The length of a printer setting: numbers, each followed by a letter, the last one in upper
    /// case.
    fn printer_setting(&self, rest: &[u8]) -> Result<usize, SourceError> {
        let parts = rest.iter().enumerate().skip(3);
        for (i, byte) in parts {
            match byte {
                // That many bytes of a picture or a font follow.
                b'W' | b'w' => break,
                b'A'..=b'Z' | b'@' => return Ok(i + 1),
                b'a'..=b'z' | b'0'..=b'9' | b'+' | b'-' | b'.' => {}
                _ => break,
            }
        }
        Err(self.found("printer settings only; printer pictures and fonts (PCL) are not supported"))
    }

    fn skip_printer_lines(&mut self) {
        while self.text[self.at..].starts_with(b"@PJL") {
            _ = self.until(b'\n');
        }
    }

    fn numbers(&mut self) -> Result<Vec<f64>, SourceError> {
        let mut numbers = Vec::new();
        while let Some(&byte) = self.text.get(self.at) {
            match byte {
                b',' | b' ' | b'\t' | b'\r' | b'\n' => self.at += 1,
                b'0'..=b'9' | b'.' | b'+' | b'-' => {
                    let number = number(&self.text[self.at..]);
                    let (number, length) = number.ok_or_else(|| self.found(NUMBER))?;
                    numbers.push(number);
                    self.at += length;
                }
                b';' | ESC | 0..0x20 => break,
                byte if byte.is_ascii_alphabetic() => break,
                _ => return Err(self.found(NUMBER)),
            }
        }
        Ok(numbers)
    }

    /// Skips to a byte, and returns what was skipped.
    fn until(&mut self, end: u8) -> &'a [u8] {
        let rest = &self.text[self.at..];
        let length = rest.iter().position(|&byte| byte == end);
        self.at += length.map_or(rest.len(), |length| length + 1);
        &rest[..length.unwrap_or(rest.len())]
    }

    /// Parses `CO "any text"`.
    fn comment(&mut self) {
        let rest = &self.text[self.at..];
        if let Some(quote) = rest
            .iter()
            .position(|&byte| byte != b' ')
            .filter(|&i| rest[i] == b'"')
        {
            self.at += quote + 1;
            _ = self.until(b'"');
        }
    }

    /// The text of LB at an offset.
    fn label(&mut self, at: usize) -> Result<&'a [u8], SourceError> {
        let begin = self.at;
        let text = self.until(self.label_end);
        if begin + text.len() == self.text.len() {
            let expected = "ETX (character 3) after it, or the terminator set by DT";
            return Err(SourceError::found(
                self.text,
                at,
                "a label without an end",
                expected,
            ));
        }
        if text.len() > MAX_LETTERS {
            let found = format!("a label of {} characters", text.len());
            let expected = format!("at most {MAX_LETTERS}; split it");
            return Err(SourceError::found(self.text, at, found, expected));
        }
        let length = text.len() + usize::from(self.writes_end);
        Ok(&self.text[begin..begin + length])
    }

    /// Parses `DT #` or `DT #,0`, which prints the terminator too.
    fn set_label_end(&mut self) -> Result<(), SourceError> {
        self.label_end = self.character().first().copied().unwrap_or(ETX);
        self.writes_end = self.numbers()? == [0.0];
        Ok(())
    }

    /// A single character as an optional parameter.
    fn character(&mut self) -> &'a [u8] {
        let rest = &self.text[self.at..];
        let length = usize::from(rest.first().is_some_and(|&rest| rest != b';'));
        self.at += length;
        &rest[..length]
    }

    fn found(&self, expected: &str) -> SourceError {
        SourceError::unexpected(self.text, self.at, expected)
    }
}

/// The longest label; it would be kept in three copies.
const MAX_LETTERS: usize = 100_000;
const ESC: u8 = 0x1B;
const ETX: u8 = 3;
const COMMAND: &str = "a command of two letters such as PD";
const NUMBER: &str = "a number such as 40 or -2.5";
