//! The laser never burns while the arm stands, whoever sent what burns.

use std::time::Duration;

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_safety::Policy;
use dobot_sim::{Fault, Line, RECORDING_PERIOD, VirtualArm};
use dobot_station::{ClientId, JobPhase, News, Rehearsal, Request};
use dobot_wire::{Command, Packet};

use crate::commands::vector;
use crate::drawing::{burnt_spiral, is_over, rehearsal};

/// What the laser may stand at the most.
const MOST_S: f64 = 0.3;

/// Control, and a laser that is armed.
fn armed(it: &mut Rehearsal) -> ClientId {
    let anna = it.client("Anna");
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(anna, Request::ArmLaser { for_s: 600.0 }).unwrap();
    anna
}

/// How long the laser was on at the most while the arm stood, in seconds: of the arm, not as told.
pub(crate) fn longest_stand_s(it: &Rehearsal) -> f64 {
    let mut longest_s: f64 = 0.0;
    let mut stood_s = 0.0;
    for pair in it.arm().samples().windows(2) {
        let stands = pair[1].position.distance(pair[0].position).0 < 0.001;
        stood_s = if stands && pair[1].laser {
            stood_s + pair[1].at.saturating_sub(pair[0].at).as_secs_f64()
        } else {
            0.0
        };
        longest_s = longest_s.max(stood_s);
    }
    longest_s
}

fn burns(it: &Rehearsal) -> bool {
    it.arm().controller().outputs().laser
}

/// A minute in which nothing is sent, and a motion at its end: what stood by then was recorded.
fn rest(it: &mut Rehearsal, anna: ClientId) {
    it.run_for(Duration::from_secs(5));
    let command = vector([0.0, 0.0, 5.0], false);
    it.ask(anna, Request::Command { command }).unwrap();
    it.run_for(Duration::from_secs(3));
}

#[test]
fn a_single_vector_that_burns_does_not_leave_the_laser_on() {
    for personality in Personality::ALL {
        let mut it = rehearsal(personality);
        let anna = armed(&mut it);
        let command = vector([10.0, 0.0, 0.0], true);
        it.ask(anna, Request::Command { command }).unwrap();
        let soon = it.now() + Duration::from_secs(1);
        assert!(it.run_until(soon, burns), "{personality}: it burns");
        assert!(it.keeper().state().laser.on, "{personality}");
        let later = it.now() + Duration::from_secs(2);
        assert!(it.run_until(later, |it| !burns(it)), "{personality}");
        it.run_for(Duration::from_millis(500));
        assert!(!it.keeper().state().laser.on, "{personality}");
        assert!(it.keeper().state().laser.armed_for_s > 0.0, "{personality}");
        rest(&mut it, anna);
        let stood_s = longest_stand_s(&it);
        assert!(stood_s <= MOST_S, "{personality}: {stood_s} s");
    }
}

#[test]
fn a_packet_of_a_raw_program_that_burns_does_not_leave_the_laser_on() {
    for personality in Personality::ALL {
        let mut it = rehearsal(personality);
        let program = it.client("an old program");
        let packet = vector([10.0, 0.0, 0.0], true).emit(&personality.dialect());
        assert_eq!(
            it.send_raw(program, &packet).unwrap_err().kind(),
            "laser-disarmed"
        );
        let anna = it.client("Anna");
        // Its protocol has no words for that.
        it.ask(anna, Request::ArmLaser { for_s: 600.0 }).unwrap();
        it.send_raw(program, &packet).unwrap();
        let soon = it.now() + Duration::from_secs(1);
        assert!(it.run_until(soon, burns), "{personality}: it burns");
        it.run_for(Duration::from_secs(5));
        let packet = vector([0.0, 0.0, 5.0], false).emit(&personality.dialect());
        it.send_raw(program, &packet).unwrap();
        it.run_for(Duration::from_secs(3));
        let stood_s = longest_stand_s(&it);
        assert!(stood_s <= MOST_S, "{personality}: {stood_s} s");
    }
}

#[test]
fn whoever_watches_is_told_that_the_laser_was_switched_off() {
    let mut it = rehearsal(Personality::Firmware11);
    let anna = armed(&mut it);
    let command = vector([10.0, 0.0, 0.0], true);
    it.ask(anna, Request::Command { command }).unwrap();
    it.run_for(Duration::from_secs(5));
    let told = it.notices().iter().filter(|it| it.news == News::LaserOff);
    assert_eq!(told.count(), 1, "{:?}", it.notices());
}

#[test]
fn vectors_that_follow_one_another_burn_without_a_packet_between_them() {
    for personality in Personality::ALL {
        let mut it = rehearsal(personality);
        let anna = armed(&mut it);
        let before = it.packets().len();
        for x_mm in [5.0, 6.0, 7.0, 8.0] {
            let command = vector([x_mm, 0.0, 0.0], true);
            it.ask(anna, Request::Command { command }).unwrap();
        }
        it.run_for(Duration::from_secs(8));
        let sent: Vec<Command> = it.packets()[before..]
            .iter()
            .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
            .map(|it| Command::parse(&it, &personality.dialect()).unwrap())
            .collect();
        let burning = |it: &Command| matches!(it, Command::WriteVector(_));
        assert!(sent.iter().take(4).all(burning), "{personality}: {sent:?}");
        assert_eq!(sent.iter().filter(|it| burning(it)).count(), 4);
    }
}

#[test]
fn a_policy_that_lets_the_laser_stand_lets_it_stand() {
    let power_up = PowerUp::new(Personality::Firmware11);
    let arm = VirtualArm::new(Controller::power_up(power_up), Line::STOCK);
    let mut policy = Policy::default();
    policy.laser.standing = true;
    let mut it = Rehearsal::with_arm(arm, power_up, policy);
    it.run_for(Duration::from_secs(1));
    let anna = armed(&mut it);
    let command = vector([10.0, 0.0, 0.0], true);
    it.ask(anna, Request::Command { command }).unwrap();
    it.run_for(Duration::from_secs(5));
    assert!(burns(&it));
    assert!(it.keeper().state().laser.on);
}

/// Numbers that look like chance (`SplitMix64`).
struct Chance(u64);

impl Chance {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut it = self.0;
        it = (it ^ (it >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        it = (it ^ (it >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (it ^ (it >> 31)) % end
    }
}

const LINKS: [&str; 5] = [
    "",
    "delay=80ms",
    "drop=0.3%:from",
    "delay=40ms drop=1%:from",
    "withhold@4s..4.7s withhold@6s..6.5s",
];

fn on_link(personality: Personality, link: &str, seed: u64) -> Rehearsal {
    let power_up = PowerUp::new(personality);
    let faults: Vec<Fault> = link
        .split_whitespace()
        .map(|it| it.parse().unwrap())
        .collect();
    let arm = VirtualArm::new(Controller::power_up(power_up), Line::STOCK);
    let mut arm = arm.with_faults(power_up, &faults, seed);
    arm.record(RECORDING_PERIOD);
    let mut it = Rehearsal::with_arm(arm, power_up, Policy::default());
    it.run_for(Duration::from_secs(1));
    it
}

/// A random program of vectors that burn and others, as requests or as packets, with or without time
/// between them; what is refused is refused.
fn random_program(seed: u64) -> f64 {
    let mut chance = Chance(seed);
    let personality = Personality::ALL[usize::from(seed % 2 == 1)];
    let link = LINKS[usize::try_from(seed / 2).unwrap() % LINKS.len()];
    let mut it = on_link(personality, link, seed);
    let raw = chance.below(2) == 0;
    let anna = it.client("Anna");
    let program = it.client("an old program");
    if raw {
        let dark = vector([1.0, 0.0, 0.0], false).emit(&personality.dialect());
        it.send_raw(program, &dark).unwrap();
    } else {
        it.ask(anna, Request::TakeLease).unwrap();
    }
    for step in 0_u8..25 {
        // A link that was lost has disarmed it.
        let _ = it.ask(anna, Request::ArmLaser { for_s: 600.0 });
        let length_mm = if step % 2 == 0 { 1.0 } else { -1.0 } * (1 + chance.below(12)) as f32;
        let command = match chance.below(5) {
            0 => vector([0.0, 0.0, length_mm / 4.0], false),
            1 => vector([0.0, length_mm, 0.0], false),
            _ => vector([0.0, length_mm, 0.0], true),
        };
        let _ = if raw {
            it.send_raw(program, &command.emit(&personality.dialect()))
        } else {
            it.ask(anna, Request::Command { command }).map(|_| ())
        };
        if chance.below(3) == 0 {
            it.run_for(Duration::from_millis(chance.below(900)));
        }
    }
    it.run_for(Duration::from_secs(30));
    let dark = vector([0.0, 0.0, 2.0], false);
    it.ask(anna, Request::SeizeLease).unwrap();
    let _ = it.ask(anna, Request::ConfirmPose);
    it.ask(anna, Request::Command { command: dark }).unwrap();
    it.run_for(Duration::from_secs(3));
    longest_stand_s(&it)
}

#[test]
fn no_random_program_leaves_the_laser_burning_on_the_spot() {
    let mut longest: (f64, u64) = (0.0, 0);
    for seed in 0..60 {
        let stood_s = random_program(seed);
        if stood_s > longest.0 {
            longest = (stood_s, seed);
        }
    }
    let (stood_s, seed) = longest;
    println!("the longest stand is {stood_s} s, seed {seed}");
    assert!(stood_s <= MOST_S, "seed {seed}: {stood_s} s");
}

/// A burnt job on a link, paused and gone on with; returns how long the laser stood at the most, in
/// seconds.
fn random_job(seed: u64) -> f64 {
    let mut chance = Chance(seed);
    let personality = Personality::ALL[usize::from(seed % 2 == 1)];
    let link = LINKS[usize::try_from(seed / 2).unwrap() % LINKS.len()];
    let mut it = on_link(personality, link, seed);
    let anna = armed(&mut it);
    let job = it.submit(&burnt_spiral(12)).unwrap();
    it.start(anna, job).unwrap();
    let latest = it.now() + Duration::from_mins(2);
    let mut pauses = chance.below(3);
    while !is_over(&it, job) && it.now() < latest {
        it.run_for(Duration::from_millis(500 + chance.below(4_000)));
        if pauses > 0 {
            pauses -= 1;
            let _ = it.ask(anna, Request::PauseJob);
            it.run_for(Duration::from_secs(4));
        }
        if it
            .keeper()
            .job()
            .is_some_and(|it| it.phase == JobPhase::Paused)
        {
            let _ = it.ask(anna, Request::ArmLaser { for_s: 600.0 });
            let _ = it.start(anna, job);
        }
    }
    assert!(is_over(&it, job), "seed {seed}: {:?}", it.keeper().job());
    longest_stand_s(&it)
}

#[test]
fn no_job_leaves_the_laser_burning_on_the_spot() {
    let mut longest: (f64, u64) = (0.0, 0);
    for seed in 0..30 {
        let stood_s = random_job(seed);
        if stood_s > longest.0 {
            longest = (stood_s, seed);
        }
    }
    let (stood_s, seed) = longest;
    println!("the longest stand is {stood_s} s, seed {seed}");
    assert!(stood_s <= MOST_S, "seed {seed}: {stood_s} s");
}
