use proptest::prelude::*;

use super::*;

const SEARCH: Search = Search {
    travel: Travel::Length,
    kicks: 100,
    seed: 1,
};

/// Returns the travel cost between the strokes.
fn cost_of(travel: Travel, strokes: &[Stroke]) -> f64 {
    cost(strokes, &given(strokes), Point::default(), travel)
}

/// Returns the length of the travel between the strokes, in mm.
fn travel_mm(strokes: &[Stroke]) -> f64 {
    cost_of(Travel::Length, strokes)
}

fn line(points: &[(f64, f64)]) -> Stroke {
    Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
}

#[test]
fn continues_with_the_nearest_stroke_and_turns_it_if_that_is_nearer() {
    let strokes = vec![
        line(&[(50.0, 0.0), (60.0, 0.0)]),
        line(&[(20.0, 0.0), (11.0, 0.0)]),
        line(&[(0.0, 0.0), (10.0, 0.0)]),
    ];
    let ordered = order(strokes, Point::default(), &SEARCH);
    let starts: Vec<f64> = ordered.iter().map(|s| s.points[0].x).collect();
    assert_eq!(starts, [0.0, 11.0, 50.0]);
}

#[test]
fn a_closed_stroke_starts_at_its_nearest_corner() {
    let mut square = line(&[(9.0, 9.0), (5.0, 9.0), (5.0, 5.0), (9.0, 5.0), (9.0, 9.0)]);
    square.closed = true;
    let ordered = order(vec![square], Point::default(), &SEARCH);
    assert_eq!(
        ordered[0].points,
        line(&[(5.0, 5.0), (9.0, 5.0), (9.0, 9.0), (5.0, 9.0), (5.0, 5.0)]).points
    );
}

#[test]
fn a_line_that_ends_at_its_start_may_also_start_anywhere() {
    let ring = line(&[(9.0, 0.0), (5.0, 0.0), (5.0, 5.0), (9.0, 0.0)]);
    let ordered = order(vec![ring], Point::default(), &SEARCH);
    assert_eq!(ordered[0].points[0], Point::new(5.0, 0.0));
    assert_eq!(ordered[0].points.len(), 4);
}

fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
    let point = (0.0..100.0_f64, 0.0..100.0_f64).prop_map(|(x, y)| Point::new(x, y));
    let stroke =
        (proptest::collection::vec(point, 0..6), any::<bool>()).prop_map(|(mut points, closed)| {
            if closed {
                points.extend(points.first().copied());
            }
            Stroke { points, closed }
        });
    proptest::collection::vec(stroke, 0..40)
}

/// Returns the segments of a stroke, regardless of direction.
fn ink(stroke: &Stroke) -> Vec<String> {
    let mut ink: Vec<String> = stroke
        .segments()
        .map(|(a, b)| {
            if (a.x, a.y) < (b.x, b.y) {
                (a, b)
            } else {
                (b, a)
            }
        })
        .chain(stroke.points.iter().map(|&p| (p, p)))
        .map(|pair| format!("{pair:?}"))
        .collect();
    ink.sort();
    ink.dedup();
    ink
}

proptest! {
    #[test]
    fn draws_every_stroke_once_and_travels_no_further(strokes in strokes()) {
        let ordered = order(strokes.clone(), Point::default(), &SEARCH);
        prop_assert!(travel_mm(&ordered) <= travel_mm(&strokes));
        prop_assert_eq!(&ordered, &order(strokes.clone(), Point::default(), &SEARCH));
        let mut before: Vec<_> = strokes.iter().map(ink).collect();
        let mut after: Vec<_> = ordered.iter().map(ink).collect();
        before.sort();
        after.sort();
        prop_assert_eq!(before, after);
    }
}

#[test]
fn small_drawings_get_the_optimal_order() {
    let mut random = Random::new(5);
    let mut point = || Point::new(f64::from(random.below(1000)), f64::from(random.below(1000)));
    for _ in 0..60 {
        let strokes: Vec<Stroke> = (0..5)
            .map(|_| Stroke::open(vec![point(), point()]))
            .collect();
        let found = travel_mm(&order(strokes.clone(), Point::default(), &SEARCH));
        let best = least(&mut strokes.clone(), Point::default());
        assert!(found < best + 1e-6, "{found} mm found, {best} mm possible");
    }
}

/// Returns the minimum travel over all orders.
fn least(left: &mut Vec<Stroke>, here: Point) -> f64 {
    let mut best = if left.is_empty() { 0.0 } else { f64::INFINITY };
    for i in 0..left.len() {
        let stroke = left.swap_remove(i);
        for (begin, end) in [(0, 1), (1, 0)] {
            let way = here.distance(stroke.points[begin]);
            best = best.min(way + least(left, stroke.points[end]));
        }
        left.push(stroke);
        let last = left.len() - 1;
        left.swap(i, last);
    }
    best
}

#[test]
fn a_field_of_dots_is_traversed_almost_without_a_detour() {
    // The best path through a square of 30 x 30 from a corner is 899 steps.
    let mut random = Random::new(9);
    let mut dots: Vec<Stroke> = (0..900_u32)
        .map(|i| line(&[(f64::from(i % 30), f64::from(i / 30))]))
        .collect();
    for i in (1..900).rev() {
        dots.swap(i as usize, random.below(i + 1) as usize);
    }
    let search = Search {
        kicks: 4000,
        ..SEARCH
    };
    let travel = travel_mm(&order(dots, Point::default(), &search));
    assert!((899.0..899.0 * 1.02).contains(&travel), "{travel} mm");
}

#[test]
fn a_cancelled_search_stops_at_once() {
    let mut random = Random::new(4);
    let mut dot = || line(&[(random.share() * 100.0, random.share() * 100.0)]);
    let dots: Vec<Stroke> = (0..500).map(|_| dot()).collect();
    let cancel = CancelToken::default();
    let ordered = |seed, cancel: &CancelToken| {
        let search = Search { seed, ..SEARCH };
        order_until(dots.clone(), Point::default(), &search, cancel)
    };
    assert_ne!(ordered(1, &cancel), ordered(2, &cancel));
    // The first tour takes two checks for each dot, and without it the order is the given one.
    for checks in [0, 10, 900] {
        assert_eq!(ordered(1, &CancelToken::after_checks(checks)), dots);
    }
}

#[test]
fn thousands_of_dots_at_the_same_two_places_need_one_travel_between_them() {
    let dots = (0..4000).map(|i| line(&[(f64::from(i % 2) * 7.0, 0.0)]));
    let ordered = order(dots.collect(), Point::default(), &SEARCH);
    assert_eq!(travel_mm(&ordered), 7.0);
}

#[test]
fn a_shuffled_line_of_segments_is_put_together_again() {
    let at = |i: u32| (f64::from(i), (f64::from(i) * 0.1).sin());
    let mut random = Random::new(2);
    let mut pieces: Vec<Stroke> = (0..500).map(|i| line(&[at(i), at(i + 1)])).collect();
    for i in (1..500).rev() {
        pieces.swap(i as usize, random.below(i + 1) as usize);
    }
    assert_eq!(travel_mm(&order(pieces, Point::default(), &SEARCH)), 0.0);
}

#[test]
fn in_arm_time_a_travel_costs_its_trapezoid_but_never_less_than_a_packet() {
    let travel = Travel::Time {
        speed_mm_s: 50.0,
        acceleration_mm_s2: 100.0,
        least_s: 0.08,
    };
    // 25 mm are just enough to reach 50 mm/s: half a second of acceleration, half a second of
    // braking.
    let expected = [
        (0.0, 0.0),
        (0.01, 0.08),
        (1.0, 0.2),
        (25.0, 1.0),
        (75.0, 2.0),
    ];
    for (length_mm, time_s) in expected {
        let found = travel.cost(length_mm);
        assert!(
            (found - time_s).abs() < 1e-9,
            "{length_mm} mm: {found} s, expected {time_s} s"
        );
    }
}

#[test]
fn by_arm_time_no_order_is_slower_than_the_given_one() {
    let travel = Travel::Time {
        speed_mm_s: 80.0,
        acceleration_mm_s2: 100.0,
        least_s: 0.08,
    };
    let dots: Vec<Stroke> = (0..40)
        .map(|i| line(&[(f64::from(i * 17 % 40), f64::from(i * 11 % 7))]))
        .collect();
    let ordered = order(
        dots.clone(),
        Point::default(),
        &Search {
            travel,
            kicks: 20_000,
            ..SEARCH
        },
    );
    let (found, given) = (cost_of(travel, &ordered), cost_of(travel, &dots));
    assert!(found < given, "{found} s, given {given} s");
}
