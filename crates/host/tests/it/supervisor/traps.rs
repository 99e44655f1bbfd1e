//! Packets that make a stock arm hang or lose its pose are never sent (note N51).

use std::time::Duration;

use dobot_api::{ClientId, Request};
use dobot_controller::{Personality, Refused};
use dobot_host::VirtualStation;
use dobot_supervisor::Refusal;
use dobot_wire::{
    Command, Configuration, Dialect, Frame, Gesture, MouseMove, MoveTo, MovingMode, Packet,
    WriteMode, WriteVector,
};

use super::drawing::virtual_station;
use crate::cases::commands::target;

const STOCK: Dialect = Dialect::FIRMWARE_1_1;

/// The way a command is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    Api,
    Raw,
}

fn stock() -> (VirtualStation, ClientId) {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    (station, anna)
}

fn send(
    station: &mut VirtualStation,
    client: ClientId,
    by: By,
    command: Command,
) -> Result<(), Refusal> {
    match by {
        By::Api => station.ask(client, Request::Command { command }).map(drop),
        By::Raw => station.send_raw(client, &command.emit(&STOCK)),
    }
}

fn go(station: &mut VirtualStation, client: ClientId, command: impl Into<Command>) {
    send(station, client, By::Api, command.into()).unwrap();
    station.run_for(Duration::from_secs(6));
}

const fn line(place: [f32; 3]) -> MoveTo {
    MoveTo {
        mode: MovingMode::MovL,
        ..target(place)
    }
}

/// The arm hangs in none of its commands, knows where it is, and goes where it is sent.
fn is_well(station: &mut VirtualStation, client: ClientId, what: &str) {
    station.run_for(Duration::from_secs(3));
    while let Some(refused) = station.arm_mut().poll_refused() {
        let is_lost = matches!(refused, Refused::Hangs(_) | Refused::PoseLost);
        assert!(!is_lost, "{what}: {refused}");
    }
    let there = MoveTo {
        mode: MovingMode::MovJ,
        ..target([210.0, 25.0, 12.0])
    };
    go(station, client, there);
    let status = station.supervisor().state().arm.unwrap().status;
    let off_mm = (status.y_mm - 25.0).abs() + (status.z_mm - 12.0).abs();
    assert!(off_mm < 0.01, "{what}: off by {off_mm} mm");
}

fn mouse([y, x, z]: [f32; 3]) -> Command {
    MouseMove {
        y,
        x,
        z,
        rotation_deg: 0.0,
        suction: false,
    }
    .into()
}

fn hand([x, y, z]: [f32; 3]) -> Command {
    Gesture {
        x,
        y,
        z,
        grab: false,
    }
    .into()
}

#[test]
fn mouse_and_hand_packets_at_any_interval_never_hang_an_arm_at_its_lower_stop() {
    let rows = [
        mouse([0.0, 0.0, -3.0]),
        mouse([0.0, 0.0, -0.1]),
        mouse([0.0, 1e-6, -3.0]),
        hand([-40.0, 0.0, -50.0]),
        hand([-40.0, 0.0, -5.0]),
        hand([-40.0, 10.0, 200.0]),
    ];
    let gaps_ms = [60, 80, 90, 130, 170, 230, 300];
    let starts = [
        [200.0, 0.0, -30.0],
        [231.0, 40.0, -30.0],
        [210.0, 0.0, -29.0],
        [230.0, -20.0, -28.0],
    ];
    for (row, start) in rows
        .into_iter()
        .flat_map(|row| starts.map(|start| (row, start)))
    {
        for gap_ms in gaps_ms {
            let by = if gap_ms % 20 == 0 { By::Api } else { By::Raw };
            let (mut station, anna) = stock();
            go(&mut station, anna, line(start));
            for _ in 0..30 {
                // Most are refused, as they move nothing.
                let _ = send(&mut station, anna, by, row);
                station.run_for(Duration::from_millis(gap_ms));
            }
            let what = format!("{row:?} from {start:?} every {gap_ms} ms by {by:?}");
            is_well(&mut station, anna, &what);
        }
    }
}

#[test]
fn a_mouse_moving_back_and_forth_is_followed_and_never_hangs_the_arm() {
    for by in [By::Api, By::Raw] {
        let (mut station, anna) = stock();
        let mut taken = 0;
        for round in 0..80_u8 {
            // Whole units, as a mouse sends them: their averages are often 0.
            let y = [6.0, 2.0, -4.0, -4.0, 0.0, 3.0, -3.0][usize::from(round % 7)];
            taken += u32::from(send(&mut station, anna, by, mouse([y, 0.0, 0.0])).is_ok());
            station.run_for(Duration::from_millis(100));
        }
        assert!(taken > 60, "{by:?}: {taken} of 80 were sent");
        is_well(&mut station, anna, &format!("{by:?}"));
    }
}

#[test]
fn a_gesture_after_mouse_packets_is_averaged_with_their_remainder() {
    // The recording p47: the arm is expected to be there when the second gesture is over.
    let (mut station, anna) = stock();
    for (by, wait_ms) in [
        (mouse([4.0, 6.0, -5.0]), 200),
        (mouse([4.0, 6.0, -5.0]), 400),
        (hand([0.0, 0.0, 200.0]), 600),
        (hand([0.0, 10.0, 205.0]), 600),
    ] {
        send(&mut station, anna, By::Api, by).unwrap();
        station.run_for(Duration::from_millis(wait_ms));
    }
    let place = station
        .supervisor()
        .session()
        .model()
        .unwrap()
        .place
        .pose
        .position;
    let status = station.supervisor().state().arm.unwrap().status;
    for (foreseen, reported) in [
        (place.x, status.x_mm),
        (place.y, status.y_mm),
        (place.z, status.z_mm),
    ] {
        let off = (foreseen.0 - f64::from(reported)).abs();
        assert!(off < 0.001, "foreseen {foreseen:?}, reported {reported}");
    }
}

/// Packets of floats by state, first floats and their positions.
fn frame(floats: &[(usize, f32)]) -> Packet {
    let frame = floats
        .iter()
        .fold(Frame::ZERO, |frame, &(n, value)| frame.with(n, value));
    frame.into()
}

#[test]
fn no_packet_that_is_a_trap_by_itself_is_passed_on_from_the_raw_port() {
    let speeds = |n: usize, value: f32| {
        let all = [
            (3, 90.0),
            (4, 90.0),
            (5, 90.0),
            (6, 90.0),
            (7, 60.0),
            (8, 60.0),
        ];
        let mut floats = vec![(1, 9.0), (2, 1.0), (10, 10.0)];
        floats.extend(all.map(|(at, float)| (at, if at == n { value } else { float })));
        floats
    };
    let mut traps: Vec<Vec<(usize, f32)>> = Vec::new();
    for state in [
        0.0,
        11.0,
        12.0,
        13.0,
        14.0,
        15.0,
        16.0,
        -1.0,
        3.5,
        1e9,
        f32::NAN,
        f32::INFINITY,
    ] {
        traps.push(vec![(1, state), (3, 210.0), (8, 1.0)]);
    }
    // Voice as floats, moving modes and axes that are none, laser modes and switches that are none.
    traps.push(vec![(1, 5.0)]);
    for mode in [3.0, -1.0, 2.5, f32::NAN] {
        traps.push(vec![(1, 3.0), (3, 210.0), (8, mode)]);
        traps.push(vec![(1, 6.0), (4, 45.0), (5, 45.0), (8, mode)]);
    }
    for axis in [15.0, 16.0, -1.0, 1e6, f32::NAN] {
        traps.push(vec![(1, 2.0), (2, axis), (8, 50.0)]);
        traps.push(vec![(1, 7.0), (2, axis), (8, 50.0)]);
    }
    traps.push(vec![(1, 4.0), (2, 2.0), (3, 5.0), (10, 40.0)]);
    traps.push(vec![(1, 4.0), (2, 1.0), (3, 5.0), (7, 0.5), (10, 40.0)]);
    for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        for n in 3..=8 {
            // Jog speeds of 0 and values above a ceiling are amended: see `programs`.
            if bad != 0.0 {
                let mut teach = speeds(n, bad);
                teach[1] = (2, 0.0);
                traps.push(teach);
            }
            traps.push(speeds(n, bad));
        }
        traps.push(vec![(1, 9.0), (2, 2.0), (3, bad)]);
        for n in 3..=4 {
            let other = 7 - n;
            traps.push(vec![(1, 10.0), (n, bad), (other, 50.0), (5, 50.0)]);
        }
        traps.push(vec![(1, 4.0), (3, 5.0), (10, bad)]);
    }
    // A pause of more ticks than it can count, lines and vectors without length.
    traps.push(vec![(1, 3.0), (3, 210.0), (8, 1.0), (10, 656.0)]);
    traps.push(vec![(1, 4.0), (10, 40.0)]);
    traps.push(vec![(1, 4.0), (3, 1e-4), (10, 40.0)]);
    traps.push(vec![(1, 4.0), (3, 5.0), (10, 0.001)]);
    let (mut station, anna) = stock();
    go(&mut station, anna, line([210.0, 0.0, 0.0]));
    let sent = station.packets().len();
    for floats in &traps {
        let taken = station.send_raw(anna, &frame(floats));
        assert!(taken.is_err(), "{floats:?} was sent");
        station.run_for(Duration::from_millis(100));
    }
    // Its current pose, by its place and by its angles.
    let status = station.supervisor().state().arm.unwrap().status;
    let (x, y, z) = (status.x_mm, status.y_mm, status.z_mm);
    let here = frame(&[(1, 3.0), (3, x), (4, y), (5, z), (8, 2.0)]);
    let (base, rear, fore) = (status.base_deg, status.rear_deg, status.fore_deg);
    let angles = frame(&[(1, 6.0), (3, base), (4, rear), (5, fore), (8, 2.0)]);
    assert!(station.send_raw(anna, &here).is_err() && station.send_raw(anna, &angles).is_err());
    // The refusal switched the laser off, and nothing else was sent.
    let off = [0x60, 0x41];
    for (_, packet) in &station.packets()[sent..] {
        assert_eq!(
            (&packet[3..5], &packet[7..9]),
            (&[0x00, 0x40][..], &off[..])
        );
    }
    is_well(&mut station, anna, "all of them");
}

fn vector(by: [f32; 3], end_mm_s: f32, max_mm_s: f32) -> Command {
    let [x_mm, y_mm, z_mm] = by;
    WriteVector {
        end_speed_mm_s: end_mm_s,
        ..WriteVector::by(x_mm, y_mm, z_mm, max_mm_s)
    }
    .into()
}

#[test]
fn a_vector_that_would_creep_for_ever_is_refused() {
    // The vectors of the recording p44; the last is one of laser mode without the laser.
    for by in [By::Api, By::Raw] {
        let (mut station, anna) = stock();
        let acceleration_mm_s2 = 200.0;
        go(
            &mut station,
            anna,
            Configuration::Writing { acceleration_mm_s2 },
        );
        send(
            &mut station,
            anna,
            by,
            vector([6.95, -0.3, 0.64], 0.0, 45.0),
        )
        .unwrap();
        send(
            &mut station,
            anna,
            by,
            vector([-7.95, -8.73, 0.0], 0.0, 10.0),
        )
        .unwrap();
        let Command::WriteVector(third) = vector([6.44, -11.93, 0.0], 50.0, 45.0) else {
            unreachable!("it is a vector");
        };
        let third = WriteVector {
            mode: WriteMode::Laser,
            ..third
        };
        assert!(
            send(&mut station, anna, by, third.into()).is_err(),
            "{by:?}"
        );
        station.run_for(Duration::from_secs(5));
        is_well(&mut station, anna, "creeping");
    }
}
