//! Scenarios on simulated time: a list of steps and expectations.

mod bad_input;
mod jogging;
mod lab;
mod moving;
mod queue;
mod twin;
mod writing;
