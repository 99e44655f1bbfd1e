//! Everything that a person writes for a virtual arm: an error, but never a panic.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::texts(input));
