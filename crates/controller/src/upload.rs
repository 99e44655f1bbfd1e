//! When a status is sent (notes N20 and N38).

use core::time::Duration;

use dobot_arm::TICK;
use dobot_wire::PACKET_LEN;
use heapless::Deque;

use crate::Port;
use crate::log::Log;

/// A status on its way out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Upload {
    /// When its first byte leaves, since power-up: at a control tick, or as much later as the
    /// program calculates.
    pub at: Duration,
    /// The packet.
    pub bytes: [u8; PACKET_LEN],
}

/// Statuses that were sent and not yet fetched.
#[derive(Debug, Default)]
pub(crate) struct Uploads(Deque<Upload, UPLOADS_LEN>);

/// Which control ticks send a status.
#[derive(Debug)]
pub(crate) enum StatusSchedule {
    Usb {
        /// From one status to the next.
        period_ms: u32,
        /// For how long the queue had room since the last status was due.
        with_room_ms: u32,
    },
    Bluetooth {
        /// Ticks since the cycle of eight began.
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

    /// How many ticks from now on send nothing, as long as nothing waits.
    pub(crate) const fn silent_ticks(&self) -> u32 {
        match self {
            Self::Usb {
                period_ms,
                with_room_ms,
            } => (*period_ms - *with_room_ms - 1) / TICK_MS,
            Self::Bluetooth { .. } => 0,
        }
    }

    /// Takes another tick, in which so many commands wait. If a status is due, returns what is to be
    /// added to its X.
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
    /// Queues a status to be fetched; the oldest is lost where there is no room.
    pub(crate) fn push(&mut self, upload: Upload, log: &mut Log) {
        log.counters.statuses += 1;
        if self.0.is_full() {
            self.0.pop_front();
            log.counters.lost_statuses += 1;
        }
        self.0.push_back(upload).expect("room was made just above");
    }

    pub(crate) fn pop(&mut self) -> Option<Upload> {
        self.0.pop_front()
    }
}

const TICK_MS: u32 = TICK.subsec_millis();
/// With that many commands waiting no status is sent (note N20).
const STALLS_AT: usize = 4;
/// With that many commands waiting no status over Bluetooth permits another one (note N38).
const FULL_AT: usize = 6;
const BLUETOOTH_CYCLE: u8 = 8;
/// What is added to the X of a status over Bluetooth that permits no command (note N38).
const NO_PERMIT_MM: f32 = 1000.0;
/// Beyond the last of them statuses are lost: more than a second's worth.
const UPLOADS_LEN: usize = 32;
