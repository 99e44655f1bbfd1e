//! Serial programs at a virtual serial port.

use super::*;

#[tokio::test]
async fn a_serial_program_moves_the_arm_leaves_and_comes_again() {
    let (mut server, path) = on_pty();
    let address = format!("serial:{path}");
    serve(&mut server, async |mut events: ServerEvents| {
        let mut arm = connect(&address).await;
        let status = arm.next_status().await.expect("one comes");
        #[expect(clippy::cast_possible_truncation, reason = "a status is single")]
        let x_mm = POWER_UP_X_MM as f32;
        assert_at(&status, x_mm, 0.0, -17.677_67);
        let id = arm.send(there()).expect("it is allowed");
        arm.completed(id).await.expect("it is within reach");
        drop(arm);
        events.disconnected().await;
        for _ in 0..3 {
            let mut arm = connect(&address).await;
            let status = arm.next_status().await.expect("one comes");
            assert_at(&status, 250.0, 10.0, 0.0);
            drop(arm);
            events.disconnected().await;
        }
    })
    .await;
}

/// A program that sends the arm on its way and reads nothing, until the arm is there.
async fn leave_unread(path: &str, events: &mut ServerEvents) {
    let mut deaf = plain_open(path);
    deaf.write_all(&bytes(there())).expect("it takes them");
    deaf.write_all(&marker()).expect("it takes them");
    events.refusal().await;
}

#[tokio::test]
async fn a_plain_program_gets_nothing_that_was_sent_before_it_came() {
    let (mut server, path) = on_pty();
    serve(&mut server, async |mut events: ServerEvents| {
        leave_unread(&path, &mut events).await;
        events.disconnected().await;
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
    serve(&mut server, async |mut events: ServerEvents| {
        leave_unread(&path, &mut events).await;
        let mut arm = connect(&format!("serial:{path}")).await;
        let status = arm.next_status().await.expect("one comes");
        assert_at(&status, 250.0, 10.0, 0.0);
    })
    .await;
}

#[tokio::test]
async fn bytes_of_a_program_that_writes_and_closes_at_once_arrive() {
    let (mut server, path) = on_pty();
    serve(&mut server, async |mut events: ServerEvents| {
        plain_open(&path)
            .write_all(&marker())
            .expect("it takes them");
        events.until(|it| *it == ServerEvent::PtyOpened).await;
        events.disconnected().await;
        events.refusal().await;
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
    serve(&mut server, async |mut events: ServerEvents| {
        let killed = plain_open(path);
        rustix::termios::ioctl_tiocexcl(&killed).expect("it is a terminal");
        events.until(|it| *it == ServerEvent::PtyOpened).await;
        drop(killed);
        events.disconnected().await;
        let mut arm = connect(&format!("serial:{path}")).await;
        arm.next_status().await.expect("one comes");
    })
    .await;
}
