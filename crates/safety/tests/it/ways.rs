//! Rules for the whole path of a command.

use dobot_arm::{Calibration, Plane, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_wire::{
    Configuration, Dialect, Gesture, MouseMove,
    MovingMode::{Jump, MovJ, MovL},
    Voice,
};

use crate::desk::{Desk, assert_near, go, turn, vector};

#[test]
fn ordinary_drawing_at_40_mm_below_the_pivot_is_allowed() {
    let desk = Desk::at(180.0, -60.0, -30.0);
    desk.allows(vector(0.0, 0.0, -10.0));
    let down = Desk::at(180.0, -60.0, -40.0);
    down.allows(vector(80.0, 120.0, 0.0));
    down.allows(go(Jump, 240.0, 60.0, -40.0));
}

#[test]
fn a_tool_stays_out_of_the_table_by_its_own_length() {
    let policy = "[table]\nz_mm = -103\n[tool_length]\nsuction_cup_mm = 60";
    let desk = Desk::at(200.0, 0.0, 0.0).under(policy);
    desk.allows(vector(0.0, 0.0, -43.0));
    let violation = desk.refuses("table", vector(0.0, 0.0, -80.0));
    assert_near(
        violation.value.as_ref().expect("a value").found,
        -80.0,
        1e-6,
    );
    assert_near(
        violation.value.as_ref().expect("a value").nearest,
        -43.0,
        1e-9,
    );
    assert_near(violation.nearest.expect("a place")[2], -43.0, 0.03);
    let at = violation.at.as_ref().expect("a place on the way");
    assert_near(at.position_mm[2], -43.0, 0.03);
    assert_near(at.along_mm, 43.0, 0.03);
    // From rest at 100 mm/s2 up to 40 mm/s: 8 mm in 0.4 s, and 35 mm more at 40 mm/s.
    assert_near(at.after_s.expect("a time"), 0.4 + 35.0 / 40.0, 0.01);
    for part in ["z would be -80 mm", "table allows -43 mm and more", "43"] {
        assert!(violation.to_string().contains(part), "{part}: {violation}");
    }
}

#[test]
fn the_table_follows_the_paper_at_any_slope() {
    // It rises by 2 mm in 100 forward: -44 mm at 200, -43 mm at 250.
    let table = Plane {
        z0_mm: -48.0,
        slope_x: 0.02,
        slope_y: 0.0,
    };
    let arm = Calibration {
        table: Some(table),
        ..Calibration::NONE
    };
    let mut desk = Desk::at(200.0, 0.0, 0.0).under("[table]\nbelow_paper_mm = 2");
    desk.model = desk.model.calibrated(arm);
    desk.allows(vector(0.0, 0.0, -45.9));
    let violation = desk.refuses("table.below_paper", vector(0.0, 0.0, -46.5));
    assert!(
        violation.to_string().contains(
            "height above the paper would be -2.5 mm; table.below_paper allows -2 mm and more"
        ),
        "{violation}"
    );
    // Level above the paper, and in it where that is higher.
    let mut low = Desk::at(200.0, 0.0, -45.5).under("[table]\nbelow_paper_mm = 2");
    low.model = low.model.calibrated(arm);
    low.allows(vector(0.0, 40.0, 0.0));
    let violation = low.refuses("table.below_paper", vector(80.0, 0.0, 0.0));
    // 2 mm below the paper at x = 225.
    assert_near(violation.nearest.expect("a place")[0], 225.0, 1.1);
    // A gripper that is longer than the pen by 10 mm has to stay higher by as much.
    let lengths =
        "[tool_length]\nsuction_cup_mm = 40\ngripper_mm = 50\n[table]\nbelow_paper_mm = 2";
    let pose = Desk::at(200.0, 0.0, 0.0).model.place.pose;
    let place = ArmPlace::at_pose(pose, Tool::Gripper).expect("the arm can be there");
    let mut gripper = Desk::at(200.0, 0.0, 0.0).under(lengths);
    gripper.model = Model::standing(Dialect::SPECIFICATION, place).calibrated(arm);
    gripper.model.tool = Tool::Gripper;
    gripper.allows(vector(0.0, 0.0, -35.9));
    gripper.refuses("table.below_paper", vector(0.0, 0.0, -36.2));
}

#[test]
fn a_tiny_violation_is_reported_with_enough_decimals_to_show_it() {
    let policy = "[table]\nz_mm = -103\n[tool_length]\nsuction_cup_mm = 60";
    let desk = Desk::at(200.0, 0.0, 0.0).under(policy);
    let violation = desk.refuses("table", vector(0.0, 0.0, -43.004)).to_string();
    assert!(
        violation.contains("z would be -43.004 mm; table allows -43 mm"),
        "{violation}"
    );
}

#[test]
fn the_cables_keep_the_base_within_135_degrees() {
    let desk = Desk::with_joints(130.0, 20.0, 30.0);
    desk.allows(turn(MovJ, 135.0, 20.0, 30.0));
    let violation = desk.refuses("joints.base", turn(MovJ, 150.0, 20.0, 30.0));
    let at = violation.at.as_ref().expect("a place on the way");
    assert_near(at.joints_deg[0], 135.0, 0.03);
    assert_near(
        violation.value.as_ref().expect("a value").found,
        150.0,
        1e-9,
    );
}

#[test]
fn a_line_whose_ends_are_allowed_may_not_cut_through_the_space_near_the_base() {
    let desk = Desk::at(60.0, -160.0, -40.0);
    let violation = desk.refuses("workspace.reach", go(MovL, 60.0, 160.0, -40.0));
    // The reach is 129 mm where y is -sqrt(129^2 - 60^2).
    let y = violation.at.expect("a place on the way").position_mm[1];
    assert_near(y, -(129.0_f64.powi(2) - 60.0_f64.powi(2)).sqrt(), 0.05);
    desk.allows(go(Jump, 60.0, 160.0, -40.0));
}

#[test]
fn a_joint_move_that_swings_out_half_way_is_detected() {
    // At both ends x is half of the reach, straight ahead all of it.
    let desk = Desk::with_joints(-60.0, 45.0, 30.0).under("[workspace]\nx_mm = [-321, 250]");
    assert!(desk.model.place.pose.position.reach().0 > 280.0);
    let violation = desk.refuses("workspace.x", turn(MovJ, 60.0, 45.0, 30.0));
    assert_near(violation.nearest.expect("a place")[0], 250.0, 0.03);
    desk.allows(turn(MovJ, -40.0, 45.0, 30.0));
}

#[test]
fn a_keep_out_stops_forearm_and_hand_not_only_the_tool() {
    let post =
        "[keep_out.post]\ncylinder = { x_mm = 150, y_mm = 0, radius_mm = 5, z_mm = [-103, 60] }";
    // The tool stays beyond the post at all times; the arm sweeps over it.
    let desk = Desk::at(200.0, -200.0, 30.0).under(post);
    let violation = desk.refuses("keep_out.post", go(Jump, 200.0, 200.0, 30.0));
    assert!(
        violation.to_string().contains("would touch keep_out.post"),
        "{violation}"
    );
    let short = post.replace("60]", "-60]");
    desk.under(&short).allows(go(Jump, 200.0, 200.0, 30.0));
}

#[test]
fn nothing_is_too_thin_for_a_keep_out() {
    let wall = "[arm]\nradius_mm = 0\n[keep_out.wall]\nbox = { x_mm = [100, 300], y_mm = [0, 0], z_mm = [-103, 136] }";
    let desk = Desk::at(200.0, -100.0, 30.0).under(wall);
    let violation = desk.refuses("keep_out.wall", go(MovL, 200.0, 100.0, 30.0));
    // 0.1 mm before the wall where it comes first (half way out, at x 100), in whole tenths.
    let y = violation.nearest.expect("a place")[1];
    assert!((-0.35..0.0).contains(&y), "{y}");
}

#[test]
fn an_arm_right_at_a_keep_out_can_leave_it() {
    let crate_ =
        "[keep_out.crate]\nbox = { x_mm = [150, 300], y_mm = [50, 150], z_mm = [-103, 60] }";
    let desk = Desk::at(200.0, -100.0, 30.0).under(crate_);
    let stop = desk.refuses("keep_out.crate", go(MovL, 200.0, 100.0, 30.0));
    let [x, y, z] = stop.nearest.expect("a place");
    let near = Desk::at(x, y, z).under(crate_);
    near.refuses("keep_out.crate", vector(0.0, 5.0, 0.0));
    near.allows(vector(0.0, -5.0, 0.0));
    near.allows(vector(0.0, 0.0, 60.0));
}

#[test]
fn an_arm_outside_may_come_back_in_but_not_go_deeper() {
    let desk = Desk::with_joints(150.0, 20.0, 30.0);
    desk.allows(turn(MovJ, 145.0, 20.0, 30.0));
    desk.allows(turn(MovJ, 100.0, 20.0, 30.0));
    desk.refuses("joints.base", turn(MovJ, 151.0, 20.0, 30.0));
    // Rules that are not broken still apply.
    desk.refuses("joints.rear", turn(MovJ, 145.0, 86.0, 60.0));
    let low = Desk::at(200.0, 0.0, -80.0);
    low.allows(vector(0.0, 0.0, 30.0));
    low.allows(vector(10.0, 0.0, 0.0));
    low.refuses("table", vector(0.0, 0.0, -1.0));
}

#[test]
fn an_arm_that_came_back_in_may_not_go_out_again_in_the_same_move() {
    // From the right rear of the arm to its left rear.
    let desk = Desk::at(-60.0, -160.0, -40.0).under("[joints]\nbase_deg = [-105, 105]");
    assert!(desk.model.place.joints.base.0 < -105.0);
    let violation = desk.refuses("joints.base", go(Jump, -60.0, 160.0, -40.0));
    let at = violation.at.as_ref().expect("a place on the way");
    assert_near(at.joints_deg[0], 105.0, 0.03);
}

#[test]
fn an_arm_inside_a_keep_out_may_leave_it_but_not_go_deeper() {
    let crate_ =
        "[keep_out.crate]\nbox = { x_mm = [150, 300], y_mm = [50, 150], z_mm = [-103, 60] }";
    let inside = Desk::at(220.0, 40.0, 30.0).under(crate_);
    inside.allows(vector(0.0, -30.0, 0.0));
    inside.refuses("keep_out.crate", vector(0.0, 10.0, 0.0));
    inside.refuses("keep_out.crate", go(Jump, 220.0, 100.0, 0.0));
}

#[test]
fn all_three_phases_of_a_jump_are_checked() {
    for dialect in Dialect::ALL {
        let desk = Desk::at(200.0, -60.0, 0.0).speaking(dialect);
        // Up into a shelf, across into a post, down into a box.
        let shelf = "[keep_out.it]\nbox = { x_mm = [200, 300], y_mm = [-80, -40], z_mm = [25, 60] }\n[arm]\nradius_mm = 0";
        let post = "[keep_out.it]\nbox = { x_mm = [150, 300], y_mm = [-5, 5], z_mm = [-103, 15] }";
        let below = "[keep_out.it]\nbox = { x_mm = [180, 300], y_mm = [40, 80], z_mm = [-103, -39] }\n[arm]\nradius_mm = 0";
        let mut lifted = desk.clone();
        lifted.model.settings.jump_height = dobot_arm::Millimeters(30.0);
        lifted.allows(go(Jump, 200.0, 60.0, 0.0));
        for policy in [shelf, post, below] {
            lifted
                .clone()
                .under(policy)
                .refuses("keep_out.it", go(Jump, 200.0, 60.0, 0.0));
        }
    }
}

#[test]
fn targets_beyond_reach_name_the_rule_and_the_nearest_value() {
    let violation = Desk::at(200.0, 0.0, 0.0).refuses("joints.opening", go(MovL, 340.0, 0.0, 0.0));
    assert_near(
        violation.value.as_ref().expect("a value").nearest,
        35.0,
        1e-9,
    );
}

#[test]
fn mouse_gesture_and_voice_are_checked_in_both_dialects() {
    let wall = "[keep_out.wall]\nbox = { x_mm = [240, 321], y_mm = [-200, 200], z_mm = [-103, 136] }\n[arm]\nradius_mm = 0";
    let desk = Desk::at(200.0, 0.0, 0.0).under(wall);
    let mouse = |x| MouseMove {
        y: 0.0,
        x,
        z: 0.0,
        rotation_deg: 0.0,
        suction: false,
    };
    desk.allows(mouse(30.0));
    desk.refuses("keep_out.wall", mouse(60.0));
    let voice = |text| Voice::new(text).expect("it is printable");
    desk.allows(voice("ahead thirty"));
    desk.refuses("keep_out.wall", voice("ahead fifty"));
    let hand = |x| Gesture {
        x,
        y: 0.0,
        z: 200.0,
        grab: false,
    };
    desk.allows(Gesture {
        z: 0.0,
        ..hand(220.0)
    });
    desk.refuses(
        "keep_out.wall",
        Gesture {
            z: 0.0,
            ..hand(260.0)
        },
    );
    let stock = desk.speaking(Dialect::FIRMWARE_1_1);
    stock.allows(mouse(20.0));
    stock.refuses("keep_out.wall", mouse(150.0));
    stock.refuses("keep_out.wall", hand(60.0));
}

#[test]
fn a_tool_that_would_reach_into_the_table_may_not_be_set() {
    let policy = "[tool_length]\nlaser_mm = 100";
    let tool = Configuration::EndEffector {
        tool: Tool::Laser.into(),
    };
    Desk::at(200.0, 0.0, 20.0).under(policy).allows(tool);
    let violation = Desk::at(200.0, 0.0, -20.0)
        .under(policy)
        .refuses("table", tool);
    assert_near(
        violation.value.as_ref().expect("a value").nearest,
        -3.0,
        1e-9,
    );
}

#[test]
fn initial_angles_beyond_the_joint_limits_are_refused() {
    let desk = Desk::at(200.0, 0.0, 0.0).under("[joints]\nrear_deg = [0, 60]");
    let angles = |rear_deg| Configuration::InitialAngles {
        rear_deg,
        fore_deg: 45.0,
    };
    desk.allows(angles(45.0));
    desk.refuses("joints.rear", angles(70.0));
}

#[test]
fn a_move_that_would_lose_the_pose_is_refused_by_its_own_rule() {
    let desk = Desk::at(200.0, 0.0, 0.0);
    desk.refuses("arm", go(MovJ, f32::NAN, 0.0, 0.0));
    desk.refuses("arm", vector(f32::INFINITY, 0.0, 0.0));
    let stock = desk.speaking(Dialect::FIRMWARE_1_1);
    let here = stock.refuses("arm", go(MovL, 200.0, 0.0, 0.0));
    assert!(here.to_string().contains("lose its pose"), "{here}");
}

#[test]
fn each_tool_has_the_length_given_by_the_policy_and_a_pen_that_of_the_cup() {
    let policy = "[tool_length]\nsuction_cup_mm = 51\ngripper_mm = 52\nlaser_mm = 53";
    let lengths = dobot_safety::Policy::from_toml(policy)
        .expect("a policy")
        .tool_length;
    let tools = [Tool::SuctionCup, Tool::Gripper, Tool::Laser, Tool::Pen];
    assert_eq!(tools.map(|tool| lengths.of(tool)), [51.0, 52.0, 53.0, 51.0]);
}
