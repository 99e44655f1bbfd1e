//! Debug text on the unused port (note N39).

/// The text printed on the other port. If it is not fetched, the oldest bytes are overwritten.
#[derive(Debug)]
pub(crate) struct Printer {
    /// A ring with an 8-bit index.
    bytes: [u8; LEN],
    next_in: u8,
    count: usize,
}

impl Default for Printer {
    fn default() -> Self {
        Self {
            bytes: [0; LEN],
            next_in: 0,
            count: 0,
        }
    }
}

impl Printer {
    /// Takes the oldest byte.
    pub(crate) fn poll(&mut self) -> Option<u8> {
        let first = (usize::from(self.next_in) + LEN - self.count) % LEN;
        self.count = self.count.checked_sub(1)?;
        Some(self.bytes[first])
    }

    pub(crate) fn print(&mut self, text: &[u8]) {
        let mut next_in = self.next_in;
        for byte in text {
            self.bytes[usize::from(next_in)] = *byte;
            next_in = next_in.wrapping_add(1);
        }
        self.next_in = next_in;
        self.count = (self.count + text.len()).min(LEN);
    }

    pub(crate) fn print_number(&mut self, mut number: u32) {
        let mut digits = [0; 10];
        let mut first = digits.len();
        loop {
            first -= 1;
            digits[first] = b"0123456789"[(number % 10) as usize];
            number /= 10;
            if number == 0 {
                break;
            }
        }
        self.print(&digits[first..]);
    }
}

const LEN: usize = 1 << u8::BITS;

#[cfg(test)]
mod tests {
    use super::*;

    fn text(mut printer: Printer) -> heapless::Vec<u8, LEN> {
        core::iter::from_fn(|| printer.poll()).collect()
    }

    #[test]
    fn numbers_are_printed_in_full() {
        let mut printer = Printer::default();
        for number in [0, 907, u32::MAX] {
            printer.print_number(number);
            printer.print(b",");
        }
        assert_eq!(text(printer), b"0,907,4294967295,");
    }

    #[test]
    fn unfetched_bytes_are_overwritten_oldest_first() {
        let mut printer = Printer::default();
        printer.print(&[b'a'; 200]);
        printer.print(&[b'b'; 100]);
        let text = text(printer);
        assert_eq!(text[..156], [b'a'; 156]);
        assert_eq!(text[156..], [b'b'; 100]);
    }
}
