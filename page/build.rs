//! Generates the table of the page's files: everything in `files/` except tests and types.
//!
//! All files but the pages themselves are served in a folder named after the version of the page, a
//! digest of all of them, so a browser may keep them forever. Relative imports need no change. In
//! the pages, the style sheets are joined to one, and the modules that a script imports are listed,
//! so that a browser requests all of them at once; those of the first script, STOP, come first.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::{env, process};

use flate2::Compression;
use flate2::write::GzEncoder;
use sha2::{Digest, Sha256};

fn main() {
    println!("cargo::rerun-if-changed=files");
    println!("cargo::rerun-if-changed=build.rs");
    if let Err(error) = write_table() {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// The files, by their paths in `files/`.
type Files = BTreeMap<String, Vec<u8>>;

fn write_table() -> io::Result<()> {
    let variable = |name| {
        env::var_os(name)
            .map(PathBuf::from)
            .ok_or(io::ErrorKind::NotFound)
    };
    let folder = variable("CARGO_MANIFEST_DIR")?.join("files");
    let mut files = Files::new();
    collect(&folder, &folder, &mut files)?;
    let version = version(&files);
    for page in PAGES {
        join(page, &version, &mut files)?;
    }
    let out = variable("OUT_DIR")?.join("served");
    fs::create_dir_all(&out)?;
    // A browser opens `/` first.
    let mut paths: Vec<&String> = files.keys().collect();
    paths.sort_by_key(|path| (*path != PAGES[0], *path));
    let mut table = "&[\n".to_owned();
    for (number, path) in paths.into_iter().enumerate() {
        table += &row(&out, number, path, &files[path], &version)?;
    }
    table += "]\n";
    fs::write(out.join("files.rs"), table)?;
    fs::write(out.join("version.rs"), format!("{version:?}"))
}

/// Adds the files below a folder; parts of their paths are separated by `/` on every system.
fn collect(root: &Path, folder: &Path, files: &mut Files) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(root, &path, files)?;
            continue;
        }
        let below = path.strip_prefix(root).map_err(io::Error::other)?;
        let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
        let name = parts.join("/");
        if !name.ends_with(".test.js") && !name.ends_with(".d.ts") {
            files.insert(name, fs::read(path)?);
        }
    }
    Ok(())
}

/// Returns the version of the page: a digest of all paths and contents.
fn version(files: &Files) -> String {
    let mut all = Sha256::new();
    for (path, bytes) in files {
        all.update(format!("{path} {}\n", bytes.len()));
        all.update(bytes);
    }
    format!("page-{}", hex(&all.finalize()[..6]))
}

/// Joins the style sheets of a page, and lists the modules of its scripts.
fn join(page: &str, version: &str, files: &mut Files) -> io::Result<()> {
    let text = text_of(files, page)?;
    let (mut styles, mut scripts, mut rest) = (Vec::new(), Vec::new(), String::new());
    for line in text.lines() {
        if let Some(style) = between(line, "<link rel=\"stylesheet\" href=\"", "\">") {
            styles.push(style.to_owned());
        } else if let Some(script) = between(line, "<script type=\"module\" src=\"", "\"></script>")
        {
            scripts.push(script.to_owned());
        } else {
            rest.push_str(line);
            rest.push('\n');
        }
    }
    let mut head = format!("  <meta name=\"dobot-page\" content=\"{version}\">\n");
    let mut listed = Vec::new();
    let style = page.replace(".html", ".css");
    for (number, script) in scripts.iter().enumerate() {
        for module in modules(script, files)? {
            if !listed.contains(&module) {
                line(
                    &mut head,
                    format_args!("<link rel=\"modulepreload\" href=\"{version}/{module}\">"),
                );
                listed.push(module);
            }
        }
        line(
            &mut head,
            format_args!("<script type=\"module\" src=\"{version}/{script}\"></script>"),
        );
        if number == 0 {
            line(
                &mut head,
                format_args!("<link rel=\"stylesheet\" href=\"{version}/{style}\">"),
            );
        }
    }
    let mut joined = String::new();
    for name in styles {
        joined += &text_of(files, &name)?;
    }
    files.insert(style, joined.into_bytes());
    files.insert(
        page.to_owned(),
        rest.replacen("</head>", &format!("{head}</head>"), 1)
            .into_bytes(),
    );
    Ok(())
}

fn line(head: &mut String, text: std::fmt::Arguments<'_>) {
    writeln!(head, "  {text}").expect("a text takes all");
}

/// Returns a script and all modules that it imports, directly or not.
fn modules(script: &str, files: &Files) -> io::Result<Vec<String>> {
    let mut found = vec![script.to_owned()];
    let mut next = 0;
    while let Some(module) = found.get(next).cloned() {
        next += 1;
        for name in imports(&text_of(files, &module)?) {
            let path = resolve(&module, &name);
            if !found.contains(&path) {
                found.push(path);
            }
        }
    }
    Ok(found)
}

/// Returns what a module imports when it is loaded.
fn imports(text: &str) -> Vec<String> {
    let mut names = Vec::new();
    let code = text
        .lines()
        .filter(|line| !line.trim_start().starts_with(['/', '*']));
    for line in code {
        let parts: Vec<&str> = line.split('"').collect();
        for pair in parts.windows(2) {
            let before = pair[0].trim_end();
            if pair[1].starts_with('.') && (before.ends_with("from") || before.ends_with("import"))
            {
                names.push(pair[1].to_owned());
            }
        }
    }
    names
}

/// Returns the path of a module named in another one.
fn resolve(module: &str, name: &str) -> String {
    let mut parts: Vec<&str> = module.split('/').collect();
    parts.pop();
    for part in name.split('/') {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

fn row(out: &Path, number: usize, path: &str, bytes: &[u8], version: &str) -> io::Result<String> {
    let kind = content_type(path)?;
    let gzip = out.join(format!("{number}.gz"));
    fs::write(&gzip, compressed(bytes)?)?;
    let is_kept = !AT_ROOT.contains(&path) && !PAGES.contains(&path);
    let served = if is_kept {
        format!("/{version}/{path}")
    } else {
        format!(
            "/{}",
            path.strip_suffix("index.html")
                .unwrap_or(path)
                .trim_end_matches('/')
        )
    };
    Ok(format!(
        "File {{ path: {served:?}, content_type: {kind:?}, gzip: include_bytes!({:?}), digest: {:?}, is_kept: {is_kept} }},\n",
        gzip.display().to_string(),
        hex(&Sha256::digest(bytes)[..8]),
    ))
}

fn compressed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}

/// Returns the content type by file extension. Browsers refuse a module with another type.
fn content_type(path: &str) -> io::Result<&'static str> {
    let name = path.rsplit('/').next().unwrap_or(path);
    match name.rsplit_once('.').map(|(_, end)| end) {
        Some("html") => Ok("text/html; charset=utf-8"),
        Some("css") => Ok("text/css; charset=utf-8"),
        Some("js") => Ok("text/javascript; charset=utf-8"),
        Some("json") => Ok("application/json"),
        Some("svg") => Ok("image/svg+xml"),
        Some("toml") => Ok("application/toml; charset=utf-8"),
        Some("webmanifest") => Ok("application/manifest+json"),
        None => Ok("text/plain; charset=utf-8"),
        Some(other) => Err(io::Error::other(format!(
            "page/files/{path} has the extension .{other}; supported are .html, .css, .js, .json, .svg, .toml, .webmanifest and none; add its content type to page/build.rs"
        ))),
    }
}

fn text_of(files: &Files, path: &str) -> io::Result<String> {
    let bytes = files.get(path).ok_or_else(|| {
        io::Error::other(format!(
            "page/files/{path} does not exist, but another file names it"
        ))
    })?;
    String::from_utf8(bytes.clone()).map_err(io::Error::other)
}

fn between<'a>(line: &'a str, before: &str, after: &str) -> Option<&'a str> {
    line.trim().strip_prefix(before)?.strip_suffix(after)
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        write!(text, "{byte:02x}").expect("a text takes all");
        text
    })
}

/// The pages; each is served at the path of its folder, the first one at `/`.
const PAGES: [&str; 2] = ["index.html", "fleet/index.html"];
/// What has to be at a fixed path.
const AT_ROOT: [&str; 3] = ["icon.svg", "manifest.webmanifest", "offline.js"];
