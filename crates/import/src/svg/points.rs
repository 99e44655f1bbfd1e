//! Points of polygons and polylines that come to an end between x and y.

use svgtypes::NumberListParser;
use usvg::roxmltree::{Attribute, Document, Node};

use crate::warning::Warning;

/// Tells of the lists of points whose last number is an x without its y: the library draws the points before it, as
/// browsers do.
pub(super) fn lone_coordinates(doc: &Document<'_>) -> Option<Warning> {
    let shapes = doc.descendants().filter(|it| is_shape(*it));
    let lists = shapes.filter_map(|it| it.attribute_node("points"));
    let mut odd = lists.filter(|it| NumberListParser::from(it.value()).count() % 2 == 1);
    let first = odd.next()?;
    Some(Warning {
        place: Some(doc.text_pos_at(end(&first)).into()),
        ..Warning::new("lone coordinate", INSTEAD, 1 + odd.count())
    })
}

fn is_shape(node: Node<'_, '_>) -> bool {
    matches!(node.tag_name().name(), "polygon" | "polyline")
}

/// Where y is missing, in bytes of the file.
fn end(points: &Attribute<'_, '_>) -> usize {
    let (value, range) = (points.value(), points.range_value());
    // Where entities were replaced, the value does not line up with the file.
    if range.len() == value.len() {
        range.start + value.trim_end().len()
    } else {
        range.start
    }
}

const INSTEAD: &str =
    "x without y in the points of a polygon or polyline left out; the points before it are drawn";
