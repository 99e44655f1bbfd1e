//! Follows a path until a rule forbids it.

use dobot_arm::Unreachable;

use crate::distance::distance;
use crate::effective_rules::{Broken, EffectiveRules, PathPoint};
use crate::path::Path;

/// Where and why a path is forbidden.
#[derive(Clone, Debug)]
pub(crate) struct Breach {
    pub(crate) broken: Broken,
    /// The first forbidden point, if the arm can be there.
    pub(crate) at: Option<PathPoint>,
    /// When the arm would be there, if known.
    pub(crate) at_s: Option<f64>,
    /// The last allowed point.
    pub(crate) nearest: PathPoint,
    /// The distance covered by the tool until there.
    pub(crate) covered_mm: f64,
}

/// The check of a path, up to the current point.
#[derive(Debug)]
pub(crate) struct PathCheck<'a> {
    rules: EffectiveRules<'a>,
    /// The current point.
    here: PathPoint,
    covered_mm: f64,
}

impl<'a> PathCheck<'a> {
    /// Starts at the start of a path.
    pub(crate) fn begin(mut rules: EffectiveRules<'a>, path: &Path) -> Result<Self, Unreachable> {
        let here = rules.point_at(0.0, path.place_at(0.0)?);
        rules.begin(&here);
        Ok(Self {
            rules,
            here,
            covered_mm: 0.0,
        })
    }

    /// Follows a whole path that starts at the current point.
    pub(crate) fn along(&mut self, path: &Path) -> Result<(), Box<Breach>> {
        self.here.share = 0.0;
        if let Some(broken) = self.rules.broken_at(&self.here).next() {
            let at_s = path.time_at(0.0);
            return Err(Box::new(self.breach(broken, Some(self.here), at_s)));
        }
        self.go(path, 1.0, self.look(path, 1.0), 0)
    }

    /// Moves from the current point to a share of a path. If not everything between is certainly
    /// allowed, bisects.
    ///
    /// So the rest after the last allowed point is as short as possible, and everything before it
    /// is allowed.
    fn go(
        &mut self,
        path: &Path,
        share: f64,
        to: Result<PathPoint, Unreachable>,
        depth: usize,
    ) -> Result<(), Box<Breach>> {
        let broken = match &to {
            Ok(point) => self
                .rules
                .broken_between(path.interpolation(), &self.here, point),
            Err(error) => Some(Broken::Unreachable(*error)),
        };
        let is_leaf = |point: &PathPoint| self.here.is_next_to(point) || depth == DEEPEST;
        match (broken, to) {
            (None, Ok(point)) => {
                self.advance(point);
                return Ok(());
            }
            (Some(broken), Ok(point)) if is_leaf(&point) => {
                return Err(Box::new(self.breach(
                    broken,
                    Some(point),
                    path.time_at(share),
                )));
            }
            (Some(broken), Err(_)) if depth == DEEPEST => {
                return Err(Box::new(self.breach(broken, None, path.time_at(share))));
            }
            _ => {}
        }
        let half = 0.5 * (self.here.share + share);
        self.go(path, half, self.look(path, half), depth + 1)?;
        self.go(path, share, to, depth + 1)
    }

    fn look(&self, path: &Path, share: f64) -> Result<PathPoint, Unreachable> {
        Ok(self.rules.point_at(share, path.place_at(share)?))
    }

    fn advance(&mut self, to: PathPoint) {
        self.covered_mm += distance(self.here.body.tool, to.body.tool);
        self.rules.advance(&to);
        self.here = to;
    }

    const fn breach(&self, broken: Broken, at: Option<PathPoint>, at_s: Option<f64>) -> Breach {
        Breach {
            broken,
            at,
            at_s,
            nearest: self.here,
            covered_mm: self.covered_mm,
        }
    }
}

/// Bisecting a path this often leaves nothing of it.
const DEEPEST: usize = 40;
