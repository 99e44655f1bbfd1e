//! Stored files on the disk: limits, full disks, crashes, damage.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use std::path::Path;

use super::store::{MOST_BYTES, write};
use super::*;

fn new(name: &str, content: &[u8]) -> NewFile {
    NewFile {
        name: name.into(),
        content: data_encoding::BASE64.encode(content),
        options: None,
        existing: Existing::Refuse,
    }
}

fn replacing(revision: u64, content: &[u8]) -> ChangeFile {
    ChangeFile {
        revision,
        name: None,
        content: Some(data_encoding::BASE64.encode(content)),
        options: None,
    }
}

/// A disk that is full for contents of more than four bytes, and for what is known about files
/// named `full`.
fn write_on_full_disk(path: &Path, content: &[u8]) -> io::Result<()> {
    let is_content = !path.ends_with("about.json");
    let text = String::from_utf8_lossy(content);
    if (is_content && content.len() > 4) || text.contains("full") {
        // As a disk does that is full in the middle.
        let _ = std::fs::create_dir_all(path.parent().unwrap());
        let _ = std::fs::write(path.with_extension("new-1"), &content[..1]);
        return Err(io::ErrorKind::StorageFull.into());
    }
    write(path, content)
}

/// The names of all files below a folder, sorted.
fn below(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            names.extend(below(&path));
        } else {
            names.push(path.file_name().unwrap().to_str().unwrap().to_owned());
        }
    }
    names.sort();
    names
}

#[tokio::test]
async fn files_are_there_again_after_a_restart_with_their_placement_and_result() {
    let folder = tempfile::tempdir().unwrap();
    let files = StoredFiles::new(folder.path().join("files"));
    let (a, is_new) = files.add(new("a.svg", b"<svg/>")).await.unwrap();
    assert!(is_new);
    let options: Options = serde_json::from_str(r#"{"place": {"at": [200, 30]}}"#).unwrap();
    files
        .set_job(a.file, 7, Some(options.clone()))
        .await
        .unwrap();
    files
        .finish_job(7, JobPhase::Done, Some(12.5))
        .await
        .unwrap();
    let again = StoredFiles::new(folder.path().join("files"));
    let view = again.view(a.file).await.unwrap();
    assert_eq!((&*view.name, view.revision), ("a.svg", 1));
    assert_eq!(view.options, Some(options));
    let job = view.last_job.unwrap();
    assert_eq!(
        (job.job, job.phase, job.took_s),
        (7, JobPhase::Done, Some(12.5))
    );
    assert_eq!(again.content(a.file).await.unwrap(), b"<svg/>");
    again.remove(a.file).await.unwrap();
    assert_eq!(below(folder.path()), [""; 0]);
}

#[tokio::test]
async fn a_full_disk_leaves_everything_as_it_was_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let files = StoredFiles::with_room(folder.path().into(), write_on_full_disk, MOST_BYTES);
    let (a, _) = files.add(new("a.svg", b"old")).await.unwrap();
    let problem = files.change(a.file, replacing(1, b"newer content")).await;
    let problem = problem.unwrap_err();
    assert_eq!(problem.name(), "files-unusable");
    assert!(problem.hint.unwrap().contains("free disk space"));
    let second = files.add(new("b.svg", b"newer content")).await;
    assert_eq!(second.unwrap_err().name(), "files-unusable");
    let named = files.add(new("full.svg", b"abc")).await;
    assert_eq!(named.unwrap_err().name(), "files-unusable");
    // The same after a restart, which removes what is left over.
    for files in [files, StoredFiles::new(folder.path().into())] {
        let view = files.view(a.file).await.unwrap();
        assert_eq!(view.revision, 1);
        assert_eq!(files.content(a.file).await.unwrap(), b"old");
        assert_eq!(files.list(String::new()).await.unwrap().files.len(), 1);
    }
    assert_eq!(below(folder.path()), ["about.json", "content-1"]);
}

#[tokio::test]
async fn a_crash_between_two_writes_loses_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let files = StoredFiles::new(folder.path().into());
    let (a, _) = files.add(new("a.svg", b"old")).await.unwrap();
    let place = folder.path().join(a.file.to_string());
    // A new content was written, and what is known about the file not yet; another file has no more.
    std::fs::write(place.join("content-2"), b"newer").unwrap();
    std::fs::create_dir(folder.path().join("9")).unwrap();
    std::fs::write(folder.path().join("9/content-1"), b"x").unwrap();
    let files = StoredFiles::new(folder.path().into());
    assert_eq!(files.content(a.file).await.unwrap(), b"old");
    assert_eq!(below(folder.path()), ["about.json", "content-1"]);
    // Its number is not used again.
    let (next, _) = files.add(new("b.svg", b"b")).await.unwrap();
    assert_eq!(next.file, 10);
}

#[tokio::test]
async fn a_damaged_file_is_reported_and_kept_and_the_others_work() {
    let folder = tempfile::tempdir().unwrap();
    let files = StoredFiles::new(folder.path().into());
    for name in ["a.svg", "b.svg", "c.svg"] {
        files.add(new(name, name.as_bytes())).await.unwrap();
    }
    std::fs::write(folder.path().join("1/about.json"), "{").unwrap();
    std::fs::write(folder.path().join("2/content-1"), "shorter").unwrap();
    std::fs::write(folder.path().join("2/content-1"), "x").unwrap();
    let files = StoredFiles::new(folder.path().into());
    let list = files.list(String::new()).await.unwrap();
    assert_eq!(list.damaged.len(), 2, "{:?}", list.damaged);
    assert_eq!(list.files.len(), 1);
    assert!(folder.path().join("2/content-1").exists());
    let (next, _) = files.add(new("d.svg", b"d")).await.unwrap();
    assert_eq!(next.file, 4);
}

#[tokio::test]
async fn when_the_space_is_used_up_the_largest_files_are_named() {
    let folder = tempfile::tempdir().unwrap();
    // Nothing is written: only the sizes matter.
    let files = StoredFiles::with_room(folder.path().into(), |_, _| Ok(()), 3_000_000);
    let size = 1_000_000;
    for (name, bytes) in [
        ("small.svg", 10),
        ("one.png", size),
        ("two.png", size),
        ("three.png", size - 20),
    ] {
        let content = vec![u8::try_from(name.len()).unwrap(); bytes];
        files.add(new(name, &content)).await.unwrap();
    }
    let full = files.add(new("more.svg", &[7; 20])).await.unwrap_err();
    assert_eq!(full.name(), "files-full");
    assert!(full.detail.contains("3.0 MB"), "{}", full.detail);
    let hint = full.hint.unwrap();
    assert!(
        hint.contains("one.png") && !hint.contains("small.svg"),
        "{hint}"
    );
    // A smaller content in place of a large one fits.
    files.change(2, replacing(1, b"less")).await.unwrap();
    files.add(new("more.svg", &[7; 20])).await.unwrap();
}
