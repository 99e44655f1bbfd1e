//! What the commands that draw nothing are to a drawing.

/// Why a command is left out, where that has to be told; `None` where it makes no difference.
pub(super) const fn left_out(name: [u8; 2]) -> Option<&'static str> {
    match &name {
        // Of the sheet, the pens, the speed of lifting, the shape of letters, questions to the
        // plotter.
        b"AC" | b"AF" | b"AH" | b"AP" | b"AS" | b"BP" | b"CA" | b"CO" | b"CR" | b"CS" | b"CT"
        | b"CC" | b"CM" | b"CV" | b"DC" | b"DI" | b"DP" | b"DR" | b"DS" | b"DT" | b"DV" | b"EC"
        | b"ES" | b"FR" | b"FS" | b"GC" | b"GM" | b"GP" | b"IM" | b"IV" | b"KY" | b"LA" | b"LO"
        | b"MC" | b"MG" | b"MT" | b"NP" | b"NR" | b"OA" | b"OC" | b"OD" | b"OE" | b"OF" | b"OH"
        | b"OI" | b"OK" | b"OL" | b"OO" | b"OP" | b"OS" | b"OT" | b"OW" | b"PC" | b"PP" | b"PS"
        | b"PT" | b"PW" | b"QL" | b"RP" | b"SA" | b"SB" | b"SI" | b"SL" | b"SR" | b"SS" | b"ST"
        | b"SD" | b"AD" | b"TD" | b"TL" | b"TR" | b"UL" | b"WD" | b"WU" | b"MU" | b"VN" => None,
        b"LB" | b"BL" | b"PB" => Some("left out; have text written as lines"),
        b"CP" => Some("left out, for text is left out"),
        b"XT" | b"YT" | b"UC" | b"SM" | b"SV" | b"RF" => Some("left out"),
        _ => Some("not known, left out"),
    }
}
