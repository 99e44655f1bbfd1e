//! Goes along a way until a rule forbids to.

use dobot_arm::Unreachable;

use crate::distance::distance;
use crate::fence::{Broken, Fence, PathPoint};
use crate::path::Path;

/// Where and why a way is forbidden.
#[derive(Clone, Debug)]
pub(crate) struct Breach {
    pub(crate) broken: Broken,
    /// The first place that is forbidden, where the arm can be there.
    pub(crate) at: Option<PathPoint>,
    /// When it would be there, where that is known.
    pub(crate) at_s: Option<f64>,
    /// The last place that is allowed.
    pub(crate) nearest: PathPoint,
    /// How far the tool went until there.
    pub(crate) gone_mm: f64,
}

/// A way so far.
#[derive(Debug)]
pub(crate) struct PathCheck<'a> {
    fence: Fence<'a>,
    /// Where the arm is.
    here: PathPoint,
    gone_mm: f64,
}

impl<'a> PathCheck<'a> {
    /// Begins where a path does.
    pub(crate) fn begin(mut fence: Fence<'a>, path: &Path) -> Result<Self, Unreachable> {
        let here = fence.stop(0.0, path.place_at(0.0)?);
        fence.begin(&here);
        Ok(Self {
            fence,
            here,
            gone_mm: 0.0,
        })
    }

    /// Goes along a whole path, which begins where the way is.
    pub(crate) fn along(&mut self, path: &Path) -> Result<(), Box<Breach>> {
        self.here.share = 0.0;
        if let Some(broken) = self.fence.broken_at(&self.here).next() {
            let at_s = path.time_at(0.0);
            return Err(Box::new(self.breach(broken, Some(self.here), at_s)));
        }
        self.go(path, 1.0, self.look(path, 1.0), 0)
    }

    /// Goes from here to a share of a path. Where it is not sure that all between is allowed, it goes
    /// to the half first.
    ///
    /// So what is left when it gives up is as short as can be, and all before it is allowed.
    fn go(
        &mut self,
        path: &Path,
        share: f64,
        to: Result<PathPoint, Unreachable>,
        depth: usize,
    ) -> Result<(), Box<Breach>> {
        let broken = match &to {
            Ok(stop) => self
                .fence
                .broken_between(path.interpolation(), &self.here, stop),
            Err(error) => Some(Broken::Unreachable(*error)),
        };
        let is_leaf = |stop: &PathPoint| self.here.is_next_to(stop) || depth == DEEPEST;
        match (broken, to) {
            (None, Ok(stop)) => {
                self.advance(stop);
                return Ok(());
            }
            (Some(broken), Ok(stop)) if is_leaf(&stop) => {
                return Err(Box::new(self.breach(
                    broken,
                    Some(stop),
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
        Ok(self.fence.stop(share, path.place_at(share)?))
    }

    fn advance(&mut self, to: PathPoint) {
        self.gone_mm += distance(self.here.body.tool, to.body.tool);
        self.fence.advance(&to);
        self.here = to;
    }

    const fn breach(&self, broken: Broken, at: Option<PathPoint>, at_s: Option<f64>) -> Breach {
        Breach {
            broken,
            at,
            at_s,
            nearest: self.here,
            gone_mm: self.gone_mm,
        }
    }
}

/// Halving a way this often leaves nothing of it.
const DEEPEST: usize = 40;
