//! State 5 of the stock controller: voice, over Bluetooth (notes N17 and N50).

use dobot_wire::VoiceOrder;

use super::follow::CLOSED_DEG;
use super::line::StraightLine;
use super::settings::StockSettings;
use super::target::MoveShape;
use super::{Body, Printer, Progress, TickOutcome};
use crate::Hang;

/// The words that were understood last, and what becomes of them.
#[derive(Debug, Default)]
pub(crate) struct Spoken {
    order: Option<VoiceOrder>,
    is_planned: bool,
}

/// What else goes on while an order is looked at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InFlight {
    /// The way to a target.
    pub(crate) way: Option<MoveShape>,
    /// A text of which the rest is still to come.
    pub(crate) text: bool,
    /// This is the first tick of a command from the queue.
    pub(crate) fetched: bool,
}

/// What was found in a text.
#[derive(Debug, PartialEq)]
pub(crate) struct SpokenWords {
    order: Option<VoiceOrder>,
    /// The words that were recognised, and the sum of the numbers.
    word: &'static str,
    numbers: [&'static str; 4],
    sum: u16,
}

impl Spoken {
    pub(crate) const fn clear(&mut self) {
        self.is_planned = false;
    }

    /// Takes another text; returns whether it orders anything.
    pub(crate) fn hear(&mut self, words: &SpokenWords) -> bool {
        if words.order.is_some() {
            self.order = words.order;
        }
        words.order.is_some()
    }

    /// A tick of an order. A straight line that is under way already is gone to its end; one that was
    /// ordered itself is ended by what acts at once.
    pub(crate) fn tick(
        &mut self,
        is_over: bool,
        in_flight: InFlight,
        settings: &StockSettings,
        line: &mut StraightLine,
        body: &mut Body,
    ) -> TickOutcome {
        if is_over {
            return TickOutcome::OVER;
        }
        let Some(order) = self.order else {
            body.repeats = in_flight.text;
            return TickOutcome::hangs_if(!in_flight.text, Hang::NothingSaid);
        };
        if in_flight.way == Some(MoveShape::ByJoints) {
            // It counts as planned already, and there is no line to go.
            return TickOutcome::OVER;
        }
        match order {
            _ if in_flight.way == Some(MoveShape::Line) => {}
            VoiceOrder::Catch => {
                body.repeats = !in_flight.fetched;
                body.grab(true, CLOSED_DEG);
                return TickOutcome::OVER;
            }
            VoiceOrder::Release => {
                body.repeats = !in_flight.fetched;
                body.grab(false, 0.0);
                return TickOutcome::OVER;
            }
            VoiceOrder::Move { .. } if self.is_planned => {}
            VoiceOrder::Move { x_mm, y_mm, z_mm } => {
                let from = body.pose;
                let to = [from.x_mm + x_mm, from.y_mm + y_mm, from.z_mm + z_mm];
                line.plan(from, to, settings.line);
                self.is_planned = true;
            }
        }
        match line.tick(body) {
            Progress::GoesOn => TickOutcome::GOES_ON,
            Progress::Arrived => TickOutcome::OVER,
            Progress::CutShort => TickOutcome::over(false),
        }
    }
}

impl SpokenWords {
    /// Finds words anywhere in a text, inside of others too; what follows a zero is not read.
    pub(crate) fn find(text: &[u8]) -> Self {
        let text = text.split(|&byte| byte == 0).next().unwrap_or_default();
        let first = |list: &[(&'static str, u16)]| {
            list.iter()
                .copied()
                .find(|(word, _)| contains(text, word))
                .unwrap_or_default()
        };
        let (ones, tens) = VoiceOrder::NUMBERS.split_at(9);
        let (teens, tens) = tens.split_at(10);
        let numbers = [&HUNDREDS[..], teens, tens, ones].map(first);
        let sum = numbers.iter().map(|(_, value)| value).sum();
        // The first one that is found counts.
        let mut words = VoiceOrder::WORDS.into_iter();
        let word = words.find(|(word, _)| contains(text, word));
        let (word, order) = word.map_or(("", None), |(word, order)| (word, order.times(sum)));
        Self {
            order,
            word,
            numbers: numbers.map(|(word, _)| word),
            sum,
        }
    }

    /// What is printed on the other port: the words and the sum.
    pub(crate) fn echo(&self, printer: &mut Printer) {
        printer.print(self.word.as_bytes());
        printer.print(b" ");
        for number in self.numbers {
            printer.print(number.as_bytes());
        }
        printer.print_number(self.sum.into());
    }
}

/// Whether a word is in a text, in small letters or with a capital one in front.
fn contains(text: &[u8], word: &str) -> bool {
    text.windows(word.len()).any(|part| {
        part[0].to_ascii_lowercase() == word.as_bytes()[0] && part[1..] == word.as_bytes()[1..]
    })
}

const HUNDREDS: [(&str, u16); 1] = [("hundred", 100)];
