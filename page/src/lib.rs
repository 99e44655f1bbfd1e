//! The web page of a station: its files, as a program serves them.
//!
//! They are written by hand and need no build: what is in `files/` is what a browser gets. [`FILES`] has a row for each.
//!
//! ```
//! let page = dobot_page::FILES[0];
//! assert_eq!(page.path, "/");
//! assert_eq!(page.content_type, "text/html; charset=utf-8");
//! assert!(page.bytes.starts_with(b"<!doctype html>"));
//! ```

mod files;

pub use files::{FILES, File};
