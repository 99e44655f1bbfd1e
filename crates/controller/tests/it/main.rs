//! Scenarios on simulated time: each reads like a page of a lab notebook.

mod bad_input;
mod jogging;
mod lab;
mod moving;
mod queue;
mod twin;
mod writing;
