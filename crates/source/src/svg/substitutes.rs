//! Fonts that a file asks for and that are not here.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use usvg::fontdb::{Database, Family, ID};
use usvg::{Font, FontFamily};

use crate::place::printable;
use crate::warning::Warning;

/// For each family that is not here the one that is taken instead.
#[derive(Debug, Default)]
pub(super) struct Substitutes(Mutex<BTreeMap<String, String>>);

impl Substitutes {
    /// Takes down what a file asks for by name, where it got none of that.
    pub(super) fn note(&self, asked: &Font, fonts: &Database, got: ID) {
        let Some(face) = fonts.face(got) else {
            return;
        };
        let is_got = |name: &str| face.families.iter().any(|it| it.0 == name);
        let names = asked.families();
        if names
            .iter()
            .any(|it| is_got(fonts.family_name(&family(it))))
        {
            return;
        }
        // Where a file names none, the default is asked for; nobody misses that.
        let default = fonts.family_name(&Family::Serif);
        let named = names.iter().find_map(|it| match it {
            FontFamily::Named(name) if name != default => Some(name),
            _ => None,
        });
        if let (Some(named), Some((taken, _))) = (named, face.families.first()) {
            let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            all.entry(named.clone()).or_insert_with(|| taken.clone());
        }
    }

    pub(super) fn warnings(self) -> impl Iterator<Item = Warning> {
        let all = self.0.into_inner().unwrap_or_else(PoisonError::into_inner);
        all.into_iter().map(|(named, taken)| {
            let what = format!("font {}", printable(&named));
            let instead = format!("not here, drawn in {}", printable(&taken));
            Warning::new(&what, &instead, 1)
        })
    }
}

fn family(it: &FontFamily) -> Family<'_> {
    match it {
        FontFamily::Serif => Family::Serif,
        FontFamily::SansSerif => Family::SansSerif,
        FontFamily::Cursive => Family::Cursive,
        FontFamily::Fantasy => Family::Fantasy,
        FontFamily::Monospace => Family::Monospace,
        FontFamily::Named(name) => Family::Name(name),
    }
}
