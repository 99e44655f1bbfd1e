use dobot_teach::vendor::{
    JogParams, Params, PlaybackParams, VendorPoint, points_of, program_of, read_play,
    read_playback, read_points, write_play, write_points,
};
use dobot_teach::{NoFiles, Program};

/// Files of the vendor's programs as they may be found: an error, or points that are written and read again unchanged.
pub fn vendor_files(input: &[u8]) {
    let bytes = crate::spelled(input, WORDS);
    if let Ok(read) = read_points(&bytes) {
        let again = read_points(write_points(&read.content).as_bytes());
        let again = again.expect("what was written can be read");
        assert_eq!(
            (again.content, again.warnings.len()),
            (read.content.clone(), 0)
        );
        let back = points_of(&program_of(&read.content), &mut NoFiles);
        let (points, lost) = back.expect("joint angles can be written");
        assert!(
            are_near(&points, &read.content) && lost.is_empty(),
            "{points:?}"
        );
    }
    if let Ok(read) = read_play(&bytes) {
        let text = write_play(&read.content);
        let again = read_play(text.as_bytes()).expect("what was written can be read");
        // It carries thousandths of a degree: those are kept from then on.
        assert_eq!(write_play(&again.content), text);
    }
    if let Ok(read) = read_playback(&bytes) {
        assert_eq!(
            Program::from_toml(&read.content.to_toml()),
            Ok(read.content)
        );
    }
    let _ = Params::read(&bytes);
    if let Ok(params) = JogParams::read(&bytes) {
        assert_eq!(JogParams::read(params.write().as_bytes()), Ok(params));
    }
    if let Ok(params) = PlaybackParams::read(&bytes) {
        assert_eq!(PlaybackParams::read(params.write().as_bytes()), Ok(params));
    }
}

/// Whether points are the same within single precision.
fn are_near(found: &[VendorPoint], expected: &[VendorPoint]) -> bool {
    let numbers = |point: &VendorPoint| {
        let [base, rear, fore, servo] = point.joints_deg;
        [base, rear, fore, servo, point.gripper_deg, point.pause_s]
    };
    let is_near = |(one, other): (&VendorPoint, &VendorPoint)| {
        let pairs = numbers(one).into_iter().zip(numbers(other));
        let mut differences = pairs.map(|(one, other)| (one - other).abs() - other.abs() * 1e-6);
        differences.all(|beyond| beyond <= 1e-4) && (one.mode, one.grab) == (other.mode, other.grab)
    };
    found.len() == expected.len() && found.iter().zip(expected).all(is_near)
}

const WORDS: &[&str] = &[
    "<?xml version='1.0' encoding='UTF-8'?>\n",
    "<playBack>",
    "</playBack>",
    "<playback>",
    "</playback>",
    "<point>",
    "</point>",
    "<motionStyle>JUMP</motionStyle>",
    "<motionStyle>movl</motionStyle>",
    "<isGrab>true</isGrab>",
    "<x>25,3125</x>",
    "<x>1</x><y>45</y><z>45</z>",
    "<rHead>-5.5</rHead>",
    "<gripper>45</gripper>",
    "<pauseTime>1</pauseTime>",
    "<pauseTime>1e9</pauseTime>",
    "<root>",
    "</root>",
    "<DobotType><item_0>Magician</item_0></DobotType>",
    "<row0><item_0>1</item_0><item_2>200</item_2><item_3>0</item_3><item_4>20</item_4>",
    "<item_5>5</item_5><item_10>0.5</item_10>",
    "<item_11>2</item_11>",
    "<item_12>1</item_12>",
    "</row0>",
    "<!DOCTYPE a [<!ENTITY b \"c\">]>",
    "&b;",
    "<!-- -->",
    "6;;0:Jump;31.800;36.686;18.769;0.000;NO;0;0;\n",
    "6;;1:Movj;",
    "1,5;",
    "YES;",
    "-0.0004;",
    "{",
    "\"jointVelocity\": 15",
    "\"velocityRatio\": 48.5",
    "\"jumpHeight\": 20",
    "}",
    ",",
    "nan",
    "\u{feff}",
    "\n",
    ";",
    "0",
];
