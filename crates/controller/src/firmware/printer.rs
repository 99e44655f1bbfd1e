//! The port that is not served: text comes out of it (note N39).

use core::fmt::{self, Write as _};

use heapless::Deque;

/// What is printed on the other port. Nobody has to fetch it: the oldest is displaced.
#[derive(Debug, Default)]
pub(crate) struct Printer(Deque<u8, PRINTED_LEN>);

impl Printer {
    pub(crate) fn poll(&mut self) -> Option<u8> {
        self.0.pop_front()
    }

    pub(crate) fn print(&mut self, text: fmt::Arguments<'_>) {
        self.write_fmt(text).expect("it takes whatever comes");
    }
}

impl fmt::Write for Printer {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            if self.0.is_full() {
                self.0.pop_front();
            }
            self.0.push_back(byte).expect("room was made just above");
        }
        Ok(())
    }
}

const PRINTED_LEN: usize = 256;
