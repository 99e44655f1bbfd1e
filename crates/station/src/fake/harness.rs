//! A port for legacy programs with the driver behind it.

use dobot_api::Role;
use dobot_host::StationHandle;
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};

use super::FakeDriver;
use crate::{ProgramNews, Traffic};

/// A port for legacy programs, at an address or a path, with the driver behind it.
pub(crate) struct Harness<At> {
    pub(crate) at: At,
    pub(crate) driver: FakeDriver,
    pub(crate) events: UnboundedReceiver<ProgramNews>,
}

impl<At> Harness<At> {
    /// Returns the harness, the handle of the driver and the callback for events.
    pub(crate) fn new(at: At) -> (Self, StationHandle, impl Fn(ProgramNews) + use<At>) {
        let (handle, driver) = FakeDriver::new(16);
        let (report, events) = unbounded_channel();
        let report = move |news| {
            // The test may have ended.
            let _ = report.send(news);
        };
        (Self { at, driver, events }, handle, report)
    }

    /// Admits the next program and returns its name.
    pub(crate) async fn admit(&mut self) -> String {
        let (_, name, role) = self.driver.admit().await;
        assert_eq!(role, Role::Control);
        let connected = ProgramNews::Came { name: name.clone() };
        assert_eq!(self.news().await, connected);
        name
    }

    /// Returns the next event.
    pub(crate) async fn news(&mut self) -> ProgramNews {
        self.events.recv().await.expect("the port is served")
    }

    /// Returns the traffic of a program that has left, which must be the next event.
    pub(crate) async fn left(&mut self) -> Traffic {
        self.driver.left().await;
        match self.news().await {
            ProgramNews::Left { traffic, .. } => traffic,
            news => panic!("it has left: {news:?}"),
        }
    }
}
