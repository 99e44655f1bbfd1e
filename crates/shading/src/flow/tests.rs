use std::f64::consts::TAU;

use dobot_geometry::steps;

use super::*;
use crate::shading::ShadingStyle;

/// A page of 120 mm by 60 mm, of this darkness.
fn page(ink: impl Fn(Point) -> f64) -> Tone {
    let mut tone = Tone {
        width: 480,
        height: 240,
        cell: Point::new(0.25, 0.25),
        ink: Vec::new(),
    };
    for y in 0..tone.height {
        let row = (0..tone.width).map(|x| as_ink(ink(tone.middle(x, y))));
        let row: Vec<f32> = row.collect();
        tone.ink.extend(row);
    }
    tone
}

fn drawn(tone: &Tone) -> Vec<Stroke> {
    flowing(
        tone,
        &Shading::new(ShadingStyle::Flow),
        SPACING_MM,
        &CancelToken::default(),
    )
}

/// Black in the middle of the page, white at its edges.
fn cone(p: Point) -> f64 {
    1.0 - (p - MIDDLE).length() / 30.0
}

/// A letter L, black on white.
fn letter(p: Point) -> f64 {
    let is_stem = (15.0..24.0).contains(&p.x) && (5.0..55.0).contains(&p.y);
    let is_foot = (15.0..45.0).contains(&p.x) && (46.0..55.0).contains(&p.y);
    f64::from(u8::from(is_stem || is_foot))
}

/// A stair of six tones, from white to black, within a black frame.
fn stair(p: Point) -> f64 {
    let is_inside = (0.5..119.5).contains(&p.x) && (0.5..59.5).contains(&p.y);
    if is_inside {
        (p.x / 20.0).floor() / 5.0
    } else {
        1.0
    }
}

/// Points along a stroke, each with its distance from the start.
fn places(stroke: &Stroke) -> Vec<(f64, Point)> {
    let (mut places, mut before_mm) = (Vec::new(), 0.0);
    for (a, b) in stroke.segments() {
        places.extend(steps(a, b, 0.2).map(|p| (before_mm + a.distance(p), p)));
        before_mm += a.distance(b);
    }
    places
}

#[test]
fn a_line_around_something_is_drawn_once_and_closed() {
    let strokes = drawn(&page(cone));
    let turn = |stroke: &Stroke| {
        let turns = stroke.segments().map(|(a, b)| {
            let (a, b) = (a - MIDDLE, b - MIDDLE);
            a.cross(b).atan2(a.dot(b))
        });
        turns.sum::<f64>().abs() / TAU
    };
    for stroke in &strokes {
        assert!(turn(stroke) < 1.05, "{} times around", turn(stroke));
        assert!(!stroke.closed || stroke.last() == stroke.points.first().copied());
    }
    let closed = strokes
        .iter()
        .filter(|stroke| stroke.closed && turn(stroke) > 0.99);
    assert!(closed.count() >= 12, "of {}", strokes.len());
}

#[test]
fn a_line_keeps_off_itself_as_its_tone_asks() {
    let uneven = |p: Point| 0.55 + 0.45 * (p.x / 5.0).sin() * (p.y / 7.0 + p.x / 30.0).cos();
    for tone in [page(cone), page(letter), page(stair), page(uneven)] {
        let wanted_mm = |p: Point| SPACING_MM / tone.at(p).max(1.0 / WIDEST);
        for stroke in drawn(&tone) {
            let (places, length_mm) = (places(&stroke), stroke.length_mm());
            for (i, &(at_mm, p)) in places.iter().enumerate() {
                for &(further_mm, q) in &places[i + 1..] {
                    let mut along_mm = further_mm - at_mm;
                    if stroke.closed {
                        along_mm = along_mm.min(length_mm - along_mm);
                    }
                    let wanted_mm = wanted_mm(p).min(wanted_mm(q));
                    assert!(
                        along_mm < 2.0 * wanted_mm || p.distance(q) > 0.45 * wanted_mm,
                        "{p:?} at {at_mm} mm, {q:?} at {further_mm} mm of {length_mm} mm"
                    );
                }
            }
        }
    }
}

#[test]
fn white_stays_empty_and_ink_grows_with_darkness_up_to_the_request() {
    let mut ink_mm = [0.0; 6];
    for (a, b) in drawn(&page(stair)).iter().flat_map(Stroke::segments) {
        let middle = a.lerp(b, 0.5);
        let is_inside = (2.0..18.0).contains(&(middle.x % 20.0)) && (2.0..58.0).contains(&middle.y);
        if is_inside {
            ink_mm[cell(middle.x / 20.0, 6)] += a.distance(b);
        }
    }
    assert_eq!(ink_mm[0], 0.0);
    let full_mm = 16.0 * 56.0 / SPACING_MM;
    for (ink_mm, darkness) in ink_mm.iter().zip([0.0, 0.2, 0.4, 0.6, 0.8, 1.0]) {
        let wanted_mm = full_mm * darkness;
        assert!(
            (0.6 * wanted_mm..=1.25 * wanted_mm).contains(ink_mm),
            "{ink_mm} mm at {darkness}, not {wanted_mm} mm"
        );
    }
    assert!(
        ink_mm.windows(2).all(|pair| pair[0] < pair[1]),
        "{ink_mm:?}"
    );
}

const SPACING_MM: f64 = 1.0;
const MIDDLE: Point = Point::new(30.0, 30.0);
