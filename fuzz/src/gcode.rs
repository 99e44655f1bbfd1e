/// G-code of any kind: an error, or ink within the limits, but never a panic.
pub fn gcode(input: &[u8]) {
    crate::read(&crate::file("gcode", crate::spelled(input, WORDS)));
}

const WORDS: &[&str] = &[
    "G0", "G1", "G2", "G3", "G4", "G20", "G21", "G28", "G53", "G54", "G55", "G90", "G91", "G90.1",
    "G91.1", "G92", "G92.1", "M0", "M2", "M3", "M4", "M5", "M6", "M106", "M117", "M280", "X", "Y",
    "Z", "I", "J", "R", "F", "S", "T", "P", "E", "N", "(", ")", ";", "%", "$", "/", "*", "\n",
    "\r\n", " ", "-", ".", "0", "1", "2", "5", "9", "10", "0.5", "1000000", "X10Y0", "X0Y10",
    "I5J0", "R5", "Z-1", "Z5", "S0", "S255",
];
