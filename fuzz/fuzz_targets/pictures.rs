//! Pictures of every format, whole and damaged, packed with gzip too, in every style: an error, or ink on the
//! picture's page, but never a panic.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::pictures(input));
