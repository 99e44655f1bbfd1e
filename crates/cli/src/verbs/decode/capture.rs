//! Network captures: pcap and pcapng files with TCP connections.

mod file;
mod flow;
mod segment;

use std::collections::HashMap;
use std::net::SocketAddr;

use serde_json::{Value, json};

use self::file::{File, Frame};
use self::flow::Flow;
use self::segment::{NoSegment, Segment, segment};
use super::content::Place;
use super::input::{Input, Stream};
use crate::output;

/// Reads a capture; `None` if the bytes are none.
pub(super) fn read(bytes: &[u8]) -> Option<anyhow::Result<Input>> {
    let file = file::read(bytes)?;
    Some(file.map(|file| input(&file)))
}

fn input(file: &File) -> Input {
    let start_ns = file.frames.iter().find_map(|frame| frame.at_ns);
    let mut flows = Flows::default();
    let mut ignored = Ignored::default();
    for (order, frame) in file.frames.iter().enumerate() {
        match segment(frame.link, frame.data) {
            Ok(segment) => flows.add(order, &place(frame, &segment, start_ns), &segment),
            Err(reason) => ignored.count(reason),
        }
    }
    let streams = flows.all.into_iter().map(|flow| Stream {
        parts: flow.parts(),
    });
    let streams: Vec<_> = streams.filter(|stream| !stream.parts.is_empty()).collect();
    let start = start_ns
        .and_then(time)
        .map(|start| format!("times are in seconds since {start}"));
    Input {
        format: file.format.to_owned(),
        notes: [start, ignored.note(), file.damage.clone()]
            .into_iter()
            .flatten()
            .collect(),
        streams,
    }
}

/// The time and the direction of a frame.
fn place(frame: &Frame, segment: &Segment, start_ns: Option<i128>) -> Place {
    let at_s = frame
        .at_ns
        .zip(start_ns)
        .map(|(at, start)| seconds(at - start));
    let (from, to) = (segment.from.to_string(), segment.to.to_string());
    let time = at_s.map_or_else(String::new, |at_s| format!("{at_s:.6}"));
    Place {
        text: format!("{time:>12}  {from} > {to}"),
        fields: vec![
            ("at_s", at_s.map_or(Value::Null, |at_s| json!(at_s))),
            ("sender", json!(from)),
            ("receiver", json!(to)),
        ],
    }
}

#[expect(clippy::cast_precision_loss, reason = "a time for a person")]
fn seconds(ns: i128) -> f64 {
    ns as f64 / 1e9
}

fn time(ns: i128) -> Option<jiff::Timestamp> {
    jiff::Timestamp::from_nanosecond(ns).ok()
}

/// The directions of all connections, in the order of their starts.
#[derive(Default)]
struct Flows {
    all: Vec<Flow>,
    /// The latest flow between two ends.
    latest: HashMap<(SocketAddr, SocketAddr), usize>,
}

impl Flows {
    fn add(&mut self, order: usize, place: &Place, segment: &Segment) {
        let ends = (segment.from, segment.to);
        let known = self.latest.get(&ends).copied();
        let index = known.filter(|index| !self.all[*index].is_over_with(segment));
        let index = index.unwrap_or_else(|| {
            self.all.push(Flow::default());
            self.all.len() - 1
        });
        self.latest.insert(ends, index);
        self.all[index].add(order, place, segment);
    }
}

/// The packets of a capture that are ignored.
#[derive(Default)]
struct Ignored {
    others: usize,
    /// The number of frames with an unknown link type, and the last such type.
    unknown: Option<(usize, u32)>,
}

impl Ignored {
    fn count(&mut self, reason: NoSegment) {
        match reason {
            NoSegment::Other => self.others += 1,
            NoSegment::UnknownLink(link) => {
                let before = self.unknown.map_or(0, |(count, _)| count);
                self.unknown = Some((before + 1, link));
            }
        }
    }

    fn note(&self) -> Option<String> {
        let others = (self.others > 0).then(|| {
            output::many(
                self.others,
                "packet other than TCP",
                "packets other than TCP",
            )
        });
        let unknown = self.unknown.map(|(count, link)| {
            format!(
                "{} of link type {link} (supported are Ethernet, Linux cooked, loopback and raw IP)",
                output::count(count, "packet")
            )
        });
        let ignored: Vec<_> = others.into_iter().chain(unknown).collect();
        (!ignored.is_empty()).then(|| format!("ignored: {}", ignored.join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        #[test]
        fn no_damage_to_a_capture_makes_it_panic(
            which in 0..4_usize,
            hits in proptest::collection::vec((0..2000_usize, proptest::prelude::any::<u8>()), 0..6),
            len in 0..2000_usize,
        ) {
            let mut bytes = SAMPLES[which].to_vec();
            bytes.truncate(len);
            for (at, byte) in hits {
                if let Some(hit) = bytes.get_mut(at) {
                    *hit = byte;
                }
            }
            let _ = read(&bytes);
        }
    }

    const SAMPLES: [&[u8]; 4] = [
        include_bytes!("../../../tests/process/samples/decode/awkward.pcapng"),
        include_bytes!("../../../tests/process/samples/decode/null-big-endian.pcap"),
        include_bytes!("../../../tests/process/samples/decode/sll2-ipv6.pcap"),
        include_bytes!("../../../tests/process/samples/decode/ethernet.pcap"),
    ];
}
