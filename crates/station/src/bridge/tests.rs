use dobot_api::Role;
use dobot_host::StationHandle;
use proptest::prelude::*;
use tokio::io::{DuplexStream, duplex, split};
use tokio::task::JoinHandle;

use super::*;
use crate::fake::{FakeDriver, packet};

/// A program, its bridge and the driver at the other end.
struct Bridged {
    program: DuplexStream,
    driver: FakeDriver,
    bridge: JoinHandle<Traffic>,
    handle: StationHandle,
}

/// A program that reads and writes through buffers of this size.
async fn bridged(buffer: usize) -> Bridged {
    let (handle, mut driver) = FakeDriver::new(4);
    let (program, ours) = duplex(buffer);
    let statuses = handle.packets();
    let known = tokio::spawn({
        let handle = handle.clone();
        async move { handle.client("a program", Role::Control).await }
    });
    driver.admit().await;
    let client = known.await.expect("it runs").expect("it is let in");
    let bridge = tokio::spawn(async move {
        let (reader, writer) = split(ours);
        bridge(reader, writer, &client, statuses).await
    });
    Bridged {
        program,
        driver,
        bridge,
        handle,
    }
}

fn refusal() -> Result<(), Refusal> {
    Err(Refusal::LaserDisarmed)
}

#[tokio::test]
async fn packets_reach_the_driver_and_statuses_the_client_byte_for_byte() {
    let mut bridged = bridged(4096).await;
    bridged
        .program
        .write_all(&packet(1))
        .await
        .expect("it is open");
    assert_eq!(bridged.driver.grant().await, packet(1));
    let any_bytes: [u8; 42] = std::array::from_fn(|n| u8::try_from(n * 6).expect("it fits"));
    bridged.driver.send_status(any_bytes);
    let mut got = [0; 42];
    bridged
        .program
        .read_exact(&mut got)
        .await
        .expect("it comes");
    assert_eq!(got, any_bytes);
    drop(bridged.program);
    let traffic = bridged.bridge.await.expect("it runs");
    assert_eq!((traffic.packets, traffic.statuses), (1, 1));
    assert_eq!((traffic.refused, traffic.damaged_bytes), (0, 0));
}

#[tokio::test]
async fn a_raw_client_that_leaves_is_a_client_that_leaves() {
    let mut bridged = bridged(4096).await;
    drop(bridged.program);
    bridged.driver.left().await;
    bridged.bridge.await.expect("it runs");
}

#[tokio::test]
async fn the_bridge_ends_with_the_station() {
    let mut bridged = bridged(4096).await;
    drop(bridged.driver);
    bridged
        .program
        .write_all(&packet(1))
        .await
        .expect("it is open");
    bridged.bridge.await.expect("it runs");
    assert_eq!(
        bridged.program.read(&mut [0]).await.expect("it is its end"),
        0
    );
    drop(bridged.handle);
}

#[tokio::test]
async fn statuses_arrive_while_a_packet_waits_for_the_driver() {
    let mut bridged = bridged(4096).await;
    bridged
        .program
        .write_all(&packet(1))
        .await
        .expect("it is open");
    let (_, _, unanswered) = bridged.driver.asked().await;
    bridged.driver.send_status([7; 42]);
    let mut got = [0; 42];
    bridged
        .program
        .read_exact(&mut got)
        .await
        .expect("it comes");
    drop(unanswered);
}

#[tokio::test]
async fn reading_ahead_while_the_driver_has_not_answered_is_bounded() {
    let mut bridged = bridged(420).await;
    let flood = tokio::spawn(async move {
        let mut sent = 0_u64;
        while bridged.program.write_all(&packet(1)).await.is_ok() {
            sent += 1;
        }
        sent
    });
    let (_, _, unanswered) = bridged.driver.asked().await;
    for _ in 0..100_000 {
        tokio::task::yield_now().await;
    }
    assert!(bridged.driver.idle(), "one packet at a time");
    bridged.bridge.abort();
    drop(unanswered);
    // The packets read ahead, at most one read of 4096 bytes, and the contents of the stream.
    let sent = flood.await.expect("it runs");
    assert!(
        sent <= AHEAD as u64 + 4096 / 42 + 11,
        "{sent} packets were taken"
    );
    assert!(sent >= AHEAD as u64, "{sent} packets were taken");
}

#[tokio::test(start_paused = true)]
async fn waiting_packets_of_a_disconnected_client_are_dropped_at_once() {
    let mut bridged = bridged(1 << 20).await;
    for _ in 0..3000 {
        bridged
            .program
            .write_all(&packet(1))
            .await
            .expect("it is open");
    }
    drop(bridged.program);
    let gone = Instant::now();
    let answers = tokio::spawn(async move {
        let mut refused = 0;
        while bridged.driver.answer_unless_left(refusal()).await.is_some() {
            refused += 1;
        }
        refused
    });
    let traffic = bridged.bridge.await.expect("it runs");
    assert!(gone.elapsed().is_zero(), "{:?}", gone.elapsed());
    let refused = answers.await.expect("it runs");
    assert_eq!(traffic.refused, refused);
    assert!((1..30).contains(&refused), "{refused}");
}

#[tokio::test]
async fn packets_sent_before_a_client_left_are_passed_on_if_they_need_not_wait() {
    let mut bridged = bridged(4096).await;
    bridged
        .program
        .write_all(&packet(1))
        .await
        .expect("it is open");
    bridged
        .program
        .write_all(&packet(2))
        .await
        .expect("it is open");
    drop(bridged.program);
    assert_eq!(bridged.driver.grant().await, packet(1));
    assert_eq!(bridged.driver.grant().await, packet(2));
    bridged.driver.left().await;
}

#[tokio::test(start_paused = true)]
async fn refused_packets_are_counted_and_read_no_faster_than_a_line_carries_them() {
    let mut bridged = bridged(4096).await;
    let started = Instant::now();
    let flood =
        tokio::spawn(async move { while bridged.program.write_all(&packet(1)).await.is_ok() {} });
    let mut refused = 0_u32;
    while started.elapsed().as_secs() < 60 {
        bridged.driver.answer(refusal()).await;
        refused += 1;
    }
    // 960 bytes/s are 22.9 packets, and half a second is free.
    assert!((1300..=1390).contains(&refused), "{refused} in a minute");
    bridged.bridge.abort();
    flood.await.expect("it runs");
}

#[tokio::test(start_paused = true)]
async fn a_client_whose_every_packet_is_refused_is_served_at_the_pace_of_statuses() {
    let mut bridged = bridged(4096).await;
    for status in 0..200 {
        let started = Instant::now();
        bridged.driver.send_status([status; 42]);
        let mut got = [0; 42];
        bridged
            .program
            .read_exact(&mut got)
            .await
            .expect("it comes");
        bridged
            .program
            .write_all(&packet(1))
            .await
            .expect("it is open");
        bridged.driver.answer(refusal()).await;
        assert!(started.elapsed().is_zero(), "{:?}", started.elapsed());
        tokio::time::advance(std::time::Duration::from_millis(80)).await;
    }
    drop(bridged.program);
    let traffic = bridged.bridge.await.expect("it runs");
    assert_eq!((traffic.packets, traffic.refused), (200, 200));
}

#[tokio::test(start_paused = true)]
async fn a_client_that_does_not_read_loses_statuses_and_continues_with_the_newest() {
    // The stream holds two statuses, the bridge one, the driver four.
    let mut bridged = bridged(84).await;
    for status in 0..100 {
        bridged.driver.send_status([status; 42]);
        tokio::task::yield_now().await;
    }
    let mut got = Vec::new();
    let mut status = [0; 42];
    let backoff = std::time::Duration::from_secs(1);
    while let Ok(read) =
        tokio::time::timeout(backoff, bridged.program.read_exact(&mut status)).await
    {
        read.expect("it is open");
        assert_eq!(status, [status[0]; 42], "it came whole");
        got.push(status[0]);
    }
    bridged.driver.send_status([200; 42]);
    bridged
        .program
        .read_exact(&mut status)
        .await
        .expect("it comes");
    assert_eq!(status, [200; 42]);
    assert!(got.is_sorted() && got.len() <= 7, "{got:?}");
    drop(bridged.program);
    let traffic = bridged.bridge.await.expect("it runs");
    assert_eq!(traffic.statuses, got.len() as u64 + 1);
    assert_eq!(traffic.statuses + traffic.lost_statuses, 101);
}

#[tokio::test]
async fn a_web_page_is_disconnected_before_any_of_its_packets() {
    let mut bridged = bridged(4096).await;
    let mut request = b"POST / HTTP/1.1\r\nHost: 127.0.0.1:5555\r\n\r\n".to_vec();
    request.extend(packet(1));
    bridged
        .program
        .write_all(&request)
        .await
        .expect("it is open");
    let traffic = bridged.bridge.await.expect("it runs");
    assert!(traffic.web);
    bridged.driver.left().await;
    assert!(bridged.driver.idle());
}

/// Runs bytes through a bridge, cut into pieces, and returns the packets that reach the driver.
fn through(bytes: Vec<u8>, cut: usize) -> (Vec<[u8; 42]>, Traffic) {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_time()
        .start_paused(true)
        .build()
        .expect("there is memory");
    runtime.block_on(async {
        let mut bridged = bridged(4096).await;
        let sending = tokio::spawn(async move {
            for piece in bytes.chunks(cut) {
                bridged.program.write_all(piece).await.expect("it is open");
            }
        });
        let mut packets = Vec::new();
        while let Some(packet) = bridged.driver.answer_unless_left(Ok(())).await {
            packets.push(packet);
        }
        sending.await.expect("it runs");
        (packets, bridged.bridge.await.expect("it runs"))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn packets_are_found_after_any_noise_and_every_byte_is_counted(
        noise in proptest::collection::vec(any::<u8>(), 0..3000),
        cut in 1_usize..500,
    ) {
        // A first byte that no web request has.
        let mut bytes = vec![0];
        bytes.extend(noise);
        // A packet's length of zeros ends any false start in the noise.
        bytes.extend([0; 42]);
        let len = bytes.len() as u64;
        bytes.extend(packet(1));
        bytes.extend(packet(2));
        let (packets, traffic) = through(bytes, cut);
        prop_assert!(packets.ends_with(&[packet(1), packet(2)]));
        let of_packets = 42 * traffic.packets;
        prop_assert_eq!(of_packets + traffic.damaged_bytes, len + 84);
    }
}
