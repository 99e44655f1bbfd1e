//! Tests of executed drawings.

mod cancelled;
mod virtual_arm;
