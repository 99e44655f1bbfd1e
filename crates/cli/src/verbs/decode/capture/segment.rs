//! The TCP segment in a network frame.

use std::net::{IpAddr, SocketAddr};

use etherparse::{EtherType, LaxNetSlice, LaxSlicedPacket, TransportSlice};

/// A TCP segment.
#[derive(Debug)]
pub(super) struct Segment<'a> {
    pub(super) from: SocketAddr,
    pub(super) to: SocketAddr,
    /// The sequence number.
    pub(super) sequence: u32,
    /// Whether it starts the connection.
    pub(super) is_first: bool,
    /// Whether it ends the connection.
    pub(super) is_last: bool,
    pub(super) bytes: &'a [u8],
}

/// The reason why a frame contains no segment.
#[derive(Clone, Copy, Debug)]
pub(super) enum NoSegment {
    /// Another protocol, or a fragment.
    Other,
    /// An unknown link type.
    UnknownLink(u32),
}

/// The TCP segment in a frame of such a link type (<https://www.tcpdump.org/linktypes.html>).
pub(super) fn segment(link: u32, frame: &[u8]) -> Result<Segment<'_>, NoSegment> {
    let packet = match link {
        ETHERNET => LaxSlicedPacket::from_ethernet(frame).ok(),
        NULL | LOOP => frame.get(4..).and_then(ip),
        RAW | RAW_BSD | RAW_OPENBSD | IPV4 | IPV6 => ip(frame),
        LINUX_COOKED => typed(frame, 14, 16),
        LINUX_COOKED_2 => typed(frame, 0, 20),
        _ => return Err(NoSegment::UnknownLink(link)),
    };
    packet.as_ref().and_then(of_packet).ok_or(NoSegment::Other)
}

fn ip(bytes: &[u8]) -> Option<LaxSlicedPacket<'_>> {
    LaxSlicedPacket::from_ip(bytes).ok()
}

/// Parses the contents after a header with an `EtherType`.
fn typed(frame: &[u8], type_at: usize, header_len: usize) -> Option<LaxSlicedPacket<'_>> {
    let kind = frame.get(type_at..)?.first_chunk()?;
    let kind = EtherType(u16::from_be_bytes(*kind));
    Some(LaxSlicedPacket::from_ether_type(
        kind,
        frame.get(header_len..)?,
    ))
}

fn of_packet<'a>(packet: &LaxSlicedPacket<'a>) -> Option<Segment<'a>> {
    let Some(TransportSlice::Tcp(tcp)) = &packet.transport else {
        return None;
    };
    let [from, to]: [IpAddr; 2] = match packet.net.as_ref()? {
        LaxNetSlice::Ipv4(ip) => {
            [ip.header().source_addr(), ip.header().destination_addr()].map(IpAddr::from)
        }
        LaxNetSlice::Ipv6(ip) => {
            [ip.header().source_addr(), ip.header().destination_addr()].map(IpAddr::from)
        }
        LaxNetSlice::Arp(_) => return None,
    };
    Some(Segment {
        from: SocketAddr::new(from, tcp.source_port()),
        to: SocketAddr::new(to, tcp.destination_port()),
        sequence: tcp.sequence_number(),
        is_first: tcp.syn(),
        is_last: tcp.fin(),
        bytes: tcp.payload(),
    })
}

const NULL: u32 = 0;
const ETHERNET: u32 = 1;
const RAW_BSD: u32 = 12;
const RAW_OPENBSD: u32 = 14;
const RAW: u32 = 101;
const LOOP: u32 = 108;
const LINUX_COOKED: u32 = 113;
const IPV4: u32 = 228;
const IPV6: u32 = 229;
const LINUX_COOKED_2: u32 = 276;
