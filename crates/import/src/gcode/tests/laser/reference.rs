//! Random programs and their burn by the published rules of GRBL's laser mode ($32=1).

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Write as _;

use dobot_geometry::{Point, Vec2};
use proptest::prelude::*;

/// The lines that a laser burns.
///
/// - G0, drilling cycles and moves along Z alone never burn.
/// - G1, G2 and G3 burn while M3, M4 or M106 hold and S is above 0. Before the first of them the
///   laser is off. M5 and M107 switch it off. In a file with M3 or M4, M106 and its S are for a fan.
/// - Nothing burns while an output is off (M63, M65). In a file without M3, M4 and M106, the laser is
///   on while all outputs are on (M62, M64), and M5 and M107 switch them off.
/// - S holds from its line on, and is 0 before; without any S in the file M3, M4 and M106 have full
///   power.
/// - In a file without any of these words G1, G2 and G3 burn.
/// - A dwell may burn a dot while the laser is on, if it is neither before the first line that
///   burns nor above all of them, and nothing is drilled.
#[derive(Debug, Default)]
pub(super) struct Reference {
    lit: Vec<(Point, Point)>,
    dwells: Vec<Point>,
}

impl Reference {
    pub(super) fn read(text: &str) -> Self {
        let text = uncommented(text);
        let lines: Vec<_> = text.lines().map(words).collect();
        let has_m = |codes: &[f64]| {
            let is_one = |word: &(char, f64)| word.0 == 'M' && codes.contains(&word.1);
            lines.iter().flatten().any(is_one)
        };
        let has_outputs = has_m(&[62.0, 63.0, 64.0, 65.0]);
        let has_fan = has_m(&[3.0, 4.0]);
        let mut lines_of_laser = lines.iter().filter(|line| !(has_fan && is_of_fan(line)));
        let has_s = lines_of_laser.any(|line| line.iter().any(|word| word.0 == 'S'));
        let mut reader = Reader {
            has_fan,
            is_by_outputs: has_outputs && !has_fan && !has_m(&[106.0]),
            full: !has_s,
            is_without_power: !has_s && !has_outputs && !has_m(&[3.0, 4.0, 5.0, 106.0, 107.0]),
            ..Reader::default()
        };
        for line in &lines {
            reader.line(line);
        }
        reader.finish()
    }

    /// Whether a line burns there.
    pub(super) fn burns_at(&self, p: Point) -> bool {
        self.lit.iter().any(|&(a, b)| distance(p, a, b) < 0.03)
    }

    pub(super) fn waits_at(&self, p: Point) -> bool {
        self.dwells.iter().any(|dwell| dwell.distance(p) < 1e-6)
    }

    pub(super) fn length_mm(&self) -> f64 {
        self.lit.iter().map(|(a, b)| a.distance(*b)).sum()
    }
}

#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a mode of its own")]
struct Reader {
    /// M106 is for a fan.
    has_fan: bool,
    /// Only outputs switch the laser on.
    is_by_outputs: bool,
    outputs: BTreeMap<u64, bool>,
    /// The power is full without S.
    full: bool,
    is_without_power: bool,
    at: Point,
    z: Option<f64>,
    motion: f64,
    is_relative: bool,
    is_on: bool,
    s: f64,
    lit: Vec<(Point, Point)>,
    /// Heights of the lines that burn, and of all moves along X or Y.
    lit_heights: Vec<f64>,
    heights: Vec<f64>,
    /// Dwells while the laser is on, with their heights.
    dwells: Vec<(Point, Option<f64>)>,
    /// Depths of moves down along Z by G1 while it is on.
    plunges: Vec<f64>,
    drills: bool,
}

impl Reader {
    fn line(&mut self, words: &[(char, f64)]) {
        let value = |letter| words.iter().find(|word| word.0 == letter).map(|at| at.1);
        let has_g = |code| words.contains(&('G', code));
        let is_of_fan = self.has_fan && is_of_fan(words);
        for &(letter, code) in words {
            match (letter, code) {
                ('M', 106.0) if self.has_fan => {}
                ('S', _) if is_of_fan => {}
                ('M', 3.0 | 4.0 | 106.0) => self.is_on = true,
                ('M', 5.0 | 107.0) => {
                    self.is_on = false;
                    if self.is_by_outputs {
                        self.outputs.values_mut().for_each(|is_on| *is_on = false);
                    }
                }
                ('M', 62.0..=65.0) => {
                    let output = value('P').map_or(0, f64::to_bits);
                    self.outputs.insert(output, [62.0, 64.0].contains(&code));
                }
                ('S', s) => self.s = s,
                ('G', 90.0 | 91.0) => self.is_relative = code == 91.0,
                ('G', 0.0..=3.0 | 80.0 | 81.0) => self.motion = code,
                _ => {}
            }
        }
        self.drills |= self.motion == 81.0;
        let are_on = self.outputs.values().all(|is_on| *is_on);
        let is_on = if self.is_by_outputs {
            are_on && !self.outputs.is_empty()
        } else {
            are_on && self.is_on
        };
        let is_lit = self.is_without_power || is_on && (self.full || self.s > 0.0);
        if has_g(4.0) {
            if is_lit {
                self.dwells.push((self.at, self.z));
            }
            return;
        }
        if !"XYZIJ".chars().any(|c| value(c).is_some()) {
            return;
        }
        let target = |letter, here: f64| {
            let word = value(letter)?;
            Some(if self.is_relative { here + word } else { word })
        };
        let from = self.at;
        let x = target('X', from.x).unwrap_or(from.x);
        let y = target('Y', from.y).unwrap_or(from.y);
        let z = target('Z', self.z.unwrap_or(0.0)).or(self.z);
        let center = from + Vec2::new(value('I').unwrap_or(0.0), value('J').unwrap_or(0.0));
        self.at = Point::new(x, y);
        let path = match self.motion {
            2.0 | 3.0 => arc(from, self.at, center, self.motion == 2.0),
            _ => vec![from, self.at],
        };
        let is_still = self.motion < 2.0 && from == self.at;
        if is_still && self.motion == 1.0 && is_lit && z < self.z {
            self.plunges.extend(z);
        }
        self.z = z;
        if is_still {
            return;
        }
        self.heights.extend(z);
        if is_lit && (1.0..=3.0).contains(&self.motion) {
            if self.lit.is_empty() {
                self.dwells.clear();
            }
            self.lit_heights.extend(z);
            self.lit
                .extend(path.windows(2).map(|pair| (pair[0], pair[1])));
        }
    }

    fn finish(mut self) -> Reference {
        let lowest = |of: &[f64]| of.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = self
            .lit_heights
            .iter()
            .copied()
            .fold(f64::NEG_INFINITY, f64::max);
        self.drills |= lowest(&self.plunges) < lowest(&self.heights);
        let is_above = |z: Option<f64>| !self.lit.is_empty() && z.is_some_and(|z| z > highest);
        let dots = self
            .dwells
            .iter()
            .filter(|dwell| !self.drills && !is_above(dwell.1));
        Reference {
            dwells: dots.map(|dot| dot.0).collect(),
            lit: self.lit,
        }
    }
}

/// Whether the S of a line is for a fan.
fn is_of_fan(words: &[(char, f64)]) -> bool {
    let has = |codes: [f64; 2]| {
        words
            .iter()
            .any(|&(letter, code)| letter == 'M' && codes.contains(&code))
    };
    has([106.0, 107.0]) && !has([3.0, 4.0])
}

fn uncommented(text: &str) -> String {
    let mut plain = String::new();
    let mut end = None;
    for c in text.to_ascii_uppercase().chars() {
        match (end, c) {
            (Some(last), _) if c == last => end = None,
            (None, '(') => end = Some(')'),
            (None, ';') => end = Some('\n'),
            _ => {}
        }
        if end.is_none() && c != ')' {
            plain.push(c);
        }
    }
    plain
}

fn words(line: &str) -> Vec<(char, f64)> {
    let starts: Vec<_> = line
        .match_indices(|c: char| c.is_ascii_alphabetic())
        .map(|found| found.0)
        .chain([line.len()])
        .collect();
    let word = |n: &[usize]| {
        let value = line[n[0] + 1..n[1]].trim().parse().unwrap();
        (char::from(line.as_bytes()[n[0]]), value)
    };
    starts.windows(2).map(word).collect()
}

/// An arc in chords.
fn arc(from: Point, to: Point, center: Point, clockwise: bool) -> Vec<Point> {
    let [begin, end] = [from, to].map(|value| (value - center).atan2());
    let sign = if clockwise { -1.0 } else { 1.0 };
    let turn = (sign * (end - begin)).rem_euclid(TAU);
    let turn = if from == to { TAU } else { turn };
    let radius = (from - center).hypot();
    let place = |i: u32| {
        let angle = begin + sign * turn * f64::from(i) / 64.0;
        center + radius * Vec2::from_angle(angle)
    };
    (0..=64).map(place).collect()
}

fn distance(p: Point, a: Point, b: Point) -> f64 {
    let (way, length) = (b - a, (b - a).hypot2());
    let t = if length > 0.0 {
        ((p - a).dot(way) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    p.distance(a.lerp(b, t))
}

/// The words of random programs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words {
    /// Z, and drilling cycles.
    has_z: bool,
    /// S with M3, in its own line: it may be the angle of a pen's servo.
    has_servo: bool,
    /// M5 at least.
    has_switch: bool,
}

impl Words {
    pub(super) const ANY: Self = Self {
        has_z: true,
        has_servo: true,
        has_switch: false,
    };
    /// Those that a laser program writes.
    pub(super) const OF_LASER: Self = Self {
        has_z: false,
        has_servo: false,
        has_switch: true,
    };
}

/// A line of a program. Lengths are in thousandths of a millimetre.
#[derive(Clone, Debug)]
enum Line {
    Move {
        g: u32,
        is_modal: bool,
        x: Option<i32>,
        y: Option<i32>,
        z: Option<i32>,
        s: Option<u32>,
        m: Option<u32>,
    },
    Height {
        g: u32,
        z: i32,
    },
    /// A whole circle or the half of one.
    Arc {
        g: u32,
        center: (i32, i32),
        is_whole: bool,
        s: Option<u32>,
    },
    Switch {
        m: u32,
        s: Option<u32>,
    },
    Output {
        m: u32,
        p: u32,
    },
    Power(u32),
    Dwell(Option<u32>),
    Holes(Vec<(i32, i32)>),
    Relative(bool),
    Comment(&'static str),
}

fn line() -> impl Strategy<Value = Line> {
    let place = || -50_000..50_000_i32;
    let height = || prop::sample::select(vec![-2000, -1000, 0, 1000, 5000]);
    let power = || prop::sample::select(vec![0, 0, 90, 255, 1000]);
    let maybe_power = || prop::option::weighted(0.3, power());
    let m = || prop::sample::select(vec![3, 3, 4, 5, 5, 106, 107]);
    let moved = (
        prop::sample::select(vec![0, 1, 1]),
        any::<bool>(),
        prop::option::weighted(0.8, place()),
        prop::option::weighted(0.6, place()),
        prop::option::weighted(0.1, height()),
        maybe_power(),
        prop::option::weighted(0.1, m()),
    )
        .prop_map(|(g, is_modal, x, y, z, s, m)| Line::Move {
            g,
            is_modal,
            x,
            y,
            z,
            s,
            m,
        });
    let center = (1000..5000_i32, -5000..5000_i32);
    let arc =
        (2..4_u32, center, any::<bool>(), maybe_power()).prop_map(|(g, center, is_whole, s)| {
            Line::Arc {
                g,
                center,
                is_whole,
                s,
            }
        });
    prop_oneof![
        10 => moved,
        2 => (0..2_u32, height()).prop_map(|(g, z)| Line::Height { g, z }),
        2 => arc,
        5 => (m(), maybe_power()).prop_map(|(m, s)| Line::Switch { m, s }),
        2 => (62..66_u32, 0..2_u32).prop_map(|(m, p)| Line::Output { m, p }),
        2 => power().prop_map(Line::Power),
        2 => prop::option::weighted(0.2, power()).prop_map(Line::Dwell),
        1 => prop::collection::vec((place(), place()), 1..4).prop_map(Line::Holes),
        1 => any::<bool>().prop_map(Line::Relative),
        1 => prop::sample::select(vec!["(M3 S1000)", "; laser on: M3 S9", "(pen up)"])
            .prop_map(Line::Comment),
    ]
}

/// A random program of these words. Some have no S, no Z, or no M.
pub(super) fn program(words: Words) -> impl Strategy<Value = String> {
    let lines = prop::collection::vec(line(), 1..25);
    (lines, any::<[bool; 3]>(), 0..4_u32, any::<[bool; 2]>()).prop_map(
        move |(lines, [has_s, has_z, has_outputs], kind, [is_small, is_numbered])| {
            let mut writer = Writer {
                has_s: has_s || kind == 3,
                has_z: has_z && words.has_z,
                has_m: kind > 0 || words.has_switch,
                has_servo: words.has_servo,
                has_outputs,
                ..Writer::default()
            };
            writer.text = "G21 G90\n".to_owned();
            if words.has_switch {
                writer.text.push_str("M5\n");
            }
            for line in &lines {
                writer.line(line);
            }
            finish(&writer.text, is_small, is_numbered)
        },
    )
}

/// In small letters, or with numbered lines.
fn finish(text: &str, is_small: bool, is_numbered: bool) -> String {
    let mut finished = String::new();
    for (i, line) in text.lines().enumerate() {
        if is_numbered {
            let _ = write!(finished, "N{} ", 10 * i);
        }
        let _ = writeln!(finished, "{line}");
    }
    if is_small {
        finished.make_ascii_lowercase();
    }
    finished
}

#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is chosen by itself")]
struct Writer {
    has_s: bool,
    has_z: bool,
    has_m: bool,
    has_servo: bool,
    has_outputs: bool,
    text: String,
    at: (i32, i32),
    z: i32,
    is_relative: bool,
    /// The motion code in force, unless it has to be written again.
    g: Option<u32>,
}

impl Writer {
    fn line(&mut self, line: &Line) {
        match *line {
            Line::Move {
                g,
                is_modal,
                x,
                y,
                z,
                s,
                m,
            } => {
                if self.g != Some(g) || !is_modal {
                    self.code('G', g);
                }
                self.g = Some(g);
                self.m(m);
                self.places(x, y);
                self.height(z);
                self.power(s);
            }
            Line::Height { g, z } if self.has_z => {
                self.code('G', g);
                self.g = Some(g);
                self.height(Some(z));
            }
            Line::Arc {
                g,
                center: (i, j),
                is_whole,
                s,
            } => {
                self.code('G', g);
                if !is_whole {
                    let (x, y) = self.at;
                    self.places(Some(x + 2 * i), Some(y + 2 * j));
                }
                self.length('I', i);
                self.length('J', j);
                self.power(s);
                self.g = None;
            }
            Line::Switch { m, s } => {
                self.m(Some(m));
                self.power(s.filter(|_| self.has_servo));
            }
            Line::Output { m, p } if self.has_outputs => {
                let _ = write!(self.text, "M{m} P{p}");
            }
            Line::Power(s) => self.power(Some(s)),
            Line::Dwell(s) => {
                self.text.push_str("G4 P0.5");
                self.power(s);
            }
            Line::Holes(ref places) if self.has_z => self.holes(places),
            Line::Relative(is_relative) => {
                self.is_relative = is_relative;
                self.code('G', 90 + u32::from(is_relative));
            }
            Line::Comment(text) => self.text.push_str(text),
            Line::Height { .. } | Line::Holes(_) | Line::Output { .. } => {}
        }
        self.text.push('\n');
    }

    fn holes(&mut self, places: &[(i32, i32)]) {
        self.text.push_str("G90\nG81 Z-1 R1");
        self.is_relative = false;
        for &(x, y) in places {
            self.places(Some(x), Some(y));
            self.text.push('\n');
        }
        self.text.push_str("G80");
        self.g = None;
    }

    fn code(&mut self, letter: char, code: u32) {
        let _ = write!(self.text, "{letter}{code} ");
    }

    fn m(&mut self, code: Option<u32>) {
        if let Some(code) = code.filter(|_| self.has_m) {
            self.code('M', code);
        }
    }

    fn power(&mut self, s: Option<u32>) {
        if let Some(s) = s.filter(|_| self.has_s) {
            let _ = write!(self.text, " S{s}");
        }
    }

    fn places(&mut self, x: Option<i32>, y: Option<i32>) {
        let from = if self.is_relative { self.at } else { (0, 0) };
        if let Some(x) = x {
            self.length('X', x - from.0);
            self.at.0 = x;
        }
        if let Some(y) = y {
            self.length('Y', y - from.1);
            self.at.1 = y;
        }
    }

    fn height(&mut self, z: Option<i32>) {
        if let Some(z) = z.filter(|_| self.has_z) {
            let from = if self.is_relative { self.z } else { 0 };
            self.length('Z', z - from);
            self.z = z;
        }
    }

    fn length(&mut self, letter: char, thousandths: i32) {
        let _ = write!(self.text, "{letter}{:.3}", f64::from(thousandths) / 1000.0);
    }
}
