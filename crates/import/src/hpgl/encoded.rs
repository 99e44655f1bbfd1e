//! PE: lines with numbers encoded in letters.
//!
//! A number is doubled, plus one if it is negative, and written in base 64, smallest digit first:
//! from `?` (63) on, the last digit from 191 on. With 7 bits the base is 32 and the last digit is
//! from 95 on.

/// A step of PE.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum EncodedItem {
    /// Selects a pen.
    Pen(f64),
    /// Moves the pen.
    Go {
        x: f64,
        y: f64,
        /// Whether the coordinates count from the origin, not from the pen.
        is_absolute: bool,
        is_up: bool,
    },
}

/// Decodes the letters of PE. The error describes what is wrong, and at which byte.
pub(super) fn items(
    encoded: &[u8],
) -> impl Iterator<Item = Result<EncodedItem, (usize, &'static str)>> {
    let mut decoder = Decoder {
        bytes: encoded,
        at: 0,
        has_7_bits: false,
        unit: 1.0,
    };
    std::iter::from_fn(move || decoder.item().transpose())
}

struct Decoder<'a> {
    bytes: &'a [u8],
    at: usize,
    has_7_bits: bool,
    /// The value of a digit: fractions have binary digits.
    unit: f64,
}

impl Decoder<'_> {
    fn item(&mut self) -> Result<Option<EncodedItem>, (usize, &'static str)> {
        let (mut is_absolute, mut is_up) = (false, false);
        while let Some(byte) = self.peek() {
            self.at += 1;
            match byte & self.mask() {
                b'<' => is_up = true,
                b'=' => is_absolute = true,
                b'7' => self.has_7_bits = true,
                b'>' => self.fraction()?,
                b':' => return Ok(Some(EncodedItem::Pen(self.number()? / self.unit))),
                _ => {
                    self.at -= 1;
                    let (x, y) = (self.number()?, self.number()?);
                    return Ok(Some(EncodedItem::Go {
                        x,
                        y,
                        is_absolute,
                        is_up,
                    }));
                }
            }
        }
        Ok(None)
    }

    fn fraction(&mut self) -> Result<(), (usize, &'static str)> {
        self.unit = 1.0;
        let at = self.at;
        let bits = self.number()?;
        if !(-26.0..=26.0).contains(&bits) {
            return Err((at, "from -26 to 26 bits of fraction"));
        }
        self.unit = (-bits).exp2();
        Ok(())
    }

    fn number(&mut self) -> Result<f64, (usize, &'static str)> {
        let (bits, last) = if self.has_7_bits { (5, 95) } else { (6, 191) };
        let mut value = 0_u64;
        for shift in (0..MAX_BITS).step_by(bits) {
            let digit = self.peek().map(|next| next & self.mask());
            let digit = digit.filter(|&digit| digit >= 63 && digit < last + (1 << bits));
            let digit = digit.ok_or((self.at, DIGIT))?;
            self.at += 1;
            let is_last = digit >= last;
            let base = if is_last { last } else { 63 };
            if u32::from(digit - base) >= 1 << bits {
                return Err((self.at - 1, DIGIT));
            }
            value |= u64::from(digit - base) << shift;
            if is_last {
                return Ok(self.signed(value));
            }
        }
        Err((self.at, "a number of at most 48 bits"))
    }

    fn signed(&self, value: u64) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "of at most 52 bits")]
        let size = (value >> 1) as f64 * self.unit;
        if value & 1 == 1 { -size } else { size }
    }

    /// The next significant byte.
    fn peek(&mut self) -> Option<u8> {
        while self.bytes.get(self.at)? & 0x7F <= b' ' {
            self.at += 1;
        }
        self.bytes.get(self.at).copied()
    }

    const fn mask(&self) -> u8 {
        if self.has_7_bits { 0x7F } else { 0xFF }
    }
}

const MAX_BITS: usize = 48;
const DIGIT: &str = "a digit of an encoded number";
