//! Substitutes for fonts that are not installed.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use usvg::fontdb::{Database, Family, ID, Query, Style, Weight};
use usvg::{Font, FontFamily, FontStyle};

use crate::place::printable;
use crate::warning::Warning;

/// The substitute of each family that is not installed.
#[derive(Debug, Default)]
pub(super) struct Substitutes(Mutex<BTreeMap<String, String>>);

impl Substitutes {
    /// Records a named font of the file that is not installed.
    pub(super) fn note(&self, asked: &Font, fonts: &Database, got: ID) {
        let taken = fonts.face(got).and_then(|face| face.families.first());
        if let (Some(named), Some((taken, _))) = (missing(asked, fonts, got), taken) {
            let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            all.entry(named.clone()).or_insert_with(|| taken.clone());
        }
    }

    pub(super) fn warnings(self) -> impl Iterator<Item = Warning> {
        let all = self.0.into_inner().unwrap_or_else(PoisonError::into_inner);
        all.into_iter().map(|(named, taken)| {
            let what = format!("font {}", printable(&named));
            let instead = format!("not installed, drawn in {}", printable(&taken));
            Warning::new(&what, &instead, 1)
        })
    }
}

/// The face that is closest to a missing font, by the kind of letters in its name.
pub(super) fn nearest(asked: &Font, fonts: &Database, got: ID) -> ID {
    let Some(kind) = missing(asked, fonts, got).and_then(|missing| kind_of(missing)) else {
        return got;
    };
    let query = Query {
        families: &[kind],
        weight: Weight(asked.weight()),
        style: match asked.style() {
            FontStyle::Normal => Style::Normal,
            FontStyle::Italic => Style::Italic,
            FontStyle::Oblique => Style::Oblique,
        },
        ..Query::default()
    };
    fonts.query(&query).unwrap_or(got)
}

/// The requested family if the selected face is of none of the requested families.
fn missing<'a>(asked: &'a Font, fonts: &Database, got: ID) -> Option<&'a String> {
    let face = fonts.face(got)?;
    let is_got = |name: &str| face.families.iter().any(|family| family.0 == name);
    let names = asked.families();
    if names
        .iter()
        .any(|name| is_got(fonts.family_name(&family(name))))
    {
        return None;
    }
    // A file without a font name requests the default, which nobody misses.
    let default = fonts.family_name(&Family::Serif);
    names.iter().find_map(|font_family| match font_family {
        FontFamily::Named(name) if name != default => Some(name),
        _ => None,
    })
}

/// The kind of letters in a family's name, if it differs from the default with serifs.
fn kind_of(name: &str) -> Option<Family<'static>> {
    let name = name.to_lowercase();
    let kinds = [
        (Family::Monospace, MONOSPACE),
        (Family::Cursive, CURSIVE),
        (Family::SansSerif, SANS_SERIF),
    ];
    let is_in_name =
        |(_, words): &(Family<'_>, &[&str])| words.iter().any(|word| name.contains(word));
    kinds.into_iter().find(is_in_name).map(|(kind, _)| kind)
}

const MONOSPACE: &[&str] = &["mono", "courier", "consol", "typewriter", "menlo", "fixed"];
const CURSIVE: &[&str] = &["script", "hand", "cursive", "comic", "chancery"];
const SANS_SERIF: &[&str] = &[
    "sans",
    "arial",
    "helvetica",
    "verdana",
    "tahoma",
    "trebuchet",
    "calibri",
    "segoe",
    "roboto",
    "ubuntu",
    "lato",
    "gothic",
    "grotesk",
    "futura",
    "montserrat",
    "myriad",
];

fn family(font_family: &FontFamily) -> Family<'_> {
    match font_family {
        FontFamily::Serif => Family::Serif,
        FontFamily::SansSerif => Family::SansSerif,
        FontFamily::Cursive => Family::Cursive,
        FontFamily::Fantasy => Family::Fantasy,
        FontFamily::Monospace => Family::Monospace,
        FontFamily::Named(name) => Family::Name(name),
    }
}
