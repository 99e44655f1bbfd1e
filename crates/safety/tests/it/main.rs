//! The policy: its file, and the commands that it allows.

mod desk;
mod file;
mod jogs;
mod keep_out_edits;
mod laser;
mod properties;
mod settings;
mod truth;
mod ways;
