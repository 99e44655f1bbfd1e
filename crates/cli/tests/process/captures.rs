//! `dobot decode` of what was captured on a network.

use crate::decoding::{json_lines, sample};
use crate::support::program::{dobot, dobot_reading};

/// Captured by tcpdump while two programs talked: the status in two pieces, 20 ms apart.
#[test]
fn both_directions_of_a_captured_connection_are_shown_with_their_times() {
    for name in ["ethernet.pcap", "sll.pcap", "sll2-ipv6.pcap"] {
        let outcome = dobot(&["decode", &sample(name), "--json"]).succeeds();
        let lines = json_lines(&outcome.stdout);
        let kinds: Vec<_> = lines
            .iter()
            .map(|line| line["command"].is_object())
            .collect();
        assert_eq!(kinds, [false, true, false, false], "{name}: {outcome:?}");
        assert!(lines[0]["status"].is_object(), "{name}: {outcome:?}");
        assert_eq!(lines[0]["sender"], lines[1]["receiver"], "{name}");
        let at_s: Vec<f64> = lines
            .iter()
            .filter_map(|line| line["at_s"].as_f64())
            .collect();
        // The second status is there with its second piece.
        for [first, second] in [[0, 2], [2, 3]] {
            let between_s = at_s[second] - at_s[first];
            assert!((0.1..0.13).contains(&between_s), "{name}: {at_s:?}");
        }
        assert!(
            outcome
                .stderr
                .contains("times are in seconds since 2026-11-22T12:1"),
            "{name}: {outcome:?}"
        );
    }
}

/// A connection made by hand: one command comes in the wrong order and partly twice, the sequence
/// numbers start again, and 10 bytes of the statuses are lost.
#[test]
fn a_captured_connection_is_put_in_order_and_its_gaps_are_reported() {
    for name in ["awkward.pcapng", "raw.pcap", "null-big-endian.pcap"] {
        let outcome = dobot(&["decode", &sample(name)]).succeeds();
        let client = "10.0.0.2:40000 > 10.0.0.9:5555";
        let arm = "10.0.0.9:5555 > 10.0.0.2:40000";
        let expected = [
            ("0.100000", arm, "status"),
            ("0.210000", client, "move_to"),
            ("0.300000", client, "move_to"),
            ("0.300000", client, "move_to"),
            ("0.400000", arm, "10 bytes are missing here"),
            ("0.400000", arm, "skipped 32 bytes"),
            ("0.400000", arm, "status"),
            ("0.500000", arm, "status"),
        ];
        let lines: Vec<&str> = outcome.stdout.lines().collect();
        assert_eq!(lines.len(), expected.len(), "{name}: {outcome:?}");
        for (line, (at, way, what)) in lines.iter().zip(expected) {
            assert!(
                line.trim_start()
                    .starts_with(&format!("{at}  {way}  {what}")),
                "{name}: {line}"
            );
        }
    }
}

#[test]
fn a_truncated_capture_is_read_to_its_end() {
    let bytes = std::fs::read(sample("raw.pcap")).expect("the sample is there");
    let outcome = dobot_reading(&["decode", "-"], &bytes[..bytes.len() - 70]).succeeds();
    assert!(outcome.stdout.contains("move_to"), "{outcome:?}");
    assert!(
        outcome.stderr.contains("the pcap file is damaged: byte "),
        "{outcome:?}"
    );
    dobot_reading(&["decode", "-"], &bytes[..10]).fails(1, &["the pcap file is damaged", "header"]);
}
