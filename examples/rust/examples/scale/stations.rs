//! Many stations with virtual arms.

use std::error::Error;
use std::time::Duration;

use dobot_api::{ApiRequest, FleetView, Folders, MemberAbout, Role, StationAddress, fetch};
use dobot_fleet::{Credentials, Fleet, FleetConfig, FleetSession, own_id};
use dobot_host::Client;
use dobot_session::Address;
use dobot_station::{Config, Station, Token, Tokens};
use serde_json::json;
use tempfile::TempDir;
use tokio::io::AsyncWriteExt;
use tokio::net::TcpStream;
use tokio::time::interval;

/// Many stations with virtual arms.
#[derive(Debug)]
pub(crate) struct Stations {
    pub(crate) all: Vec<Desk>,
    /// A token that each of them accepts.
    pub(crate) token: Token,
    _folder: TempDir,
}

/// A station, and its membership.
#[derive(Debug)]
pub(crate) struct Desk {
    pub(crate) name: String,
    pub(crate) station: Station,
    folders: Folders,
    fleet: Option<Fleet>,
}

impl Stations {
    /// Starts this many independent stations.
    pub(crate) async fn start(count: u16) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let folder = tempfile::tempdir()?;
        let mut tokens = Tokens::open(&Folders::at(folder.path()).tokens())?;
        let token = tokens.add(Role::Admin, "teacher")?;
        let mut all = Vec::new();
        for number in 1..=count {
            let name = format!("desk-{number}");
            let folders = Folders::at(folder.path().join(&name));
            std::fs::create_dir_all(folders.data())?;
            Tokens::open(&folders.tokens())?.accept(Role::Admin, "teacher", &token)?;
            all.push(Desk::start(name, folders).await?);
        }
        Ok(Self {
            all,
            token,
            _folder: folder,
        })
    }

    /// Lets all of them join through a router, this many with the same session.
    pub(crate) async fn join(
        &mut self,
        router: &str,
        by_one_session: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        for desks in self.all.chunks_mut(by_one_session) {
            // They join as virtual arms hosted by the first one.
            let holder = desks[0].name.clone();
            let credentials = Credentials::of_person(&holder)?;
            let session = FleetSession::open(&[router.to_owned()], &credentials).await?;
            for desk in desks {
                desk.join(&session, &holder).await?;
            }
        }
        Ok(())
    }

    /// Waits until each of them knows all others.
    pub(crate) async fn all_know_all(&self) {
        let names = self.all.iter().map(|item| item.name.as_str());
        // The request is only sent if all recipients are known: the last one never is.
        let names: Vec<_> = names.chain([MISSING_STATION]).collect();
        let request = ApiRequest {
            method: "POST".into(),
            path: "/api/v1/fleet/requests".into(),
            token: Some(self.token.secret().into()),
            body: Some(json!({"to": {"members": names}, "method": "GET", "path": "/healthz"})),
            ..ApiRequest::default()
        };
        let mut looks = interval(LOOK_EVERY);
        for desk in &self.all {
            while !desk.knows_all(&request).await {
                looks.tick().await;
            }
        }
    }

    /// Opens a board at the first station, and waits until it knows the states of all.
    pub(crate) async fn board(&self) -> Result<Board, Box<dyn Error + Send + Sync>> {
        let first = self.first();
        let mut stream = TcpStream::connect((first.host(), first.port())).await?;
        let request = format!(
            "GET /api/v1/fleet/events HTTP/1.1\r\nHost: {}:{}\r\n\r\n",
            first.host(),
            first.port()
        );
        stream.write_all(request.as_bytes()).await?;
        let reads = tokio::spawn(async move {
            // Until the task is aborted.
            let _ = tokio::io::copy(&mut stream, &mut tokio::io::sink()).await;
        });
        let mut looks = interval(LOOK_EVERY);
        loop {
            let view: FleetView = fetch(&first, "/api/v1/fleet").await?;
            let reported = view
                .members
                .iter()
                .filter(|station| station.state.is_some());
            if reported.count() == self.all.len() {
                return Ok(Board(reads));
            }
            looks.tick().await;
        }
    }

    /// Returns the address of the first station.
    pub(crate) fn first(&self) -> StationAddress {
        self.all[0].address()
    }

    /// Ends all stations.
    pub(crate) async fn end(self) -> Result<(), Box<dyn Error + Send + Sync>> {
        for desk in self.all {
            if let Some(fleet) = desk.fleet {
                fleet.leave().await;
            }
            desk.station.end().await?;
        }
        Ok(())
    }
}

/// An open board.
#[derive(Debug)]
pub(crate) struct Board(tokio::task::JoinHandle<()>);

impl Drop for Board {
    fn drop(&mut self) {
        self.0.abort();
    }
}

impl Desk {
    async fn start(name: String, folders: Folders) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let station = Station::start(Config {
            arm: Some(Address::Virtual),
            http: "127.0.0.1:0".parse()?,
            raw: None,
            ..Config::new(folders.clone())
        });
        Ok(Self {
            name,
            station: station.await?,
            folders,
            fleet: None,
        })
    }

    async fn join(
        &mut self,
        session: &FleetSession,
        holder: &str,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        let config = FleetConfig {
            name: self.name.clone(),
            about: MemberAbout {
                groups: vec!["room-1".into()],
                is_virtual: true,
                given_by: (self.name != holder).then(|| holder.to_owned()),
                ..MemberAbout::default()
            },
            work: Some(self.folders.fleet_work()),
        };
        let id = own_id(&self.folders.fleet_id())?;
        self.fleet = Some(Fleet::join(session, &config, &id, self.station.api()).await?);
        Ok(())
    }

    /// Whether only the non-existing station is unknown.
    async fn knows_all(&self, request: &ApiRequest) -> bool {
        let answer = self.station.api().call(request).await;
        answer.status == 404
            && answer.body["detail"]
                .as_str()
                .is_some_and(|body| body.contains(MISSING_STATION))
    }

    /// Returns the address of its API.
    pub(crate) fn address(&self) -> StationAddress {
        StationAddress::new(self.station.url()).expect("a station has an address")
    }

    /// Returns a client with all rights.
    pub(crate) async fn teacher(&self) -> Result<Client, dobot_supervisor::Refusal> {
        self.station.handle().client("teacher", Role::Admin).await
    }
}

const MISSING_STATION: &str = "nobody";
const LOOK_EVERY: Duration = Duration::from_millis(20);
