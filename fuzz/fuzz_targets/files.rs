//! Files of every format that a decoder of others reads, and packed ones: an error, or ink, but never a
//! panic, and never more memory than a drawing needs.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::files(input));
