use std::path::PathBuf;

use dobot_session::{Address, Link};

use super::*;
use crate::fake::{Harness, packet};

impl Harness<PathBuf> {
    fn served() -> Self {
        let port = VirtualPort::open(None).expect("there is one more");
        let (harness, handle, report) = Self::new(port.path().to_owned());
        tokio::spawn(async move {
            port.serve(&handle, report).await.expect("the port holds");
        });
        harness
    }

    /// Opens the port like a serial program, and is admitted.
    async fn program(&mut self) -> Link {
        let path = self.at.display().to_string();
        let name = format!("serial program {path}");
        let address = Address::Serial { path, baud: 9600 };
        let link = Link::open(&address).await.expect("it is there");
        assert_eq!(self.admit().await, name);
        link
    }
}

#[tokio::test]
async fn a_serial_client_is_served_leaves_and_returns() {
    let mut harness = Harness::served();
    for status in 1..4 {
        let mut program = harness.program().await;
        program.send(&packet(50));
        program.flush().await.expect("it is open");
        assert_eq!(harness.driver.grant().await, packet(50));
        harness.driver.send_status([status; 42]);
        let mut got = Vec::new();
        while got.len() < 42 {
            let open = program.receive(Duration::MAX, &mut got).await;
            assert!(open.expect("it holds"), "closed after {got:?}");
        }
        assert_eq!(got, [status; 42]);
        drop(program);
        let traffic = harness.left().await;
        assert_eq!((traffic.packets, traffic.statuses), (1, 1));
    }
}

#[tokio::test]
async fn the_port_disappears_with_the_station() {
    let mut harness = Harness::served();
    let mut program = harness.program().await;
    drop(harness.driver);
    program.send(&packet(50));
    program.flush().await.expect("it is open");
    while harness.events.recv().await.is_some() {}
}
