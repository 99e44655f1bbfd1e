//! Names and kinds of files.

use dobot_api::Problem;
use dobot_api::problem_kinds::FILE_NAME;
use dobot_draw::{Contents, FORMATS};
use dobot_supervisor::is_plain;
use schemars::JsonSchema;
use serde::Serialize;

/// The kind of a file, by the end of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum FileKind {
    /// Lines and areas to draw.
    Drawing,
    /// A picture to draw.
    Photo,
    /// A taught program.
    Program,
}

impl FileKind {
    /// Returns the kind of a file with this name.
    pub(super) fn of(name: &str) -> Option<Self> {
        let (_, end) = name.rsplit_once('.')?;
        let end = end.to_lowercase();
        if PROGRAMS.contains(&&*end) {
            return Some(Self::Program);
        }
        let format = FORMATS.iter().find(|f| f.extensions.contains(&&*end))?;
        match format.contents {
            Contents::Picture => Some(Self::Photo),
            _ => Some(Self::Drawing),
        }
    }
}

/// Checks a name. It is never part of a path on this computer, but may become one on another.
pub(super) fn check_name(name: &str) -> Result<(), Problem> {
    let letters = name.chars().count();
    if !(1..=MOST_LETTERS).contains(&letters) {
        return Err(FILE_NAME.problem(format!(
            "the name has {letters} characters; allowed are 1 to {MOST_LETTERS}"
        )));
    }
    let wrong = |&character: &char| !is_plain(character) || NOT_IN_NAMES.contains(character);
    if let Some(wrong) = name.chars().find(wrong) {
        return Err(FILE_NAME.problem(format!(
            "the name contains {wrong:?}; not allowed are / \\ : * ? \" < > | and control characters"
        )));
    }
    if name.starts_with(['.', ' ']) || name.ends_with(['.', ' ']) {
        return Err(FILE_NAME.problem(format!(
            "the name {name:?} begins or ends with a dot or a space"
        )));
    }
    if FileKind::of(name).is_none() {
        return Err(unknown_ending(name));
    }
    Ok(())
}

fn unknown_ending(name: &str) -> Problem {
    let extensions = FORMATS.iter().flat_map(|format| format.extensions);
    let all: Vec<&str> = extensions.copied().chain(PROGRAMS).collect();
    FILE_NAME.problem(format!(
        "the name {name:?} has no known ending; allowed are .{}",
        all.join(", .")
    ))
}

/// The endings of programs, of this project and of the vendor's software.
const PROGRAMS: [&str; 4] = ["toml", "xml", "play", "playback"];
/// What names of files cannot contain on some system.
const NOT_IN_NAMES: &str = "/\\:*?\"<>|";
/// The maximum length of a name, in characters.
pub(super) const MOST_LETTERS: usize = 120;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_are_paths_or_hide_something_are_refused() {
        for name in [
            "",
            ".svg",
            "..",
            "a/b.svg",
            "..\\x.svg",
            "C:x.svg",
            "a\0.svg",
            "a\n.svg",
            "a\u{202e}gvs.exe",
            "x.svg ",
            " x.svg",
            "x.svg.",
            "no ending",
            "x.exe",
            "x.html",
        ] {
            assert!(check_name(name).is_err(), "{name:?}");
        }
        assert!(check_name(&format!("{}.svg", "é".repeat(116))).is_ok());
        assert!(check_name(&format!("{}.svg", "é".repeat(117))).is_err());
        for name in [
            "harbour.svg",
            "Häfen (2).SVG",
            "港.png",
            "a b.toml",
            "..x.svg.gcode",
        ] {
            let expected = !name.starts_with('.');
            assert_eq!(check_name(name).is_ok(), expected, "{name:?}");
        }
    }

    #[test]
    fn the_ending_decides_what_a_file_is() {
        assert_eq!(FileKind::of("a.svg"), Some(FileKind::Drawing));
        assert_eq!(FileKind::of("a.JPEG"), Some(FileKind::Photo));
        assert_eq!(FileKind::of("a.toml"), Some(FileKind::Program));
        assert_eq!(FileKind::of("svg"), None);
    }
}
