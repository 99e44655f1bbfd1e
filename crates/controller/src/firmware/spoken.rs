//! State 5 of the stock controller: voice, over Bluetooth (notes N17 and N50).

use dobot_wire::VoiceOrder;

use super::follow::CLOSED_DEG;
use super::line::StraightLine;
use super::settings::StockSettings;
use super::{Body, Printer, Progress, TickOutcome};
use crate::Hang;

/// The last recognized words and the state of their order.
#[derive(Debug, Default)]
pub(crate) struct Spoken {
    order: Option<VoiceOrder>,
}

/// Other activity during a tick of an order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InFlight {
    /// A text is only partly received.
    pub(crate) text: bool,
    /// This is the first tick of a command from the queue.
    pub(crate) fetched: bool,
}

/// The words found in a text.
#[derive(Debug, PartialEq)]
pub(crate) struct SpokenWords {
    order: Option<VoiceOrder>,
    /// The recognised words and the sum of the numbers.
    word: &'static str,
    numbers: [&'static str; 4],
    sum: u16,
}

impl Spoken {
    /// Handles a text; returns whether it contains an order.
    pub(crate) const fn receive(&mut self, words: &SpokenWords) -> bool {
        self.order = words.order;
        words.order.is_some()
    }

    /// Runs a tick of an order, as its own command or in place of an interrupted one. If that one was
    /// already planned, a direction is not planned again: the last line continues.
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
        // Without a line, no new increment is calculated for the motors.
        let repeats = !in_flight.fetched;
        let Some(order) = self.order else {
            body.repeats = repeats;
            return TickOutcome::hangs_if(!in_flight.text, Hang::NothingSaid);
        };
        match order {
            VoiceOrder::Catch => {
                body.repeats = repeats;
                body.grab(true, CLOSED_DEG);
                return TickOutcome::OVER;
            }
            VoiceOrder::Release => {
                body.repeats = repeats;
                body.grab(false, 0.0);
                return TickOutcome::OVER;
            }
            VoiceOrder::Move { x_mm, y_mm, z_mm } if !body.is_planned => {
                // Exactly one is not 0: the line is along its axis.
                let by = [x_mm, y_mm, z_mm];
                let direction = by.map(|mm| if mm == 0.0 { 0.0 } else { 1.0_f32.copysign(mm) });
                let length = by.map(f32::abs).into_iter().sum();
                line.plan_along(body, direction, length, settings.line);
                body.is_planned = true;
                if settings.line.speed == 0.0 {
                    return TickOutcome::OVER;
                }
            }
            VoiceOrder::Move { .. } => {}
        }
        match line.tick(body) {
            Progress::GoesOn => TickOutcome::GOES_ON,
            Progress::Arrived => TickOutcome::OVER,
            Progress::CutShort => TickOutcome::over(false),
        }
    }
}

impl SpokenWords {
    /// Finds words anywhere in a text, even inside other words; stops at a zero byte.
    pub(crate) fn find(text: &[u8]) -> Self {
        let text = text.split(|&byte| byte == 0).next().unwrap_or_default();
        let first = |list: &[(&'static str, u16)]| {
            list.iter()
                .copied()
                .find(|(word, _)| contains(text, word, Case::Lower))
                .unwrap_or_default()
        };
        let (ones, tens) = VoiceOrder::NUMBERS.split_at(9);
        let (teens, tens) = tens.split_at(10);
        let numbers = [&HUNDREDS[..], teens, tens, ones].map(first);
        let sum = numbers.iter().map(|(_, value)| value).sum();
        // The first match counts; capitalised words are searched only if there is none.
        let find = |case| {
            let mut words = VoiceOrder::WORDS.into_iter();
            words.find(|(word, _)| contains(text, word, case))
        };
        let word = find(Case::Lower).or_else(|| find(Case::Capitalised));
        let (word, order) = word.map_or(("", None), |(word, order)| (word, order.times(sum)));
        Self {
            order,
            word,
            numbers: numbers.map(|(word, _)| word),
            sum,
        }
    }

    /// Prints the words and the sum on the other port.
    pub(crate) fn echo(&self, printer: &mut Printer) {
        printer.print(self.word.as_bytes());
        printer.print(b" ");
        for number in self.numbers {
            printer.print(number.as_bytes());
        }
        printer.print_number(self.sum.into());
    }
}

/// How a word is spelled.
#[derive(Clone, Copy)]
enum Case {
    Lower,
    /// With a capital first letter.
    Capitalised,
}

fn contains(text: &[u8], word: &str, case: Case) -> bool {
    let Some((&first, rest)) = word.as_bytes().split_first() else {
        return true;
    };
    let first = match case {
        Case::Lower => first,
        Case::Capitalised => first.to_ascii_uppercase(),
    };
    text.windows(word.len())
        .any(|part| part.split_first() == Some((&first, rest)))
}

const HUNDREDS: [(&str, u16); 1] = [("hundred", 100)];
