//! Curve handles that coincide with an end: for the direction of markers there, the library ignores
//! the other handle.

use svgtypes::{SimplePathSegment as Segment, SimplifyingPathParser};
use usvg::roxmltree::Node;

use super::check::{PathCommand, check_path};
use super::edits::Edit;

/// A path whose coincident handles are moved a little along the curve; `None` if there are none.
pub(super) fn freed(node: Node<'_, '_>) -> Option<Edit> {
    let attribute = node.attribute_node("d")?;
    check_path(attribute.value()).ok()?;
    let path: Result<Vec<Segment>, _> = SimplifyingPathParser::from(attribute.value()).collect();
    let mut path = path.ok()?;
    let mut here = [0.0; 2];
    let mut start = here;
    let mut moved = false;
    for segment in &mut path {
        moved |= free(here, segment);
        here = match *segment {
            Segment::MoveTo { x, y } => {
                start = [x, y];
                start
            }
            Segment::ClosePath => start,
            Segment::LineTo { x, y }
            | Segment::CurveTo { x, y, .. }
            | Segment::Quadratic { x, y, .. } => [x, y],
        };
    }
    let commands = path.iter().map(command).take_while(PathCommand::is_small);
    moved.then(|| Edit {
        range: attribute.range_value(),
        words: commands.map(|command| command.text()).collect(),
    })
}

/// Moves the coincident handles of a curve, and returns whether there were any.
fn free(from: [f64; 2], segment: &mut Segment) -> bool {
    let Segment::CurveTo {
        x1,
        y1,
        x2,
        y2,
        x,
        y,
    } = segment
    else {
        return false;
    };
    let (first, second, to) = ([*x1, *y1], [*x2, *y2], [*x, *y]);
    let begins = first == from && second != from && second != to;
    let ends = second == to && first != to && first != from;
    if begins {
        [*x1, *y1] = towards(first, second);
    }
    if ends {
        [*x2, *y2] = towards(second, first);
    }
    begins || ends
}

fn towards(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|value| from[value] + SHARE * (to[value] - from[value]))
}

fn command(segment: &Segment) -> PathCommand {
    match *segment {
        Segment::MoveTo { x, y } => PathCommand::new('M', true, [x, y]),
        Segment::LineTo { x, y } => PathCommand::new('L', true, [x, y]),
        Segment::CurveTo {
            x1,
            y1,
            x2,
            y2,
            x,
            y,
        } => PathCommand::new('C', true, [x1, y1, x2, y2, x, y]),
        Segment::Quadratic { x1, y1, x, y } => PathCommand::new('Q', true, [x1, y1, x, y]),
        Segment::ClosePath => PathCommand::new('Z', true, []),
    }
}

/// The fraction of the handle; enough for a direction, and the curve moves by less than half of it.
const SHARE: f64 = 0.001;
