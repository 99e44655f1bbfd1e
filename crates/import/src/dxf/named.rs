//! Layers and blocks by name.

use std::collections::HashMap;

/// Values by name. `AutoCAD` ignores the case of names; other programs do not, so that an exact
/// match comes first.
#[derive(Debug)]
pub(super) struct Named<T> {
    things: HashMap<String, T>,
    /// The upper-case names; the first of several counts.
    names: HashMap<String, String>,
}

impl<T> Named<T> {
    /// Adds a value; the last one of a name counts.
    pub(super) fn insert(&mut self, name: String, thing: T) {
        self.names
            .entry(name.to_uppercase())
            .or_insert_with(|| name.clone());
        self.things.insert(name, thing);
    }

    pub(super) fn get(&self, name: &str) -> Option<&T> {
        self.things.get(self.own_name(name))
    }

    /// The name as defined in the file, or the given one if it is not defined.
    pub(super) fn own_name<'n>(&'n self, name: &'n str) -> &'n str {
        if self.things.contains_key(name) {
            return name;
        }
        let own = self.names.get(&name.to_uppercase());
        own.map_or(name, String::as_str)
    }

    pub(super) fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.things.values_mut()
    }
}

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self {
            things: HashMap::new(),
            names: HashMap::new(),
        }
    }
}
