//! The machine state that G-code modifies.

use std::f64::consts::TAU;

use dobot_geometry::{Point, Vec2};

use super::arc::{center_by_radius, far_sides, sweep_rad};
use super::block::{Block, BlockKind};
use super::codes::{self, Meaning};
use super::laser::{LaserCodes, LaserState};
use super::outputs::Outputs;
use super::servo::ServoCode;
use crate::error::SourceError;
use crate::sketch::checked;
use crate::warning::Warnings;

/// A move of the machine, from one line of the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Move {
    /// The position in the text.
    pub(super) at: usize,
    pub(super) kind: MoveKind,
    pub(super) from: Point,
    pub(super) to: Point,
    /// The heights at its start and its end, if known.
    pub(super) from_z_mm: Option<f64>,
    pub(super) z_mm: Option<f64>,
    pub(super) tool: ToolState,
    pub(super) laser: LaserState,
    /// Whether M3 switched the tool on.
    pub(super) is_by_m3: bool,
    /// Whether its line has an S.
    pub(super) has_power_word: bool,
}

impl Move {
    /// Whether the machine moves along Z only, or waits.
    pub(super) fn is_still(&self) -> bool {
        let is_arc = matches!(
            self.kind,
            MoveKind::Arc { .. } | MoveKind::UprightArc { .. }
        );
        self.from == self.to && !is_arc
    }

    /// Whether it moves along X or Y at a feed rate.
    pub(super) fn is_line(&self) -> bool {
        !self.is_still() && self.kind != MoveKind::Rapid
    }
}

/// The kind of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum MoveKind {
    /// G0, G28: a rapid move.
    Rapid,
    /// G1: a line.
    Line,
    /// G2 and G3: about a center, by an angle above 0 for counterclockwise.
    Arc { center: Point, sweep_rad: f64 },
    /// An arc in a vertical plane (G18, G19), seen from above: a line with the two places where it
    /// turns back, or its end.
    UprightArc { by: [Point; 2] },
    /// G81 and similar: a hole, at its depth.
    Drill,
    /// G4: a wait.
    Dwell,
}

/// The state of the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ToolState {
    /// Its number.
    pub(super) number: Option<f64>,
    /// The current S while M3, M4 or M106 is active, if above 0.
    pub(super) power: Option<f64>,
    /// Whether M3, M4 or M106 is active, and the program has no S yet.
    pub(super) is_on_without_power: bool,
    /// The servo angle of M280.
    m280: Option<f64>,
    /// The servo angle of M300.
    m300: Option<f64>,
    /// The S on an M3 line without motion; M5 ends it.
    m3: Option<f64>,
    /// F as in the file.
    pub(super) feed: Option<f64>,
    /// F in mm/s.
    pub(super) speed_mm_s: Option<f64>,
}

impl ToolState {
    /// The servo angle that this code sets.
    pub(super) const fn angle(&self, code: ServoCode) -> Option<f64> {
        match code {
            ServoCode::M280 => self.m280,
            ServoCode::M300 => self.m300,
            ServoCode::M3 => self.m3,
        }
    }
}

/// The state of a machine.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each is a mode of its own")]
pub(super) struct Machine<'a, 'w> {
    text: &'a [u8],
    warnings: &'w mut Warnings<'a>,
    /// The position, in mm.
    at: Point,
    z_mm: Option<f64>,
    /// The origin of the program since G92.
    origin: Point,
    origin_z_mm: f64,
    /// The active motion code, in tenths.
    motion: u32,
    /// Whether a drilling cycle is active instead.
    cycle: Option<DrillCycle>,
    /// G99: after a hole the tool stays at R.
    stays_at_r: bool,
    plane: Plane,
    unit_mm: f64,
    is_relative: bool,
    centers_are_absolute: bool,
    feed_is_by_minute: bool,
    /// The active coordinate system (G54 to G59.3), in tenths.
    system: Option<u32>,
    is_by_m3: bool,
    codes: LaserCodes,
    /// Whether M3, M4 or M106 is active.
    is_switched_on: Option<bool>,
    outputs: Outputs,
    laser: LaserState,
    tool: ToolState,
    has_ended: bool,
}

impl<'a, 'w> Machine<'a, 'w> {
    pub(super) fn new(text: &'a [u8], codes: LaserCodes, warnings: &'w mut Warnings<'a>) -> Self {
        Self {
            text,
            warnings,
            at: Point::ORIGIN,
            z_mm: None,
            origin: Point::ORIGIN,
            origin_z_mm: 0.0,
            motion: 0,
            cycle: None,
            stays_at_r: false,
            plane: Plane::Xy,
            unit_mm: 1.0,
            is_relative: false,
            centers_are_absolute: false,
            feed_is_by_minute: true,
            system: None,
            is_by_m3: false,
            codes,
            is_switched_on: None,
            outputs: Outputs::default(),
            laser: LaserState::default(),
            tool: ToolState::default(),
            has_ended: false,
        }
    }

    /// Executes a block and passes its moves on.
    pub(super) fn handle(
        &mut self,
        block: &Block,
        hand_on: &mut impl FnMut(&Move) -> Result<(), SourceError>,
    ) -> Result<(), SourceError> {
        if self.has_ended {
            let instead = "left out, because it is after the end (M2, M30, M99, M112 or %)";
            self.warn(block.at, "unreached line", instead);
            return Ok(());
        }
        match block.kind {
            BlockKind::Words => {}
            BlockKind::Setting => {
                self.warn(block.at, "machine setting", "left out ($)");
                return Ok(());
            }
            BlockKind::RealTime => {
                self.warn(block.at, "real-time command", "left out (?, ! or ~)");
                return Ok(());
            }
            BlockKind::End => {
                self.has_ended = true;
                return Ok(());
            }
        }
        if block.is_optional {
            self.warn(block.at, "optional line", "drawn (/)");
        }
        self.check_codes(block)?;
        if block.g.0.is_empty() && block.m.0.iter().any(|code| codes::has_own_words(code.1)) {
            self.switch_tool(block);
            return Ok(());
        }
        if block.has_any(OTHER_AXES) && block.m.first(&[670, 680]).is_none() {
            self.warn_of_axes(block);
        }
        self.modes(block)?;
        self.set_tool(block);
        if self.drills(block) {
            self.drill(block, hand_on)?;
        } else if let Some(motion) = self.motion(block)? {
            hand_on(&motion)?;
        }
        self.has_ended = block.m.first(&[20, 300, 990, 1120]).is_some();
        Ok(())
    }

    /// The program.
    pub(super) const fn text(&self) -> &'a [u8] {
        self.text
    }

    /// The current tool and laser.
    pub(super) const fn state(&self) -> (ToolState, LaserState) {
        (self.tool, self.laser)
    }

    fn warn(&mut self, at: usize, what: &str, instead: &str) {
        self.warnings.add(at, what, instead);
    }

    fn found(&self, at: usize, found: impl Into<String>, expected: &str) -> SourceError {
        SourceError::found(self.text, at, found, expected)
    }

    fn check_codes(&mut self, block: &Block) -> Result<(), SourceError> {
        for &(at, code) in &block.g.0 {
            // Compensation for tool number 0 or no tool is none.
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
                let instead = "left out, because only X and Y are drawn";
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
                170 => self.plane = Plane::Xy,
                180 => self.plane = Plane::Zx,
                190 => self.plane = Plane::Yz,
                980 | 990 => self.stays_at_r = code == 990,
                0 | 10 | 20 | 30 => (self.motion, self.cycle) = (code, None),
                800 => self.cycle = None,
                _ if codes::is_drill(code) => {
                    let initial_mm = self.z_mm;
                    self.cycle.get_or_insert(DrillCycle {
                        initial_mm,
                        ..DrillCycle::default()
                    });
                }
                _ => {}
            }
        }
        let mut motions = block.g.0.iter().filter(|code| code.1 <= 30);
        match motions.nth(1) {
            Some(&(at, code)) => {
                let expected = "one of G0 to G3 per line";
                Err(self.found(at, codes::name('G', code), expected))
            }
            None => Ok(()),
        }
    }

    fn use_system(&mut self, at: usize, code: u32) {
        let first = *self.system.get_or_insert(code);
        if first != code {
            let [what, first] = [code, first].map(|value| codes::name('G', value));
            let instead = format!("drawn in the place of {first}");
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
        self.switch_tool(block);
    }

    /// Executes M3, M4, M5, M106, M107, the codes of outputs and servos, and S.
    fn switch_tool(&mut self, block: &Block) {
        for &(_, code) in &block.m.0 {
            match code {
                1060 if self.codes == LaserCodes::Spindle => {}
                30 | 40 | 1060 => {
                    (self.is_switched_on, self.is_by_m3) = (Some(true), code == 30);
                }
                50 | 1070 => {
                    self.is_switched_on = Some(false);
                    if self.codes == LaserCodes::Outputs {
                        self.outputs.switch_all_off();
                    }
                }
                _ => {}
            }
        }
        self.outputs.switch(block);
        let are_on = self.outputs.are_on();
        self.laser.is_on = match self.is_switched_on {
            Some(true) => Some(are_on != Some(false)),
            is_on if self.codes == LaserCodes::Outputs => are_on.or(is_on),
            is_on => is_on,
        };
        self.turn_servo(block);
        self.set_power(block);
    }

    fn turn_servo(&mut self, block: &Block) {
        if block.m.has(2800) {
            self.tool.m280 = block.value(b'S').or(self.tool.m280);
        }
        let angle = servo_angle(block).filter(|servo_angle| *servo_angle != SERVO_OFF);
        self.tool.m300 = angle.or(self.tool.m300);
        let is_m3 = block.m.has(30) && !block.has_any(b"XYZ");
        let angle = block.value(b'S').filter(|_| is_m3);
        self.tool.m3 = angle.or(self.tool.m3).filter(|_| self.is_on());
    }

    fn is_on(&self) -> bool {
        self.laser.is_on == Some(true)
    }

    /// S is the power, unless it belongs to another code: a dwell, a servo angle.
    fn set_power(&mut self, block: &Block) {
        if let Some(s) = block.value(b'S') {
            let has_fan = self.codes == LaserCodes::Spindle && block.m.first(&[30, 40]).is_none();
            let is_others = |code: u32| match code {
                1060 | 1070 => has_fan,
                _ => code > 90,
            };
            // With P, which is the time, S is not the time.
            let is_time = block.g.has(40) && block.value(b'P').is_none();
            if !is_time && !block.m.0.iter().any(|code| is_others(code.1)) {
                self.laser.power = Some(s);
            }
        }
        let power = self.laser.power;
        self.tool.power = power.filter(|power| self.is_on() && *power > 0.0);
        self.tool.is_on_without_power = self.is_on() && power.is_none();
    }

    fn motion(&mut self, block: &Block) -> Result<Option<Move>, SourceError> {
        if block.g.has(40) {
            return Ok(Some(self.moved(block, MoveKind::Dwell, self.at, self.z_mm)));
        }
        if block.g.first(&[920, 921, 922]).is_some() {
            return self.set_origin(block).map(|()| None);
        }
        if let Some((at, _)) = block.g.first(&[280, 300]) {
            return Ok(Some(self.home(block, at)));
        }
        let is_upright = self.plane != Plane::Xy;
        let words: &[u8] = if is_upright { b"XYZIJKR" } else { b"XYZIJR" };
        if !block.has_any(words) {
            return Ok(None);
        }
        if block.g.has(530) {
            return self.machine_move(block).map(Some);
        }
        let z_mm = self.target(block, b'Z', self.z_mm.unwrap_or(0.0), self.origin_z_mm);
        let z_mm = z_mm.or(self.z_mm);
        let to = self.target_point(block)?;
        let kind = match self.motion {
            0 => MoveKind::Rapid,
            10 => MoveKind::Line,
            _ if is_upright => self.upright_arc(block, to, z_mm.unwrap_or(0.0))?,
            _ => self.arc(block, to)?,
        };
        if self.motion < 20 && block.has_any(b"IJR") {
            let places = b"IJR".iter().filter(|c| block.value(**c).is_some());
            let at = places
                .map(|&place| block.place(place))
                .min()
                .unwrap_or(block.at);
            let expected = "I, J and R only with G2 or G3";
            let found = format!(
                "the center of an arc with {}",
                codes::name('G', self.motion)
            );
            return Err(self.found(at, found, expected));
        }
        Ok(Some(self.moved(block, kind, to, z_mm)))
    }

    fn moved(&mut self, block: &Block, kind: MoveKind, to: Point, z_mm: Option<f64>) -> Move {
        let from = std::mem::replace(&mut self.at, to);
        let from_z_mm = std::mem::replace(&mut self.z_mm, z_mm);
        Move {
            at: block.at,
            kind,
            from,
            to,
            from_z_mm,
            z_mm,
            tool: self.tool,
            laser: self.laser,
            is_by_m3: self.is_by_m3,
            has_power_word: block.value(b'S').is_some(),
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
        let (center, sweep_rad) = self.circle(block, [self.at, to], self.origin)?;
        checked(self.text, block.at, center)?;
        Ok(MoveKind::Arc { center, sweep_rad })
    }

    /// G2 and G3 in the planes of G18 and G19.
    fn upright_arc(&self, block: &Block, to: Point, to_z_mm: f64) -> Result<MoveKind, SourceError> {
        let is_zx = self.plane == Plane::Zx;
        // Along the plane, and across it.
        let sides = |p: Point| if is_zx { [p.x, p.y] } else { [p.y, p.x] };
        let [[from, across], [end, ends_across]] = [self.at, to].map(sides);
        if across != ends_across {
            let found = "an upright arc (G18 or G19) that also moves sideways";
            return Err(self.found(block.at, found, "an arc within its plane"));
        }
        let ends = [
            Point::new(from, self.z_mm.unwrap_or(0.0)),
            Point::new(end, to_z_mm),
        ];
        let origin = Point::new(sides(self.origin)[0], self.origin_z_mm);
        let (center, sweep_rad) = self.circle(block, ends, origin)?;
        let place = |far: Option<f64>| match far {
            Some(x) if is_zx => checked(self.text, block.at, Point::new(x, across)),
            Some(y) => checked(self.text, block.at, Point::new(across, y)),
            None => Ok(to),
        };
        let [first, second] = far_sides(center, ends[0], sweep_rad).map(place);
        Ok(MoveKind::UprightArc {
            by: [first?, second?],
        })
    }

    /// The center of an arc between two points of its plane, and its sweep.
    fn circle(
        &self,
        block: &Block,
        ends: [Point; 2],
        origin: Point,
    ) -> Result<(Point, f64), SourceError> {
        // Z is the first axis of the plane ZX, and the second one here.
        let clockwise = (self.motion == 20) != (self.plane == Plane::Zx);
        let center = self.center(block, ends, origin, clockwise)?;
        let found = |found| self.found(block.at, found, "ends that fit the arc");
        let sweep_rad = sweep_rad(center, ends[0], ends[1], clockwise).map_err(found)?;
        Ok((
            center,
            sweep_rad + self.further_turns_rad(block, clockwise)?,
        ))
    }

    /// P: the number of turns that an arc begins.
    fn further_turns_rad(&self, block: &Block, clockwise: bool) -> Result<f64, SourceError> {
        let turns = block.value(b'P').unwrap_or(1.0);
        let most = if self.plane == Plane::Xy {
            MAX_TURNS
        } else {
            1.0
        };
        if turns.fract() != 0.0 || !(1.0..=most).contains(&turns) {
            let found = format!("an arc of {turns} turns (P)");
            let expected = format!("a whole number from 1 to {most}");
            return Err(self.found(block.place(b'P'), found, &expected));
        }
        let direction = if clockwise { -1.0 } else { 1.0 };
        Ok(direction * TAU * (turns - 1.0))
    }

    fn center(
        &self,
        block: &Block,
        [from, to]: [Point; 2],
        origin: Point,
        clockwise: bool,
    ) -> Result<Point, SourceError> {
        if let Some(radius) = block.value(b'R') {
            let center = center_by_radius(from, to, radius * self.unit_mm, clockwise);
            let expected = "a radius of at least half their distance";
            return center.map_err(|found| self.found(block.place(b'R'), found, expected));
        }
        let letters = self.plane.center_letters();
        if !block.has_any(&letters) {
            let found = format!("{} without a center", codes::name('G', self.motion));
            let [i, j] = letters.map(char::from);
            return Err(self.found(block.at, found, &format!("{i} and {j}, or R")));
        }
        let [i, j] = letters.map(|letter| block.value(letter).map(|value| value * self.unit_mm));
        Ok(if self.centers_are_absolute {
            let x = i.map_or(from.x, |i| origin.x + i);
            Point::new(x, j.map_or(from.y, |j| origin.y + j))
        } else {
            from + Vec2::new(i.unwrap_or(0.0), j.unwrap_or(0.0))
        })
    }

    /// Whether a block belongs to the active drilling cycle.
    fn drills(&self, block: &Block) -> bool {
        let others = [40, 280, 300, 530, 920, 921, 922];
        self.cycle.is_some() && block.has_any(b"XYZR") && block.g.first(&others).is_none()
    }

    /// G81 and similar: to the place, down to Z, and up again.
    fn drill(
        &mut self,
        block: &Block,
        hand_on: &mut impl FnMut(&Move) -> Result<(), SourceError>,
    ) -> Result<(), SourceError> {
        let mut cycle = self.cycle.unwrap_or_default();
        let here_mm = self.z_mm.unwrap_or(0.0);
        let r_mm = self.target(block, b'R', here_mm, self.origin_z_mm);
        cycle.r_mm = r_mm.or(cycle.r_mm);
        let from_mm = cycle.r_mm.unwrap_or(here_mm);
        let bottom_mm = self.target(block, b'Z', from_mm, self.origin_z_mm);
        cycle.bottom_mm = bottom_mm.or(cycle.bottom_mm);
        self.cycle = Some(cycle);
        let (Some(r_mm), Some(bottom_mm)) = (cycle.r_mm, cycle.bottom_mm) else {
            let expected = "Z (the depth) and R (the start height)";
            return Err(self.found(block.at, "a drilling cycle without a depth", expected));
        };
        if let Some(times) = block.value(b'L').filter(|&value| value != 1.0) {
            let times = format!("a drilling cycle of {times} times (L)");
            return Err(self.found(block.place(b'L'), times, "single holes"));
        }
        let to = self.target_point(block)?;
        let over_mm = |z_mm: Option<f64>| z_mm.map_or(r_mm, |z_mm| z_mm.max(r_mm));
        let up_mm = if self.stays_at_r {
            r_mm
        } else {
            over_mm(cycle.initial_mm)
        };
        for (kind, z_mm) in [
            (MoveKind::Rapid, over_mm(self.z_mm)),
            (MoveKind::Drill, bottom_mm),
            (MoveKind::Rapid, up_mm),
        ] {
            hand_on(&self.moved(block, kind, to, Some(z_mm)))?;
        }
        Ok(())
    }

    /// G92: assigns new coordinates to the current position; G92.1 removes them.
    fn set_origin(&mut self, block: &Block) -> Result<(), SourceError> {
        if !block.g.has(920) {
            (self.origin, self.origin_z_mm) = (Point::ORIGIN, 0.0);
            return Ok(());
        }
        if !block.has_any(b"XYZE") {
            return Err(self.found(block.at, "G92 without an axis", "X, Y or Z after it"));
        }
        let value = |letter| block.value(letter).map(|value| value * self.unit_mm);
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

    /// G28 and G30: the machine's own corner, which is 0 in Marlin.
    fn home(&mut self, block: &Block, at: usize) -> Move {
        self.warn(at, "G28 or G30 homing", "read as a travel to X 0, Y 0");
        let is_all = !block.has_any(b"XYZ");
        let homes = |letter| is_all || block.value(letter).is_some();
        let axis = |letter, here| if homes(letter) { 0.0 } else { here };
        let to = Point::new(axis(b'X', self.at.x), axis(b'Y', self.at.y));
        let z_mm = self.z_mm.filter(|_| !homes(b'Z'));
        self.moved(block, MoveKind::Rapid, to, z_mm)
    }

    /// G53: a move in machine coordinates, which the file does not define.
    fn machine_move(&mut self, block: &Block) -> Result<Move, SourceError> {
        self.warn(block.at, "G53 move", "read as a travel with the pen up");
        let value = |letter, here| {
            block
                .value(letter)
                .map_or(here, |value| value * self.unit_mm)
        };
        let to = Point::new(value(b'X', self.at.x), value(b'Y', self.at.y));
        let to = checked(self.text, block.at, to)?;
        Ok(self.moved(block, MoveKind::Rapid, to, None))
    }
}

/// The plane of arcs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Plane {
    /// G17.
    Xy,
    /// G18.
    Zx,
    /// G19.
    Yz,
}

impl Plane {
    /// The letters of an arc's center, Z last.
    const fn center_letters(self) -> [u8; 2] {
        match self {
            Self::Xy => *b"IJ",
            Self::Zx => *b"IK",
            Self::Yz => *b"JK",
        }
    }
}

/// The parameters of a drilling cycle that persist from hole to hole: heights, in mm.
#[derive(Clone, Copy, Debug, Default)]
#[expect(clippy::struct_field_names, reason = "the unit of each")]
struct DrillCycle {
    /// The height of the tool before.
    initial_mm: Option<f64>,
    /// The start height of drilling.
    r_mm: Option<f64>,
    /// The depth.
    bottom_mm: Option<f64>,
}

/// The S of M300 if it may be a servo angle, or 255 for none: a beep has a higher one, and P.
fn servo_angle(block: &Block) -> Option<f64> {
    let s = block
        .value(b'S')
        .filter(|value| (0.0..=180.0).contains(value) || *value == SERVO_OFF);
    s.filter(|_| block.m.has(3000) && block.value(b'P').is_none())
}

/// The largest number of turns of an arc.
const MAX_TURNS: f64 = 1000.0;
/// The S of M300 that relaxes a servo.
const SERVO_OFF: f64 = 255.0;
/// Letters of rotary axes, of secondary axes, and of the extruder.
const OTHER_AXES: &[u8] = b"ABCEUVW";
