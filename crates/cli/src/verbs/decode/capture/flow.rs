//! Reassembly of one direction of a TCP connection.

use std::collections::BTreeMap;
use std::ops::Range;

use super::segment::Segment;
use crate::verbs::decode::content::Place;
use crate::verbs::decode::input::{Chunk, Part};

/// One direction of a TCP connection.
#[derive(Debug, Default)]
pub(super) struct Flow {
    /// The pieces by their start; they do not overlap.
    pieces: BTreeMap<i64, Piece>,
    /// The sequence number of the last segment, and its distance from the first one.
    last: Option<(u32, i64)>,
    /// The position of the first byte, if the start of the connection was captured.
    begin: Option<i64>,
}

/// Bytes that were sent together; empty at the end of the connection.
#[derive(Debug)]
struct Piece {
    /// The index of its segment in the capture.
    order: usize,
    place: Place,
    bytes: Vec<u8>,
}

impl Flow {
    /// Adds a segment, the `order`-th of the capture. The first copy of repeated bytes counts.
    pub(super) fn add(&mut self, order: usize, place: &Place, segment: &Segment) {
        let at = self.at(segment.sequence);
        self.last = Some((segment.sequence, at));
        let at = at + i64::from(segment.is_first);
        if segment.is_first {
            self.begin = Some(at);
        }
        let bytes = segment.bytes;
        for missing in self.missing(at, bytes.len()) {
            let bytes = bytes[missing.clone()].to_vec();
            let piece = Piece {
                order,
                place: place.clone(),
                bytes,
            };
            self.pieces.insert(offset(at, missing.start), piece);
        }
        if segment.is_last {
            let end = Piece {
                order,
                place: place.clone(),
                bytes: Vec::new(),
            };
            self.pieces.entry(offset(at, bytes.len())).or_insert(end);
        }
    }

    /// Whether a segment starts another connection between the same ends.
    pub(super) fn is_over_with(&self, segment: &Segment) -> bool {
        let begins_again = self.begin != Some(self.at(segment.sequence) + 1);
        segment.is_first && self.last.is_some() && begins_again
    }

    /// The bytes in the order of sending.
    pub(super) fn parts(self) -> Vec<Part> {
        let mut parts: Vec<Part> = Vec::new();
        let mut end = self
            .begin
            .or(self.pieces.keys().next().copied())
            .unwrap_or(0);
        for (at, piece) in self.pieces {
            let gap = u64::try_from(at - end).unwrap_or(0);
            if gap > 0 || parts.is_empty() {
                parts.push(Part {
                    gap,
                    ..Part::default()
                });
            }
            end = end.max(offset(at, piece.bytes.len()));
            if let Some(part) = parts.last_mut() {
                push(part, piece);
            }
        }
        parts.retain(|part| part.gap > 0 || !part.bytes.is_empty());
        parts
    }

    /// The position of a sequence number, which wraps around.
    fn at(&self, sequence: u32) -> i64 {
        let since = |last: u32| i64::from(sequence.wrapping_sub(last).cast_signed());
        self.last.map_or(0, |(last, at)| at + since(last))
    }

    /// The ranges of new bytes in a segment.
    fn missing(&self, at: i64, len: usize) -> Vec<Range<usize>> {
        let end = offset(at, len);
        let before = self.pieces.range(..=at).next_back();
        let known = before
            .into_iter()
            .chain(self.pieces.range(at + 1..end.max(at + 1)));
        let mut missing = Vec::new();
        let mut from = at;
        for (begin, piece) in known {
            missing.push(from..*begin);
            from = from.max(offset(*begin, piece.bytes.len()));
        }
        missing.push(from..end);
        let index = |place: i64| usize::try_from(place - at).unwrap_or(0);
        let indices = missing
            .into_iter()
            .map(|range| index(range.start)..index(range.end));
        indices.filter(|range| !range.is_empty()).collect()
    }
}

/// Appends bytes to a part; they arrive no earlier than the bytes before them.
fn push(part: &mut Part, piece: Piece) {
    let begin = part.bytes.len();
    let chunk = match part.chunks.last() {
        Some(before) if before.order > piece.order => Chunk {
            begin,
            order: before.order,
            place: before.place.clone(),
        },
        _ => Chunk {
            begin,
            order: piece.order,
            place: piece.place,
        },
    };
    part.chunks.push(chunk);
    part.bytes.extend(piece.bytes);
}

fn offset(at: i64, len: usize) -> i64 {
    at.saturating_add_unsigned(len as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flow(segments: &[(u32, &str)]) -> Flow {
        let end = "127.0.0.1:1".parse().expect("it is an address");
        let place = Place {
            text: String::new(),
            fields: Vec::new(),
        };
        let mut flow = Flow::default();
        for (order, (sequence, text)) in segments.iter().enumerate() {
            let segment = Segment {
                from: end,
                to: end,
                sequence: *sequence,
                is_first: *text == "SYN",
                is_last: *text == "FIN",
                bytes: if matches!(*text, "SYN" | "FIN") {
                    b""
                } else {
                    text.as_bytes()
                },
            };
            flow.add(order, &place, &segment);
        }
        flow
    }

    /// The bytes, each part with the size of the gap before it.
    fn text(segments: &[(u32, &str)]) -> String {
        let part = |part: Part| {
            let bytes = String::from_utf8(part.bytes).expect("it is text");
            if part.gap > 0 {
                format!("<{}>{bytes}", part.gap)
            } else {
                bytes
            }
        };
        flow(segments).parts().into_iter().map(part).collect()
    }

    #[test]
    fn segments_are_put_in_order_and_repeated_bytes_count_once() {
        assert_eq!(
            text(&[(7, "SYN"), (8, "abc"), (11, "def"), (14, "FIN")]),
            "abcdef"
        );
        assert_eq!(
            text(&[
                (7, "SYN"),
                (11, "def"),
                (8, "abc"),
                (8, "XXXX"),
                (10, "XXXXgh")
            ]),
            "abcdefgh"
        );
        assert_eq!(text(&[(8, "abc"), (8, "abc"), (7, "zXXXX")]), "zabcX");
        assert_eq!(text(&[(u32::MAX, "abc"), (2, "def"), (0, "XXX")]), "abcdef");
    }

    #[test]
    fn missing_bytes_are_reported_at_the_beginning_in_the_middle_and_at_the_end() {
        assert_eq!(
            text(&[(7, "SYN"), (10, "cd"), (14, "gh"), (17, "FIN")]),
            "<2>cd<2>gh<1>"
        );
        assert_eq!(text(&[(10, "cd"), (12, "ef")]), "cdef");
    }

    #[test]
    fn bytes_are_available_when_all_before_them_are() {
        let parts = flow(&[(11, "def"), (8, "abc"), (14, "ghi")]).parts();
        let orders: Vec<_> = parts[0]
            .chunks
            .iter()
            .map(|chunk| (chunk.begin, chunk.order))
            .collect();
        assert_eq!(orders, [(0, 1), (3, 1), (6, 2)]);
    }

    #[test]
    fn a_connection_that_starts_again_is_another_one() {
        let first = flow(&[(7, "SYN"), (8, "abc")]);
        let syn = |sequence| {
            let end = "127.0.0.1:1".parse().expect("it is an address");
            Segment {
                from: end,
                to: end,
                sequence,
                is_first: true,
                is_last: false,
                bytes: b"",
            }
        };
        assert!(first.is_over_with(&syn(5000)));
        assert!(!first.is_over_with(&syn(7)));
        assert!(!Flow::default().is_over_with(&syn(7)));
    }

    proptest::proptest! {
        #[test]
        fn no_byte_is_reported_twice(
            segments in proptest::collection::vec((0..60_u32, 0..20_usize), 0..20),
        ) {
            let source: String = ('!'..='~').collect();
            let segments: Vec<_> = segments
                .iter()
                .map(|(at, len)| (at.wrapping_add(u32::MAX - 30), &source[*at as usize..][..*len]))
                .collect();
            let parts = flow(&segments).parts();
            let read: Vec<u8> = parts.into_iter().flat_map(|part| part.bytes).collect();
            proptest::prop_assert!(read.is_sorted_by(|a, b| a < b), "{read:?}");
            let mut sent: Vec<u8> = segments.iter().flat_map(|(_, text)| text.bytes()).collect();
            sent.sort_unstable();
            sent.dedup();
            proptest::prop_assert_eq!(read, sent);
        }
    }
}
