use std::path::PathBuf;

use dobot_client::{Address, Link};
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis};
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};

use super::*;
use crate::double::Double;

/// A virtual port with the owner behind it, and what is told.
struct Lab {
    path: PathBuf,
    owner: Double,
    told: UnboundedReceiver<ProgramNews>,
}

impl Lab {
    fn new() -> Self {
        let port = VirtualPort::open(None).expect("there is one more");
        let path = port.path().to_owned();
        let (handle, owner) = Double::new(16);
        let (tell, told) = unbounded_channel();
        tokio::spawn(async move {
            let tell = |news| {
                // A test that has seen enough listens no more.
                let _ = tell.send(news);
            };
            port.serve(&handle, tell).await.expect("the port holds");
        });
        Self { path, owner, told }
    }

    /// Opens the port as a serial program does, and is let in.
    async fn program(&mut self) -> Link {
        let address = Address::Serial {
            path: self.path.display().to_string(),
            baud: 9600,
        };
        let link = Link::open(&address).await.expect("it is there");
        let (_, name, role) = self.owner.admit().await;
        assert_eq!(name, format!("serial program {}", self.path.display()));
        assert_eq!(role, Role::Control);
        assert_eq!(self.news().await, ProgramNews::Came { name });
        link
    }

    async fn news(&mut self) -> ProgramNews {
        self.told.recv().await.expect("the port is served")
    }
}

fn packet() -> [u8; 42] {
    let jog = JointJog {
        axis: JointJogAxis::BasePlus,
        speed_percent: 50.0,
    };
    let frame = Command::from(jog).emit(&Dialect::FIRMWARE_1_1);
    frame.to_bytes()
}

#[tokio::test]
async fn a_serial_program_is_served_leaves_and_comes_again() {
    let mut lab = Lab::new();
    for status in 1..4 {
        let mut program = lab.program().await;
        program.send(&packet());
        program.flush().await.expect("it is open");
        assert_eq!(lab.owner.grant().await, packet());
        lab.owner.send_status([status; 42]);
        let mut got = Vec::new();
        while got.len() < 42 {
            let open = program.receive(Duration::MAX, &mut got).await;
            assert!(open.expect("it holds"), "closed after {got:?}");
        }
        assert_eq!(got, [status; 42]);
        drop(program);
        lab.owner.left().await;
        let ProgramNews::Left { traffic, .. } = lab.news().await else {
            panic!("it has left");
        };
        assert_eq!((traffic.packets, traffic.statuses), (1, 1));
    }
}

#[tokio::test]
async fn the_port_goes_with_the_station() {
    let mut lab = Lab::new();
    let mut program = lab.program().await;
    drop(lab.owner);
    program.send(&packet());
    program.flush().await.expect("it is open");
    while lab.told.recv().await.is_some() {}
}
