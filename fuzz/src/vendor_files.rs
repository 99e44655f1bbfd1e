use dobot_teach::vendor::{
    JogParams, PlaybackParams, points_of, program_of, read_play, read_points, write_play,
    write_points,
};

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
        let (points, lost) = points_of(&program_of(&read.content));
        assert_eq!((points, lost.len()), (read.content, 0));
    }
    if let Ok(read) = read_play(&bytes) {
        let text = write_play(&read.content);
        let again = read_play(text.as_bytes()).expect("what was written can be read");
        // It carries thousandths of a degree: those are kept from then on.
        assert_eq!(write_play(&again.content), text);
    }
    if let Ok(params) = JogParams::read(&bytes) {
        assert_eq!(JogParams::read(params.write().as_bytes()), Ok(params));
    }
    if let Ok(params) = PlaybackParams::read(&bytes) {
        assert_eq!(PlaybackParams::read(params.write().as_bytes()), Ok(params));
    }
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
