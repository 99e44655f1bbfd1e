//! Similar names, for the errors about unknown ones.

/// Returns the name most similar to `name`, if one is similar enough.
#[must_use]
pub fn nearest<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let edits = |other: &str| {
        if other.eq_ignore_ascii_case(name) {
            return 0;
        }
        strsim::osa_distance(name, other)
    };
    let least = names.map(|other| (edits(other), other));
    let (edits, other) = least.min_by_key(|(edits, _)| *edits)?;
    // If half of the letters are wrong it is not a typing error.
    (edits * 2 < name.chars().count()).then_some(other)
}
