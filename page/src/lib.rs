//! The web page of a station, as a table of files for a program that serves them.
//!
//! The files need no build: browsers get exactly the content of `files/`. [`FILES`] has one row per file.
//!
//! ```
//! let page = dobot_page::FILES[0];
//! assert_eq!(page.path, "/");
//! assert_eq!(page.content_type, "text/html; charset=utf-8");
//! assert!(page.bytes.starts_with(b"<!doctype html>"));
//! ```

mod files;

pub use files::{FILES, File};
