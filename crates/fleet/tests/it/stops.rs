//! Stops of the whole fleet.

use std::time::Duration;

use dobot_api::{ApiRequest, FleetWideStop, State, StopView, TakesWork, WorkPhase, WorkView};
use dobot_fleet::{FleetConfig, VirtualArms, VirtualArmsConfig};
use dobot_host::PassedPacket;
use dobot_wire::{Command, Packet};
use serde_json::{Value, json};
use tokio::sync::broadcast;
use tokio::time::{interval, timeout};

use super::{
    Desk, Folders, PATIENCE, dialect, fleet_config, free_port, is_away, present, router,
    station_config, two_desks,
};

const DRILL: &str = "stopped: fleet, by test at desk-1: fire drill";

impl Desk {
    /// Waits until the state of this station meets the condition.
    async fn is(&self, what: &str, is_so: impl Fn(&State) -> bool) {
        let mut states = self.station.handle().states();
        let waited = timeout(
            PATIENCE,
            states.wait_for(|snapshot| is_so(snapshot.state())),
        )
        .await;
        let state = self.station.handle().state();
        assert!(waited.is_ok(), "{}: never {what}: {state:?}", self.name);
    }

    async fn is_stopped(&self) {
        self.is("stopped by the fleet", |state| {
            text(state).as_deref() == Some(DRILL)
        })
        .await;
    }

    async fn is_at_rest(&self) {
        self.is("at rest", |state| {
            state.stop.as_ref().is_some_and(|stop| stop.at_rest)
        })
        .await;
    }

    async fn is_free(&self) {
        self.is("released", |state| state.stop.is_none()).await;
    }

    /// Stops the whole fleet; returns the members that did not answer.
    async fn drill(&self) -> Vec<String> {
        let body = json!({"reason": "fire drill"});
        let (status, body) = self.ask("POST", "/api/v1/fleet/stop", Some(body)).await;
        assert_eq!(status, 200, "{body}");
        silent(&body)
    }

    /// Resets the stop of the whole fleet; returns the members that do not know it yet.
    async fn reset_all(&self) -> Vec<String> {
        let (status, body) = self.ask("DELETE", "/api/v1/fleet/stop", None).await;
        assert_eq!(status, 200, "{body}");
        silent(&body)
    }

    /// Tries to move the arm on behalf of a person at this station.
    async fn moves(&self) -> (u16, Value) {
        self.is("linked", |state| state.arm.is_some()).await;
        let (status, lease) = self.ask("POST", "/api/v1/lease", None).await;
        assert_eq!(status, 200, "{lease}");
        let request = |method: &str, path: &str| ApiRequest {
            method: method.into(),
            path: path.into(),
            token: Some(self.admin()),
            lease: lease["token"].as_str().map(str::to_owned),
            ..ApiRequest::default()
        };
        let command = ApiRequest {
            body: Some(json!({"command": target()})),
            ..request("POST", "/api/v1/commands")
        };
        let answer = self.station.api().call(&command).await;
        let left = request("DELETE", "/api/v1/lease");
        assert_eq!(self.station.api().call(&left).await.status, 200);
        (answer.status, answer.body)
    }

    /// Checks that no person at this station can move the arm.
    async fn refuses_to_move(&self) {
        let (status, problem) = self.moves().await;
        assert_eq!(status, 409, "{problem}");
        assert_eq!(problem["type"], "/api/v1/problems/stopped");
        assert_eq!(problem["detail"], DRILL);
    }
}

fn target() -> Value {
    json!({"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50, "rotation_deg": 0, "suction": false, "mode": "jump", "gripper_deg": 0, "pause_s": 0})
}

fn text(state: &State) -> Option<String> {
    state.stop.as_ref().map(StopView::text)
}

fn silent(answers: &Value) -> Vec<String> {
    let answers = answers.as_array().unwrap().iter();
    let silent = answers.filter(|answer| answer["answer"]["status"] != 200);
    silent
        .map(|answer| answer["member"].as_str().unwrap().to_owned())
        .collect()
}

/// Returns the commands that have reached an arm, except those that bring it to rest.
fn motions(packets: &mut broadcast::Receiver<PassedPacket>) -> Vec<Command> {
    let mut sent = Vec::new();
    while let Ok(packet) = packets.try_recv() {
        if packet.to_arm {
            let packet = Packet::from_bytes(&packet.bytes).unwrap();
            sent.push(Command::parse(&packet, &dialect()).unwrap());
        }
    }
    sent.retain(|command| !matches!(command, Command::JointJog(_)));
    sent
}

#[tokio::test(flavor = "multi_thread")]
async fn a_station_that_joins_late_is_stopped_too_and_all_stay_stopped_through_a_restart() {
    let (router, at) = router(free_port()).await;
    let [one, two] = two_desks(&at).await;
    assert!(one.drill().await.is_empty());
    let late = Desk::up("desk-3", &at, None).await;
    let mut packets = late.station.handle().passed();
    for desk in [&one, &two, &late] {
        desk.is_stopped().await;
        desk.refuses_to_move().await;
    }
    assert!(motions(&mut packets).is_empty());
    // All restart at the same time, so that none can inform another.
    let mut folders = Vec::new();
    for desk in [one, two, late] {
        folders.push((desk.name.clone(), desk.left().await));
    }
    for (name, folder) in folders {
        let desk = Desk::in_folder(&name, &at, None, folder).await;
        desk.is_stopped().await;
        desk.refuses_to_move().await;
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_disconnected_station_is_stopped_and_reset_when_it_returns() {
    let port = free_port();
    let (first, at) = router(port).await;
    let [one, two] = two_desks(&at).await;
    first.end().await;
    one.sees("that desk-2 is away", is_away("desk-2")).await;
    assert_eq!(one.drill().await, ["desk-2"]);
    assert_eq!(text(two.station.handle().state().state()), None);
    let (second, _) = router(port).await;
    two.is_stopped().await;
    two.refuses_to_move().await;
    one.sees("both again", present(&["desk-1", "desk-2"])).await;
    // The reset happens while it is away again.
    second.end().await;
    one.sees("that desk-2 is away", is_away("desk-2")).await;
    one.is_at_rest().await;
    assert_eq!(one.reset_all().await, ["desk-2"]);
    one.is_free().await;
    two.refuses_to_move().await;
    let (third, _) = router(port).await;
    two.is_free().await;
    let (status, moved) = two.moves().await;
    assert_eq!(status, 202, "{moved}");
    for desk in [one, two] {
        desk.end().await;
    }
    third.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_arm_reset_by_a_person_moves_and_is_not_stopped_again_by_the_same_stop() {
    let port = free_port();
    let (first, at) = router(port).await;
    let [one, two] = two_desks(&at).await;
    assert!(one.drill().await.is_empty());
    two.is_at_rest().await;
    let (status, body) = two.ask("DELETE", "/api/v1/stop", None).await;
    assert_eq!(status, 200, "{body}");
    // The others send it again when it returns, and when it is restarted.
    first.end().await;
    one.sees("that desk-2 is away", is_away("desk-2")).await;
    let (second, _) = router(port).await;
    one.sees("both again", present(&["desk-1", "desk-2"])).await;
    let folder = two.left().await;
    let two = Desk::in_folder("desk-2", &at, None, folder).await;
    two.sees("both", present(&["desk-1", "desk-2"])).await;
    let knows = |state: &State| state.fleet_stops.iter().any(FleetWideStop::holds);
    two.is("informed of the stop", knows).await;
    let (status, moved) = two.moves().await;
    assert_eq!(status, 202, "{moved}");
    one.refuses_to_move().await;
    // A stopped member remains, which holds new arrivals.
    let late = Desk::up("desk-3", &at, None).await;
    late.is_stopped().await;
    // Members that do not answer within two seconds are asked again.
    drop(two.reset_all().await);
    for desk in [&one, &two, &late] {
        desk.is_free().await;
    }
    for desk in [one, two, late] {
        desk.end().await;
    }
    second.end().await;
}

/// A station that submits jobs and starts the jobs that it takes.
async fn worker(name: &str, at: &str, folder: tempfile::TempDir) -> Desk {
    let mut config = FleetConfig {
        work: Some(Folders::at(folder.path()).fleet_work()),
        ..fleet_config(name)
    };
    config.about.takes_work = Some(TakesWork::Start);
    Desk::joining(config, at, None, folder).await
}

impl Desk {
    async fn submit(&self, title: &str) {
        let job = json!({"title": title, "kind": "program", "commands": [target()]});
        let work = json!({"job": job, "student": "Anna"});
        let (status, body) = self.ask("POST", "/api/v1/fleet/work", Some(work)).await;
        assert_eq!(status, 201, "{body}");
    }

    async fn work(&self) -> Vec<WorkView> {
        let (status, body) = self.ask("GET", "/api/v1/fleet/work", None).await;
        assert_eq!(status, 200, "{body}");
        serde_json::from_value(body).unwrap()
    }

    /// Waits until the job that was submitted here meets the condition.
    async fn has_work(&self, what: &str, is_so: impl Fn(&WorkView) -> bool) {
        let mut looks = interval(Duration::from_millis(50));
        let looking = async {
            while !self.work().await.iter().all(&is_so) {
                looks.tick().await;
            }
        };
        let looked = timeout(PATIENCE, looking).await;
        assert!(looked.is_ok(), "never {what}: {:#?}", self.work().await);
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn while_the_fleet_is_stopped_its_queue_waits_and_no_joining_arm_starts_anything() {
    let (router, at) = router(free_port()).await;
    let one = worker("desk-1", &at, tempfile::tempdir().unwrap()).await;
    one.is("linked", |state| state.arm.is_some()).await;
    assert!(one.drill().await.is_empty());
    one.submit("first").await;
    let late = worker("desk-2", &at, tempfile::tempdir().unwrap()).await;
    let mut packets = [&one, &late].map(|arm| arm.station.handle().passed());
    late.is_stopped().await;
    let is_wanted = |work: &WorkView| {
        let reason = work.reason.as_deref().unwrap_or_default();
        work.phase == WorkPhase::Waiting && reason.contains(DRILL)
    };
    one.has_work("waiting, with the reason", is_wanted).await;
    // A person releases one arm: the queue of the fleet still waits.
    late.is("at rest", |state| {
        state.stop.as_ref().is_some_and(|stop| stop.at_rest)
    })
    .await;
    late.ask("DELETE", "/api/v1/stop", None).await;
    late.is_free().await;
    // The home is killed, and resumes with the jobs on its disk.
    let one = worker("desk-1", &at, one.left().await).await;
    one.is_stopped().await;
    one.has_work("waiting, with the reason", is_wanted).await;
    for packets in &mut packets {
        assert!(motions(packets).is_empty());
    }
    one.is_at_rest().await;
    one.reset_all().await;
    one.has_work("done", |work| work.phase == WorkPhase::Done)
        .await;
    for desk in [one, late] {
        desk.end().await;
    }
    router.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_virtual_arm_created_while_the_fleet_is_stopped_is_stopped() {
    let (router, at) = router(free_port()).await;
    let hall = Desk::up("desk-1", &at, None).await;
    let config = VirtualArmsConfig {
        most: 1,
        unused: Duration::from_secs(3600),
        station: station_config(hall.folder.path()),
        fleet: fleet_config("desk-1"),
        session: hall.session.clone(),
    };
    let arms = VirtualArms::start(config, hall.station.api());
    assert!(hall.drill().await.is_empty());
    let wanted = json!({"name": "anna"});
    let (status, given) = hall
        .ask("POST", "/api/v1/fleet/virtual-arms", Some(wanted))
        .await;
    assert_eq!(status, 200, "{given}");
    let asked = json!({"to": {"members": ["anna"]}, "method": "GET", "path": "/api/v1/state"});
    hall.sees("it", present(&["anna", "desk-1"])).await;
    let state = hall.all_as(Some(hall.admin()), asked).await.remove(0);
    let state: State = serde_json::from_value(state.answer.body).unwrap();
    assert_eq!(text(&state).as_deref(), Some(DRILL));
    arms.end().await;
    hall.end().await;
    router.end().await;
}
