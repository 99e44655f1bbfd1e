//! Coordinated programs at stations of a fleet.

use std::collections::BTreeMap;

use dobot_api::StationAddress;
use dobot_fleet::together::{EngineEvent, Home, Order, Outcome, Part, RunEvent, check, run};
use dobot_host::PassedPacket;
use dobot_teach::{NoFiles, Program};
use dobot_wire::{Command, Packet};
use tokio::sync::broadcast::error::TryRecvError;
use tokio::sync::{broadcast, mpsc};
use tokio::task::JoinHandle;

use super::*;

/// Three desks, each of which accepts the token of the first one.
struct Room {
    router: Router,
    desks: Vec<Desk>,
    home: Home,
    packets: Vec<broadcast::Receiver<PassedPacket>>,
}

impl Room {
    async fn open() -> Self {
        let (router, at) = router(free_port()).await;
        let names = ["desk-1", "desk-2", "desk-3"];
        let mut desks = Vec::new();
        for name in names {
            desks.push(Desk::up(name, &at, None).await);
        }
        desks[0].sees("all arms", is_ready(&names)).await;
        let token = dobot_station::Token::of_secret(&desks[0].admin()).unwrap();
        for desk in &desks[1..] {
            let mut tokens = Tokens::open(&Folders::at(desk.folder.path()).tokens()).unwrap();
            tokens.accept(Role::Control, "teacher", &token).unwrap();
        }
        let mut address = StationAddress::new(desks[0].station.url()).unwrap();
        address.token = Some(desks[0].admin());
        let packets = desks.iter().map(|desk| desk.station.handle().passed());
        Self {
            router,
            home: Home::new(address),
            packets: packets.collect(),
            desks,
        }
    }

    /// Whether a target after the barrier was sent to this arm.
    fn has_gone_past(&mut self, desk: usize) -> bool {
        let packets = &mut self.packets[desk];
        let sent = std::iter::from_fn(|| match packets.try_recv() {
            Ok(packet) => Some(packet),
            Err(TryRecvError::Empty | TryRecvError::Closed) => None,
            Err(TryRecvError::Lagged(_)) => panic!("packets of desk {desk} were missed"),
        });
        let mut commands = sent.filter(|sent| sent.to_arm).map(|sent| command(&sent));
        commands.any(
            |command| matches!(command, Some(Command::MoveTo(command)) if command.y_mm == AFTER_MM),
        )
    }

    async fn close(self) {
        for desk in self.desks {
            desk.end().await;
        }
        self.router.end().await;
    }
}

fn is_ready(names: &[&str]) -> impl Fn(&[Member]) -> bool {
    let present = present(names);
    let is_linked = |member: &Member| {
        member
            .state
            .as_ref()
            .is_some_and(|state| state.arm.is_some())
    };
    move |members| present(members) && members.iter().all(is_linked)
}

fn command(packet: &PassedPacket) -> Option<Command> {
    let packet = Packet::from_bytes(&packet.bytes)?;
    Command::parse(&packet, &dialect()).ok()
}

/// A part that does something, waits for the others and continues after the barrier.
fn part(arm: &str, before: &str) -> Part {
    let text = format!(
        "title = \"part of {arm}\"\n\
         [[steps]]\ngo = {{ x = 200, y = 30, z = 20 }}\n{before}\
         [[steps]]\nbarrier = \"together\"\n\
         [[steps]]\ngo = {{ x = 200, y = {AFTER_MM}, z = 20 }}\n"
    );
    let program = Program::from_toml(&text).unwrap();
    Part {
        arm: arm.into(),
        file: format!("{arm}.toml"),
        compiled: program.compile(&mut NoFiles).unwrap(),
        text,
        files: BTreeMap::new(),
    }
}

/// Moves back and forth before the barrier.
fn to_and_fro(times: u32) -> String {
    format!(
        "[[steps]]\nrepeat = {times}\n\
         [[steps.steps]]\ngo = {{ x = 200, y = 60, z = 20 }}\n\
         [[steps.steps]]\ngo = {{ x = 200, y = 30, z = 20 }}\n"
    )
}

/// The y of all targets after the barrier.
const AFTER_MM: f32 = -30.0;

/// A running program and its events.
struct Running {
    orders: mpsc::Sender<Order>,
    events: mpsc::UnboundedReceiver<RunEvent>,
    ended: JoinHandle<Outcome>,
}

impl Running {
    fn begin(home: &Home, parts: Vec<Part>, is_attended: bool) -> Self {
        assert_eq!(check(&parts), [""; 0]);
        let (orders, ordered) = mpsc::channel(8);
        let (sender, events) = mpsc::unbounded_channel();
        let home = home.clone();
        let ended = tokio::spawn(async move {
            let report = |event| drop(sender.send(event));
            run(&home, &parts, is_attended, ordered, report)
                .await
                .unwrap()
        });
        Self {
            orders,
            events,
            ended,
        }
    }

    /// Waits for an event; returns it and all events before it.
    async fn until(&mut self, is_match: impl Fn(&RunEvent) -> bool) -> Vec<RunEvent> {
        let mut all = Vec::new();
        let waiting = async {
            while let Some(event) = self.events.recv().await {
                let found = is_match(&event);
                all.push(event);
                if found {
                    return true;
                }
            }
            false
        };
        let found = timeout(PATIENCE, waiting).await;
        assert_eq!(found, Ok(true), "{all:#?}");
        all
    }

    async fn end(self) -> Outcome {
        timeout(PATIENCE, self.ended).await.unwrap().unwrap()
    }
}

fn is_at_barrier(event: &RunEvent, of: usize) -> bool {
    matches!(event, RunEvent::News(EngineEvent::Arrived { part, .. }) if *part == of)
}

#[tokio::test(flavor = "multi_thread")]
async fn no_arm_passes_a_barrier_before_the_last_one_has_arrived() {
    let mut room = Room::open().await;
    let parts = vec![
        part("desk-1", ""),
        part("desk-2", ""),
        part("desk-3", "[[steps]]\nwait = \"is the sheet there?\"\n"),
    ];
    let mut running = Running::begin(&room.home, parts, true);
    let mut events = running.until(|event| is_at_barrier(event, 0)).await;
    if !events.iter().any(|event| is_at_barrier(event, 1)) {
        events.extend(running.until(|event| is_at_barrier(event, 1)).await);
    }
    let is_asked = |event: &RunEvent| {
        matches!(
            event,
            RunEvent::News(EngineEvent::WaitsForPerson { part: 2, .. })
        )
    };
    if !events.iter().any(is_asked) {
        events.extend(running.until(is_asked).await);
    }
    let Some(RunEvent::Queued(jobs)) = events.first() else {
        panic!("{events:#?}")
    };
    for desk in 0..3 {
        assert!(!room.has_gone_past(desk), "desk {desk}");
    }
    // A person resumes the third part; then all continue.
    room.desks[2].start(jobs[2]).await;
    let released = |event: &RunEvent| {
        matches!(
            event,
            RunEvent::Started {
                barrier: Some(_),
                ..
            }
        )
    };
    let events = running.until(released).await;
    assert!(
        events.iter().any(|event| is_at_barrier(event, 2)),
        "{events:#?}"
    );
    assert_eq!(running.end().await, Outcome::Done);
    for desk in 0..3 {
        assert!(room.has_gone_past(desk), "desk {desk}");
    }
    room.close().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn if_a_station_is_lost_the_others_hold_before_the_barrier() {
    let mut room = Room::open().await;
    let long = to_and_fro(400);
    let parts = vec![
        part("desk-1", ""),
        part("desk-2", &long),
        part("desk-3", &long),
    ];
    let mut running = Running::begin(&room.home, parts, false);
    running.until(|event| is_at_barrier(event, 0)).await;
    room.desks.remove(1).end().await;
    let is_held = |event: &RunEvent| matches!(event, RunEvent::News(EngineEvent::Held { part: 1, with, .. }) if *with == [0, 2]);
    running.until(is_held).await;
    // No person is present to decide.
    assert_eq!(running.end().await, Outcome::Held);
    let (_, state) = room.desks[1].ask("GET", "/api/v1/state", None).await;
    assert_eq!(state["job"]["phase"], "paused", "{state}");
    for desk in [0, 2] {
        assert!(!room.has_gone_past(desk), "desk {desk}");
    }
    room.close().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_fleet_stop_holds_all_parts_before_the_barrier() {
    let mut room = Room::open().await;
    let parts = vec![part("desk-1", ""), part("desk-2", &to_and_fro(400))];
    let mut running = Running::begin(&room.home, parts, false);
    running.until(|event| is_at_barrier(event, 0)).await;
    let answers = room.desks[2].stop_all().await;
    assert!(answers.iter().all(|answer| answer.answer.is_success()));
    assert_eq!(running.end().await, Outcome::Held);
    for desk in 0..2 {
        assert!(!room.has_gone_past(desk), "desk {desk}");
        assert!(
            room.desks[desk]
                .station
                .handle()
                .state()
                .state()
                .stop
                .is_some()
        );
    }
    room.close().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_person_pauses_and_resumes_all_parts() {
    let mut room = Room::open().await;
    let slow = to_and_fro(4);
    let parts = vec![
        part("desk-1", ""),
        part("desk-2", &slow),
        part("desk-3", ""),
    ];
    let mut running = Running::begin(&room.home, parts, true);
    running
        .until(|event| matches!(event, RunEvent::Started { barrier: None, .. }))
        .await;
    running.orders.send(Order::Hold).await.unwrap();
    running
        .until(|event| matches!(event, RunEvent::News(EngineEvent::Held { .. })))
        .await;
    running.orders.send(Order::Resume).await.unwrap();
    assert_eq!(running.end().await, Outcome::Done);
    for desk in 0..3 {
        assert!(room.has_gone_past(desk), "desk {desk}");
    }
    room.close().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn if_one_station_refuses_its_part_no_arm_moves() {
    let mut room = Room::open().await;
    let deep = "[[steps]]\ngo = { x = 200, y = 30, z = -200 }\n";
    let parts = [part("desk-1", ""), part("desk-2", deep)];
    let (_orders, ordered) = mpsc::channel(8);
    let error = run(&room.home, &parts, false, ordered, |_| {})
        .await
        .unwrap_err();
    let error = error.to_string();
    assert!(error.starts_with("desk-2: step 2 (line 4"), "{error}");
    let (_, jobs) = room.desks[0].ask("GET", "/api/v1/jobs", None).await;
    assert_eq!(jobs, json!([]));
    assert!(!room.has_gone_past(0));
    room.close().await;
}

impl Desk {
    /// A person at the arm has finished the requested work and starts the job.
    async fn start(&self, job: u64) {
        let (status, lease) = self.ask("POST", "/api/v1/lease", None).await;
        assert_eq!(status, 200, "{lease}");
        let request = |method: &str, path: String| ApiRequest {
            method: method.into(),
            path,
            token: Some(self.admin()),
            lease: lease["token"].as_str().map(str::to_owned),
            ..ApiRequest::default()
        };
        for action in ["confirm", "start"] {
            let asked = request("POST", format!("/api/v1/jobs/{job}/{action}"));
            let answer = self.station.api().call(&asked).await;
            assert_eq!(answer.status, 200, "{answer:?}");
        }
        let release = request("DELETE", "/api/v1/lease".into());
        self.station.api().call(&release).await;
    }
}
