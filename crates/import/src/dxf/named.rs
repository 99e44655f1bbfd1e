//! Layers and blocks by their names.

use std::collections::HashMap;

/// Things by their names, which are the same for `AutoCAD` whether in capitals or not. Other programs tell such names
/// apart, so that one in the same letters comes first.
#[derive(Debug)]
pub(super) struct Named<T> {
    things: HashMap<String, T>,
    /// Names by what they are in capitals; of several the first.
    names: HashMap<String, String>,
}

impl<T> Named<T> {
    /// Adds a thing; of the same name the last counts.
    pub(super) fn insert(&mut self, name: String, thing: T) {
        self.names
            .entry(name.to_uppercase())
            .or_insert_with(|| name.clone());
        self.things.insert(name, thing);
    }

    pub(super) fn get(&self, name: &str) -> Option<&T> {
        self.things.get(self.own_name(name))
    }

    /// The name as it stands where the thing is described; the same where it is nowhere.
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
