//! Outputs that may switch a laser: M62 to M68 (`LinuxCNC`) and M42 (Marlin).

use std::collections::HashSet;

use super::block::Block;

/// The outputs that a program has switched so far.
#[derive(Debug, Default)]
pub(super) struct Outputs {
    known: HashSet<Output>,
    on: HashSet<Output>,
}

/// An output and the bits of its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Output {
    Digital(u64),
    Analog(u64),
    Pin(u64),
}

impl Outputs {
    /// Executes the codes of a block.
    pub(super) fn switch(&mut self, block: &Block) {
        let number = |letter| block.value(letter).unwrap_or(0.0);
        let bits = |letter| number(letter).to_bits();
        for &(_, code) in &block.m.0 {
            let (output, is_on) = match code {
                620 | 640 => (Output::Digital(bits(b'P')), true),
                630 | 650 => (Output::Digital(bits(b'P')), false),
                670 | 680 => (Output::Analog(bits(b'E')), number(b'Q') > 0.0),
                420 => (Output::Pin(bits(b'P')), number(b'S') > 0.0),
                _ => continue,
            };
            self.known.insert(output);
            if is_on {
                self.on.insert(output);
            } else {
                self.on.remove(&output);
            }
        }
    }

    pub(super) fn switch_all_off(&mut self) {
        self.on.clear();
    }

    /// Whether all of them are on; `None` before the first. One of them may be the laser, and
    /// another one its air assist.
    pub(super) fn are_on(&self) -> Option<bool> {
        (!self.known.is_empty()).then_some(self.on.len() == self.known.len())
    }
}

/// Whether an M code in tenths switches an output.
pub(super) const fn is_output(code: u32) -> bool {
    matches!(code, 420 | 620 | 630 | 640 | 650 | 670 | 680)
}
