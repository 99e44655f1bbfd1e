//! The frames in a pcap or pcapng file.

use anyhow::{Context, anyhow, bail};

use super::super::starts::{PCAP, PCAP_BIG, PCAP_NS, PCAP_NS_BIG, PCAPNG};

/// A capture file.
#[derive(Debug)]
pub(super) struct File<'a> {
    pub(super) format: &'static str,
    pub(super) frames: Vec<Frame<'a>>,
    /// The damage of the file, if any; it is read up to there.
    pub(super) damage: Option<String>,
}

/// A captured frame.
#[derive(Debug)]
pub(super) struct Frame<'a> {
    /// The link type.
    pub(super) link: u32,
    /// The time in nanoseconds since 1970, if recorded.
    pub(super) at_ns: Option<i128>,
    pub(super) data: &'a [u8],
}

/// Reads a capture; `None` if the bytes do not start like one.
pub(super) fn read(bytes: &[u8]) -> Option<anyhow::Result<File<'_>>> {
    let mut frames = Vec::new();
    let (format, result) = match *bytes.first_chunk::<4>()? {
        PCAP => ("pcap", pcap(bytes, Order::Little, 1000, &mut frames)),
        PCAP_BIG => ("pcap", pcap(bytes, Order::Big, 1000, &mut frames)),
        PCAP_NS => ("pcap", pcap(bytes, Order::Little, 1, &mut frames)),
        PCAP_NS_BIG => ("pcap", pcap(bytes, Order::Big, 1, &mut frames)),
        PCAPNG => ("pcapng", pcapng(bytes, &mut frames)),
        _ => return None,
    };
    let damage = result
        .err()
        .map(|error| error.context(format!("the {format} file is damaged")));
    Some(match damage {
        Some(error) if frames.is_empty() => Err(error),
        damage => Ok(File {
            format,
            frames,
            damage: damage.map(|error| format!("{error:#}")),
        }),
    })
}

/// The byte order.
#[derive(Clone, Copy, Debug)]
enum Order {
    Little,
    Big,
}

fn pcap<'a>(
    bytes: &'a [u8],
    order: Order,
    ns_per_unit: i128,
    frames: &mut Vec<Frame<'a>>,
) -> anyhow::Result<()> {
    let link = order.long(bytes, 20).context("the header is incomplete")? & LINK_BITS;
    let mut at = 24;
    while at < bytes.len() {
        let head = [0, 4, 8].map(|field| order.long(bytes, at + field));
        let [Some(seconds), Some(units), Some(len)] = head else {
            bail!("byte {at}: the header of a packet is incomplete");
        };
        let begin = at + 16;
        let data = slice(bytes, begin, len).ok_or_else(|| cut(at, len))?;
        let at_ns = i128::from(seconds) * NS_PER_S + i128::from(units) * ns_per_unit;
        frames.push(Frame {
            link,
            at_ns: Some(at_ns),
            data,
        });
        at = begin + data.len();
    }
    Ok(())
}

fn pcapng<'a>(bytes: &'a [u8], frames: &mut Vec<Frame<'a>>) -> anyhow::Result<()> {
    let mut order = Order::Little;
    let mut interfaces: Vec<Interface> = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let kind = order
            .long(bytes, at)
            .with_context(|| format!("byte {at}: a block is incomplete"))?;
        if kind == SECTION {
            order = order_of_section(&bytes[at..])
                .with_context(|| format!("byte {at}: a section has no byte order"))?;
            interfaces.clear();
        }
        let len = order
            .long(bytes, at + 4)
            .with_context(|| format!("byte {at}: a block is incomplete"))?;
        let block = slice(bytes, at, len).filter(|block| block.len() >= 12);
        let block = block.ok_or_else(|| cut(at, len))?;
        let body = &block[8..block.len() - 4];
        handle_block(order, kind, body, &mut interfaces, frames)
            .with_context(|| format!("byte {at}: {}", incomplete(kind)))?;
        at += block.len().next_multiple_of(4);
    }
    Ok(())
}

/// Adds the interface or the packet of a block; `None` if it is incomplete.
fn handle_block<'a>(
    order: Order,
    kind: u32,
    body: &'a [u8],
    interfaces: &mut Vec<Interface>,
    frames: &mut Vec<Frame<'a>>,
) -> Option<()> {
    match kind {
        INTERFACE => interfaces.push(Interface::of(order, body)?),
        PACKET | SIMPLE_PACKET => frames.push(frame(order, interfaces, kind, body)?),
        _ => {}
    }
    Some(())
}

const fn incomplete(kind: u32) -> &'static str {
    match kind {
        INTERFACE => "an interface is incomplete",
        _ => "a packet is incomplete, or its interface does not exist",
    }
}

/// An interface of a pcapng file.
struct Interface {
    link: u32,
    /// Time units per second.
    units_per_s: u128,
    /// The maximum length of packets without their own length; 0 is unlimited.
    longest: u32,
}

impl Interface {
    fn of(order: Order, body: &[u8]) -> Option<Self> {
        let exponent = option(order, body.get(8..)?, TIME_RESOLUTION).unwrap_or(6);
        let units_per_s = if exponent & 0x80 == 0 {
            10_u128.checked_pow(u32::from(exponent))
        } else {
            2_u128.checked_pow(u32::from(exponent & 0x7F))
        };
        Some(Self {
            link: u32::from(order.short(body, 0)?),
            units_per_s: units_per_s?,
            longest: order.long(body, 4)?,
        })
    }

    fn at_ns(&self, high: u32, low: u32) -> Option<i128> {
        let units = (u128::from(high) << 32) | u128::from(low);
        i128::try_from(units * NS_PER_S.unsigned_abs() / self.units_per_s).ok()
    }
}

fn frame<'a>(
    order: Order,
    interfaces: &[Interface],
    kind: u32,
    body: &'a [u8],
) -> Option<Frame<'a>> {
    if kind == SIMPLE_PACKET {
        return simple_frame(order, interfaces.first()?, body);
    }
    let interface = interfaces.get(usize::try_from(order.long(body, 0)?).ok()?)?;
    let at_ns = interface.at_ns(order.long(body, 4)?, order.long(body, 8)?);
    let data = slice(body, 20, order.long(body, 12)?)?;
    Some(Frame {
        link: interface.link,
        at_ns,
        data,
    })
}

fn simple_frame<'a>(order: Order, interface: &Interface, body: &'a [u8]) -> Option<Frame<'a>> {
    let limit = match interface.longest {
        0 => u32::MAX,
        longest => longest,
    };
    let data = slice(body, 4, order.long(body, 0)?.min(limit))?;
    Some(Frame {
        link: interface.link,
        at_ns: None,
        data,
    })
}

fn order_of_section(block: &[u8]) -> Option<Order> {
    match block.get(8..12)? {
        [0x4D, 0x3C, 0x2B, 0x1A] => Some(Order::Little),
        [0x1A, 0x2B, 0x3C, 0x4D] => Some(Order::Big),
        _ => None,
    }
}

/// The first byte of an option.
fn option(order: Order, mut options: &[u8], wanted: u16) -> Option<u8> {
    loop {
        let (code, len) = (
            order.short(options, 0)?,
            usize::from(order.short(options, 2)?),
        );
        if code == wanted && len > 0 {
            return options.get(4).copied();
        }
        options = options.get(4 + len.next_multiple_of(4)..)?;
    }
}

impl Order {
    fn short(self, bytes: &[u8], at: usize) -> Option<u16> {
        let bytes = *bytes.get(at..)?.first_chunk()?;
        Some(match self {
            Self::Little => u16::from_le_bytes(bytes),
            Self::Big => u16::from_be_bytes(bytes),
        })
    }

    fn long(self, bytes: &[u8], at: usize) -> Option<u32> {
        let bytes = *bytes.get(at..)?.first_chunk()?;
        Some(match self {
            Self::Little => u32::from_le_bytes(bytes),
            Self::Big => u32::from_be_bytes(bytes),
        })
    }
}

fn slice(bytes: &[u8], begin: usize, len: u32) -> Option<&[u8]> {
    bytes.get(begin..)?.get(..usize::try_from(len).ok()?)
}

fn cut(at: usize, len: u32) -> anyhow::Error {
    anyhow!("byte {at}: the length is {len} bytes, which exceeds the file or is too small")
}

/// The bits of the link type; the others are the length of a checksum.
const LINK_BITS: u32 = 0x0FFF_FFFF;
const NS_PER_S: i128 = 1_000_000_000;
/// Blocks of a pcapng file.
const SECTION: u32 = 0x0A0D_0D0A;
const INTERFACE: u32 = 1;
const SIMPLE_PACKET: u32 = 3;
const PACKET: u32 = 6;
/// An option of an interface.
const TIME_RESOLUTION: u16 = 9;

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        #[test]
        fn no_bytes_make_it_panic(magic in 0..5_usize, bytes: Vec<u8>) {
            let magics = [
                [0xD4, 0xC3, 0xB2, 0xA1], [0xA1, 0xB2, 0xC3, 0xD4], [0x4D, 0x3C, 0xB2, 0xA1],
                [0xA1, 0xB2, 0x3C, 0x4D], [0x0A, 0x0D, 0x0D, 0x0A],
            ];
            let _ = read(&[&magics[magic][..], &bytes].concat());
        }
    }
}
