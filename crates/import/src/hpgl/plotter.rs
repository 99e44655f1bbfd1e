//! A plotter that draws into a sketch.

use dobot_geometry::{Area, FillRule, Point, Vec2};

use super::command::Command;
use super::encoded::{EncodedItem, items};
use super::label::Labels;
use super::line_type::LineTypes;
use super::polygon::Polygon;
use super::tick::Ticks;
use super::transform::PlotTransform;
use super::window::Window;
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::place::excerpt;
use crate::sketch::Sketch;

/// The state of a plotter.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of its own")]
pub(super) struct Plotter<'a> {
    pub(super) sketch: Sketch<'a>,
    pub(super) transform: PlotTransform,
    /// The position of the pen, in user units.
    pub(super) at: Point,
    pub(super) is_down: bool,
    is_relative: bool,
    pen: PenChoice,
    /// The colours of pens (PC), by number.
    colors: Vec<(f64, [u8; 3])>,
    speed_mm_s: Option<f64>,
    /// Where the pen was lowered and has drawn nothing yet.
    pub(super) is_dot: bool,
    /// Whether the sketch uses the layer of the pen at its speed.
    is_selected: bool,
    pub(super) has_drawn: bool,
    /// Whether PG came since.
    is_new_page: bool,
    /// Whether the file has set P1 and P2 (IP).
    pub(super) knows_corners: bool,
    /// The length and the width of the sheet, in plotter units (PS).
    pub(super) sheet: Option<[f64; 2]>,
    /// Whether areas are filled with lines or dots (FT).
    has_pattern: bool,
    /// Whether chords of arcs are given by their deviation.
    pub(super) chords_by_deviation: bool,
    pub(super) polygon: Polygon,
    /// The parts of ticks to the right or up, and to the left or down (TL).
    pub(super) ticks: Ticks,
    pub(super) labels: Labels,
    pub(super) line_types: LineTypes,
    pub(super) window: Option<Window>,
}

/// The selected pen.
#[derive(Clone, Copy, Debug, PartialEq)]
enum PenChoice {
    /// None was selected.
    Any,
    /// SP 0: no pen.
    None,
    Number(f64),
}

impl<'a> Plotter<'a> {
    pub(super) fn new(sketch: Sketch<'a>) -> Self {
        Self {
            sketch,
            transform: PlotTransform::DEFAULT,
            at: Point::default(),
            is_down: false,
            is_relative: false,
            pen: PenChoice::Any,
            colors: Vec::new(),
            speed_mm_s: None,
            is_dot: false,
            is_selected: false,
            has_drawn: false,
            is_new_page: false,
            knows_corners: false,
            sheet: None,
            has_pattern: false,
            chords_by_deviation: false,
            polygon: Polygon::default(),
            ticks: Ticks::default(),
            labels: Labels::default(),
            line_types: LineTypes::default(),
            window: None,
        }
    }

    /// Ends the plot at a mistake: the pen may not have been meant to touch the paper there.
    pub(super) fn finish_early(mut self) -> Result<Sketch<'a>, SourceError> {
        self.is_dot = false;
        self.finish()
    }

    pub(super) fn finish(mut self) -> Result<Sketch<'a>, SourceError> {
        let end = Command {
            at: 0,
            name: *b"PU",
            numbers: Vec::new(),
            bytes: &[],
        };
        self.lift(&end)?;
        self.end_window()?;
        Ok(self.sketch)
    }

    pub(super) fn handle(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        match &command.name {
            b"IN" | b"DF" => self.reset(command),
            b"PU" => {
                self.lift(command)?;
                self.go(command)
            }
            b"PD" => {
                self.lower();
                self.go(command)
            }
            b"PA" | b"PR" => {
                self.is_relative = &command.name == b"PR";
                self.go(command)
            }
            b"PE" => self.go_encoded(command),
            b"SP" => self.take_pen(command, command.number(0)),
            b"PC" => {
                self.color_pen(command);
                Ok(())
            }
            b"VS" => self.set_speed(command),
            b"IP" => self.set_corners(command),
            b"SC" => self.set_scale(command),
            b"RO" => self.turn(command),
            b"IR" => self.relative_corners(command),
            b"PS" => {
                self.set_sheet(command);
                Ok(())
            }
            b"CT" => {
                self.chords_by_deviation = command.number(0) == Some(1.0);
                Ok(())
            }
            b"CI" => self.circle(command),
            b"AA" | b"AR" => self.arc(command),
            b"AT" | b"RT" => self.arc_through(command),
            b"BZ" | b"BR" => self.beziers(command),
            b"EA" | b"ER" | b"RA" | b"RR" => self.rectangle(command),
            b"EW" | b"WG" => self.wedge(command),
            b"PM" => self.polygon_mode(command),
            b"EP" | b"FP" => self.draw_polygon(command),
            b"LB" | b"BL" | b"PB" | b"CP" | b"SI" | b"SR" | b"DI" | b"DR" | b"SL" | b"ES"
            | b"LO" | b"SM" | b"CS" | b"CA" | b"SD" | b"AD" | b"DV" | b"TD" => self.text(command),
            b"TL" => {
                self.ticks = Ticks::of(&command.numbers);
                Ok(())
            }
            b"XT" | b"YT" => self.tick(command),
            b"LT" => self.set_line_type(command),
            b"UL" => self.define_line_type(command),
            b"FT" => {
                self.fill_type(command);
                Ok(())
            }
            b"IW" => self.set_window(command),
            b"PG" => {
                self.is_new_page = true;
                Ok(())
            }
            name => {
                if let Some(instead) = left_out(*name) {
                    self.warn(command, &format!("{} command", command.letters()), instead);
                }
                Ok(())
            }
        }
    }

    pub(super) fn warn(&mut self, command: &Command<'_>, what: &str, instead: &str) {
        self.sketch.warn(command.at, what, instead);
    }

    pub(super) fn refused(&self, command: &Command<'_>, expected: &str) -> SourceError {
        self.sketch.found(command.at, command.text(), expected)
    }

    /// IN resets everything, DF keeps the corners and the rotation.
    fn reset(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        self.lift(command)?;
        self.end_window()?;
        self.is_relative = false;
        self.has_pattern = false;
        self.chords_by_deviation = false;
        self.polygon = Polygon::default();
        self.ticks = Ticks::default();
        self.reset_labels();
        self.reset_line_types()?;
        let mut transform = PlotTransform::DEFAULT;
        if &command.name == b"IN" {
            (self.speed_mm_s, self.is_selected) = (None, false);
            self.knows_corners = false;
        } else {
            (transform.corners, transform.quarters) =
                (self.transform.corners, self.transform.quarters);
        }
        self.use_transform(transform);
        Ok(())
    }

    /// Keeps the pen at its place on the paper.
    pub(super) fn use_transform(&mut self, transform: PlotTransform) {
        if self.transform != transform {
            self.at = transform.point_at(self.transform.point(self.at));
            self.transform = transform;
        }
    }

    /// Makes a dot if the pen only touched the paper.
    fn lift(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let is_dot = std::mem::take(&mut self.is_dot) && !self.polygon.is_open;
        if is_dot && self.pen != PenChoice::None && self.select(command)? {
            let at = self.transform.point(self.at);
            self.sketch.check(command.at, at)?;
            self.sketch.dot(at)?;
        }
        self.is_down = false;
        self.sketch.lift();
        Ok(())
    }

    const fn lower(&mut self) {
        self.is_dot |= !self.is_down;
        self.is_down = true;
    }

    fn go(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        if !command.numbers.len().is_multiple_of(2) {
            return Err(self.refused(command, "pairs of coordinates x,y"));
        }
        for pair in command.numbers.chunks_exact(2) {
            let from = self.base(self.is_relative);
            self.go_to(command, from + Vec2::new(pair[0], pair[1]))?;
            self.mark(command)?;
        }
        Ok(())
    }

    /// The origin of coordinates: the pen for relative ones.
    pub(super) fn base(&self, is_relative: bool) -> Point {
        if is_relative {
            self.at
        } else {
            Point::default()
        }
    }

    pub(super) fn go_to(&mut self, command: &Command<'_>, to: Point) -> Result<(), SourceError> {
        let from_mm = self
            .sketch
            .check(command.at, self.transform.point(self.at))?;
        let to_mm = self.sketch.check(command.at, self.transform.point(to))?;
        self.at = to;
        self.labels.margin_mm = None;
        if self.polygon.is_open {
            self.polygon.point(to_mm, self.is_down);
            return self.sketch.spend(1);
        }
        if self.is_down && from_mm != to_mm {
            self.ink(command, &[from_mm, to_mm])?;
        }
        Ok(())
    }

    /// Draws with the current pen, up or down.
    pub(super) fn ink(
        &mut self,
        command: &Command<'_>,
        points: &[Point],
    ) -> Result<(), SourceError> {
        self.is_dot = false;
        if self.select(command)? {
            self.begin_dashes();
            let mut lines = points.windows(2);
            lines.try_for_each(|line| self.sketch.line(line[0], line[1]))?;
        }
        Ok(())
    }

    /// Draws a separate line.
    pub(super) fn outline(
        &mut self,
        command: &Command<'_>,
        points: &[Point],
    ) -> Result<(), SourceError> {
        self.sketch.lift();
        self.ink(command, points)?;
        self.sketch.lift();
        Ok(())
    }

    /// Draws a filled area, which hides what was drawn before it unless its pattern is transparent
    /// (FT).
    pub(super) fn fill(&mut self, command: &Command<'_>, area: Area) -> Result<(), SourceError> {
        if self.select(command)? {
            if !self.has_pattern {
                self.sketch.cover(&area.rings, area.rule)?;
            }
            self.sketch.area(area)?;
        }
        Ok(())
    }

    /// Uses the pen's layer; returns whether there is a pen.
    pub(super) fn select(&mut self, command: &Command<'_>) -> Result<bool, SourceError> {
        if self.pen == PenChoice::None {
            self.warn(command, "penless line", "left out (SP 0)");
            return Ok(false);
        }
        if std::mem::take(&mut self.is_new_page) && self.has_drawn {
            self.warn(command, "further page", "drawn on the same sheet (PG)");
        }
        if !self.is_selected {
            self.select_layer(command)?;
        }
        self.begin_window();
        Ok(true)
    }

    fn select_layer(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        (self.is_selected, self.has_drawn) = (true, true);
        let name = match self.pen {
            PenChoice::Number(number) => format!("pen {number}"),
            PenChoice::Any | PenChoice::None => String::new(),
        };
        self.sketch.use_layer(Layer {
            name,
            color: self.color(),
            speed_mm_s: self.speed_mm_s,
            ..Layer::default()
        })?;
        if self.sketch.layer().speed_mm_s != self.speed_mm_s {
            self.warn(
                command,
                "speed change",
                "drawn with the first speed of the pen (VS)",
            );
        }
        Ok(())
    }

    /// Red, green and blue, each from 0 to 255.
    fn color_pen(&mut self, command: &Command<'_>) {
        let [Some(pen), Some(red), Some(green), Some(blue)] =
            [0, 1, 2, 3].map(|i| command.number(i))
        else {
            return;
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a shade; saturates"
        )]
        let color = [red, green, blue].map(|value| value as u8);
        self.colors.retain(|color| color.0 != pen);
        if self.colors.len() < MAX_PENS {
            self.colors.push((pen, color));
        }
    }

    fn color_of(&self, pen: f64) -> Option<[u8; 3]> {
        self.colors
            .iter()
            .find(|color| color.0 == pen)
            .map(|at| at.1)
    }

    fn color(&self) -> Option<[u8; 3]> {
        match self.pen {
            PenChoice::Number(number) => self.color_of(number),
            PenChoice::Any | PenChoice::None => None,
        }
    }

    fn take_pen(&mut self, command: &Command<'_>, number: Option<f64>) -> Result<(), SourceError> {
        self.lift(command)?;
        self.pen = match number {
            // Pen 0 is white, and draws nothing, unless it has an explicit colour.
            Some(0.0) if self.color_of(0.0).is_some_and(|color| color != WHITE) => {
                PenChoice::Number(0.0)
            }
            None | Some(0.0) => PenChoice::None,
            Some(number) => PenChoice::Number(number),
        };
        self.is_selected = false;
        Ok(())
    }

    /// VS: the speed, in centimetres per second.
    fn set_speed(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let speed_mm_s = command.number(0).map(|cm_s| cm_s * 10.0);
        if speed_mm_s.is_some_and(|speed_mm_s| speed_mm_s <= 0.0) {
            return Err(self.refused(command, "a speed above 0 cm/s"));
        }
        if self.speed_mm_s != speed_mm_s {
            self.is_selected = false;
            self.speed_mm_s = speed_mm_s;
        }
        Ok(())
    }

    /// FT: the fill. Patterns are not drawn. Without a number the fill is reset.
    fn fill_type(&mut self, command: &Command<'_>) {
        self.has_pattern = command.number(0).is_some_and(|kind| kind > 2.0);
        if self.has_pattern {
            self.warn(command, "fill pattern", "filled like all other areas (FT)");
        }
    }

    fn polygon_mode(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        match command.number(0) {
            None | Some(0.0) => self.polygon.begin(self.transform.point(self.at)),
            Some(1.0) => self.polygon.close_ring(self.is_down),
            Some(2.0) => self.polygon.end(self.is_down),
            _ => return Err(self.refused(command, "PM 0, PM 1 or PM 2")),
        }
        self.is_dot = false;
        Ok(())
    }

    fn draw_polygon(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        if &command.name == b"EP" {
            let lines = self.polygon.lines();
            return lines
                .iter()
                .try_for_each(|line| self.outline(command, line));
        }
        let rings = self.polygon.filled();
        let rule = match command.number(0) {
            Some(1.0) => FillRule::NonZero,
            _ => FillRule::EvenOdd,
        };
        self.fill(command, Area { rings, rule })
    }

    fn go_encoded(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        for item in items(command.bytes) {
            let found = |(at, expected)| {
                let text = excerpt(command.bytes, at);
                self.sketch.found(command.at + 2 + at, text, expected)
            };
            match item.map_err(found)? {
                EncodedItem::Pen(number) => {
                    self.take_pen(command, Some(number))?;
                }
                EncodedItem::Go {
                    x,
                    y,
                    is_absolute,
                    is_up,
                } => {
                    if is_up {
                        self.lift(command)?;
                    } else {
                        self.lower();
                    }
                    let from = self.base(!is_absolute);
                    self.go_to(command, from + Vec2::new(x, y))?;
                    self.mark(command)?;
                }
            }
        }
        Ok(())
    }
}

/// The warning for a command that is left out; `None` if it has no effect.
const fn left_out(name: [u8; 2]) -> Option<&'static str> {
    match &name {
        // Commands about the sheet, the pens, the lifting speed, the fonts, and queries.
        b"AC" | b"AF" | b"AH" | b"AP" | b"AS" | b"BP" | b"CO" | b"CR" | b"CC" | b"CM" | b"CV"
        | b"DC" | b"DP" | b"DS" | b"DT" | b"EC" | b"FR" | b"FS" | b"GC" | b"GM" | b"GP" | b"IM"
        | b"IV" | b"KY" | b"LA" | b"MC" | b"MG" | b"MT" | b"NP" | b"NR" | b"OA" | b"OC" | b"OD"
        | b"OE" | b"OF" | b"OH" | b"OI" | b"OK" | b"OL" | b"OO" | b"OP" | b"OS" | b"OT" | b"OW"
        | b"PP" | b"PT" | b"PW" | b"QL" | b"RP" | b"SA" | b"SB" | b"SS" | b"ST" | b"TR" | b"WD"
        | b"WU" | b"MU" | b"VN" => None,
        b"UC" | b"SV" | b"RF" => Some("left out"),
        _ => Some("unknown, left out"),
    }
}

/// The largest number of pens.
const MAX_PENS: usize = 256;
const WHITE: [u8; 3] = [255; 3];
