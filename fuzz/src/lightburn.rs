use dobot_import::Source;

/// Projects of `LightBurn` of any kind: an error, or ink within the limits, but never a panic.
pub fn lightburn(input: &[u8]) {
    let spelled = crate::spelled(input, WORDS);
    let inside = String::from_utf8_lossy(&spelled);
    // Most of what is spelled is in a project, and much of that in a path, so that it is looked at.
    let [begin, end] = FRAMES[usize::from(input.first().copied().unwrap_or(0)) % FRAMES.len()];
    crate::read(&Source::LightBurn(format!("{begin}{inside}{end}")));
}

const FRAMES: [[&str; 2]; 4] = [
    ["", ""],
    ["<LightBurnProject>", "</LightBurnProject>"],
    [
        "<LightBurnProject><Shape Type=\"Path\">",
        "</Shape></LightBurnProject>",
    ],
    [
        "<LightBurnProject><Shape Type=\"Path\"><VertList>V0 0V5 0V5 5",
        "</Shape></LightBurnProject>",
    ],
];

const WORDS: &[&str] = &[
    "<LightBurnProject MirrorX=\"True\" MirrorY=\"True\">",
    "</LightBurnProject>",
    "<CutSetting type=\"Scan\"><index Value=\"0\"/><scanOpt Value=\"byGroup\"/></CutSetting>",
    "<CutSetting type=\"Cut\"><index Value=\"1\"/><name Value=\"a\"/><doOutput Value=\"0\"/></CutSetting>",
    "<CutSetting type=\"Scan+Cut\"><index Value=\"2\"/><name Value=\"a\"/><hide Value=\"1\"/></CutSetting>",
    "<CutSetting type=\"Tool\"><index Value=\"30\"/></CutSetting>",
    "<Shape Type=\"Group\"><Children>",
    "</Children></Shape>",
    "<Shape Type=\"Rect\" CutIndex=\"0\" W=\"9\" H=\"5\" Cr=\"2\"/>",
    "<Shape Type=\"Rect\" CutIndex=\"1\" W=\"9\" H=\"5\" Cr=\"-2\"/>",
    "<Shape Type=\"Ellipse\" CutIndex=\"2\" Rx=\"9\" Ry=\"5\"/>",
    "<Shape Type=\"Polygon\" CutIndex=\"0\" N=\"6\" Rx=\"9\" Ry=\"5\"/>",
    "<Shape Type=\"Bitmap\" Data=\"AAAA\"/>",
    "<Shape Type=\"Path\" CutIndex=\"0\" VertID=\"0\" PrimID=\"0\">",
    "<Shape Type=\"Path\" CutIndex=\"0\">",
    "<Shape Type=\"Text\">",
    "<Shape Type=\"",
    "</Shape>",
    "<BackupPath Type=\"Path\">",
    "</BackupPath>",
    "<XForm>1 0 0 1 5 5</XForm>",
    "<XForm>0 1e9 -1e9 0 0 0</XForm>",
    "<XForm>",
    "</XForm>",
    "<VertList>",
    "</VertList>",
    "<PrimList>",
    "</PrimList>",
    "LineClosed",
    "LineOpen",
    "V0 0",
    "V9 0c0x12c0y3c1x1",
    "V9 9c0x1c1x6c1y12",
    "V1e9 -1e9",
    "L0 1",
    "L1 2",
    "B1 2",
    "B2 0",
    "<V vx=\"1\" vy=\"2\" c0x=\"3\" c0y=\"4\"/>",
    "<V vx=\"9\" vy=\"9\" c1x=\"3\" c1y=\"4\"/>",
    "<P T=\"L\" p0=\"0\" p1=\"1\"/>",
    "<P T=\"B\" p0=\"1\" p1=\"0\"/>",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "&amp;",
    "&#48;",
    "\"",
    "/>",
    "<",
    ">",
    "c0x",
    "c1y",
    "S",
    "nan",
    "1e308",
    "-",
    ".",
    "e",
    " ",
    "0",
    "7",
];
