//! Export of a drawing to files for other programs: the strokes in order, in true millimetres.

use std::fmt::Write as _;
use std::str::FromStr;

use dobot_geometry::{Point, Rect, Stroke, bounds};
use dobot_plan::{DOT_MM, DrawingTool, Pass};

use crate::layout::sheet::SheetPlace;

/// The export formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExportFormat {
    /// SVG with a path per stroke and a layer per pass, as Inkscape and vpype read them.
    Svg,
    /// G-code: moves of a pen by Z, or of a laser by M4.
    Gcode,
    /// HP-GL with a pen per pass.
    Hpgl,
    /// JSON points, as `dobot draw` reads them.
    Json,
}

impl FromStr for ExportFormat {
    type Err = &'static str;

    /// Parses the extension of a file name.
    fn from_str(ending: &str) -> Result<Self, Self::Err> {
        match ending.to_ascii_lowercase().as_str() {
            "svg" => Ok(Self::Svg),
            "gcode" | "nc" => Ok(Self::Gcode),
            "plt" | "hpgl" => Ok(Self::Hpgl),
            "json" => Ok(Self::Json),
            _ => Err("allowed are names that end in .svg, .gcode, .plt or .json"),
        }
    }
}

/// Exports passes to a file. The page is the sheet, or the bounds of the ink without one; the
/// picture is upright as seen from behind the arm.
#[must_use]
pub fn export(passes: &[Pass], sheet: Option<&SheetPlace>, format: ExportFormat) -> String {
    let page = Page::of(passes, sheet);
    match format {
        ExportFormat::Svg => svg(passes, &page),
        ExportFormat::Gcode => gcode(passes, &page),
        ExportFormat::Hpgl => hpgl(passes, &page),
        ExportFormat::Json => json(passes, &page),
    }
}

/// A page with x to the right and y down from its upper left corner, in mm.
struct Page<'a> {
    sheet: Option<&'a SheetPlace>,
    /// The bounds of the ink in the base frame.
    ink: Rect,
    width_mm: f64,
    height_mm: f64,
}

impl<'a> Page<'a> {
    fn of(passes: &[Pass], sheet: Option<&'a SheetPlace>) -> Self {
        let strokes = passes.iter().flat_map(|pass| &pass.strokes);
        let ink = bounds(strokes.flat_map(|stroke| stroke.points.iter().copied()));
        let [width_mm, height_mm] = match sheet {
            Some(sheet) => [sheet.size.width_mm, sheet.size.height_mm],
            // A page without height would not be displayed.
            None => [ink.height(), ink.width()].map(|mm| mm.max(MIN_PAGE_MM)),
        };
        Self {
            sheet,
            ink,
            width_mm,
            height_mm,
        }
    }

    fn place(&self, p: Point) -> [Thousandths; 2] {
        let p = match self.sheet {
            Some(sheet) => sheet.on_sheet(p),
            None => Point::new(self.ink.y1 - p.y, self.ink.x1 - p.x),
        };
        [p.x, p.y].map(Thousandths)
    }

    /// Converts a point to the page with y up from the lower edge.
    fn upright(&self, p: Point) -> [Thousandths; 2] {
        let [x, Thousandths(y)] = self.place(p);
        [x, Thousandths(self.height_mm - y)]
    }
}

const MIN_PAGE_MM: f64 = 1.0;
const ALMOST_WHITE: u8 = 230;

/// Millimetres with at most three decimals.
#[derive(Clone, Copy)]
struct Thousandths(f64);

impl std::fmt::Display for Thousandths {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rounded = (self.0 * 1000.0).round() / 1000.0;
        // Avoid a negative zero.
        write!(f, "{}", rounded + 0.0)
    }
}

fn svg(passes: &[Pass], page: &Page<'_>) -> String {
    let [width, height] = [page.width_mm, page.height_mm].map(Thousandths);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" fill=\"none\" stroke-width=\"0.3\" stroke-linecap=\"round\">\n"
    );
    for (number, pass) in (1..).zip(passes) {
        let (name, color) = (escaped(&pass.name), color(seen(pass.color)));
        let _ = writeln!(
            text,
            "<g id=\"layer{number}\" inkscape:groupmode=\"layer\" inkscape:label=\"{name}\" stroke=\"{color}\">"
        );
        for stroke in &pass.strokes {
            let _ = writeln!(text, "<path d=\"{}\"/>", path(stroke, page));
        }
        text += "</g>\n";
    }
    text + "</svg>\n"
}

/// Returns a path; a dot is a line without length.
fn path(stroke: &Stroke, page: &Page<'_>) -> String {
    let places = stroke.points.iter().map(|&p| page.place(p));
    let corners = places.map(|[x, y]| format!("{x} {y}"));
    let corners: Vec<String> = corners.collect();
    let end = if corners.len() == 1 { "h0" } else { "" };
    format!("M{}{end}", corners.join("L"))
}

/// Replaces almost white and missing colours by black, which is visible on the page.
fn seen(color: Option<[u8; 3]>) -> [u8; 3] {
    let is_seen = |rgb: &[u8; 3]| rgb.iter().any(|shade| *shade < ALMOST_WHITE);
    color.filter(is_seen).unwrap_or_default()
}

fn color([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('"', "&quot;")
}

fn gcode(passes: &[Pass], page: &Page<'_>) -> String {
    let mut text = "G21\nG90\n".to_owned();
    for pass in passes {
        let name: String = pass
            .name
            .chars()
            .filter(|letter| !letter.is_control())
            .collect();
        let _ = writeln!(text, "; {name}");
        let (on, off) = match pass.tool {
            DrawingTool::Pen(pen) => ("G1 Z-0.1 F600", format!("G0 Z{}", Thousandths(pen.lift_mm))),
            DrawingTool::Laser(_) => ("M4 S1000", "M5".to_owned()),
        };
        let feed = Thousandths(pass.tool.speed_mm_s() * 60.0);
        let _ = writeln!(text, "{off}");
        for stroke in pass.drawn() {
            let mut places: Vec<_> = stroke.points.iter().map(|&p| page.upright(p)).collect();
            if let ([[Thousandths(x), y]], true) = (&places[..], pass.tool.burns()) {
                // With M4, a laser that does not move does not burn.
                places = [-0.5, 0.5]
                    .map(|side| [Thousandths(x + side * DOT_MM), *y])
                    .to_vec();
            }
            let Some(([x, y], rest)) = places.split_first() else {
                continue;
            };
            let _ = writeln!(text, "G0 X{x} Y{y}\n{on}");
            for [x, y] in rest {
                let _ = writeln!(text, "G1 X{x} Y{y} F{feed}");
            }
            let _ = writeln!(text, "{off}");
        }
    }
    text + "M2\n"
}

fn hpgl(passes: &[Pass], page: &Page<'_>) -> String {
    let units = |p: Point| {
        let [x, y] = page.upright(p).map(|mm| (mm.0 * UNITS_A_MM).round() + 0.0);
        format!("{x},{y}")
    };
    let mut text = "IN;\n".to_owned();
    for (number, pass) in (1..).zip(passes) {
        let _ = writeln!(text, "SP{number};");
        for Stroke { points, .. } in &pass.strokes {
            let Some((&first, rest)) = points.split_first() else {
                continue;
            };
            let rest: Vec<String> = rest.iter().map(|&p| units(p)).collect();
            let _ = writeln!(text, "PU{};PD{};PU;", units(first), rest.join(","));
        }
    }
    text + "SP0;\n"
}

fn json(passes: &[Pass], page: &Page<'_>) -> String {
    let mut strokes = Vec::new();
    for pass in passes {
        let name = serde_json::Value::from(pass.name.as_str());
        let color = pass
            .color
            .map(|rgb| format!("\"color\":\"{}\",", color(rgb)));
        let color = color.unwrap_or_default();
        for stroke in &pass.strokes {
            let points = stroke.points.iter().map(|&p| {
                let [x, y] = page.place(p);
                format!("[{x},{y}]")
            });
            let points: Vec<String> = points.collect();
            let points = points.join(",");
            strokes.push(format!("{{\"layer\":{name},{color}\"points\":[{points}]}}"));
        }
    }
    format!("{{\"strokes\":[\n{}\n]}}\n", strokes.join(",\n"))
}

/// HP-GL counts in fortieths of a millimetre.
const UNITS_A_MM: f64 = 40.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_import::{ReadOptions, Source, WarningKind};
    use dobot_plan::Laser;

    /// A corner, a line and a dot, 60 mm wide and 40 mm high.
    fn passes() -> Vec<Pass> {
        let line =
            |points: &[(f64, f64)]| Stroke::open(points.iter().map(|&p| Point::from(p)).collect());
        let corner = line(&[(200.0, 30.0), (240.0, 30.0), (240.0, -30.0)]);
        let others = vec![line(&[(210.0, 0.0), (220.0, 0.0)]), line(&[(205.0, -10.0)])];
        let mut red = Pass::new(DrawingTool::default(), vec![corner]);
        (red.name, red.color) = ("red & \"thin\"".to_owned(), Some([255, 0, 0]));
        let blue = Pass {
            name: "blue".to_owned(),
            ..Pass::new(DrawingTool::default(), others)
        };
        vec![red, blue]
    }

    /// Returns the strokes of a file, relative to the corner of their ink.
    fn read(name: &str, text: String) -> Vec<Vec<(f64, f64)>> {
        let options = ReadOptions {
            burns: text.contains("M4"),
            ..ReadOptions::default()
        };
        let source = Source::of_file(name, text.into_bytes()).unwrap();
        let (artwork, warnings) = source.read(&options).unwrap();
        let mut differences = warnings
            .iter()
            .filter(|warning| warning.kind != WarningKind::Note);
        assert_eq!(differences.next(), None, "{name}");
        let round = |mm: f64| (mm * 1e3).round() / 1e3 + 0.0;
        let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
        let points = |stroke: &Stroke| {
            stroke
                .points
                .iter()
                .map(|p| (round(p.x), round(p.y)))
                .collect()
        };
        strokes.map(points).collect()
    }

    #[test]
    fn every_exported_file_is_read_back_as_its_strokes() {
        let wanted = vec![
            vec![(0.0, 40.0), (0.0, 0.0), (60.0, 0.0)],
            vec![(30.0, 30.0), (30.0, 20.0)],
            vec![(40.0, 35.0)],
        ];
        for (name, format) in [
            ("a.svg", ExportFormat::Svg),
            ("a.gcode", ExportFormat::Gcode),
            ("a.plt", ExportFormat::Hpgl),
            ("a.json", ExportFormat::Json),
        ] {
            assert_eq!(name[2..].parse(), Ok(format));
            let text = export(&passes(), None, format);
            assert_eq!(read(name, text), wanted, "{name}");
        }
        assert!("png".parse::<ExportFormat>().is_err());
    }

    #[test]
    fn on_a_sheet_the_page_is_the_sheet() {
        let size = "210x148".parse().unwrap();
        let sheet = SheetPlace::centered(size, Point::new(225.0, 0.0));
        let text = export(&passes(), Some(&sheet), ExportFormat::Svg);
        assert!(text.contains("width=\"210mm\" height=\"148mm\" viewBox=\"0 0 210 148\""));
        assert!(text.contains("inkscape:label=\"red &amp; &quot;thin&quot;\" stroke=\"#ff0000\""));
        assert_eq!(read("a.svg", text)[0][0], (75.0, 99.0));
    }

    #[test]
    fn white_and_flat_drawings_are_visible_in_other_programs() {
        let line = Stroke::open(vec![Point::new(200.0, 30.0), Point::new(200.0, -30.0)]);
        for (found, color) in [([255, 255, 254], "#000000"), ([255, 255, 0], "#ffff00")] {
            let pass = Pass {
                color: Some(found),
                ..Pass::new(DrawingTool::default(), vec![line.clone()])
            };
            let text = export(&[pass], None, ExportFormat::Svg);
            assert!(text.contains(&format!("stroke=\"{color}\"")), "{text}");
            assert!(
                text.contains("height=\"1mm\" viewBox=\"0 0 60 1\""),
                "{text}"
            );
        }
    }

    #[test]
    fn an_exported_laser_pass_is_repeated() {
        let laser = Laser {
            times: 3,
            ..Laser::default()
        };
        let pass = Pass {
            tool: DrawingTool::Laser(laser),
            ..passes().remove(0)
        };
        let text = export(&[pass], None, ExportFormat::Gcode);
        assert_eq!(text.matches("M4 S1000").count(), 3);
        assert!(text.contains("G1 X60 Y40 F600\nM5"));
    }

    #[test]
    fn an_exported_laser_repeats_each_shape_or_each_layer_and_its_dots_move() {
        for (by_stroke, order) in [
            (false, [30.0, 40.0, 30.0, 40.0]),
            (true, [30.0, 30.0, 40.0, 40.0]),
        ] {
            let laser = Laser {
                times: 2,
                by_stroke,
                ..Laser::default()
            };
            let line = |x: f64| {
                Stroke::open(vec![
                    Point::new(200.0, 30.0 - x),
                    Point::new(240.0, 30.0 - x),
                ])
            };
            let dot = Stroke::open(vec![Point::new(205.0, -10.0)]);
            let pass = Pass::new(DrawingTool::Laser(laser), vec![line(30.0), dot.clone()]);
            let frame = Pass::new(DrawingTool::Laser(Laser::default()), vec![line(0.0)]);
            let strokes = read("a.gcode", export(&[frame, pass], None, ExportFormat::Gcode));
            let middles = strokes
                .iter()
                .map(|line| f64::midpoint(line[0].0, line[line.len() - 1].0));
            assert_eq!(middles.skip(1).collect::<Vec<_>>(), order);
            let dots = strokes
                .iter()
                .filter(|line| (line[0].1 - 35.0).abs() < 1e-9);
            assert!(
                dots.clone().count() == 2
                    && dots
                        .clone()
                        .all(|line| ((line[1].0 - line[0].0).abs() - 0.2).abs() < 1e-9),
                "{strokes:?}"
            );
        }
    }
}
