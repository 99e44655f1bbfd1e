//! The installed fonts.

use usvg::fontdb::Database;

/// The installed fonts, and the fonts for the generic families (sans-serif, serif and so on).
/// Reading the font files takes a while.
#[must_use]
pub fn system_fonts() -> Database {
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    name_generic(&mut fonts);
    fonts
}

/// Sets each generic family to the first installed font of its list.
fn name_generic(fonts: &mut Database) {
    let here = |names: &str| {
        let has = |name: &&str| {
            let mut families = fonts.faces().flat_map(|face| &face.families);
            families.any(|family| family.0 == *name)
        };
        names.split(", ").find(has).map(str::to_owned)
    };
    let [serif, sans, mono, cursive, fantasy] =
        [SERIF, SANS_SERIF, MONOSPACE, CURSIVE, FANTASY].map(here);
    if let Some(name) = serif {
        fonts.set_serif_family(name);
    }
    // Handwriting and display fonts are rarer: a plain one comes closest.
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
