//! The points and primitives of paths, which paths may share.

use std::collections::HashMap;
use std::rc::Rc;

use usvg::roxmltree::Node;

use super::field::Field;
use super::list::{self, Joints, Vertex};
use crate::error::SourceError;
use crate::limits::{Budget, MAX_SEGMENTS};

/// A reader of path lists. Of the paths that share a list only the first contains it; the others
/// refer to its number (`VertID`, `PrimID`).
#[derive(Debug)]
pub(super) struct Lists<'d> {
    file: &'d str,
    vertices: ListsOf<'d, Vec<Vertex>>,
    joints: ListsOf<'d, Joints>,
    /// The number of points and primitives that may still be read.
    budget: Budget,
}

impl<'d> Lists<'d> {
    pub(super) fn new(file: &'d str, root: Node<'d, '_>) -> Self {
        let mut lists = Self {
            file,
            vertices: ListsOf {
                element: "VertList",
                number: "VertID",
                read: list::vertices,
                read_old: list::old_vertices,
                shared: HashMap::new(),
            },
            joints: ListsOf {
                element: "PrimList",
                number: "PrimID",
                read: list::joints,
                read_old: list::old_joints,
                shared: HashMap::new(),
            },
            budget: Budget::new(MAX_SEGMENTS),
        };
        for node in root.descendants().filter(Node::is_element) {
            lists.vertices.note(node);
            lists.joints.note(node);
        }
        lists
    }

    /// The points and the primitives of a path.
    pub(super) fn of(
        &mut self,
        path: Node<'d, '_>,
    ) -> Result<(Rc<Vec<Vertex>>, Rc<Joints>), SourceError> {
        let vertices = self.vertices.of(self.file, path, &mut self.budget)?;
        let joints = self.joints.of(self.file, path, &mut self.budget)?;
        Ok((vertices, joints))
    }
}

/// The lists of one kind.
#[derive(Debug)]
struct ListsOf<'d, T> {
    /// The element name of the list, and the attribute with its number.
    element: &'static str,
    number: &'static str,
    read: fn(&str, Field<'_>, &mut Budget) -> Result<T, SourceError>,
    /// The reader of the list in the older format.
    read_old: fn(&str, Node<'_, '_>, &mut Budget) -> Result<T, SourceError>,
    /// The numbered lists.
    shared: HashMap<&'d str, Shared<'d, T>>,
}

/// A numbered list, read on demand.
#[derive(Debug)]
struct Shared<'d, T> {
    field: Field<'d>,
    list: Option<Rc<T>>,
}

impl<'d, T> ListsOf<'d, T> {
    /// Registers a numbered list.
    fn note(&mut self, node: Node<'d, '_>) {
        let Some(number) = node.attribute(self.number) else {
            return;
        };
        if let Some(field) = Field::content(node, self.element) {
            let list = None;
            self.shared.entry(number).or_insert(Shared { field, list });
        }
    }

    /// The list of a path: its own one, a shared one, or without either, one of the older format.
    fn of(
        &mut self,
        file: &str,
        path: Node<'d, '_>,
        budget: &mut Budget,
    ) -> Result<Rc<T>, SourceError> {
        let own = Field::content(path, self.element);
        let number = Field::attribute(path, self.number);
        let (own, number) = match (own, number) {
            (None, None) => return (self.read_old)(file, path, budget).map(Rc::new),
            (Some(own), None) => return (self.read)(file, own, budget).map(Rc::new),
            (own, Some(number)) => (own, number),
        };
        let Some(of_number) = self.shared.get_mut(number.text) else {
            let expected = format!("the number of a <{}> of the file", self.element);
            return Err(number.refused(file, &expected));
        };
        // It has its own list with the same number.
        if let Some(own) = own.filter(|value| value.at != of_number.field.at) {
            return (self.read)(file, own, budget).map(Rc::new);
        }
        if let Some(list) = &of_number.list {
            return Ok(Rc::clone(list));
        }
        let list = Rc::new((self.read)(file, of_number.field, budget)?);
        of_number.list = Some(Rc::clone(&list));
        Ok(list)
    }
}
