//! Line types: dashes, gaps and dots.

/// A line type of the table LTYPE.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LineType {
    /// Alternating dashes and gaps, in units of the file; a dash of length 0 is a dot.
    pub(super) lengths: Vec<f64>,
    /// The offset into them at which a line starts.
    pub(super) offset: f64,
}

impl LineType {
    /// Creates a type from its elements: above 0 a dash, below 0 a gap, 0 a dot. `None` for a line
    /// without gaps.
    ///
    /// ```text
    ///   0.5 -0.25 0 -0.25      ----    .    ----    .    ----
    /// ```
    pub(super) fn of(elements: &[f64]) -> Option<Self> {
        let is_gap = |x: &f64| *x < 0.0;
        let first = elements.iter().position(|element| !is_gap(element))?;
        elements.iter().find(|element| is_gap(element))?;
        let (begin, from_dash) = elements.split_at(first);
        let mut lengths: Vec<f64> = Vec::new();
        for &element in from_dash.iter().chain(begin) {
            // Even ones are dashes.
            let is_other = is_gap(&element) == (lengths.len() % 2 == 1);
            match lengths.last_mut().filter(|_| !is_other) {
                Some(last) => *last += element.abs(),
                None => lengths.push(element.abs()),
            }
        }
        let mut offset = -begin.iter().sum::<f64>().abs();
        // The last dash continues in the first one.
        if lengths.len() % 2 == 1 {
            let last = lengths.pop()?;
            lengths[0] += last;
            offset += last;
        }
        let period: f64 = lengths.iter().sum();
        (period > 0.0 && period.is_finite()).then_some(Self { lengths, offset })
    }

    /// The type scaled by a factor; `None` for an invalid factor.
    pub(super) fn scaled(&self, factor: f64) -> Option<Self> {
        let is_sane = factor.is_finite() && factor > 0.0;
        is_sane.then(|| Self {
            lengths: self.lengths.iter().map(|length| length * factor).collect(),
            offset: self.offset * factor,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_and_gaps_take_turns_from_any_start_of_the_type() {
        let of = |elements: &[f64]| {
            LineType::of(elements).map(|line_type| (line_type.lengths, line_type.offset))
        };
        assert_eq!(of(&[0.5, -0.25]), Some((vec![0.5, 0.25], 0.0)));
        let dash_dot = [0.5, -0.25, 0.0, -0.25];
        assert_eq!(of(&dash_dot), Some((vec![0.5, 0.25, 0.0, 0.25], 0.0)));
        assert_eq!(of(&[-0.25, 0.5]), Some((vec![0.5, 0.25], -0.25)));
        assert_eq!(of(&[0.5, -0.25, 0.25]), Some((vec![0.75, 0.25], 0.25)));
        assert_eq!(
            of(&[0.5, 0.5, -0.1, -0.2]).map(|pattern| pattern.0.len()),
            Some(2)
        );
        for solid in [&[][..], &[0.5], &[-0.5], &[0.0, 1.0], &[f64::NAN, -1.0]] {
            assert_eq!(of(solid), None, "{solid:?}");
        }
    }
}
