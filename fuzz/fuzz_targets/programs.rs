//! A program that anybody writes: an error with its line, or a program that is written and read again unchanged, that
//! is made into commands or refused, and that is checked without a panic.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::programs(input));
