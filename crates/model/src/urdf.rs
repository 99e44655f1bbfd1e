//! The model as URDF, the Unified Robot Description Format of ROS.

use dobot_arm::{Degrees, Span};
use dobot_motion::Speeds;
use xmlwriter::XmlWriter;

use crate::joint::{Axis, Joint, Turn, span_of_follower};
use crate::model::{Model, Part};
use crate::shape::{Colour, Shape, Solid};
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
        for joint in &self.joints {
            self.urdf_joint(&mut xml, joint);
        }
        xml.end_document()
    }

    fn urdf_joint(&self, xml: &mut XmlWriter, joint: &Joint) {
        let names = [joint.name, joint.parent, joint.child];
        match joint.turn {
            Turn::Fixed => {
                start(xml, "fixed", names, joint.at_mm);
                xml.end_element();
            }
            Turn::Driven { axis, span, deg_s } => {
                start(xml, "revolute", names, joint.at_mm);
                turning(xml, axis, &span, deg_s);
                xml.end_element();
            }
            Turn::Follows { rear, fore: 0.0 } => {
                self.mimic(xml, names, joint.at_mm, ("rear", [rear, 0.0]));
            }
            Turn::Follows { rear: 0.0, fore } => {
                self.mimic(xml, names, joint.at_mm, ("fore", [0.0, fore]));
            }
            Turn::Follows { rear, fore } => {
                let between = &format!("{}_level", joint.child);
                element(xml, "link", &[("name", between)]);
                let first = [between, joint.parent, between];
                self.mimic(xml, first, joint.at_mm, ("rear", [rear, 0.0]));
                let second = [joint.name, between, joint.child];
                self.mimic(xml, second, [0.0; 3], ("fore", [0.0, fore]));
            }
        }
    }

    /// A joint that turns so many times as far as another.
    fn mimic(
        &self,
        xml: &mut XmlWriter,
        names: [&str; 3],
        at_mm: [f64; 3],
        (driver, [rear, fore]): (&str, [f64; 2]),
    ) {
        let span = span_of_follower(rear, fore, &self.limits);
        start(xml, "revolute", names, at_mm);
        turning(xml, Axis::Y, &span, Speeds::STOCK.joint_deg_s);
        let times = numbers([rear + fore]);
        element(
            xml,
            "mimic",
            &[("joint", driver), ("multiplier", &times), ("offset", "0")],
        );
        xml.end_element();
    }
}

/// Starts a joint: its name, parent and child.
fn start(xml: &mut XmlWriter, kind: &str, [name, parent, child]: [&str; 3], at_mm: [f64; 3]) {
    xml.start_element("joint");
    xml.write_attribute("name", name);
    xml.write_attribute("type", kind);
    element(xml, "parent", &[("link", parent)]);
    element(xml, "child", &[("link", child)]);
    element(xml, "origin", &[("xyz", &metres(at_mm))]);
}

fn turning(xml: &mut XmlWriter, axis: Axis, span: &Span<Degrees>, deg_s: f64) {
    let [lower, upper] = radians(span).map(|it| numbers([it]));
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
            let [radius, length] = [radius_mm, long_mm].map(|it| metres([it]));
            element(xml, "cylinder", &[("radius", &radius), ("length", &length)]);
        }
    }
    xml.end_element();
}
