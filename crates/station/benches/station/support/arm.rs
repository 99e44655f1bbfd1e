//! A virtual arm at a real pseudo-terminal, and when each packet arrived there.

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
    /// What arrives.
    pub(crate) arrivals: Receiver<Arrival>,
    /// The other end.
    master: File,
    /// While one program has the port open, nothing ends when another one closes it.
    _open: File,
}

/// A virtual arm at such a port.
#[derive(Debug)]
pub(crate) struct Arm {
    pub(crate) port: Port,
}

/// An arm at rest that counts its statuses: each tells its number as the angle of its gripper.
#[derive(Debug)]
pub(crate) struct CountingArm {
    pub(crate) port: Port,
    over: Arc<AtomicBool>,
    thread: JoinHandle<Vec<Instant>>,
}

impl CountingArm {
    /// An arm with a status every 80 ms.
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

    /// Ends it; when it sent which status.
    pub(crate) fn end(self) -> Vec<Instant> {
        self.over.store(true, Ordering::Relaxed);
        self.thread.join().expect("nobody panics")
    }
}

/// Where a virtual arm stands when it has been switched on.
fn at_rest() -> Status {
    let controller = Controller::power_up(PowerUp::new(Personality::default()));
    let mut arm = VirtualArm::new(controller, SerialLine::STOCK);
    let mut bytes = Vec::new();
    arm.handle_time(Duration::from_secs(5));
    arm.poll_bytes(&mut bytes);
    let mut decoder = Decoder::statuses(|_| true);
    let frame = decoder.feed(&bytes).last().expect("it has told something");
    Status::parse(&frame).expect("it tells statuses")
}

impl Port {
    /// Opens a port; what arrives is also passed on to `also`.
    pub(crate) fn open(also: Option<Sender<[u8; PACKET_LEN]>>) -> Self {
        let (master, path, open) = pair().expect("the system has a pseudo-terminal left");
        let (tell, arrivals) = channel();
        let mut reader = master.try_clone().expect("there are descriptors left");
        std::thread::spawn(move || {
            let mut packet = [0; PACKET_LEN];
            while reader.read_exact(&mut packet).is_ok() {
                let at = Instant::now();
                if let Some(also) = &also {
                    let _ = also.send(packet);
                }
                if tell.send(Arrival { at, packet }).is_err() {
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

    /// When this very packet arrived.
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

    /// Forgets what has arrived so far.
    pub(crate) fn forget(&self) {
        while self.arrivals.try_recv().is_ok() {}
    }
}

impl Arm {
    /// A virtual arm in real time.
    pub(crate) fn start(personality: Personality) -> Self {
        let (tell, packets) = channel();
        let port = Port::open(Some(tell));
        let writer = port.master.try_clone().expect("there are descriptors left");
        let controller = Controller::power_up(PowerUp::new(personality));
        let arm = VirtualArm::new(controller, SerialLine::STOCK);
        std::thread::spawn(move || live(arm, &packets, writer));
        Self { port }
    }
}

/// Lets time pass for an arm. A status leaves in one piece, as USB chips pass them on.
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

/// What is not there by then does not come.
const PATIENCE: Duration = Duration::from_secs(3);
const SHORTEST: Duration = Duration::from_millis(1);
/// As a stock arm's.
const PERIOD: Duration = Duration::from_millis(80);
