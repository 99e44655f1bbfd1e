//! Requests that anybody sends to a station: an error, or a request that is written and read again
//! unchanged, and that the rules carry out without a panic. Jobs that are kept can be read, what
//! reaches the arm makes sense, and when the time is over that a stop promises, it is dark.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| dobot_fuzz::requests(input));
