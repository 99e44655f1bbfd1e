//! Clients over TCP.

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
    serve(&mut server, async |mut events: ServerEvents| {
        let mut first = connect(&format!("tcp:{address}")).await;
        first.next_status().await.expect("one comes");
        let mut second = TcpStream::connect(address).await.expect("it listens");
        let from = second.local_addr().expect("it is connected");
        assert_eq!(second.read(&mut [0; 42]).await.unwrap_or(0), 0);
        events
            .until(|it| *it == ServerEvent::TcpRefused(from))
            .await;
        first
            .next_status()
            .await
            .expect("the first one is still served");
        drop(first);
        events.disconnected().await;
        let mut third = connect(&format!("tcp:{address}")).await;
        third.next_status().await.expect("one comes");
    })
    .await;
}

#[tokio::test]
async fn a_client_that_leaves_in_the_middle_of_a_packet_harms_nobody() {
    let (mut server, address) = on_tcp().await;
    serve(&mut server, async |mut events: ServerEvents| {
        let mut torn = TcpStream::connect(address).await.expect("it listens");
        torn.write_all(&marker()[..20])
            .await
            .expect("it takes them");
        drop(torn);
        events.disconnected().await;
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
    serve(&mut server, async |mut events: ServerEvents| {
        let mut deaf = TcpStream::connect(address).await.expect("it listens");
        deaf.write_all(&bytes(there()))
            .await
            .expect("it takes them");
        deaf.write_all(&marker()).await.expect("it takes them");
        events.refusal().await;
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
async fn a_client_that_sends_faster_than_the_line_is_reported_once_and_still_served() {
    let (mut server, address) = on_tcp().await;
    serve(&mut server, async |mut events: ServerEvents| {
        let mut flood = TcpStream::connect(address).await.expect("it listens");
        for _ in 0..100 {
            flood.write_all(&[0x55; 1000]).await.expect("it takes them");
        }
        events.until(|it| *it == ServerEvent::Overrun).await;
        let statuses = read_statuses(flood, 3).await;
        assert_eq!(statuses.len(), 3);
        let again = |it: &ServerEvent| *it == ServerEvent::Overrun;
        events
            .until(|it| *it == ServerEvent::Disconnected || again(it))
            .await;
        assert!(!std::iter::from_fn(|| events.0.try_recv().ok()).any(|it| again(&it)));
    })
    .await;
    assert!(server.arm().lost_bytes() > 90_000);
}
