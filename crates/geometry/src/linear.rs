//! Systems of linear equations.

/// Solves `matrix * x = right` for `x`; `None` if the matrix is singular or a number is not finite.
///
/// For a nearly singular matrix the result is inaccurate.
///
/// ```
/// let x = dobot_geometry::solve(&[[2.0, 1.0], [1.0, 3.0]], &[4.0, 7.0]).expect("not singular");
/// assert!((x[0] - 1.0).abs() < 1e-12 && (x[1] - 2.0).abs() < 1e-12);
/// ```
///
/// # Panics
///
/// If the matrix is not square, or `right` does not have one number per row.
#[must_use]
pub fn solve(matrix: &[impl AsRef<[f64]>], right: &[f64]) -> Option<Vec<f64>> {
    assert_eq!(matrix.len(), right.len(), "one number for each row");
    let right = right.iter().map(|number| vec![*number]);
    Some(eliminate(matrix, right)?.concat())
}

/// Returns the inverse of a matrix, row by row; `None` if the matrix is singular or a number is not
/// finite.
///
/// # Panics
///
/// If the matrix is not square.
#[must_use]
pub fn inverse(matrix: &[impl AsRef<[f64]>]) -> Option<Vec<Vec<f64>>> {
    let identity = (0..matrix.len()).map(|row| {
        let mut unit = vec![0.0; matrix.len()];
        unit[row] = 1.0;
        unit
    });
    eliminate(matrix, identity)
}

/// Applies Gauss-Jordan elimination with partial pivoting and returns the right-hand side once the
/// matrix is the identity.
fn eliminate(
    matrix: &[impl AsRef<[f64]>],
    right: impl Iterator<Item = Vec<f64>>,
) -> Option<Vec<Vec<f64>>> {
    let count = matrix.len();
    let joined = |(left, right): (_, Vec<f64>)| {
        let left: &[f64] = AsRef::as_ref(left);
        assert_eq!(left.len(), count, "the matrix is square");
        [left, &right].concat()
    };
    let mut rows: Vec<Vec<f64>> = matrix.iter().zip(right).map(joined).collect();
    if !rows.iter().flatten().all(|number| number.is_finite()) {
        return None;
    }
    for column in 0..count {
        eliminate_column(&mut rows, column)?;
    }
    let answer = |row: Vec<f64>| row[count..].to_vec();
    Some(rows.into_iter().map(answer).collect())
}

/// Makes the largest number of a column 1 and the others 0; `None` if they are too small.
fn eliminate_column(rows: &mut [Vec<f64>], column: usize) -> Option<()> {
    let size = |row: &usize| rows[*row][column].abs();
    let largest = (column..rows.len()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
    rows.swap(column, largest);
    let (above, rest) = rows.split_at_mut(column);
    let (pivot_row, below) = rest.split_first_mut()?;
    let pivot = pivot_row[column];
    if pivot == 0.0 || !pivot.is_finite() {
        return None;
    }
    for number in &mut pivot_row[column..] {
        *number /= pivot;
    }
    for row in above.iter_mut().chain(below) {
        let factor = row[column];
        for (number, pivot) in row[column..].iter_mut().zip(&pivot_row[column..]) {
            *number -= factor * pivot;
        }
    }
    Some(())
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;

    fn product(matrix: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
        let dot = |row: &Vec<f64>| row.iter().zip(x).map(|(a, b)| a * b).sum();
        matrix.iter().map(dot).collect()
    }

    #[test]
    fn rows_are_swapped_where_a_pivot_is_zero() {
        let matrix = [[0.0, 2.0, 0.0], [0.0, 0.0, 4.0], [1.0, 0.0, 0.0]];
        assert_eq!(solve(&matrix, &[2.0, 8.0, 3.0]), Some(vec![3.0, 1.0, 2.0]));
    }

    #[test]
    fn a_small_pivot_costs_no_accuracy() {
        let x = solve(&[[1e-20, 1.0], [1.0, 1.0]], &[1.0, 2.0]).unwrap();
        assert!((x[0] - 1.0).abs() < 1e-12, "{x:?}");
        assert!((x[1] - 1.0).abs() < 1e-12, "{x:?}");
    }

    #[test]
    fn singular_matrices_have_no_answer() {
        let right = [1.0, 2.0];
        for matrix in [
            [[0.0, 0.0], [0.0, 0.0]],
            [[1.0, 2.0], [2.0, 4.0]],
            [[0.0, 1.0], [0.0, 3.0]],
            [[1.0, 1.0], [0.0, 0.0]],
        ] {
            assert_eq!(solve(&matrix, &right), None, "{matrix:?}");
            assert_eq!(inverse(&matrix), None, "{matrix:?}");
        }
    }

    #[test]
    fn infinite_and_nan_entries_have_no_answer() {
        for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(solve(&[[1.0, 0.0], [0.0, number]], &[1.0, 1.0]), None);
            assert_eq!(solve(&[[1.0, number], [0.0, 1.0]], &[1.0, 1.0]), None);
            assert_eq!(solve(&[[1.0]], &[number]), None);
            assert_eq!(inverse(&[[number]]), None);
        }
    }

    #[test]
    fn no_equations_have_an_empty_answer() {
        let matrix: [[f64; 0]; 0] = [];
        assert_eq!(solve(&matrix, &[]), Some(Vec::new()));
        assert_eq!(inverse(&matrix), Some(Vec::new()));
    }

    proptest! {
        #[test]
        fn the_answer_fulfils_the_equations(
            (mut matrix, right) in (1..20_usize)
                .prop_flat_map(|n| (vec(vec(-1.0..1.0, n), n), vec(-1.0..1.0, n))),
            shift in 0..20_usize,
        ) {
            // Far from singular: one large number in each row and column, at any position.
            let count = right.len();
            for (row, numbers) in matrix.iter_mut().enumerate() {
                numbers[(row + shift) % count] += 25.0;
            }
            let x = solve(&matrix, &right).unwrap();
            for (found, wanted) in product(&matrix, &x).iter().zip(&right) {
                prop_assert!((found - wanted).abs() < 1e-12, "{} for {}", found, wanted);
            }
        }

        #[test]
        fn a_matrix_times_its_inverse_is_the_identity(
            numbers in (1..13_usize).prop_flat_map(|n| vec(vec(-1.0..1.0, n), n)),
        ) {
            // Symmetric and positive definite, as the normal equations of least squares.
            let count = numbers.len();
            let dot = |a: &Vec<f64>, b: &Vec<f64>| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let normal: Vec<Vec<f64>> = (0..count)
                .map(|row| {
                    let of_column = |column| {
                        dot(&numbers[row], &numbers[column]) + if row == column { 1.0 } else { 0.0 }
                    };
                    (0..count).map(of_column).collect()
                })
                .collect();
            let inverse = inverse(&normal).unwrap();
            for column in 0..count {
                let of_column: Vec<f64> = inverse.iter().map(|row| row[column]).collect();
                for (row, found) in product(&normal, &of_column).iter().enumerate() {
                    let wanted = if row == column { 1.0 } else { 0.0 };
                    prop_assert!((found - wanted).abs() < 1e-10, "{} at {}, {}", found, row, column);
                }
            }
        }
    }
}
