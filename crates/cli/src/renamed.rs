//! Options that were renamed. The old spelling is accepted for one release, with a hint.

use std::ffi::OsString;

/// An option that was renamed, without dashes.
struct Renamed {
    /// The subcommands that have it.
    path: &'static [&'static str],
    old: &'static str,
    new: &'static str,
}

const fn renamed(path: &'static [&'static str], old: &'static str, new: &'static str) -> Renamed {
    Renamed { path, old, new }
}

const RENAMED: [Renamed; 18] = [
    renamed(&["arm"], "speed", "time-factor"),
    renamed(&["up"], "speed", "time-factor"),
    renamed(&["replay"], "speed", "time-factor"),
    renamed(&["replay"], "folder", "recordings"),
    renamed(&["jog"], "speed", "percent"),
    renamed(&["set", "percent"], "speed", "speed-percent"),
    renamed(&["set", "percent"], "acceleration", "acceleration-percent"),
    renamed(&["set", "percent"], "teach", "jog-percent"),
    renamed(&["log"], "from", "since"),
    renamed(&["log"], "to", "until"),
    renamed(&["log"], "folder", "recordings"),
    renamed(&["decode"], "from", "sender"),
    renamed(&["world"], "from", "address"),
    renamed(&["policy", "test"], "from", "start-point"),
    renamed(&["draw"], "frame", "outline"),
    renamed(&["calibrate"], "paper", "touch-paper"),
    renamed(&["vector"], "laser", "burn"),
    renamed(&["conformance"], "laser", "with-laser"),
];

/// Replaces the old spellings on a command line, and returns a hint for each.
pub(crate) fn replace(words: &mut [OsString]) -> Vec<String> {
    let mut hints = Vec::new();
    let is_end = |word: &OsString| word.as_os_str() == "--";
    let end = words.iter().position(is_end).unwrap_or(words.len());
    let is_used = |renamed: &&Renamed| renamed.is_for(&words[..end]);
    let used: Vec<&Renamed> = RENAMED.iter().filter(is_used).collect();
    for renamed in used {
        let (old, new) = (format!("--{}", renamed.old), format!("--{}", renamed.new));
        for word in &mut words[..end] {
            let Some(value) = word.to_str().and_then(|word| word.strip_prefix(&old)) else {
                continue;
            };
            if value.is_empty() || value.starts_with('=') {
                *word = format!("{new}{value}").into();
                hints.push(hint(&old, &new));
            }
        }
    }
    hints
}

/// Returns the current name of an option of `dobot draw`, without dashes, and a hint if it was renamed.
pub(crate) fn draw_option(option: &str) -> (String, Option<String>) {
    let renamed = RENAMED
        .iter()
        .find(|renamed| renamed.path == ["draw"] && renamed.old == option);
    match renamed {
        Some(renamed) => (renamed.new.to_owned(), Some(hint(option, renamed.new))),
        None => (option.to_owned(), None),
    }
}

fn hint(old: &str, new: &str) -> String {
    format!("`{old}` is now `{new}`; the next release no longer accepts the old name")
}

impl Renamed {
    fn is_for(&self, words: &[OsString]) -> bool {
        let is_verb = words.get(1).is_some_and(|word| word == self.path[0]);
        let has_group = |group: &&str| words.iter().any(|word| word == group);
        is_verb && self.path[1..].iter().all(has_group)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn replaced(line: &str) -> (String, usize) {
        let mut words: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        let hints = replace(&mut words);
        let words: Vec<&str> = words.iter().filter_map(|word| word.to_str()).collect();
        (words.join(" "), hints.len())
    }

    #[test]
    fn old_spellings_are_replaced_where_their_meaning_has_changed() {
        for (old, new) in [
            ("dobot arm --speed 8", "dobot arm --time-factor 8"),
            ("dobot arm --speed=max", "dobot arm --time-factor=max"),
            ("dobot jog x+ --speed 20", "dobot jog x+ --percent 20"),
            (
                "dobot set percent --speed 5",
                "dobot set percent --speed-percent 5",
            ),
            ("dobot draw a.svg --frame", "dobot draw a.svg --outline"),
        ] {
            assert_eq!(replaced(old), (new.to_owned(), 1));
        }
        let line = "dobot log FILE --from 1 --to 2";
        assert_eq!(
            replaced(line),
            ("dobot log FILE --since 1 --until 2".to_owned(), 2)
        );
    }

    #[test]
    fn other_commands_and_arguments_after_two_dashes_are_unchanged() {
        for line in [
            "dobot draw a.svg --speed 20 --paper-size a5",
            "dobot jog x+ --frame linear",
            "dobot set moves --joint-speed 5",
            "dobot service install -- --speed 2",
            "dobot decode -- --from",
        ] {
            assert_eq!(replaced(line), (line.to_owned(), 0));
        }
    }

    #[test]
    fn each_new_name_is_an_option_and_the_old_one_is_not() {
        for Renamed { path, old, new } in &RENAMED {
            let mut command = &crate::command_line::command();
            for name in *path {
                command = command.find_subcommand(name).expect("the command exists");
            }
            let has = |long| {
                command
                    .get_arguments()
                    .any(|arg| arg.get_long() == Some(long))
            };
            assert!(has(*new) && !has(*old), "{path:?} --{old} --{new}");
        }
    }
}
