//! A virtual arm at a real pseudo-terminal, and the arrival times of packets.

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::os::unix::fs::OpenOptionsExt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_sim::{SerialLine, VirtualArm};
use dobot_wire::{Decoder, PACKET_LEN, Packet, Status};
use rustix::fs::OFlags;
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, speed, tcgetattr, tcsetattr};

/// A packet at the end of the serial port.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arrival {
    pub(crate) at: Instant,
    pub(crate) packet: [u8; PACKET_LEN],
}

/// A serial port whose other end is held here.
#[derive(Debug)]
pub(crate) struct Port {
    pub(crate) path: String,
    /// The arriving packets.
    pub(crate) arrivals: Receiver<Arrival>,
    /// The other end.
    master: File,
    /// Keeps the port open when other programs close it.
    _open: File,
}

/// A virtual arm at such a port.
#[derive(Debug)]
pub(crate) struct Arm {
    pub(crate) port: Port,
}

/// An arm at rest that counts its statuses: each has its number as the gripper angle.
#[derive(Debug)]
pub(crate) struct CountingArm {
    pub(crate) port: Port,
    over: Arc<AtomicBool>,
    thread: JoinHandle<Vec<Instant>>,
}

impl CountingArm {
    /// Starts an arm with a status every 80 ms.
    pub(crate) fn start() -> Self {
        let port = Port::open(None);
        let mut writer = port.master.try_clone().expect("there are descriptors left");
        let over = Arc::new(AtomicBool::new(false));
        let until = over.clone();
        let mut status = at_rest();
        let thread = std::thread::spawn(move || {
            let began = Instant::now();
            let mut sent = Vec::new();
            for number in 0_u16.. {
                let due = began + PERIOD * u32::from(number);
                std::thread::sleep(due.saturating_duration_since(Instant::now()));
                if until.load(Ordering::Relaxed) {
                    break;
                }
                status.gripper_deg = number.into();
                let packet = Packet::from(status.emit()).to_bytes();
                sent.push(Instant::now());
                writer.write_all(&packet).expect("the port is there");
            }
            sent
        });
        Self { port, over, thread }
    }

    /// Ends it; returns the sending times of its statuses.
    pub(crate) fn end(self) -> Vec<Instant> {
        self.over.store(true, Ordering::Relaxed);
        self.thread.join().expect("nobody panics")
    }
}

/// The status of a virtual arm after power-up.
fn at_rest() -> Status {
    let controller = Controller::power_up(PowerUp::new(Personality::default()));
    let mut arm = VirtualArm::new(controller, SerialLine::STOCK);
    let mut bytes = Vec::new();
    arm.handle_time(Duration::from_secs(5));
    arm.poll_bytes(&mut bytes);
    let mut decoder = Decoder::statuses(|_| true);
    let frame = decoder.feed(&bytes).last().expect("it has sent a packet");
    Status::parse(&frame).expect("it sends statuses")
}

impl Port {
    /// Opens a port; packets are also forwarded to `also`.
    pub(crate) fn open(also: Option<Sender<[u8; PACKET_LEN]>>) -> Self {
        let (master, path, open) = pair().expect("the system has a pseudo-terminal left");
        let (sender, arrivals) = channel();
        let mut reader = master.try_clone().expect("there are descriptors left");
        std::thread::spawn(move || {
            let mut packet = [0; PACKET_LEN];
            while reader.read_exact(&mut packet).is_ok() {
                let at = Instant::now();
                if let Some(also) = &also {
                    let _ = also.send(packet);
                }
                if sender.send(Arrival { at, packet }).is_err() {
                    break;
                }
            }
        });
        Self {
            path,
            arrivals,
            master,
            _open: open,
        }
    }

    /// Returns the arrival time of this packet.
    pub(crate) fn arrival_of(&self, packet: &[u8; PACKET_LEN]) -> Option<Instant> {
        let until = Instant::now() + PATIENCE;
        loop {
            let left = until.saturating_duration_since(Instant::now());
            let arrival = self.arrivals.recv_timeout(left).ok()?;
            if arrival.packet == *packet {
                return Some(arrival.at);
            }
        }
    }

    /// Drops the packets that have arrived so far.
    pub(crate) fn forget(&self) {
        while self.arrivals.try_recv().is_ok() {}
    }
}

impl Arm {
    /// Starts a virtual arm in real time.
    pub(crate) fn start(personality: Personality) -> Self {
        let (sender, packets) = channel();
        let port = Port::open(Some(sender));
        let writer = port.master.try_clone().expect("there are descriptors left");
        let controller = Controller::power_up(PowerUp::new(personality));
        let arm = VirtualArm::new(controller, SerialLine::STOCK);
        std::thread::spawn(move || live(arm, &packets, writer));
        Self { port }
    }
}

/// Advances an arm in real time. A status is written in one piece, as by USB chips.
fn live(mut arm: VirtualArm, packets: &Receiver<[u8; PACKET_LEN]>, mut writer: File) {
    let began = Instant::now();
    let mut bytes = Vec::new();
    loop {
        let until = arm.poll_wakeup().saturating_sub(began.elapsed());
        match packets.recv_timeout(until.max(SHORTEST)) {
            Ok(packet) => arm.handle_bytes(began.elapsed(), &packet),
            Err(RecvTimeoutError::Timeout) => arm.handle_time(began.elapsed()),
            Err(RecvTimeoutError::Disconnected) => return,
        }
        arm.poll_bytes(&mut bytes);
        let whole = bytes.len() - bytes.len() % PACKET_LEN;
        if writer.write_all(&bytes[..whole]).is_err() {
            return;
        }
        bytes.drain(..whole);
    }
}

fn pair() -> std::io::Result<(File, String, File)> {
    let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
    grantpt(&master)?;
    unlockpt(&master)?;
    let path = ptsname(&master, Vec::new())?;
    let path = path.into_string().map_err(std::io::Error::other)?;
    let open = OpenOptions::new()
        .read(true)
        .write(true)
        .custom_flags(OFlags::NOCTTY.bits().cast_signed())
        .open(&path)?;
    let mut settings = tcgetattr(&open)?;
    settings.make_raw();
    settings.set_speed(speed::B9600)?;
    tcsetattr(&open, OptionalActions::Now, &settings)?;
    Ok((master.into(), path, open))
}

/// The time after which a packet is considered lost.
const PATIENCE: Duration = Duration::from_secs(3);
const SHORTEST: Duration = Duration::from_millis(1);
/// The status period of a stock arm.
const PERIOD: Duration = Duration::from_millis(80);
