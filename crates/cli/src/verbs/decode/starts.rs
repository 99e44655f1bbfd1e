//! The first bytes of network captures.

/// pcap with microseconds, in both byte orders.
pub(super) const PCAP: [u8; 4] = [0xD4, 0xC3, 0xB2, 0xA1];
pub(super) const PCAP_BIG: [u8; 4] = [0xA1, 0xB2, 0xC3, 0xD4];
/// pcap with nanoseconds, in both byte orders.
pub(super) const PCAP_NS: [u8; 4] = [0x4D, 0x3C, 0xB2, 0xA1];
pub(super) const PCAP_NS_BIG: [u8; 4] = [0xA1, 0xB2, 0x3C, 0x4D];
pub(super) const PCAPNG: [u8; 4] = [0x0A, 0x0D, 0x0D, 0x0A];

/// Returns whether bytes start like a capture.
#[cfg(not(feature = "full"))]
pub(super) fn is_capture(bytes: &[u8]) -> bool {
    let starts = [PCAP, PCAP_BIG, PCAP_NS, PCAP_NS_BIG, PCAPNG];
    starts.iter().any(|start| bytes.starts_with(start))
}
