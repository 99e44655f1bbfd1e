//! Files of the vendor's software: samples and deviations.

use dobot_teach::vendor::{
    JogParams, Params, PlaybackParams, VendorPoint, points_of, program_of, read_play,
    read_playback, read_points, write_play, write_points,
};
use dobot_teach::{NoFiles, Program};
use dobot_wire::{Command, Configuration, MovingMode};
use proptest::prelude::*;

const POINTS: &str = include_str!("../data/PlayBackPoints.xml");
const PLAY: &str = include_str!("../data/program.play");

fn points(text: &str) -> (Vec<VendorPoint>, Vec<String>) {
    let read = read_points(text.as_bytes()).unwrap();
    (read.content, read.warnings)
}

#[test]
fn the_samples_are_written_as_they_were_read() {
    let (found, warnings) = points(POINTS);
    assert!(warnings.is_empty(), "{warnings:?}");
    assert_eq!(write_points(&found), POINTS);
    let read = read_play(PLAY.as_bytes()).unwrap();
    assert!(read.warnings.is_empty());
    assert_eq!(write_play(&read.content), PLAY);
    let jog = include_str!("../data/JogParams.json");
    assert_eq!(JogParams::read(jog.as_bytes()).unwrap().write(), jog);
    let playback = include_str!("../data/PlayBackParams.json");
    assert_eq!(
        PlaybackParams::read(playback.as_bytes()).unwrap().write(),
        playback
    );
}

#[test]
fn an_old_file_becomes_a_program_and_its_targets() {
    let program = program_of(&points(POINTS).0);
    let again = Program::from_toml(&program.to_toml()).unwrap();
    assert_eq!(again, program);
    let (back, lost) = points_of(&again, &mut NoFiles).unwrap();
    assert_eq!((write_points(&back).as_str(), lost.len()), (POINTS, 0));
    let compiled = program.compile(&mut NoFiles).unwrap();
    let Command::MoveJoints(second) = compiled.commands[1] else {
        panic!("{compiled:?}")
    };
    assert_eq!(
        (
            second.base_deg,
            second.rear_deg,
            second.fore_deg,
            second.servo_deg
        ),
        (25.3125, 48.7, 52.25, -25.3)
    );
    assert_eq!(
        (second.mode, second.suction, second.pause_s),
        (MovingMode::Jump, true, 0.5)
    );
}

#[test]
fn speeds_become_configuration() {
    let playback = PlaybackParams::read(include_bytes!("../data/PlayBackParams.json")).unwrap();
    let [
        Command::Configuration(Configuration::Playback {
            jump_height_mm,
            joint_speed_deg_s,
            ..
        }),
        Command::PlaybackAdjustment(percents),
    ] = playback.commands()
    else {
        panic!("{playback:?}")
    };
    assert_eq!((jump_height_mm, joint_speed_deg_s), (20.0, 200.0));
    assert_eq!(
        (percents.speed_percent, percents.acceleration_percent),
        (48.0, 38.0)
    );
    let jog = JogParams::read(include_bytes!("../data/JogParams.json")).unwrap();
    assert_eq!(
        jog.command(),
        Configuration::teach([15.0, 50.0, 30.0, 10.0, 40.0, 40.0]).into()
    );
}

#[test]
fn surprises_are_read_with_a_warning_each() {
    let (expected, _) = points(POINTS);
    let other_root = POINTS.replace("playBack", "playback");
    let commas = POINTS.replace("25.3125", "25,3125");
    let missing = POINTS.replacen("        <gripper>0</gripper>\n", "", 1);
    for text in [other_root, commas, missing] {
        let (found, warnings) = points(&text);
        assert_eq!(found, expected);
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        assert!(warnings[0].starts_with("line "), "{warnings:?}");
    }
    let (found, warnings) = points(&POINTS.replace('\n', "\r\n"));
    assert_eq!((found, warnings.len()), (expected.clone(), 0));
    let marked = [b"\xEF\xBB\xBF", POINTS.as_bytes()].concat();
    assert_eq!(read_points(&marked).unwrap().content, expected);
}

#[test]
fn other_encodings_are_read() {
    let (expected, _) = points(POINTS);
    let declared = POINTS.replace("UTF-8", "UTF-16");
    let little: Vec<u8> = declared.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = declared.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let chinese = POINTS.replace("UTF-8", "GBK").into_bytes();
    let comment = [
        &chinese[..chinese.len() - 12],
        b"<!-- \xB5\xE3 -->",
        &chinese[chinese.len() - 12..],
    ]
    .concat();
    for bytes in [
        [&b"\xFF\xFE"[..], &little].concat(),
        [&b"\xFE\xFF"[..], &big].concat(),
        little,
        big,
        comment,
    ] {
        let read = read_points(&bytes).unwrap();
        assert_eq!((read.content, read.warnings.len()), (expected.clone(), 1));
    }
}

#[test]
fn a_bad_file_is_reported_with_its_line_the_found_and_the_allowed_value() {
    let bomb = "<?xml version='1.0'?>\n<!DOCTYPE b [<!ENTITY a \"aa\"><!ENTITY b \"&a;&a;\">]>\n<playBack><point><x>&b;</x></point></playBack>";
    for (text, start, part) in [
        (bomb, "line ", "DTD"),
        ("<points/>", "line 1: ", "<points>"),
        ("<playBack>\n<point>", "line ", "not well-formed XML"),
        ("<playBack/>", "line 1: ", "no points"),
        (
            "<playBack>\n<point><x>1</x><y>2</y></point></playBack>",
            "line 2: ",
            "no <z>",
        ),
        (
            "<playBack><point><x>a</x><y>2</y><z>3</z></point></playBack>",
            "line 1: ",
            "\"a\"",
        ),
        (
            "<playBack><point><x>nan</x><y>2</y><z>3</z></point></playBack>",
            "line 1: ",
            "nan",
        ),
        (
            "<playBack><point><motionStyle>FLY</motionStyle><x>1</x><y>2</y><z>3</z></point></playBack>",
            "line 1: ",
            "JUMP, MOVL and MOVJ",
        ),
    ] {
        let error = read_points(text.as_bytes()).unwrap_err().to_string();
        assert!(error.starts_with(start) && error.contains(part), "{error}");
    }
    for (text, part) in [
        ("", "no points"),
        ("6;;0:Jump;1;2", "5 fields"),
        ("3;;0:Jump;1;2;3;4;NO;0;0;", "state"),
        ("6;;0:Fly;1;2;3;4;NO;0;0;", "0:Fly"),
        ("6;;0:Jump;1;2;3;4;MAYBE;0;0;", "YES and NO"),
        ("6;;0:Jump;1;2;inf;4;NO;0;0;", "\"inf\""),
        ("6;;0:Jump;1;2;3;4;NO;0;900;", "655"),
    ] {
        let error = read_play(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
    let error = PlaybackParams::read(b"{\n\"jumpheight\": 3}")
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("line 2: ") && error.contains("jumpHeight"),
        "{error}"
    );
    assert!(PlaybackParams::read(b"{\"velocityRatio\": 0}").is_err());
}

#[test]
fn content_that_the_other_form_cannot_carry_is_reported() {
    let program = Program::from_toml("start_speed_percent = 20\n[[steps]]\ngo = {x=200,y=0,z=0}\n[[steps]]\ngo={base=0,rear=45,fore=45}\n[[steps]]\nwait = \"?\"").unwrap();
    let (found, lost) = points_of(&program, &mut NoFiles).unwrap();
    assert_eq!((found.len(), lost.len()), (2, 2), "{lost:?}");
}

/// The joint angles of the points of a program.
fn joints_of(text: &str) -> Vec<[f64; 4]> {
    let program = Program::from_toml(text).unwrap();
    let (points, lost) = points_of(&program, &mut NoFiles).unwrap();
    assert_eq!(lost, Vec::<String>::new());
    points.iter().map(|point| point.joints_deg).collect()
}

#[test]
fn positions_become_the_joint_angles_of_the_arm() {
    // Upright rear arm and level forearm: x is 160 mm and the tool's 55.07 mm, z 135 mm.
    let found = joints_of("[[steps]]\ngo = { x = 215.07, y = 0, z = 135, rotation = 20 }\n");
    assert_eq!(found, [[0.0, 0.0, 0.0, 20.0]]);
    // The same with the tip 40 mm below, and turned to the left.
    let tip = "[tools.cup]\nkind = \"suction_cup\"\nlength = 40\n[[steps]]\ntool = \"cup\"\n[[steps]]\ngo = { x = 0, y = 215.07, z = 95 }\n";
    let program = Program::from_toml(tip).unwrap();
    let (points, lost) = points_of(&program, &mut NoFiles).unwrap();
    assert_eq!(points[0].joints_deg, [90.0, 0.0, 0.0, -90.0]);
    assert!(
        lost.len() == 1 && lost[0].starts_with("line 4: the tool"),
        "{lost:?}"
    );
}

#[test]
fn grids_offsets_and_grips_become_points() {
    let text = include_str!("../../../../examples/programs/pick-and-place.toml");
    let program = Program::from_toml(text).unwrap();
    let (points, lost) = points_of(&program, &mut NoFiles).unwrap();
    let compiled = program.compile(&mut NoFiles).unwrap();
    let is_target =
        |command: &&Command| matches!(command, Command::MoveTo(_) | Command::MoveJoints(_));
    assert_eq!(
        points.len(),
        compiled.commands.iter().filter(is_target).count()
    );
    assert_eq!(
        points.iter().filter(|point| point.grab).count(),
        9,
        "nine cubes"
    );
    assert_eq!(lost.len(), 2, "its speeds and the soft start: {lost:?}");
}

#[test]
fn every_position_out_of_reach_is_named_with_its_step_and_line() {
    let text = "[points]\nfar = { x = 400, y = 0, z = 0 }\n[[steps]]\ngo = { x = 200, y = 0, z = 0 }\n[[steps]]\ngo = \"far\"\n[[steps]]\ngo = { x = 200, y = 0, z = 300 }\n";
    let program = Program::from_toml(text).unwrap();
    let error = points_of(&program, &mut NoFiles).unwrap_err().to_string();
    assert!(error.starts_with("line 5: step 2 (go to far): "), "{error}");
    assert!(
        error.contains("line 7: step 3 (go to x 200 y 0 z 300): "),
        "{error}"
    );
}

#[test]
fn a_later_file_becomes_a_program_of_positions() {
    let read = read_playback(PLAYBACK.as_bytes()).unwrap();
    let expected = Program::from_toml(
        "[[steps]]\ngo = { x = 196.4, y = -126.25, z = 73.5, rotation = -5.5 }\npath = \"movj\"\n\
         [[steps]]\ngo = { x = 220, y = 0, z = 20, rotation = 0 }\npath = \"movl\"\nsuction = true\npause = 1.5\n\
         [[steps]]\ngo = { x = 220, y = 60, z = 20, rotation = 0 }\nsuction = false\n",
    )
    .unwrap();
    assert_eq!(read.content.to_toml(), expected.to_toml());
    assert_eq!(read.warnings.len(), 2, "{:?}", read.warnings);
    assert!(
        read.warnings[0].contains("another arm"),
        "{:?}",
        read.warnings
    );
    assert!(read.warnings[1].contains("gripper"), "{:?}", read.warnings);
}

#[test]
fn a_bad_later_file_is_reported_with_its_line() {
    for (from, to, part) in [
        (
            "<item_0>1</item_0>",
            "<item_0>3</item_0>",
            "<item_0> is \"3\"; allowed are 0",
        ),
        ("<item_2>196.4</item_2>", "<item_2/>", "no <item_2>"),
        (
            "<item_12>1</item_12>",
            "<item_12>on</item_12>",
            "0 (off) and 1 (on)",
        ),
    ] {
        let error = read_playback(PLAYBACK.replacen(from, to, 1).as_bytes())
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with("line ") && error.contains(part),
            "{error}"
        );
    }
    let error = read_playback(b"<playBack/>").unwrap_err().to_string();
    assert!(error.contains("<root>"), "{error}");
}

/// As the vendor's later software writes it.
const PLAYBACK: &str = "\
<root>
  <DobotType><item_0>Magician</item_0></DobotType>
  <row_StudioVersion><item_0>Ver-194</item_0></row_StudioVersion>
  <row0>
    <item_0>1</item_0><item_1/>
    <item_2>196.4</item_2><item_3>-126.25</item_3><item_4>73.5</item_4><item_5>-5.5</item_5>
    <item_10>0.0</item_10>
  </row0>
  <row1>
    <item_0>2</item_0><item_1>pick</item_1>
    <item_2>220</item_2><item_3>0</item_3><item_4>20</item_4><item_5>0</item_5>
    <item_10>1.5</item_10><item_12>1</item_12>
  </row1>
  <row2>
    <item_0>0</item_0><item_1>place</item_1>
    <item_2>220</item_2><item_3>60</item_3><item_4>20</item_4><item_5>0</item_5>
    <item_10>0</item_10><item_11>2</item_11><item_12>0</item_12>
  </row2>
</root>
";

#[test]
fn speeds_of_jogs_are_never_read_as_speeds_of_moves() {
    let jog = include_bytes!("../data/JogParams.json");
    assert_eq!(
        Params::read(jog).unwrap(),
        Params::Jog(JogParams::read(jog).unwrap())
    );
    let playback = include_bytes!("../data/PlayBackParams.json");
    let expected = Params::Playback(PlaybackParams::read(playback).unwrap());
    assert_eq!(Params::read(playback).unwrap(), expected);
}

proptest! {
    #[test]
    fn points_are_written_and_read_again_unchanged(
        joints_deg in prop::array::uniform4(-180.0..180.0_f64),
        grab: bool,
        gripper_deg in -90.0..90.0_f64,
        pause_s in 0.0..655.0_f64,
        mode in prop::sample::select(vec![MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ]),
    ) {
        let point = VendorPoint { joints_deg, mode, grab, gripper_deg, pause_s };
        let read = read_points(write_points(&[point]).as_bytes()).unwrap();
        prop_assert_eq!((&read.content[..], read.warnings.len()), (&[point][..], 0));
        let play = read_play(write_play(&[point]).as_bytes()).unwrap().content[0];
        for (found, expected) in play.joints_deg.iter().zip(joints_deg) {
            prop_assert!((found - expected).abs() <= 0.0005 + 1e-9);
        }
        let program = program_of(&[point]);
        prop_assert_eq!(Program::from_toml(&program.to_toml()).unwrap(), program);
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,200}") {
        let _ = read_points(text.as_bytes());
        let _ = read_play(text.as_bytes());
        let _ = read_playback(text.as_bytes());
        let _ = Params::read(text.as_bytes());
        let _ = PlaybackParams::read(text.as_bytes());
        if let Ok(program) = Program::from_toml(&text) {
            let _ = program.compile(&mut NoFiles);
        }
    }
}
