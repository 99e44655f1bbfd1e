use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_wire::{Command, Dialect, LinearJog, LinearJogAxis, MoveTo, Status, WriteVector};

/// A policy that anybody writes: an error with its line, or a policy that is written and read again
/// unchanged, and that forbids what it says.
pub fn policy(input: &[u8]) {
    let text = crate::spelled(input, WORDS);
    let text = String::from_utf8_lossy(&text);
    let policy = match Policy::from_toml(&text) {
        Ok(policy) => policy,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    policy.validate().expect("what was read is in its ranges");
    let again = Policy::from_toml(&policy.to_toml());
    assert_eq!(again.expect("what was written can be read"), policy);

    let number = |n: usize| f32::from(input.get(n).copied().unwrap_or(128));
    let to = |n| {
        [
            100.0 + number(n),
            number(n + 1) - 128.0,
            number(n + 2) - 120.0,
        ]
    };
    let ([x, y, z], [dx, dy, dz]) = (to(1), to(4));
    for command in [
        Command::from(MoveTo::to(x, y, z)),
        WriteVector::by(dx - x, dy - y, dz - z, 40.0).into(),
        LinearJog::new(LinearJogAxis::XPlus, 50.0).into(),
    ] {
        obeyed(&policy, &command);
    }
}

/// What is allowed ends where it may, or no farther outside than the arm stands already.
fn obeyed(policy: &Policy, command: &Command) {
    let model = Model::new(Dialect::SPECIFICATION, &Status::AT_ZERO);
    let Ok(trajectory) = policy.check(&model, command) else {
        return;
    };
    let Some(duration_s) = trajectory.duration_s() else {
        return;
    };
    assert!(duration_s.is_finite());
    let values = |at_s| {
        let place = trajectory
            .place_at(at_s)
            .expect("the arm can be where it may");
        let at = place.pose.position;
        let joints = place.joints;
        [
            at.x.0,
            at.y.0,
            at.z.0,
            joints.base.0,
            joints.rear.0,
            joints.fore.0,
        ]
    };
    let limits = [
        policy.workspace.x_mm,
        policy.workspace.y_mm,
        policy.workspace.z_mm,
        policy.joints.base_deg,
        policy.joints.rear_deg,
        policy.joints.fore_deg,
    ];
    for ((allowed, began), found) in limits.into_iter().zip(values(0.0)).zip(values(duration_s)) {
        let near = (allowed.min.min(began) - 1e-3)..=(allowed.max.max(began) + 1e-3);
        assert!(
            near.contains(&found),
            "{found} is not in {allowed:?}: {command:?}"
        );
    }
}

const WORDS: &[&str] = &[
    "[joints]\n",
    "base_deg = ",
    "rear_deg = ",
    "fore_deg = ",
    "servo_deg = ",
    "opening_deg = ",
    "[workspace]\n",
    "x_mm = ",
    "y_mm = ",
    "z_mm = ",
    "reach_mm = ",
    "[table]\n",
    "z_mm = -60\n",
    "[tool_length]\n",
    "suction_cup_mm = ",
    "[arm]\n",
    "radius_mm = ",
    "[keep_out]\n",
    "[keep_out.lamp]\n",
    "[keep_out.\"a b\"]\n",
    "lamp = { x_mm = [200, 250], y_mm = [-50, 50], z_mm = [0, 90] }\n",
    "pole = { center_mm = [200, 50], radius_mm = 30, z_mm = [-50, 60] }\n",
    "center_mm = [200, 0]\n",
    "[speed]\n",
    "joint_deg_s = ",
    "line_mm_s = ",
    "writing_mm_s = ",
    "jog_percent = ",
    "[acceleration]\n",
    "line_mm_s2 = ",
    "[jump]\n",
    "height_mm = ",
    "[laser]\n",
    "allowed = ",
    "arm_for_s = ",
    "least_speed_mm_s = ",
    "standing = ",
    "area = ",
    "[jog]\n",
    "dead_man_s = ",
    "raw_dead_man_s = ",
    "reaction_s = ",
    "[queue]\n",
    "ahead_s = ",
    "[voice]\n",
    "largest_mm = ",
    "[-135, 135]\n",
    "[-10, 60]\n",
    "[150, 300]\n",
    "[0, 0]\n",
    "[9, -9]\n",
    "[-inf, inf]\n",
    "0\n",
    "1\n",
    "50\n",
    "0.15\n",
    "1e300\n",
    "-5\n",
    "nan\n",
    "true\n",
    "false\n",
    "{ x_mm = [130, 321], y_mm = [-200, 200], z_mm = [-103, 60] }\n",
    "{",
    "}",
    "[",
    "]",
    ",",
    "=",
    "\"",
    "#",
    "\n",
    " ",
    "x",
];
