//! Faults on the way of a served arm.

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
    serve(&mut server, async |mut events: ServerEvents| {
        let mut first = connect(&format!("tcp:{address}")).await;
        first.send(idle_button()).expect("it is allowed");
        while first.next_status().await.is_ok() {}
        events.disconnected().await;
        let mut second = connect(&format!("tcp:{address}")).await;
        second.next_status().await.expect_err("it is turned away");
        events.until(|it| matches!(it, ServerEvent::PortClosed(_)))
            .await;
        let over = |it: &ServerEvent| {
            matches!(it, ServerEvent::Struck(struck) if struck.what == FaultEffect::Over(0))
        };
        events.until(over).await;
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
    serve(&mut server, async |mut events: ServerEvents| {
        let mut first = connect(&format!("serial:{path}")).await;
        first.send(idle_button()).expect("it is allowed");
        while first.next_status().await.is_ok() {}
        let moved = events
            .until(|it| matches!(it, ServerEvent::PtyMoved(_)))
            .await;
        let ServerEvent::PtyMoved(path) = moved else {
            panic!("{moved:?}");
        };
        events.until(
            |it| matches!(it, ServerEvent::Struck(struck) if struck.what == FaultEffect::Over(0)),
        )
        .await;
        let mut second = connect(&format!("serial:{}", path.display())).await;
        second.next_status().await.expect("the arm is still there");
    })
    .await;
}
