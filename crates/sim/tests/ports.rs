//! A served arm, over real pseudo-terminals and real TCP connections, in real time.

#![cfg(unix)]

mod common;

use std::fs::{File, OpenOptions};
use std::future::Future;
use std::io::Write;
use std::net::{Ipv4Addr, SocketAddr};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::time::Duration;

use common::{POWER_UP_X_MM, button, move_to, ms, virtual_arm};
use dobot_client::{Connection, plausible};
use dobot_controller::PowerUp;
use dobot_sim::{Pty, Server, ServerEvent, Speed, What};
use dobot_wire::{Command, Decoder, Dialect, JointJogAxis, MoveTo, MovingMode, Status};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};

/// What the server tells.
struct Told(UnboundedReceiver<ServerEvent>);

impl Told {
    /// Waits for an event and skips those before it.
    async fn until(&mut self, wanted: impl Fn(&ServerEvent) -> bool) -> ServerEvent {
        loop {
            let event = self.0.recv().await.expect("the server runs");
            if wanted(&event) {
                return event;
            }
        }
    }

    async fn refusal(&mut self) {
        self.until(|it| matches!(it, ServerEvent::Refused(_))).await;
    }

    async fn disconnected(&mut self) {
        self.until(|it| *it == ServerEvent::Disconnected).await;
    }
}

/// Serves the arm while a test does something with it.
async fn serve<F: Future<Output = ()>>(server: &mut Server, test: impl FnOnce(Told) -> F) {
    let (tell, told) = unbounded_channel();
    tokio::select! {
        ended = server.run(|event| {
            // A test that has seen enough listens no more.
            let _ = tell.send(event);
        }) => panic!("the server ended: {ended:?}"),
        () = test(Told(told)) => {}
        () = tokio::time::sleep(HANGS) => panic!("the test hangs"),
    }
}

async fn listen() -> (TcpListener, SocketAddr) {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))
        .await
        .expect("a port is free");
    let address = listener.local_addr().expect("it is bound");
    (listener, address)
}

/// A served arm on TCP.
async fn on_tcp() -> (Server, SocketAddr) {
    let (listener, address) = listen().await;
    (Server::new(virtual_arm()).on_tcp(listener), address)
}

/// A served arm on a virtual serial port, and its name.
fn on_pty() -> (Server, String) {
    let pty = Pty::open(None).expect("there is one more");
    let path = pty.path().to_str().expect("the name is text").to_owned();
    (Server::new(virtual_arm()).on_pty(pty), path)
}

async fn connect(address: &str) -> Connection {
    let address = address.parse().expect("it is an address");
    Connection::open(&address, Some(Dialect::SPECIFICATION))
        .await
        .expect("it can be opened")
}

fn bytes(command: impl Into<Command>) -> [u8; 42] {
    command.into().emit(&Dialect::SPECIFICATION).to_bytes()
}

fn there() -> MoveTo {
    move_to(MovingMode::MovL, 250.0, 10.0, 0.0)
}

/// What the controller refuses, and so says that it has come to it.
fn marker() -> [u8; 42] {
    bytes(move_to(MovingMode::MovL, 900.0, 0.0, 0.0))
}

fn plain_open(path: &str) -> File {
    OpenOptions::new()
        .read(true)
        .write(true)
        .open(path)
        .expect("it is there")
}

#[track_caller]
fn assert_at(status: &Status, x_mm: f32, y_mm: f32, z_mm: f32) {
    for (found, expected) in [
        (status.x_mm, x_mm),
        (status.y_mm, y_mm),
        (status.z_mm, z_mm),
    ] {
        let tolerance = 1e-3;
        assert!(
            (found - expected).abs() < tolerance,
            "{found} is not {expected}, tolerance {tolerance}: {status:?}"
        );
    }
}

mod links {
    use super::*;

    fn folder() -> tempfile::TempDir {
        tempfile::tempdir().expect("there is room")
    }

    #[test]
    fn a_port_without_a_link_goes_by_its_own_name() {
        let pty = Pty::open(None).expect("there is one more");
        assert!(pty.path().starts_with("/dev"), "{}", pty.path().display());
        drop(plain_open(pty.path().to_str().expect("it is text")));
    }

    #[test]
    fn a_link_leads_to_the_port_until_the_port_is_gone() {
        let folder = folder();
        let link = folder.path().join("arm");
        let pty = Pty::open(Some(&link)).expect("nothing is in the way");
        assert_eq!(pty.path(), link);
        drop(plain_open(link.to_str().expect("it is text")));
        drop(pty);
        assert!(!link.is_symlink());
    }

    #[test]
    fn a_link_that_leads_nowhere_is_replaced() {
        let folder = folder();
        let link = folder.path().join("arm");
        symlink(folder.path().join("gone"), &link).expect("there is room");
        let _pty = Pty::open(Some(&link)).expect("nothing of worth is in the way");
        let target = std::fs::read_link(&link).expect("it is a link");
        assert!(target.starts_with("/dev"), "{}", target.display());
    }

    #[test]
    fn a_file_in_the_way_is_refused_and_kept() {
        let folder = folder();
        let file = folder.path().join("arm");
        std::fs::write(&file, "dear").expect("there is room");
        let error = Pty::open(Some(&file)).expect_err("a file is in the way");
        assert_eq!(error.kind(), std::io::ErrorKind::AlreadyExists);
        assert_eq!(std::fs::read_to_string(&file).expect("it is there"), "dear");
    }

    #[test]
    fn a_link_to_something_is_refused_and_kept() {
        let folder = folder();
        let [file, link] = ["file", "arm"].map(|name| folder.path().join(name));
        std::fs::write(&file, "dear").expect("there is room");
        symlink(&file, &link).expect("there is room");
        let error = Pty::open(Some(&link)).expect_err("a link is in the way");
        assert_eq!(error.kind(), std::io::ErrorKind::AlreadyExists);
        assert_eq!(std::fs::read_link(&link).expect("it is there"), file);
    }

    #[test]
    fn a_link_that_somebody_put_in_its_place_is_kept() {
        let folder = folder();
        let link = folder.path().join("arm");
        let pty = Pty::open(Some(&link)).expect("nothing is in the way");
        std::fs::remove_file(&link).expect("it is there");
        symlink("elsewhere", &link).expect("there is room");
        drop(pty);
        let target = std::fs::read_link(&link).expect("it is there");
        assert_eq!(target, Path::new("elsewhere"));
    }
}

mod on_a_virtual_serial_port {
    use super::*;

    #[tokio::test]
    async fn a_serial_program_moves_the_arm_leaves_and_comes_again() {
        let (mut server, path) = on_pty();
        let address = format!("serial:{path}");
        serve(&mut server, async |mut told: Told| {
            let mut arm = connect(&address).await;
            let status = arm.next_status().await.expect("one comes");
            #[expect(clippy::cast_possible_truncation, reason = "a status is single")]
            let x_mm = POWER_UP_X_MM as f32;
            assert_at(&status, x_mm, 0.0, -17.677_67);
            let id = arm.send(there()).expect("it is allowed");
            arm.completed(id).await.expect("it is within reach");
            drop(arm);
            told.disconnected().await;
            for _ in 0..3 {
                let mut arm = connect(&address).await;
                let status = arm.next_status().await.expect("one comes");
                assert_at(&status, 250.0, 10.0, 0.0);
                drop(arm);
                told.disconnected().await;
            }
        })
        .await;
    }

    /// A program that sends the arm on its way and reads nothing, until the arm is there.
    async fn leave_unread(path: &str, told: &mut Told) {
        let mut deaf = plain_open(path);
        deaf.write_all(&bytes(there())).expect("it takes them");
        deaf.write_all(&marker()).expect("it takes them");
        told.refusal().await;
    }

    #[tokio::test]
    async fn a_plain_program_gets_nothing_that_was_sent_before_it_came() {
        let (mut server, path) = on_pty();
        serve(&mut server, async |mut told: Told| {
            leave_unread(&path, &mut told).await;
            told.disconnected().await;
            // Nothing is discarded here by opening: the file is opened and read, no more.
            let file = tokio::fs::File::from_std(plain_open(&path));
            let statuses = read_statuses(file, 2).await;
            for status in &statuses {
                assert_at(status, 250.0, 10.0, 0.0);
            }
        })
        .await;
    }

    #[tokio::test]
    async fn a_connection_gets_nothing_that_was_sent_before_it_however_fast_it_comes() {
        let (mut server, path) = on_pty();
        serve(&mut server, async |mut told: Told| {
            leave_unread(&path, &mut told).await;
            let mut arm = connect(&format!("serial:{path}")).await;
            let status = arm.next_status().await.expect("one comes");
            assert_at(&status, 250.0, 10.0, 0.0);
        })
        .await;
    }

    #[tokio::test]
    async fn a_program_that_writes_and_leaves_at_once_is_heard() {
        let (mut server, path) = on_pty();
        serve(&mut server, async |mut told: Told| {
            plain_open(&path)
                .write_all(&marker())
                .expect("it takes them");
            told.until(|it| *it == ServerEvent::PtyOpened).await;
            told.disconnected().await;
            told.refusal().await;
        })
        .await;
    }

    #[tokio::test]
    async fn a_killed_client_does_not_lock_the_next_one_out() {
        let folder = tempfile::tempdir().expect("there is room");
        let link = folder.path().join("arm");
        let pty = Pty::open(Some(&link)).expect("nothing is in the way");
        let mut server = Server::new(virtual_arm()).on_pty(pty);
        let path = link.to_str().expect("it is text");
        serve(&mut server, async |mut told: Told| {
            let killed = plain_open(path);
            rustix::termios::ioctl_tiocexcl(&killed).expect("it is a terminal");
            told.until(|it| *it == ServerEvent::PtyOpened).await;
            drop(killed);
            told.disconnected().await;
            let mut arm = connect(&format!("serial:{path}")).await;
            arm.next_status().await.expect("one comes");
        })
        .await;
    }
}

mod over_tcp {
    use super::*;

    #[tokio::test]
    async fn statuses_arrive_whole() {
        let (mut server, address) = on_tcp().await;
        serve(&mut server, async |_| {
            let stream = TcpStream::connect(address).await.expect("it listens");
            read_statuses(stream, 10).await;
        })
        .await;
    }

    #[tokio::test]
    async fn a_move_is_seen_to_be_over() {
        let (mut server, address) = on_tcp().await;
        serve(&mut server, async |_| {
            let mut arm = connect(&format!("tcp:{address}")).await;
            let id = arm.send(there()).expect("it is allowed");
            arm.completed(id).await.expect("it is within reach");
            let status = arm.next_status().await.expect("one comes");
            assert_at(&status, 250.0, 10.0, 0.0);
        })
        .await;
    }

    #[tokio::test]
    async fn a_second_client_is_turned_away_until_the_first_has_left() {
        let (mut server, address) = on_tcp().await;
        serve(&mut server, async |mut told: Told| {
            let mut first = connect(&format!("tcp:{address}")).await;
            first.next_status().await.expect("one comes");
            let mut second = TcpStream::connect(address).await.expect("it listens");
            let from = second.local_addr().expect("it is connected");
            assert_eq!(second.read(&mut [0; 42]).await.unwrap_or(0), 0);
            told.until(|it| *it == ServerEvent::TcpRefused(from)).await;
            first
                .next_status()
                .await
                .expect("the first one is still served");
            drop(first);
            told.disconnected().await;
            let mut third = connect(&format!("tcp:{address}")).await;
            third.next_status().await.expect("one comes");
        })
        .await;
    }

    #[tokio::test]
    async fn a_client_that_leaves_in_the_middle_of_a_packet_harms_nobody() {
        let (mut server, address) = on_tcp().await;
        serve(&mut server, async |mut told: Told| {
            let mut torn = TcpStream::connect(address).await.expect("it listens");
            torn.write_all(&marker()[..20])
                .await
                .expect("it takes them");
            drop(torn);
            told.disconnected().await;
            let mut arm = connect(&format!("tcp:{address}")).await;
            let id = arm.send(there()).expect("it is allowed");
            arm.completed(id).await.expect("it is within reach");
        })
        .await;
        let counters = server.arm().controller().counters();
        assert_eq!((counters.packets, counters.skipped_bytes), (1, 20));
        assert_eq!(counters.refused, 0);
    }

    #[tokio::test]
    async fn a_client_that_never_reads_does_not_stop_the_arm() {
        let (mut server, address) = on_tcp().await;
        serve(&mut server, async |mut told: Told| {
            let mut deaf = TcpStream::connect(address).await.expect("it listens");
            deaf.write_all(&bytes(there()))
                .await
                .expect("it takes them");
            deaf.write_all(&marker()).await.expect("it takes them");
            told.refusal().await;
        })
        .await;
        let arm = server.arm();
        let position = arm.controller().pose_at(arm.now()).position;
        assert_eq!(
            (position.x.0, position.y.0, position.z.0),
            (250.0, 10.0, 0.0)
        );
    }

    #[tokio::test]
    async fn a_client_that_sends_faster_than_the_line_is_told_of_once_and_served_on() {
        let (mut server, address) = on_tcp().await;
        serve(&mut server, async |mut told: Told| {
            let mut flood = TcpStream::connect(address).await.expect("it listens");
            for _ in 0..100 {
                flood.write_all(&[0x55; 1000]).await.expect("it takes them");
            }
            told.until(|it| *it == ServerEvent::Overrun).await;
            let statuses = read_statuses(flood, 3).await;
            assert_eq!(statuses.len(), 3);
            let again = |it: &ServerEvent| *it == ServerEvent::Overrun;
            told.until(|it| *it == ServerEvent::Disconnected || again(it))
                .await;
            assert!(!std::iter::from_fn(|| told.0.try_recv().ok()).any(|it| again(&it)));
        })
        .await;
        assert!(server.arm().lost_bytes() > 90_000);
    }
}

mod on_both {
    use super::*;

    async fn on_both() -> (Server, SocketAddr, String) {
        let (server, path) = on_pty();
        let (listener, address) = listen().await;
        (server.on_tcp(listener), address, path)
    }

    #[tokio::test]
    async fn who_has_the_serial_port_open_has_the_arm() {
        let (mut server, address, path) = on_both().await;
        serve(&mut server, async |mut told: Told| {
            let mut first = connect(&format!("serial:{path}")).await;
            first.next_status().await.expect("one comes");
            let mut second = TcpStream::connect(address).await.expect("it listens");
            assert_eq!(second.read(&mut [0; 42]).await.unwrap_or(0), 0);
            first.next_status().await.expect("it is still served");
            drop(first);
            told.disconnected().await;
            let mut third = connect(&format!("tcp:{address}")).await;
            third.next_status().await.expect("one comes");
        })
        .await;
    }

    #[tokio::test]
    async fn who_opens_the_serial_port_during_a_tcp_connection_gets_the_arm_after_it() {
        let (mut server, address, path) = on_both().await;
        serve(&mut server, async |mut told: Told| {
            let mut first = connect(&format!("tcp:{address}")).await;
            first.next_status().await.expect("one comes");
            let mut second = plain_open(&path);
            second.write_all(&marker()).expect("it takes them");
            for _ in 0..5 {
                first.next_status().await.expect("it is still served");
            }
            drop(first);
            told.until(|it| *it == ServerEvent::PtyOpened).await;
            let statuses = read_statuses(tokio::fs::File::from_std(second), 2).await;
            assert_eq!(statuses.len(), 2);
        })
        .await;
        let counters = server.arm().controller().counters();
        assert_eq!(counters.packets, 0, "only who has the arm is heard");
    }
}

mod at_the_greatest_speed {
    use super::*;

    #[tokio::test]
    async fn time_runs_on_from_status_to_status_and_no_answer_comes_too_late() {
        let (server, address) = on_tcp().await;
        let mut server = server.at_speed(Speed::MAX);
        serve(&mut server, async |_| {
            let mut arm = connect(&format!("tcp:{address}")).await;
            let mut last = None;
            for n in 0..20_u8 {
                let side = if n % 2 == 0 { 80.0 } else { -80.0 };
                let there = move_to(MovingMode::MovL, 200.0, side, 0.0);
                last = Some(arm.send(there).expect("it is allowed"));
            }
            let last = last.expect("there are twenty");
            arm.completed(last).await.expect("nothing is lost");
        })
        .await;
        let arm = server.arm();
        assert_eq!(arm.controller().counters().packets, 20);
        // Twenty ways of 160 mm, the first one apart, at 50 mm/s at the most.
        assert!(arm.now() > Duration::from_mins(1), "{:?}", arm.now());
    }

    #[tokio::test(start_paused = true)]
    async fn time_stands_still_without_a_client() {
        let mut server = Server::new(virtual_arm()).at_speed(Speed::MAX);
        serve(&mut server, |_| tokio::time::sleep(Duration::from_secs(10))).await;
        assert_eq!(server.arm().now(), Duration::ZERO);
    }
}

mod with_faults {
    use super::*;

    /// A packet that changes nothing: it makes a fault strike that waits for one.
    fn idle_button() -> Command {
        button(JointJogAxis::SuctionOff, 100.0).into()
    }

    #[tokio::test]
    async fn a_port_that_is_closed_turns_clients_away_until_it_opens_again() {
        let (listener, address) = listen().await;
        let fault = "close@packet1..+3s".parse().expect("it is a fault");
        let arm = virtual_arm().with_faults(PowerUp::default(), &[fault], 0);
        let mut server = Server::new(arm).on_tcp(listener);
        serve(&mut server, async |mut told: Told| {
            let mut first = connect(&format!("tcp:{address}")).await;
            first.send(idle_button()).expect("it is allowed");
            while first.next_status().await.is_ok() {}
            told.disconnected().await;
            let mut second = connect(&format!("tcp:{address}")).await;
            second.next_status().await.expect_err("it is turned away");
            told.until(|it| matches!(it, ServerEvent::PortClosed(_)))
                .await;
            let over = |it: &ServerEvent| {
                matches!(it, ServerEvent::Struck(struck) if struck.what == What::Over(0))
            };
            told.until(over).await;
            let mut third = connect(&format!("tcp:{address}")).await;
            third.next_status().await.expect("the arm is still there");
        })
        .await;
    }

    #[tokio::test]
    async fn whoever_has_the_serial_port_open_when_it_closes_loses_it() {
        let pty = Pty::open(None).expect("there is one more");
        let path = pty.path().to_str().expect("the name is text").to_owned();
        let fault = "close@packet1..+200ms".parse().expect("it is a fault");
        let arm = virtual_arm().with_faults(PowerUp::default(), &[fault], 0);
        let mut server = Server::new(arm).on_pty(pty);
        serve(&mut server, async |mut told: Told| {
            let mut first = connect(&format!("serial:{path}")).await;
            first.send(idle_button()).expect("it is allowed");
            while first.next_status().await.is_ok() {}
            let moved = told
                .until(|it| matches!(it, ServerEvent::PtyMoved(_)))
                .await;
            let ServerEvent::PtyMoved(path) = moved else {
                panic!("{moved:?}");
            };
            told.until(
                |it| matches!(it, ServerEvent::Struck(struck) if struck.what == What::Over(0)),
            )
            .await;
            let mut second = connect(&format!("serial:{}", path.display())).await;
            second.next_status().await.expect("the arm is still there");
        })
        .await;
    }
}

mod in_time {
    use super::*;

    /// How many statuses an arm has sent by then: the first after 60 ms, then one every 80 ms.
    fn statuses_by(now: Duration) -> u128 {
        (now.as_millis() + 20) / 80
    }

    #[tokio::test(start_paused = true)]
    async fn an_arm_whose_server_was_cancelled_goes_on_where_it_was() {
        let mut server = Server::new(virtual_arm());
        for seconds in [10, 20] {
            let ten = tokio::time::sleep(Duration::from_secs(10));
            serve(&mut server, |_| ten).await;
            // Without a client the arm is looked at once a second: what has passed since then is
            // lost with the server that was cancelled.
            let apart = server.arm().now().abs_diff(Duration::from_secs(seconds));
            assert!(
                apart <= Duration::from_secs(seconds / 10) + ms(50),
                "{apart:?}"
            );
        }
    }

    #[tokio::test(start_paused = true)]
    async fn a_server_that_is_always_late_keeps_the_pace() {
        let mut server = Server::new(virtual_arm());
        serve(&mut server, async |_| {
            for late in [333, 1, 77, 950, 19].into_iter().cycle().take(100) {
                tokio::time::advance(ms(late)).await;
            }
        })
        .await;
        let arm = server.arm();
        let counters = arm.controller().counters();
        assert!(arm.now() > Duration::from_secs(27), "{:?}", arm.now());
        assert_eq!(u128::from(counters.statuses), statuses_by(arm.now()));
        assert_eq!(counters.lost_statuses, 0);
    }

    #[tokio::test]
    async fn a_button_pressed_and_released_over_a_port_moves_the_arm_between() {
        let (mut server, path) = on_pty();
        serve(&mut server, async |_| {
            let mut arm = connect(&format!("serial:{path}")).await;
            let jog = button(JointJogAxis::BasePlus, 100.0);
            for _ in 0..5 {
                arm.send(jog).expect("it is allowed");
            }
            let released = button(JointJogAxis::Released, 0.0);
            let id = arm.send(released).expect("it is allowed");
            arm.completed(id).await.expect("the link is open");
            let status = arm.next_status().await.expect("one comes");
            assert!(status.base_deg > 1.0, "{status:?}");
        })
        .await;
    }
}

/// Reads that many statuses, of which none is damaged; the first bytes may be the end of one.
async fn read_statuses(mut from: impl AsyncReadExt + Unpin, count: usize) -> Vec<Status> {
    let mut decoder = Decoder::statuses(plausible);
    let mut statuses = Vec::new();
    let mut skipped = None;
    while statuses.len() < count {
        // Never more than one packet, so that none comes beyond those asked for.
        let mut some = [0; 42];
        let len = from.read(&mut some).await.expect("the link is open");
        assert!(len > 0, "closed after {statuses:?}");
        let frames: Vec<_> = decoder.feed(&some[..len]).collect();
        statuses.extend(
            frames
                .iter()
                .map(|it| Status::parse(it).expect("it is one")),
        );
        if !frames.is_empty() {
            let now = decoder.counts().skipped_bytes;
            assert_eq!(*skipped.get_or_insert(now), now, "bytes were lost");
            assert!(now < 42, "{now} bytes before the first status");
        }
    }
    statuses
}

/// Nothing here takes nearly as long.
const HANGS: Duration = Duration::from_mins(1);
