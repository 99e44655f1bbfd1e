//! The safety policy: what no command of any client may do.
