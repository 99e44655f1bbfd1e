//! The engine: receive buffer, queue, ticks and statuses.

use core::time::Duration;

use dobot_arm::{Joints, Pose, Tool, Unreachable};
use dobot_wire::{Command, Commands, Decoder, Dialect, PACKET_LEN, Packet};
use heapless::Deque;

use crate::jog::{Button, Jog};
use crate::motion::{Motion, Running, Then};
use crate::plan::{Plan, check_way, plan};
use crate::refused::QUEUE_LEN;
use crate::settings::Settings;
use crate::state::{Place, State};
use crate::{PowerUp, Refused};

/// The controller of an arm, as an engine: it owns no port, no thread and no clock.
///
/// Things happen to it (`handle_*`), it wants things (`poll_*`), and [`Controller::poll_wakeup`]
/// says when it next needs the time, which counts from power-up and never goes back. Who calls
/// [`Controller::handle_time`] later than that gets all the same results, but has to fetch the
/// statuses at least every second, else the oldest are lost.
#[derive(Debug)]
pub struct Controller {
    dialect: Dialect,
    decoder: Decoder<Commands>,
    queue: Deque<Command, QUEUE_LEN>,
    state: State,
    settings: Settings,
    running: Option<Running>,
    /// The number of the next control tick.
    tick: u32,
    /// Ticks since the last status in which the queue had room.
    ticks_with_room: u8,
    uploads: Deque<[u8; PACKET_LEN], UPLOADS_LEN>,
    refusals: Deque<Refused, REFUSALS_LEN>,
    counters: Counters,
}

/// What a controller has counted since power-up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Packets received whole, voice included.
    pub packets: u64,
    /// Bytes received that belong to no packet.
    pub skipped_bytes: u64,
    /// Commands that were begun.
    pub begun: u64,
    /// Packets and commands refused, for whatever reason.
    pub refused: u64,
    /// Statuses sent.
    pub statuses: u64,
    /// Statuses lost because nobody fetched them.
    pub lost_statuses: u64,
}

impl Controller {
    /// Switches a controller on.
    #[must_use]
    pub fn power_up(power_up: PowerUp) -> Self {
        let tool = Tool::SuctionCup;
        let joints = Joints::new(0.0, power_up.rear_deg, power_up.fore_deg, 0.0);
        Self {
            dialect: power_up.dialect,
            decoder: Decoder::commands(),
            queue: Deque::new(),
            state: State {
                place: Place::at_joints(joints, tool),
                tool,
                suction: false,
                laser: false,
                gripper_deg: 0.0,
                write_speed_mm_s: 0.0,
            },
            settings: Settings::new(&power_up.dialect),
            running: None,
            tick: 0,
            ticks_with_room: 0,
            uploads: Deque::new(),
            refusals: Deque::new(),
            counters: Counters::default(),
        }
    }

    /// Takes bytes from the client, the last of which arrives at `now`. What they say is done from
    /// the next tick on.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        // The iterator borrows the decoder, which is given back with its new lock.
        let mut decoder = core::mem::replace(&mut self.decoder, Decoder::commands());
        for packet in decoder.feed(bytes) {
            self.handle_packet(&packet);
        }
        self.counters.skipped_bytes = decoder.counts().skipped_bytes;
        self.decoder = decoder;
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        loop {
            let at = self.poll_wakeup();
            if at > now {
                return;
            }
            if self.running.as_ref().is_some_and(|it| it.ends <= at) {
                self.finish(at);
                self.begin_next(at);
            }
            if self.next_tick() <= at {
                self.tick(at);
            }
        }
    }

    /// The status to send now, if one is due.
    pub fn poll_bytes(&mut self) -> Option<[u8; PACKET_LEN]> {
        self.uploads.pop_front()
    }

    /// What was refused, the oldest first; only the last few are kept.
    pub fn poll_refused(&mut self) -> Option<Refused> {
        self.refusals.pop_front()
    }

    /// When [`Controller::handle_time`] wants to be called next.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        let tick = self.next_tick();
        self.running.as_ref().map_or(tick, |it| it.ends.min(tick))
    }

    /// Where the tool is at a time between now and the next wakeup.
    #[must_use]
    pub fn pose_at(&self, at: Duration) -> Pose {
        self.place_at(at).pose
    }

    /// The joint angles at a time between now and the next wakeup.
    #[must_use]
    pub fn joints_at(&self, at: Duration) -> Joints {
        self.place_at(at).joints
    }

    /// Whether the suction cup's pump runs.
    #[must_use]
    pub const fn suction(&self) -> bool {
        self.state.suction
    }

    /// Whether the laser is on.
    #[must_use]
    pub const fn laser(&self) -> bool {
        self.state.laser
    }

    /// What it has counted.
    #[must_use]
    pub const fn counters(&self) -> &Counters {
        &self.counters
    }

    fn next_tick(&self) -> Duration {
        TICK * self.tick
    }

    fn place_at(&self, at: Duration) -> Place {
        self.running
            .as_ref()
            .and_then(|it| it.place_at(at, self.state.tool))
            .and_then(Result::ok)
            .unwrap_or(self.state.place)
    }

    fn handle_packet(&mut self, packet: &Packet) {
        self.counters.packets += 1;
        match Command::parse(packet, &self.dialect) {
            Err(error) => self.refuse(Refused::Unreadable(error)),
            Ok(command) => {
                if self.queue.push_back(command).is_err() {
                    self.refuse(Refused::QueueFull);
                }
            }
        }
    }

    fn tick(&mut self, at: Duration) {
        self.tick += 1;
        self.settle(at);
        self.obey_buttons(at);
        self.guard(at);
        if self.running.is_none() {
            self.begin_next(at);
        }
        if self.queue.len() < STALLS_AT {
            self.ticks_with_room += 1;
        }
        if self.ticks_with_room == TICKS_PER_STATUS {
            self.ticks_with_room = 0;
            self.upload();
        }
    }

    fn upload(&mut self) {
        self.counters.statuses += 1;
        if self.uploads.is_full() {
            self.uploads.pop_front();
            self.counters.lost_statuses += 1;
        }
        let packet = self.state.status().emit().to_bytes();
        self.uploads
            .push_back(packet)
            .expect("room was made just above");
    }

    /// Brings the state to where the motion has come.
    fn settle(&mut self, at: Duration) {
        self.state.place = self.place_at(at);
        if let Some(Running {
            motion: Motion::Jog(jog),
            began,
            ..
        }) = &self.running
        {
            self.state.gripper_deg = jog.gripper_deg_at(at.saturating_sub(*began).as_secs_f64());
        }
    }

    fn finish(&mut self, at: Duration) {
        self.settle(at);
        let Some(running) = self.running.take() else {
            return;
        };
        match running.then {
            Then::Nothing => {}
            Then::EndStroke { speed_mm_s } => {
                self.state.write_speed_mm_s = speed_mm_s;
                if !matches!(self.queue.front(), Some(Command::WriteVector(_))) {
                    self.state.laser = false;
                }
            }
            Then::SetTool {
                suction,
                gripper_deg,
                pause,
            } => {
                self.state.suction = suction;
                self.state.gripper_deg = gripper_deg;
                if pause > Duration::ZERO {
                    self.run(Motion::Pause, at, pause, Then::Nothing);
                }
            }
        }
    }

    /// Begins what waits: commands without motion one after the other, up to one that moves.
    fn begin_next(&mut self, at: Duration) {
        while self.running.is_none()
            && let Some(command) = self.queue.pop_front()
        {
            if let Err(refused) = self.begin(&command, at) {
                self.state.laser = false;
                self.refuse(refused);
            }
        }
    }

    fn begin(&mut self, command: &Command, at: Duration) -> Result<(), Refused> {
        match plan(command, &self.state, &self.settings, &self.dialect)? {
            Plan::Settings(settings) => self.settings = settings,
            Plan::State(state) => self.state = state,
            Plan::Move {
                motion,
                then,
                suction,
                laser,
            } => {
                let duration_s = motion.duration_s();
                if let Some(duration_s) = duration_s {
                    check_way(&motion, duration_s, &self.state)?;
                }
                self.state.suction = suction.unwrap_or(self.state.suction);
                self.state.laser = laser.unwrap_or(self.state.laser);
                let duration = duration_s.and_then(|it| Duration::try_from_secs_f64(it).ok());
                self.run(motion, at, duration.unwrap_or(Duration::MAX), then);
            }
        }
        self.counters.begun += 1;
        self.guard(at);
        Ok(())
    }

    fn run(&mut self, motion: Motion, began: Duration, lasts: Duration, then: Then) {
        self.running = Some(Running {
            motion,
            began,
            ends: began.saturating_add(lasts),
            then,
            ahead: None,
        });
    }

    /// While the arm jogs, buttons act at once; any other command waits until it has come to rest.
    fn obey_buttons(&mut self, at: Duration) {
        while let Some(Running {
            motion: Motion::Jog(jog),
            began,
            ends,
            ..
        }) = self.running
            && let Some(command) = self.queue.front()
        {
            let t_s = at.saturating_sub(began).as_secs_f64();
            let next = match button(command) {
                Some(Button::Suction(on)) => {
                    self.state.suction = on;
                    Next::Go
                }
                Some(Button::Laser(on)) => {
                    self.state.laser = on;
                    Next::Go
                }
                Some(Button::Held { axis, share }) if axis == jog.axis => {
                    let speed = jog.ramp.speed_at(t_s);
                    Jog::start(&self.state, &self.settings, axis, share, speed)
                        .map_or(Next::Go, |jog| Next::Jog(jog, Duration::MAX))
                }
                Some(Button::Released) => self.released(&jog, t_s),
                // Anything else stays in the queue until the jog has run down.
                _ if ends == Duration::MAX => {
                    if let Next::Jog(jog, lasts) = self.released(&jog, t_s) {
                        self.run(Motion::Jog(jog), at, lasts, Then::Nothing);
                    }
                    return;
                }
                _ => return,
            };
            self.queue.pop_front();
            self.counters.begun += 1;
            if let Next::Jog(jog, lasts) = next {
                self.run(Motion::Jog(jog), at, lasts, Then::Nothing);
            }
        }
    }

    fn released(&self, jog: &Jog, t_s: f64) -> Next {
        jog.release(&self.state, t_s).map_or(Next::Go, |jog| {
            let lasts = Duration::try_from_secs_f64(jog.ramp.change_s());
            Next::Jog(jog, lasts.unwrap_or_default())
        })
    }

    /// Stops a jog that would be beyond a limit one tick later. An arm that stands outside of the
    /// limits may be jogged back in.
    fn guard(&mut self, at: Duration) {
        let Some(running) = &self.running else {
            return;
        };
        let Motion::Jog(jog) = running.motion else {
            return;
        };
        let next = running.ends.min(at + TICK);
        match self.look_ahead(&jog, next.saturating_sub(running.began)) {
            Err(refused) => {
                self.running = None;
                self.refuse(refused);
            }
            Ok(place) => {
                let running = self.running.as_mut();
                running.expect("it was seen just above").ahead = place.map(|it| (next, it));
            }
        }
    }

    /// Where a jog leads, if it moves the arm, and the arm may go there.
    fn look_ahead(&self, jog: &Jog, time: Duration) -> Result<Option<Place>, Refused> {
        let t_s = time.as_secs_f64();
        let gripper_deg = jog.gripper_deg_at(t_s);
        if gripper_deg.abs() > GRIPPER_DEG && gripper_deg.abs() > self.state.gripper_deg.abs() {
            return Err(Refused::GripperAtLimit { found: gripper_deg });
        }
        let Some(ahead) = jog.place_at(t_s, self.state.tool) else {
            return Ok(None);
        };
        let Err(error) = ahead.and_then(|place| place.check()) else {
            return Ok(ahead.ok());
        };
        let returning = |now: Unreachable| error.excess() < now.excess();
        if self.state.place.check().is_err_and(returning) {
            return Ok(ahead.ok());
        }
        Err(Refused::AtLimit(error))
    }

    fn refuse(&mut self, refused: Refused) {
        self.counters.refused += 1;
        if self.refusals.is_full() {
            self.refusals.pop_front();
        }
        self.refusals
            .push_back(refused)
            .expect("room was made just above");
    }
}

/// What a button leads to while the arm jogs.
enum Next {
    /// The jog goes on.
    Go,
    /// Another one, for so long.
    Jog(Jog, Duration),
}

fn button(command: &Command) -> Option<Button> {
    match command {
        Command::JointJog(jog) => Some(Button::of_joint(*jog)),
        Command::LinearJog(jog) => Some(Button::of_linear(*jog)),
        _ => None,
    }
}

/// The control tick (note N27).
const TICK: Duration = Duration::from_millis(20);
/// A status comes every 80 ms (note N20).
const TICKS_PER_STATUS: u8 = 4;
/// With that many commands waiting no status is sent (note N20).
const STALLS_AT: usize = 4;
/// Beyond the last of them statuses are lost: more than a second's worth.
const UPLOADS_LEN: usize = 16;
const REFUSALS_LEN: usize = 8;
/// Table 3.7.
const GRIPPER_DEG: f64 = 90.0;
