//! The workspace in the plane of reach and z, each edge in the colour of its limit.

use dobot_arm::{Limits, Pose, Position, Quantity, Tool, Unreachable};

use dobot_lettering::{Anchor, ShapeStyle};

use crate::canvas::{BLUE, Canvas, FAINT, GREEN, INK, ORANGE, PURPLE, RED, SHADE, SOFT, dashed};

/// The workspace of the suction cup within the stock limits; the laser's edge is dashed.
pub(crate) fn cross_section() -> String {
    let mut c = Canvas::new(820, 640);
    c.place([70.0, 285.0], [1.55, 1.55]);
    grid(&mut c);
    let columns = columns(Tool::SuctionCup);
    c.area(&outline(&columns), SHADE);
    c.path(&outline(&self::columns(Tool::Laser)), &dashed(SOFT, 1.3));
    for (quantity, edge) in edges(&columns) {
        c.path(&edge, &ShapeStyle::line(color(quantity), 3.5));
    }
    c.arrow([0.0, 0.0], [378.0, 0.0], SOFT, 1.5);
    c.text([384.0, 0.0], Anchor::Left, INK, "reach in mm");
    c.arrow([0.0, -210.0], [0.0, 165.0], SOFT, 1.5);
    c.text([8.0, 165.0], Anchor::Left, INK, "z in mm");
    c.line(
        [0.0, -103.0],
        [385.0, -103.0],
        &ShapeStyle::line("#b08968", 2.0),
    );
    c.note([6.0, -95.0], Anchor::Left, "table");
    legend(&mut c);
    c.finish()
}

/// For each millimetre of reach, the lowest and the highest allowed z.
fn columns(tool: Tool) -> Vec<[f64; 3]> {
    let within = |reach_mm: f64, z_mm: f64| refusal(reach_mm, z_mm, tool).is_none();
    // Finer towards the end, where the edge turns.
    (1290..=3210)
        .filter(|n| n % 10 == 0 || *n > 3100)
        .map(|n| f64::from(n) * 0.1)
        .filter_map(|reach_mm| {
            let mut heights = (-2500..=1500).map(|n| f64::from(n) * 0.1);
            let low = heights.find(|z_mm| within(reach_mm, *z_mm))?;
            let high = heights.take_while(|z_mm| within(reach_mm, *z_mm)).last()?;
            Some([reach_mm, low, high])
        })
        .collect()
}

fn refusal(reach_mm: f64, z_mm: f64, tool: Tool) -> Option<Quantity> {
    let pose = Pose {
        position: Position::new(reach_mm, 0.0, z_mm),
        ..Pose::default()
    };
    match Limits::STOCK.solve(&pose, tool).err()? {
        Unreachable::OutOfRange { quantity, .. } => Some(quantity),
        _ => None,
    }
}

fn outline(columns: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let bottom = columns.iter().map(|[reach, low, _]| [*reach, *low]);
    let top = columns.iter().rev().map(|[reach, _, high]| [*reach, *high]);
    let mut points: Vec<_> = bottom.chain(top).collect();
    points.push(points[0]);
    points
}

/// The outline cut into edges, each with the limit that it represents.
fn edges(columns: &[[f64; 3]]) -> Vec<(Quantity, Vec<[f64; 2]>)> {
    let mut edges: Vec<(Quantity, Vec<[f64; 2]>)> = Vec::new();
    for pair in outline(columns).windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let quantity = beyond(a, b);
        match edges.last_mut() {
            Some((last, points)) if *last == quantity => points.push(b),
            _ => edges.push((quantity, vec![a, b])),
        }
    }
    edges
}

/// Returns the limit just outside of a piece of the outline, which runs counter-clockwise.
fn beyond(a: [f64; 2], b: [f64; 2]) -> Quantity {
    let [right, up] = [b[0] - a[0], b[1] - a[1]];
    let length = right.hypot(up);
    let outside = [
        f64::midpoint(a[0], b[0]) + 0.5 * up / length,
        f64::midpoint(a[1], b[1]) - 0.5 * right / length,
    ];
    refusal(outside[0], outside[1], Tool::SuctionCup).expect("outside is not allowed")
}

fn grid(c: &mut Canvas) {
    for n in -4..=3 {
        let at = f64::from(n) * 50.0;
        c.line([0.0, at], [380.0, at], &ShapeStyle::line("#f3f4f6", 1.0));
        c.note([-8.0, at], Anchor::Right, &format!("{at}"));
    }
    for n in 1..=7 {
        let at = f64::from(n) * 50.0;
        c.line([at, -205.0], [at, 155.0], &ShapeStyle::line("#f3f4f6", 1.0));
        c.note([at, -216.0], Anchor::Middle, &format!("{at}"));
    }
    c.line(
        [0.0, -205.0],
        [380.0, -205.0],
        &ShapeStyle::line(FAINT, 1.0),
    );
}

fn legend(c: &mut Canvas) {
    let lines = [
        (Quantity::Reach, "reach 129 to 321 mm"),
        (Quantity::Z, "z at most 136 mm"),
        (Quantity::Opening, "rear − fore at most 35°"),
        (Quantity::Rear, "rear −5 to 85°"),
        (Quantity::Fore, "fore −10 to 95°"),
    ];
    for (n, (quantity, words)) in (0..).zip(lines) {
        let y = -30.0 - 14.0 * f64::from(n);
        c.line(
            [352.0, y],
            [368.0, y],
            &ShapeStyle::line(color(quantity), 3.5),
        );
        c.note([374.0, y], Anchor::Left, words);
    }
    c.line([352.0, -124.0], [368.0, -124.0], &dashed(SOFT, 1.3));
    c.note([374.0, -124.0], Anchor::Left, "with the laser");
}

const fn color(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Reach => INK,
        Quantity::Z => PURPLE,
        Quantity::Rear => BLUE,
        Quantity::Fore => ORANGE,
        Quantity::Opening => GREEN,
        _ => RED,
    }
}
