//! Tests over real pseudo-terminals that pose as ports of USB chips.

#![cfg(unix)]

use std::net::Ipv4Addr;
use std::path::Path;

use dobot_controller::{Controller, PowerUp};
use dobot_session::{NoStatus, OpenError, Usb, plausible};
use dobot_sim::{Fault, Pty, PtyClient, SerialLine, Server, VirtualArm};
use dobot_wire::Decoder;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpListener;
use tokio::task::JoinHandle;

use super::*;

fn pty() -> Pty {
    Pty::open(None).expect("there is one more")
}

fn text(path: &Path) -> String {
    path.to_str().expect("the name is text").to_owned()
}

/// A port that poses as a CH340.
fn port(path: &Path) -> Port {
    Port {
        path: text(path),
        device: Some("USB 1a86:7523".into()),
        usb: Some(Usb {
            vendor: 0x1a86,
            product: 0x7523,
            serial: None,
        }),
    }
}

/// An arm at a virtual serial port.
fn arm(faults: &[&str]) -> (JoinHandle<()>, Port) {
    let faults: Vec<Fault> = faults
        .iter()
        .map(|fault| fault.parse().expect("it is a fault"))
        .collect();
    let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
    let arm = arm.with_faults(PowerUp::default(), &faults, 0);
    let pty = pty();
    let port = port(pty.path());
    let mut server = Server::new(arm).on_pty(pty);
    let serving = tokio::spawn(async move {
        server.run(|_| {}).await.expect("the port holds");
    });
    (serving, port)
}

/// Waits until the port is opened.
async fn opened(pty: &Pty) -> PtyClient {
    loop {
        match pty.client().expect("it is there") {
            Some(client) => return client,
            None => tokio::task::yield_now().await,
        }
    }
}

/// Sends noise to the process that opens the port, until it is closed; returns the bytes received.
fn noisy() -> (JoinHandle<Vec<u8>>, Port) {
    let pty = pty();
    let port = port(pty.path());
    let sending = tokio::spawn(async move {
        let mut client = opened(&pty).await;
        let mut received = Vec::new();
        client.write_all(&[0xA5; 1000]).await.expect("it is open");
        client.read_to_end(&mut received).await.expect("it holds");
        received
    });
    (sending, port)
}

fn finder() -> Finder {
    Finder::new(Search::default())
}

fn listened_to(news: &[FinderNews]) -> Vec<String> {
    let path = |event: &FinderNews| match event {
        FinderNews::Listening { address, .. } => Some(address.to_string()),
        FinderNews::Failed { .. } => None,
    };
    news.iter().filter_map(path).collect()
}

#[tokio::test]
async fn an_arm_is_found_and_its_link_continues_without_loss() {
    let (_arm, port) = arm(&[]);
    let mut finder = finder();
    let mut news = Vec::new();
    let found = finder
        .find_among(std::slice::from_ref(&port), |event| news.push(event))
        .await;
    let Found {
        address,
        mut link,
        mut bytes,
    } = found.expect("it is there");
    assert_eq!(address.to_string(), format!("serial:{}@9600", port.path));
    assert_eq!(listened_to(&news), [address.to_string()]);
    while bytes.len() < 10 * 42 {
        let open = link.receive(std::time::Duration::MAX, &mut bytes).await;
        assert!(open.expect("it holds"));
    }
    let mut decoder = Decoder::statuses(plausible);
    assert!(decoder.feed(&bytes).count() >= 9);
    let skipped = decoder.counts().skipped_bytes;
    assert!(skipped < 42, "{skipped} bytes between the first statuses");
    let place = finder.last().expect("it is remembered");
    assert_eq!(
        (place.path.as_str(), place.baud),
        (port.path.as_str(), 9600)
    );
    assert_eq!(place.usb, port.usb);
}

#[tokio::test]
async fn an_arm_that_is_reset_by_the_opening_and_silent_at_first_is_found() {
    let (_arm, port) = arm(&["reset@open"]);
    let found = finder().find_among(&[port], |_| {}).await;
    let waited = found.expect("it is there").link.now();
    assert!(waited.as_secs() >= 2, "{waited:?}");
}

#[tokio::test(start_paused = true)]
async fn a_silent_port_is_reported_and_nothing_is_written_to_it() {
    let pty = pty();
    let port = port(pty.path());
    let nothing = finder().find_among(&[port], |_| {}).await;
    let nothing = nothing.expect_err("there is no arm");
    assert!(
        matches!(
            nothing.failures[..],
            [(_, ProbeFailure::NoStatus(NoStatus::Nothing))]
        ),
        "{nothing}"
    );
    assert!(
        nothing.hint().contains("the arm is switched on"),
        "{}",
        nothing.hint()
    );
    // A peer that has left would leave bytes to read.
    assert!(pty.client().expect("it is there").is_none());
}

/// In real time: a clock that runs ahead when idle would not wait for bytes in transit.
#[tokio::test]
async fn a_noisy_port_is_reported_and_nothing_is_written_to_it() {
    let (receiving, port) = noisy();
    let nothing = finder().find_among(&[port], |_| {}).await;
    let nothing = nothing.expect_err("no arm is there");
    let [(_, ProbeFailure::NoStatus(NoStatus::Other { bytes }))] = nothing.failures[..] else {
        panic!("{nothing}");
    };
    assert!((1..=1000).contains(&bytes), "{bytes}");
    let written = receiving.await.expect("it runs");
    assert!(written.is_empty(), "{written:?}");
}

#[tokio::test]
async fn a_port_that_disappears_is_reported() {
    let pty = pty();
    let port = port(pty.path());
    let unplugged = tokio::spawn(async move {
        opened(&pty).await;
        drop(pty);
    });
    let nothing = finder().find_among(&[port], |_| {}).await;
    let nothing = nothing.expect_err("it is gone");
    unplugged.await.expect("it runs");
    let [(_, ProbeFailure::Link { .. })] = nothing.failures[..] else {
        panic!("{nothing}");
    };
}

#[tokio::test]
async fn a_port_that_is_missing_or_in_use_is_skipped_with_the_reason() {
    let taken = pty();
    let address = format!("serial:{}", text(taken.path()));
    let address = address.parse().expect("it is an address");
    let _other = Link::open(&address).await.expect("it is free");
    let (_arm, arm) = arm(&[]);
    let gone = port(Path::new("/dev/no-such-port"));
    let mut news = Vec::new();
    let ports = [gone, port(taken.path()), arm.clone()];
    let found = finder().find_among(&ports, |event| news.push(event)).await;
    let found = found.expect("the third one is an arm");
    assert_eq!(
        found.address.to_string(),
        format!("serial:{}@9600", arm.path)
    );
    let failures: Vec<_> = news
        .iter()
        .filter_map(|event| match event {
            FinderNews::Failed { why, hint, .. } => Some((why.as_str(), hint.clone())),
            FinderNews::Listening { .. } => None,
        })
        .collect();
    let [(no_port, Some(_)), (in_use, Some(hint))] = &failures[..] else {
        panic!("{failures:?}");
    };
    assert!(no_port.contains("there is no serial port"), "{no_port}");
    assert!(in_use.contains("in use"), "{in_use}");
    assert!(hint.contains("fuser"), "{hint}");
}

#[tokio::test(start_paused = true)]
async fn a_port_that_was_found_silent_is_not_opened_again_for_a_minute() {
    let pty = pty();
    let ports = [port(pty.path())];
    let mut finder = finder();
    let mut news = Vec::new();
    for _ in 0..3 {
        let nothing = finder.find_among(&ports, |event| news.push(event)).await;
        nothing.expect_err("there is no arm");
    }
    assert_eq!(listened_to(&news).len(), 1);
    let nothing = finder.find_among(&ports, |_| {}).await;
    let nothing = nothing.expect_err("there is no arm").to_string();
    assert!(nothing.contains("nothing was received"), "{nothing}");
    tokio::time::advance(std::time::Duration::from_mins(1)).await;
    let nothing = finder.find_among(&ports, |event| news.push(event)).await;
    nothing.expect_err("there is no arm");
    assert_eq!(listened_to(&news).len(), 2);
}

#[tokio::test]
async fn an_unplugged_arm_is_found_again_before_other_ports_are_touched() {
    let (first_arm, port_of_arm) = arm(&[]);
    let mut finder = finder();
    let found = finder.find_among(&[port_of_arm], |_| {}).await;
    drop(found.expect("it is there"));
    first_arm.abort();
    // It reappears under another name, among others of its kind that have serial numbers.
    let (_arm, back) = arm(&[]);
    let silent = pty();
    let mut other = port(silent.path());
    if let Some(usb) = &mut other.usb {
        usb.serial = Some("1".into());
    }
    let mut news = Vec::new();
    let ports = [other, back.clone()];
    let found = finder.find_among(&ports, |event| news.push(event)).await;
    found.expect("it is there");
    assert_eq!(listened_to(&news), [format!("serial:{}@9600", back.path)]);
}

#[tokio::test]
async fn an_address_on_the_network_is_listened_to_like_a_port() {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).await;
    let listener = listener.expect("a port is free");
    let address = listener.local_addr().expect("it is bound");
    let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
    let mut server = Server::new(arm).on_tcp(listener);
    tokio::spawn(async move { server.run(|_| {}).await });
    let mut finder = Finder::new(Search {
        named: vec![format!("tcp:{address}").parse().expect("it is one")],
        ..Search::default()
    });
    let found = finder.find_among(&[], |_| {}).await.expect("it is there");
    assert_eq!(found.address.to_string(), format!("tcp:{address}"));
    assert_eq!(finder.last(), None);
}

#[tokio::test]
async fn a_named_address_without_a_listener_is_reported_with_its_reason() {
    let mut finder = Finder::new(Search {
        named: vec!["serial:/dev/no-such-port".parse().expect("it is one")],
        ..Search::default()
    });
    let nothing = finder.find(|_| {}).await.expect_err("there is no arm");
    let [(_, ProbeFailure::Open(OpenError::NoSuchPort { .. }))] = &nothing.failures[..] else {
        panic!("{nothing}");
    };
}
