#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use std::collections::BTreeSet;

use dobot_geometry::{CancelToken, Point, Stroke, bounds_of_strokes, steps};

use crate::tone::{self, Tone, count};
use crate::{GreyPicture, Orientation, Shading, ShadingStyle, stipple};

/// Grey pixels, 96 per inch.
struct Pixels {
    grey: Vec<u8>,
    width: usize,
    height: usize,
}

impl Pixels {
    fn picture(&self) -> GreyPicture<'_> {
        let [width_mm, height_mm] = [self.width, self.height].map(|side| count(side) * PIXEL_MM);
        GreyPicture {
            pixels: &self.grey,
            width: self.width,
            height: self.height,
            page: Point::new(width_mm, height_mm),
            orientation: Orientation::default(),
        }
    }
}

fn grey(width: usize, height: usize, grey: impl Fn(f64, f64) -> f64) -> Pixels {
    let middle = |i: usize| count(i) + 0.5;
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (middle(x), middle(y))));
    Pixels {
        grey: places.map(|(x, y)| byte(grey(x, y))).collect(),
        width,
        height,
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped"
)]
fn byte(value: f64) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}

fn drawn(pixels: &Pixels, shading: &Shading) -> Vec<Stroke> {
    let strokes = shading.strokes(&pixels.picture(), 1.0, &CancelToken::default());
    strokes.unwrap()
}

/// Black within `radius` of (x, y), white outside, the edge as sharp as pixels can show.
fn disc(x: f64, y: f64, radius: f64) -> impl Fn(f64, f64) -> f64 {
    move |px, py| (px - x).hypot(py - y) - radius + 0.5
}

const PIXEL_MM: f64 = 25.4 / 96.0;

#[test]
fn the_outline_of_a_disc_is_a_circle_of_its_size() {
    let file = grey(200, 180, disc(101.3, 88.6, 60.0));
    let strokes = drawn(&file, &Shading::new(ShadingStyle::Outline));
    assert_eq!(strokes.len(), 1);
    assert!(strokes[0].closed);
    for p in &strokes[0].points {
        let away = (p.x / PIXEL_MM - 101.3).hypot(p.y / PIXEL_MM - 88.6);
        assert!((away - 60.0).abs() < 0.3, "{away} pixels from the middle");
    }
}

#[test]
fn an_outline_omits_specks_and_runs_at_its_threshold() {
    let big = disc(60.0, 60.0, 30.0);
    let speck = disc(110.0, 20.0, 1.0);
    let file = grey(120, 120, |x, y| big(x, y).min(speck(x, y)));
    assert_eq!(drawn(&file, &Shading::new(ShadingStyle::Outline)).len(), 1);
    // A cone of tone: black in the middle, white at 40 pixels.
    let cone = grey(120, 120, |x, y| (x - 60.0).hypot(y - 60.0) / 40.0);
    let mut wide = Shading::new(ShadingStyle::Outline);
    wide.threshold = Some(0.2);
    let mut narrow = Shading::new(ShadingStyle::Outline);
    narrow.threshold = Some(0.8);
    let [wide, narrow] = [wide, narrow].map(|value| drawn(&cone, &value));
    assert_eq!([wide.len(), narrow.len()], [1, 1]);
    assert!(wide[0].length_mm() > 2.0 * narrow[0].length_mm());
}

#[test]
fn a_wall_that_grows_dark_has_no_outline() {
    let file = grey(400, 100, |x, _| x / 400.0);
    assert_eq!(drawn(&file, &Shading::new(ShadingStyle::Outline)), []);
}

#[test]
fn dots_are_distributed_according_to_the_tone() {
    for (left, right) in [(0.75, 0.25), (1.0, 0.1), (0.3, 0.2), (0.5, 0.5)] {
        let ink = (0..160 * 120).map(|i| tone::as_ink(if i % 160 < 80 { left } else { right }));
        let tone = Tone {
            width: 160,
            height: 120,
            cell: Point::new(0.25, 0.25),
            ink: ink.collect(),
        };
        // The loss at the edge is random: five drawings average it out.
        let drawings = (1..=5).map(|seed| {
            let shading = Shading {
                seed,
                ..Shading::new(ShadingStyle::Stipple)
            };
            stipple::stippled(&tone, &shading, 1.0, &CancelToken::default())
        });
        let dots: Vec<Stroke> = drawings.flatten().collect();
        let on_the_left = dots.iter().filter(|dot| dot.points[0].x < 20.0).count();
        let share = count(on_the_left) / count(dots.len());
        let wanted = left / (left + right);
        assert!((share / wanted - 1.0).abs() < 0.1, "{share}, not {wanted}");
        // 600 mm2 each; in the densest packing a dot takes 0.866 mm2.
        let all = 5.0 * 600.0 * (left + right) / 0.866;
        assert!(
            (count(dots.len()) / all - 1.0).abs() < 0.05,
            "{} of {all}",
            dots.len()
        );
    }
}

#[test]
fn dots_keep_apart_and_leave_white_alone() {
    let checker = |x: f64, y: f64| {
        let [column, row] = [x, y].map(|value| (value / 40.0).floor());
        (column + row) % 2.0
    };
    let file = grey(160, 160, checker);
    let dots = drawn(&file, &Shading::new(ShadingStyle::Stipple));
    assert!(dots.len() > 500);
    let spacing_mm = Shading::new(ShadingStyle::Stipple).spacing_mm;
    for (i, dot) in dots.iter().enumerate() {
        let p = dot.points[0];
        let ink_near = [-0.5, 0.5]
            .iter()
            .any(|by| checker(p.x / PIXEL_MM + by, p.y / PIXEL_MM + by) < 0.5);
        assert!(ink_near, "a dot in white at {p:?}");
        let apart = |other: &Stroke| other.points[0].distance(p);
        let nearest = dots[i + 1..]
            .iter()
            .map(apart)
            .fold(f64::INFINITY, f64::min);
        assert!(nearest > 0.5 * spacing_mm, "{nearest} mm at {p:?}");
    }
}

#[test]
fn another_seed_places_other_dots_and_the_same_seed_the_same_ones() {
    let file = grey(90, 60, |x, _| x / 90.0);
    let with = |seed| {
        let shading = Shading {
            seed,
            ..Shading::new(ShadingStyle::Stipple)
        };
        drawn(&file, &shading)
    };
    assert_eq!(with(5), with(5));
    assert_ne!(with(5), with(6));
}

/// Five bands from white to black, 60 pixels each.
fn bands() -> Pixels {
    grey(300, 200, |x, _| 1.0 - (x / 60.0).floor() / 4.0)
}

/// The band of a place, unless it is near a border.
fn band(p: Point) -> Option<usize> {
    let place = p.x / PIXEL_MM / 60.0;
    (0..5).find(|&band| (place - count(band) - 0.5).abs() < 0.25)
}

#[test]
fn each_darker_tone_is_hatched_in_one_more_direction() {
    let mut directions = [const { BTreeSet::new() }; 5];
    for stroke in drawn(&bands(), &Shading::new(ShadingStyle::Hatch)) {
        let long = stroke.segments().filter(|(a, b)| a.distance(*b) > 3.0);
        for (a, b) in long {
            let along = b - a;
            let turn = along
                .y
                .atan2(along.x)
                .to_degrees()
                .rem_euclid(180.0)
                .round();
            for p in steps(a, b, 0.5) {
                if let Some(band) = band(p) {
                    directions[band].insert((turn % 180.0).abs().to_string());
                }
            }
        }
    }
    assert_eq!(directions.map(|direction| direction.len()), [0, 1, 2, 3, 4]);
}

#[test]
fn darker_lines_leave_more_ink() {
    for style in [
        ShadingStyle::Lines,
        ShadingStyle::Spiral,
        ShadingStyle::Flow,
    ] {
        let mut ink_mm = [0.0; 5];
        for stroke in drawn(&bands(), &Shading::new(style)) {
            for (a, b) in stroke.segments() {
                if let Some(band) = band(a.lerp(b, 0.5)) {
                    ink_mm[band] += a.distance(b);
                }
            }
        }
        assert_eq!(ink_mm[0], 0.0, "{style:?}");
        assert!(
            ink_mm.windows(2).all(|pair| pair[1] > 1.05 * pair[0]),
            "{style:?} {ink_mm:?}"
        );
    }
}

#[test]
fn a_spiral_over_black_is_one_line_from_the_middle_to_the_edge() {
    let file = grey(200, 200, |x, y| if x < 2.0 && y < 2.0 { 1.0 } else { 0.0 });
    let strokes = drawn(&file, &Shading::new(ShadingStyle::Spiral));
    let page_mm = 200.0 * PIXEL_MM;
    let longest = strokes
        .iter()
        .max_by(|a, b| a.length_mm().total_cmp(&b.length_mm()));
    let inked = bounds_of_strokes(&[longest.unwrap().clone()]);
    assert!(
        inked.width() > 0.9 * page_mm && inked.height() > 0.9 * page_mm,
        "{inked:?}"
    );
    let middle = Point::new(page_mm / 2.0, page_mm / 2.0);
    assert!(longest.unwrap().points[0].distance(middle) < 1.6);
}

#[test]
fn flow_lines_run_along_an_edge_and_not_across_it() {
    // Darker to the right, with the change in the middle.
    let file = grey(240, 240, |x, _| {
        0.9 - 0.8 / (1.0 + ((120.0 - x) / 20.0).exp())
    });
    let (mut along_mm, mut across_mm) = (0.0, 0.0);
    for stroke in drawn(&file, &Shading::new(ShadingStyle::Flow)) {
        for (a, b) in stroke.segments() {
            if (a.x / PIXEL_MM - 120.0).abs() < 30.0 {
                along_mm += (a.y - b.y).abs();
                across_mm += (a.x - b.x).abs();
            }
        }
    }
    assert!(along_mm > 20.0 * across_mm, "{along_mm} {across_mm}");
}

#[test]
fn a_lighter_picture_has_less_ink_and_more_contrast_separates_tones() {
    let file = grey(200, 100, |x, _| 0.1 + 0.8 * x / 200.0);
    let ink_mm = |set: &dyn Fn(&mut Shading)| {
        let mut shading = Shading::new(ShadingStyle::Lines);
        set(&mut shading);
        let strokes = drawn(&file, &shading);
        let half = 100.0 * PIXEL_MM;
        let pieces = strokes.iter().flat_map(Stroke::segments);
        pieces.fold([0.0; 2], |mut sum, (a, b)| {
            sum[usize::from(a.x > half)] += a.distance(b);
            sum
        })
    };
    let plain = ink_mm(&|_| ());
    let lighter = ink_mm(&|shading| shading.brightness = 0.2);
    let gamma = ink_mm(&|shading| shading.darkness = 0.5);
    assert!(lighter[0] + lighter[1] < 0.9 * (plain[0] + plain[1]));
    assert!(gamma[0] + gamma[1] < 0.9 * (plain[0] + plain[1]));
    let steep = ink_mm(&|shading| shading.contrast = 0.6);
    assert!(
        steep[0] > plain[0] && steep[1] < plain[1],
        "{plain:?} {steep:?}"
    );
    let two_tones = ink_mm(&|shading| shading.threshold = Some(0.5));
    assert!(
        two_tones[0] > plain[0] && two_tones[1] < 0.2 * plain[1],
        "{plain:?} {two_tones:?}"
    );
}

#[test]
fn the_spacing_is_kept_on_the_paper() {
    let file = grey(100, 100, |_, _| 0.0);
    let dots = |scale| {
        let shading = Shading::new(ShadingStyle::Stipple);
        let strokes = shading.strokes(&file.picture(), scale, &CancelToken::default());
        count(strokes.unwrap().len())
    };
    let times = dots(3.0) / dots(1.0);
    assert!((times / 9.0 - 1.0).abs() < 0.05, "{times}");
}

#[test]
fn a_dull_photo_is_drawn_like_a_rich_one() {
    let rich = grey(160, 90, |x, y| (x + y) / 250.0);
    let dull = grey(160, 90, |x, y| 0.4 + 0.3 * (x + y) / 250.0);
    let length_mm = |file: &Pixels| -> f64 {
        let strokes = drawn(file, &Shading::new(ShadingStyle::Hatch));
        strokes.iter().map(Stroke::length_mm).sum()
    };
    let times = length_mm(&dull) / length_mm(&rich);
    assert!((times - 1.0).abs() < 0.1, "{times}");
}
