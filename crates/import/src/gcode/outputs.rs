//! Outputs that may switch a laser: M62 to M68 (`LinuxCNC`) and M42 (Marlin).

use super::block::Block;

/// The outputs that a program has switched so far, and whether each is on.
#[derive(Debug, Default)]
pub(super) struct Outputs(Vec<(Output, bool)>);

/// An output.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Output {
    Digital(f64),
    Analog(f64),
    Pin(f64),
}

impl Outputs {
    /// Executes the codes of a block.
    pub(super) fn switch(&mut self, block: &Block) {
        let number = |letter| block.value(letter).unwrap_or(0.0);
        for &(_, code) in &block.m.0 {
            let (output, is_on) = match code {
                620 | 640 => (Output::Digital(number(b'P')), true),
                630 | 650 => (Output::Digital(number(b'P')), false),
                670 | 680 => (Output::Analog(number(b'E')), number(b'Q') > 0.0),
                420 => (Output::Pin(number(b'P')), number(b'S') > 0.0),
                _ => continue,
            };
            match self.0.iter_mut().find(|entry| entry.0 == output) {
                Some(entry) => entry.1 = is_on,
                None => self.0.push((output, is_on)),
            }
        }
    }

    pub(super) fn switch_all_off(&mut self) {
        self.0.iter_mut().for_each(|entry| entry.1 = false);
    }

    /// Whether all of them are on; `None` before the first. One of them may be the laser, and
    /// another one its air.
    pub(super) fn are_on(&self) -> Option<bool> {
        (!self.0.is_empty()).then(|| self.0.iter().all(|entry| entry.1))
    }
}

/// Whether an M code in tenths switches an output.
pub(super) const fn is_output(code: u32) -> bool {
    matches!(code, 420 | 620 | 630 | 640 | 650 | 670 | 680)
}
