//! An arm that is served as fast as it can be calculated.

use super::*;

#[tokio::test]
async fn time_runs_on_from_status_to_status_and_no_answer_comes_too_late() {
    let (server, address) = on_tcp().await;
    let mut server = server.at_speed(Speed::MAX);
    serve(&mut server, async |_| {
        let mut arm = connect(&format!("tcp:{address}")).await;
        let mut last = None;
        for n in 0..20_u8 {
            let side = if n % 2 == 0 { 80.0 } else { -80.0 };
            let there = move_to(MovingMode::MovL, 200.0, side, 0.0);
            last = Some(arm.send(there).expect("it is allowed"));
        }
        let last = last.expect("there are twenty");
        arm.completed(last).await.expect("nothing is lost");
    })
    .await;
    let arm = server.arm();
    assert_eq!(arm.controller().counters().packets, 20);
    // Twenty ways of 160 mm, the first one apart, at 50 mm/s at the most.
    assert!(arm.now() > Duration::from_mins(1), "{:?}", arm.now());
}

#[tokio::test(start_paused = true)]
async fn time_stands_still_without_a_client() {
    let mut server = Server::new(virtual_arm()).at_speed(Speed::MAX);
    serve(&mut server, |_| tokio::time::sleep(Duration::from_secs(10))).await;
    assert_eq!(server.arm().now(), Duration::ZERO);
}
