//! What a machine does when it reads a line: the state that G-code builds on.

use dobot_geometry::{Point, Vec2};

use super::arc::{center_by_radius, sweep_rad};
use super::block::Block;
use super::codes::{self, Meaning};
use super::servo::ServoCode;
use crate::error::SourceError;
use crate::sketch::checked;
use crate::warning::Warnings;

/// A move of the machine, from one line of the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Move {
    /// Where it stands in the text.
    pub(super) at: usize,
    pub(super) kind: MoveKind,
    pub(super) from: Point,
    pub(super) to: Point,
    /// The height at its end, where it is known.
    pub(super) z_mm: Option<f64>,
    pub(super) tool: ToolState,
    /// What switched the tool is M3.
    pub(super) is_by_m3: bool,
}

/// How the machine gets there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum MoveKind {
    /// G0, G28: in haste.
    Rapid,
    /// G1.
    Line,
    /// G2 and G3: about a center, by an angle that is above 0 for counterclockwise.
    Arc { center: Point, sweep_rad: f64 },
    /// G4: it waits.
    Dwell,
}

/// The tool of the machine, and how it is used.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ToolState {
    /// Its number.
    pub(super) number: Option<f64>,
    /// The S in force where M3, M4 or M106 hold and it is above 0.
    pub(super) power: Option<f64>,
    /// The angle that M280 gave a servo.
    m280: Option<f64>,
    /// And M300.
    m300: Option<f64>,
    /// F as the file has it.
    pub(super) feed: Option<f64>,
    /// The same in mm/s.
    pub(super) speed_mm_s: Option<f64>,
}

impl ToolState {
    /// The angle of the servo that this code turns.
    pub(super) const fn angle(&self, code: ServoCode) -> Option<f64> {
        match code {
            ServoCode::M280 => self.m280,
            ServoCode::M300 => self.m300,
        }
    }
}

/// The state of a machine.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a mode of its own")]
pub(super) struct Machine<'a, 'w> {
    text: &'a [u8],
    warnings: &'w mut Warnings<'a>,
    /// Where it stands, in mm.
    at: Point,
    z_mm: Option<f64>,
    /// Where the program counts from since G92.
    origin: Point,
    origin_z_mm: f64,
    /// The motion code in force, in tenths.
    motion: u32,
    unit_mm: f64,
    is_relative: bool,
    centers_are_absolute: bool,
    feed_is_by_minute: bool,
    /// The coordinate system in use (G54 to G59.3), in tenths.
    system: Option<u32>,
    is_on: bool,
    is_by_m3: bool,
    power: f64,
    tool: ToolState,
    has_ended: bool,
}

impl<'a, 'w> Machine<'a, 'w> {
    pub(super) fn new(text: &'a [u8], warnings: &'w mut Warnings<'a>) -> Self {
        Self {
            text,
            warnings,
            at: Point::ORIGIN,
            z_mm: None,
            origin: Point::ORIGIN,
            origin_z_mm: 0.0,
            motion: 0,
            unit_mm: 1.0,
            is_relative: false,
            centers_are_absolute: false,
            feed_is_by_minute: true,
            system: None,
            is_on: false,
            is_by_m3: false,
            power: 0.0,
            tool: ToolState::default(),
            has_ended: false,
        }
    }

    /// Takes a line; what comes back is the move that it asks for.
    pub(super) fn handle(&mut self, block: &Block) -> Result<Option<Move>, SourceError> {
        if self.has_ended {
            let instead = "left out, after the end (M2, M30 or M99)";
            self.warn(block.at, "unreached line", instead);
            return Ok(None);
        }
        if block.is_setting {
            self.warn(block.at, "machine setting", "left out ($)");
            return Ok(None);
        }
        if block.is_optional {
            self.warn(block.at, "optional line", "drawn (/)");
        }
        self.check_codes(block)?;
        if block.g.0.is_empty() && block.m.0.iter().any(|it| codes::has_own_words(it.1)) {
            self.turn_servo(block);
            return Ok(None);
        }
        if block.has_any(OTHER_AXES) {
            self.warn_of_axes(block);
        }
        self.modes(block)?;
        self.set_tool(block);
        let it = self.motion(block)?;
        self.has_ended = [20, 300, 990].into_iter().any(|it| block.m.has(it));
        Ok(it)
    }

    /// The tool as it is now.
    pub(super) const fn tool(&self) -> ToolState {
        self.tool
    }

    fn warn(&mut self, at: usize, what: &str, instead: &str) {
        self.warnings.add(at, what, instead);
    }

    fn found(&self, at: usize, found: impl Into<String>, expected: &str) -> SourceError {
        SourceError::found(self.text, at, found, expected)
    }

    fn check_codes(&mut self, block: &Block) -> Result<(), SourceError> {
        for &(at, code) in &block.g.0 {
            // Compensation by a tool without a number, or number 0, is none.
            if ![410, 420].contains(&code) || block.value(b'D') != Some(0.0) {
                self.check_code(at, 'G', code, codes::g(code))?;
            }
        }
        for &(at, code) in &block.m.0 {
            if code != 3000 || servo_angle(block).is_none() {
                self.check_code(at, 'M', code, codes::m(code))?;
            }
        }
        Ok(())
    }

    fn warn_of_axes(&mut self, block: &Block) {
        for &letter in OTHER_AXES {
            if block.value(letter).is_some() {
                let what = format!("{} word", char::from(letter));
                let instead = "left out, for only X and Y are drawn";
                self.warn(block.place(letter), &what, instead);
            }
        }
    }

    fn check_code(
        &mut self,
        at: usize,
        letter: char,
        code: u32,
        meaning: Meaning,
    ) -> Result<(), SourceError> {
        let name = || codes::name(letter, code);
        match meaning {
            Meaning::Plain => {}
            Meaning::LeftOut(instead) => self.warn(at, &format!("{} code", name()), instead),
            Meaning::Refused(why) => {
                let expected = format!("moves by G0 to G3: {why}");
                return Err(self.found(at, name(), &expected));
            }
        }
        Ok(())
    }

    /// Units, distances and coordinate systems.
    fn modes(&mut self, block: &Block) -> Result<(), SourceError> {
        for &(at, code) in &block.g.0 {
            match code {
                200 => self.unit_mm = 25.4,
                210 => self.unit_mm = 1.0,
                900 => self.is_relative = false,
                910 => self.is_relative = true,
                901 => self.centers_are_absolute = true,
                911 => self.centers_are_absolute = false,
                930 | 950 => self.feed_is_by_minute = false,
                940 => self.feed_is_by_minute = true,
                540..=599 => self.use_system(at, code),
                0 | 10 | 20 | 30 => self.motion = code,
                _ => {}
            }
        }
        let mut motions = block.g.0.iter().filter(|it| it.1 <= 30);
        match motions.nth(1) {
            Some(&(at, code)) => {
                let expected = "one of G0 to G3 in a line";
                Err(self.found(at, codes::name('G', code), expected))
            }
            None => Ok(()),
        }
    }

    fn use_system(&mut self, at: usize, code: u32) {
        let first = *self.system.get_or_insert(code);
        if first != code {
            let [what, first] = [code, first].map(|it| codes::name('G', it));
            let instead = format!("drawn as if it lay where {first} lies");
            self.warn(at, &format!("{what} coordinate system"), &instead);
        }
    }

    fn set_tool(&mut self, block: &Block) {
        if let Some(feed) = block.value(b'F') {
            let speed_mm_s = feed * self.unit_mm / 60.0;
            self.tool.feed = Some(feed);
            self.tool.speed_mm_s =
                (self.feed_is_by_minute && speed_mm_s > 0.0).then_some(speed_mm_s);
        }
        self.tool.number = block.value(b'T').or(self.tool.number);
        for &(_, code) in &block.m.0 {
            match code {
                30 | 40 | 1060 => (self.is_on, self.is_by_m3) = (true, code == 30),
                50 | 1070 => self.is_on = false,
                _ => {}
            }
        }
        self.turn_servo(block);
        self.set_power(block);
    }

    fn turn_servo(&mut self, block: &Block) {
        if block.m.has(2800) {
            self.tool.m280 = block.value(b'S').or(self.tool.m280);
        }
        let angle = servo_angle(block).filter(|it| *it != SERVO_OFF);
        self.tool.m300 = angle.or(self.tool.m300);
    }

    /// S is the power, unless it belongs to another code: a time to wait, a servo's angle.
    fn set_power(&mut self, block: &Block) {
        if let Some(s) = block.value(b'S') {
            let is_others = |code: u32| code > 90 && code != 1060;
            if !block.g.has(40) && !block.m.0.iter().any(|it| is_others(it.1)) {
                self.power = s;
            }
        }
        self.tool.power = (self.is_on && self.power > 0.0).then_some(self.power);
    }

    fn motion(&mut self, block: &Block) -> Result<Option<Move>, SourceError> {
        if block.g.has(40) {
            return Ok(Some(self.moved(block, MoveKind::Dwell, self.at)));
        }
        if block.g.first(&[920, 921, 922]).is_some() {
            return self.set_origin(block).map(|()| None);
        }
        if let Some((at, _)) = block.g.first(&[280, 300]) {
            return Ok(Some(self.home(block, at)));
        }
        if !block.has_any(b"XYZIJR") {
            return Ok(None);
        }
        if block.g.has(530) {
            return self.machine_move(block).map(Some);
        }
        self.z_mm = self
            .target(block, b'Z', self.z_mm.unwrap_or(0.0), self.origin_z_mm)
            .or(self.z_mm);
        let to = self.target_point(block)?;
        let kind = match self.motion {
            0 => MoveKind::Rapid,
            10 => MoveKind::Line,
            _ => self.arc(block, to)?,
        };
        if self.motion < 20 && block.has_any(b"IJR") {
            let places = b"IJR".iter().filter(|it| block.value(**it).is_some());
            let at = places.map(|&it| block.place(it)).min().unwrap_or(block.at);
            let expected = "I, J and R with G2 or G3 only";
            let found = format!(
                "the center of an arc with {}",
                codes::name('G', self.motion)
            );
            return Err(self.found(at, found, expected));
        }
        Ok(Some(self.moved(block, kind, to)))
    }

    fn moved(&mut self, block: &Block, kind: MoveKind, to: Point) -> Move {
        let from = self.at;
        self.at = to;
        Move {
            at: block.at,
            kind,
            from,
            to,
            z_mm: self.z_mm,
            tool: self.tool,
            is_by_m3: self.is_by_m3,
        }
    }

    fn target(&self, block: &Block, letter: u8, here: f64, origin: f64) -> Option<f64> {
        let from = if self.is_relative { here } else { origin };
        Some(from + block.value(letter)? * self.unit_mm)
    }

    fn target_point(&self, block: &Block) -> Result<Point, SourceError> {
        let (here, origin) = (self.at, self.origin);
        let x = self.target(block, b'X', here.x, origin.x).unwrap_or(here.x);
        let y = self.target(block, b'Y', here.y, origin.y).unwrap_or(here.y);
        checked(self.text, block.at, Point::new(x, y))
    }

    fn arc(&self, block: &Block, to: Point) -> Result<MoveKind, SourceError> {
        let clockwise = self.motion == 20;
        let center = self.center(block, to, clockwise)?;
        let found = |found| self.found(block.at, found, "ends that fit the arc");
        let sweep_rad = sweep_rad(center, self.at, to, clockwise).map_err(found)?;
        checked(self.text, block.at, center)?;
        if let Some(turns) = block.value(b'P').filter(|&it| it != 1.0) {
            let turns = format!("an arc of {turns} turns (P)");
            return Err(self.found(block.place(b'P'), turns, "at most one turn"));
        }
        Ok(MoveKind::Arc { center, sweep_rad })
    }

    fn center(&self, block: &Block, to: Point, clockwise: bool) -> Result<Point, SourceError> {
        if let Some(radius) = block.value(b'R') {
            let center = center_by_radius(self.at, to, radius * self.unit_mm, clockwise);
            let expected = "a radius of at least half their distance";
            return center.map_err(|found| self.found(block.place(b'R'), found, expected));
        }
        if !block.has_any(b"IJ") {
            let found = format!("{} without a center", codes::name('G', self.motion));
            return Err(self.found(block.at, found, "I and J, or R"));
        }
        let [i, j] = [b'I', b'J'].map(|it| block.value(it).map(|it| it * self.unit_mm));
        Ok(if self.centers_are_absolute {
            let x = i.map_or(self.at.x, |i| self.origin.x + i);
            Point::new(x, j.map_or(self.at.y, |j| self.origin.y + j))
        } else {
            self.at + Vec2::new(i.unwrap_or(0.0), j.unwrap_or(0.0))
        })
    }

    /// G92: the place where the machine stands gets other numbers; G92.1 takes them back.
    fn set_origin(&mut self, block: &Block) -> Result<(), SourceError> {
        if !block.g.has(920) {
            (self.origin, self.origin_z_mm) = (Point::ORIGIN, 0.0);
            return Ok(());
        }
        if !block.has_any(b"XYZE") {
            return Err(self.found(block.at, "G92 alone", "X, Y or Z with it"));
        }
        let value = |letter| block.value(letter).map(|it| it * self.unit_mm);
        let [x, y, z] = [b'X', b'Y', b'Z'].map(value);
        let origin = Point::new(
            x.map_or(self.origin.x, |x| self.at.x - x),
            y.map_or(self.origin.y, |y| self.at.y - y),
        );
        self.origin = checked(self.text, block.at, origin)?;
        if let Some(z) = z {
            let here = *self.z_mm.get_or_insert(z);
            self.origin_z_mm = here - z;
        }
        Ok(())
    }

    /// G28 and G30: the machine's own corner, where Marlin begins to count at 0.
    fn home(&mut self, block: &Block, at: usize) -> Move {
        self.warn(at, "G28 or G30 homing", "taken for a travel to X 0, Y 0");
        let is_all = !block.has_any(b"XYZ");
        let homes = |letter| is_all || block.value(letter).is_some();
        let axis = |letter, here| if homes(letter) { 0.0 } else { here };
        let to = Point::new(axis(b'X', self.at.x), axis(b'Y', self.at.y));
        if homes(b'Z') {
            self.z_mm = None;
        }
        self.moved(block, MoveKind::Rapid, to)
    }

    /// G53: in the machine's own coordinates, which the file does not define.
    fn machine_move(&mut self, block: &Block) -> Result<Move, SourceError> {
        self.warn(block.at, "G53 move", "taken for a travel with the pen up");
        let value = |letter, here| block.value(letter).map_or(here, |it| it * self.unit_mm);
        let to = Point::new(value(b'X', self.at.x), value(b'Y', self.at.y));
        let to = checked(self.text, block.at, to)?;
        self.z_mm = None;
        Ok(self.moved(block, MoveKind::Rapid, to))
    }
}

/// The S of M300 where it may be the angle of a servo, or 255 for none: a beep has a higher one, and P.
fn servo_angle(block: &Block) -> Option<f64> {
    let s = block
        .value(b'S')
        .filter(|it| (0.0..=180.0).contains(it) || *it == SERVO_OFF);
    s.filter(|_| block.m.has(3000) && block.value(b'P').is_none())
}

/// The S of M300 that lets a servo rest.
const SERVO_OFF: f64 = 255.0;
/// Those that turn, those beside the first three, and the extruder's.
const OTHER_AXES: &[u8] = b"ABCEUVW";
