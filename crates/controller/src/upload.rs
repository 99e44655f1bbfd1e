//! The schedule of statuses (notes N20 and N38).

use core::time::Duration;

use dobot_arm::TICK;
use dobot_wire::PACKET_LEN;
use heapless::Deque;

use crate::Port;
use crate::log::Log;

/// A status to be sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Upload {
    /// The time of its first byte since power-up: that of a control tick plus the calculation time.
    pub at: Duration,
    /// The packet.
    pub bytes: [u8; PACKET_LEN],
}

/// The queue of statuses not fetched yet.
#[derive(Debug, Default)]
pub(crate) struct Uploads(Deque<Upload, UPLOADS_LEN>);

/// Selects the control ticks that send a status.
#[derive(Debug)]
pub(crate) enum StatusSchedule {
    Usb {
        /// The status period.
        period_ms: u32,
        /// The time with room in the queue since the last status was due.
        with_room_ms: u32,
    },
    Bluetooth {
        /// Ticks since the start of the eight-tick cycle.
        ticks: u8,
    },
}

impl StatusSchedule {
    pub(crate) const fn new(port: Port, period: Duration) -> Self {
        match port {
            Port::Usb => Self::Usb {
                period_ms: period.subsec_millis(),
                with_room_ms: 0,
            },
            Port::Bluetooth => Self::Bluetooth { ticks: 0 },
        }
    }

    pub(crate) const fn period(&self) -> Duration {
        Duration::from_millis(match self {
            Self::Usb { period_ms, .. } => *period_ms as u64,
            Self::Bluetooth { .. } => BLUETOOTH_CYCLE as u64 / 2 * TICK_MS as u64,
        })
    }

    /// The number of coming ticks that send no status, as long as no command waits.
    pub(crate) const fn silent_ticks(&self) -> u32 {
        match self {
            Self::Usb {
                period_ms,
                with_room_ms,
            } => (*period_ms - *with_room_ms - 1) / TICK_MS,
            Self::Bluetooth { .. } => 0,
        }
    }

    /// Runs a tick with `waiting` commands. If a status is due, returns the offset to add to its X.
    pub(crate) const fn tick(&mut self, waiting: usize) -> Option<f32> {
        match self {
            Self::Usb {
                period_ms,
                with_room_ms,
            } => {
                if waiting < STALLS_AT {
                    *with_room_ms += TICK_MS;
                }
                if *with_room_ms < *period_ms {
                    return None;
                }
                *with_room_ms -= *period_ms;
                Some(0.0)
            }
            Self::Bluetooth { ticks } => {
                *ticks = *ticks % BLUETOOTH_CYCLE + 1;
                match *ticks {
                    1 | 5 => Some(NO_PERMIT_MM),
                    3 if waiting < FULL_AT => Some(0.0),
                    _ => None,
                }
            }
        }
    }
}

impl Uploads {
    /// Queues a status; drops the oldest if the queue is full.
    pub(crate) fn push(&mut self, upload: Upload, log: &mut Log) {
        log.counters.statuses += 1;
        if self.0.is_full() {
            self.0.pop_front();
            log.counters.lost_statuses += 1;
        }
        self.0
            .push_back(upload)
            .expect("an entry was removed above");
    }

    pub(crate) fn pop(&mut self) -> Option<Upload> {
        self.0.pop_front()
    }
}

const TICK_MS: u32 = TICK.subsec_millis();
/// From this number of waiting commands on, no status is sent (note N20).
const STALLS_AT: usize = 4;
/// From this number of waiting commands on, no status over Bluetooth permits another (note N38).
const FULL_AT: usize = 6;
const BLUETOOTH_CYCLE: u8 = 8;
/// The X offset of a status over Bluetooth that permits no command (note N38).
const NO_PERMIT_MM: f32 = 1000.0;
/// The capacity for statuses: more than a second.
const UPLOADS_LEN: usize = 32;
