//! Small pictures of lines, for lists of files and jobs.

use std::collections::HashSet;
use std::fmt::Write;

use dobot_api::JobPath;
use dobot_draw::Path;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A small picture of lines, seen from above by a person behind the arm: -Y to the right, X up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Sketch {
    /// Left, top, width and height of the lines, in mm: the `viewBox` of an SVG.
    pub(crate) view_mm: [f64; 4],
    /// The lines as the data of an SVG path, at most 8,192 characters; what is too small to be seen
    /// is left out.
    pub(crate) path: String,
    /// The length of all lines, in mm.
    pub(crate) drawn_mm: f64,
}

/// A line: its corners, to the right and down, in mm.
type Line = Vec<[f64; 2]>;

impl Sketch {
    /// Returns the picture of a planned drawing; `None` if it has no lines.
    pub(crate) fn of_plan(path: &Path) -> Option<Self> {
        let mut lines: Vec<Line> = Vec::new();
        for ((&x, &y), &ink) in path.x_mm.iter().zip(&path.y_mm).zip(&path.ink) {
            let corner = seen(x, y);
            match (ink, lines.last_mut()) {
                (2, _) | (1, None) => lines.push(vec![corner]),
                (1, Some(line)) => line.push(corner),
                _ => {}
            }
        }
        Self::of(&lines)
    }

    /// Returns the picture of what a job draws; of a job without ink, its whole path. `None` if it
    /// does not move.
    pub(crate) fn of_job(path: &JobPath) -> Option<Self> {
        let draws = path.marks.contains(&true);
        let mut lines: Vec<Line> = Vec::new();
        let mut from = None;
        for (&[x, y, _], &marks) in path.path_mm.iter().zip(&path.marks) {
            let corner = seen(x, y);
            if marks || !draws {
                match (lines.last_mut(), from) {
                    (Some(line), None) => line.push(corner),
                    (_, Some(from)) => lines.push(vec![from, corner]),
                    (None, None) => lines.push(vec![corner]),
                }
                from = None;
            } else {
                from = Some(corner);
            }
        }
        let sketch = Self::of(&lines)?;
        let drawn_mm = if draws { sketch.drawn_mm } else { 0.0 };
        Some(Self { drawn_mm, ..sketch })
    }

    fn of(lines: &[Line]) -> Option<Self> {
        let corners = || lines.iter().flatten();
        let ends = |axis: usize| {
            let along = corners().map(|corner| corner[axis]);
            along.fold([f64::MAX, f64::MIN], |[least, most], at| {
                [least.min(at), most.max(at)]
            })
        };
        let [[left, right], [top, bottom]] = [ends(0), ends(1)];
        if left > right {
            return None;
        }
        let [width, height] = [right - left, bottom - top];
        let mut detail_mm = (width.max(height) / DETAILS).max(0.01);
        let mut path = path_of(lines, detail_mm);
        while path.len() > LONGEST {
            detail_mm *= 1.5;
            path = path_of(lines, detail_mm);
        }
        Some(Self {
            view_mm: [left, top, width, height].map(rounded),
            path,
            drawn_mm: rounded(lines.iter().map(length).sum()),
        })
    }
}

/// Returns the data of an SVG path without what is smaller than this.
fn path_of(lines: &[Line], detail_mm: f64) -> String {
    let mut path = String::new();
    let mut dots = HashSet::new();
    for line in lines {
        let Some((&first, rest)) = line.split_first() else {
            continue;
        };
        let is_dot = rest
            .iter()
            .all(|&corner| distance(first, corner) < detail_mm);
        #[expect(clippy::cast_possible_truncation, reason = "positions are small")]
        let cell = first.map(|at| (at / detail_mm).round() as i64);
        if is_dot && !dots.insert(cell) {
            continue;
        }
        add(&mut path, 'M', first);
        if is_dot {
            path.push_str("h.01");
            continue;
        }
        add_corners(&mut path, first, rest, detail_mm);
    }
    path
}

fn add_corners(path: &mut String, first: [f64; 2], rest: &[[f64; 2]], detail_mm: f64) {
    let mut last = first;
    for (index, &corner) in rest.iter().enumerate() {
        if distance(last, corner) >= detail_mm || index + 1 == rest.len() {
            add(path, 'L', corner);
            last = corner;
        }
    }
}

fn add(path: &mut String, letter: char, [right, down]: [f64; 2]) {
    write!(path, "{letter}{} {}", rounded(right), rounded(down)).expect("a text takes all");
}

/// The place at which a person behind the arm sees a position.
fn seen(x_mm: f64, y_mm: f64) -> [f64; 2] {
    [-y_mm, -x_mm]
}

fn length(line: &Line) -> f64 {
    let pairs = line.windows(2);
    pairs.map(|pair| distance(pair[0], pair[1])).sum()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Rounds to a tenth, without a negative zero.
fn rounded(mm: f64) -> f64 {
    (mm * 10.0).round() / 10.0 + 0.0
}

/// The number of details that a thumbnail shows from edge to edge.
const DETAILS: f64 = 150.0;
/// The maximum length of the path, in characters.
const LONGEST: usize = 8_192;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_small_however_many_lines_there_are() {
        let dots = (0..60_000).map(|n| vec![[f64::from(n % 245), f64::from(n / 245)]; 2]);
        let lines = (0..2_000).map(|n| vec![[0.0, f64::from(n) / 10.0], [200.0, 0.5]]);
        for lines in [dots.collect::<Vec<_>>(), lines.collect()] {
            let sketch = Sketch::of(&lines).expect("it has lines");
            assert!(sketch.path.len() <= LONGEST, "{}", sketch.path.len());
            assert!(sketch.path.len() > 100, "{}", sketch.path);
        }
    }

    #[test]
    fn a_square_is_seen_from_behind_the_arm_and_has_its_length() {
        let path = Path {
            x_mm: vec![200.0, 200.0, 210.0, 210.0, 200.0, 200.0],
            y_mm: vec![0.0, 20.0, 20.0, 0.0, 0.0, -50.0],
            ink: vec![2, 1, 1, 1, 1, 0],
            ..Path::default()
        };
        let sketch = Sketch::of_plan(&path).expect("it has lines");
        assert_eq!(sketch.view_mm, [-20.0, -210.0, 20.0, 10.0]);
        assert_eq!(sketch.path, "M0 -200L-20 -200L-20 -210L0 -210L0 -200");
        assert_eq!(sketch.drawn_mm, 60.0);
    }

    #[test]
    fn a_job_without_ink_shows_its_path_and_draws_nothing() {
        let mut path = JobPath {
            path_mm: vec![[200.0, 0.0, 5.0], [200.0, 30.0, 5.0]],
            marks: vec![false, false],
            ..JobPath::default()
        };
        let moves = Sketch::of_job(&path).expect("it moves");
        assert_eq!((&*moves.path, moves.drawn_mm), ("M0 -200L-30 -200", 0.0));
        path.marks[1] = true;
        assert_eq!(Sketch::of_job(&path).expect("it draws").drawn_mm, 30.0);
        assert_eq!(Sketch::of_job(&JobPath::default()), None);
    }
}
