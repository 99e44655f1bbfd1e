//! Pictures with 16 bits per value.

use super::decode::on_paper;

/// Grey pixels with 16 bits per value.
#[derive(Debug, Default)]
pub(super) struct DeepPixels {
    grey: Vec<u16>,
    /// Empty if no pixel is transparent.
    alpha: Vec<u8>,
}

impl DeepPixels {
    pub(super) fn add(&mut self, grey: u16) {
        self.grey.push(grey);
    }

    pub(super) fn add_transparent(&mut self, grey: u16, alpha: u16) {
        self.grey.push(grey);
        self.alpha.push((alpha >> 8) as u8);
    }

    /// The pixels with 8 bits. Cameras and scanners store 10 to 14 bits in 16: if no value uses the
    /// upper two bits, the largest one is white.
    pub(super) fn shallow(self, paper: u8) -> Vec<u8> {
        let largest = self.grey.iter().copied().max().unwrap_or_default();
        let white = if largest > FEW_BITS {
            u16::MAX
        } else {
            largest.max(1)
        };
        let grey = self.grey.into_iter().map(|grey| {
            let share = (u32::from(grey) * 255 + u32::from(white) / 2) / u32::from(white);
            u8::try_from(share).expect("a share of 255")
        });
        if self.alpha.is_empty() {
            return grey.collect();
        }
        let pixels = grey.zip(self.alpha);
        pixels
            .map(|(grey, alpha)| on_paper(grey, alpha, paper))
            .collect()
    }
}

/// The largest value of 14 bits.
const FEW_BITS: u16 = 0x3fff;
