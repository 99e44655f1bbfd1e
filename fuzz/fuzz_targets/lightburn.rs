//! Projects of `LightBurn` of any kind: an error, or ink within the limits, but never a panic.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::lightburn(input));
