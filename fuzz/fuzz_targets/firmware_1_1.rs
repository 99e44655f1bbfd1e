//! The twin of the stock controller: no panic and no endless loop. What is not finite is part of it,
//! but never reaches the motors.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::firmware_1_1(input));
