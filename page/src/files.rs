//! The table of the page's files.

/// A file of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct File {
    /// Where it is served, as in `/page.css`.
    pub path: &'static str,
    /// Its `Content-Type`, by the end of its name.
    pub content_type: &'static str,
    /// What is in it.
    pub bytes: &'static [u8],
}

/// All files of the folder `files/` but tests and types; the first one is what a browser opens. `build.rs` writes it.
pub const FILES: &[File] = include!(concat!(env!("OUT_DIR"), "/files.rs"));

#[cfg(test)]
mod tests {
    use super::*;

    fn find(path: &str) -> Option<&'static File> {
        FILES.iter().find(|file| file.path == path)
    }

    #[test]
    fn the_first_file_is_the_page() {
        assert_eq!(FILES[0].path, "/");
        assert_eq!(FILES[0].content_type, "text/html; charset=utf-8");
    }

    #[test]
    fn the_page_of_a_folder_is_where_the_folder_is() {
        let board = find("/fleet").map(|file| file.content_type);
        assert_eq!(board, Some("text/html; charset=utf-8"));
        assert!(find("/fleet/index.html").is_none());
    }

    #[test]
    fn files_in_folders_say_what_they_are() {
        for (path, expected) in [
            ("/vendor/three/three.js", "text/javascript; charset=utf-8"),
            ("/vendor/uplot/uplot.css", "text/css; charset=utf-8"),
            ("/vendor/lit-html/LICENSE", "text/plain; charset=utf-8"),
        ] {
            let found = find(path).map(|file| file.content_type);
            assert_eq!(found, Some(expected), "{path}");
        }
    }

    #[test]
    fn tests_and_types_are_not_served() {
        for file in FILES {
            let served = !file.path.ends_with(".test.js") && !file.path.ends_with(".d.ts");
            assert!(served, "{}", file.path);
        }
    }
}
