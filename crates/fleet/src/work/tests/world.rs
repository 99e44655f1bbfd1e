//! A fleet in virtual time: homes with disks, stations with real rules, journals and twins, and a
//! network that loses, delays, duplicates and splits.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use std::time::Duration;

use dobot_api::{
    ClientId, JobKind, JobPhase, JobProgram, JobView, Member, MemberAbout, NewJob, Presence,
    Request, TakesWork, TimeSlot, WorkView,
};
use dobot_controller::{Personality, PowerUp};
use dobot_geometry::Random;
use dobot_host::{OfferAnswer, OfferRequest, VirtualStation};
use dobot_safety::Policy;
use dobot_station::{Members, work_hurdle};
use dobot_wire::{MoveTo, MovingMode, WriteVector};

use super::super::engine::{Action, Answer, Ask, What, Work};
use super::super::ticket::{Place, Ticket};

/// The time of a step.
pub(super) const STEP: Duration = Duration::from_millis(200);
/// The timeout of a request.
const PATIENCE: Duration = Duration::from_secs(5);
/// The time after which arrivals and departures are noticed.
const NOTICED: Duration = Duration::from_secs(2);

/// A simulated fleet.
pub(super) struct World {
    pub(super) now: Duration,
    pub(super) random: Random,
    pub(super) homes: Vec<Home>,
    pub(super) desks: Vec<Desk>,
    /// The in-flight messages, by arrival time.
    messages: Vec<(Duration, Message)>,
    /// The side of a split on which each station is: the homes, then the desks.
    pub(super) sides: Vec<bool>,
    /// Since when each home and each desk have been disconnected or connected.
    seen: HashMap<(usize, usize), (bool, Duration)>,
    pub(super) figures: Figures,
}

/// Counts of events.
#[derive(Debug, Default)]
pub(super) struct Figures {
    pub(super) kills_of_homes: usize,
    pub(super) kills_of_desks: usize,
    pub(super) splits: usize,
    pub(super) lost: usize,
    pub(super) doubled: usize,
    pub(super) late: usize,
    pub(super) in_doubt: usize,
    pub(super) longest_doubt: Duration,
    doubts: HashMap<(usize, String), Duration>,
}

/// A station to which jobs are submitted.
pub(super) struct Home {
    /// The contents of its disk.
    pub(super) disk: BTreeMap<String, Ticket>,
    /// Its engine, while it runs.
    pub(super) work: Option<Work>,
    /// The reason why it offers nothing.
    pub(super) held: Option<String>,
    /// The number of starts.
    life: u64,
    back: Duration,
}

/// A station with an arm.
pub(super) struct Desk {
    pub(super) name: String,
    pub(super) station: VirtualStation,
    person: Option<ClientId>,
    /// Whether it never returns.
    pub(super) is_gone: bool,
    /// Whether a person is present who starts waiting jobs.
    pub(super) has_person: bool,
    pub(super) takes_work: TakesWork,
    /// Whether it can start its accepted work, with automatic starts.
    pub(super) can_start: bool,
}

#[derive(Clone, Debug)]
enum Message {
    Question {
        home: usize,
        life: u64,
        ask: Ask,
        job: Option<Box<NewJob>>,
    },
    Answer {
        home: usize,
        life: u64,
        ask: Ask,
        answer: Answer,
    },
}

impl World {
    pub(super) fn new(seed: u64, homes: usize, desks: usize) -> Self {
        let mut world = Self {
            now: Duration::from_secs(1),
            random: Random::new(seed),
            homes: Vec::new(),
            desks: (1..=desks).map(Desk::new).collect(),
            messages: Vec::new(),
            sides: vec![false; homes + desks],
            seen: HashMap::new(),
            figures: Figures::default(),
        };
        for home in 0..homes {
            let work = Some(world.start(home, Vec::new()));
            world.homes.push(Home {
                disk: BTreeMap::new(),
                work,
                held: None,
                life: 0,
                back: Duration::ZERO,
            });
        }
        world
    }

    /// A random number below this one.
    pub(super) fn below(&mut self, count: u32) -> u64 {
        self.random.below(count).into()
    }

    /// A random index.
    pub(super) fn one_of(&mut self, count: usize) -> usize {
        let count = u32::try_from(count).unwrap();
        usize::try_from(self.random.below(count)).unwrap()
    }

    fn start(&mut self, home: usize, kept: Vec<Ticket>) -> Work {
        let mut keys = Random::new(self.random.number());
        Work::new(kept, move || Some(format!("{home}-{:016x}", keys.number())))
    }

    /// A student submits a drawing.
    pub(super) fn submit(&mut self, home: usize, number: u64, student: &str) {
        let ticket = ticket(home, number, student);
        let entry = &mut self.homes[home];
        entry.disk.insert(ticket.id.clone(), ticket.clone());
        if let Some(work) = &mut entry.work {
            work.next_number();
            work.submitted(ticket);
        }
    }

    /// Kills a home and restarts it after a while.
    pub(super) fn kill_home(&mut self, home: usize) {
        let away = Duration::from_millis(500 + self.below(8000));
        let entry = &mut self.homes[home];
        entry.work = None;
        entry.life += 1;
        entry.back = entry.back.max(self.now + away);
        self.figures.kills_of_homes += 1;
    }

    /// Kills a desk and restarts it after a while; its arm continues.
    pub(super) fn kill_desk(&mut self, desk: usize) {
        let away = Duration::from_millis(500 + self.below(8000));
        let entry = &mut self.desks[desk];
        if entry.is_gone || entry.station.now() > self.now {
            return;
        }
        entry.station.crash(away).unwrap();
        entry.person = None;
        self.figures.kills_of_desks += 1;
    }

    /// Splits the network.
    pub(super) fn split(&mut self) {
        for side in &mut self.sides {
            *side = self.random.below(2) == 0;
        }
        self.figures.splits += 1;
    }

    pub(super) fn join(&mut self) {
        self.sides.fill(false);
    }

    /// Advances one step.
    pub(super) fn step(&mut self) {
        self.now += STEP;
        for home in 0..self.homes.len() {
            if self.homes[home].work.is_none() && self.homes[home].back <= self.now {
                let kept = self.homes[home].disk.values().cloned().collect();
                self.homes[home].work = Some(self.start(home, kept));
            }
        }
        for desk in &mut self.desks {
            desk.go_on(self.now);
        }
        let due = self
            .messages
            .extract_if(.., |message| message.0 <= self.now);
        for (_, message) in due.collect::<Vec<_>>() {
            self.arrive(message);
        }
        for home in 0..self.homes.len() {
            self.work(home);
        }
        self.look();
    }

    fn work(&mut self, home: usize) {
        let members = self.members(home);
        let Some(mut work) = self.homes[home].work.take() else {
            return;
        };
        work.update_members(&members, self.homes[home].held.clone());
        while let Some(action) = work.poll_action(self.now) {
            match action {
                Action::Write(ticket) => {
                    // A disk may be full for a while.
                    let fails = self.below(50) == 0;
                    if !fails {
                        self.homes[home].disk.insert(ticket.id.clone(), *ticket);
                    }
                    work.handle_written(self.now, !fails);
                }
                Action::Forget(id) => drop(self.homes[home].disk.remove(&id)),
                Action::Ask(ask) => self.ask(home, ask),
            }
        }
        self.homes[home].work = Some(work);
    }

    fn ask(&mut self, home: usize, ask: Ask) {
        let life = self.homes[home].life;
        let kept = &self.homes[home].disk[&ask.ticket];
        let keys = kept
            .offer()
            .into_iter()
            .chain(kept.before.iter().map(|before| &before.offer));
        assert!(
            keys.map(|earlier| &earlier.key).any(|key| *key == ask.key),
            "the ticket is on the disk before a request is sent"
        );
        let job = (ask.what == What::Offer).then(|| Box::new(drawing(&kept.title)));
        let lost = Answer::Unclear("it did not answer".into());
        let answer = Message::Answer {
            home,
            life,
            ask: ask.clone(),
            answer: lost,
        };
        self.messages.push((self.now + PATIENCE, answer));
        self.send(Message::Question {
            home,
            life,
            ask,
            job,
        });
    }

    /// Sends a message through an unreliable network.
    fn send(&mut self, message: Message) {
        match self.below(20) {
            0 => return self.figures.lost += 1,
            1 => {
                self.figures.doubled += 1;
                let late = Duration::from_millis(self.below(20_000));
                self.messages.push((self.now + late, message.clone()));
            }
            2 => {
                self.figures.late += 1;
                let late = PATIENCE + Duration::from_millis(self.below(20_000));
                return self.messages.push((self.now + late, message));
            }
            _ => {}
        }
        let soon = Duration::from_millis(self.below(400));
        self.messages.push((self.now + soon, message));
    }

    fn arrive(&mut self, message: Message) {
        match message {
            Message::Question {
                home,
                life,
                ask,
                job,
            } => {
                let desk = self.desk(&ask);
                if !self.are_joined(home, desk) || !self.desks[desk].runs(self.now) {
                    self.figures.lost += 1;
                    return;
                }
                let answer = self.desks[desk].answer(&ask, job);
                self.send(Message::Answer {
                    home,
                    life,
                    ask,
                    answer,
                });
            }
            Message::Answer {
                home,
                life,
                ask,
                answer,
            } => {
                let is_own = matches!(&answer, Answer::Unclear(_));
                let arrives = is_own || self.are_joined(home, self.desk(&ask));
                let entry = &mut self.homes[home];
                if let Some(work) = entry
                    .work
                    .as_mut()
                    .filter(|_| arrives && entry.life == life)
                {
                    work.handle_answer(self.now, &ask, answer);
                }
            }
        }
    }

    fn desk(&self, ask: &Ask) -> usize {
        let mut desks = self.desks.iter();
        desks.position(|desk| desk.name == ask.member.name).unwrap()
    }

    fn are_joined(&self, home: usize, desk: usize) -> bool {
        self.sides[home] == self.sides[self.homes.len() + desk]
    }

    /// Whether a home considers a desk present: it notices late.
    fn sees(&mut self, home: usize, desk: usize) -> bool {
        let is_there = self.are_joined(home, desk) && self.desks[desk].runs(self.now);
        let now = self.now;
        let seen = self
            .seen
            .entry((home, desk))
            .or_insert((is_there, Duration::ZERO));
        if seen.0 != is_there {
            *seen = (is_there, now);
        }
        if now.saturating_sub(seen.1) >= NOTICED {
            is_there
        } else {
            !is_there
        }
    }

    fn members(&mut self, home: usize) -> Members {
        let desks = 0..self.desks.len();
        let sees: Vec<bool> = desks.map(|desk| self.sees(home, desk)).collect();
        let members = self.desks.iter().zip(sees);
        members
            .map(|(desk, sees)| Arc::new(desk.member(sees)))
            .collect()
    }

    /// Checks that each ticket whose station is unreachable is shown as in doubt.
    fn look(&mut self) {
        for home in 0..self.homes.len() {
            let members = self.members(home);
            let held = self.homes[home].held.clone();
            let Some(work) = &mut self.homes[home].work else {
                continue;
            };
            work.update_members(&members, held);
            for view in work.views() {
                let key = (home, view.id.clone());
                let is_away = |known: &Arc<Member>| {
                    view.member.as_ref().is_some_and(|one| one.id == known.id)
                        && known.presence == Presence::Away
                };
                let out = !view.phase.is_over() && view.member.is_some();
                if out && members.iter().any(is_away) {
                    assert!(view.doubt.is_some(), "{view:?}");
                }
                if view.doubt.is_none() {
                    self.figures.doubts.remove(&key);
                    continue;
                }
                if !self.figures.doubts.contains_key(&key) {
                    self.figures.in_doubt += 1;
                }
                let since = *self.figures.doubts.entry(key).or_insert(self.now);
                let doubted = self.now.saturating_sub(since);
                self.figures.longest_doubt = self.figures.longest_doubt.max(doubted);
            }
        }
    }

    /// Adds a desk, which has been idle until now.
    pub(super) fn add_desk(&mut self) {
        let mut desk = Desk::new(self.desks.len() + 1);
        desk.go_on(self.now);
        self.desks.push(desk);
        self.sides.push(false);
    }

    /// Makes a time slot of a student active at a desk.
    pub(super) fn is_time_of(&mut self, desk: usize, student: &str) {
        let station = &mut self.desks[desk].station;
        let teacher = station.client("Ms Weber");
        let slots = vec![TimeSlot {
            student: student.into(),
            group: None,
            starts_in_s: 0.0,
            ends_in_s: 86_400.0,
        }];
        station.ask(teacher, Request::SetSlots { slots }).unwrap();
    }

    pub(super) fn work_of(&mut self, home: usize) -> &mut Work {
        self.homes[home].work.as_mut().unwrap()
    }

    pub(super) fn views(&self) -> Vec<WorkView> {
        let running = self.homes.iter().filter_map(|home| home.work.as_ref());
        running.flat_map(Work::views).collect()
    }

    /// Returns the drawings that were begun, by title, with their desks and phases.
    pub(super) fn begun(&mut self) -> BTreeMap<String, Vec<(String, JobPhase)>> {
        let mut begun: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for desk in &mut self.desks {
            for job in desk.history() {
                begun
                    .entry(job.title)
                    .or_default()
                    .push((desk.name.clone(), job.phase));
            }
        }
        begun
    }
}

impl Desk {
    fn new(number: usize) -> Self {
        let mut station =
            VirtualStation::new(PowerUp::new(Personality::Firmware11), Policy::default());
        station.run_for(Duration::from_secs(1));
        Self {
            name: format!("desk-{number}"),
            station,
            person: None,
            is_gone: false,
            has_person: true,
            takes_work: TakesWork::Queue,
            can_start: true,
        }
    }

    fn runs(&self, now: Duration) -> bool {
        !self.is_gone && self.station.now() <= now
    }

    /// Advances the time; a person at the arm starts waiting jobs and resumes interrupted ones.
    fn go_on(&mut self, now: Duration) {
        if self.is_gone || self.station.now() >= now {
            return;
        }
        let time = now.saturating_sub(self.station.now());
        self.station.run_for(time);
        if !self.has_person || !self.station.supervisor().is_at_rest() {
            return;
        }
        let jobs = self.station.jobs().unwrap();
        let Some(next) = jobs
            .iter()
            .find(|job| matches!(job.phase, JobPhase::Queued | JobPhase::Paused))
        else {
            return;
        };
        let station = &mut self.station;
        let person = *self.person.get_or_insert_with(|| station.client("person"));
        // Refused requests are tried again.
        for request in [
            Request::TakeLease,
            Request::ConfirmPose,
            Request::StartJob { job: next.job },
        ] {
            drop(station.ask(person, request));
        }
    }

    fn answer(&mut self, ask: &Ask, job: Option<Box<NewJob>>) -> Answer {
        let state = self.station.supervisor().state();
        let ask_of = match (ask.what, job) {
            (What::Offer, Some(_)) if work_hurdle(&state, self.takes_work).is_some() => {
                OfferRequest::Refuse {
                    reason: work_hurdle(&state, self.takes_work).unwrap(),
                    busy: true,
                }
            }
            (What::Offer, Some(job)) => OfferRequest::Take {
                job,
                made_for: None,
            },
            (What::Withdraw, _) => OfferRequest::Withdraw { by: "home".into() },
            _ => OfferRequest::Look,
        };
        match self.station.offer(&ask.key, ask_of) {
            Ok(OfferAnswer::Taken(job)) => {
                self.start(&job);
                Answer::Taken(job)
            }
            Ok(OfferAnswer::Refused { reason, busy }) => Answer::Refused { reason, busy },
            Ok(OfferAnswer::Unknown) => Answer::Unknown,
            Err(refusal) => Answer::Unclear(refusal.to_string()),
        }
    }

    /// Starts a job that it has taken, once, if it has automatic starts.
    fn start(&mut self, job: &JobView) {
        if self.takes_work != TakesWork::Start || !self.can_start || job.phase != JobPhase::Queued {
            return;
        }
        let client = self.station.client("work of the fleet");
        for request in [Request::TakeLease, Request::StartJob { job: job.job }] {
            drop(self.station.ask(client, request));
        }
        self.station.leave(client);
    }

    /// Returns the titles of its drawings, in order.
    pub(super) fn titles(&mut self) -> Vec<String> {
        self.history()
            .into_iter()
            .map(|history| history.title)
            .collect()
    }

    /// Returns all jobs that were begun.
    fn history(&mut self) -> Vec<JobView> {
        let jobs = self.station.jobs().unwrap();
        jobs.into_iter()
            .filter(|job| self.station.job(job.job).unwrap().window.upto > 0)
            .collect()
    }

    fn member(&self, is_present: bool) -> Member {
        Member {
            name: self.name.clone(),
            id: self.name.clone(),
            here: false,
            presence: if is_present {
                Presence::Present
            } else {
                Presence::Away
            },
            heard_at_s: 0.0,
            about: Some(MemberAbout {
                offers: vec!["pen".into(), "a5".into()],
                takes_work: Some(self.takes_work),
                ..MemberAbout::default()
            }),
            state: Some(Box::new(self.station.supervisor().state())),
        }
    }
}

pub(super) fn ticket(home: usize, number: u64, student: &str) -> Ticket {
    Ticket {
        id: format!("{home:02}{number:030}"),
        number,
        title: format!("drawing {number} of home {home}"),
        student: student.into(),
        group: None,
        needs: vec!["pen".into(), "a5".into()],
        submitted_ms: 0,
        key: None,
        at: Place::Waiting,
        refused: Vec::new(),
        before: Vec::new(),
        returned: None,
    }
}

/// A short drawing: a move, pen down, a corner, pen up.
fn drawing(title: &str) -> NewJob {
    let there = MoveTo {
        x_mm: 220.0,
        y_mm: 0.0,
        z_mm: -30.0,
        rotation_deg: 0.0,
        suction: false,
        mode: MovingMode::Jump,
        gripper_deg: 0.0,
        pause_s: 0.0,
    };
    let way = [
        [0.0, 0.0, -10.0],
        [6.0, 0.0, 0.0],
        [0.0, 5.0, 0.0],
        [0.0, 0.0, 10.0],
    ];
    let vectors = way.map(|[x, y, z]| WriteVector::by(x, y, z, 20.0).into());
    NewJob {
        title: title.into(),
        kind: JobKind::Drawing,
        commands: [there.into()].into_iter().chain(vectors).collect(),
        lift_mm: 5.0,
        pauses: Vec::new(),
        program: JobProgram::default(),
    }
}
