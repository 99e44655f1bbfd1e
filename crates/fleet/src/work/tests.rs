//! Jobs for any arm, against stations in virtual time with real journals.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod world;

use std::time::Duration;

use dobot_api::{JobPhase, Request, TakesWork, WorkPhase};
use dobot_supervisor::StoppedBy;

use self::world::World;
use super::ticket_store::TicketStore;

/// A queue of short drawings, while stations are killed and the network splits.
struct Storm {
    seed: u64,
    homes: usize,
    desks: usize,
    drawings: u64,
    kills: usize,
    splits: usize,
}

impl Storm {
    /// Runs the storm and returns the final world.
    fn pass(&self) -> World {
        let mut world = World::new(self.seed, self.homes, self.desks);
        for number in 1..=self.drawings {
            let home = world.one_of(self.homes);
            let student = format!("student-{}", number % 30);
            world.submit(home, number, &student);
        }
        let mut heals = Duration::ZERO;
        let hour = Duration::from_secs(4 * 3600);
        while !is_over(&world) {
            assert!(world.now < hour, "it ends: {:?}", open(&world));
            world.step();
            let kills = world.figures.kills_of_homes + world.figures.kills_of_desks;
            // Spread over the whole time.
            if kills < self.kills && world.below(4) == 0 {
                let which = world.one_of(self.homes + self.desks);
                match which.checked_sub(self.homes) {
                    None => world.kill_home(which),
                    Some(desk) => world.kill_desk(desk),
                }
            }
            if world.now >= heals && world.figures.splits < self.splits && world.below(10) == 0 {
                world.split();
                heals = world.now + Duration::from_millis(1000 + world.below(3_500));
            } else if world.now >= heals {
                world.join();
            }
        }
        world
    }
}

fn is_over(world: &World) -> bool {
    let all = world.homes.iter().all(|home| home.work.is_some());
    all && world.views().iter().all(|view| view.phase.is_over())
}

fn open(world: &World) -> Vec<dobot_api::WorkView> {
    let open = world
        .views()
        .into_iter()
        .filter(|view| !view.phase.is_over());
    open.take(3).collect()
}

/// Checks that each drawing was begun by one arm, once, and that its ticket has the right result.
fn check(world: &mut World, drawings: u64) {
    let views = world.views();
    assert_eq!(views.len() as u64, drawings, "none is lost");
    let begun = world.begun();
    assert_eq!(begun.len() as u64, drawings);
    for view in views {
        let found = &begun[&view.title];
        let member = view.member.unwrap().name;
        let phase = if view.phase == WorkPhase::Done {
            JobPhase::Done
        } else {
            view.job.unwrap().phase
        };
        assert_eq!(*found, [(member, phase)], "{} is done once", view.title);
    }
}

#[test]
fn five_hundred_drawings_are_done_once_each_through_two_hundred_kills_and_fifty_splits() {
    let storm = Storm {
        seed: 22,
        homes: 4,
        desks: 20,
        drawings: 500,
        kills: 200,
        splits: 50,
    };
    let mut world = storm.pass();
    check(&mut world, storm.drawings);
    let figures = &world.figures;
    println!("{figures:?}, {:?}", world.now);
    assert_eq!(figures.kills_of_homes + figures.kills_of_desks, 200);
    assert_eq!(figures.splits, 50);
    assert!(
        figures.in_doubt > 0,
        "each doubt was shown: the world looks at each step"
    );
}

#[test]
fn each_drawing_is_started_by_one_arm_despite_faults() {
    for seed in 0..20 {
        let storm = Storm {
            seed,
            homes: 3,
            desks: 4,
            drawings: 40,
            kills: 60,
            splits: 15,
        };
        check(&mut storm.pass(), storm.drawings);
    }
}

/// A fleet of one home, in which the one station that has a drawing is gone permanently.
fn without_the_taker() -> (World, String) {
    let mut world = World::new(3, 1, 1);
    world.submit(0, 1, "Anna");
    while world.views()[0].phase != WorkPhase::Taken {
        world.step();
    }
    world.desks[0].is_gone = true;
    for _ in 0..50 {
        world.step();
    }
    let id = world.views()[0].id.clone();
    (world, id)
}

#[test]
fn work_of_a_lost_station_is_in_doubt_until_a_person_reassigns_it() {
    let (mut world, id) = without_the_taker();
    world.add_desk();
    for _ in 0..100 {
        world.step();
    }
    let view = world.views().remove(0);
    assert_eq!(
        view.phase,
        WorkPhase::Taken,
        "the other one does not get it by itself"
    );
    assert!(view.doubt.unwrap().contains("desk-1 cannot be reached"));
    world.work_of(0).give(&id).unwrap();
    while world.views()[0].phase != WorkPhase::Done {
        world.step();
    }
    let view = world.views().remove(0);
    assert_eq!(view.member.unwrap().name, "desk-2");
    assert_eq!(view.before[0].member.name, "desk-1");
    assert!(
        !view.before[0].is_settled,
        "the progress at the first one is still unknown"
    );
}

#[test]
fn reassigned_work_is_not_started_by_the_first_arm_when_it_returns() {
    let mut world = World::new(3, 1, 1);
    world.desks[0].has_person = false;
    world.submit(0, 1, "Anna");
    while world.views()[0].phase != WorkPhase::Taken {
        world.step();
    }
    world.sides[1] = true;
    while world.views()[0].doubt.is_none() {
        world.step();
    }
    let id = world.views()[0].id.clone();
    world.work_of(0).give(&id).unwrap();
    world.join();
    while !world.views()[0].before[0].is_settled {
        world.step();
    }
    world.desks[0].has_person = true;
    world.add_desk();
    while world.views()[0].phase != WorkPhase::Done {
        world.step();
    }
    let found: Vec<_> = world.begun().into_values().flatten().collect();
    assert_eq!(found, [("desk-2".to_owned(), JobPhase::Done)]);
}

#[test]
fn work_that_is_neither_in_doubt_nor_failed_is_not_reassigned() {
    let mut world = World::new(1, 1, 1);
    world.submit(0, 1, "Anna");
    let id = world.views()[0].id.clone();
    let refused = world.work_of(0).give(&id).unwrap_err();
    assert!(
        refused.detail.contains("not in doubt"),
        "{}",
        refused.detail
    );
    assert_eq!(world.work_of(0).give("7").unwrap_err().status, 404);
}

#[test]
fn work_cancelled_before_its_start_is_never_started() {
    let mut world = World::new(5, 1, 1);
    world.desks[0].has_person = false;
    for number in 1..=2 {
        world.submit(0, number, "Anna");
    }
    while world.views()[0].phase != WorkPhase::Taken {
        world.step();
    }
    for view in world.views() {
        world.work_of(0).cancel(&view.id).unwrap();
    }
    while world
        .views()
        .iter()
        .any(|view| view.phase != WorkPhase::Cancelled)
    {
        world.step();
    }
    world.desks[0].has_person = true;
    for _ in 0..50 {
        world.step();
    }
    assert!(world.begun().is_empty());
    let id = world.views()[0].id.clone();
    assert_eq!(world.work_of(0).cancel(&id).unwrap_err().status, 409);
}

#[test]
fn a_student_with_one_drawing_does_not_wait_for_the_ten_of_another() {
    let mut world = World::new(7, 1, 1);
    for number in 1..=10 {
        world.submit(0, number, "Ben");
    }
    world.submit(0, 11, "Anna");
    while !is_over(&world) {
        world.step();
    }
    let order: Vec<String> = world.desks[0].titles();
    let place = order
        .iter()
        .position(|order| order == "drawing 11 of home 0");
    assert_eq!(place, Some(1), "{order:?}");
}

#[test]
fn in_the_slot_of_a_student_an_arm_gets_only_that_students_work() {
    let mut world = World::new(11, 1, 1);
    world.is_time_of(0, "ANNA");
    world.submit(0, 1, "Ben");
    world.submit(0, 2, "Anna");
    while world.views()[1].phase != WorkPhase::Done {
        world.step();
    }
    assert_eq!(world.views()[0].phase, WorkPhase::Waiting);
    assert_eq!(world.desks[0].titles(), ["drawing 2 of home 0"]);
}

#[test]
fn work_that_no_station_can_do_waits_and_is_reported() {
    let mut world = World::new(9, 1, 2);
    let mut ticket = world::ticket(0, 1, "Anna");
    ticket.needs = vec!["laser".into()];
    world.work_of(0).submitted(ticket);
    for _ in 0..50 {
        world.step();
    }
    let view = world.views().remove(0);
    assert_eq!(view.phase, WorkPhase::Waiting);
    assert!(view.reason.unwrap().contains("has laser"));
}

#[test]
fn tickets_survive_a_kill_and_an_invalid_file_is_kept_and_reported() {
    let folder = tempfile::tempdir().unwrap();
    let ticket = world::ticket(0, 1, "Anna");
    let offer = serde_json::json!({"by": "desk-1"});
    let (kept, none, wrong) = TicketStore::open(folder.path()).unwrap();
    assert!(none.is_empty() && wrong.is_empty());
    kept.submit(&ticket, &offer).unwrap();
    let half = folder.path().join(format!("{}.json", "f".repeat(32)));
    std::fs::write(&half, "{\"id\": ").unwrap();
    std::fs::write(folder.path().join("0.new-17"), "half").unwrap();
    let (kept, found, wrong) = TicketStore::open(folder.path()).unwrap();
    assert_eq!(found, std::slice::from_ref(&ticket));
    assert_eq!(kept.offer(&ticket.id).unwrap(), offer);
    assert!(
        wrong.len() == 1 && wrong[0].contains("ffff.json"),
        "{wrong:?}"
    );
    assert!(half.exists());
    kept.forget(&ticket.id).unwrap();
    assert!(TicketStore::open(folder.path()).unwrap().1.is_empty());
}

/// Steps until the condition is met.
fn until(world: &mut World, what: &str, is_so: impl Fn(&World) -> bool) {
    for _ in 0..3000 {
        if is_so(world) {
            return;
        }
        world.step();
    }
    panic!("never: {what}: {:?}", world.views());
}

fn is_in(phase: WorkPhase) -> impl Fn(&World) -> bool {
    move |world| world.views()[0].phase == phase
}

/// A fleet of one home and one station with automatic starts.
fn with_one_that_starts(seed: u64) -> World {
    let mut world = World::new(seed, 1, 1);
    let desk = &mut world.desks[0];
    desk.takes_work = TakesWork::Start;
    desk.has_person = false;
    world
}

fn fire_drill() -> StoppedBy {
    StoppedBy {
        by: "Ms Weber".into(),
        reason: Some("fire drill".into()),
        ..StoppedBy::default()
    }
}

#[test]
fn while_the_fleet_is_stopped_nothing_is_offered_and_the_list_gives_the_reason() {
    let mut world = World::new(3, 1, 2);
    let text = "stopped: fleet, by Ms Weber: fire drill";
    world.homes[0].held = Some(text.into());
    world.submit(0, 1, "Anna");
    for _ in 0..100 {
        world.step();
        let view = world.views().remove(0);
        assert_eq!(view.phase, WorkPhase::Waiting);
        assert!(view.reason.unwrap().starts_with(text));
    }
    for desk in &mut world.desks {
        assert!(desk.station.jobs().unwrap().is_empty());
    }
    world.homes[0].held = None;
    until(&mut world, "it is done", is_in(WorkPhase::Done));
}

#[test]
fn an_offer_from_before_a_stop_is_not_repeated_while_the_stop_holds() {
    for seed in 0..10 {
        let mut world = World::new(seed, 1, 1);
        // All requests of the home are lost.
        world.sides[1] = true;
        world.submit(0, 1, "Anna");
        until(&mut world, "it is offered", is_in(WorkPhase::Offered));
        world.homes[0].held = Some("stopped".into());
        // In-flight messages are lost or delivered.
        for _ in 0..300 {
            world.step();
        }
        world.join();
        for _ in 0..100 {
            world.step();
        }
        assert!(world.desks[0].station.jobs().unwrap().is_empty());
        world.homes[0].held = None;
        until(&mut world, "it is done", is_in(WorkPhase::Done));
    }
}

#[test]
fn a_ticket_accepted_just_before_a_stop_returns_to_the_queue_and_is_done_after_the_reset() {
    for seed in 0..10 {
        let mut world = with_one_that_starts(seed);
        // The stop arrives between taking and starting.
        world.desks[0].can_start = false;
        world.submit(0, 1, "Anna");
        until(&mut world, "it is taken", is_in(WorkPhase::Taken));
        let station = &mut world.desks[0].station;
        station.stop_fleet("desk-9", fire_drill());
        let before = station.packets().len();
        world.desks[0].can_start = true;
        until(&mut world, "it waits again", is_in(WorkPhase::Waiting));
        let reason = world.views()[0].reason.clone().unwrap();
        let text = "desk-1: stopped: fleet, by Ms Weber: fire drill";
        assert!(reason.contains(text), "{reason}");
        for _ in 0..100 {
            world.step();
        }
        assert_eq!(world.views()[0].phase, WorkPhase::Waiting);
        assert!(world.begun().is_empty());
        // Only stopping packets were sent.
        let packets = &world.desks[0].station.packets()[before..];
        assert!(packets.len() < 20, "{}", packets.len());
        world.desks[0].station.reset_fleet("Ms Weber");
        until(&mut world, "it is done", is_in(WorkPhase::Done));
        check(&mut world, 1);
    }
}

#[test]
fn a_ticket_that_its_station_does_not_start_is_offered_to_another_one() {
    let mut world = with_one_that_starts(4);
    world.desks[0].can_start = false;
    world.submit(0, 1, "Anna");
    until(&mut world, "it is taken", is_in(WorkPhase::Taken));
    world.add_desk();
    until(&mut world, "it is done", is_in(WorkPhase::Done));
    assert_eq!(world.views()[0].member.as_ref().unwrap().name, "desk-2");
    check(&mut world, 1);
}

#[test]
fn a_job_cancelled_at_the_arm_before_its_start_is_not_done_elsewhere() {
    let mut world = World::new(4, 1, 1);
    world.desks[0].has_person = false;
    world.submit(0, 1, "Anna");
    until(&mut world, "it is taken", is_in(WorkPhase::Taken));
    world.add_desk();
    let station = &mut world.desks[0].station;
    let person = station.client("Ben");
    let job = station.jobs().unwrap()[0].job;
    station.ask(person, Request::CancelJob { job }).unwrap();
    until(&mut world, "it has failed", is_in(WorkPhase::Failed));
    assert!(world.begun().is_empty());
}
