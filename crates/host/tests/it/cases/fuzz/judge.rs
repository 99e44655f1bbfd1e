//! Conditions that must never occur, for any requests.

use dobot_arm::{Joints, Tool, forward};
use dobot_controller::Refused;
use dobot_host::VirtualStation;
use dobot_safety::{Bounds, Policy};
use dobot_wire::VOICE_HEADER;

/// Looks at the arm in every moment in which something happens: at every control tick at least,
/// while it moves.
#[derive(Debug)]
pub(crate) struct Judge {
    policy: Policy,
    /// The laser may be armed.
    burns: bool,
    /// Whether the arm is reset at some time: then its assumed base angle is wrong, which is
    /// undetectable if it was 0. Its positions are not judged.
    resets: bool,
    /// Control ticks seen.
    pub ticks: u64,
    tick: u32,
    /// Packets seen on the line.
    packets: usize,
    /// The joints of the last moment.
    before: Option<Joints>,
    /// The violation and its figures.
    pub lost: Option<(&'static str, String)>,
}

pub(crate) const HANGS: &str = "the arm hangs";
pub(crate) const NAN: &str = "the pose is NaN";
pub(crate) const OUTSIDE: &str = "the arm broke the policy";
pub(crate) const LASER: &str = "the laser was on without being armed";

impl Judge {
    pub(crate) const fn new(policy: Policy, burns: bool, resets: bool) -> Self {
        Self {
            policy,
            burns,
            resets,
            ticks: 0,
            tick: 0,
            packets: 0,
            before: None,
            lost: None,
        }
    }

    /// Judges this moment.
    pub(crate) fn look(&mut self, station: &VirtualStation) {
        let arm = station.arm();
        self.look_for_voice(station);
        let tick = arm.controller().tick_count();
        if self.lost.is_some() || tick == self.tick {
            return;
        }
        self.tick = tick;
        self.ticks += 1;
        if arm.controller().laser() && !self.burns {
            self.lose(LASER, String::new());
        }
        let at = arm.controller_time(station.now());
        let believed = arm.controller().joints_at(at);
        let pose = arm.controller().pose_at(at);
        if !is_finite(&believed) || !pose.position.z.0.is_finite() {
            self.lose(NAN, format!("{believed:?}"));
            return;
        }
        if self.resets {
            return;
        }
        let joints = arm.mechanics().joints_at(station.now());
        // The tool last set at the controller.
        let reach_mm = forward(&believed, Tool::SuctionCup).position.reach().0;
        let is_long = (pose.position.reach().0 - reach_mm).abs() < 1.0;
        let tool = if is_long {
            Tool::SuctionCup
        } else {
            Tool::Laser
        };
        if let Some(why) = self.outside(&joints, tool) {
            self.lose(OUTSIDE, why);
        }
    }

    /// Voice that leaves for an arm in motion hangs a stock arm, with its motors running (note N50).
    fn look_for_voice(&mut self, station: &VirtualStation) {
        let joints = station.arm().mechanics().joints_at(station.now());
        let moves = self
            .before
            .replace(joints)
            .is_some_and(|previous| previous != joints);
        let mut sent = station.packets().iter().skip(self.packets);
        if moves && sent.any(|(_, bytes)| bytes[0] == VOICE_HEADER) {
            self.lose(HANGS, "voice was sent while it moved".to_owned());
        }
        self.packets = station.packets().len();
    }

    /// Reads the controller's reports.
    pub(crate) fn read_reports(&mut self, station: &mut VirtualStation) {
        while let Some(refused) = station.arm_mut().poll_refused() {
            match refused {
                Refused::Hangs(_) => self.lose(HANGS, refused.to_string()),
                Refused::PoseLost => self.lose(NAN, refused.to_string()),
                _ => {}
            }
        }
    }

    fn lose(&mut self, what: &'static str, why: String) {
        self.lost.get_or_insert((what, why));
    }

    /// The rule that is broken. This is not the crate `safety`, but the limits themselves.
    fn outside(&self, joints: &Joints, tool: Tool) -> Option<String> {
        let policy = &self.policy;
        let position = forward(joints, tool).position;
        let tip = policy.table.z_mm + policy.tool_length.of(tool);
        let above = Bounds::new(tip, f64::INFINITY);
        let (joint, space) = (&policy.joints, &policy.workspace);
        [
            ("base", joints.base.0, joint.base_deg, SLACK_DEG),
            ("rear arm", joints.rear.0, joint.rear_deg, SLACK_DEG),
            ("forearm", joints.fore.0, joint.fore_deg, SLACK_DEG),
            ("servo", joints.servo.0, joint.servo_deg, SLACK_SERVO_DEG),
            (
                "opening",
                joints.rear.0 - joints.fore.0,
                joint.opening_deg,
                SLACK_DEG,
            ),
            ("x", position.x.0, space.x_mm, SLACK_MM),
            ("y", position.y.0, space.y_mm, SLACK_MM),
            ("z", position.z.0, space.z_mm, SLACK_MM),
            ("reach", position.reach().0, space.reach_mm, SLACK_MM),
            ("z above the table", position.z.0, above, SLACK_MM),
        ]
        .into_iter()
        .find(|&(_, found, allowed, slack)| {
            !(found >= allowed.min - slack && found <= allowed.max + slack)
        })
        .map(|(name, found, allowed, _)| format!("{name} is {found:.3}, allowed is {allowed}"))
    }
}

const fn is_finite(joints: &Joints) -> bool {
    joints.base.0.is_finite()
        && joints.rear.0.is_finite()
        && joints.fore.0.is_finite()
        && joints.servo.0.is_finite()
}

/// Steps of the motors, and the single precision of a packet.
const SLACK_MM: f64 = 0.1;
const SLACK_DEG: f64 = 0.05;
/// The signal of a servo comes in steps of 0.18 degrees.
const SLACK_SERVO_DEG: f64 = 0.2;
