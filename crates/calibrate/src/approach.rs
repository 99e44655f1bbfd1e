//! The side from which the joints come to a touch.

use dobot_arm::Joints;
use thiserror::Error;

/// Follows the joints of an arm from status to status.
///
/// A joint with backlash stands differently depending on the side from which it came. All touches
/// come from the right and from above: then each joint turns on, to larger angles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Approach {
    /// Base, rear arm and forearm; `None` before the first status.
    turns: Option<[Turn; 3]>,
}

/// How a joint has turned, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turn {
    /// The largest angle since the joint last turned back.
    most: f64,
    /// The angle to which it turned back; `None` if that was never seen.
    back: Option<f64>,
}

impl Approach {
    /// Handles the raw joint angles of a status.
    pub fn handle_status(&mut self, raw: &Joints) {
        let angles = [raw.base, raw.rear, raw.fore].map(|angle| angle.0);
        let turns = self.turns.get_or_insert_with(|| angles.map(Turn::at));
        for (turn, angle) in turns.iter_mut().zip(angles) {
            turn.follow(angle);
        }
    }

    /// Checks that a touch here comes from the right and from above.
    ///
    /// # Errors
    ///
    /// [`OtherSide`] with the first joint that came from the other side.
    pub fn check(&self) -> Result<(), OtherSide> {
        let names = ["base", "rear arm", "forearm"];
        let wrong = self
            .turns
            .iter()
            .flatten()
            .zip(names)
            .find(|(turn, _)| !turn.is_on());
        wrong.map_or(Ok(()), |(_, joint)| Err(OtherSide { joint }))
    }
}

impl Turn {
    const fn at(angle: f64) -> Self {
        Self {
            most: angle,
            back: None,
        }
    }

    fn follow(&mut self, angle: f64) {
        if angle < self.most - CORRECTION_DEG {
            *self = Self {
                most: angle,
                back: Some(angle),
            };
        }
        self.most = self.most.max(angle);
    }

    fn is_on(&self) -> bool {
        self.back.is_none_or(|back| self.most - back >= RUN_UP_DEG)
    }
}

/// The error returned when a joint came to a touch from the other side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error(
    "the {joint} came from the other side; go 5 mm up and right, then left and down to the point"
)]
pub struct OtherSide {
    /// The joint.
    pub joint: &'static str,
}

/// A joint may turn back by so much, to correct the tip by a few tenths of a millimetre.
const CORRECTION_DEG: f64 = 0.08;
/// A joint has to turn on by so much after it turned back.
const RUN_UP_DEG: f64 = 0.25;

#[cfg(test)]
mod tests {
    use super::*;

    fn after(angles: &[[f64; 3]]) -> Result<(), OtherSide> {
        let mut approach = Approach::default();
        for [base, rear, fore] in angles {
            approach.handle_status(&Joints::new(*base, *rear, *fore, 0.0));
        }
        approach.check()
    }

    #[test]
    fn a_touch_after_all_joints_turned_on_is_accepted() {
        assert_eq!(after(&[[0.0, 40.0, 45.0]]), Ok(()));
        assert_eq!(
            after(&[[9.0, 50.0, 55.0], [0.0, 40.0, 45.0], [0.3, 40.3, 45.3]]),
            Ok(())
        );
    }

    #[test]
    fn a_joint_that_turned_back_last_is_named_with_a_remedy() {
        for (joint, name) in ["base", "rear arm", "forearm"].into_iter().enumerate() {
            let mut end = [0.5, 41.0, 46.0];
            end[joint] -= 0.2;
            let error =
                after(&[[0.0, 40.0, 45.0], [0.5, 41.0, 46.0], end]).expect_err("it turned back");
            assert_eq!(error.joint, name);
            assert!(error.to_string().contains("go 5 mm up and right"));
        }
    }

    #[test]
    fn a_slow_turn_back_counts_like_a_fast_one() {
        let slowly: Vec<[f64; 3]> = (0..20)
            .map(|n| [10.0 - 0.05 * f64::from(n), 40.0, 45.0])
            .collect();
        assert!(after(&slowly).is_err());
    }

    #[test]
    fn a_correction_of_a_tenth_of_a_millimetre_is_accepted() {
        assert_eq!(
            after(&[[0.0, 40.0, 45.0], [1.0, 41.0, 46.0], [1.0, 41.03, 45.96]]),
            Ok(())
        );
    }

    #[test]
    fn a_turn_of_less_than_the_backlash_does_not_count_as_an_approach_from_the_right_side() {
        assert!(after(&[[5.0, 40.0, 45.0], [0.0, 40.0, 45.0], [0.1, 40.0, 45.0]]).is_err());
    }
}
