//! Everything that can go wrong, a few times each: the example `reliability` does it thousands of times.

use crate::cases::{
    cables, clients, disks, floods, fuzz, kills, lines, long_lines, sessions, stands, stops,
    watchdogs,
};

/// Fails with the first violation and their number.
fn right(wrong: &[String]) {
    assert!(wrong.is_empty(), "{} of them: {}", wrong.len(), wrong[0]);
}

#[test]
fn a_killed_station_loses_nothing_repeats_nothing_and_switches_the_laser_off_first() {
    let it = kills::run(60);
    right(&it.wrong);
    assert_eq!((it.lost, it.repeated, it.unclear), (0, 0, 0));
    assert_eq!((it.not_off_first, it.burnt_at_rest), (0, 0));
    assert!(it.at_work > 40 && it.burning > 5, "{it:?}");
}

#[test]
fn a_cable_may_be_pulled_in_every_phase_of_a_job() {
    for it in cables::run(18) {
        right(&it.wrong);
        assert_eq!((it.lost, it.repeated), (0, 0), "{}", it.during);
        assert_eq!(it.looks_reset, 0, "{}", it.during);
    }
}

#[test]
fn a_bad_line_never_damages_a_drawing_silently() {
    for it in lines::run(12) {
        right(&it.wrong);
        assert_eq!(it.silently_wrong, 0, "{}: {:?}", it.fault, it.example);
        if it.fault.ends_with(":from") {
            assert_eq!(it.done, it.drawings, "{}: {:?}", it.fault, it.reason);
        }
    }
}

#[test]
fn an_arm_whose_client_vanishes_is_stopped() {
    for it in clients::run(16) {
        right(&it.wrong);
        assert!(it.packet_s.most() <= 0.21, "{}: {}", it.how, it.packet_s);
        assert!(it.over_s.most() < 2.5, "{}: {}", it.how, it.over_s);
        assert_eq!(it.not_free, 0, "{}", it.how);
    }
}

#[test]
fn a_watchdog_stops_every_motion_and_every_laser_after_its_station_is_killed() {
    for it in watchdogs::run(4) {
        right(&it.wrong);
        assert_eq!((it.unasked, it.burnt), (0, 0), "{} {}", it.fate, it.doing);
        assert!(it.packet_s.most() <= 0.4, "{} {}", it.fate, it.doing);
        // In-flight commands finish; a jog slows down from its speed within 1.2 s.
        if it.doing != watchdogs::GuardedMotion::Moving
            && it.doing != watchdogs::GuardedMotion::Burning
        {
            let rest_s = it.rest_s.most();
            assert!(rest_s <= 0.4 + 1.2, "{} {}: {rest_s} s", it.fate, it.doing);
        }
        assert!(
            it.stood_s.most() <= 0.5,
            "{} {}: {}",
            it.fate,
            it.doing,
            it.stood_s
        );
    }
}

#[test]
fn a_flood_overruns_neither_arm_nor_station() {
    for it in floods::run(4) {
        right(&it.wrong);
        assert_eq!((it.overrun, it.not_served), (0, 0), "{}", it.who);
        assert!(it.most_waiting <= 64, "{}: {}", it.who, it.most_waiting);
    }
}

#[test]
fn a_full_disk_pauses_the_job_which_resumes_when_there_is_space() {
    let it = disks::run(24);
    right(&it.wrong);
    assert_eq!((it.lost, it.repeated), (0, 0));
    assert!(it.paused > 8, "{it:?}");
}

#[test]
fn the_arm_rests_within_the_promised_time_in_every_state() {
    for it in stops::run(30) {
        right(&it.wrong);
        assert_eq!((it.late, it.burnt), (0, 0), "{}", it.doing);
    }
}

#[test]
fn a_long_line_in_the_arm_is_over_soon_after_any_interruption() {
    for it in long_lines::run(4) {
        right(&it.wrong);
        let what = if it.burns { "light" } else { "motion" };
        assert_eq!(it.late, 0, "{} of {}: {:?}", what, it.material, it.ends);
    }
}

#[test]
fn the_laser_does_not_burn_on_the_spot_for_any_sender() {
    for it in stands::run(12) {
        right(&it.wrong);
        assert_eq!(it.late, 0, "{} {}: {}", it.sender, it.link, it.stood_s);
        assert_eq!(it.displaced, 0, "{} {}", it.sender, it.link);
        assert!(it.stood_s.most() <= stands::MAX_S, "{}", it.stood_s);
    }
}

#[test]
fn no_request_can_make_the_arm_lose_its_pose() {
    let it = fuzz::run(0, 200);
    right(&it.wrong);
    assert!(it.taken > it.requests / 5 && it.packets > 10_000, "{it:?}");
}

#[test]
fn after_any_sequence_of_faults_the_arm_rests_with_the_laser_off_and_all_reports_were_true() {
    let it = sessions::run(60);
    right(&it.wrong);
    assert!(it.times == 60 && it.incidents > 100, "{it:?}");
    assert!(it.jobs > 5 && it.undelivered > 0, "{it:?}");
}
