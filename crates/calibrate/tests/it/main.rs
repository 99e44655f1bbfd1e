//! What is found out about an arm.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod fit;
