//! The table of the page's files.

/// A file of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct File {
    /// Where it is served, as in `/page.css`.
    pub path: &'static str,
    /// What it is for, in a line.
    pub summary: &'static str,
    /// Its `Content-Type`. Browsers refuse a module that does not say that it is one.
    pub content_type: &'static str,
    /// What is in it.
    pub bytes: &'static [u8],
}

/// All files of the page; the first one is what a browser opens.
pub const FILES: &[File] = &[
    File {
        path: "/",
        summary: "A page to watch and move the arm",
        content_type: HTML,
        bytes: include_bytes!("../files/index.html"),
    },
    File {
        path: "/page.css",
        summary: "How the page looks",
        content_type: CSS,
        bytes: include_bytes!("../files/page.css"),
    },
    File {
        path: "/page.js",
        summary: "What the page does",
        content_type: JS,
        bytes: include_bytes!("../files/page.js"),
    },
    File {
        path: "/preview.js",
        summary: "Shows a drawing in time",
        content_type: JS,
        bytes: include_bytes!("../files/preview.js"),
    },
    File {
        path: "/timeline.js",
        summary: "What is at a moment of a drawing",
        content_type: JS,
        bytes: include_bytes!("../files/timeline.js"),
    },
    File {
        path: "/reader.js",
        summary: "Reads the timeline of a drawing",
        content_type: JS,
        bytes: include_bytes!("../files/reader.js"),
    },
    File {
        path: "/look.js",
        summary: "How a drawing in time looks",
        content_type: JS,
        bytes: include_bytes!("../files/look.js"),
    },
    File {
        path: "/sketch.js",
        summary: "Draws a drawing in time",
        content_type: JS,
        bytes: include_bytes!("../files/sketch.js"),
    },
];

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const JS: &str = "text/javascript; charset=utf-8";

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Those beside them are for who writes the page: tests and types.
    fn is_served(name: &str) -> bool {
        !name.ends_with(".test.js") && !name.ends_with(".d.ts")
    }

    #[test]
    fn every_file_of_the_folder_has_one_row() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/files");
        let names = std::fs::read_dir(folder).expect("it is there").map(|it| {
            let name = it.expect("it is read").file_name();
            name.into_string().expect("names are text")
        });
        let there: BTreeSet<String> = names.filter(|name| is_served(name)).collect();
        let name = |file: &File| match file.path {
            "/" => "index.html".to_owned(),
            path => path.trim_start_matches('/').to_owned(),
        };
        let rows: BTreeSet<String> = FILES.iter().map(name).collect();
        assert_eq!(rows, there);
        assert_eq!(FILES.len(), there.len(), "a path has two rows");
    }

    #[test]
    fn every_file_says_what_it_is() {
        for file in FILES {
            let expected = match file.path.rsplit_once('.') {
                None => HTML,
                Some((_, "css")) => CSS,
                Some((_, "js")) => JS,
                Some((_, other)) => panic!("{}: what is the type of {other}?", file.path),
            };
            assert_eq!(file.content_type, expected, "{}", file.path);
        }
    }
}
