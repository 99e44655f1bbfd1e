//! The timeline of a drawing from its plan, before an arm executes it.

use dobot_arm::{Position, TICK_S};
use dobot_geometry::{PathDistance, Point, Stroke};
use dobot_plan::MoveKind;

use crate::output::estimate::PassFigures;
use crate::output::ink::InkLine;
use crate::output::timeline::{MILLI, Moves, Path, Timeline, bounds_mm, figures, rounded};
use crate::output::trace::{Ink, TracePoint, lines};
use crate::prepare::Prepared;

impl Prepared {
    /// Returns the timeline computed from the plan alone, with one row per vector. It is available
    /// immediately, whereas a [`Trace`](crate::Trace) needs a run of a virtual arm. The ink's
    /// deviation is given at the ends of vectors.
    #[must_use]
    pub fn timeline(&self) -> Timeline {
        let moments = self.measured();
        let mut passes: Vec<PassFigures> = self.plan.passes.iter().map(PassFigures::of).collect();
        self.measure(&moments, &mut passes);
        Timeline {
            version: 1,
            duration_s: rounded(self.plan.duration_s(), MILLI),
            tick_s: TICK_S,
            bounds_mm: bounds_mm(&moments),
            passes: passes.into_iter().map(figures).collect(),
            moves: Moves::of(&self.plan, moments[1..].iter().map(|moment| moment.t_s)),
            path: Path::of(moments.iter()),
        }
    }

    /// Returns the ink computed from the plan alone: lines and dots with their passes.
    #[must_use]
    pub fn ink(&self) -> Vec<InkLine> {
        self.lines(&self.measured())
    }

    /// Returns the ink without its deviation from the wanted path.
    #[must_use]
    pub fn planned(&self) -> Vec<Stroke> {
        let lines = self.lines(&self.moments(|_| 0.0));
        lines.into_iter().map(|line| line.stroke).collect()
    }

    fn lines(&self, moments: &[TracePoint]) -> Vec<InkLine> {
        let passes = self.plan.moves.iter().map(|vector| vector.pass);
        // There is no ink at the start of the plan.
        lines(moments[1..].iter().zip(passes))
    }

    fn measured(&self) -> Vec<TracePoint> {
        let wanted = self.wanted();
        let mut near = PathDistance::new(&wanted);
        self.moments(|p| near.distance_mm(p))
    }

    /// Returns the start of the plan and the end of each vector; `error_mm` measures the points on
    /// the paper.
    fn moments(&self, mut error_mm: impl FnMut(Point) -> f64) -> Vec<TracePoint> {
        let moves = &self.plan.moves;
        let begins_ink = |index: usize| moves.get(index).is_some_and(|vector| vector.kind.marks());
        let mut t_s = 0.0;
        let mut moments = vec![moment(0.0, self.plan.start, Ink::None, 0.0)];
        let ends = self.plan.positions().zip(self.plan.durations());
        for (index, (vector, (there, duration_s))) in moves.iter().zip(ends).enumerate() {
            t_s += duration_s;
            let ink = match vector.kind {
                kind if kind.marks() => Ink::Line,
                // Lowering a pen leaves a dot, even if it draws no line.
                MoveKind::Lower if !matches!(moves.get(index + 1), Some(next) if next.kind == MoveKind::Lower) => {
                    Ink::Begin
                }
                _ if begins_ink(index + 1) => Ink::Begin,
                _ => Ink::None,
            };
            let error_mm = match ink {
                Ink::None => 0.0,
                Ink::Line | Ink::Begin => error_mm(Point::new(there[0], there[1])),
            };
            moments.push(moment(t_s, there, ink, error_mm));
        }
        moments
    }

    fn measure(&self, moments: &[TracePoint], passes: &mut [PassFigures]) {
        let mut last = None;
        for (vector, ends) in self.plan.moves.iter().zip(moments.windows(2)) {
            let figures = &mut passes[vector.pass as usize];
            let (from, to) = (&ends[0], &ends[1]);
            let length_mm =
                (to.position.x.0 - from.position.x.0).hypot(to.position.y.0 - from.position.y.0);
            figures.vectors += 1;
            figures.strokes += usize::from(last.replace(vector.stroke) != Some(vector.stroke));
            figures.time_s += to.t_s - from.t_s;
            if vector.kind.marks() {
                figures.ink_mm += length_mm;
                figures.error_mm = figures.error_mm.max(to.error_mm);
            } else {
                figures.travel_mm += length_mm;
            }
        }
    }
}

const fn moment(t_s: f64, [x, y, z]: [f64; 3], ink: Ink, error_mm: f64) -> TracePoint {
    TracePoint {
        t_s,
        position: Position::new(x, y, z),
        ink,
        error_mm,
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_import::{LayersBy, Source};

    use crate::{Settings, prepare};

    #[test]
    fn the_timeline_of_a_plan_is_available_before_any_arm_has_drawn_it() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40"><path d="M10 10H30" stroke="black"/></svg>"#;
        let all = |_| Ok::<(), String>(());
        let prepared = prepare(&Source::from(svg), &Settings::default(), all).unwrap();
        let timeline = prepared.timeline();
        assert!((timeline.duration_s - prepared.plan.duration_s()).abs() < 1e-3);
        assert!((timeline.passes[0].ink_mm - 20.0).abs() < 0.1);
        let ink = &timeline.path.ink;
        let begins = ink.iter().position(|&ink| ink == 2).unwrap();
        assert!(ink[begins + 1..].contains(&1), "{ink:?}");
        assert_eq!(timeline.path.t_s.last(), Some(&timeline.duration_s));
    }

    #[test]
    fn the_ink_of_a_plan_has_its_dots_and_its_layers() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40" stroke-linecap="round"><path d="M10 10H30" stroke="black"/><path d="M20 20h0M20 30h0" stroke="red"/></svg>"#;
        let all = |_| Ok::<(), String>(());
        let settings = Settings {
            layers: Some(LayersBy::Color),
            ..Settings::default()
        };
        let prepared = prepare(&Source::from(svg), &settings, all).unwrap();
        let ink = prepared.ink();
        let dots = ink
            .iter()
            .map(|line| (line.pass, line.stroke.points.len() == 1));
        let expected = [(0, false), (1, true), (1, true)];
        assert_eq!(dots.collect::<Vec<_>>(), expected);
        let errors = ink.iter().flat_map(|line| &line.errors_mm);
        assert!(errors.copied().fold(0.0, f64::max) < 0.05);
    }

    #[test]
    fn a_cancelled_preparation_ends() {
        let settings = Settings::default();
        settings.cancel.cancel();
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm"/>"#;
        let all = |_| Ok::<(), String>(());
        let ended = prepare(&Source::from(svg), &settings, all).unwrap_err();
        assert_eq!(ended, crate::PrepareError::Cancelled);
    }
}
