//! Wrong touches: the ones without which the others agree far better.

use dobot_arm::Tool;
use dobot_geometry::{Point, least_width};

use crate::Touch;
use crate::solve::{Solved, Suspect, length, solve};

/// The touches without the wrong ones.
#[derive(Debug)]
pub(crate) struct Kept {
    /// The indexes of the wrong touches, at most two, in order.
    pub(crate) wrong: Vec<usize>,
    /// The other touches.
    pub(crate) touches: Vec<Touch>,
    /// The best parameters for the other touches.
    pub(crate) solved: Solved,
}

impl Kept {
    fn without(wrong: Vec<usize>, touches: &[Touch], tool: Tool) -> Self {
        let is_kept = |&(index, _): &(usize, &Touch)| !wrong.contains(&index);
        let touches: Vec<Touch> = touches
            .iter()
            .enumerate()
            .filter(is_kept)
            .map(|(_, touch)| *touch)
            .collect();
        Self {
            solved: solve(&touches, tool, Suspect::Nothing),
            wrong,
            touches,
        }
    }

    /// Returns whether these touches agree far better than those of another choice with more
    /// touches, and whether each wrong touch is far from where they expect it.
    fn is_far_better(&self, other: &Self, touches: &[Touch], tool: Tool) -> bool {
        let gain = other.solved.cost - self.solved.cost;
        let is_far = |index: &usize| {
            length(&self.solved.numbers.away_mm(&touches[*index], tool, false)) > WRONG_MM
        };
        gain > WRONG_GAIN && gain > other.solved.cost / 2.0 && self.wrong.iter().all(is_far)
    }
}

/// Leaves out the wrong touches: one or two, of all choices the best one.
pub(crate) fn without_wrong(touches: &[Touch], tool: Tool) -> Kept {
    let mut kept = Kept::without(Vec::new(), touches, tool);
    let all = kept.solved.clone();
    // Two wrong touches can hide each other: a pair is compared with the best single one even if
    // that is not wrong by itself.
    let mut fewer: Option<Kept> = None;
    for count in 1..=MIN_TOUCHES.len() {
        if touches.len() < MIN_TOUCHES[count - 1] {
            break;
        }
        let Some(wrong) = best_choice(&all, touches, count) else {
            break;
        };
        let best = Kept::without(wrong, touches, tool);
        let before = fewer.as_ref().unwrap_or(&kept);
        if best.is_far_better(before, touches, tool) {
            kept = best;
            fewer = None;
        } else {
            fewer = Some(best);
        }
    }
    kept
}

/// Returns the choice of this many touches without which the others agree best and still span a
/// calibration.
fn best_choice(all: &Solved, touches: &[Touch], count: usize) -> Option<Vec<usize>> {
    let single = (0..touches.len()).map(|index| vec![index]);
    let choices: Vec<Vec<usize>> = if count == 1 {
        single.collect()
    } else {
        single
            .flat_map(|first| (0..first[0]).map(move |other| vec![other, first[0]]))
            .collect()
    };
    choices
        .into_iter()
        .filter(|choice| width_without(touches, choice) >= MIN_WIDTH_MM)
        .map(|choice| (all.cost_without(&choice), choice))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, choice)| choice)
}

/// Returns the width of the narrowest strip that holds all points but some, seen from above, in mm.
pub(crate) fn width_without(touches: &[Touch], left_out: &[usize]) -> f64 {
    let kept = touches
        .iter()
        .enumerate()
        .filter(|(index, _)| !left_out.contains(index));
    let places = kept.map(|(_, touch)| Point::new(touch.place_mm[0], touch.place_mm[1]));
    least_width(&places.collect::<Vec<_>>())
}

/// The least number of touches in which one wrong touch, and two, can be identified.
const MIN_TOUCHES: [usize; 2] = [6, 10];
/// The least width of the strip that holds all points.
pub(crate) const MIN_WIDTH_MM: f64 = 60.0;
/// How much better the others agree without a wrong touch, in squared standard deviations of a
/// touch.
const WRONG_GAIN: f64 = 20.0;
const WRONG_MM: f64 = 1.5;
