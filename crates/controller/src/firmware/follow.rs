//! States 1, 8 and 15 of the stock controller: mouse, gesture and a third one that follow a moving
//! target (note N49).

use dobot_arm::stock::{StockJoints, StockPose, inverse, is_out_of_reach, reach, short};
use dobot_wire::Frame;

use super::TickOutcome;
use super::body::{Body, FORE_DEG, PERIOD_S, REAR_DEG};
use super::settings::StockSettings;
use crate::{Hang, Refused};

/// The state of following.
#[derive(Debug, Default)]
pub(crate) struct Follow {
    /// Degrees per second: base, rear, fore.
    speeds: [f32; 3],
    ticks_left: i16,
    /// One for all three.
    history: History,
}

/// The kind of target that is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FollowKind {
    Mouse,
    Gesture,
    Joints,
}

/// The last ten samples, and an eleventh slot that the sums also read.
#[derive(Debug, Default)]
struct History {
    samples: [[f32; 3]; 11],
    count: u8,
}

impl Follow {
    /// Starts a new sequence after another state. Old samples stay in memory and count if a sum reads
    /// them.
    pub(crate) const fn begin_sequence(&mut self) {
        self.history.count = 0;
    }

    /// Runs a tick of following.
    pub(crate) fn tick(
        &mut self,
        kind: FollowKind,
        frame: &Frame,
        is_over: bool,
        settings: &mut StockSettings,
        body: &mut Body,
    ) -> TickOutcome {
        if kind != FollowKind::Joints {
            grab(frame.float(7), body);
        }
        let outcome = if is_over {
            TickOutcome::OVER
        } else {
            let planned = self.plan(kind, frame, settings, body);
            planned.map_or_else(|outcome| outcome, |()| self.go(body))
        };
        let servo_deg = frame.float(6);
        if kind == FollowKind::Mouse && (-90.0..=90.0).contains(&servo_deg) {
            body.set_servo(servo_deg);
            body.turn_head(servo_deg);
        }
        outcome
    }

    fn go(&mut self, body: &mut Body) -> TickOutcome {
        if self.ticks_left == 0 {
            return TickOutcome::GOES_ON;
        }
        let [base, rear, fore] = self.speeds;
        if !body.advance([base, rear, fore, 0.0]) {
            return TickOutcome::over(false);
        }
        // A count that overflowed its 16 bits ends after a tick.
        self.ticks_left = (self.ticks_left - 1).max(0);
        if self.ticks_left == 0 {
            TickOutcome::OVER
        } else {
            TickOutcome::GOES_ON
        }
    }

    /// Sets speeds and ticks, once for each command, unless it ends or hangs before it moves.
    fn plan(
        &mut self,
        kind: FollowKind,
        frame: &Frame,
        settings: &mut StockSettings,
        body: &mut Body,
    ) -> Result<(), TickOutcome> {
        if core::mem::replace(&mut body.is_planned, true) {
            return Ok(());
        }
        let sample = [3, 4, 5].map(|n| frame.float(n));
        self.ticks_left = 0;
        settings.joint_speeds = [FOLLOW_DEG_S; 4];
        settings.joint_accelerations = [match kind {
            FollowKind::Mouse => MOUSE_DEG_S2,
            FollowKind::Gesture | FollowKind::Joints => GESTURE_DEG_S2,
        }; 4];
        let (to, period_s) = match kind {
            FollowKind::Mouse => (self.moused(sample, settings, body)?, MOUSE_S),
            FollowKind::Gesture => self.gestured(sample, settings, body)?,
            FollowKind::Joints => (within_limits(self.history.joint_average(sample))?, JOINTS_S),
        };
        self.set_speeds(body.joints, to, period_s)
    }

    /// Sets the speeds that lead to these angles within a period, unless all are already there.
    fn set_speeds(
        &mut self,
        from: StockJoints,
        to: StockJoints,
        period_s: f32,
    ) -> Result<(), TickOutcome> {
        let ways = [
            to.base_deg - from.base_deg,
            to.rear_deg - from.rear_deg,
            to.fore_deg - from.fore_deg,
        ];
        if ways.iter().all(|way| way.abs() < NO_WAY_DEG) {
            return Err(TickOutcome::hangs(Hang::NothingToFollow));
        }
        self.speeds = ways.map(|way| {
            if way.abs() < NO_WAY_DEG {
                0.0
            } else {
                way / period_s
            }
        });
        self.ticks_left = short(period_s / PERIOD_S);
        Ok(())
    }

    fn moused(
        &mut self,
        sample: [f32; 3],
        settings: &StockSettings,
        body: &Body,
    ) -> Result<StockJoints, TickOutcome> {
        let [swing, longer, higher] = self.history.mouse_average(sample);
        let z_mm = body.pose.z_mm + higher;
        let pose = StockPose {
            x_mm: reach(body.pose) + longer,
            y_mm: 0.0,
            z_mm: clamp(z_mm, settings.lowest_mm, HIGHEST_MM),
            rotation_deg: 0.0,
        };
        let arms = solve(pose, body)?;
        Ok(StockJoints {
            base_deg: body.joints.base_deg - swing,
            ..arms
        })
    }

    fn gestured(
        &mut self,
        sample: [f32; 3],
        settings: &StockSettings,
        body: &Body,
    ) -> Result<(StockJoints, f32), TickOutcome> {
        let [x, y, z] = self.history.hand_average(sample);
        let (x_mm, y_mm) = (130.0 + (0.5 * x + 100.0), y);
        let z_mm = 0.5 * (z - 200.0) + settings.lowest_mm;
        let period_s = gesture_period_s([x_mm, y_mm, z_mm], body);
        let pose = StockPose {
            x_mm,
            y_mm,
            z_mm: clamp(z_mm, settings.lowest_mm, HIGHEST_MM),
            rotation_deg: 0.0,
        };
        Ok((solve(pose, body)?, period_s))
    }
}

impl History {
    fn len(&self) -> usize {
        self.count.into()
    }

    /// Sums each previous sample plus the new one, and the new one once more, over the count: in
    /// degrees of the base, mm of reach and mm of height.
    fn mouse_average(&mut self, sample: [f32; 3]) -> [f32; 3] {
        let mut sums = sample;
        for old in &self.samples[..self.len()] {
            for (sum, (new, old)) in sums.iter_mut().zip(sample.into_iter().zip(old)) {
                *sum += new + old;
            }
        }
        self.store(sample);
        let [swing, longer, higher] = sums.map(|sum| sum / f32::from(self.count));
        [
            swing / MOUSE_RANGE * MOUSE_RANGE_DEG,
            MOUSE_MM * longer,
            MOUSE_MM * higher,
        ]
    }

    /// Averages the new sample with the mean of the previous ones.
    fn hand_average(&mut self, sample: [f32; 3]) -> [f32; 3] {
        let sums = self.sums_before(sample, [0.0, 0.0, sample[2]]);
        core::array::from_fn(|axis| 0.5 * sample[axis] + 0.5 * sums[axis] / f32::from(self.count))
    }

    /// The average of the previous angles, without the newest.
    fn joint_average(&mut self, [rear, fore, base]: [f32; 3]) -> StockJoints {
        let sample = [
            clamp(rear, REAR_DEG[0], REAR_DEG[1]),
            clamp(fore, FORE_DEG[0], FORE_DEG[1]),
            base,
        ];
        let [rear_deg, fore_deg, base_deg] = self
            .sums_before(sample, [0.0; 3])
            .map(|sum| sum / f32::from(self.count));
        StockJoints {
            base_deg,
            rear_deg,
            fore_deg,
            servo_deg: 0.0,
        }
    }

    /// The sums over one slot more than there are samples, before the new one is stored: over stale
    /// memory or, after ten samples, over the new one itself.
    fn sums_before(&mut self, sample: [f32; 3], mut sums: [f32; 3]) -> [f32; 3] {
        self.samples[SAMPLES] = sample;
        for old in &self.samples[..=self.len()] {
            for (sum, old) in sums.iter_mut().zip(old) {
                *sum += old;
            }
        }
        self.store(sample);
        sums
    }

    /// Stores a sample; drops the oldest of more than ten.
    fn store(&mut self, sample: [f32; 3]) {
        if self.len() == SAMPLES {
            self.samples.copy_within(1..SAMPLES, 0);
            self.samples[SAMPLES - 1] = sample;
        } else {
            self.samples[self.len()] = sample;
            self.count += 1;
        }
    }
}

/// The period of a gesture to a place, in seconds.
fn gesture_period_s([x_mm, y_mm, z_mm]: [f32; 3], body: &Body) -> f32 {
    let [dx, dy, dz] = [
        x_mm - body.pose.x_mm,
        y_mm - body.pose.y_mm,
        z_mm - body.pose.z_mm,
    ];
    let distance_mm = libm::sqrtf(dx * dx + dy * dy + dz * dz);
    if distance_mm > NEAR_MM {
        distance_mm / GESTURE_MM_S
    } else {
        GESTURE_S
    }
}

/// Arm angles for a pose, within the limits.
fn solve(pose: StockPose, body: &Body) -> Result<StockJoints, TickOutcome> {
    if is_out_of_reach(pose, body.tool_mm) {
        return Err(TickOutcome::over_with(Refused::OutOfReach));
    }
    within_limits(inverse(pose, body.tool_mm))
}

/// Checks the limits; a rear arm too far back is set to its limit.
fn within_limits(mut joints: StockJoints) -> Result<StockJoints, TickOutcome> {
    if joints.rear_deg > REAR_DEG[1]
        || joints.fore_deg < FORE_DEG[0]
        || joints.fore_deg > FORE_DEG[1]
    {
        return Err(TickOutcome::over_with(Refused::OutOfReach));
    }
    if joints.rear_deg < REAR_DEG[0] {
        joints.rear_deg = REAR_DEG[0];
    }
    Ok(joints)
}

fn grab(pump: f32, body: &mut Body) {
    if pump == 1.0 {
        body.grab(true, CLOSED_DEG);
    } else if pump == 0.0 {
        body.grab(false, 0.0);
    }
}

/// Clamps by comparison: NaN stays NaN.
fn clamp(value: f32, low: f32, high: f32) -> f32 {
    if value < low {
        low
    } else if value > high {
        high
    } else {
        value
    }
}

const SAMPLES: usize = 10;
const FOLLOW_DEG_S: f32 = 200.0;
const MOUSE_DEG_S2: f32 = 100.0;
const GESTURE_DEG_S2: f32 = 500.0;
/// Mouse units and the base angle they correspond to.
const MOUSE_RANGE: f32 = 400.0;
const MOUSE_RANGE_DEG: f32 = 90.0;
/// Millimetres of reach and height per mouse unit.
const MOUSE_MM: f32 = 0.4;
const MOUSE_S: f32 = 0.1;
const GESTURE_S: f32 = 0.1;
const JOINTS_S: f32 = 0.08;
/// Above this distance the speed determines the time.
const NEAR_MM: f32 = 20.0;
const GESTURE_MM_S: f32 = 200.0;
const HIGHEST_MM: f32 = 135.0;
const NO_WAY_DEG: f32 = 1e-6;
pub(crate) const CLOSED_DEG: f32 = 45.0;
