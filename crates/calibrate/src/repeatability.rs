//! The pose repeatability of an arm.

/// The pose repeatability of an arm (ISO 9283).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeatability {
    /// The mean distance from the centroid, in mm.
    pub mean_mm: f64,
    /// The standard deviation of the distances, in mm.
    pub spread_mm: f64,
    /// The pose repeatability RP: the mean plus three standard deviations, in mm.
    pub rp_mm: f64,
}

/// Returns the repeatability of a position that was approached several times; `None` with fewer
/// than two.
#[must_use]
#[expect(
    clippy::cast_precision_loss,
    reason = "there are fewer than 2^52 approaches"
)]
pub fn repeatability(attained_mm: &[[f64; 3]]) -> Option<Repeatability> {
    let count = attained_mm.len() as f64;
    if attained_mm.len() < 2 {
        return None;
    }
    let middle =
        [0, 1, 2].map(|axis| attained_mm.iter().map(|place| place[axis]).sum::<f64>() / count);
    let distance = |place: &[f64; 3]| {
        let squares = [0, 1, 2].map(|axis| (place[axis] - middle[axis]).powi(2));
        squares.iter().sum::<f64>().sqrt()
    };
    let mean_mm = attained_mm.iter().map(distance).sum::<f64>() / count;
    let squares: f64 = attained_mm
        .iter()
        .map(|place| (distance(place) - mean_mm).powi(2))
        .sum();
    let spread_mm = (squares / (count - 1.0)).sqrt();
    Some(Repeatability {
        mean_mm,
        spread_mm,
        rp_mm: mean_mm + 3.0 * spread_mm,
    })
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn the_spread_of_places_on_a_circle_is_its_radius() {
        let places = [
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
        ];
        let found = repeatability(&places).unwrap();
        assert!((found.rp_mm - 1.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn a_single_place_has_no_spread() {
        assert_eq!(repeatability(&[[1.0, 2.0, 3.0]]), None);
    }
}
