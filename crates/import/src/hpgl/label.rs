//! Labels (LB, BL, PB, CP) and symbols at points (SM).

use dobot_geometry::{Point, Vec2};
use dobot_lettering::StrokeFont;

use super::characters::{Cell, Characters, Direction, Origin, Size};
use super::command::Command;
use super::plotter::Plotter;
use crate::error::SourceError;
use crate::text::{Lettering, composed};

/// The text state of a plotter.
#[derive(Debug, Default)]
pub(super) struct Labels {
    characters: Characters,
    /// The position of a carriage return, on the paper; `None` for that of the pen.
    pub(super) margin_mm: Option<Point>,
    /// The symbol of SM.
    symbol: Option<char>,
    /// The text that BL stores for PB.
    kept: String,
    /// Warnings that only count when the file writes a text: place, what, instead.
    unlike: Vec<(usize, &'static str, &'static str)>,
    lettering: Lettering,
}

/// The pen while it writes, on the paper in millimetres.
#[derive(Clone, Copy, Debug)]
struct Cursor {
    at: Point,
    margin: Point,
}

impl Plotter<'_> {
    /// The text commands.
    pub(super) fn text(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        match &command.name {
            b"LB" => self.write(command, &decoded(command.bytes)),
            b"PB" => self.write(command, &self.labels.kept.clone()),
            b"CP" => self.skip_cells(command),
            b"SI" | b"SR" => self.set_size(command),
            b"DI" | b"DR" => self.set_direction(command),
            b"LO" => self.set_origin(command),
            _ => self.set_style(command),
        }
    }

    /// Commands that only change the appearance of texts.
    fn set_style(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let numbers = command.numbers.as_slice();
        let first = command.number(0).unwrap_or_default();
        let labels = &mut self.labels;
        let mut unlike = |what, instead| labels.unlike.push((command.at, what, instead));
        match &command.name {
            b"BL" => labels.kept = decoded(command.bytes),
            b"SM" => labels.symbol = decoded(command.bytes).chars().find(|c| *c > ' '),
            b"SL" => labels.characters.slant = first,
            b"ES" if numbers.len() < 3 => {
                labels.characters.extra = Point::new(first, command.number(1).unwrap_or_default());
            }
            b"ES" => {
                return Err(
                    self.refused(command, "the extra width and height of the character cells")
                );
            }
            b"CS" | b"CA" if first != 0.0 => unlike(
                "character set",
                "read as Roman-8, or as UTF-8 if it is valid UTF-8 (CS)",
            ),
            b"SD" | b"AD" if !numbers.is_empty() => unlike(
                "font",
                "written in plain letters, in the size set by SI or SR (SD)",
            ),
            b"DV" if first != 0.0 => unlike("text path", "written to the right (DV)"),
            b"TD" if first != 0.0 => unlike(
                "transparent label",
                "its control characters are executed (TD)",
            ),
            _ => {}
        }
        Ok(())
    }

    fn set_size(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let is_relative = &command.name == b"SR";
        self.labels.characters.size = match *command.numbers.as_slice() {
            [] if is_relative => Size::Relative(DEFAULT_PERCENT),
            [] => Size::Default,
            [width, height] if width != 0.0 && height != 0.0 => {
                let size = if is_relative {
                    Size::Relative
                } else {
                    Size::Absolute
                };
                size(Vec2::new(width, height))
            }
            _ => return Err(self.refused(command, "a width and a height other than 0")),
        };
        Ok(())
    }

    fn set_direction(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let way = match *command.numbers.as_slice() {
            [] => Vec2::new(1.0, 0.0),
            [run, rise] => Vec2::new(run, rise),
            _ => return Err(self.refused(command, "a direction as run,rise")),
        };
        if way.length() == 0.0 {
            self.warn(command, "zero direction", "ignored (DI or DR)");
            return Ok(());
        }
        self.labels.characters.direction = if &command.name == b"DR" {
            Direction::Relative(way)
        } else {
            Direction::Absolute(way)
        };
        self.labels.margin_mm = None;
        Ok(())
    }

    fn set_origin(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let mut number = command.number(0).unwrap_or(1.0);
        if number == PCL_ORIGIN {
            let instead = "read as LO 1 (LO 21)";
            self.labels
                .unlike
                .push((command.at, "PCL label origin", instead));
            number = 1.0;
        }
        let origin = Origin::of(number)
            .ok_or_else(|| self.refused(command, "an origin from 1 to 9 or from 11 to 19"))?;
        self.labels.characters.origin = origin;
        self.labels.margin_mm = None;
        Ok(())
    }

    /// CP: moves by this many cells to the right and up, or to the next line.
    fn skip_cells(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let cell = self.cell(command);
        let mut cursor = self.cursor();
        match *command.numbers.as_slice() {
            [] => {
                cursor.lines(&cell, -1.0);
                cursor.at = cursor.margin;
            }
            [spaces, lines] => {
                cursor.at += cell.advance * spaces;
                cursor.lines(&cell, lines);
            }
            _ => return Err(self.refused(command, "the numbers of spaces and lines, or nothing")),
        }
        self.put_pen(command, cursor)
    }

    /// Writes from the pen on, and moves the pen after the label.
    fn write(&mut self, command: &Command<'_>, text: &str) -> Result<(), SourceError> {
        if text.is_empty() {
            return Ok(());
        }
        let cell = self.cell(command);
        let has_pen = self.select(command)?;
        self.end_dashes()?;
        let mut cursor = self.cursor();
        for line in text.split_inclusive('\r') {
            let pen = cursor.at;
            let start = cell.start(columns(line));
            cursor.at = pen + start;
            for character in line.chars() {
                self.character(command, character, &cell, &mut cursor, has_pen)?;
            }
            if !line.ends_with('\r') {
                cursor.at = if cell.continues() {
                    cursor.at - start
                } else {
                    cursor.margin
                };
            }
        }
        self.put_pen(command, cursor)
    }

    fn character(
        &mut self,
        command: &Command<'_>,
        character: char,
        cell: &Cell,
        cursor: &mut Cursor,
        has_pen: bool,
    ) -> Result<(), SourceError> {
        match character {
            '\r' => cursor.at = cursor.margin,
            '\n' => cursor.lines(cell, -1.0),
            '\u{8}' => cursor.at -= cell.advance,
            '\t' => {
                cursor.at += cell.advance * TAB;
                self.warn(command, "label tab", "read as five spaces");
            }
            command if command.is_control() => {}
            _ => {
                if has_pen {
                    self.letter(command, character, cell, cursor.at)?;
                }
                cursor.at += cell.advance;
            }
        }
        Ok(())
    }

    fn letter(
        &mut self,
        command: &Command<'_>,
        character: char,
        cell: &Cell,
        at: Point,
    ) -> Result<(), SourceError> {
        let lettering = &mut self.labels.lettering;
        let ink = lettering.extent(character).unwrap_or_default().ink;
        let pose = cell.pose(at, ink);
        lettering.write(&mut self.sketch, command.at, character, &pose)
    }

    /// SM: marks the position of the pen.
    pub(super) fn mark(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let Some(symbol) = self.labels.symbol.filter(|_| !self.polygon.is_open) else {
            return Ok(());
        };
        let cell = self.cell(command);
        if self.select(command)? {
            let at = self.transform.point(self.at) - (cell.across + cell.up) * 0.5;
            self.end_dashes()?;
            self.letter(command, symbol, &cell, at)?;
        }
        Ok(())
    }

    /// The cell of the next character.
    fn cell(&mut self, command: &Command<'_>) -> Cell {
        for (at, what, instead) in std::mem::take(&mut self.labels.unlike) {
            self.sketch.warn(at, what, instead);
        }
        let characters = self.labels.characters;
        if characters.size == Size::Default {
            let instead = "written as for an A4 sheet, 1.87 mm wide, 2.69 mm tall (no SI or SR)";
            self.warn(command, "sizeless text", instead);
        }
        characters.cell(&self.transform)
    }

    fn cursor(&self) -> Cursor {
        let at = self.transform.point(self.at);
        let margin = self.labels.margin_mm.unwrap_or(at);
        Cursor { at, margin }
    }

    fn put_pen(&mut self, command: &Command<'_>, cursor: Cursor) -> Result<(), SourceError> {
        self.sketch.check(command.at, cursor.margin)?;
        self.at = self
            .transform
            .point_at(self.sketch.check(command.at, cursor.at)?);
        self.labels.margin_mm = Some(cursor.margin);
        self.sketch.lift();
        self.is_dot = false;
        Ok(())
    }

    /// IN and DF: resets all text settings.
    pub(super) fn reset_labels(&mut self) {
        let lettering = std::mem::take(&mut self.labels.lettering);
        self.labels = Labels {
            lettering,
            ..Labels::default()
        };
    }
}

impl Cursor {
    /// Moves up by this many lines, the position of a carriage return too.
    fn lines(&mut self, cell: &Cell, count: f64) {
        let way = cell.line * count;
        (self.at, self.margin) = (self.at + way, self.margin + way);
    }
}

/// The width of a line, in cells.
fn columns(line: &str) -> f64 {
    line.chars()
        .fold(0.0, |columns: f64, character| match character {
            '\u{8}' => (columns - 1.0).max(0.0),
            '\t' => columns + TAB,
            character if character.is_control() => columns,
            _ => columns + 1.0,
        })
}

/// Decodes UTF-8 if valid, else Roman-8, the encoding of plotters.
fn decoded(bytes: &[u8]) -> String {
    let roman = |byte: u8| match byte {
        0..0x80 => char::from(byte),
        0x80..0xA0 => char::REPLACEMENT_CHARACTER,
        _ => ROMAN_8
            .chars()
            .nth(usize::from(byte) - 0xA0)
            .unwrap_or(char::REPLACEMENT_CHARACTER),
    };
    match std::str::from_utf8(bytes) {
        Ok(text) => composed(text, StrokeFont::Sans).into_owned(),
        Err(_) => bytes.iter().copied().map(roman).collect(),
    }
}

/// The place of a text in PCL, the printer language.
const PCL_ORIGIN: f64 = 21.0;
/// The default of SR without numbers.
const DEFAULT_PERCENT: Vec2 = Vec2::new(0.75, 1.5);
/// In cells; the reference does not specify it, printers of HP use it.
const TAB: f64 = 5.0;
/// The characters from 160 on.
const ROMAN_8: &str = "\u{A0}ÀÂÈÊËÎÏ´ˋˆ¨˜ÙÛ₤¯Ýý°ÇçÑñ¡¿¤£¥§ƒ¢âêôûáéóúàèòùäëöü\
    ÅîØÆåíøæÄìÖÜÉïßÔÁÃãÐðÍÌÓÒÕõŠšÚŸÿÞþ·µ¶¾—¼½ªº«■»±";
