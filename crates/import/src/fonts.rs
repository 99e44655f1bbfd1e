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
    let here = |names: &str| {
        let has = |name: &&str| {
            let mut families = fonts.faces().flat_map(|it| &it.families);
            families.any(|it| it.0 == *name)
        };
        names.split(", ").find(has).map(str::to_owned)
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

const SERIF: &str = "DejaVu Serif, Liberation Serif, Noto Serif, Times New Roman, Times";
const SANS_SERIF: &str = "DejaVu Sans, Liberation Sans, Noto Sans, Arial, Helvetica";
const MONOSPACE: &str = "DejaVu Sans Mono, Liberation Mono, Noto Sans Mono, Courier New, Menlo";
const CURSIVE: &str = "Comic Neue, Comic Sans MS, Apple Chancery";
const FANTASY: &str = "Impact, Papyrus";
