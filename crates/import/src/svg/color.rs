//! The names of colours.

use std::str::FromStr;

use svgtypes::Color;

/// The CSS name of a colour, or its hexadecimal digits.
pub(crate) fn name(rgb: [u8; 3]) -> String {
    let is_match = |name: &&str| {
        Color::from_str(name).is_ok_and(|color| [color.red, color.green, color.blue] == rgb)
    };
    match NAMES.split_whitespace().find(is_match) {
        Some(name) => name.to_owned(),
        None => format!("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]),
    }
}

/// The preferred one of two names for a colour.
const NAMES: &str = "
    aliceblue antiquewhite aquamarine azure beige bisque black blanchedalmond blue blueviolet
    brown burlywood cadetblue chartreuse chocolate coral cornflowerblue cornsilk crimson cyan
    darkblue darkcyan darkgoldenrod darkgray darkgreen darkkhaki darkmagenta darkolivegreen
    darkorange darkorchid darkred darksalmon darkseagreen darkslateblue darkslategray
    darkturquoise darkviolet deeppink deepskyblue dimgray dodgerblue firebrick floralwhite
    forestgreen gainsboro ghostwhite gold goldenrod gray green greenyellow honeydew hotpink
    indianred indigo ivory khaki lavender lavenderblush lawngreen lemonchiffon lightblue
    lightcoral lightcyan lightgoldenrodyellow lightgray lightgreen lightpink lightsalmon
    lightseagreen lightskyblue lightslategray lightsteelblue lightyellow lime limegreen linen
    magenta maroon mediumaquamarine mediumblue mediumorchid mediumpurple mediumseagreen
    mediumslateblue mediumspringgreen mediumturquoise mediumvioletred midnightblue mintcream
    mistyrose moccasin navajowhite navy oldlace olive olivedrab orange orangered orchid
    palegoldenrod palegreen paleturquoise palevioletred papayawhip peachpuff peru pink plum
    powderblue purple red rosybrown royalblue saddlebrown salmon sandybrown seagreen seashell
    sienna silver skyblue slateblue slategray snow springgreen steelblue tan teal thistle tomato
    turquoise violet wheat white whitesmoke yellow yellowgreen";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn named_colours_have_names_and_others_have_digits() {
        assert_eq!(name([255, 0, 0]), "red");
        assert_eq!(name([0, 255, 255]), "cyan");
        assert_eq!(name([128, 128, 128]), "gray");
        assert_eq!(name([27, 42, 65]), "#1b2a41");
    }

    #[test]
    fn every_name_is_known_to_css() {
        for known in NAMES.split_whitespace() {
            let color = Color::from_str(known).unwrap();
            assert_eq!(&name([color.red, color.green, color.blue]), known);
        }
    }
}
