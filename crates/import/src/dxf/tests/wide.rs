use super::*;

/// The lengths of the edges and the size of the area in mm2.
fn edges_and_area(entities: &str) -> ([f64; 2], usize) {
    let (artwork, warnings) = draw(entities);
    assert_eq!(warnings, [""; 0], "{entities}");
    let [layer] = &artwork.layers[..] else {
        panic!("{entities}");
    };
    let length = layer.strokes.iter().map(Stroke::length_mm).sum();
    let rings = layer.areas.iter().flat_map(|area| &area.rings);
    let area: f64 = rings.map(|ring| signed_area(ring)).sum();
    ([length, area.abs()], layer.strokes.len())
}

fn signed_area(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter()
        .zip(next)
        .map(|(a, b)| a.to_vec2().cross(b.to_vec2()) / 2.0)
        .sum()
}

#[test]
fn polylines_with_a_width_are_areas_with_two_edges() {
    let wedge = 6.0 + 2.0 * 109_f64.sqrt();
    for (entities, lines, length, area) in [
        // A bar, by one width for all and by that of its corner.
        (
            "0 LWPOLYLINE 90 2 70 0 43 4 10 20 20 0 10 40 20 0",
            1,
            48.0,
            80.0,
        ),
        (
            "0 LWPOLYLINE 90 2 70 0 10 20 20 0 40 4 41 4 10 40 20 0",
            1,
            48.0,
            80.0,
        ),
        (
            "0 LWPOLYLINE 90 2 70 0 10 50 20 0 40 6 41 0 10 60 20 0",
            1,
            wedge,
            30.0,
        ),
        // A ring from 1.5 to 3.5 mm, and a disc.
        (
            "0 LWPOLYLINE 90 2 70 1 43 2 10 -2.5 20 0 42 1 10 2.5 20 0 42 1",
            2,
            10.0 * PI,
            10.0 * PI,
        ),
        (
            "0 LWPOLYLINE 90 2 70 1 43 5 10 -2.5 20 0 42 1 10 2.5 20 0 42 1",
            1,
            10.0 * PI,
            25.0 * PI,
        ),
        // A right angle with a mitre, a frame, and a sharp turn with a bevel.
        (
            "0 LWPOLYLINE 90 3 70 0 43 2 10 0 20 0 10 10 20 0 10 10 20 10",
            1,
            44.0,
            40.0,
        ),
        (
            "0 LWPOLYLINE 90 3 70 0 43 2 10 0 20 0 10 10 20 0 10 10 20 -10",
            1,
            44.0,
            40.0,
        ),
        (
            "0 LWPOLYLINE 90 4 70 1 43 2 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10",
            2,
            80.0,
            80.0,
        ),
        // The older entity, with widths for all corners or for one.
        (
            "0 POLYLINE 66 1 70 0 40 4 41 4 0 VERTEX 10 0 20 0 0 VERTEX 10 20 20 0 0 SEQEND",
            1,
            48.0,
            80.0,
        ),
        (
            "0 POLYLINE 66 1 70 0 0 VERTEX 10 0 20 0 40 4 41 4 0 VERTEX 10 20 20 0 0 SEQEND",
            1,
            48.0,
            80.0,
        ),
        // A line with an arrow.
        (
            "0 LWPOLYLINE 90 3 70 0 10 0 20 0 10 50 20 0 40 6 41 0 10 60 20 0",
            2,
            50.0 + wedge,
            30.0,
        ),
    ] {
        let (found, strokes) = edges_and_area(entities);
        assert_eq!(strokes, lines, "{entities}");
        for (found, expected) in found.into_iter().zip([length, area]) {
            assert!(
                (found - expected).abs() < 0.1,
                "{entities}: {found}, expected {expected}"
            );
        }
    }
}

#[test]
fn the_width_of_a_polyline_is_scaled_with_its_block() {
    let bar = "0 LWPOLYLINE 90 2 70 0 43 4 10 0 20 0 10 20 20 0";
    let block = format!("0 BLOCK 2 a 10 0 20 0 {bar} 0 ENDBLK");
    let (artwork, _) = draw_text(&file("", &block, "0 INSERT 2 a 10 0 20 0 41 -2 42 3"));
    assert_eq!(
        [artwork.width_mm, artwork.height_mm].map(f64::round),
        [40.0, 12.0]
    );
}

#[test]
fn a_negative_width_is_a_mistake() {
    let text = file("", "", "0 LWPOLYLINE 90 2 70 0 43 -4 10 0 20 0 10 20 20 0");
    assert!(
        error(text.as_bytes())
            .ends_with("found a polyline of width -4; expected a width of 0 or more")
    );
}
