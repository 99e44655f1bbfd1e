//! Stored files of a station.

use std::fs;

use crate::support::up::Up;

const SVG: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1H8" stroke="red"/></svg>"#;

#[test]
fn files_are_stored_listed_fetched_and_deleted() {
    let up = Up::new(&[]);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("line.svg");
    fs::write(&path, SVG).expect("it is written");
    let path = path.display().to_string();
    up.dobot(&["files", "put", &path]).succeeds();
    let list = up.dobot(&["files"]).succeeds();
    assert!(
        list.stdout.contains("drawing") && list.stdout.contains("line.svg"),
        "{list:?}"
    );
    let found = up.dobot(&["files", "list", "nothing"]).succeeds();
    assert_eq!(found.stdout, "");
    let content = up
        .dobot(&["files", "get", "line.svg", "--out", "-"])
        .succeeds();
    assert_eq!(content.stdout, SVG);
    // An existing file of this computer stays unless a person wants otherwise.
    up.dobot(&["files", "get", "1", "--out", &path])
        .fails(1, &["--force"]);
    up.dobot(&["files", "rm", "line.svg"]).succeeds();
    up.dobot(&["files", "get", "line.svg"])
        .fails(1, &["dobot files"]);
}

#[test]
fn a_name_that_is_taken_needs_a_decision() {
    let up = Up::new(&[]);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("line.svg");
    let put = |content: &str, arguments: &[&str]| {
        fs::write(&path, content).expect("it is written");
        let path = path.display().to_string();
        up.dobot(&[&["files", "put", &*path], arguments].concat())
    };
    put(SVG, &[]).succeeds();
    put("other", &[]).fails(1, &["--keep-both"]);
    put("other", &["--keep-both"]).succeeds();
    put("third", &["--replace"]).succeeds();
    let content = |name: &str| {
        up.dobot(&["files", "get", name, "--out", "-"])
            .succeeds()
            .stdout
    };
    assert_eq!(content("line.svg"), "third");
    assert_eq!(content("line (2).svg"), "other");
}
