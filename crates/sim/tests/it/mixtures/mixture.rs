//! Random mixtures of whatever can be sent.

use std::time::Duration;

use dobot_controller::Port;
use dobot_wire::{Frame, Packet, Voice};
use proptest::prelude::*;

/// What is sent over a port, and for how long the arm is watched.
#[derive(Clone, Debug)]
pub(crate) struct Mixture {
    pub(crate) port: Port,
    pub(crate) items: Vec<Item>,
}

/// Something that is sent, and the pause behind it.
#[derive(Clone, Debug)]
pub(crate) struct Item {
    pub(crate) what: What,
    pub(crate) pause: Duration,
}

#[derive(Clone, Debug)]
pub(crate) enum What {
    Floats([f32; 10]),
    Text(&'static str),
    Noise(Vec<u8>),
}

impl Mixture {
    /// Each byte with the time at which it arrives, over a line as that of a stock arm.
    pub(crate) fn bytes(&self) -> Vec<(Duration, u8)> {
        let mut at = Duration::from_millis(100);
        let mut bytes = Vec::new();
        for item in &self.items {
            for byte in item.what.bytes() {
                at += BYTE;
                bytes.push((at, byte));
            }
            at += item.pause;
        }
        bytes
    }

    /// All packets that are sent whole.
    pub(crate) fn packets(&self) -> impl Iterator<Item = &[f32; 10]> {
        self.items.iter().filter_map(|item| match &item.what {
            What::Floats(floats) => Some(floats),
            _ => None,
        })
    }

    pub(crate) fn has_noise(&self) -> bool {
        let is_noise = |item: &Item| matches!(item.what, What::Noise(_));
        self.items.iter().any(is_noise)
    }

    pub(crate) fn has_text(&self) -> bool {
        let is_text = |item: &Item| matches!(item.what, What::Text(_));
        self.items.iter().any(is_text)
    }
}

impl What {
    pub(crate) fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Floats(floats) => frame(floats).to_bytes().to_vec(),
            Self::Text(text) => {
                let voice = Voice::new(text).expect("it fits");
                Packet::from(voice).to_bytes().to_vec()
            }
            Self::Noise(bytes) => bytes.clone(),
        }
    }
}

fn frame(floats: &[f32; 10]) -> Frame {
    let floats = floats.iter().zip(1..);
    floats.fold(Frame::ZERO, |frame, (value, n)| frame.with(n, *value))
}

pub(crate) fn mixture() -> impl Strategy<Value = Mixture> {
    prop_oneof![3 => Just(Port::Usb), 1 => Just(Port::Bluetooth)].prop_flat_map(|port| {
        prop::collection::vec(item(port), 1..25).prop_map(move |items| Mixture { port, items })
    })
}

fn item(port: Port) -> impl Strategy<Value = Item> {
    let text = match port {
        Port::Usb => packet().boxed(),
        Port::Bluetooth => {
            let texts = prop::sample::select(&TEXTS[..]);
            texts.prop_map(What::Text).boxed()
        }
    };
    // Without a gap, a status later, and long enough for most motions.
    let pause_ms = prop_oneof![2 => Just(0), 4 => 8..90_u64, 2 => 90..3000_u64];
    let what = prop_oneof![20 => packet(), 3 => text, 1 => noise()];
    (what, pause_ms).prop_map(|(what, pause_ms)| Item {
        what,
        pause: Duration::from_millis(pause_ms),
    })
}

fn noise() -> impl Strategy<Value = What> {
    prop::collection::vec(any::<u8>(), 1..60).prop_map(What::Noise)
}

fn packet() -> impl Strategy<Value = What> {
    prop_oneof![
        8 => jog(),
        8 => target(),
        2 => far_target(),
        8 => vector(),
        3 => mouse(),
        3 => hand(),
        2 => third(),
        3 => configuration(),
        1 => trap(),
    ]
    .prop_map(What::Floats)
}

fn jog() -> impl Strategy<Value = [f32; 10]> {
    let axis = prop_oneof![3 => Just(0_u8), 7 => 1..=14_u8];
    (kind([2.0, 7.0]), axis, 1..=100_u8).prop_map(|(state, axis, percent)| {
        [
            state,
            axis.into(),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            percent.into(),
            0.0,
            0.0,
        ]
    })
}

/// Points in reach, and angles not far from them.
fn target() -> impl Strategy<Value = [f32; 10]> {
    let point = [
        200.0..260.0_f32,
        -80.0..80.0_f32,
        -30.0..70.0_f32,
        -60.0..60.0_f32,
    ];
    let angles = [
        -60.0..60.0_f32,
        20.0..60.0_f32,
        30.0..60.0_f32,
        -60.0..60.0_f32,
    ];
    let place = prop_oneof![
        point.prop_map(|place| (3.0, place)),
        angles.prop_map(|place| (6.0, place)),
    ];
    (place, grab(), 0..3_u8, 0.0..90.0_f32, pause_s()).prop_map(
        |((state, [a, b, c, d]), grab, mode, gripper, pause)| {
            [state, 0.0, a, b, c, d, grab, mode.into(), gripper, pause]
        },
    )
}

fn far_target() -> impl Strategy<Value = [f32; 10]> {
    (
        -400.0..400.0_f32,
        -400.0..400.0_f32,
        -200.0..300.0_f32,
        0..3_u8,
    )
        .prop_map(|(x, y, z, mode)| [3.0, 0.0, x, y, z, 0.0, 0.0, mode.into(), 0.0, 0.0])
}

fn vector() -> impl Strategy<Value = [f32; 10]> {
    let way = [-25.0..25.0_f32, -25.0..25.0_f32, -8.0..8.0_f32];
    let stops = prop_oneof![8 => Just(0.0), 1 => Just(1.0_f32)];
    let speeds = (prop_oneof![Just(0.0), 0.0..40.0_f32], 2.0..60.0_f32);
    (kind([0.0, 1.0]), way, stops, grab(), speeds).prop_map(
        |(mode, [x, y, z], stops, lit, (end, most))| {
            [4.0, mode, x, y, z, stops, lit, 0.0, end, most]
        },
    )
}

fn mouse() -> impl Strategy<Value = [f32; 10]> {
    let by = [-9.0..9.0_f32, -9.0..9.0_f32, -9.0..9.0_f32];
    (by, -110.0..110.0_f32, grab())
        .prop_map(|([a, b, c], servo, grab)| [1.0, 0.0, a, b, c, servo, grab, 0.0, 0.0, 0.0])
}

fn hand() -> impl Strategy<Value = [f32; 10]> {
    let place = [-60.0..60.0_f32, -80.0..80.0_f32, 150.0..300.0_f32];
    (place, grab()).prop_map(|([x, y, z], grab)| [8.0, 0.0, x, y, z, 0.0, grab, 0.0, 0.0, 0.0])
}

fn third() -> impl Strategy<Value = [f32; 10]> {
    [0.0..70.0_f32, 0.0..70.0_f32, -50.0..50.0_f32]
        .prop_map(|[rear, fore, base]| [15.0, 0.0, rear, fore, base, 0.0, 0.0, 0.0, 0.0, 0.0])
}

fn configuration() -> impl Strategy<Value = [f32; 10]> {
    let values = prop::array::uniform7(1.0..200.0_f32);
    let rest =
        |state, mode, [a, b, c, d, e, f, g]: [f32; 7]| [state, mode, a, b, c, d, e, f, 0.0, g];
    prop_oneof![
        2 => values.clone().prop_map(move |it| rest(9.0, 0.0, it)),
        2 => values.prop_map(move |it| rest(9.0, 1.0, it)),
        1 => (10.0..1000.0_f32).prop_map(move |a| rest(9.0, 2.0, [a, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])),
        1 => (30.0..60.0_f32, 30.0..60.0_f32)
            .prop_map(move |(a, b)| rest(9.0, 3.0, [a, b, 0.0, 0.0, 0.0, 0.0, 0.0])),
        2 => (0..4_u8).prop_map(move |a| rest(9.0, 4.0, [a.into(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])),
        2 => (1.0..100.0_f32, 1.0..100.0_f32)
            .prop_map(|(a, b)| [10.0, 0.0, a, b, 50.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
    ]
}

/// What makes a stock arm hang, or lose its pose.
fn trap() -> impl Strategy<Value = [f32; 10]> {
    prop_oneof![
        Just([0.0; 10]),
        Just([5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        Just([3.0, 0.0, 220.0, 0.0, 20.0, 0.0, 0.0, 3.0, 0.0, 0.0]),
        Just([2.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0, 0.0, 0.0]),
        Just([4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 20.0]),
        Just([9.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        prop::array::uniform10(any::<f32>()),
    ]
}

/// Off, on and neither.
fn grab() -> impl Strategy<Value = f32> {
    prop_oneof![3 => Just(0.0), 3 => Just(1.0), 1 => Just(2.5_f32)]
}

fn pause_s() -> impl Strategy<Value = f32> {
    prop_oneof![3 => Just(0.0), 1 => 0.0..0.6_f32]
}

fn kind(all: [f32; 2]) -> impl Strategy<Value = f32> {
    prop::sample::select(all.to_vec())
}

/// How long a byte is on the line (note N26).
pub(crate) const BYTE: Duration = Duration::from_micros(1040);
const TEXTS: [&str; 6] = [
    "ahead ten",
    "left twenty",
    "Down five",
    "catch",
    "release",
    "hello",
];
