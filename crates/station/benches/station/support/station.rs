//! A station in a separate process, as in normal use: this program, started with another argument.

use std::io::{BufRead, BufReader, Read};
use std::net::SocketAddr;
use std::process::{Child, Command, Stdio};

use dobot_api::Folders;
use dobot_controller::Personality;
use dobot_session::Address;
use dobot_station::{Config, Station};
use tempfile::TempDir;

/// A station in a separate process; it ends when this is dropped.
#[derive(Debug)]
pub(crate) struct StationProcess {
    child: Child,
    pub(crate) http: String,
    pub(crate) raw: SocketAddr,
    _folder: TempDir,
}

const WORD: &str = "serve-a-station";

impl StationProcess {
    /// Starts a station with the arm at a port.
    pub(crate) fn start(serial: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder for its data");
        let program = std::env::current_exe().expect("this program has a path");
        let mut child = Command::new(program)
            .arg(WORD)
            .arg(serial)
            .arg(folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("this program starts once more");
        let out = child.stdout.take().expect("it was asked for");
        let mut lines = BufReader::new(out).lines();
        let mut line = || lines.next().expect("it tells where").expect("as text");
        let (http, raw) = (line(), line());
        let http = http.strip_prefix("http://").expect("no TLS on loopback");
        Self {
            http: http.to_owned(),
            raw: raw.parse().expect("an address"),
            child,
            _folder: folder,
        }
    }

    pub(crate) fn pid(&self) -> u32 {
        self.child.id()
    }
}

impl Drop for StationProcess {
    fn drop(&mut self) {
        // It ends when its standard input is closed.
        drop(self.child.stdin.take());
        let _ = self.child.wait();
    }
}

/// Runs a station if this is its process.
pub(crate) fn serve() -> bool {
    let mut words = std::env::args().skip(1);
    if words.next().as_deref() != Some(WORD) {
        return false;
    }
    let (serial, folder) = (words.next(), words.next());
    let (serial, folder) = serial.zip(folder).expect("a port and a folder");
    let config = Config {
        arm: Some(Address::Serial {
            path: serial,
            baud: 9600,
        }),
        dialect: Some(Personality::default().dialect()),
        http: ([127, 0, 0, 1], 0).into(),
        raw: Some(([127, 0, 0, 1], 0).into()),
        ..Config::new(Folders::at(folder))
    };
    // Like that of the program.
    let runtime = tokio::runtime::Runtime::new().expect("threads");
    runtime.block_on(async {
        let station = Box::pin(Station::start(config))
            .await
            .expect("nothing is in its way");
        println!("{}", station.url());
        println!("{}", station.raw().expect("it was asked for"));
        let over = tokio::task::spawn_blocking(|| std::io::stdin().read_to_end(&mut Vec::new()));
        let _ = over.await;
        station.end().await.expect("nothing failed");
    });
    true
}
