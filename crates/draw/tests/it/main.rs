//! Tests of executed drawings.

mod virtual_arm;
