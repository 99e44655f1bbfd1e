use std::net::Ipv4Addr;

use tokio::io::AsyncReadExt;

use super::*;
use crate::fake::{Harness, packet};

impl Harness<SocketAddr> {
    async fn served() -> Self {
        let any = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
        let port = RawPort::bind(any).await.expect("a port is free");
        let (harness, handle, report) = Self::new(port.address());
        tokio::spawn(async move { port.serve(&handle, report).await });
        harness
    }

    /// Connects without being admitted.
    async fn come(&self) -> TcpStream {
        TcpStream::connect(self.at).await.expect("it listens")
    }

    /// Connects and is admitted.
    async fn program(&mut self) -> TcpStream {
        let program = self.come().await;
        let from = program.local_addr().expect("it is connected");
        assert_eq!(
            self.admit().await,
            format!("a program on this computer (port {})", from.port())
        );
        program
    }
}

/// Lets all pending tasks run.
async fn settle() {
    for _ in 0..1000 {
        tokio::task::yield_now().await;
    }
}

async fn assert_served(harness: &mut Harness<SocketAddr>, program: &mut TcpStream) {
    program.write_all(&packet(50)).await.expect("it is open");
    assert_eq!(harness.driver.grant().await, packet(50));
    harness.driver.send_status([9; 42]);
    let mut status = [0; 42];
    program.read_exact(&mut status).await.expect("one comes");
    assert_eq!(status, [9; 42]);
}

/// Returns what it receives before the connection is closed.
async fn read_to_end(program: &mut TcpStream) -> String {
    let mut text = String::new();
    program.read_to_string(&mut text).await.expect("it is text");
    text
}

#[tokio::test]
async fn an_old_program_is_a_client_that_may_control_the_arm() {
    let mut harness = Harness::served().await;
    let mut program = harness.program().await;
    assert_served(&mut harness, &mut program).await;
}

#[tokio::test]
async fn raw_clients_connect_and_leave_one_after_another() {
    let mut harness = Harness::served().await;
    for _ in 0..5 {
        let mut program = harness.program().await;
        assert_served(&mut harness, &mut program).await;
        drop(program);
        let traffic = harness.left().await;
        assert_eq!((traffic.packets, traffic.statuses), (1, 1));
    }
}

#[tokio::test]
async fn a_second_raw_client_is_refused_with_the_reason_and_the_first_is_still_served() {
    let mut harness = Harness::served().await;
    let mut first = harness.program().await;
    let mut second = harness.come().await;
    // Data that it sends immediately do not hide the reason from it.
    second.write_all(&packet(50)).await.expect("it is open");
    let reason = read_to_end(&mut second).await;
    let [first_name, second_name] = [&first, &second].map(|socket| {
        let from = socket.local_addr().expect("it is connected");
        format!("a program on this computer (port {})", from.port())
    });
    assert!(reason.contains(&first_name), "{reason}");
    assert!(reason.is_ascii() && reason.ends_with("\r\n"), "{reason}");
    let turned_away = ProgramNews::TurnedAway {
        name: second_name,
        by: first_name,
    };
    assert_eq!(harness.news().await, turned_away);
    assert_served(&mut harness, &mut first).await;
}

#[tokio::test(start_paused = true)]
async fn a_raw_client_that_restarts_at_once_is_served_even_if_its_last_end_was_not_noticed() {
    let mut harness = Harness::served().await;
    let mut first = harness.program().await;
    first.write_all(&packet(50)).await.expect("it is open");
    // Nothing more is read from the first program, and so not its end, until this is answered.
    let (_, _, answer) = harness.driver.asked().await;
    drop(first);
    let mut second = harness.come().await;
    // The port has accepted the second program by then, and waits.
    settle().await;
    tokio::time::advance(Duration::from_millis(400)).await;
    settle().await;
    answer.send(Ok(())).expect("it waits");
    let news = harness.news().await;
    assert!(matches!(news, ProgramNews::Left { .. }), "{news:?}");
    harness.driver.left().await;
    harness.admit().await;
    assert_served(&mut harness, &mut second).await;
}

#[tokio::test]
async fn a_raw_client_that_disconnects_in_the_middle_of_a_packet_does_no_harm() {
    let mut harness = Harness::served().await;
    let mut torn = harness.program().await;
    torn.write_all(&packet(50)[..20]).await.expect("it is open");
    drop(torn);
    let traffic = harness.left().await;
    assert_eq!((traffic.packets, traffic.damaged_bytes), (0, 20));
    let mut next = harness.program().await;
    assert_served(&mut harness, &mut next).await;
}

#[tokio::test]
async fn a_web_page_gets_nothing_and_moves_nothing() {
    let mut harness = Harness::served().await;
    let mut page = harness.program().await;
    let mut request = b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n".to_vec();
    request.extend(packet(50));
    page.write_all(&request).await.expect("it is open");
    assert!(harness.left().await.web, "it was cut off");
}

#[tokio::test]
async fn the_port_is_for_this_machine_alone() {
    for outside in ["0.0.0.0:5555", "192.168.1.2:5555", "[::]:5555"] {
        let address = outside.parse().expect("it is an address");
        let error = RawPort::bind(address).await.expect_err("it is not allowed");
        assert!(error.to_string().contains("127.0.0.1"), "{error}");
    }
}

#[tokio::test]
async fn a_port_in_use_by_another_program_is_reported_as_in_use() {
    let harness = Harness::served().await;
    let error = RawPort::bind(harness.at).await.expect_err("it is taken");
    assert!(matches!(error, RawPortError::InUse { .. }), "{error}");
}

#[tokio::test]
async fn the_port_closes_with_the_station() {
    let mut harness = Harness::served().await;
    let mut program = harness.program().await;
    drop(harness.driver);
    program.write_all(&packet(50)).await.expect("it is open");
    assert_eq!(read_to_end(&mut program).await, "");
    // The callback is dropped with the server.
    while harness.events.recv().await.is_some() {}
}
