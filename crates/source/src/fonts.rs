//! The fonts of this machine.

use usvg::fontdb::Database;

/// The fonts that are installed, and which of them stands for each family that every file may ask for
/// (sans-serif, serif and so on). The fonts' files are read, which takes a while.
#[must_use]
pub fn system_fonts() -> Database {
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    name_generic(&mut fonts);
    fonts
}

/// Takes for each of the families that every file may ask for the first that is here.
fn name_generic(fonts: &mut Database) {
    let here = |names: &[&str]| {
        let is_here = |name: &str| {
            fonts
                .faces()
                .any(|it| it.families.iter().any(|it| it.0 == name))
        };
        let name = names.iter().find(|it| is_here(it));
        name.map(|it| (*it).to_owned())
    };
    let [serif, sans, mono, cursive, fantasy] =
        [SERIF, SANS_SERIF, MONOSPACE, CURSIVE, FANTASY].map(here);
    if let Some(name) = serif {
        fonts.set_serif_family(name);
    }
    // Handwriting and display letters are rarer: what is plain comes nearest.
    if let Some(name) = cursive.or_else(|| sans.clone()) {
        fonts.set_cursive_family(name);
    }
    if let Some(name) = fantasy.or_else(|| sans.clone()) {
        fonts.set_fantasy_family(name);
    }
    if let Some(name) = sans {
        fonts.set_sans_serif_family(name);
    }
    if let Some(name) = mono {
        fonts.set_monospace_family(name);
    }
}

const SERIF: &[&str] = &[
    "DejaVu Serif",
    "Liberation Serif",
    "Noto Serif",
    "Times New Roman",
    "Times",
];
const SANS_SERIF: &[&str] = &[
    "DejaVu Sans",
    "Liberation Sans",
    "Noto Sans",
    "Arial",
    "Helvetica",
];
const MONOSPACE: &[&str] = &[
    "DejaVu Sans Mono",
    "Liberation Mono",
    "Noto Sans Mono",
    "Courier New",
    "Menlo",
];
const CURSIVE: &[&str] = &["Comic Neue", "Comic Sans MS", "Apple Chancery"];
const FANTASY: &[&str] = &["Impact", "Papyrus"];

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use usvg::fontdb::{FaceInfo, Family, ID, Language, Source, Stretch, Style, Weight};

    use super::*;

    fn with_fonts(names: &[&str]) -> Database {
        let mut fonts = Database::new();
        for name in names {
            fonts.push_face_info(FaceInfo {
                id: ID::dummy(),
                source: Source::Binary(Arc::new(Vec::<u8>::new())),
                index: 0,
                families: vec![((*name).to_owned(), Language::English_UnitedStates)],
                post_script_name: String::new(),
                style: Style::Normal,
                weight: Weight::NORMAL,
                stretch: Stretch::Normal,
                monospaced: false,
            });
        }
        name_generic(&mut fonts);
        fonts
    }

    #[test]
    fn the_families_that_every_file_may_ask_for_are_fonts_that_are_here() {
        let fonts = with_fonts(&[
            "Liberation Serif",
            "Noto Sans",
            "Liberation Sans",
            "Courier New",
        ]);
        for (family, name) in [
            (Family::Serif, "Liberation Serif"),
            (Family::SansSerif, "Liberation Sans"),
            (Family::Monospace, "Courier New"),
            (Family::Cursive, "Liberation Sans"),
            (Family::Fantasy, "Liberation Sans"),
        ] {
            assert_eq!(fonts.family_name(&family), name);
        }
        let handwriting = with_fonts(&["Noto Sans", "Comic Neue"]);
        assert_eq!(handwriting.family_name(&Family::Cursive), "Comic Neue");
    }
}
