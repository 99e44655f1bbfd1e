//! Everything that can go wrong, a few times each: the example `reliability` does it thousands of times.

use crate::cases::{
    cables, clients, disks, floods, fuzz, kills, lines, long_lines, sessions, standing_laser,
    stops, watchdogs,
};

/// Fails with the first violation and their number.
fn right(wrong: &[String]) {
    assert!(wrong.is_empty(), "{} of them: {}", wrong.len(), wrong[0]);
}

#[test]
fn a_killed_station_loses_nothing_repeats_nothing_and_switches_the_laser_off_first() {
    let figures = kills::run(60);
    right(&figures.wrong);
    assert_eq!((figures.lost, figures.repeated, figures.unclear), (0, 0, 0));
    assert_eq!((figures.not_off_first, figures.burnt_at_rest), (0, 0));
    assert!(figures.at_work > 40 && figures.burning > 5, "{figures:?}");
}

#[test]
fn a_cable_may_be_pulled_in_every_phase_of_a_job() {
    for figures in cables::run(18) {
        right(&figures.wrong);
        assert_eq!(
            (figures.lost, figures.repeated),
            (0, 0),
            "{}",
            figures.during
        );
        assert_eq!(figures.looks_reset, 0, "{}", figures.during);
    }
}

#[test]
fn a_bad_line_never_damages_a_drawing_silently() {
    for figures in lines::run(12) {
        right(&figures.wrong);
        assert_eq!(
            figures.silently_wrong, 0,
            "{}: {:?}",
            figures.fault, figures.example
        );
        if figures.fault.ends_with(":from") {
            assert_eq!(
                figures.done, figures.drawings,
                "{}: {:?}",
                figures.fault, figures.reason
            );
        }
    }
}

#[test]
fn an_arm_whose_client_vanishes_is_stopped() {
    for figures in clients::run(16) {
        right(&figures.wrong);
        assert!(
            figures.packet_s.most() <= 0.21,
            "{}: {}",
            figures.how,
            figures.packet_s
        );
        assert!(
            figures.over_s.most() < 2.5,
            "{}: {}",
            figures.how,
            figures.over_s
        );
        assert_eq!(figures.not_free, 0, "{}", figures.how);
    }
}

#[test]
fn a_watchdog_stops_every_motion_and_every_laser_after_its_station_is_killed() {
    for figures in watchdogs::run(4) {
        right(&figures.wrong);
        assert_eq!(
            (figures.unasked, figures.burnt),
            (0, 0),
            "{} {}",
            figures.fate,
            figures.doing
        );
        assert!(
            figures.packet_s.most() <= 0.4,
            "{} {}",
            figures.fate,
            figures.doing
        );
        // In-flight commands finish; a jog slows down from its speed within 1.2 s.
        if figures.doing != watchdogs::GuardedMotion::Moving
            && figures.doing != watchdogs::GuardedMotion::Burning
        {
            let rest_s = figures.rest_s.most();
            assert!(
                rest_s <= 0.4 + 1.2,
                "{} {}: {rest_s} s",
                figures.fate,
                figures.doing
            );
        }
        assert!(
            figures.stood_s.most() <= 0.5,
            "{} {}: {}",
            figures.fate,
            figures.doing,
            figures.stood_s
        );
    }
}

#[test]
fn a_flood_overruns_neither_arm_nor_station() {
    for figures in floods::run(4) {
        right(&figures.wrong);
        assert_eq!(
            (figures.overrun, figures.not_served),
            (0, 0),
            "{}",
            figures.who
        );
        assert!(
            figures.most_waiting <= 64,
            "{}: {}",
            figures.who,
            figures.most_waiting
        );
    }
}

#[test]
fn a_full_disk_pauses_the_job_which_resumes_when_there_is_space() {
    let figures = disks::run(24);
    right(&figures.wrong);
    assert_eq!((figures.lost, figures.repeated), (0, 0));
    assert!(figures.paused > 8, "{figures:?}");
}

#[test]
fn the_arm_rests_within_the_promised_time_in_every_state() {
    for figures in stops::run(30) {
        right(&figures.wrong);
        assert_eq!((figures.late, figures.burnt), (0, 0), "{}", figures.doing);
    }
}

#[test]
fn a_long_line_in_the_arm_is_over_soon_after_any_interruption() {
    for figures in long_lines::run(4) {
        right(&figures.wrong);
        let what = if figures.burns { "light" } else { "motion" };
        assert_eq!(
            figures.late, 0,
            "{} of {}: {:?}",
            what, figures.material, figures.ends
        );
    }
}

#[test]
fn the_laser_does_not_burn_on_the_spot_for_any_sender() {
    for figures in standing_laser::run(12) {
        right(&figures.wrong);
        assert_eq!(
            figures.late, 0,
            "{} {}: {}",
            figures.sender, figures.link, figures.stood_s
        );
        assert_eq!(figures.displaced, 0, "{} {}", figures.sender, figures.link);
        assert!(
            figures.stood_s.most() <= standing_laser::MAX_S,
            "{}",
            figures.stood_s
        );
    }
}

#[test]
fn no_request_can_make_the_arm_lose_its_pose() {
    let figures = fuzz::run(0, 200);
    right(&figures.wrong);
    assert!(
        figures.taken > figures.requests / 5 && figures.packets > 10_000,
        "{figures:?}"
    );
}

#[test]
fn after_any_sequence_of_faults_the_arm_rests_with_the_laser_off_and_all_reports_were_true() {
    let figures = sessions::run(60);
    right(&figures.wrong);
    assert!(
        figures.times == 60 && figures.incidents > 100,
        "{figures:?}"
    );
    assert!(figures.jobs > 5 && figures.undelivered > 0, "{figures:?}");
}
