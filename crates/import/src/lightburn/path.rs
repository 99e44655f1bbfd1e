//! The points and joints of paths, some of which several paths share.

use std::collections::HashMap;
use std::rc::Rc;

use usvg::roxmltree::Node;

use super::field::Field;
use super::list::{self, Joints, Vertex};
use crate::error::SourceError;
use crate::limits::{Budget, MAX_SEGMENTS};

/// Reads the lists of paths. Of those with the same list only the first has it; the others tell its number (`VertID`,
/// `PrimID`).
#[derive(Debug)]
pub(super) struct Lists<'d> {
    file: &'d str,
    vertices: ListsOf<'d, Vec<Vertex>>,
    joints: ListsOf<'d, Joints>,
    /// How many points and joints may still be read.
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

    /// The points of a path, and how they are joined.
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
    /// What a list is called, and the attribute that has its number.
    element: &'static str,
    number: &'static str,
    read: fn(&str, Field<'_>, &mut Budget) -> Result<T, SourceError>,
    /// Reads it from a path of the older format.
    read_old: fn(&str, Node<'_, '_>, &mut Budget) -> Result<T, SourceError>,
    /// Those with a number.
    shared: HashMap<&'d str, Shared<'d, T>>,
}

/// A list with a number, which is read when it is first needed.
#[derive(Debug)]
struct Shared<'d, T> {
    field: Field<'d>,
    list: Option<Rc<T>>,
}

impl<'d, T> ListsOf<'d, T> {
    /// Keeps the place of a list that has a number.
    fn note(&mut self, node: Node<'d, '_>) {
        let Some(number) = node.attribute(self.number) else {
            return;
        };
        if let Some(field) = Field::content(node, self.element) {
            let list = None;
            self.shared.entry(number).or_insert(Shared { field, list });
        }
    }

    /// The list of a path: its own, the one that its number tells, or where it has neither, one of the older format.
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
        // Another list of the same number is its own.
        if let Some(own) = own.filter(|it| it.at != of_number.field.at) {
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
