//! The serial line with its transmission time.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_wire::PACKET_LEN;

/// One direction of a serial line.
///
/// Each byte takes its transmission time. Up to 4096 bytes are buffered, as by the serial port of a
/// computer; further bytes are lost and counted.
#[derive(Clone, Debug)]
pub struct SerialLine {
    byte_time: Duration,
    /// The arrival time of the last byte sent.
    busy_until: Duration,
    bytes: VecDeque<u8>,
    bursts: VecDeque<Burst>,
    lost: u64,
}

/// The unreceived bytes of one `send`.
#[derive(Clone, Copy, Debug)]
struct Burst {
    /// The arrival time of the first.
    arrives: Duration,
    len: usize,
}

impl SerialLine {
    /// The line of a stock arm: nominally 9600 baud, 1.04 ms per byte and 43.68 ms per packet (note
    /// N26).
    pub const STOCK: Self = Self::new(STOCK_BYTE_TIME);

    /// Creates a line with this time per byte.
    #[must_use]
    pub const fn new(byte_time: Duration) -> Self {
        Self {
            byte_time,
            busy_until: Duration::ZERO,
            bytes: VecDeque::new(),
            bursts: VecDeque::new(),
            lost: 0,
        }
    }

    /// Sends bytes after those still on the line.
    pub fn send(&mut self, now: Duration, bytes: &[u8]) {
        let (bytes, lost) = bytes.split_at(bytes.len().min(CAPACITY - self.bytes.len()));
        self.lost += lost.len() as u64;
        if bytes.is_empty() {
            return;
        }
        let begins = self.busy_until.max(now);
        self.bytes.extend(bytes);
        self.bursts.push_back(Burst {
            arrives: begins + self.byte_time,
            len: bytes.len(),
        });
        self.busy_until = begins + self.byte_times(bytes.len());
    }

    /// The time at which the earliest burst on the line has arrived completely.
    #[must_use]
    pub fn next_burst(&self) -> Option<Duration> {
        let burst = self.bursts.front()?;
        Some(burst.arrives + self.byte_times(burst.len - 1))
    }

    /// Takes the bytes received by `now`, with the time of the last.
    pub fn receive(&mut self, now: Duration, bytes: &mut Vec<u8>) -> Option<Duration> {
        let mut last = None;
        while let Some(&burst) = self.bursts.front()
            && let end = burst.arrives + self.byte_times(burst.len - 1)
            && end <= now
        {
            self.bursts.pop_front();
            bytes.extend(self.bytes.drain(..burst.len));
            last = Some(end);
        }
        while let Some((arrival, byte)) = self.pop(now) {
            bytes.push(byte);
            last = Some(arrival);
        }
        last
    }

    /// The arrival time of the next byte on the line.
    pub(crate) fn next_byte(&self) -> Option<Duration> {
        self.bursts.front().map(|it| it.arrives)
    }

    /// Takes the next byte received by `now`, with its time.
    pub(crate) fn pop(&mut self, now: Duration) -> Option<(Duration, u8)> {
        let burst = self.bursts.front_mut()?;
        let arrival = burst.arrives;
        if arrival > now {
            return None;
        }
        burst.arrives += self.byte_time;
        burst.len -= 1;
        if burst.len == 0 {
            self.bursts.pop_front();
        }
        self.bytes.pop_front().map(|byte| (arrival, byte))
    }

    /// Discards the bytes still on the line.
    pub(crate) fn cut(&mut self, now: Duration) {
        self.bytes.clear();
        self.bursts.clear();
        self.busy_until = self.busy_until.min(now);
    }

    /// The transmission time of a packet.
    pub(crate) fn packet_time(&self) -> Duration {
        self.byte_times(PACKET_LEN)
    }

    fn byte_times(&self, count: usize) -> Duration {
        self.byte_time * u32::try_from(count).expect("the line holds less")
    }

    /// The number of bytes lost because the buffer was full.
    #[must_use]
    pub const fn lost(&self) -> u64 {
        self.lost
    }
}

/// The transmission time of a byte on the line of a stock arm (note N26).
pub(crate) const STOCK_BYTE_TIME: Duration = Duration::from_micros(1040);
/// The kernel buffer of a serial port.
const CAPACITY: usize = 4096;

#[cfg(test)]
mod tests {
    use super::*;

    const fn us(us: u64) -> Duration {
        Duration::from_micros(us)
    }

    #[test]
    fn a_packet_takes_43_68_ms() {
        let mut line = SerialLine::STOCK;
        line.send(us(1000), &[0xA5; 42]);
        assert_eq!(line.next_burst(), Some(us(1000 + 43_680)));
    }

    #[test]
    fn bytes_arrive_one_by_one_and_bursts_queue_up_behind_each_other() {
        let mut line = SerialLine::new(us(100));
        line.send(us(0), &[1, 2]);
        line.send(us(50), &[3]);
        let mut bytes = Vec::new();
        assert_eq!(line.receive(us(99), &mut bytes), None);
        assert_eq!(line.receive(us(150), &mut bytes), Some(us(100)));
        assert_eq!(bytes, [1]);
        assert_eq!(line.next_burst(), Some(us(200)));
        assert_eq!(line.receive(us(300), &mut bytes), Some(us(300)));
        assert_eq!(bytes, [1, 2, 3]);
        assert_eq!(line.next_burst(), None);
    }

    #[test]
    fn more_than_4096_waiting_bytes_are_lost_and_counted() {
        let mut line = SerialLine::new(us(1));
        line.send(us(0), &[1; 4000]);
        line.send(us(0), &[2; 100]);
        assert_eq!(line.lost(), 4);
        let mut bytes = Vec::new();
        line.receive(us(4096), &mut bytes);
        assert_eq!(bytes.len(), 4096);
        line.send(us(5000), &[3]);
        assert_eq!(line.lost(), 4);
        assert_eq!(line.next_burst(), Some(us(5001)));
    }

    #[test]
    fn what_is_under_way_when_the_sender_falls_silent_never_arrives() {
        let mut line = SerialLine::new(us(100));
        line.send(us(0), &[1, 2, 3]);
        assert_eq!(line.pop(us(150)), Some((us(100), 1)));
        line.cut(us(150));
        assert_eq!(line.next_burst(), None);
        line.send(us(160), &[4]);
        assert_eq!(line.pop(us(1000)), Some((us(260), 4)));
    }

    #[test]
    fn nothing_sent_is_no_burst() {
        let mut line = SerialLine::STOCK;
        line.send(us(0), &[]);
        assert_eq!(line.next_burst(), None);
    }
}
