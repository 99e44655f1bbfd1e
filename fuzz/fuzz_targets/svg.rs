//! SVG of any kind: an error, or ink on the file's page, but never a panic.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::svg(input));
