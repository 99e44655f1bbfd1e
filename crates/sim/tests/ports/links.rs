//! Links that lead to a virtual serial port.

use super::*;

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("there is room")
}

#[test]
fn a_port_without_a_link_goes_by_its_own_name() {
    let pty = Pty::open(None).expect("there is one more");
    assert!(pty.path().starts_with("/dev"), "{}", pty.path().display());
    drop(plain_open(pty.path().to_str().expect("it is text")));
}

#[test]
fn a_link_leads_to_the_port_until_the_port_is_gone() {
    let folder = folder();
    let link = folder.path().join("arm");
    let pty = Pty::open(Some(&link)).expect("nothing is in the way");
    assert_eq!(pty.path(), link);
    drop(plain_open(link.to_str().expect("it is text")));
    drop(pty);
    assert!(!link.is_symlink());
}

#[test]
fn a_link_that_leads_nowhere_is_replaced() {
    let folder = folder();
    let link = folder.path().join("arm");
    symlink(folder.path().join("gone"), &link).expect("there is room");
    let _pty = Pty::open(Some(&link)).expect("nothing of worth is in the way");
    let target = std::fs::read_link(&link).expect("it is a link");
    assert!(target.starts_with("/dev"), "{}", target.display());
}

#[test]
fn a_file_in_the_way_is_refused_and_kept() {
    let folder = folder();
    let file = folder.path().join("arm");
    std::fs::write(&file, "dear").expect("there is room");
    let error = Pty::open(Some(&file)).expect_err("a file is in the way");
    assert_eq!(error.kind(), std::io::ErrorKind::AlreadyExists);
    assert_eq!(std::fs::read_to_string(&file).expect("it is there"), "dear");
}

#[test]
fn a_link_to_something_is_refused_and_kept() {
    let folder = folder();
    let [file, link] = ["file", "arm"].map(|name| folder.path().join(name));
    std::fs::write(&file, "dear").expect("there is room");
    symlink(&file, &link).expect("there is room");
    let error = Pty::open(Some(&link)).expect_err("a link is in the way");
    assert_eq!(error.kind(), std::io::ErrorKind::AlreadyExists);
    assert_eq!(std::fs::read_link(&link).expect("it is there"), file);
}

#[test]
fn a_link_that_somebody_put_in_its_place_is_kept() {
    let folder = folder();
    let link = folder.path().join("arm");
    let pty = Pty::open(Some(&link)).expect("nothing is in the way");
    std::fs::remove_file(&link).expect("it is there");
    symlink("elsewhere", &link).expect("there is room");
    drop(pty);
    let target = std::fs::read_link(&link).expect("it is there");
    assert_eq!(target, Path::new("elsewhere"));
}
