//! The values that a stock arm takes although no table allows them.

use crate::{Frame, ParseError};

/// A value that no table allows, and that a stock arm takes all the same: it checks nothing (note N34), and
/// only some packets make it hang or lose its pose (note N51).
///
/// Programs written for such an arm rely on it. This list of accepted values serves such programs and
/// explains their packets.
///
/// ```
/// use dobot_wire::{Command, Dialect, Frame, Leniency};
///
/// // A target at which the pump is half on.
/// let frame = Frame::ZERO.with(1, 3.0).with(3, 200.0).with(7, 0.5);
/// let error = Command::parse(&frame.into(), &Dialect::FIRMWARE_1_1).unwrap_err();
/// let leniency = Leniency::of(&frame, &error).unwrap();
/// assert_eq!(leniency.effect, "leaves pump and gripper as they are");
/// // The pump runs at present, and the gripper is at 20 degrees.
/// let in_force = Frame::ZERO.with(7, 1.0).with(9, 20.0);
/// let sent = leniency.stand_in(&frame, &error, &in_force);
/// assert_eq!(sent, frame.with(7, 1.0).with(9, 20.0));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Leniency {
    /// The states in which it holds.
    states: &'static [i16],
    /// The floats' names, as in their table.
    names: &'static [&'static str],
    /// Whether it holds for the value that was found.
    when: fn(&Frame, f32) -> bool,
    /// The effect of such a value on a stock arm, as the end of a sentence.
    pub effect: &'static str,
    /// The nearest allowed value.
    pub instead: Instead,
    /// Whether an arm that is sent that does the same, or less: then it may be sent for the other.
    pub is_harmless: bool,
}

/// The replacement of a value that is not allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instead {
    /// This one.
    Value(f32),
    /// The nearest in this range.
    Nearest(f32, f32),
    /// The current value.
    InForce,
    /// Pump and gripper as they are: floats 7 and 9 of a target.
    Tool,
    /// The number without its fraction.
    Whole,
    /// The release of the button, instead of its press.
    Release,
}

impl Leniency {
    /// Why a stock arm minds an error not, if it does not.
    #[must_use]
    pub fn of(frame: &Frame, error: &ParseError) -> Option<&'static Self> {
        let ParseError::OutOfRange { name, found, .. } = *error else {
            return None;
        };
        let state = frame.float(1);
        let holds = |entry: &&Self| {
            entry.states.iter().any(|allowed| whole(state) == *allowed)
                && entry.names.contains(&name)
                && (entry.when)(frame, found)
        };
        found.is_finite().then(|| ALL.iter().find(holds)).flatten()
    }

    /// The frame with the replacement for the invalid value; `in_force` holds the current values,
    /// each at the float that sets it.
    #[must_use]
    pub fn stand_in(&self, frame: &Frame, error: &ParseError, in_force: &Frame) -> Frame {
        let ParseError::OutOfRange { float, found, .. } = *error else {
            return *frame;
        };
        match self.instead {
            Instead::Value(value) => frame.with(float, value),
            Instead::Nearest(least, most) => frame.with(float, found.clamp(least, most)),
            Instead::InForce => frame.with(float, in_force.float(float)),
            Instead::Tool => frame.with(7, in_force.float(7)).with(9, in_force.float(9)),
            Instead::Whole => frame.with(float, f32::from(whole(found))),
            Instead::Release => frame.with(2, 0.0).with(float, 0.0),
        }
    }
}

/// Whether a jog packet presses a button that moves something: neither a release nor a switch.
fn is_press(frame: &Frame) -> bool {
    !matches!(whole(frame.float(2)), 0 | 9 | 10 | 13 | 14)
}

/// A code as a stock arm takes it.
#[expect(
    clippy::cast_possible_truncation,
    reason = "that is what a stock arm does; beyond 16 bits there are no codes"
)]
const fn whole(code: f32) -> i16 {
    code as i16
}

/// The list. Where two entries hold, the first one counts.
const ALL: &[Leniency] = &[
    Leniency {
        states: &[3, 6],
        names: &["isGrab"],
        effect: "leaves pump and gripper as they are",
        instead: Instead::Tool,
        ..OVERLOOKED
    },
    Leniency {
        states: &[1, 8],
        names: &["isGrab"],
        when: |_, _| true,
        effect: "leaves pump and gripper as they are",
        instead: Instead::InForce,
        is_harmless: false, // A switch would turn the gripper, too.
    },
    Leniency {
        states: &[3, 6],
        names: &["GripperValue"],
        effect: "drives the gripper's servo against its end",
        instead: Instead::Nearest(-90.0, 90.0),
        ..OVERLOOKED
    },
    Leniency {
        states: &[3, 6],
        names: &["PauseTime"],
        when: |_, found| found < 0.0,
        effect: "does not pause",
        ..OVERLOOKED
    },
    Leniency {
        states: &[2, 7],
        names: &["StarVel"],
        when: |frame, _| !is_press(frame),
        effect: "does not look at it, for nothing is to move",
        ..OVERLOOKED
    },
    Leniency {
        states: &[2, 7],
        names: &["StarVel"],
        when: |_, found| found == 0.0,
        effect: "stands still",
        instead: Instead::Release,
        is_harmless: true,
    },
    Leniency {
        states: &[2, 7],
        names: &["StarVel"],
        when: |_, found| found > 0.0,
        effect: "goes at that speed",
        instead: Instead::Nearest(1.0, 100.0),
        is_harmless: true,
    },
    Leniency {
        states: &[2, 7],
        names: &["StarVel"],
        when: |_, _| true,
        effect: "goes the other way, without a ramp",
        instead: Instead::Nearest(1.0, 100.0),
        is_harmless: false,
    },
    Leniency {
        states: &[4],
        names: &["isLaser"],
        when: |frame, _| whole(frame.float(2)) == 0,
        ..OVERLOOKED
    },
    Leniency {
        states: &[4],
        names: &["isLaser"],
        effect: "leaves the laser as it is",
        is_harmless: false, // It may burn, and the acceleration is another one (note N48).
        ..OVERLOOKED
    },
    Leniency {
        states: &[4],
        names: &["stop"],
        effect: "does not stop",
        ..OVERLOOKED
    },
    Leniency {
        states: &[4],
        names: &["StartVel"],
        ..OVERLOOKED
    },
    Leniency {
        states: &[9],
        names: &[
            "joint jog speed",
            "joint jog acceleration",
            "joint 4 speed",
            "joint 4 acceleration",
            "linear jog speed",
            "linear jog acceleration",
        ],
        when: |_, found| found == 0.0,
        effect: "does not jog these axes then",
        instead: Instead::InForce,
        is_harmless: true,
    },
    Leniency {
        states: &[9],
        names: &["default pause time"],
        instead: Instead::InForce,
        ..OVERLOOKED
    },
    Leniency {
        states: &[10],
        names: &["mode"],
        ..OVERLOOKED
    },
    Leniency {
        states: &[10],
        names: &["teaching speed"],
        instead: Instead::InForce,
        ..OVERLOOKED
    },
    Leniency {
        states: &[10],
        names: &["playback speed", "playback acceleration"],
        when: |_, found| found > 100.0,
        effect: "is that much faster",
        instead: Instead::Value(100.0),
        is_harmless: true,
    },
    Leniency {
        states: &[2, 3, 4, 6, 7, 9],
        names: &["Axis", "MovingMode", "mode", "end effector"],
        when: |_, found| f32::from(whole(found)) != found,
        effect: "cuts the fraction off",
        instead: Instead::Whole,
        is_harmless: false, // A sign of floats in the wrong place (note N6).
    },
];

/// A stock arm does not look at this value, whatever it is.
const OVERLOOKED: Leniency = Leniency {
    states: &[],
    names: &[],
    when: |_, _| true,
    effect: "does not look at it",
    instead: Instead::Value(0.0),
    is_harmless: true,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Command, Dialect};

    fn frame(floats: &[f32]) -> Frame {
        let floats = (1..).zip(floats);
        floats.fold(Frame::ZERO, |frame, (n, value)| frame.with(n, *value))
    }

    /// Replaces the floats of a packet one by one until it is allowed.
    fn stand_in(floats: &[f32], in_force: &Frame) -> Option<(Frame, bool)> {
        let mut sent = frame(floats);
        let mut is_harmless = true;
        for _ in 0..10 {
            match Command::parse(&sent.into(), &Dialect::FIRMWARE_1_1) {
                Ok(_) => return Some((sent, is_harmless)),
                Err(error) => {
                    let leniency = Leniency::of(&sent, &error)?;
                    is_harmless &= leniency.is_harmless;
                    sent = leniency.stand_in(&sent, &error, in_force);
                }
            }
        }
        None
    }

    #[test]
    fn each_entry_results_in_an_allowed_packet() {
        let in_force = frame(&[0.0, 0.0, 15.0, 50.0, 30.0, 10.0, 1.0, 40.0, 20.0]);
        let cases: &[(&[f32], &[f32])] = &[
            (
                &[3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 2.0, 0.0, 130.0, -1.0],
                &[3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 1.0, 0.0, 20.0, 0.0],
            ),
            (
                &[6.0, 0.0, 0.0, 45.0, 45.0, 0.0, 0.0, 0.0, -130.0],
                &[6.0, 0.0, 0.0, 45.0, 45.0, 0.0, 0.0, 0.0, -90.0],
            ),
            (&[2.0, 3.0], &[2.0]),
            (
                &[7.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 130.0],
                &[7.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 100.0],
            ),
            (
                &[7.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5],
                &[7.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            ),
            (&[2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -3.0], &[2.0]),
            (&[2.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 150.0], &[2.0, 9.0]),
            (
                &[4.0, 0.0, 1.0, 0.0, 0.0, 7.0, 7.0, -7.0, 0.0, 50.0],
                &[4.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0],
            ),
            (
                &[9.0, 0.0, 50.0, 100.0],
                &[9.0, 0.0, 50.0, 100.0, 30.0, 10.0, 1.0, 40.0],
            ),
            (
                &[9.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 700.0],
                &[9.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 20.0],
            ),
            (&[10.0, 1.0, 130.0, 50.0], &[10.0, 0.0, 100.0, 50.0, 30.0]),
        ];
        for (found, expected) in cases {
            let expected = Some((frame(expected), true));
            assert_eq!(stand_in(found, &in_force), expected, "{found:?}");
        }
    }

    #[test]
    fn a_packet_that_a_stock_arm_accepts_with_another_effect_is_not_harmless() {
        let in_force = frame(&[1.0; 10]);
        for found in [
            &[1.0, 0.0, 5.0, 5.0, 5.0, 0.0, 0.5][..],
            &[8.0, 0.0, 5.0, 5.0, 5.0, 0.0, 0.5],
            &[2.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -5.0],
            &[4.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 50.0],
            &[2.0, 1.5, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0],
        ] {
            let is_harmless = stand_in(found, &in_force).map(|(_, is_harmless)| is_harmless);
            assert_eq!(is_harmless, Some(false), "{found:?}");
        }
    }

    #[test]
    fn packets_that_hang_a_stock_arm_or_lose_its_pose_are_not_in_the_list() {
        let in_force = frame(&[1.0; 10]);
        for found in [
            &[0.0][..],
            &[5.0],
            &[11.0],
            &[2.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0],
            &[3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 0.0, 3.0],
            &[3.0, 0.0, 200.0, 0.0, 0.0, 0.0, f32::NAN],
            &[3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 0.0, 0.0, 130.0, 700.0],
            &[4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0],
            &[9.0, 1.0],
            &[9.0, 2.0],
            &[10.0, 0.0, 0.0, 50.0],
        ] {
            assert_eq!(stand_in(found, &in_force), None, "{found:?}");
        }
    }
}
