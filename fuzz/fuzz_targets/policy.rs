//! A policy that anybody writes: an error with its line, or a policy that is written and read again
//! unchanged, and that forbids what it says.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::policy(input));
