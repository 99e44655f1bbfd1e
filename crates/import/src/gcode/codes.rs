//! The meaning of G and M codes for a drawing.

use super::outputs::is_output;

/// The meaning of a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// Executed, or without effect on a drawing.
    Plain,
    /// Unsupported: without it something else would be drawn; the text gives the reason.
    Refused(&'static str),
    /// Left out with this warning.
    LeftOut(&'static str),
}

/// The meaning of a G code in tenths.
pub(super) fn g(code: u32) -> Meaning {
    use Meaning::{LeftOut, Plain, Refused};
    match code {
        530..=599 => Plain,
        50..=52 => Refused("splines are not supported; export lines or arcs"),
        70 => Refused("lathe diameters are not supported"),
        100 => Refused("offsets set by the program are not supported; export without them"),
        120 | 130 => Refused("pockets are not supported; export lines or arcs"),
        160 => Refused("polar coordinates are not supported; export X and Y"),
        310 | 380..=389 => {
            Refused("probing is not supported, because the end of the move is unknown")
        }
        320 | 330 | 331 | 760 => Refused("threading is not supported"),
        410 | 411 | 420 | 421 => {
            Refused("cutter compensation is not supported; export the path of the tool center")
        }
        510 => Refused("scaling is not supported; export at true size"),
        520 | 923 => Refused("offsets set by the program are not supported; use G92"),
        650 | 660 => Refused("macros are not supported; expand them"),
        680 => Refused("rotation is not supported; export the rotated drawing"),
        870 | 880 => Refused("this canned cycle is not supported; export single moves"),
        930 | 950 => LeftOut("speeds are read as units per minute"),
        _ if is_drill(code) => Plain,
        _ if PLAIN_G.binary_search(&code).is_ok() => Plain,
        _ => LeftOut("unknown, left out"),
    }
}

/// Whether a G code in tenths drills, bores or taps a hole at each following place.
pub(super) const fn is_drill(g_code: u32) -> bool {
    matches!(g_code, 730 | 740 | 810 | 820 | 830 | 840 | 850 | 860 | 890)
}

/// The meaning of an M code in tenths.
pub(super) const fn m(code: u32) -> Meaning {
    use Meaning::{LeftOut, Plain, Refused};
    match code {
        // Laser or spindle, end (also M99 of a repeated program, and M112), tool change, coolant,
        // motors and extruder, servo.
        20 | 30 | 40 | 50 | 60 | 70 | 80 | 90 | 170 | 180 | 300 | 480 | 490 | 820 | 830 | 840
        | 990 | 1060 | 1070 | 1120 | 2800 => Plain,
        0 | 10 | 600 => LeftOut("drawn without a pause"),
        _ if is_output(code) => LeftOut("read as a switch of the tool, like M3 and M5"),
        970 | 980 => Refused("subroutines are not supported; expand them"),
        1170 | 1180 => LeftOut("its message is not shown"),
        _ => LeftOut("unknown, left out"),
    }
}

/// Whether the words of an M code in tenths are its own parameters instead of a move: limits,
/// currents, steps, axes. Those of M42 include I, which would be the center of an arc.
pub(super) const fn has_own_words(m_code: u32) -> bool {
    match m(m_code) {
        Meaning::LeftOut(_) => m_code > 90 && (m_code == 420 || !is_output(m_code)),
        _ => matches!(m_code, 170 | 180 | 840),
    }
}

/// The written form of a code: `G90.1` for 901.
pub(super) fn name(letter: char, code: u32) -> String {
    match code % 10 {
        0 => format!("{letter}{}", code / 10),
        tenth => format!("{letter}{}.{tenth}", code / 10),
    }
}

/// G codes in tenths that are executed or have no effect, in order. G53 to G59.9 are plain too.
const PLAIN_G: &[u32] = &[
    0, 10, 20, 30, 40, 150, 170, 180, 190, 200, 210, 280, 300, 400, 430, 431, 432, 490, 500, 610,
    611, 640, 690, 800, 900, 901, 910, 911, 920, 921, 922, 940, 970, 980, 990,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_codes_are_sorted_so_that_each_is_found() {
        assert!(PLAIN_G.is_sorted());
        assert!(PLAIN_G.iter().all(|&code| g(code) == Meaning::Plain));
    }
}
