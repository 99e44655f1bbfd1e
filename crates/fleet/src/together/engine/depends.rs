//! Dependencies between parts.

use std::collections::BTreeSet;

/// Returns the parts that still share a barrier with this one, directly or through others; `ahead`
/// has the names of the remaining barriers of each.
pub(super) fn dependents(ahead: &[BTreeSet<&str>], part: usize) -> Vec<usize> {
    let mut reached = BTreeSet::from([part]);
    let mut waiting = vec![part];
    while let Some(from) = waiting.pop() {
        for (other, names) in ahead.iter().enumerate() {
            if !names.is_disjoint(&ahead[from]) && reached.insert(other) {
                waiting.push(other);
            }
        }
    }
    reached.remove(&part);
    reached.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_depend_on_each_other_indirectly_and_only_until_their_barrier() {
        let ahead = [&["x"][..], &["x", "y"], &["y"], &["z"], &["z"], &[]];
        let ahead = ahead.map(|names| names.iter().copied().collect::<BTreeSet<_>>());
        assert_eq!(dependents(&ahead, 0), [1, 2]);
        assert_eq!(dependents(&ahead, 4), [3]);
        assert!(dependents(&ahead, 5).is_empty());
    }
}
