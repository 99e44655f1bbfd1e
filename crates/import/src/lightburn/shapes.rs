//! The lines of each kind of shape, on the page.

use std::f64::consts::{FRAC_PI_2, TAU};

use dobot_geometry::{Affine, CubicBez, Point, Vec2};
use usvg::roxmltree::Node;

use super::field::{Field, length};
use super::list::{Joint, Joints, Vertex};
use super::renderer::{Contour, ShapeRenderer};
use crate::arc::{Arc, SAME_MM};
use crate::error::SourceError;
use crate::frame::way;

impl<'d> ShapeRenderer<'_, '_, 'd> {
    /// A rectangle about its center, optionally with round corners.
    pub(super) fn rectangle(
        &mut self,
        node: Node<'d, '_>,
        frame: Affine,
    ) -> Result<Vec<Contour>, SourceError> {
        let half =
            [length(self.file, node, "W")?, length(self.file, node, "H")?].map(|mm| mm / 2.0);
        let [x, y] = half;
        let corners = [(x, -y), (x, y), (-x, y), (-x, -y)].map(|(x, y)| Point::new(x, y));
        let radius = self.corner_radius(node, half)?;
        if radius == 0.0 {
            return self.ring(node, frame, &corners);
        }
        let at = node.range().start;
        let mut points = Vec::new();
        for (corner, from_rad) in corners
            .into_iter()
            .zip([-FRAC_PI_2, 0.0, FRAC_PI_2, -TAU / 2.0])
        {
            let inwards = Vec2::new(-corner.x.signum(), -corner.y.signum()) * radius;
            let middle = self.sketch.check(at, frame * (corner + inwards))?;
            let [across, along] = [Vec2::new(radius, 0.0), Vec2::new(0.0, radius)];
            let [across, along] = [way(frame, across), way(frame, along)];
            let arc = Arc::ellipse(middle, across, along, from_rad, FRAC_PI_2);
            points.append(&mut self.sketch.arc_points(at, &arc)?);
        }
        Ok(closed(points))
    }

    /// The corner radius of a rectangle.
    fn corner_radius(&mut self, node: Node<'d, '_>, [x, y]: [f64; 2]) -> Result<f64, SourceError> {
        let radius = super::field::number(self.file, node, "Cr")?;
        if radius < 0.0 {
            let instead =
                "drawn with sharp corners; convert it to a path in LightBurn and save the project";
            self.left_out(node, "negatively rounded rectangle", instead);
            return Ok(0.0);
        }
        let most = x.min(y);
        if radius > most {
            let instead = "drawn with the largest radius that its shorter side allows";
            self.left_out(node, "too-round rectangle", instead);
            return Ok(most);
        }
        Ok(radius)
    }

    pub(super) fn ellipse(
        &mut self,
        node: Node<'d, '_>,
        frame: Affine,
    ) -> Result<Vec<Contour>, SourceError> {
        let at = node.range().start;
        let [x, y] = [
            length(self.file, node, "Rx")?,
            length(self.file, node, "Ry")?,
        ];
        let middle = self.sketch.check(at, frame * Point::ORIGIN)?;
        let [across, along] = [Vec2::new(x, 0.0), Vec2::new(0.0, y)].map(|value| way(frame, value));
        let arc = Arc::ellipse(middle, across, along, 0.0, TAU);
        let points = self.sketch.arc_points(at, &arc)?;
        Ok(closed(points))
    }

    /// A stretched regular polygon, whose first corner is to the right of its center.
    pub(super) fn polygon(
        &mut self,
        node: Node<'d, '_>,
        frame: Affine,
    ) -> Result<Vec<Contour>, SourceError> {
        let expected = "the number of its sides, from 3 to 10000";
        let Some(field) = Field::attribute(node, "N") else {
            let at = node.range().start;
            return Err(self.sketch.found(at, "a polygon without N", expected));
        };
        let sides = field.count(self.file)?;
        if !SIDES.contains(&sides) {
            return Err(field.refused(self.file, expected));
        }
        let [x, y] = [
            length(self.file, node, "Rx")?,
            length(self.file, node, "Ry")?,
        ];
        let corner = |i: u32| {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(sides)).sin_cos();
            Point::new(x * cos, y * sin)
        };
        let corners: Vec<Point> = (0..sides).map(corner).collect();
        self.ring(node, frame, &corners)
    }

    /// A path of lines and curves, in one or several pieces.
    pub(super) fn path(
        &mut self,
        node: Node<'d, '_>,
        frame: Affine,
    ) -> Result<Vec<Contour>, SourceError> {
        let (vertices, joints) = self.lists.of(node)?;
        let in_order;
        let joints = match &*joints {
            Joints::Listed(joints) => joints,
            Joints::InOrder { closed } => {
                // Counted before anything is stored.
                self.sketch.spend(vertices.len())?;
                in_order = joined_in_order(vertices.len(), *closed, node.range().start);
                &in_order
            }
        };
        if joints.is_empty() {
            self.left_out(node, "empty path", "left out");
        }
        let mut contours: Vec<Contour> = Vec::new();
        let mut last: Option<Joint> = None;
        for &joint in joints {
            let points = self.joint_points(frame, &vertices, joint)?;
            match contours.last_mut() {
                Some(contour)
                    if !contour.closed && last.is_some_and(|last| last.to == joint.from) =>
                {
                    contour.points.extend(&points[1..]);
                    contour.closed = is_closed(&contour.points);
                }
                _ => contours.push(Contour {
                    closed: is_closed(&points),
                    points,
                }),
            }
            last = Some(joint);
        }
        Ok(contours)
    }

    /// The corners of a line or curve, both ends included.
    fn joint_points(
        &mut self,
        frame: Affine,
        vertices: &[Vertex],
        joint: Joint,
    ) -> Result<Vec<Point>, SourceError> {
        let Joint { at, .. } = joint;
        let vertex = |number: usize| {
            vertices.get(number).copied().ok_or_else(|| {
                let found = format!("point {number}");
                let expected = match vertices.len() {
                    0 => "a path with points".to_owned(),
                    count => format!(
                        "one of the {count} points of the path, from 0 to {}",
                        count - 1
                    ),
                };
                self.sketch.found(at, found, &expected)
            })
        };
        let (from, to) = (vertex(joint.from)?, vertex(joint.to)?);
        let [start, end] = [from.at, to.at].map(|p| frame * p);
        let [start, end] = [self.sketch.check(at, start)?, self.sketch.check(at, end)?];
        let points = if joint.is_curve {
            let curve = CubicBez::new(start, frame * from.leaving, frame * to.arriving, end);
            self.sketch.cubic_points(at, curve)?
        } else {
            vec![start, end]
        };
        self.sketch.spend(points.len() - 1)?;
        Ok(points)
    }

    fn ring(
        &self,
        node: Node<'_, '_>,
        frame: Affine,
        corners: &[Point],
    ) -> Result<Vec<Contour>, SourceError> {
        let at = node.range().start;
        let places = corners.iter().map(|&p| self.sketch.check(at, frame * p));
        Ok(closed(places.collect::<Result<_, _>>()?))
    }
}

fn closed(mut points: Vec<Point>) -> Vec<Contour> {
    if points.first() != points.last() {
        points.extend(points.first().copied());
    }
    let closed = true;
    vec![Contour { points, closed }]
}

fn is_closed(points: &[Point]) -> bool {
    match points {
        [first, _, .., last] => first.distance(*last) < SAME_MM,
        _ => false,
    }
}

fn joined_in_order(count: usize, closed: bool, at: usize) -> Vec<Joint> {
    let joint = |from, to| Joint {
        is_curve: false,
        from,
        to,
        at,
    };
    let mut joints: Vec<Joint> = (1..count).map(|to| joint(to - 1, to)).collect();
    if closed && count > 2 {
        joints.push(joint(count - 1, 0));
    }
    joints
}

/// The allowed numbers of polygon sides.
const SIDES: std::ops::RangeInclusive<u32> = 3..=10_000;
