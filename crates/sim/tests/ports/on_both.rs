//! One arm at a virtual serial port and on TCP.

use super::*;

async fn on_both() -> (Server, SocketAddr, String) {
    let (server, path) = on_pty();
    let (listener, address) = listen().await;
    (server.on_tcp(listener), address, path)
}

#[tokio::test]
async fn who_has_the_serial_port_open_has_the_arm() {
    let (mut server, address, path) = on_both().await;
    serve(&mut server, async |mut events: ServerEvents| {
        let mut first = connect(&format!("serial:{path}")).await;
        first.next_status().await.expect("one comes");
        let mut second = TcpStream::connect(address).await.expect("it listens");
        assert_eq!(second.read(&mut [0; 42]).await.unwrap_or(0), 0);
        first.next_status().await.expect("it is still served");
        drop(first);
        events.disconnected().await;
        let mut third = connect(&format!("tcp:{address}")).await;
        third.next_status().await.expect("one comes");
    })
    .await;
}

#[tokio::test]
async fn who_opens_the_serial_port_during_a_tcp_connection_gets_the_arm_after_it() {
    let (mut server, address, path) = on_both().await;
    serve(&mut server, async |mut events: ServerEvents| {
        let mut first = connect(&format!("tcp:{address}")).await;
        first.next_status().await.expect("one comes");
        let mut second = plain_open(&path);
        second.write_all(&marker()).expect("it takes them");
        for _ in 0..5 {
            first.next_status().await.expect("it is still served");
        }
        drop(first);
        events.until(|it| *it == ServerEvent::PtyOpened).await;
        let statuses = read_statuses(tokio::fs::File::from_std(second), 2).await;
        assert_eq!(statuses.len(), 2);
    })
    .await;
    let counters = server.arm().controller().counters();
    assert_eq!(counters.packets, 0, "only who has the arm is heard");
}
