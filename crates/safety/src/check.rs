//! The check of a command over its whole path.

use dobot_arm::{Calibration, Position};
use dobot_motion::{ArmPlace, Button, Model, Trajectory, burns};
use dobot_wire::{Command, Configuration, MoveTo, single};

use crate::body::measures;
use crate::effective_rules::EffectiveRules;
use crate::limits::{LASER_AREA, Limit};
use crate::path::Path;
use crate::path_check::PathCheck;
use crate::{Policy, Violation};

impl Policy {
    /// Checks a command over its whole path, starting where the model says that the arm will be.
    ///
    /// For a jog this is the path covered until a client that falls silent is noticed and the
    /// release takes effect. Commands that only stop something (a release, laser off, a stop) are
    /// always allowed.
    ///
    /// # Errors
    ///
    /// [`Violation`] with the rule, the location on the path and the nearest allowed position.
    pub fn check(&self, model: &Model, command: &Command) -> Result<Trajectory, Violation> {
        self.judge(model, command).map_err(|violation| {
            let nearest = match command {
                Command::MoveTo(target) => self.nearest(model, target, violation.nearest),
                _ => violation.nearest,
            };
            Violation {
                nearest,
                ..violation
            }
        })
    }

    fn judge(&self, model: &Model, command: &Command) -> Result<Trajectory, Violation> {
        let trajectory = model
            .trajectory(command)
            .map_err(|error| Violation::of_trajectory(&error))?;
        if stops(command) {
            return Ok(trajectory);
        }
        self.check_settings(model, command, &trajectory)?;
        self.check_laser(model, command, &trajectory)?;
        if trajectory.jog().is_some() {
            let within_s = self.jog.dead_man_s + self.jog.reaction_s;
            self.check_jog(model, command, within_s)?;
        } else if trajectory.moves() {
            self.check_way(model, command, &trajectory)?;
        } else {
            self.check_standing(model, command, &trajectory)?;
        }
        Ok(trajectory)
    }

    /// Returns how far towards a target the arm may go, in tenths of a millimetre as people type
    /// them: the last position of the free path or, if that cannot be a target, one on the line to
    /// the target.
    fn nearest(
        &self,
        model: &Model,
        target: &MoveTo,
        on_the_way: Option<[f64; 3]>,
    ) -> Option<[f64; 3]> {
        let from = model.place.pose.position;
        let raw = |[x, y, z]: [f64; 3]| {
            let place = Position::new(x, y, z);
            model.calibration.raw_place(place, model.tool).ok()
        };
        let is_allowed = |raw: Position| {
            let command = MoveTo {
                x_mm: single(raw.x.0),
                y_mm: single(raw.y.0),
                z_mm: single(raw.z.0),
                ..*target
            };
            self.judge(model, &command.into()).is_ok()
        };
        // Rounding may lead out of what is allowed, so some positions before it are tried as well.
        let rounded = |end: Position| {
            let back = (from - end) * (TENTH_MM / end.distance(from).0.max(TENTH_MM));
            (0..TENTHS_BACK).find_map(|tenths| {
                let place = end + back * f64::from(tenths);
                let place = model.calibration.true_place(place, model.tool).ok()?;
                let place = [place.x.0, place.y.0, place.z.0].map(to_tenths);
                raw(place).is_some_and(is_allowed).then_some(place)
            })
        };
        let on_the_way = on_the_way.and_then(raw).and_then(rounded);
        on_the_way.or_else(|| {
            let to = Position::new(target.x_mm.into(), target.y_mm.into(), target.z_mm.into());
            let place = |share: f64| from + (to - from) * share;
            let (mut allowed, mut forbidden) = (0.0, 1.0);
            for _ in 0..NEAREST_HALVINGS {
                let middle = f64::midpoint(allowed, forbidden);
                if is_allowed(place(middle)) {
                    allowed = middle;
                } else {
                    forbidden = middle;
                }
            }
            (allowed > 0.0).then(|| rounded(place(allowed))).flatten()
        })
    }

    fn check_way(
        &self,
        model: &Model,
        command: &Command,
        trajectory: &Trajectory,
    ) -> Result<(), Violation> {
        let burning = trajectory.laser() || burns(command);
        let paths = paths(trajectory);
        let mut walk = PathCheck::begin(
            EffectiveRules::new(self, model.tool, model.calibration, burning),
            &paths[0],
        )
        .map_err(|error| Violation::of_arm(&error))?;
        let duration_s = trajectory.motion_s().unwrap_or_default();
        let place = |share: f64| {
            let raw = trajectory.place_at(share * duration_s).ok()?;
            Some(model.calibrated_place(&raw))
        };
        paths
            .iter()
            .filter(|path| path.time_at(0.0) < path.time_at(1.0))
            .try_for_each(|path| walk.along(path))
            .map_err(|breach| {
                Violation::of_breach(&breach, |limit| worst(limit, &model.calibration, place))
            })
    }

    /// Checks a command without motion: the position that the arm is to assume, with the tool that
    /// it is to assume, and the position where a standing laser would burn.
    fn check_standing(
        &self,
        model: &Model,
        command: &Command,
        trajectory: &Trajectory,
    ) -> Result<(), Violation> {
        let after = model.after(command, trajectory);
        let applies = |rule: &str| match command {
            Command::Configuration(Configuration::InitialAngles { .. }) => {
                rule.starts_with("joints.")
            }
            Command::Configuration(Configuration::EndEffector { .. }) => true,
            _ => burns(command) && rule == LASER_AREA,
        };
        let rules = EffectiveRules::new(self, after.tool, after.calibration, burns(command));
        let point = rules.point_at(0.0, after.place);
        rules
            .broken_at(&point)
            .map(|broken| Violation::of_place(&broken, &point))
            .find(|violation| applies(&violation.rule))
            .map_or(Ok(()), Err)
    }
}

/// Returns the measured value farthest outside a limit on a path, sampled by shares.
pub(crate) fn worst(
    limit: &Limit,
    arm: &Calibration,
    place: impl Fn(f64) -> Option<ArmPlace>,
) -> f64 {
    let excess = |value: f64| (value - limit.bounds.nearest(value)).abs();
    (0..=LOOKS)
        .filter_map(|look| place(f64::from(look) / f64::from(LOOKS)))
        .map(|place| measures(&place, arm)[limit.measure as usize])
        .max_by(|a, b| excess(*a).total_cmp(&excess(*b)))
        .unwrap_or(f64::NAN)
}

/// Returns whether a command only stops something.
fn stops(command: &Command) -> bool {
    match command {
        Command::WriteVector(vector) => vector.stop && !vector.laser,
        _ => matches!(
            Button::of(command),
            Some(Button::Released | Button::Laser(false) | Button::Suction(false))
        ),
    }
}

fn paths(trajectory: &Trajectory) -> [Path<'_>; 3] {
    let segments = trajectory.segments();
    let ends_s = segments.map(|segment| segment.until_s);
    [0, 1, 2].map(|index| Path::Trajectory {
        trajectory,
        from_s: if index == 0 { 0.0 } else { ends_s[index - 1] },
        to_s: ends_s[index],
        interpolation: segments[index].interpolation,
    })
}

/// The number of samples on a forbidden path to find how far out it leads.
const LOOKS: u32 = 256;
/// Rounds to tenths; negative zero becomes zero.
fn to_tenths(mm: f64) -> f64 {
    (mm * 10.0).round() / 10.0 + 0.0
}

const TENTH_MM: f64 = 0.1;
/// The number of tenths tried before the nearest position.
const TENTHS_BACK: u32 = 12;
/// The number of bisections of the path to the nearest position: a hundredth of a millimetre out of
/// 400.
const NEAREST_HALVINGS: u32 = 16;
