//! Points of polygons and polylines that end between x and y.

use svgtypes::NumberListParser;
use usvg::roxmltree::{Attribute, Document, Node};

use crate::warning::Warning;

/// Warns about point lists whose last number is an x without a y: the library draws the points
/// before it, like browsers.
pub(super) fn lone_coordinates(doc: &Document<'_>) -> Option<Warning> {
    let shapes = doc.descendants().filter(|node| is_shape(*node));
    let lists = shapes.filter_map(|shape| shape.attribute_node("points"));
    let mut odd = lists.filter(|list| NumberListParser::from(list.value()).count() % 2 == 1);
    let first = odd.next()?;
    Some(Warning {
        place: Some(doc.text_pos_at(end(&first)).into()),
        ..Warning::new("lone coordinate", INSTEAD, 1 + odd.count())
    })
}

fn is_shape(node: Node<'_, '_>) -> bool {
    matches!(node.tag_name().name(), "polygon" | "polyline")
}

/// The position of the missing y, in bytes of the file.
fn end(points: &Attribute<'_, '_>) -> usize {
    let (value, range) = (points.value(), points.range_value());
    // After replaced entities, the value does not match the file.
    if range.len() == value.len() {
        range.start + value.trim_end().len()
    } else {
        range.start
    }
}

const INSTEAD: &str =
    "x without y in the points of a polygon or polyline left out; the points before it are drawn";
