//! The packets of the original Dobot Arm: bytes, frames, commands and statuses.

#![no_std]
