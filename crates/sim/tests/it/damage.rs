//! A client and a virtual arm with something bad between them.

use std::time::Duration;

use crate::common::{button, completed, in_process, move_to, ms, refusals, run};
use dobot_arm::Position;
use dobot_geometry::Random;
use dobot_session::{Connection, Event, LinkError, NoStatus, Peer};
use dobot_sim::InProcess;
use dobot_wire::{Command, Dialect, JointJogAxis, MovingMode};

/// Drops, flips and inserts bytes on the way from the arm.
#[derive(Debug)]
struct Damaging {
    arm: InProcess,
    random: Random,
    /// One byte of so many is damaged.
    one_of: u32,
}

impl Peer for Damaging {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        self.arm.send(bytes);
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        let mut sent = Vec::new();
        let open = self.arm.receive(until, &mut sent);
        for byte in sent {
            if self.random.below(self.one_of) > 0 {
                bytes.push(byte);
                continue;
            }
            match self.random.below(3) {
                0 => {}
                1 => bytes.push(byte ^ (1 << self.random.below(8))),
                _ => bytes.extend([byte_of(&mut self.random), byte]),
            }
        }
        open
    }
}

/// An arm that falls silent for ever after a number of bytes.
#[derive(Debug)]
struct FallingSilent {
    arm: InProcess,
    bytes_left: usize,
}

impl Peer for FallingSilent {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        self.arm.send(bytes);
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        while self.arm.now() < until && bytes.is_empty() {
            let mut sent = Vec::new();
            self.arm.receive(until, &mut sent);
            sent.truncate(self.bytes_left);
            self.bytes_left -= sent.len();
            bytes.append(&mut sent);
        }
        true
    }
}

/// Something that is no arm: bytes at random, ten every ten milliseconds.
#[derive(Debug)]
struct Noise {
    now: Duration,
    random: Random,
}

impl Peer for Noise {
    fn now(&self) -> Duration {
        self.now
    }

    fn send(&mut self, _: &[u8]) {}

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        self.now = (self.now + ms(10)).min(until);
        bytes.extend((0..10).map(|_| byte_of(&mut self.random)));
        true
    }
}

fn byte_of(random: &mut Random) -> u8 {
    u8::try_from(random.below(256)).expect("it is below 256")
}

fn grabbing_program() -> Vec<Command> {
    let mut program = crate::common::program();
    program.insert(2, button(JointJogAxis::SuctionOn, 0.0).into());
    program
}

#[tokio::test]
async fn damaged_statuses_cost_time_and_nothing_else() {
    let program = grabbing_program();
    let mut resyncs = 0;
    for seed in 0..100 {
        let arm = in_process();
        let damaging = Damaging {
            arm: arm.clone(),
            random: Random::new(seed),
            one_of: 200,
        };
        let mut connection = Connection::over_peer(damaging, Some(Dialect::SPECIFICATION));
        let events = run(&mut connection, &program).await;
        let all: Vec<u64> = (0..program.len() as u64).collect();
        assert_eq!(completed(&events), all, "seed {seed}: {events:?}");
        assert_eq!(refusals(&arm), [], "seed {seed}");
        let counters = *arm.arm().controller().counters();
        assert_eq!(counters.packets, program.len() as u64, "seed {seed}");
        let now = arm.now();
        let position = arm.arm().controller().pose_at(now).position;
        let apart_mm = position.distance(Position::new(200.0, 0.0, 0.0)).0;
        assert!(apart_mm < 1e-6, "seed {seed}: {position:?}");
        resyncs += connection.session().counts().resyncs;
    }
    assert!(resyncs > 500, "there was too little damage: {resyncs}");
}

#[tokio::test]
async fn an_arm_that_falls_silent_is_a_lost_link_a_second_later() {
    for statuses in [1, 2, 7] {
        // With half a status more, which says nothing.
        let silent = FallingSilent {
            arm: in_process(),
            bytes_left: statuses * 42 + 21,
        };
        let mut connection = Connection::over_peer(silent, Some(Dialect::SPECIFICATION));
        for _ in 0..statuses {
            connection.next_status().await.expect("so many come");
        }
        let heard = connection.now();
        let event = connection.next_event().await.expect("it is open");
        let second = Duration::from_secs(1);
        let lost = Event::LinkLost {
            silent_for: second,
            received: NoStatus::Other { bytes: 21 },
        };
        assert_eq!(event, lost);
        assert_eq!(connection.now(), heard + second);
    }
}

#[tokio::test]
async fn an_arm_that_falls_silent_on_its_way_is_a_lost_link_too() {
    let silent = FallingSilent {
        arm: in_process(),
        bytes_left: 5 * 42,
    };
    let mut connection = Connection::over_peer(silent, Some(Dialect::SPECIFICATION));
    let id = connection
        .send(move_to(MovingMode::MovL, 200.0, 80.0, 0.0))
        .expect("it is allowed");
    let error = connection.completed(id).await.expect_err("nobody knows");
    assert!(
        matches!(
            error,
            LinkError::Silent {
                received: NoStatus::Nothing,
                ..
            }
        ),
        "{error}"
    );
    assert!(connection.now() < Duration::from_secs(2));
}

#[tokio::test]
async fn a_peer_that_sends_only_noise_is_no_arm_and_the_noise_is_counted() {
    for seed in 0..20 {
        let noise = Noise {
            now: Duration::ZERO,
            random: Random::new(seed),
        };
        let mut connection = Connection::over_peer(noise, None);
        let error = connection.next_status().await.expect_err("it is no arm");
        let LinkError::Silent {
            silent_for,
            received,
        } = error
        else {
            panic!("{error}");
        };
        assert_eq!(silent_for, Duration::from_secs(5));
        assert_eq!(
            received,
            NoStatus::Other { bytes: 5000 },
            "ten bytes every ten milliseconds"
        );
    }
}
