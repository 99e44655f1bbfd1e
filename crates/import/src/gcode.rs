//! The G-code reader, for files of laser software, plotter posts and mills.
//!
//! G-code moves a machine and does not declare which moves leave ink. The reader infers the rule
//! from the whole file: see [`ink_rule::InkRule`].

mod arc;
mod block;
mod codes;
mod grbl_servo;
mod high_pen;
mod ink;
mod ink_rule;
mod laser;
mod machine;
mod outputs;
mod ramp;
mod servo;
mod spindle;
mod subroutine;
mod switch;
mod zero;

use dobot_geometry::CancelToken;

use self::ink::Inker;
use self::ink_rule::{InkRule, MoveStatistics};
use self::laser::{LaserCodes, LaserState};
use self::machine::{Machine, Move, ToolState};
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::limits::MAX_SEGMENTS;
use crate::options::ReadOptions;
use crate::sketch::{REST_LEFT_OUT, Sketch, Y};
use crate::warning::Warning;
use crate::warning::Warnings;

/// Reads G-code: lines and arcs of the XY plane, upright (Y points up), moved so that the ink
/// starts at the page's corner.
///
/// Each tool is a layer; for a laser, each combination of power and speed.
pub(crate) fn read(
    text: &[u8],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let (sketch, rule) = sketch(text, options)?;
    sketch.finish(Y::Up, rule.nothing(options.burns))
}

/// The ink in the program's coordinates, and its rule.
fn sketch<'a>(text: &'a [u8], options: &ReadOptions) -> Result<(Sketch<'a>, InkRule), SourceError> {
    let mut sketch = Sketch::new(text, options)?;
    let mut statistics = MoveStatistics::default();
    let mut moves = 0;
    let cancel = &options.cancel;
    let codes = LaserCodes::of(text, cancel);
    let machine = Machine::new(text, codes, sketch.warnings());
    let program = run(machine, usize::MAX, cancel, |motion| {
        moves += 1;
        if moves > MAX_MOVES {
            let found = format!("more than {MAX_MOVES} moves");
            let expected = "at most that in a drawing; simplify it, or draw it in parts";
            return Err(SourceError::limit(text, motion.at, found, expected));
        }
        statistics.count(motion);
        Ok(())
    });
    sketch.skip_mistake(program.read, REST_LEFT_OUT)?;
    let end = (program.tool, program.laser);
    let switch = options.burns.then(|| statistics.laser_switch(end.1));
    let rule = statistics.rule(text, end, options);
    rule.report(sketch.warnings(), options.gcode);
    let mut inker = Inker::new(&mut sketch, rule, switch);
    let warnings = &mut Warnings::new(text);
    let machine = Machine::new(text, codes, warnings);
    let drawn = run(machine, program.lines, cancel, |motion| inker.draw(motion));
    inker.finish()?;
    sketch.skip_mistake(drawn.read, REST_LEFT_OUT)?;
    Ok((sketch, rule))
}

/// A program that was run up to its end or its first mistake.
struct Program {
    /// The tool and the laser there.
    tool: ToolState,
    laser: LaserState,
    /// The number of lines before the mistake, those of subroutines at each call.
    lines: usize,
    read: Result<(), SourceError>,
}

/// Runs at most `most` lines of the program and passes its moves on.
fn run(
    mut machine: Machine<'_, '_>,
    most: usize,
    cancel: &CancelToken,
    mut hand_on: impl FnMut(&Move) -> Result<(), SourceError>,
) -> Program {
    let (lines, read) = block::each(machine.text(), most, |block| {
        cancel.check()?;
        machine.handle(block, &mut hand_on)
    });
    let (tool, laser) = machine.state();
    Program {
        tool,
        laser,
        lines,
        read,
    }
}

/// The largest number of moves: lines of a drawing and travels; all are analysed before the first
/// is drawn.
const MAX_MOVES: usize = MAX_SEGMENTS / 2 * 3;

/// A word such as `G21`, or what may precede the first word.
pub(crate) fn is_likely(start: &str) -> bool {
    let mut letters = start.chars();
    let first = letters.next().unwrap_or_default().to_ascii_uppercase();
    let second = letters.find(|letter| *letter != ' ').unwrap_or_default();
    "%(;$/".contains(first)
        || ("FGMNSTXYZ".contains(first) && (second.is_ascii_digit() || "-.".contains(second)))
}

#[cfg(test)]
mod tests;
