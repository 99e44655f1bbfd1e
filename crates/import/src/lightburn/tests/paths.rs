use super::*;

fn path(lists: &str) -> String {
    shape("Type=\"Path\" CutIndex=\"0\"", HERE, lists)
}

#[test]
fn both_formats_describe_the_same_path() {
    // A quarter of a circle, and a line back to where it begins.
    let k = 5.522_847_498;
    let new = format!(
        "<VertList>V10 0c0x10c0y{k}c1x1V0 10c0x1c1x{k}c1y10</VertList><PrimList>B0 1L1 0</PrimList>"
    );
    let old = format!(
        "<V vx=\"10\" vy=\"0\" c0x=\"10\" c0y=\"{k}\" c1x=\"1\"/><V vx=\"0\" vy=\"10\" c0x=\"1\" c1x=\"{k}\" c1y=\"10\"/><P T=\"B\" p0=\"0\" p1=\"1\"/><P T=\"L\" p0=\"1\" p1=\"0\"/>"
    );
    let [new, old] = [new, old].map(|value| draw(&path(&value)));
    assert_eq!(new, old);
    assert!(strokes(&new)[0].closed);
    same(length_mm(&new), PI * 5.0 + 200.0_f64.sqrt(), 0.05);
}

#[test]
fn a_curve_without_control_points_is_straight() {
    // A single c0x1 means no control point.
    let artwork = draw(&path(
        "<VertList>V0 0c0x1c1x1V9 0c0x1c1x1</VertList><PrimList>B0 1</PrimList>",
    ));
    same(length_mm(&artwork), 9.0, 1e-9);
    same(artwork.height_mm, 0.0, 1e-9);
}

#[test]
fn the_keywords_join_all_points_in_order() {
    let with = |joints: &str| {
        let lists = format!("<VertList>V0 0V6 0V6 4</VertList><PrimList>{joints}</PrimList>");
        draw(&path(&lists))
    };
    assert_eq!(strokes(&with("LineClosed"))[0].points.len(), 4);
    assert!(strokes(&with("LineClosed"))[0].closed);
    assert_eq!(
        corners(&with("LineOpen")),
        [[(0.0, 4.0), (6.0, 4.0), (6.0, 0.0)]]
    );
}

#[test]
fn pieces_that_do_not_meet_are_separate_strokes() {
    let lists = "<VertList>V0 0V1 0V1 1V5 5V6 5</VertList><PrimList>L0 1L1 2L2 0L3 4</PrimList>";
    let artwork = draw(&path(lists));
    let counts: Vec<usize> = strokes(&artwork)
        .iter()
        .map(|stroke| stroke.points.len())
        .collect();
    assert_eq!(counts, [4, 2]);
}

#[test]
fn a_list_of_another_path_is_found_by_its_number_at_any_place() {
    let of = |frame: &str, lists: &str| {
        shape(
            "Type=\"Path\" CutIndex=\"0\" VertID=\"7\" PrimID=\"3\"",
            frame,
            lists,
        )
    };
    let first = of("1 0 0 1 0 5", "");
    let second = of(
        HERE,
        "<VertList>V0 0V4 0</VertList><PrimList>L0 1</PrimList>",
    );
    let lines = corners(&draw(&(first + &second)));
    assert_eq!(lines, [[(0.0, 0.0), (4.0, 0.0)], [(0.0, 5.0), (4.0, 5.0)]]);
}

#[test]
fn numbers_may_have_exponents_and_points_may_be_marked_as_smooth() {
    let lists = "<VertList>V-1e-3 0Sc0x1c1x1V9.999e0 0S1</VertList><PrimList>L0 1</PrimList>";
    same(length_mm(&draw(&path(lists))), 10.0, 1e-9);
}

#[test]
fn a_path_without_lines_is_reported() {
    let lists = "<VertList>V0 0V4 0</VertList>";
    let line = path("<VertList>V0 0V4 0</VertList><PrimList>L0 1</PrimList>");
    let (artwork, warnings) = read_text(&project(&(path(lists) + &line)));
    assert_eq!(strokes(&artwork).len(), 1);
    assert!(
        warnings[0].ends_with("1 empty path: left out"),
        "{warnings:?}"
    );
}

proptest! {
    #[test]
    fn a_polyline_is_restored_point_by_point(
        points in proptest::collection::vec((-999.0..999.0_f64, -999.0..999.0_f64), 2..40),
    ) {
        let list: Vec<String> = points.iter().map(|(x, y)| format!("V{x} {y}c0x1c1x1")).collect();
        let list = list.concat();
        let artwork = draw(&path(&format!("<VertList>{list}</VertList><PrimList>LineOpen</PrimList>")));
        let left = points.iter().map(|point| point.0).fold(f64::INFINITY, f64::min);
        let top = points.iter().map(|point| point.1).fold(f64::NEG_INFINITY, f64::max);
        let found = &strokes(&artwork)[0].points;
        prop_assert_eq!(found.len(), points.len());
        for (p, (x, y)) in found.iter().zip(&points) {
            prop_assert!((p.x - (x - left)).abs() < 1e-9 && (p.y - (top - y)).abs() < 1e-9);
        }
    }
}
