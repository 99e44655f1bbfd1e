use crossterm::event::{KeyCode, KeyModifiers};
use dobot_api::{ClientId, JobPhase, JobView};
use dobot_safety::Policy;
use dobot_wire::Command;
use ratatui::Terminal;
use ratatui::backend::TestBackend;

use super::*;
use crate::pendant::{Drive, KeyReports};

fn teacher() -> Teacher {
    let dead_man = Duration::from_millis(150);
    let pendant = Pendant::new(ClientId(1), KeyReports::Presses, dead_man, Drive::Jog);
    let settings = Settings {
        tolerance_mm: 0.5,
        rules: Rules::of(&Policy::default()).into(),
        arm_laser: None,
    };
    let mut it = Teacher::new(pendant, Lesson::new("t".into()), "t.toml".into(), settings);
    it.handle_state(State::sample());
    it
}

fn at(x_mm: f32) -> State {
    let mut state = State::sample();
    state.arm.as_mut().unwrap().status.x_mm = x_mm;
    state
}

/// The texts of the steps.
fn lines(it: &Teacher) -> Vec<String> {
    let rows = it.lesson.rows().into_iter().skip(1);
    rows.map(|(_, text)| text).collect()
}

/// All that is asked for after a key.
fn keyed(it: &mut Teacher, code: KeyCode) -> Vec<Request> {
    let key = Event::Key(KeyEvent::new(code, KeyModifiers::NONE));
    it.handle_event(Duration::ZERO, &key);
    asked(it)
}

fn asked(it: &mut Teacher) -> Vec<Request> {
    std::iter::from_fn(|| it.pendant.poll_request(Duration::ZERO)).collect()
}

fn job_view(job: u64, phase: JobPhase) -> JobView {
    let text = format!(
        r#"{{"job": {job}, "title": "t", "kind": "program", "created_ms": 0, "phase": "queued", "reason": null,
        "commands": 1, "completed": 0, "planned_s": null, "left_s": null, "took_s": null,
        "speed_percent": 100.0, "height_mm": 0.0}}"#
    );
    let view: JobView = serde_json::from_str(&text).unwrap();
    JobView { phase, ..view }
}

#[test]
fn a_point_is_taught_once_however_long_enter_is_held() {
    let mut it = teacher();
    for _ in 0..5 {
        keyed(&mut it, KeyCode::Enter);
    }
    assert_eq!(lines(&it).len(), 1);
    it.handle_state(at(230.0));
    keyed(&mut it, KeyCode::Enter);
    assert_eq!(lines(&it).len(), 2);
}

#[test]
fn no_point_is_taught_while_the_arm_moves_or_its_pose_is_not_trusted() {
    let mut it = teacher();
    let mut moving = State::sample();
    moving.arm.as_mut().unwrap().moving = true;
    let mut lost = State::sample();
    lost.trust.trusted = false;
    for state in [moving, lost] {
        it.handle_state(state);
        keyed(&mut it, KeyCode::Enter);
        assert_eq!(it.lesson.text(), "");
    }
}

#[test]
fn the_pump_is_switched_and_taught_with_one_key() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    let asked = keyed(&mut it, KeyCode::Char('j'));
    assert!(matches!(asked[..], [Request::Command { .. }]), "{asked:?}");
    // The state says that the pump ran when the point was taught.
    assert!(lines(&it)[1].contains("suction = false"));
}

#[test]
fn a_jogged_path_becomes_few_steps() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Char('v'));
    for x in 0_u8..40 {
        it.handle_state(at(200.0 + f32::from(x)));
    }
    keyed(&mut it, KeyCode::Char('v'));
    let lines = lines(&it);
    assert_eq!(lines.len(), 2, "{lines:?}");
    assert!(lines[1].contains("239"), "{lines:?}");
}

#[test]
fn a_program_is_submitted_started_paused_and_resumed() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    let submitted = keyed(&mut it, KeyCode::Char('g'));
    assert!(
        matches!(submitted[..], [Request::SubmitJob { .. }]),
        "{submitted:?}"
    );
    it.handle_reply(&Reply::Job {
        job: job_view(4, JobPhase::Queued),
    });
    assert_eq!(asked(&mut it), [], "the pump may still be under way");
    it.handle_state(State::sample());
    let start = Request::StartJob { job: 4 };
    assert_eq!(asked(&mut it), std::slice::from_ref(&start));
    it.handle_refused(&start, Some("still-moving"), "the arm still moves".into());
    it.handle_state(State::sample());
    assert_eq!(asked(&mut it), [start]);
    let mut paused = State::sample();
    paused.job = Some(job_view(4, JobPhase::Paused));
    it.handle_state(paused);
    assert_eq!(
        keyed(&mut it, KeyCode::Char('n')),
        [Request::StepJob { job: 4 }]
    );
    assert_eq!(
        keyed(&mut it, KeyCode::Char('g')),
        [Request::StartJob { job: 4 }]
    );
    keyed(&mut it, KeyCode::Char('t'));
    let again = keyed(&mut it, KeyCode::Char('g'));
    assert!(
        matches!(
            again[..],
            [Request::CancelJob { job: 4 }, Request::SubmitJob { .. }]
        ),
        "it was changed: {again:?}"
    );
}

#[test]
fn what_is_not_saved_is_left_only_with_a_second_q() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    keyed(&mut it, KeyCode::Char('q'));
    assert!(!it.pendant.is_over());
    keyed(&mut it, KeyCode::Char('w'));
    let (file, text) = it.poll_file().unwrap();
    assert_eq!(file, PathBuf::from("t.toml"));
    it.handle_saved(text, Ok(()));
    keyed(&mut it, KeyCode::Char('q'));
    assert!(it.pendant.is_over());
}

#[test]
fn a_stop_goes_out_whatever_is_taught() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    let asked = keyed(&mut it, KeyCode::Char(' '));
    assert!(matches!(asked[..], [Request::Stop { .. }]), "{asked:?}");
}

#[test]
fn a_program_that_burns_runs_only_where_the_goggles_are_on_and_the_laser_is_armed_first() {
    let text = "[[steps]]\ngo = { x = 200, y = 0, z = 0 }\n[[steps]]\nlaser = true\n[[steps]]\nlaser = false\n";
    let mut it = teacher();
    let mut policy = Policy::default();
    policy.laser.standing = true;
    it.settings.rules = Rules::of(&policy).into();
    it.lesson = Lesson::of_text(text).unwrap();
    assert_eq!(keyed(&mut it, KeyCode::Char('g')), []);
    it.settings.arm_laser = Some(Duration::from_secs(60));
    let wanted = keyed(&mut it, KeyCode::Char('g'));
    assert!(
        matches!(
            &wanted[..],
            [Request::ArmLaser { for_s: 60.0 }, Request::SubmitJob { .. }]
        ),
        "{wanted:?}"
    );
}

/// Presses the keys of a text.
fn types(it: &mut Teacher, keys: &str) -> Vec<Request> {
    let mut all = Vec::new();
    for key in keys.chars() {
        let code = match key {
            '\n' => KeyCode::Enter,
            letter => KeyCode::Char(letter),
        };
        all.extend(keyed(it, code));
    }
    all
}

#[test]
fn letters_of_a_name_neither_move_nor_run_anything() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    assert_eq!(types(&mut it, "anglrsxupoc_19"), []);
    assert_eq!(keyed(&mut it, KeyCode::Up), []);
    assert_eq!(types(&mut it, "\n"), []);
    assert!(it.prompt.is_none());
    assert!(lines(&it)[0].contains("go = \"glrsxupoc_19\""));
    // As long as Enter is held, it adds no point.
    it.handle_state(at(230.0));
    let enter = Event::Key(KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
    for at_ms in [600, 700, 800] {
        it.handle_event(Duration::from_millis(at_ms), &enter);
    }
    assert_eq!(lines(&it).len(), 1);
    it.handle_event(Duration::from_secs(1), &enter);
    assert_eq!(lines(&it).len(), 2);
}

#[test]
fn keys_with_control_move_nothing_in_a_question_and_control_c_leaves() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    types(&mut it, "anx");
    let with_control = |it: &mut Teacher, code| {
        let key = Event::Key(KeyEvent::new(code, KeyModifiers::CONTROL));
        it.handle_event(Duration::ZERO, &key);
        asked(it)
    };
    for code in [KeyCode::Char('u'), KeyCode::Char('r'), KeyCode::Left] {
        assert_eq!(with_control(&mut it, code), [], "{code:?}");
    }
    assert_eq!(it.prompt.as_ref().map(Prompt::text), Some("x"));
    with_control(&mut it, KeyCode::Char('c'));
    assert!(it.pendant.is_over());
}

#[test]
fn the_arm_is_stopped_in_every_question_and_nothing_that_was_taught_is_lost() {
    for keys in ["a", "an", "ar1", "at", "atc", "agtray", "agtray\n", "af"] {
        let mut it = teacher();
        keyed(&mut it, KeyCode::Enter);
        types(&mut it, keys);
        let asked = keyed(&mut it, KeyCode::Char(' '));
        assert!(
            matches!(asked[..], [Request::Stop { .. }]),
            "{keys:?}: {asked:?}"
        );
        assert!(it.prompt.is_some(), "{keys:?}");
        let asked = keyed(&mut it, KeyCode::Esc);
        assert!(
            matches!(asked[..], [Request::Stop { .. }]),
            "{keys:?}: {asked:?}"
        );
        assert!(it.prompt.is_none(), "{keys:?}");
        assert_eq!(lines(&it).len(), 1, "{keys:?}");
    }
}

#[test]
fn the_arm_is_jogged_between_the_corners_of_a_grid_but_no_program_runs() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    types(&mut it, "agtray\n");
    let asked = keyed(&mut it, KeyCode::Up);
    assert!(matches!(asked[..], [Request::Jog { .. }]), "{asked:?}");
    assert_eq!(types(&mut it, "glhnqw"), [Request::Release]);
    assert!(!it.pendant.is_over());
    let mut moving = at(210.0);
    moving.arm.as_mut().unwrap().moving = true;
    it.handle_state(moving);
    types(&mut it, "\n");
    assert!(it.prompt.as_ref().unwrap().question().contains("place 1"));
    for (x, y) in [(200.0, 0.0), (230.0, 0.0), (200.0, 30.0)] {
        let mut state = at(x);
        state.arm.as_mut().unwrap().status.y_mm = y;
        it.handle_state(state);
        types(&mut it, "\n\n");
    }
    // The second Enter of the last corner asked for a size.
    types(&mut it, "2x2\n");
    assert!(it.prompt.is_none(), "{:?}", it.prompt);
    assert_eq!(
        lines(&it)[1..],
        ["each = \"tray\"", "  go = \"tray\"", "end of each"]
    );
}

#[test]
fn a_tool_is_set_in_the_program_and_at_the_arm() {
    let mut it = teacher();
    let asked = types(&mut it, "atl38\n");
    assert!(
        matches!(
            asked[..],
            [Request::Command {
                command: Command::Configuration(_)
            }]
        ),
        "{asked:?}"
    );
    assert_eq!(lines(&it), ["tool = \"laser\""]);
}

#[test]
fn a_repeat_is_begun_ended_and_run() {
    let mut it = teacher();
    types(&mut it, "ar2\n");
    types(&mut it, "e");
    assert_eq!(lines(&it).len(), 0, "it has no step yet");
    keyed(&mut it, KeyCode::Tab);
    types(&mut it, "\ne");
    let lines = lines(&it);
    assert_eq!((&*lines[0], &*lines[2]), ("repeat = 2", "end of repeat"));
    assert!(lines[1].contains("go = \"p1\""), "{lines:?}");
    let asked = types(&mut it, "g");
    assert!(
        matches!(asked[..], [Request::SubmitJob { .. }]),
        "{asked:?}"
    );
}

#[test]
fn pasted_text_is_taken_by_a_question_for_text_alone() {
    let mut it = teacher();
    assert!(!it.handle_paste("glue"));
    keyed(&mut it, KeyCode::Enter);
    types(&mut it, "an");
    assert!(it.handle_paste("glue\nq"));
    assert_eq!(asked(&mut it), []);
    types(&mut it, "\n");
    assert!(lines(&it)[0].contains("go = \"glue\""));
}

fn screen(it: &Teacher, width: u16, height: u16) -> String {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal.draw(|frame| it.draw(frame)).unwrap();
    let buffer = terminal.backend().buffer();
    let row = |y| (0..width).map(|x| buffer[(x, y)].symbol()).collect();
    let rows: Vec<String> = (0..height).map(row).collect();
    rows.join("\n")
}

#[test]
fn the_screen_shows_every_key_and_every_question_on_a_usual_terminal() {
    let mut it = teacher();
    keyed(&mut it, KeyCode::Enter);
    for (keys, parts) in [
        (
            "",
            &[
                "add name, repeat, tool, grid, frame, call",
                "end repeat",
                "save, quit",
                "▶   1",
            ][..],
        ),
        (
            "a",
            &["name of the point", "call", "Backspace  back", "STOP"],
        ),
        ("n", &["new name of point p1", "accept", "STOP and leave"]),
        ("tray", &["tray█"]),
        ("\nat", &["suction cup", "laser"]),
        ("l", &["0 to 200 mm (0: teach the wrist)", "accept"]),
        ("<<ag", &["name of the grid", "for example tray"]),
        (
            "from\n",
            &[
                "place 1 of 3",
                "the first cell",
                "x+ x-",
                "touch",
                "STOP and leave",
            ],
        ),
        ("<<<<<<af", &["nothing: teach points in the base frame"]),
    ] {
        for key in keys.chars() {
            let code = match key {
                '\n' => KeyCode::Enter,
                '<' => KeyCode::Backspace,
                letter => KeyCode::Char(letter),
            };
            keyed(&mut it, code);
        }
        let screen = screen(&it, 80, 24);
        for part in parts {
            assert!(
                screen.contains(part),
                "{keys:?}: `{part}` is missing:\n{screen}"
            );
        }
    }
    for width in (1..=120).step_by(17) {
        for height in (1..=40).step_by(3) {
            screen(&it, width, height);
        }
    }
}
