//! The fault engine: active faults and their targets.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_geometry::Random;

use super::when::{FaultEnd, FaultMoment};
use super::{Amount, Damage, Fault, FaultEffect, FaultKind, Struck, Tilt};
use crate::{Joint, Mechanics, SerialLine};

/// All faults of a virtual arm, as an engine.
///
/// Bytes and pulses are processed one by one at their time of arrival, so time steps and chunk sizes
/// do not matter.
#[derive(Debug)]
pub(crate) struct FaultSchedule {
    entries: Vec<ScheduledFault>,
    /// Processed bytes to be fetched, in either direction.
    judged: [VecDeque<(Duration, u8)>; 2],
    orders: VecDeque<ArmOrder>,
    struck: VecDeque<Struck>,
}

/// The direction of bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineDirection {
    ToArm,
    FromArm,
}

/// An action on the whole arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ArmOrder {
    ClosePort,
    AllowPort,
    Reset(Tilt),
    PowerOff(Tilt),
    PowerOn,
}

/// The counters of all controllers since the first power-up.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counted {
    pub(crate) packets: u64,
    pub(crate) statuses: u64,
}

/// A fault and its progress.
#[derive(Debug)]
struct ScheduledFault {
    fault: Fault,
    phase: Phase,
    /// The remaining number of bytes, in either direction, or pulses to hit.
    left: [u32; 2],
    hits: u64,
    random: [Random; 2],
    delay: [Duration; 2],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Waiting,
    Acting { until: Option<FaultMoment> },
    Over,
}

impl FaultSchedule {
    /// Prepares faults; the same faults with the same seed have the same effect.
    pub(crate) fn new(faults: &[Fault], seed: u64) -> Self {
        let entry = |(number, &fault)| ScheduledFault::new(fault, seed, number);
        Self {
            entries: (0..).zip(faults).map(entry).collect(),
            judged: [VecDeque::new(), VecDeque::new()],
            orders: VecDeque::new(),
            struck: VecDeque::new(),
        }
    }

    /// Ends all active faults.
    pub(crate) fn end_all(&mut self, now: Duration) {
        for number in 0..self.entries.len() {
            if self.entries[number].acts() {
                self.end(number, now);
            }
        }
    }

    /// Replaces the faults; processed bytes are kept.
    pub(crate) fn replace(&mut self, faults: &[Fault], seed: u64) {
        self.entries = Self::new(faults, seed).entries;
    }

    /// Sets the backlash of the joints; 0 for joints without a fault.
    pub(crate) fn fit_backlash(&self, machine: &mut Mechanics) {
        let joints = [Joint::Base, Joint::Rear, Joint::Fore, Joint::Servo];
        for joint in joints {
            machine.set_backlash(joint, 0.0);
        }
        for entry in &self.entries {
            if let FaultKind::Backlash { joint, deg } = entry.fault.kind {
                machine.set_backlash(joint, deg);
            }
        }
    }

    /// Applies backlash and zero errors to the joints and returns the offset of each from the
    /// controller's estimate.
    pub(crate) fn fit(&self, machine: &mut Mechanics) -> [f64; 4] {
        self.fit_backlash(machine);
        let mut zeros_deg = [0.0; 4];
        for entry in &self.entries {
            if let FaultKind::Zero { joint, deg } = entry.fault.kind {
                zeros_deg[joint as usize] += deg;
            }
        }
        machine.set_zeros(zeros_deg);
        zeros_deg
    }

    /// Advances to `now` with the current counters.
    pub(crate) fn handle_time(&mut self, now: Duration, counted: Counted) {
        let reached = |moment| match moment {
            FaultMoment::Time(at) => at <= now,
            FaultMoment::Packet(number) => counted.packets >= number,
            FaultMoment::Status(number) => counted.statuses >= number,
            FaultMoment::Open => false,
        };
        for number in 0..self.entries.len() {
            if self.entries[number].phase == Phase::Waiting
                && reached(self.entries[number].fault.when.begin)
            {
                self.begin(number, now);
            }
            if let Phase::Acting { until: Some(end) } = self.entries[number].phase
                && reached(end)
            {
                self.end(number, now);
            }
        }
    }

    /// Handles the opening of the port by a client.
    pub(crate) fn handle_open(&mut self, now: Duration) {
        for number in 0..self.entries.len() {
            if self.entries[number].fault.when.begin == FaultMoment::Open {
                self.begin(number, now);
            }
        }
    }

    /// The next time at which a timed fault begins or ends.
    pub(crate) fn poll_wakeup(&self) -> Duration {
        let next = self
            .entries
            .iter()
            .filter_map(ScheduledFault::next_time)
            .min();
        next.unwrap_or(Duration::MAX)
    }

    /// Takes the next action on the arm.
    pub(crate) fn poll_order(&mut self) -> Option<ArmOrder> {
        self.orders.pop_front()
    }

    /// Takes the next fault event; only the last few are kept.
    pub(crate) fn poll_struck(&mut self) -> Option<Struck> {
        self.struck.pop_front()
    }

    /// Whether statuses are withheld.
    pub(crate) fn withholds(&self) -> bool {
        let withholds = |it: &ScheduledFault| it.fault.kind == FaultKind::Withhold && it.acts();
        self.entries.iter().any(withholds)
    }

    /// Processes the bytes received at the ends of both lines in order of arrival. Bytes from the arm
    /// are lost without a port.
    pub(crate) fn judge(&mut self, lines: [&mut SerialLine; 2], by: Duration, has_port: bool) {
        let [to_arm, from_arm] = lines;
        loop {
            let next = [to_arm.next_byte(), from_arm.next_byte()];
            let [to, from] = next.map(|time| time.unwrap_or(Duration::MAX));
            let (direction, line) = if to <= from {
                (LineDirection::ToArm, &mut *to_arm)
            } else {
                (LineDirection::FromArm, &mut *from_arm)
            };
            let Some((arrival, byte)) = line.pop(by) else {
                return;
            };
            if direction == LineDirection::ToArm || has_port {
                self.judge_byte(direction, arrival, byte);
            }
        }
    }

    fn judge_byte(&mut self, direction: LineDirection, arrival: Duration, byte: u8) {
        let mut bytes = vec![byte];
        let mut delay = Duration::ZERO;
        for number in 0..self.entries.len() {
            let entry = &mut self.entries[number];
            let before = entry.hits;
            delay += entry.judge(direction, &mut bytes);
            self.report_hits(number, before, arrival);
        }
        let judged = &mut self.judged[direction as usize];
        let last = judged.back().map_or(Duration::ZERO, |&(at, _)| at);
        let at = (arrival + delay).max(last);
        judged.extend(bytes.iter().map(|&byte| (at, byte)));
    }

    /// Takes the next processed byte with its time.
    pub(crate) fn pop(&mut self, direction: LineDirection, by: Duration) -> Option<(Duration, u8)> {
        let judged = &mut self.judged[direction as usize];
        judged.front().filter(|it| it.0 <= by)?;
        judged.pop_front()
    }

    /// Whether bytes wait to be fetched.
    pub(crate) fn keeps(&self, direction: LineDirection) -> bool {
        !self.judged[direction as usize].is_empty()
    }

    /// The time of the next delayed byte.
    pub(crate) fn next_late(&self, direction: LineDirection, now: Duration) -> Option<Duration> {
        let judged = &self.judged[direction as usize];
        let next = judged.partition_point(|&(at, _)| at <= now);
        judged.get(next).map(|&(at, _)| at)
    }

    /// The pulses for base, rear and fore that the motors really make.
    pub(crate) fn make(&mut self, pulses: [i32; 3], at: Duration) -> [i32; 3] {
        let mut made = pulses;
        for number in 0..self.entries.len() {
            let entry = &mut self.entries[number];
            if let FaultKind::Lose { joint, amount } = entry.fault.kind
                && entry.acts()
            {
                let before = entry.hits;
                let pulses = &mut made[joint as usize];
                *pulses = pulses.signum() * entry.make(pulses.abs(), amount);
                self.report_hits(number, before, at);
            }
        }
        made
    }

    fn begin(&mut self, number: usize, now: Duration) {
        let entry = &mut self.entries[number];
        let end = entry.fault.when.end.map(|end| match end {
            FaultEnd::At(moment) => moment,
            FaultEnd::After(lasts) => FaultMoment::Time(now + lasts),
        });
        entry.phase = Phase::Acting { until: end };
        match entry.fault.kind {
            FaultKind::Close => self.orders.push_back(ArmOrder::ClosePort),
            FaultKind::Power(tilt) => self.orders.push_back(ArmOrder::PowerOff(tilt)),
            FaultKind::Reset(tilt) => {
                entry.phase = Phase::Over;
                self.orders.push_back(ArmOrder::Reset(tilt));
            }
            // Hits are reported separately.
            FaultKind::Bytes { .. }
            | FaultKind::Lose { .. }
            | FaultKind::Backlash { .. }
            | FaultKind::Zero { .. } => {
                return;
            }
            FaultKind::Delay { .. } | FaultKind::Withhold => {}
        }
        self.report(number, now, FaultEffect::Began);
    }

    fn end(&mut self, number: usize, now: Duration) {
        let entry = &mut self.entries[number];
        entry.phase = Phase::Over;
        let hits = entry.hits;
        match entry.fault.kind {
            FaultKind::Close => self.orders.push_back(ArmOrder::AllowPort),
            FaultKind::Power(_) => self.orders.push_back(ArmOrder::PowerOn),
            _ => {}
        }
        self.report(number, now, FaultEffect::Over(hits));
    }

    /// Reports the 1st, 10th, 100th ... hit.
    fn report_hits(&mut self, number: usize, before: u64, at: Duration) {
        let hits = self.entries[number].hits;
        if hits > before && before.checked_ilog10() != hits.checked_ilog10() {
            self.report(number, at, FaultEffect::Hit(10_u64.pow(hits.ilog10())));
        }
    }

    fn report(&mut self, number: usize, at: Duration, what: FaultEffect) {
        if self.struck.len() == STRUCK_LEN {
            self.struck.pop_front();
        }
        let fault = self.entries[number].fault;
        self.struck.push_back(Struck { at, fault, what });
    }
}

impl ScheduledFault {
    fn new(fault: Fault, seed: u64, number: u64) -> Self {
        let left = match fault.kind {
            FaultKind::Bytes { amount, .. } | FaultKind::Lose { amount, .. } => match amount {
                Amount::Count(count) => count,
                Amount::Percent(_) => 0,
            },
            _ => 0,
        };
        Self {
            fault,
            phase: Phase::Waiting,
            left: [left; 2],
            hits: 0,
            random: [2 * number, 2 * number + 1].map(|stream| Random::sequence(seed, stream)),
            delay: [Duration::ZERO; 2],
        }
    }

    fn acts(&self) -> bool {
        matches!(self.phase, Phase::Acting { .. })
    }

    fn next_time(&self) -> Option<Duration> {
        match (self.phase, self.fault.when.begin) {
            (Phase::Waiting, FaultMoment::Time(at))
            | (
                Phase::Acting {
                    until: Some(FaultMoment::Time(at)),
                },
                _,
            ) => Some(at),
            _ => None,
        }
    }

    /// Applies the fault to bytes and returns their delay.
    fn judge(&mut self, direction: LineDirection, bytes: &mut Vec<u8>) -> Duration {
        if !self.acts() {
            return Duration::ZERO;
        }
        match self.fault.kind {
            FaultKind::Bytes {
                damage,
                amount,
                way,
            } if way.includes(direction) => self.damage(direction as usize, damage, amount, bytes),
            FaultKind::Delay { longest, way } if way.includes(direction) => {
                return self.late(direction as usize, longest);
            }
            _ => {}
        }
        Duration::ZERO
    }

    fn damage(&mut self, direction: usize, damage: Damage, amount: Amount, bytes: &mut Vec<u8>) {
        // There is one byte, or a few where another fault has doubled it.
        for byte in std::mem::take(bytes) {
            if !self.hits(direction, amount) {
                bytes.push(byte);
                continue;
            }
            match damage {
                Damage::Drop => {}
                Damage::Flip => bytes.push(byte ^ (1 << (self.random[direction].number() >> 61))),
                Damage::Duplicate => bytes.extend([byte, byte]),
            }
        }
    }

    /// Changes the delay occasionally.
    fn late(&mut self, direction: usize, longest: Duration) -> Duration {
        let random = &mut self.random[direction];
        if random.chance(DELAY_CHANGES_PERCENT) {
            self.delay[direction] = longest.mul_f64(random.share());
        }
        self.delay[direction]
    }

    /// The number of pulses that remain.
    fn make(&mut self, pulses: i32, amount: Amount) -> i32 {
        let lost = (0..pulses).filter(|_| self.hits(0, amount)).count();
        pulses - i32::try_from(lost).expect("not more than there were")
    }

    fn hits(&mut self, direction: usize, amount: Amount) -> bool {
        let hits = match amount {
            Amount::Percent(percent) => self.random[direction].chance(percent),
            Amount::Count(_) => {
                let left = &mut self.left[direction];
                let some = *left > 0;
                *left -= u32::from(some);
                some
            }
        };
        self.hits += u64::from(hits);
        hits
    }
}

/// The delay changes about once a packet.
const DELAY_CHANGES_PERCENT: f64 = 2.5;
/// More than are reported between two polls.
const STRUCK_LEN: usize = 64;
