//! A standard error without a reader.

use std::io::{PipeReader, PipeWriter, Write, pipe};

use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};

/// A pipe that takes nothing more.
pub(crate) fn full_pipe() -> (PipeReader, PipeWriter) {
    let (reader, mut writer) = pipe().expect("there is room");
    let flags = fcntl_getfl(&writer).expect("it is open");
    fcntl_setfl(&writer, flags | OFlags::NONBLOCK).expect("it is open");
    while writer.write(&[b'.'; 4096]).is_ok() {}
    while writer.write(b".").is_ok() {}
    fcntl_setfl(&writer, flags).expect("it is open");
    (reader, writer)
}
