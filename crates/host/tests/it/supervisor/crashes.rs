//! The station is killed in the middle of a job.

use std::time::Duration;

use dobot_api::JobState;
use dobot_api::Request;
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use proptest::prelude::*;

use super::drawing::{drawn_mm, spiral, virtual_station, wanted_mm};

/// Returns whether the arm is at rest and the job can be started or resumed: one killed in its
/// first moments has not started.
fn rests(station: &VirtualStation, job: u64) -> bool {
    let state = station.job(job).unwrap().state;
    station.supervisor().is_at_rest() && matches!(state, JobState::Queued | JobState::Paused { .. })
}

/// Draws a spiral and kills the station this many milliseconds after the start and after each
/// resume.
fn draw_with_crashes(personality: Personality, kills_ms: &[u64], away_ms: u64) {
    let mut station = virtual_station(personality);
    let drawing = spiral(12);
    let job = station.submit(&drawing).unwrap();
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.start(anna, job).unwrap();
    for &kill_ms in kills_ms {
        station.run_for(Duration::from_millis(kill_ms));
        if station.job(job).unwrap().state.is_over() {
            break;
        }
        station.crash(Duration::from_millis(away_ms)).unwrap();
        let was_running = station.supervisor().job().is_some();
        let minute = station.now() + Duration::from_secs(60);
        assert!(
            station.run_until(minute, |station| rests(station, job)),
            "it is paused, not lost"
        );
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        if was_running {
            // The person looks at the arm first.
            let refused = station.start(anna, job).unwrap_err();
            assert!(
                refused.hint().is_some_and(|hint| hint.contains("confirm")),
                "{refused}"
            );
        }
        station.ask(anna, Request::ConfirmPose).unwrap();
        station.start(anna, job).unwrap();
    }
    let minutes = station.now() + Duration::from_secs(180);
    assert!(station.run_until(minutes, |station| station.job(job).unwrap().state.is_over()));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
    let (found_mm, wanted_mm) = (drawn_mm(&station), wanted_mm(&drawing));
    assert!(
        (found_mm - wanted_mm).abs() < 0.3,
        "{found_mm} mm were drawn, wanted are {wanted_mm} mm: a vector was lost or repeated"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn no_vector_is_lost_or_repeated_whenever_the_station_is_killed(
        kills_ms in prop::collection::vec(0_u64..20_000, 1..3),
        away_ms in 1_u64..5_000,
        twin in any::<bool>(),
    ) {
        let personality = Personality::ALL[usize::from(twin)];
        draw_with_crashes(personality, &kills_ms, away_ms);
    }
}
