//! The model as URDF, the Unified Robot Description Format of ROS.

use dobot_arm::{Degrees, Span};
use dobot_motion::Speeds;
use xmlwriter::XmlWriter;

use crate::inertia::Inertia;
use crate::joint::{Axis, Turn, span_of_follower};
use crate::model::Model;
use crate::shape::{Colour, Shape, Solid};
use crate::tree::TreeJoint;
use crate::xml::{TITLE, document, element, metres, numbers, radians};

impl Model {
    /// The model as URDF: metres and radians.
    ///
    /// URDF has no loops: joints that the linkage turns mimic the driven ones. One can mimic a single joint only, so a joint
    /// that follows both arms is written as two, with a link without a shape between them, as `forearm_level`. All driven
    /// joints are in the chain from `base` to `tool`. The shapes are for looks and for collisions. Nobody has measured masses
    /// and forces: links weigh what their shapes would if they were of water, and each `effort` is an estimate.
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
            link(&mut xml, part.name, &part.shapes);
        }
        for joint in self.tree() {
            if !self.parts.iter().any(|part| part.name == joint.child) {
                link(&mut xml, &joint.child, &[]);
            }
            self.urdf_joint(&mut xml, &joint);
            if let Turn::Driven { .. } = joint.turn {
                transmission(&mut xml, &joint.name);
            }
        }
        xml.end_document()
    }

    fn urdf_joint(&self, xml: &mut XmlWriter, joint: &TreeJoint) {
        match joint.turn {
            Turn::Fixed => start(xml, "fixed", joint),
            Turn::Driven { axis, span, deg_s } => {
                start(xml, "revolute", joint);
                turning(xml, axis, &span, deg_s, effort_nm(joint));
            }
            Turn::Follows { rear, fore } => {
                let driver = if fore == 0.0 { "rear" } else { "fore" };
                let span = span_of_follower(rear, fore, &self.limits);
                start(xml, "revolute", joint);
                turning(xml, Axis::Y, &span, Speeds::STOCK.joint_deg_s, MOTOR_NM);
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

fn effort_nm(joint: &TreeJoint) -> f64 {
    if joint.name == "servo" {
        SERVO_NM
    } else {
        MOTOR_NM
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

fn turning(xml: &mut XmlWriter, axis: Axis, span: &Span<Degrees>, deg_s: f64, effort_nm: f64) {
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
            ("effort", &numbers([effort_nm])),
        ],
    );
}

/// Lets Drake and others put a motor to a joint.
fn transmission(xml: &mut XmlWriter, joint: &str) {
    xml.start_element("transmission");
    xml.write_attribute("name", &format!("{joint}_transmission"));
    text(xml, "type", "transmission_interface/SimpleTransmission");
    for (part, name, reduction) in [("joint", joint, None), ("actuator", joint, Some("1"))] {
        xml.start_element(part);
        xml.write_attribute("name", name);
        text(
            xml,
            "hardwareInterface",
            "hardware_interface/PositionJointInterface",
        );
        if let Some(reduction) = reduction {
            text(xml, "mechanicalReduction", reduction);
        }
        xml.end_element();
    }
    xml.end_element();
}

fn text(xml: &mut XmlWriter, name: &str, value: &str) {
    xml.start_element(name);
    xml.set_preserve_whitespaces(true);
    xml.write_text(value);
    xml.end_element();
    xml.set_preserve_whitespaces(false);
}

fn link(xml: &mut XmlWriter, name: &str, shapes: &[Shape]) {
    xml.start_element("link");
    xml.write_attribute("name", name);
    inertial(xml, &Inertia::of(shapes));
    for shape in shapes {
        xml.start_element("visual");
        place(xml, shape);
        element(xml, "material", &[("name", shape.colour.name())]);
        xml.end_element();
    }
    for shape in shapes {
        xml.start_element("collision");
        place(xml, shape);
        xml.end_element();
    }
    xml.end_element();
}

fn inertial(xml: &mut XmlWriter, inertia: &Inertia) {
    xml.start_element("inertial");
    element(xml, "origin", &[("xyz", &numbers(inertia.at_m))]);
    element(xml, "mass", &[("value", &numbers([inertia.mass_kg]))]);
    let [xx, yy, zz] = inertia.moments.map(|moment| numbers([moment]));
    let [xy, xz, yz] = inertia.products.map(|product| numbers([product]));
    let tensor = [
        ("ixx", &*xx),
        ("iyy", &yy),
        ("izz", &zz),
        ("ixy", &xy),
        ("ixz", &xz),
        ("iyz", &yz),
    ];
    element(xml, "inertia", &tensor);
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

/// The torque of the motors of base, rear arm and forearm, estimated.
const MOTOR_NM: f64 = 5.0;
/// The torque of the servo, estimated.
const SERVO_NM: f64 = 1.0;
