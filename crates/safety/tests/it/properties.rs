//! Properties of every policy, position and command.

use dobot_arm::{Calibration, Joints, Limits, Plane, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::{Area, Bounds, Cylinder, KeepOut, Policy};
use dobot_wire::{
    Command, Dialect, JointJogAxis, LinearJogAxis, MoveTo,
    MovingMode::{self, Jump, MovJ, MovL},
    single,
};
use proptest::prelude::*;

use crate::desk::{go, jog, slide, turn, vector};
use crate::truth::broken;

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 3000,
        max_global_rejects: 100_000,
        ..ProptestConfig::default()
    })]

    #[test]
    fn no_place_on_an_allowed_path_breaks_a_rule(
        policy in policies(),
        from in places(),
        command in commands(),
        stock in any::<bool>(),
    ) {
        let model = Model::standing(dialect(stock), from);
        prop_assume!(broken(&policy, &from, BEGINS).is_none());
        let Ok(trajectory) = policy.check(&model, &command) else {
            return Ok(());
        };
        let duration_s = trajectory.motion_s().expect("no jog");
        for index in 0..=1000 {
            let t_s = duration_s * f64::from(index) / 1000.0;
            let place = trajectory.place_at(t_s).expect("an allowed place is reachable");
            prop_assert_eq!(broken(&policy, &place, 2e-6), None, "after {} s", t_s);
        }
    }

    #[test]
    fn the_path_up_to_a_refusal_is_free_and_its_nearest_place_is_allowed(
        policy in policies(),
        from in places(),
        command in commands(),
        stock in any::<bool>(),
    ) {
        let model = Model::standing(dialect(stock), from);
        prop_assume!(broken(&policy, &from, BEGINS).is_none());
        let Err(violation) = policy.check(&model, &command) else {
            return Ok(());
        };
        prop_assert_eq!(violation.to_string().lines().count(), 1);
        if let (Command::MoveTo(target), Some(place)) = (&command, violation.nearest) {
            // The reported position can be typed, and the path there is free.
            let [x_mm, y_mm, z_mm] = place.map(|place| format!("{place:.1}").parse().expect("a number"));
            let typed = MoveTo { x_mm, y_mm, z_mm, ..*target };
            prop_assert!(policy.check(&model, &typed.into()).is_ok(), "{:?}", place);
        }
        let (Some(at), Some([x, y, z])) = (&violation.at, violation.nearest) else {
            return Ok(());
        };
        // The reported position is on the path, right after the nearest allowed one.
        let trajectory = model.trajectory(&command).expect("it has a way");
        let place = trajectory.place_at(at.after_s.expect("no jog")).expect("it is reachable");
        let reported = place.pose.position;
        let [at_x, at_y, at_z] = at.position_mm;
        let apart = (reported.x.0 - at_x).hypot(reported.y.0 - at_y).hypot(reported.z.0 - at_z);
        prop_assert!(apart < 1e-6, "{} mm off its way", apart);
        if !matches!(command, Command::MoveTo(_)) {
            let step = (at_x - x).hypot(at_y - y).hypot(at_z - z);
            prop_assert!(step <= LEAF, "{} mm from the nearest", step);
        }
        // And it breaks the rule, or comes nearer than the resolution to doing so.
        let tight = shrunk(&policy, 0.25);
        prop_assert!(broken(&tight, &place, 0.0).is_some(), "{}", violation);
        // All before it is free.
        for index in 0..200 {
            let t_s = at.after_s.expect("no jog") * f64::from(index) / 200.0;
            let place = trajectory.place_at(t_s).expect("it is reachable");
            prop_assert_eq!(broken(&policy, &place, LEAF), None, "after {} s", t_s);
        }
    }

    #[test]
    fn no_place_that_a_jog_can_cover_breaks_a_rule(
        policy in policies(),
        from in places(),
        command in jogs(),
        within_s in 0.0..2.0,
    ) {
        let model = Model::standing(Dialect::FIRMWARE_1_1, from);
        prop_assume!(broken(&policy, &from, BEGINS).is_none());
        if policy.check_jog(&model, &command, within_s).is_err() {
            return Ok(());
        }
        // At full speed for that long, and then the run-down, a little at a time.
        let trajectory = model.trajectory(&command).expect("a jog").jog().expect("a jog");
        let full_s = trajectory.change_s() + within_s;
        let (speed, acceleration) = (trajectory.target_speed().abs(), trajectory.acceleration());
        let covered = speed * within_s + speed * speed / (2.0 * acceleration);
        // The same distance from rest takes longer: until then it is no farther.
        for index in 0..=300 {
            let t_s = full_s * f64::from(index) / 300.0;
            let ramp_s = t_s.min(trajectory.change_s());
            let gone = 0.5 * acceleration * ramp_s * ramp_s + speed * (t_s - ramp_s);
            if gone > covered {
                break;
            }
            let place = trajectory.place_at(t_s).expect("an allowed place is reachable");
            prop_assert_eq!(broken(&policy, &place, 2e-6), None, "after {} s", t_s);
        }
    }

    #[test]
    fn no_allowed_path_leads_farther_below_the_paper_than_the_policy_allows(
        from in places(),
        command in commands(),
        (z0_mm, slope_x, slope_y) in (-80.0..20.0, -0.1..0.1, -0.1..0.1),
        (base_deg, rear_deg, fore_deg, reach_mm, left_mm) in
            (-20.0..20.0, -10.0..10.0, -10.0..10.0, -8.0..8.0, -5.0..5.0),
        as_drawn in any::<bool>(),
    ) {
        let table = Some(Plane { z0_mm, slope_x, slope_y });
        let crooked = Calibration { base_deg, rear_deg, fore_deg, reach_mm, left_mm, table, ..Calibration::NONE };
        let arm = if as_drawn { Calibration { table, ..Calibration::NONE } } else { crooked };
        let policy = Policy::default();
        let model = Model::standing(Dialect::SPECIFICATION, from).calibrated(arm);
        let lowest_mm = |model: &Model, place: &ArmPlace| {
            let there = model.calibrated_place(place).pose.position;
            arm.above_table_mm(there).expect("there is a table")
        };
        let begins_mm = lowest_mm(&model, &from);
        let checked = policy.check(&model, &command);
        let Ok(trajectory) = checked else { return Ok(()) };
        let duration_s = trajectory.motion_s().expect("no jog");
        for index in 0..=1000 {
            let place = trajectory.place_at(duration_s * f64::from(index) / 1000.0).expect("reachable");
            let now_mm = lowest_mm(&model, &place);
            let allowed_mm = begins_mm.min(-policy.table.below_paper_mm);
            prop_assert!(now_mm >= allowed_mm - 3e-6, "{} mm where {} mm is allowed", now_mm, allowed_mm);
        }
    }

    #[test]
    fn an_arm_outside_never_ends_up_farther_outside(
        from in places(),
        command in commands(),
        rear_max in 20.0..60.0,
        lowest in -60.0..20.0,
    ) {
        let mut policy = Policy::default();
        policy.joints.rear_deg.max = rear_max;
        policy.workspace.z_mm.min = lowest;
        let model = Model::standing(Dialect::SPECIFICATION, from);
        let Ok(trajectory) = policy.check(&model, &command) else {
            return Ok(());
        };
        let outside = |place: &ArmPlace| {
            let rear = (place.joints.rear.0 - rear_max).max(0.0);
            [rear, (lowest - place.pose.position.z.0).max(0.0)]
        };
        let deepest = outside(&from);
        let (mut was_inside, duration_s) = ([false; 2], trajectory.motion_s().expect("no jog"));
        for index in 0..=1000 {
            let t_s = duration_s * f64::from(index) / 1000.0;
            let now = outside(&trajectory.place_at(t_s).expect("reachable"));
            for rule in 0..2 {
                prop_assert!(now[rule] <= deepest[rule] + 3e-6, "{:?} after {} s", now, t_s);
                was_inside[rule] |= now[rule] == 0.0;
            }
        }
        // A part that came in is in at the end.
        let end = outside(&trajectory.place_at(duration_s).expect("reachable"));
        for rule in 0..2 {
            prop_assert!(!was_inside[rule] || end[rule] <= 3e-6, "{:?} at the end", end);
        }
    }
}

fn dialect(stock: bool) -> Dialect {
    Dialect::ALL[usize::from(stock)]
}

/// Places within the limits of the arm.
fn places() -> impl Strategy<Value = ArmPlace> {
    let joints = (-135.0..135.0, -5.0..85.0, -10.0..95.0, -45.0..45.0);
    joints.prop_filter_map("beyond the limits", |(base, rear, fore, servo)| {
        let place = ArmPlace::at_joints(Joints::new(base, rear, fore, servo), Tool::SuctionCup);
        let within = Limits::STOCK
            .check_at(&place.joints, place.pose.position)
            .is_ok();
        within.then_some(place)
    })
}

fn commands() -> impl Strategy<Value = Command> {
    let modes = || prop_oneof![Just(Jump), Just(MovL), Just(MovJ)];
    let targets = (modes(), places()).prop_map(|(mode, place): (MovingMode, ArmPlace)| {
        let position = place.pose.position;
        let [x, y, z] = [position.x.0, position.y.0, position.z.0].map(single);
        Command::from(go(mode, x, y, z))
    });
    let joints = (modes(), places()).prop_map(|(mode, place): (MovingMode, ArmPlace)| {
        let joints = place.joints;
        let [base, rear, fore] = [joints.base.0, joints.rear.0, joints.fore.0].map(single);
        Command::from(turn(mode, base, rear, fore))
    });
    let vectors = (-100.0..100.0_f32, -100.0..100.0_f32, -60.0..60.0_f32)
        .prop_map(|(x, y, z)| Command::from(vector(x, y, z)));
    prop_oneof![targets, joints, vectors]
}

fn jogs() -> impl Strategy<Value = Command> {
    (1..=8_usize, 1.0..100.0_f32, any::<bool>()).prop_map(|(axis, percent, linear)| {
        if linear {
            slide(LinearJogAxis::ALL[axis], percent).into()
        } else {
            jog(JointJogAxis::ALL[axis], percent).into()
        }
    })
}

/// Policies with keep-outs, some of them thin.
fn policies() -> impl Strategy<Value = Policy> {
    let size = || prop_oneof![Just(0.0), 0.0..5.0, 5.0..100.0];
    let corner = || (60.0..320.0, -250.0..250.0, -100.0..130.0);
    let blocks = (corner(), size(), size(), size()).prop_map(|((x, y, z), a, b, c)| {
        KeepOut::Box(Area {
            x_mm: Bounds::new(x, x + a),
            y_mm: Bounds::new(y, y + b),
            z_mm: Bounds::new(z, z + c),
        })
    });
    let cylinders = (corner(), size(), size()).prop_map(|((x_mm, y_mm, z), radius_mm, height)| {
        KeepOut::Cylinder(Cylinder {
            x_mm,
            y_mm,
            radius_mm,
            z_mm: Bounds::new(z, z + height),
        })
    });
    let keep_out = prop::collection::btree_map("[a-c]", prop_oneof![blocks, cylinders], 0..3);
    let radius = prop_oneof![Just(0.0), 0.0..30.0];
    (keep_out, radius, -150.0..-40.0, 30.0..90.0, 60.0..136.0).prop_map(
        |(keep_out, radius_mm, table_mm, fore_max, z_max)| {
            let mut policy = Policy {
                keep_out,
                ..Policy::default()
            };
            policy.arm.radius_mm = radius_mm;
            policy.table.z_mm = table_mm;
            policy.joints.fore_deg.max = fore_max;
            policy.workspace.z_mm.max = z_max;
            policy
        },
    )
}

/// Returns the policy with all rules tighter by this much.
fn shrunk(policy: &Policy, by: f64) -> Policy {
    let mut tight = policy.clone();
    let joints = &mut tight.joints;
    let space = &mut tight.workspace;
    for bounds in [
        &mut joints.base_deg,
        &mut joints.rear_deg,
        &mut joints.fore_deg,
        &mut joints.servo_deg,
        &mut joints.opening_deg,
        &mut space.x_mm,
        &mut space.y_mm,
        &mut space.z_mm,
        &mut space.reach_mm,
    ] {
        *bounds = Bounds::new(bounds.min + by, bounds.max - by);
    }
    tight.table.z_mm += by;
    // The points of the truth lie apart.
    tight.arm.radius_mm += by + 6.0;
    tight
}

/// The resolution of the check, in mm or degrees.
const LEAF: f64 = 0.0201;

/// It begins this much inside of all rules, in mm or degrees: the points of the truth are 4.5 mm
/// apart, so that nearer objects may already touch.
const BEGINS: f64 = -2.4;
