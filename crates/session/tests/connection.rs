//! The shell over an in-memory stream, on tokio's paused clock.

use std::time::Duration;

use dobot_session::{Address, Connection, LinkError, OpenError};
use dobot_wire::{JointJog, JointJogAxis, Status};
use tokio::io::{AsyncReadExt, AsyncWriteExt, duplex};
use tokio::net::{TcpListener, TcpStream};

/// Rear arm upright, forearm level.
const STATUS: Status = Status::AT_ZERO;

const LASER_OFF: JointJog = JointJog::new(JointJogAxis::LaserOff, 0.0);

#[tokio::test(start_paused = true)]
async fn a_command_leaves_with_the_first_status() {
    let (ours, mut theirs) = duplex(1024);
    let mut arm = Connection::over_stream(ours, None);
    arm.send(LASER_OFF).expect("it is allowed");
    let bytes = STATUS.emit().to_bytes();
    theirs.write_all(&bytes).await.expect("it is open");
    assert_eq!(arm.next_status().await.expect("it was sent"), STATUS);
    let waiting = tokio::spawn(async move { arm.next_status().await });
    let mut packet = [0; 42];
    theirs.read_exact(&mut packet).await.expect("it is open");
    assert_eq!(
        packet[..5],
        [0xA5, 0, 0, 0, 0x40],
        "state 2.0, little-endian"
    );
    waiting.abort();
}

#[tokio::test(start_paused = true)]
async fn a_peer_that_closes_in_the_middle_of_a_status_is_reported() {
    let (ours, mut theirs) = duplex(1024);
    let mut arm = Connection::over_stream(ours, None);
    let bytes = STATUS.emit().to_bytes();
    theirs.write_all(&bytes[..20]).await.expect("it is open");
    drop(theirs);
    let error = arm.next_status().await.expect_err("there is none");
    assert!(matches!(error, LinkError::Closed), "{error}");
}

#[tokio::test]
async fn a_peer_that_closes_without_having_read_everything_has_closed_too() {
    let listener = TcpListener::bind("127.0.0.1:0").await.expect("one is free");
    let address = listener.local_addr().expect("it is bound");
    let ours = TcpStream::connect(address).await.expect("it listens");
    let (mut theirs, _) = listener.accept().await.expect("a client has connected");
    let mut arm = Connection::over_stream(ours, None);
    arm.send(LASER_OFF).expect("it is allowed");
    let bytes = STATUS.emit().to_bytes();
    theirs.write_all(&bytes).await.expect("it is open");
    arm.next_status().await.expect("it was sent");
    let waiting = tokio::spawn(async move { arm.next_status().await });
    theirs.peek(&mut [0]).await.expect("laser off comes");
    drop(theirs);
    let answer = waiting.await.expect("it ends");
    let error = answer.expect_err("there is none");
    assert!(matches!(error, LinkError::Closed), "{error}");
}

#[tokio::test(start_paused = true)]
async fn a_peer_that_sends_noise_is_distinguished_from_a_silent_one() {
    let (ours, mut theirs) = duplex(1024);
    let mut arm = Connection::over_stream(ours, None);
    theirs.write_all(&[0x55; 500]).await.expect("it is open");
    let error = arm.next_status().await.expect_err("there is none");
    assert_eq!(
        error.to_string(),
        "the arm has sent no valid status for 5.0 s: 500 bytes were received, but no valid status; they begin with \"UUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUUU\""
    );
}

#[tokio::test(start_paused = true)]
async fn an_arm_that_falls_silent_is_noticed_after_a_second() {
    let (ours, mut theirs) = duplex(1024);
    let mut arm = Connection::over_stream(ours, None);
    let bytes = STATUS.emit().to_bytes();
    theirs.write_all(&bytes).await.expect("it is open");
    arm.next_status().await.expect("it was sent");
    let error = arm.next_status().await.expect_err("there is no other");
    assert_eq!(
        error.to_string(),
        "the arm has sent no valid status for 1.0 s: nothing was received"
    );
}

#[tokio::test(start_paused = true)]
async fn a_cancelled_wait_loses_no_byte() {
    let (ours, mut theirs) = duplex(1024);
    let mut arm = Connection::over_stream(ours, None);
    let bytes = STATUS.emit().to_bytes();
    for half in [&bytes[..17], &bytes[17..]] {
        theirs.write_all(half).await.expect("it is open");
        let wait = tokio::time::timeout(Duration::from_millis(1), arm.next_status());
        if let Ok(status) = wait.await {
            assert_eq!(status.expect("it was sent"), STATUS);
            return;
        }
    }
    panic!("the status was lost");
}

#[tokio::test]
async fn a_port_that_does_not_exist_is_named_with_a_hint() {
    let address: Address = "serial:/dev/there-is-no-such-port"
        .parse()
        .expect("it is one");
    let error = Connection::open(&address, None)
        .await
        .expect_err("there is none");
    assert!(matches!(error, OpenError::NoSuchPort { .. }), "{error}");
    assert!(
        error
            .hint()
            .expect("something can be done")
            .contains("dobot ports")
    );
}

#[cfg(unix)]
#[tokio::test]
async fn a_file_that_is_not_a_port_is_reported() {
    let address: Address = "serial:/dev/null".parse().expect("it is one");
    let error = Connection::open(&address, None)
        .await
        .expect_err("it is none");
    assert!(matches!(error, OpenError::NotASerialPort { .. }), "{error}");
}

#[tokio::test]
async fn a_tcp_port_without_a_listener_is_reported() {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let port = listener.local_addr().expect("it is bound").port();
    drop(listener);
    let address = Address::Tcp {
        host: "127.0.0.1".into(),
        port,
    };
    let error = Connection::open(&address, None)
        .await
        .expect_err("nobody listens");
    assert!(
        error
            .hint()
            .expect("something can be done")
            .contains("dobot arm"),
        "{error}"
    );
}
