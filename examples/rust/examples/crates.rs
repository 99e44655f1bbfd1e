//! `cargo run -p dobot-examples --example crates`: prints `docs/crates.md`, the crates and their dependencies, read from the
//! manifests.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::{fs, io};

use toml::Table;

const INTRODUCTION: &str = "\
# Crates

Written by `cargo run -p dobot-examples --example crates > docs/crates.md`; `./ci.sh doc` compares. The descriptions and the
dependencies are those of the manifests.

The package of a folder is `dobot-<folder>`. Dependencies point down only. Crates without `std` do not use the heap either.
[code-tour.md](code-tour.md) follows one command through them.

| crate | `no_std` | contents |
|---|---|---|
";

const DIAGRAM: &str = "
## Dependencies

A crate is listed above all crates that it uses. Dependencies that another one implies are left out, and so are those of
tests.

```
";

/// A crate of the workspace.
struct Crate {
    folder: String,
    description: String,
    is_no_std: bool,
    /// The names of the crates that it uses, without `dobot-`.
    uses: BTreeSet<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let crates = crates(&root)?;
    let levels = levels(&crates);
    let mut names: Vec<&String> = crates.keys().collect();
    names.sort_by_key(|&name| (std::cmp::Reverse(levels[name]), name));

    print!("{INTRODUCTION}");
    for &name in &names {
        let Crate {
            folder,
            description,
            is_no_std,
            ..
        } = &crates[name];
        let no_std = if *is_no_std { "yes" } else { "" };
        println!("| [`{name}`](../{folder}) | {no_std} | {description} |");
    }
    print!("{DIAGRAM}");
    for &name in &names {
        let uses = direct(name, &crates);
        if !uses.is_empty() {
            println!("{name:<12} -> {}", uses.join(", "));
        }
    }
    println!("```");
    Ok(())
}

fn crates(root: &Path) -> Result<BTreeMap<String, Crate>, Box<dyn Error>> {
    let mut crates = BTreeMap::new();
    for folder in folders(root)? {
        let manifest: Table = fs::read_to_string(root.join(&folder).join("Cargo.toml"))?.parse()?;
        let package = manifest["package"].as_table().ok_or("no [package]")?;
        let text = |key: &str| package.get(key).and_then(|value| value.as_str());
        let name = text("name").ok_or("no name")?.trim_start_matches("dobot-");
        let library = fs::read_to_string(root.join(&folder).join("src/lib.rs"));
        let uses = manifest
            .get("dependencies")
            .and_then(|table| table.as_table());
        let uses = uses.into_iter().flat_map(Table::keys);
        crates.insert(
            name.to_owned(),
            Crate {
                description: text("description").ok_or("no description")?.to_owned(),
                is_no_std: library.is_ok_and(|text| text.contains("#![no_std]")),
                uses: uses
                    .filter_map(|name| name.strip_prefix("dobot-"))
                    .map(str::to_owned)
                    .collect(),
                folder,
            },
        );
    }
    Ok(crates)
}

/// Returns the folders of all crates that are part of the product.
fn folders(root: &Path) -> io::Result<Vec<String>> {
    let mut folders = vec!["page".to_owned(), "python".to_owned()];
    for entry in fs::read_dir(root.join("crates"))? {
        let folder = PathBuf::from("crates").join(entry?.file_name());
        folders.extend(folder.to_str().map(str::to_owned));
    }
    Ok(folders)
}

/// Returns the number of crates below each one, on the longest path down.
fn levels(crates: &BTreeMap<String, Crate>) -> BTreeMap<String, usize> {
    fn level(name: &str, crates: &BTreeMap<String, Crate>) -> usize {
        let below = crates[name].uses.iter().map(|used| level(used, crates) + 1);
        below.max().unwrap_or(0)
    }
    let names = crates.keys();
    names
        .map(|name| (name.clone(), level(name, crates)))
        .collect()
}

/// Returns the dependencies of a crate that are not implied by its other dependencies.
fn direct<'a>(name: &str, crates: &'a BTreeMap<String, Crate>) -> Vec<&'a str> {
    fn reaches(from: &str, to: &str, crates: &BTreeMap<String, Crate>) -> bool {
        crates[from]
            .uses
            .iter()
            .any(|used| used == to || reaches(used, to, crates))
    }
    let (name, _) = crates.get_key_value(name).expect("the name of a crate");
    let uses = &crates[name].uses;
    let is_implied = |used: &str| uses.iter().any(|other| reaches(other, used, crates));
    uses.iter()
        .map(String::as_str)
        .filter(|used| !is_implied(used))
        .collect()
}
