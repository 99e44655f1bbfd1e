//! Speed profiles and the ways in which the original Dobot Arm moves.

#![no_std]
