//! The time of a served arm.

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
