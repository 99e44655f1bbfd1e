//! The controller of the original Dobot Arm as an engine: bytes in, bytes out, time is an argument.

#![no_std]
