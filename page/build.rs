//! Generates the table of the page's files: everything in `files/` except tests and types. Large files are compressed.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, process};

use flate2::Compression;
use flate2::write::GzEncoder;

fn main() {
    println!("cargo::rerun-if-changed=files");
    println!("cargo::rerun-if-changed=build.rs");
    if let Err(error) = write_table() {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

fn write_table() -> io::Result<()> {
    let variable = |name| {
        env::var_os(name)
            .map(PathBuf::from)
            .ok_or(io::ErrorKind::NotFound)
    };
    let folder = variable("CARGO_MANIFEST_DIR")?.join("files");
    let mut paths = Vec::new();
    collect(&folder, &folder, &mut paths)?;
    // A browser opens `/` first.
    paths.sort_by_key(|path| (path != "index.html", path.clone()));
    let out = variable("OUT_DIR")?;
    let rows: Vec<String> = paths
        .iter()
        .map(|path| row(&folder, &out, path))
        .collect::<io::Result<_>>()?;
    let table = format!("&[\n{}]\n", rows.concat());
    fs::write(out.join("files.rs"), table)
}

/// Adds the paths below a folder, separated by `/` on every system.
fn collect(root: &Path, folder: &Path, paths: &mut Vec<String>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(root, &path, paths)?;
            continue;
        }
        let below = path.strip_prefix(root).map_err(io::Error::other)?;
        let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
        let name = parts.join("/");
        if !name.ends_with(".test.js") && !name.ends_with(".d.ts") {
            paths.push(name);
        }
    }
    Ok(())
}

fn row(folder: &Path, out: &Path, path: &str) -> io::Result<String> {
    let served = served_at(path);
    let kind = content_type(path)?;
    let mut bytes = folder.join(path);
    let is_gzip = fs::metadata(&bytes)?.len() >= LARGE_BYTES;
    if is_gzip {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(&fs::read(&bytes)?)?;
        bytes = out.join(format!("{}.gz", path.replace('/', "-")));
        fs::write(&bytes, encoder.finish()?)?;
    }
    Ok(format!(
        "File {{ path: {:?}, content_type: {kind:?}, is_gzip: {is_gzip}, bytes: include_bytes!({:?}) }},\n",
        format!("/{served}"),
        bytes.display().to_string(),
    ))
}

/// The size from which a file is compressed.
const LARGE_BYTES: u64 = 32 * 1024;

/// Returns the path at which a file is served; an `index.html` is served as its folder, such as `/fleet`.
fn served_at(path: &str) -> &str {
    path.strip_suffix("index.html")
        .map_or(path, |folder| folder.trim_end_matches('/'))
}

/// Returns the content type by file extension. Browsers refuse a module with another type.
fn content_type(path: &str) -> io::Result<&'static str> {
    let name = path.rsplit('/').next().unwrap_or(path);
    match name.rsplit_once('.').map(|(_, end)| end) {
        Some("html") => Ok("text/html; charset=utf-8"),
        Some("css") => Ok("text/css; charset=utf-8"),
        Some("js") => Ok("text/javascript; charset=utf-8"),
        Some("json") => Ok("application/json"),
        Some("toml") => Ok("application/toml; charset=utf-8"),
        None => Ok("text/plain; charset=utf-8"),
        Some(other) => Err(io::Error::other(format!(
            "page/files/{path} has the extension .{other}; supported are .html, .css, .js, .json, .toml and none; add its content type to page/build.rs"
        ))),
    }
}
