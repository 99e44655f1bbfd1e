//! Pauses: in the queue, at targets, by default.

use super::*;

#[tokio::test]
async fn a_full_queue_of_slow_moves_and_long_pauses_is_no_lost_link() {
    let peer = in_process();
    let mut arm = connect(&peer);
    // At half of 0.5 mm/s, 40 mm take 160 s.
    let mut program: Vec<Command> = vec![playback(0.5).into()];
    let modes = [MovingMode::MovL, MovingMode::MovJ, MovingMode::Jump];
    for n in 0..9_u8 {
        let y_mm = if n % 2 == 0 { 20.0 } else { -20.0 };
        program.push(
            MoveTo {
                pause_s: 60.0,
                ..move_to(modes[usize::from(n % 3)], 230.0, y_mm, 0.0)
            }
            .into(),
        );
    }
    let events = run(&mut arm, &program).await;
    assert_eq!(
        completed(&events),
        (0..10).collect::<Vec<_>>(),
        "{events:?}"
    );
    assert_eq!(refusals(&peer), []);
    assert!(
        peer.now() > Duration::from_secs(9 * 60 + 8 * 80),
        "the pauses and the ways were taken: {:?}",
        peer.now()
    );
}

#[tokio::test]
async fn a_program_with_pauses_is_completed_when_its_last_pause_is() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let mut program: Vec<Command> = Vec::new();
    for n in 0..8_u8 {
        let y_mm = if n % 2 == 0 { 10.0 } else { -10.0 };
        program.push(
            MoveTo {
                pause_s: 60.0,
                ..move_to(MovingMode::MovJ, 230.0, y_mm, 0.0)
            }
            .into(),
        );
    }
    run(&mut arm, &program).await;
    let since = peer.now().saturating_sub(Duration::from_mins(8));
    assert!(since < Duration::from_secs(15), "{since:?} of moves");
}

#[tokio::test]
async fn a_default_pause_is_no_arm_that_fell_short() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let slow = Configuration::playback([100.0, 100.0, 100.0, 100.0, 100.0, 100.0], 5.0, 10.0);
    let program = [
        slow.into(),
        move_to(MovingMode::MovL, 230.0, 0.0, 0.0).into(),
        move_to(MovingMode::MovJ, 230.0, 20.0, 0.0).into(),
    ];
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events), [0, 1, 2], "{events:?}");
    assert!(peer.now() > Duration::from_secs(10), "{:?}", peer.now());
}
