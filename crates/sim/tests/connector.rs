//! A served arm and its clients in the same process, in a time that passes as fast as it can.

mod common;

use std::future::Future;
use std::time::Duration;

use common::{button, move_to, ms, virtual_arm};
use dobot_client::{Connection, plausible};
use dobot_controller::PowerUp;
use dobot_sim::{ConnectError, Connector, Fault, Server, ServerEvent, What};
use dobot_wire::{Command, Decoder, Dialect, JointJogAxis, MovingMode, Status};
use tokio::io::{AsyncReadExt, AsyncWriteExt, DuplexStream};
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};

/// Serves an arm while a test does something with it.
async fn serve<F: Future<Output = ()>>(
    mut server: Server,
    test: impl FnOnce(Connector, UnboundedReceiver<ServerEvent>) -> F,
) -> Server {
    let connector = server.connector();
    let (tell, told) = unbounded_channel();
    tokio::select! {
        ended = server.run(|event| {
            // A test that has seen enough listens no more.
            let _ = tell.send(event);
        }) => panic!("the server ended: {ended:?}"),
        () = test(connector, told) => {}
        () = tokio::time::sleep(HANGS) => panic!("the test hangs"),
    }
    server
}

fn server(faults: &[&str]) -> Server {
    let faults: Vec<Fault> = faults
        .iter()
        .map(|it| it.parse().expect("it is a fault"))
        .collect();
    Server::new(virtual_arm().with_faults(PowerUp::default(), &faults, 0))
}

async fn connect(connector: &Connector) -> Connection {
    let stream = connector.connect().await.expect("the arm is free");
    let mut arm = Connection::over_stream(stream, Some(Dialect::SPECIFICATION));
    arm.session_mut().confirm_pose();
    arm
}

/// Reads a status; none when the stream has ended.
async fn status(stream: &mut DuplexStream) -> Option<Status> {
    let mut decoder = Decoder::statuses(plausible);
    let mut some = [0; 42];
    loop {
        let len = stream.read(&mut some).await.ok().filter(|it| *it > 0)?;
        let frames: Vec<_> = decoder.feed(&some[..len]).collect();
        if let Some(frame) = frames.first() {
            return Some(Status::parse(frame).expect("it is one"));
        }
    }
}

fn idle_button() -> Command {
    button(JointJogAxis::SuctionOff, 100.0).into()
}

#[tokio::test(start_paused = true)]
async fn a_client_moves_the_arm_leaves_and_comes_again() {
    serve(server(&[]), async |connector: Connector, _| {
        let mut arm = connect(&connector).await;
        let there = move_to(MovingMode::MovL, 250.0, 10.0, 0.0);
        let id = arm.send(there).expect("it is allowed");
        arm.completed(id).await.expect("it is within reach");
        drop(arm);
        for _ in 0..10 {
            let mut arm = connect(&connector).await;
            let status = arm.next_status().await.expect("one comes");
            let (found, expected, tolerance) = (status.x_mm, 250.0, 1e-3);
            assert!(
                (found - expected).abs() < tolerance,
                "x is {found}, not {expected}, tolerance {tolerance}"
            );
        }
    })
    .await;
}

#[tokio::test(start_paused = true)]
async fn what_a_client_sent_before_it_left_reaches_the_arm_though_another_comes_at_once() {
    let served = serve(server(&[]), async |connector: Connector, _| {
        let mut stream = connector.connect().await.expect("the arm is free");
        let packet = idle_button().emit(&Dialect::SPECIFICATION).to_bytes();
        stream.write_all(&packet).await.expect("it is open");
        drop(stream);
        let mut next = connector.connect().await.expect("the arm is free again");
        status(&mut next).await.expect("one comes");
    })
    .await;
    assert_eq!(served.arm().controller().counters().packets, 1);
}

#[tokio::test(start_paused = true)]
async fn a_second_client_is_told_that_the_arm_has_one() {
    serve(server(&[]), async |connector: Connector, mut told| {
        let mut first = connector.connect().await.expect("the arm is free");
        let second = connector.clone().connect().await;
        assert_eq!(second.expect_err("one at a time"), ConnectError::InUse);
        status(&mut first)
            .await
            .expect("the first one is still served");
        assert_eq!(told.recv().await, Some(ServerEvent::InProcessConnected));
        let refused = ServerEvent::InProcessRefused(ConnectError::InUse);
        assert_eq!(told.recv().await, Some(refused));
    })
    .await;
}

#[tokio::test(start_paused = true)]
async fn a_closed_port_ends_the_stream_and_refuses_others_until_it_is_open_again() {
    let server = server(&["close@packet1..+3s"]);
    serve(server, async |connector: Connector, mut told| {
        let mut first = connect(&connector).await;
        first.send(idle_button()).expect("it is allowed");
        while first.next_status().await.is_ok() {}
        let refused = connector.connect().await.expect_err("it is closed");
        assert_eq!(refused, ConnectError::PortClosed);
        let over =
            |it: &ServerEvent| matches!(it, ServerEvent::Struck(it) if it.what == What::Over(0));
        while !over(&told.recv().await.expect("the server runs")) {}
        let mut second = connect(&connector).await;
        second.next_status().await.expect("the arm is still there");
    })
    .await;
}

#[tokio::test(start_paused = true)]
async fn an_arm_that_starts_anew_when_its_port_is_opened_is_silent_first() {
    let server = server(&["reset@open"]);
    serve(server, async |connector: Connector, _| {
        for _ in 0..2 {
            let opened = tokio::time::Instant::now();
            let mut stream = connector.connect().await.expect("the arm is free");
            status(&mut stream).await.expect("one comes");
            let deaf = opened.elapsed();
            assert!(deaf >= Duration::from_secs(2), "{deaf:?}");
        }
    })
    .await;
}

#[tokio::test(start_paused = true)]
async fn a_client_that_does_not_read_loses_statuses_and_does_not_stop_the_arm() {
    let served = serve(server(&[]), async |connector: Connector, _| {
        let mut stream = connector.connect().await.expect("the arm is free");
        tokio::time::sleep(Duration::from_mins(1)).await;
        let mut bytes = vec![0; 100_000];
        let mut had = 0;
        while let Ok(Ok(len)) = tokio::time::timeout(ms(1), stream.read(&mut bytes[had..])).await {
            had += len;
        }
        assert!(had <= 4096 + 42, "{had} bytes were kept");
    })
    .await;
    let statuses = served.arm().controller().counters().statuses;
    assert!(statuses > 700, "{statuses} in a minute");
}

#[tokio::test]
async fn an_arm_that_nobody_serves_any_more_says_so() {
    let connector = server(&[]).connector();
    let error = connector.connect().await.expect_err("it is gone");
    assert_eq!(error, ConnectError::Ended);
}

/// Nothing here takes nearly as long, by the clock of the test.
const HANGS: Duration = Duration::from_mins(10);
