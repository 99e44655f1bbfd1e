//! Commands that draw nothing.

/// The warning for a command that is left out; `None` if it has no effect.
pub(super) const fn left_out(name: [u8; 2]) -> Option<&'static str> {
    match &name {
        // Commands about the sheet, the pens, the lifting speed, the fonts, and queries.
        b"AC" | b"AF" | b"AH" | b"AP" | b"AS" | b"BP" | b"CO" | b"CR" | b"CC" | b"CM" | b"CV"
        | b"DC" | b"DP" | b"DS" | b"DT" | b"EC" | b"FR" | b"FS" | b"GC" | b"GM" | b"GP" | b"IM"
        | b"IV" | b"KY" | b"LA" | b"MC" | b"MG" | b"MT" | b"NP" | b"NR" | b"OA" | b"OC" | b"OD"
        | b"OE" | b"OF" | b"OH" | b"OI" | b"OK" | b"OL" | b"OO" | b"OP" | b"OS" | b"OT" | b"OW"
        | b"PP" | b"PT" | b"PW" | b"QL" | b"RP" | b"SA" | b"SB" | b"SS" | b"ST" | b"TL" | b"TR"
        | b"WD" | b"WU" | b"MU" | b"VN" => None,
        b"XT" | b"YT" | b"UC" | b"SV" | b"RF" => Some("left out"),
        _ => Some("unknown, left out"),
    }
}
