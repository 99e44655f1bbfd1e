//! The `dobot` program.

fn main() {}
