//! The model as URDF, the Unified Robot Description Format of ROS.

use dobot_arm::{Degrees, Span};
use dobot_motion::Speeds;
use xmlwriter::XmlWriter;

use crate::joint::{Axis, Turn, span_of_follower};
use crate::model::{Model, Part};
use crate::shape::{Colour, Shape, Solid};
use crate::tree::TreeJoint;
use crate::xml::{TITLE, document, element, metres, numbers, radians};

impl Model {
    /// The model as URDF: metres and radians.
    ///
    /// URDF has no loops: joints that the linkage turns mimic the driven ones. One can mimic a single joint only, so a joint
    /// that follows both arms is written as two, with a link without a shape between them, as `forearm_level`. The shapes are
    /// for looks and for collisions. Nobody has measured masses and forces: there is no `inertial`, and each `effort` is 0.
    #[must_use]
    pub fn to_urdf(&self) -> String {
        let mut xml = document(TITLE);
        xml.start_element("robot");
        xml.write_attribute("name", "dobot_arm");
        for colour in Colour::ALL {
            xml.start_element("material");
            xml.write_attribute("name", colour.name());
            element(&mut xml, "color", &[("rgba", &numbers(colour.rgba()))]);
            xml.end_element();
        }
        for part in &self.parts {
            link(&mut xml, part);
        }
        for joint in self.tree() {
            if !self.parts.iter().any(|part| part.name == joint.child) {
                element(&mut xml, "link", &[("name", &joint.child)]);
            }
            self.urdf_joint(&mut xml, &joint);
        }
        xml.end_document()
    }

    fn urdf_joint(&self, xml: &mut XmlWriter, joint: &TreeJoint) {
        match joint.turn {
            Turn::Fixed => start(xml, "fixed", joint),
            Turn::Driven { axis, span, deg_s } => {
                start(xml, "revolute", joint);
                turning(xml, axis, &span, deg_s);
            }
            Turn::Follows { rear, fore } => {
                let driver = if fore == 0.0 { "rear" } else { "fore" };
                let span = span_of_follower(rear, fore, &self.limits);
                start(xml, "revolute", joint);
                turning(xml, Axis::Y, &span, Speeds::STOCK.joint_deg_s);
                let times = numbers([rear + fore]);
                element(
                    xml,
                    "mimic",
                    &[("joint", driver), ("multiplier", &times), ("offset", "0")],
                );
            }
        }
        xml.end_element();
    }
}

/// Starts a joint: its name, parent, child and place.
fn start(xml: &mut XmlWriter, kind: &str, joint: &TreeJoint) {
    xml.start_element("joint");
    xml.write_attribute("name", &joint.name);
    xml.write_attribute("type", kind);
    element(xml, "parent", &[("link", &joint.parent)]);
    element(xml, "child", &[("link", &joint.child)]);
    element(xml, "origin", &[("xyz", &metres(joint.at_mm))]);
}

fn turning(xml: &mut XmlWriter, axis: Axis, span: &Span<Degrees>, deg_s: f64) {
    let [lower, upper] = radians(span).map(|limit| numbers([limit]));
    let velocity = numbers([deg_s.to_radians()]);
    element(xml, "axis", &[("xyz", &numbers(axis.vector()))]);
    element(
        xml,
        "limit",
        &[
            ("lower", &lower),
            ("upper", &upper),
            ("velocity", &velocity),
            ("effort", "0"),
        ],
    );
}

fn link(xml: &mut XmlWriter, part: &Part) {
    xml.start_element("link");
    xml.write_attribute("name", part.name);
    for shape in &part.shapes {
        xml.start_element("visual");
        place(xml, shape);
        element(xml, "material", &[("name", shape.colour.name())]);
        xml.end_element();
    }
    for shape in &part.shapes {
        xml.start_element("collision");
        place(xml, shape);
        xml.end_element();
    }
    xml.end_element();
}

/// Where a shape is, and what it is.
fn place(xml: &mut XmlWriter, shape: &Shape) {
    let at = metres(shape.at_mm);
    match shape.solid {
        // URDF's cylinders are along Z.
        Solid::Pin { .. } => {
            let quarter = numbers([std::f64::consts::FRAC_PI_2, 0.0, 0.0]);
            element(xml, "origin", &[("xyz", &at), ("rpy", &quarter)]);
        }
        Solid::Box { .. } | Solid::Post { .. } => element(xml, "origin", &[("xyz", &at)]),
    }
    xml.start_element("geometry");
    match shape.solid {
        Solid::Box { size_mm } => element(xml, "box", &[("size", &metres(size_mm))]),
        Solid::Pin { radius_mm, long_mm } | Solid::Post { radius_mm, long_mm } => {
            let [radius, length] = [radius_mm, long_mm].map(|length_mm| metres([length_mm]));
            element(xml, "cylinder", &[("radius", &radius), ("length", &length)]);
        }
    }
    xml.end_element();
}
