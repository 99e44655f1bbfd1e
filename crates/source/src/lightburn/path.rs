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
    vertices: HashMap<&'d str, Shared<'d, Vec<Vertex>>>,
    joints: HashMap<&'d str, Shared<'d, Joints>>,
    /// How many points and joints may still be read.
    budget: Budget,
}

/// A list with a number, which is read when it is first needed.
#[derive(Debug)]
struct Shared<'d, T> {
    field: Field<'d>,
    list: Option<Rc<T>>,
}

impl<'d> Lists<'d> {
    pub(super) fn new(file: &'d str, root: Node<'d, '_>) -> Self {
        let mut lists = Self {
            file,
            vertices: HashMap::new(),
            joints: HashMap::new(),
            budget: Budget::new(MAX_SEGMENTS),
        };
        for node in root.descendants().filter(Node::is_element) {
            note(&mut lists.vertices, node, VERTICES);
            note(&mut lists.joints, node, JOINTS);
        }
        lists
    }

    /// The points of a path.
    pub(super) fn vertices(&mut self, path: Node<'d, '_>) -> Result<Rc<Vec<Vertex>>, SourceError> {
        let Self {
            file,
            vertices,
            budget,
            ..
        } = self;
        let read = |field| list::vertices(file, field, budget);
        if let Some(vertices) = find(file, vertices, path, VERTICES, read)? {
            return Ok(vertices);
        }
        Ok(Rc::new(list::old_vertices(file, path, budget)?))
    }

    /// How they are joined.
    pub(super) fn joints(&mut self, path: Node<'d, '_>) -> Result<Rc<Joints>, SourceError> {
        let Self {
            file,
            joints,
            budget,
            ..
        } = self;
        let read = |field| list::joints(file, field, budget);
        if let Some(joints) = find(file, joints, path, JOINTS, read)? {
            return Ok(joints);
        }
        let joints = list::old_joints(file, path, budget)?;
        Ok(Rc::new(Joints::Listed(joints)))
    }
}

/// What a list is called, and the attribute that has its number.
#[derive(Clone, Copy, Debug)]
struct ListName {
    element: &'static str,
    number: &'static str,
}

const VERTICES: ListName = ListName {
    element: "VertList",
    number: "VertID",
};
const JOINTS: ListName = ListName {
    element: "PrimList",
    number: "PrimID",
};

fn note<'d, T>(shared: &mut HashMap<&'d str, Shared<'d, T>>, node: Node<'d, '_>, name: ListName) {
    let Some(number) = node.attribute(name.number) else {
        return;
    };
    if let Some(field) = Field::content(node, name.element) {
        let list = None;
        shared.entry(number).or_insert(Shared { field, list });
    }
}

/// The list of a path: its own, or the one that its number tells; `None` where it has neither.
fn find<'d, T>(
    file: &str,
    shared: &mut HashMap<&'d str, Shared<'d, T>>,
    path: Node<'d, '_>,
    name: ListName,
    mut read: impl FnMut(Field<'d>) -> Result<T, SourceError>,
) -> Result<Option<Rc<T>>, SourceError> {
    let own = Field::content(path, name.element);
    let number = Field::attribute(path, name.number);
    let (field, number) = match (own, number) {
        (None, None) => return Ok(None),
        (Some(field), None) => return Ok(Some(Rc::new(read(field)?))),
        (own, Some(number)) => (own, number),
    };
    let of_number = shared.get_mut(number.text);
    let Some(of_number) = of_number else {
        let expected = format!("the number of a <{}> of the file", name.element);
        return Err(number.refused(file, &expected));
    };
    // Another list of the same number is its own.
    if let Some(field) = field.filter(|it| it.at != of_number.field.at) {
        return Ok(Some(Rc::new(read(field)?)));
    }
    if of_number.list.is_none() {
        of_number.list = Some(Rc::new(read(of_number.field)?));
    }
    Ok(of_number.list.clone())
}
