//! Rules for every command: it reads what it has written, and knows where the dialects differ.

use dobot_arm::Tool;
use dobot_wire::{
    Command, Configuration, Dialect, EndEffector, Frame, Gesture, JointJog, JointJogAxis,
    LinearJog, LinearJogAxis, MouseMove, MoveJoints, MoveTo, MovingMode, Packet,
    PlaybackAdjustment, Status, Voice, WriteMode, WriteVector,
};
use proptest::prelude::*;

proptest! {
    #[test]
    fn emits_then_parses_to_itself(command in command(), dialect in dialect()) {
        prop_assert_eq!(Command::parse(&command.emit(&dialect), &dialect), Ok(command));
    }

    #[test]
    fn a_status_emits_then_parses_to_itself(frame in prop::array::uniform10(-1e3_f32..1e3), pump in any::<bool>()) {
        let frame = (1..=10).zip(frame).fold(Frame::ZERO, |frame, (n, value)| frame.with(n, value));
        let frame = frame.with(9, f32::from(pump));
        prop_assert_eq!(Status::parse(&frame).unwrap().emit(), frame);
    }

    #[test]
    fn every_bit_pattern_survives(bits in prop::array::uniform10(any::<u32>())) {
        let frame = (1..=10).zip(bits).fold(Frame::ZERO, |frame, (n, bits)| frame.with(n, f32::from_bits(bits)));
        let back = Frame::from_bytes(&frame.to_bytes()).unwrap();
        prop_assert_eq!(back.floats().map(f32::to_bits), bits);
    }

    #[test]
    fn any_packet_is_read_or_refused_in_one_line(bytes in prop::array::uniform32(any::<u8>()), state in 0_u8..16, dialect in dialect()) {
        let mut packet = [0; 42];
        packet[..32].copy_from_slice(&bytes);
        (packet[0], packet[41]) = (0xA5, 0x5A);
        packet[1..5].copy_from_slice(&f32::from(state).to_le_bytes());
        let packet = Packet::from_bytes(&packet).unwrap();
        if let Err(error) = Command::parse(&packet, &dialect) {
            let text = error.to_string();
            prop_assert!(text.contains(';') && !text.contains('\n') && !text.ends_with('.'), "{}", text);
        }
    }

    #[test]
    fn a_command_with_different_packets_depends_on_the_dialect(command in command()) {
        let [ours, stock] = Dialect::ALL.map(|dialect| command.emit(&dialect));
        prop_assert!(ours == stock || command.dialect_dependent().is_some(), "{:?}", command);
    }

    #[test]
    fn a_command_that_does_not_depend_on_the_dialect_is_read_by_all(command in command()) {
        if command.dialect_dependent().is_none() {
            let packet = command.emit(&Dialect::SPECIFICATION);
            prop_assert_eq!(Command::parse(&packet, &Dialect::FIRMWARE_1_1), Ok(command));
        }
    }
}

#[test]
fn names_the_field_in_which_dialects_differ() {
    let jump = MoveTo::to(200.0, 0.0, 0.0);
    assert_eq!(Command::from(jump).dialect_dependent(), None);
    let line = MoveTo {
        mode: MovingMode::MovL,
        ..jump
    };
    assert_eq!(
        Command::from(line).dialect_dependent(),
        Some("float 8 (MovingMode) of a target")
    );
    let lift = WriteVector::by(0.0, 0.0, 8.0, 50.0);
    assert_eq!(Command::from(lift).dialect_dependent(), None);
    let stroke = WriteVector { x_mm: 5.0, ..lift };
    assert_eq!(
        Command::from(stroke).dialect_dependent(),
        Some("float 3 (X) of a write vector")
    );
    let stop = WriteVector { stop: true, ..lift };
    assert_eq!(
        Command::from(stop).dialect_dependent(),
        Some("float 6 (stop) of a write vector")
    );
    let half = Configuration::InitialAngles {
        rear_deg: 45.0,
        fore_deg: 45.0,
    };
    assert_eq!(Command::from(half).dialect_dependent(), None);
}

#[test]
fn a_message_refuses_the_frame_of_another() {
    let error = MoveTo::parse(&Frame::ZERO.with(1, 6.0), &Dialect::SPECIFICATION).unwrap_err();
    assert_eq!(
        error.to_string(),
        "float 1 (state) is 6; Table 3.7 allows 3"
    );
}

#[test]
fn a_voice_text_fits_the_packet() {
    let error = Voice::new(&"a".repeat(41)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the voice text is 41 bytes long; note N17 allows up to 40"
    );
    let error = Voice::new("up é").unwrap_err();
    assert_eq!(
        error.to_string(),
        "byte 4 of the voice text is 0xc3; note N17 allows printable ASCII"
    );
}

#[test]
fn dialects_have_the_names_that_a_user_types() {
    assert_eq!("specification".parse(), Ok(Dialect::SPECIFICATION));
    assert_eq!("firmware-1.1".parse(), Ok(Dialect::FIRMWARE_1_1));
    assert_eq!(Dialect::FIRMWARE_1_1.to_string(), "firmware-1.1");
    let error = "1.1".parse::<Dialect>().unwrap_err();
    assert_eq!(
        error.to_string(),
        "there is no such dialect; the names are \"specification\" and \"firmware-1.1\""
    );
}

fn dialect() -> impl Strategy<Value = Dialect> {
    prop::sample::select(&Dialect::ALL[..])
}

fn command() -> impl Strategy<Value = Command> {
    prop_oneof![
        (triple(), angle(), any::<bool>()).prop_map(|([y, x, z], rotation_deg, suction)| {
            MouseMove {
                y,
                x,
                z,
                rotation_deg,
                suction,
            }
            .into()
        }),
        (0_usize..15, percent()).prop_map(|(n, speed_percent)| JointJog::new(
            JointJogAxis::ALL[n],
            speed_percent
        )
        .into()),
        (0_usize..15, percent()).prop_map(|(n, speed_percent)| LinearJog::new(
            LinearJogAxis::ALL[n],
            speed_percent
        )
        .into()),
        target(),
        write_vector(),
        "[ -~]{0,40}".prop_map(|text| Voice::new(&text).unwrap().into()),
        (triple(), any::<bool>()).prop_map(|([x, y, z], grab)| Gesture { x, y, z, grab }.into()),
        configuration().prop_map(Command::from),
        (percent(), percent(), percent()).prop_map(
            |(speed_percent, acceleration_percent, teach_speed_percent)| {
                PlaybackAdjustment {
                    speed_percent,
                    acceleration_percent,
                    teach_speed_percent,
                }
                .into()
            }
        ),
    ]
}

fn target() -> impl Strategy<Value = Command> {
    let mode = prop::sample::select(&[MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ][..]);
    let tool = (any::<bool>(), -90.0_f32..=90.0, 0.0_f32..=655.0);
    (any::<bool>(), triple(), angle(), mode, tool).prop_map(
        |(point, [a, b, c], d, mode, (suction, gripper_deg, pause_s))| {
            if point {
                MoveTo {
                    x_mm: a,
                    y_mm: b,
                    z_mm: c,
                    rotation_deg: d,
                    suction,
                    mode,
                    gripper_deg,
                    pause_s,
                }
                .into()
            } else {
                MoveJoints {
                    base_deg: a,
                    rear_deg: b,
                    fore_deg: c,
                    servo_deg: d,
                    suction,
                    mode,
                    gripper_deg,
                    pause_s,
                }
                .into()
            }
        },
    )
}

fn write_vector() -> impl Strategy<Value = Command> {
    let speeds = (0.0_f32..500.0, 0.0_f32..500.0, positive());
    (any::<bool>(), triple(), any::<bool>(), speeds).prop_map(
        |(pen, [x_mm, y_mm, z_mm], laser, (start, end, max))| {
            WriteVector {
                mode: if pen {
                    WriteMode::Writing
                } else {
                    WriteMode::Laser
                },
                x_mm,
                y_mm,
                z_mm: z_mm + 500.5,
                laser,
                start_speed_mm_s: start,
                end_speed_mm_s: end,
                max_speed_mm_s: max,
                stop: false,
            }
            .into()
        },
    )
}

/// The rear angles are multiples of 1/64 degree: 90 minus them is exact in single precision.
fn configuration() -> impl Strategy<Value = Configuration> {
    let tool = prop::sample::select(&Tool::END_EFFECTORS[..]).prop_map(EndEffector::from);
    prop_oneof![
        speeds().prop_map(Configuration::teach),
        (speeds(), prop_oneof![Just(0.0), 0.0_f32..655.0], positive()).prop_map(
            |(speeds, default_pause_s, jump_height_mm)| {
                Configuration::playback(speeds, default_pause_s, jump_height_mm)
            }
        ),
        positive().prop_map(|acceleration_mm_s2| Configuration::Writing { acceleration_mm_s2 }),
        (-320_i16..5440, angle()).prop_map(|(rear, fore_deg)| Configuration::InitialAngles {
            rear_deg: f32::from(rear) / 64.0,
            fore_deg
        }),
        tool.prop_map(|tool| Configuration::EndEffector { tool }),
    ]
}

fn speeds() -> impl Strategy<Value = [f32; 6]> {
    prop::array::uniform6(positive())
}

fn triple() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(prop_oneof![Just(0.0), -500.0_f32..500.0])
}

fn angle() -> impl Strategy<Value = f32> {
    -180.0_f32..180.0
}

fn percent() -> impl Strategy<Value = f32> {
    prop_oneof![1.0_f32..=100.0, Just(50.0)]
}

fn positive() -> impl Strategy<Value = f32> {
    0.001_f32..1000.0
}

#[test]
fn an_end_effector_has_the_value_of_table_3_9() {
    let values = [
        (Tool::SuctionCup, 0.0),
        (Tool::Gripper, 1.0),
        (Tool::Laser, 2.0),
        // Its holder takes the place of the suction cup.
        (Tool::Pen, 0.0),
    ];
    for (tool, value) in values {
        let tool = EndEffector::from(tool);
        let frame = Configuration::EndEffector { tool }.emit(&Dialect::SPECIFICATION);
        assert_eq!(frame.float(3), value, "{tool:?}");
    }
}

#[test]
fn every_tool_is_read_back_as_the_end_effector_that_was_written() {
    for tool in Tool::ALL.map(EndEffector::from) {
        let written = Configuration::EndEffector { tool };
        let frame = written.emit(&Dialect::SPECIFICATION);
        let read = Configuration::parse(&frame, &Dialect::SPECIFICATION);
        assert_eq!(read, Ok(written));
    }
}

#[cfg(feature = "serde")]
#[test]
fn a_pen_in_json_is_the_suction_cup_for_the_arm() {
    let read = |tool: &str| {
        let json = format!(r#"{{"mode": "end_effector", "tool": "{tool}"}}"#);
        serde_json::from_str::<Configuration>(&json)
    };
    assert_eq!(read("pen").unwrap(), read("suction_cup").unwrap());
    assert_ne!(read("laser").unwrap(), read("suction_cup").unwrap());
    let error = read("brush").unwrap_err().to_string();
    assert!(error.contains("`pen`"), "{error}");
}
