//! The model as MJCF, the format of the simulator MuJoCo.

use xmlwriter::XmlWriter;

use crate::joint::{Joint, Turn, opening};
use crate::model::Model;
use crate::shape::{Colour, Shape, Solid};
use crate::xml::{TITLE, document, element, metres, numbers, radians};

impl Model {
    /// The model as MJCF: metres and radians, with closed loops.
    ///
    /// The pins of the linkage are `connect` constraints, and the limit of the elbow's opening is that of a tendon. Four
    /// position actuators turn the driven joints; they take joint angles in radians. The sites `wrist`, `tool` and `tip` are
    /// the frames of these names. Nobody has measured masses and forces: bodies weigh what their shapes would if they were
    /// of water, gravity does not pull at them, and the actuators are stiff. The arm touches other things, but not itself.
    #[must_use]
    pub fn to_mjcf(&self) -> String {
        let mut xml = document(TITLE);
        xml.start_element("mujoco");
        xml.write_attribute("model", "dobot_arm");
        element(&mut xml, "compiler", &[("angle", "radian")]);
        element(&mut xml, "option", &[("integrator", "implicitfast")]);
        defaults(&mut xml);
        colours(&mut xml);
        xml.start_element("worldbody");
        self.body(&mut xml, "base", None);
        xml.end_element();
        self.loops(&mut xml);
        self.opening(&mut xml);
        self.actuators(&mut xml);
        xml.end_document()
    }

    /// A part and all that hangs from it.
    fn body(&self, xml: &mut XmlWriter, name: &str, joint: Option<&Joint>) {
        let at = metres(joint.map_or([0.0; 3], |joint| joint.at_mm));
        if joint.is_some_and(|joint| joint.turn == Turn::Fixed) {
            return element(xml, "site", &[("name", name), ("pos", &at)]);
        }
        xml.start_element("body");
        for (name, value) in [("name", name), ("pos", &at), ("gravcomp", "1")] {
            xml.write_attribute(name, value);
        }
        if let Some(joint) = joint {
            hinge(xml, joint);
        }
        if name == "wrist" || name == "tool" {
            element(xml, "site", &[("name", name)]);
        }
        for part in self.parts.iter().filter(|part| part.name == name) {
            for shape in &part.shapes {
                geom(xml, shape);
            }
        }
        for child in self.joints_of(name) {
            self.body(xml, child.child, Some(child));
        }
        xml.end_element();
    }

    fn loops(&self, xml: &mut XmlWriter) {
        xml.start_element("equality");
        for pin in &self.pins {
            let [one, other] = pin.parts;
            let anchor = metres(pin.at_mm[0]);
            element(
                xml,
                "connect",
                &[
                    ("name", pin.name),
                    ("body1", one),
                    ("body2", other),
                    ("anchor", &anchor),
                ],
            );
        }
        xml.end_element();
    }

    fn opening(&self, xml: &mut XmlWriter) {
        let range = numbers(radians(&opening(&self.limits)));
        xml.start_element("tendon");
        xml.start_element("fixed");
        for (name, value) in [("name", "opening"), ("range", &range)] {
            xml.write_attribute(name, value);
        }
        for (joint, times) in [("rear", "1"), ("fore", "-1")] {
            element(xml, "joint", &[("joint", joint), ("coef", times)]);
        }
        xml.end_element();
        xml.end_element();
    }

    fn actuators(&self, xml: &mut XmlWriter) {
        xml.start_element("actuator");
        for joint in &self.joints {
            if let Turn::Driven { .. } = joint.turn {
                element(
                    xml,
                    "position",
                    &[("name", joint.name), ("joint", joint.name)],
                );
            }
        }
        xml.end_element();
    }
}

/// So stiff that the arm comes to rest where its targets are; no softer pin would keep the linkage together meanwhile.
fn defaults(xml: &mut XmlWriter) {
    xml.start_element("default");
    element(xml, "joint", &[("armature", "0.01"), ("damping", "0.1")]);
    element(xml, "geom", &[("contype", "0"), ("conaffinity", "1")]);
    let solver = [("solref", "0.004 1"), ("solimp", "0.99 0.9999 0.0001")];
    element(xml, "equality", &solver);
    let servo = [("kp", "100"), ("dampratio", "1"), ("inheritrange", "1")];
    element(xml, "position", &servo);
    xml.end_element();
}

fn colours(xml: &mut XmlWriter) {
    xml.start_element("asset");
    for colour in Colour::ALL {
        let rgba = numbers(colour.rgba());
        element(xml, "material", &[("name", colour.name()), ("rgba", &rgba)]);
    }
    xml.end_element();
}

/// A joint; one that follows has no stops of its own.
fn hinge(xml: &mut XmlWriter, joint: &Joint) {
    xml.start_element("joint");
    xml.write_attribute("name", joint.name);
    xml.write_attribute("axis", &numbers(joint.turn.axis().vector()));
    if let Turn::Driven { span, .. } = joint.turn {
        xml.write_attribute("range", &numbers(radians(&span)));
    }
    xml.end_element();
}

fn geom(xml: &mut XmlWriter, shape: &Shape) {
    let at = metres(shape.at_mm);
    // MuJoCo takes half lengths.
    let (kind, size) = match shape.solid {
        Solid::Box { size_mm } => ("box", metres(size_mm.map(|edge_mm| edge_mm / 2.0))),
        Solid::Pin { radius_mm, long_mm } | Solid::Post { radius_mm, long_mm } => {
            ("cylinder", metres([radius_mm, long_mm / 2.0]))
        }
    };
    xml.start_element("geom");
    for (name, value) in [("type", kind), ("size", &size), ("pos", &at)] {
        xml.write_attribute(name, value);
    }
    if let Solid::Pin { .. } = shape.solid {
        // Its cylinders are along Z.
        xml.write_attribute("zaxis", "0 1 0");
    }
    xml.write_attribute("material", shape.colour.name());
    xml.end_element();
}
