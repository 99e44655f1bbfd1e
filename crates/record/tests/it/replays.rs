//! A recorded session is played back: the same client finds the same arm.

use std::path::{Path, PathBuf};
use std::time::Duration;

use dobot_controller::{Controller, PowerUp};
use dobot_record::{About, Limits, Record, Recorder, Replay, recordings};
use dobot_session::{Connection, LinkError, Peer};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::{Dialect, MoveTo, MovingMode, Status};

/// An arm whose bytes are recorded, both ways.
#[derive(Debug)]
struct Tapped {
    arm: InProcess,
    recorder: Recorder,
}

impl Peer for Tapped {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        let now = self.arm.now();
        self.recorder.record(now, Record::ToArm(bytes.to_vec()));
        self.arm.send(bytes);
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        let had = bytes.len();
        let open = self.arm.receive(until, bytes);
        let record = Record::FromArm(bytes[had..].to_vec());
        self.recorder.record(self.arm.now(), record);
        open
    }
}

/// Moves to a point and back; returns the position at the end.
async fn there_and_back(arm: &mut Connection, x_mm: f32) -> Result<Status, LinkError> {
    for x_mm in [x_mm, 200.0] {
        let id = arm.send(MoveTo::to(x_mm, 0.0, 20.0).with_mode(MovingMode::MovJ))?;
        arm.completed(id).await?;
    }
    arm.next_status().await
}

/// A recording of a session, and the client's view at its end.
async fn recorded(folder: &Path) -> (PathBuf, Status) {
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    let recorder = Recorder::start(folder, Limits::DEFAULT, About::default(), start).unwrap();
    let controller = Controller::power_up(PowerUp::default());
    let arm = InProcess::new(VirtualArm::new(controller, SerialLine::STOCK));
    let tapped = Tapped { arm, recorder };
    let mut arm = Connection::over_peer(tapped, Some(Dialect::SPECIFICATION));
    let status = there_and_back(&mut arm, 230.0).await.unwrap();
    drop(arm);
    let files = recordings(folder).unwrap();
    (files[0].path.clone(), status)
}

#[tokio::test]
async fn the_same_client_sees_the_same_and_does_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let (file, seen) = recorded(folder.path()).await;
    let replay = Replay::open(file).unwrap();
    let mut arm = Connection::over_peer(replay.clone(), Some(Dialect::SPECIFICATION));
    assert_eq!(there_and_back(&mut arm, 230.0).await.unwrap(), seen);
    let report = replay.report();
    assert!(report.is_same(), "{report:?}");
    assert_eq!((report.same, report.damage), (2, None));
    assert_eq!(report.furthest_apart, Duration::ZERO);
}

#[tokio::test]
async fn a_client_that_acts_differently_is_reported_with_time_expected_and_found() {
    let folder = tempfile::tempdir().unwrap();
    let (file, _) = recorded(folder.path()).await;
    let replay = Replay::open(file).unwrap();
    let mut arm = Connection::over_peer(replay.clone(), Some(Dialect::SPECIFICATION));
    // It waits in vain to get there, and the recording ends.
    assert!(there_and_back(&mut arm, 231.0).await.is_err());
    let report = replay.report();
    assert!(!report.is_same());
    let first = report.differences[0].to_string();
    // Little-endian floats: 231 is 0x43670000, 230 is 0x43660000.
    for part in [
        "the client sent a500004040",
        "00006743",
        "the recording has",
        "00006643",
    ] {
        assert!(first.contains(part), "{part}: {first}");
    }
    assert_eq!(report.same, 0);
}

#[tokio::test]
async fn a_client_that_sends_nothing_misses_the_recorded_packets() {
    let folder = tempfile::tempdir().unwrap();
    let (file, _) = recorded(folder.path()).await;
    let mut replay = Replay::open(file).unwrap();
    let mut bytes = Vec::new();
    while replay.receive(Duration::MAX, &mut bytes) {}
    let report = replay.report();
    assert_eq!(report.differences.len(), 2);
    assert!(
        report
            .differences
            .iter()
            .all(|difference| difference.sent.is_none())
    );
    assert_eq!(replay.poll_wakeup(), None);
    // The second time it sends the same.
    assert_eq!(replay.report(), report);
}

#[test]
fn a_recording_without_packets_is_over_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("empty.mcap");
    std::fs::write(&file, mcap::MAGIC).unwrap();
    let mut replay = Replay::open(file).unwrap();
    assert!(!replay.receive(Duration::from_secs(1), &mut Vec::new()));
    assert_eq!(replay.now(), Duration::ZERO);
    replay.send(&[1, 2, 3]);
    let report = replay.report();
    assert_eq!(report.noise_bytes, 3);
    assert!(!report.is_same());
    assert!(report.damage.is_some());
}
