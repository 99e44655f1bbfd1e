//! The controller that follows the document: no panic, and never a status that is not finite, nor a
//! joint beyond its limit.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::specification(input));
