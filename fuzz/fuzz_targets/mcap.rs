//! Recordings that anybody hands on, whole and damaged: what is read comes from the bytes that are
//! told to be good, and never a panic.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::mcap(input));
