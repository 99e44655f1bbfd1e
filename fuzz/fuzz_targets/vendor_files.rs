//! Files of the vendor's programs as they may be found: an error, or points that are written and read again unchanged.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::vendor_files(input));
