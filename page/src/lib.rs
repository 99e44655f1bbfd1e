//! The web page of a station, as a table of files for a program that serves them.
//!
//! Browsers get the content of `files/`; [`FILES`] has one row per file. Only the pages are changed by the build: their style
//! sheets are joined, and the addresses of their files contain the version of the page.
//!
//! ```
//! let page = dobot_page::FILES[0];
//! assert_eq!(page.path, "/");
//! assert_eq!(page.content_type, "text/html; charset=utf-8");
//! assert!(page.bytes.starts_with(b"<!doctype html>"));
//! ```

mod files;

pub use files::{FILES, File, VERSION};
