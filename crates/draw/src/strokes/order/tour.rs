//! A closed tour as an array, with edge exchanges that can be undone.

/// The nodes in the order of the tour; the first follows the last.
#[derive(Debug)]
pub(super) struct Tour {
    order: Vec<u32>,
    /// The position of each node in the order.
    place: Vec<u32>,
    /// The overwritten content since the last `commit`.
    undo: Vec<u32>,
    /// The start of each write and of its part of `undo`.
    writings: Vec<(usize, usize)>,
    /// The maximum number of places that an exchange may write.
    reach: usize,
    /// The number of places written in total.
    written: u64,
}

/// An exchange that yields a single tour: where it is cut, and the order of the pieces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exchange {
    count: usize,
    /// The places before the cuts, ascending; piece i begins after cut i.
    cuts: [u32; MAX_EDGES],
    /// Twice the piece number, plus one if it is reversed.
    pieces: [u8; MAX_EDGES],
}

impl Tour {
    pub(super) fn new(order: Vec<u32>, reach: usize) -> Self {
        let mut tour = Self {
            place: vec![0; order.len()],
            order: Vec::new(),
            undo: Vec::new(),
            writings: Vec::new(),
            reach,
            written: 0,
        };
        tour.set(order);
        tour
    }

    /// Replaces the order; earlier changes cannot be undone any more.
    pub(super) fn set(&mut self, order: Vec<u32>) {
        for (i, &node) in (0..).zip(&order) {
            self.place[node as usize] = i;
        }
        self.order = order;
        self.commit();
    }

    /// Returns the number of places written: the search's cost besides evaluation.
    pub(super) const fn written(&self) -> u64 {
        self.written
    }

    pub(super) fn order(&self) -> &[u32] {
        &self.order
    }

    pub(super) fn len(&self) -> u32 {
        u32::try_from(self.order.len()).expect("nodes are numbered with 32 bits")
    }

    #[inline]
    pub(super) fn at(&self, place: u32) -> u32 {
        self.order[place as usize]
    }

    #[inline]
    pub(super) fn next(&self, node: u32) -> u32 {
        let place = self.place[node as usize] as usize + 1;
        self.order[if place == self.order.len() { 0 } else { place }]
    }

    /// Returns the exchange that removes the edges (0, 1), (2, 3) and so on of `ends` and adds (1,
    /// 2), (3, 4), ... and from the last to the first; `None` if the tour would fall apart.
    pub(super) fn exchange(&self, ends: &[u32]) -> Option<Exchange> {
        let sides = self.sides(ends);
        let count = ends.len() / 2;
        let (mut pieces, mut passed, mut entry) = ([0; MAX_EDGES], 0, 0);
        loop {
            pieces[passed] = entry;
            passed += 1;
            entry = sides.of_end[joined(sides.end_at[usize::from(entry ^ 1)], 2 * count)];
            if entry == 0 {
                break;
            }
        }
        let cuts = sides.cuts;
        let exchange = Exchange {
            count,
            cuts,
            pieces,
        };
        // If a piece was not passed, the exchange would split the tour; a very long exchange would
        // take too much time.
        (passed == count && self.writes(&exchange) <= self.reach).then_some(exchange)
    }

    /// Cuts the tour at the edges (0, 1), (2, 3) and so on.
    fn sides(&self, ends: &[u32]) -> Sides {
        let count = ends.len() / 2;
        // The cuts in tour order, each with its edge and whether that is reversed.
        let mut sorted = [(0, 0, false); MAX_EDGES];
        for (i, edge) in ends.chunks_exact(2).enumerate() {
            let backward = self.next(edge[0]) != edge[1];
            let before = edge[usize::from(backward)];
            let cut = (self.place[before as usize], 2 * i, backward);
            let mut slot = i;
            while slot > 0 && sorted[slot - 1].0 > cut.0 {
                sorted[slot] = sorted[slot - 1];
                slot -= 1;
            }
            sorted[slot] = cut;
        }
        let mut sides = Sides::default();
        let mut left = last_side(count);
        for ((entry, (cut, edge, backward)), cut_at) in
            (0..).step_by(2).zip(sorted).zip(&mut sides.cuts[..count])
        {
            *cut_at = cut;
            // A piece is left at the first node of the edge and entered at the second.
            for (side, end) in [
                (left, edge + usize::from(backward)),
                (entry, edge + usize::from(!backward)),
            ] {
                sides.of_end[end] = side;
                sides.end_at[usize::from(side)] = end;
            }
            left = entry + 1;
        }
        sides
    }

    /// Returns a double bridge: cut after four places, ascending, the second, third and fourth
    /// piece follow in opposite order, none reversed.
    pub(super) const fn bridge(cuts: [u32; 4]) -> Exchange {
        Exchange {
            count: 4,
            cuts,
            pieces: [0, 6, 4, 2],
        }
    }

    pub(super) fn apply(&mut self, exchange: &Exchange) {
        let count = exchange.count;
        // Rewrite all but the longest piece. If that one would be reversed, reverse all others
        // instead: the tour is closed, so its direction does not matter.
        let (longest, kept) = self.longest(exchange);
        let size = self.order.len();
        let begin = (self.piece(exchange, longest).0 + kept) % size;
        let saved = self.save(begin, size - kept);
        let slot = (0..count)
            .find(|&i| usize::from(exchange.pieces[i]) / 2 == longest)
            .expect("an exchange passes every piece");
        let turned = exchange.pieces[slot] % 2 == 1;
        let mut to = begin;
        for step in 1..count {
            let slot = if turned {
                slot + count - step
            } else {
                slot + step
            };
            let entry = usize::from(exchange.pieces[slot % count]);
            let (from, length) = self.piece(exchange, entry / 2);
            let from = saved + (from + size - begin) % size;
            to = self.write(to, from, length, (entry % 2 == 1) != turned);
        }
    }

    /// Makes all changes permanent.
    pub(super) fn commit(&mut self) {
        self.undo.clear();
        self.writings.clear();
    }

    /// Undoes all changes since the last `commit`.
    pub(super) fn revert(&mut self) {
        while let Some((begin, saved)) = self.writings.pop() {
            self.written += (self.undo.len() - saved) as u64;
            let mut place = begin;
            for &node in &self.undo[saved..] {
                self.order[place] = node;
                self.place[node as usize] = u32_of(place);
                place += 1;
                if place == self.order.len() {
                    place = 0;
                }
            }
            self.undo.truncate(saved);
        }
    }

    /// Returns the start and the number of places of a piece.
    fn piece(&self, exchange: &Exchange, piece: usize) -> (usize, usize) {
        let size = self.order.len();
        let cut = exchange.cuts[piece] as usize;
        let begin = if cut + 1 == size { 0 } else { cut + 1 };
        if piece + 1 == exchange.count {
            (begin, size + exchange.cuts[0] as usize - cut)
        } else {
            (begin, exchange.cuts[piece + 1] as usize - cut)
        }
    }

    /// Returns the longest piece and its length.
    fn longest(&self, exchange: &Exchange) -> (usize, usize) {
        let lengths = (0..exchange.count).map(|i| (i, self.piece(exchange, i).1));
        lengths
            .max_by_key(|&(_, length)| length)
            .expect("an exchange has pieces")
    }

    /// Returns the number of places that an exchange writes: all but its longest piece.
    fn writes(&self, exchange: &Exchange) -> usize {
        self.order.len() - self.longest(exchange).1
    }

    fn save(&mut self, begin: usize, length: usize) -> usize {
        let saved = self.undo.len();
        self.writings.push((begin, saved));
        self.written += length as u64;
        let first = length.min(self.order.len() - begin);
        self.undo
            .extend_from_slice(&self.order[begin..begin + first]);
        self.undo.extend_from_slice(&self.order[..length - first]);
        saved
    }

    /// Copies a saved piece to the tour and returns the place after it.
    fn write(&mut self, mut to: usize, from: usize, length: usize, backward: bool) -> usize {
        for i in 0..length {
            let i = if backward { length - 1 - i } else { i };
            let node = self.undo[from + i];
            self.order[to] = node;
            self.place[node as usize] = u32_of(to);
            to += 1;
            if to == self.order.len() {
                to = 0;
            }
        }
        to
    }
}

/// The two sides of each piece: 2 p at the start of piece p, 2 p + 1 at its end.
#[derive(Default)]
struct Sides {
    cuts: [u32; MAX_EDGES],
    /// The side of a piece for each end of an edge.
    of_end: [u8; 2 * MAX_EDGES],
    /// The end of an edge for each side of a piece.
    end_at: [usize; 2 * MAX_EDGES],
}

/// Returns the side at the end of the last piece.
fn last_side(count: usize) -> u8 {
    u8::try_from(2 * count - 1).expect("at most MAX_EDGES pieces")
}

/// Returns the end joined with this one: the next for an odd end, the one before for an even end.
const fn joined(end: usize, count: usize) -> usize {
    if end % 2 == 1 {
        if end + 1 == count { 0 } else { end + 1 }
    } else if end == 0 {
        count - 1
    } else {
        end - 1
    }
}

#[expect(clippy::cast_possible_truncation, reason = "`len` has checked it")]
const fn u32_of(place: usize) -> u32 {
    place as u32
}

/// The maximum number of edges that an exchange removes.
pub(super) const MAX_EDGES: usize = 4;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Returns the edges of a tour, each with the smaller node first.
    fn edges(order: &[u32]) -> Vec<(u32, u32)> {
        let next = order.iter().cycle().skip(1);
        let mut edges: Vec<_> = order
            .iter()
            .zip(next)
            .map(|(&a, &b)| (a.min(b), a.max(b)))
            .collect();
        edges.sort_unstable();
        edges
    }

    proptest! {
        #[test]
        fn an_exchange_swaps_only_its_edges_and_can_be_undone(
            places in proptest::collection::btree_set(0_u32..12, 2..=MAX_EDGES),
            backward in proptest::collection::vec(any::<bool>(), MAX_EDGES),
        ) {
            let given: Vec<u32> = (0..12).map(|i| i * 5 % 12).collect();
            let mut tour = Tour::new(given.clone(), 12);
            let mut ends = Vec::new();
            for (&place, backward) in places.iter().zip(backward) {
                let (a, b) = (tour.at(place), tour.next(tour.at(place)));
                ends.extend(if backward { [b, a] } else { [a, b] });
            }
            if let Some(exchange) = tour.exchange(&ends) {
                tour.apply(&exchange);
                let mut expected = edges(&given);
                for pair in ends.chunks(2) {
                    let out = (pair[0].min(pair[1]), pair[0].max(pair[1]));
                    expected.retain(|edge| *edge != out);
                }
                ends.rotate_left(1);
                expected.extend(ends.chunks(2).map(|p| (p[0].min(p[1]), p[0].max(p[1]))));
                expected.sort_unstable();
                prop_assert_eq!(edges(tour.order()), expected);
                tour.revert();
            }
            prop_assert_eq!(tour.order(), &given);
            let next = (0..12).map(|place| tour.next(tour.at(place)));
            prop_assert!(next.eq((1..=12).map(|place| tour.at(place % 12))));
        }
    }
}
