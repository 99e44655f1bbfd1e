//! When and where the laser may burn.

use dobot_motion::burns;
use dobot_wire::{
    Command, Dialect, JointJogAxis, LinearJogAxis, MovingMode::MovL, WriteMode, WriteVector,
};

use crate::desk::{Desk, burning, go, jog, slide, vector};

#[test]
fn every_command_that_switches_the_laser_on_is_known() {
    let stop = WriteVector {
        stop: true,
        ..burning(0.0, 0.0)
    };
    let lights = [
        Command::from(jog(JointJogAxis::LaserOn, 0.0)),
        slide(LinearJogAxis::LaserOn, 0.0).into(),
        burning(10.0, 0.0).into(),
        WriteVector {
            mode: WriteMode::Writing,
            ..burning(10.0, 0.0)
        }
        .into(),
        stop.into(),
    ];
    assert!(lights.iter().all(burns));
    let dark = [
        Command::from(jog(JointJogAxis::LaserOff, 0.0)),
        vector(10.0, 0.0, 0.0).into(),
        go(MovL, 200.0, 0.0, 0.0).into(),
    ];
    assert!(!dark.iter().any(burns));
}

#[test]
fn a_forbidden_laser_is_never_switched_on() {
    let desk = Desk::at(200.0, 0.0, 0.0).under("[laser]\nallowed = false\nstanding = true");
    desk.refuses("laser.allowed", burning(10.0, 0.0));
    desk.refuses("laser.allowed", jog(JointJogAxis::LaserOn, 0.0));
    desk.allows(WriteVector {
        laser: false,
        ..burning(10.0, 0.0)
    });
    desk.allows(jog(JointJogAxis::LaserOff, 0.0));
}

#[test]
fn a_laser_burns_only_within_its_area() {
    let area =
        "[laser]\nlongest_s = 10\narea = { x_mm = [150, 250], y_mm = [-50, 50], z_mm = [-50, 10] }";
    let desk = Desk::at(200.0, 0.0, 0.0).under(area);
    desk.allows(burning(50.0, 50.0));
    let violation = desk.refuses("laser.area", burning(0.0, 60.0));
    assert_eq!(violation.value.map(|value| value.nearest), Some(50.0));
    desk.allows(vector(0.0, 60.0, 0.0));
    // Outside already: coming back in burns too.
    Desk::at(200.0, 60.0, 0.0)
        .under(area)
        .refuses("laser.area", burning(0.0, -60.0));
}

#[test]
fn a_laser_left_on_is_kept_within_its_area_in_every_motion() {
    let area =
        "[laser]\nlongest_s = 10\narea = { x_mm = [150, 250], y_mm = [-50, 50], z_mm = [-50, 10] }";
    let mut desk = Desk::at(200.0, 0.0, 0.0).under(area);
    desk.model.laser = true;
    desk.refuses("laser.area", go(MovL, 200.0, 80.0, 0.0));
    desk.allows(go(MovL, 200.0, 40.0, 0.0));
    let mut edge = Desk::at(200.0, 45.0, 0.0).under(area);
    edge.allows(slide(LinearJogAxis::YPlus, 100.0));
    edge.model.laser = true;
    edge.refuses("laser.area", slide(LinearJogAxis::YPlus, 100.0));
}

#[test]
fn a_laser_does_not_burn_while_the_arm_is_at_rest() {
    let desk = Desk::at(200.0, 0.0, 0.0);
    desk.refuses("laser.standing", jog(JointJogAxis::LaserOn, 0.0));
    let stock = desk.clone().speaking(Dialect::FIRMWARE_1_1);
    let stop = WriteVector {
        stop: true,
        ..burning(0.0, 0.0)
    };
    stock.refuses("laser.standing", stop);
    stock.allows(WriteVector {
        laser: false,
        ..stop
    });
    let focusing = desk.under("[laser]\nstanding = true");
    focusing.allows(jog(JointJogAxis::LaserOn, 0.0));
    let mut high = Desk::at(200.0, 0.0, 100.0).under("[laser]\nstanding = true");
    high.refuses("laser.area", jog(JointJogAxis::LaserOn, 0.0));
    high.model.laser = true;
    high.policy.laser.standing = false;
    let mut resting = go(MovL, 200.0, 0.0, 50.0);
    resting.pause_s = 1.0;
    high.refuses("laser.standing", resting);
}

#[test]
fn a_laser_that_is_too_slow_is_refused() {
    let desk = Desk::at(200.0, 0.0, 0.0).under("[laser]\nlongest_s = 10\nleast_speed_mm_s = 5");
    let at = |max_speed_mm_s| WriteVector {
        max_speed_mm_s,
        ..burning(10.0, 0.0)
    };
    desk.allows(at(5.0));
    desk.refuses("laser.least_speed", at(4.0));
}

#[test]
fn a_line_that_burns_for_too_long_is_split_into_shorter_vectors() {
    // 96 mm at 3 mm/s, from and to that speed: 32 s.
    let at_speed = |length_mm: f32| WriteVector {
        start_speed_mm_s: 3.0,
        end_speed_mm_s: 3.0,
        max_speed_mm_s: 3.0,
        ..burning(0.0, length_mm)
    };
    for dialect in [Dialect::SPECIFICATION, Dialect::FIRMWARE_1_1] {
        let desk = Desk::at(200.0, -48.0, 0.0)
            .speaking(dialect)
            .under("[laser]\nlongest_s = 1");
        let violation = desk.refuses("laser.longest", at_speed(96.0));
        assert!(violation.to_string().contains("shorter"), "{violation}");
        assert_eq!(violation.value.map(|value| value.nearest), Some(1.0));
        desk.allows(at_speed(2.5));
        desk.allows(WriteVector {
            laser: false,
            mode: WriteMode::Writing,
            ..at_speed(96.0)
        });
        desk.clone()
            .under("[laser]\nlongest_s = 60")
            .allows(at_speed(96.0));
    }
}
