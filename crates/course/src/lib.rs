//! Where a command leads the arm: the motion model that client, safety and controller share.

#![no_std]
