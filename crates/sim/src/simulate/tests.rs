use proptest::prelude::*;

use super::*;

/// The control tick, in milliseconds, in which the pump first runs.
fn pump_ms(script: &str, personality: Personality) -> Option<u128> {
    let mut since = None;
    let script = script.parse().unwrap();
    simulate_watched(&script, personality, |at, controller| {
        if controller.suction() && since.is_none() {
            since = Some(at.as_millis());
        }
    })
    .unwrap();
    since
}

fn specification(script: &str) -> Simulation {
    simulate(&script.parse().unwrap(), Personality::Specification).unwrap()
}

/// The button that switches the pump on.
const PUMP: &str = "2 9 0 0 0 0 0 50 0 0";

#[test]
fn a_run_has_the_ticks_before_its_end_and_a_status_every_fourth() {
    let simulation = specification("!end 500");
    assert_eq!(simulation.trace.ticks.len(), 25);
    let ticks: Vec<_> = simulation.trace.statuses.iter().map(|it| it.tick).collect();
    assert_eq!(ticks, [3, 7, 11, 15, 19, 23]);
    assert_eq!(simulation.end, Duration::from_millis(500));
    assert_eq!(specification("!end 501").trace.ticks.len(), 26);
    assert_eq!(specification("!end 0").trace.ticks.len(), 0);
}

#[test]
fn a_packet_acts_in_the_first_tick_at_or_after_its_last_byte() {
    for personality in Personality::ALL {
        // 43.68 ms on the line.
        for (start, acts) in [("100", 160), ("116", 160), ("116.32", 160), ("117", 180)] {
            let script = format!("!end 400\n{start} {PUMP}");
            assert_eq!(
                pump_ms(&script, personality),
                Some(acts),
                "{start} {personality}"
            );
        }
    }
}

#[test]
fn lines_wait_for_the_bytes_still_on_the_line() {
    // Two packets and 90 bytes behind each other: 174 bytes of 1.04 ms end at 180.96.
    let script = format!("!end 400\n0 1 0 0 0 0 0 0 0 0 0\nraw 0 90*00\n0 {PUMP}");
    assert_eq!(pump_ms(&script, Personality::Specification), Some(200));
}

#[test]
fn an_answer_to_a_status_acts_five_ticks_after_its_tick() {
    for personality in Personality::ALL {
        // The first status is that of tick 3.
        let script = format!("!end 400\ncredit {PUMP}");
        assert_eq!(pump_ms(&script, personality), Some(160), "{personality}");
        // That of tick 7 is the next behind a line that was let go at 110 ms.
        let script = format!("!end 400\nraw 120 00\ncredit {PUMP}");
        assert_eq!(pump_ms(&script, personality), Some(240), "{personality}");
        // One status lets one line go.
        let script = format!("!end 400\nraw credit 00\nraw credit 00\ncredit {PUMP}");
        assert_eq!(pump_ms(&script, personality), Some(320), "{personality}");
    }
}

#[test]
fn on_bluetooth_the_status_with_a_small_x_lets_a_line_go() {
    // Ticks 0, 2, 4 and 8, 10, 12 upload; x of ticks 0 and 4 has 1000 more. The status of tick 2
    // waits until that of tick 0 has left.
    let script = format!("!port bt\n!end 400\ncredit {PUMP}");
    assert_eq!(pump_ms(&script, Personality::Firmware11), Some(140));
}

#[test]
fn what_is_not_sent_at_the_end_is_counted() {
    let simulation =
        specification("!end 100\nraw 50 100*00\nraw credit 00\n900 0 0 0 0 0 0 0 0 0 0");
    assert_eq!(simulation.unsent, 3);
    assert_eq!(specification("!end 100\nraw 50 10*00").unsent, 0);
}

#[test]
fn refusals_are_reported_with_their_tick() {
    let simulation = specification("!end 300\n100 77 0 0 0 0 0 0 0 0 0");
    let [(at, refused)] = simulation.refused[..] else {
        panic!("{:?}", simulation.refused);
    };
    assert_eq!(at, Duration::from_millis(160));
    assert!(matches!(refused, Refused::Unreadable(_)), "{refused}");
}

#[test]
fn a_script_without_an_end_runs_until_the_arm_has_stood_still_for_a_second() {
    let simulation = specification("3000 3 0 240 0 0 0 0 2 0 0");
    assert_eq!(simulation.unsent, 0);
    let end = simulation.end;
    let last = simulation
        .trace
        .ticks
        .iter()
        .rposition(|it| it.outputs.pulses != [0; 3]);
    let last = TICK * u32::try_from(last.unwrap()).unwrap();
    assert!(
        last > Duration::from_secs(3) && end == last + STILL,
        "{last:?} {end:?}"
    );
    assert_eq!(specification("").end, STILL);
}

#[test]
fn a_script_without_an_end_does_not_wait_for_ever() {
    // Nobody ends the jog; it comes to its limit.
    let jog = specification("0 2 7 0 0 0 0 0 1 0 0");
    assert!(jog.end <= Duration::from_secs(121), "{:?}", jog.end);
    // Seven commands that take a long time: no status lets the last line go.
    let long = |n: u32| format!("0 3 0 {} 0 0 0 0 2 0 500\n", 220 + n);
    let moves: String = (0..7).map(long).collect();
    let hung = specification(&format!(
        "0 10 0 1 1 50 0 0 0 0 0\n{moves}raw 500 00\ncredit {PUMP}"
    ));
    assert_eq!(hung.unsent, 1);
    assert!(hung.end < Duration::from_mins(5), "{:?}", hung.end);
}

#[test]
fn the_document_knows_no_bluetooth_port() {
    let script = "!port bt".parse().unwrap();
    let error = simulate(&script, Personality::Specification).unwrap_err();
    assert!(error.to_string().contains("firmware-1.1"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_same_script_gives_the_same_bytes(
        floats in prop::collection::vec(prop::collection::vec(0_i16..300, 10), 1..12),
    ) {
        let line = |floats: Vec<i16>| {
            let words: Vec<_> = floats.iter().map(ToString::to_string).collect();
            format!("credit {}\n", words.join(" "))
        };
        let script: String = floats.into_iter().map(line).collect();
        let script: Script = format!("!end 3000\n{script}").parse().unwrap();
        for personality in Personality::ALL {
            let [one, other] = [(); 2].map(|()| simulate(&script, personality).unwrap().trace);
            prop_assert_eq!(one.statuses_csv(), other.statuses_csv());
            prop_assert_eq!(one.ticks_csv(), other.ticks_csv());
            prop_assert_eq!(one.other_port, other.other_port);
        }
    }
}
