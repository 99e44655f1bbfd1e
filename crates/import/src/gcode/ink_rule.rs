//! The rule that distinguishes drawing moves from travel, inferred from the whole file.

use super::grbl_servo::GrblServoStatistics;
use super::high_pen::HighStatistics;
use super::laser::{LaserState, LaserSwitch};
use super::machine::{Move, MoveKind, ToolState};
use super::servo::{ServoCode, ServoStatistics, UpSource};
use super::spindle::SpindleStatistics;
use super::switch::SwitchStatistics;
use super::zero::ZeroStatistics;
use crate::options::{GcodeTool, ReadOptions};
use crate::warning::Warnings;

/// The rule of drawing moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum InkRule {
    /// A laser, or a pen lowered by M3: G1 to G3 while M3, M4 or M106 is active with S above 0.
    /// `full` is the S of full power; up to the S `travel` a waiting pen is up.
    Laser {
        full: f64,
        travel: f64,
        is_at_heights: bool,
    },
    /// A pen or a mill: every move that ends below a height.
    Height { below_mm: f64, source: HeightSource },
    /// A pen whose Z points down: every move that ends above a height.
    HighPen { above_mm: f64 },
    /// A laser or a pen switched by M3 without S: G1 to G3 while it is on.
    Switch,
    /// A pen lifted by a servo: every move with another angle than that of the raised pen.
    Servo {
        code: ServoCode,
        up: f64,
        source: UpSource,
    },
    /// No indication: G1 to G3. `has_switch` if the file has M3, M5 or S nevertheless.
    Plain { has_switch: bool },
    /// A laser that is never on with power: nothing.
    Dark,
}

/// The source of the height below which a pen draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HeightSource {
    /// 0: there are moves below and others above.
    Zero,
    /// 0, and lines at 0 are left out.
    AboveZero,
    /// Just above 0: there are lines at 0, too.
    AtZero,
    /// 0: all lines are below.
    BelowZero,
    /// Below the rapid moves (G0).
    Rapids,
    /// Just above the lowest move.
    Lowest,
}

impl InkRule {
    /// Reports the rule: as a note, or as a warning if the file is ambiguous.
    pub(super) fn report(self, warnings: &mut Warnings<'_>, gcode: Option<GcodeTool>) {
        let Some((what, draws)) = self.decision() else {
            return;
        };
        if self.is_clear() {
            warnings.note(what, &draws);
        } else if gcode.is_some() {
            warnings.add(None, what, &draws);
        } else {
            let draws = format!("{draws}; what.gcode chooses laser, pen or mill instead");
            warnings.add(None, what, &draws);
        }
    }

    /// Whether the file can hardly mean anything else.
    const fn is_clear(self) -> bool {
        match self {
            Self::Laser { is_at_heights, .. } => !is_at_heights,
            Self::Height { source, .. } => matches!(source, HeightSource::Zero),
            _ => false,
        }
    }

    /// What the file is, and which moves draw; `None` if [nothing](Self::nothing) does.
    fn decision(self) -> Option<(&'static str, String)> {
        let (what, draws) = match self {
            Self::Laser { is_at_heights, .. } if is_at_heights => (
                "laser at several heights",
                "everything with the laser on (M3, M4 or M106) draws, at any Z",
            ),
            Self::Laser { .. } => (
                "G-code for a laser",
                "G1, G2 and G3 draw while M3, M4 or M106 is active with S above 0",
            ),
            Self::Height { below_mm, source } => return Some(source.decision(below_mm)),
            Self::HighPen { above_mm } => {
                let draws = format!("drawn where Z is above {above_mm:.2} mm");
                return Some(("file with travels (G0) below its lines", draws));
            }
            Self::Switch => (
                "file without powers (S)",
                "G1, G2 and G3 draw while M3, M4 or M106 is active",
            ),
            Self::Servo { code, up, source } => {
                let draws = format!("S{up} read as pen up, {}", source.reason());
                return Some((code.what(), draws));
            }
            Self::Plain { has_switch } if has_switch => (
                "file with ambiguous pen commands (M3, M5 or S)",
                "G1, G2 and G3 draw, G0 travels",
            ),
            Self::Plain { .. } => (
                "file without commands for a laser or a pen (M3, Z)",
                "G1, G2 and G3 draw, G0 travels",
            ),
            Self::Dark => return None,
        };
        Some((what, draws.to_owned()))
    }

    /// The reason why there is no ink.
    pub(super) const fn nothing(self, burns: bool) -> &'static str {
        match self {
            Self::Laser { .. } | Self::Switch => "no move with the laser on",
            Self::Height { .. } | Self::HighPen { .. } | Self::Servo { .. } if burns => {
                "no line with the laser on"
            }
            Self::Height { .. } | Self::HighPen { .. } => "no move with the pen down",
            Self::Servo { .. } => "no move with the servo down",
            Self::Plain { .. } => "no moves by G1, G2 or G3",
            Self::Dark if burns => {
                "the laser has no power in any line (M3, M4 or M106, and S above 0 if the file uses S)"
            }
            Self::Dark => {
                "the file is for a laser that has no power in any line (M3, M4 or M106, and S above 0); what.gcode pen draws it"
            }
        }
    }
}

impl HeightSource {
    fn decision(self, below_mm: f64) -> (&'static str, String) {
        let lowest_mm = match self {
            Self::Lowest => below_mm - SAME_HEIGHT_MM,
            _ => below_mm,
        };
        let what = match self {
            Self::Zero => "G-code for a pen or a mill",
            Self::AboveZero => {
                let draws = "left out, because only lines below Z 0 are drawn";
                return ("file with lines at Z 0", draws.to_owned());
            }
            Self::AtZero => {
                let draws = "drawn like those below, because the tool moves down to them";
                return ("file with lines at Z 0", draws.to_owned());
            }
            Self::BelowZero => "file with all lines below Z 0",
            Self::Rapids | Self::Lowest if lowest_mm < 0.0 => "file with travels below Z 0",
            Self::Rapids | Self::Lowest => "file without moves below Z 0",
        };
        (what, format!("drawn where Z is below {below_mm:.2} mm"))
    }
}

/// Statistics of the moves of a file.
#[derive(Debug, Default)]
pub(super) struct MoveStatistics {
    /// The lines that a laser would burn, and the places where it would wait.
    lines: BurnStatistics,
    dwells: BurnStatistics,
    /// Heights of rapid moves along X or Y, since the laser or spindle was first on.
    rapids: Range,
    /// Heights of moves at a feed rate.
    feeds: Range,
    /// Heights of all moves, including those along Z.
    all: Range,
    /// The current height, if known.
    z_mm: Option<f64>,
    has_feeds: bool,
    /// End heights of downward moves along Z only at a feed rate while the tool is on.
    plunges: Range,
    has_drill_cycle: bool,
    /// Whether it came down by a move along Z only.
    descends: bool,
    zero: ZeroStatistics,
    spindle: SpindleStatistics,
    /// The S above 0 of rapid moves.
    travel_powers: Range,
    /// The S above 0 of moves at a feed rate.
    line_powers: Range,
    m280: ServoStatistics,
    m300: ServoStatistics,
    m3: GrblServoStatistics,
    high: HighStatistics,
    switch: SwitchStatistics,
    /// The largest S, in force or not.
    most_power: f64,
}

impl MoveStatistics {
    pub(super) fn count(&mut self, motion: &Move) {
        self.all.count(motion.z_mm);
        self.most_power = self.most_power.max(motion.laser.power.unwrap_or(0.0));
        if let Some(to_mm) = motion.z_mm {
            let from_mm = self.z_mm.replace(to_mm).unwrap_or(to_mm);
            let descends = motion.is_still() && from_mm - to_mm >= SAME_HEIGHT_MM;
            self.descends |= descends;
            if descends && motion.kind == MoveKind::Line && motion.tool.power.is_some() {
                self.plunges.count(motion.z_mm);
            }
            self.zero.count(motion, from_mm, to_mm);
            self.spindle.count_rise(motion, to_mm - from_mm);
        }
        self.spindle.count(motion);
        self.m3.count(motion);
        self.has_drill_cycle |= motion.kind == MoveKind::Drill;
        if motion.kind == MoveKind::Dwell {
            self.dwells.count(motion);
        }
        if motion.is_still() {
            return;
        }
        self.high.count(motion);
        self.switch.count(motion);
        self.m280.count(motion, ServoCode::M280);
        self.m300.count(motion, ServoCode::M300);
        if motion.kind == MoveKind::Rapid {
            self.travel_powers.count(motion.tool.power);
            return self.rapids.count(motion.z_mm);
        }
        self.line_powers.count(motion.tool.power);
        self.has_feeds = true;
        self.feeds.count(motion.z_mm);
        self.lines.count(motion);
    }

    /// The largest set of lines that a laser may burn; `end` is its state at the end of the
    /// program.
    pub(super) const fn laser_switch(&self, end: LaserState) -> LaserSwitch {
        LaserSwitch {
            end,
            first_line_at: self.lines.first_at,
            highest_line_mm: self.lines.heights.highest,
            is_drill: self.is_drill(),
        }
    }

    /// Chooses the rule; `end` is the tool and the laser at the end of the program.
    pub(super) fn rule(
        &self,
        text: &[u8],
        end: (ToolState, LaserState),
        options: &ReadOptions,
    ) -> InkRule {
        let laser = end.1;
        let plain = InkRule::Plain {
            has_switch: !laser.is_unknown(),
        };
        match options.gcode {
            Some(GcodeTool::Laser) => self.laser(text, laser).unwrap_or(InkRule::Dark),
            Some(GcodeTool::Pen) => self.pen(text, &end).unwrap_or(plain),
            Some(GcodeTool::Mill) => self.height().or(self.lifted()).unwrap_or(plain),
            None if self.has_no_power(laser, options.burns) => InkRule::Dark,
            None => self.inferred(text, &end, options.burns).unwrap_or(plain),
        }
    }

    /// The rule of a file that does not say what it controls.
    fn inferred(
        &self,
        text: &[u8],
        (tool, laser): &(ToolState, LaserState),
        burns: bool,
    ) -> Option<InkRule> {
        let height = self.height();
        if height.is_none()
            && let Some(servo) = self.grbl_servo(text, tool)
        {
            return Some(servo);
        }
        if self.full().is_some() {
            let is_laser = height.is_none() || !self.is_mill();
            return if is_laser {
                self.laser(text, *laser)
            } else {
                height
            };
        }
        let by_pen = self.servo(text, tool).or(self.high.rule()).or(height);
        by_pen.or(self.switch.rule(burns)).or(self.lifted())
    }

    /// The rule of a file for a laser, if it is ever on with power.
    fn laser(&self, text: &[u8], laser: LaserState) -> Option<InkRule> {
        let Some(most) = self.full() else {
            let is_switched = self.switch.has_on && laser.power.is_none();
            return is_switched.then_some(InkRule::Switch);
        };
        let burnt = self.burns();
        let full = commented_full(text).unwrap_or_else(|| scale(most));
        Some(InkRule::Laser {
            full: full.max(most),
            travel: self.travel_power(),
            is_at_heights: burnt.lowest < burnt.highest,
        })
    }

    /// The rule of a file for a pen: lifted by a servo or by Z, or else by M3 and M5.
    fn pen(&self, text: &[u8], (tool, laser): &(ToolState, LaserState)) -> Option<InkRule> {
        let by_servo = self.grbl_servo(text, tool).or(self.servo(text, tool));
        let by_height = by_servo.or(self.high.rule()).or(self.height());
        let by_z = by_height.or(self.switch.rule(false)).or(self.lifted());
        by_z.or_else(|| self.full().and_then(|_| self.laser(text, *laser)))
    }

    /// Whether a file for a laser never has power: the laser is never on, or each S is 0. The moves
    /// of a pen may be meant nevertheless, unless M3 and S 0 say that they are not.
    fn has_no_power(&self, laser: LaserState, burns: bool) -> bool {
        let is_off = self.full().is_none() && (laser.power.is_some() || !self.switch.has_on);
        if burns {
            return is_off && !laser.is_unknown() && !self.is_drill();
        }
        let by_z = self.height().or(self.high.rule()).or(self.lifted());
        let has_s0_only = laser.power.is_some() && self.most_power <= 0.0;
        is_off && laser.is_on.is_some() && has_s0_only && by_z.is_none()
    }

    /// A pen that is raised with less S than lowered is drawn like a laser.
    fn grbl_servo(&self, text: &[u8], tool: &ToolState) -> Option<InkRule> {
        let (up, source) = self
            .m3
            .up(text, tool)
            .filter(|_| self.travel_power() == 0.0)?;
        let code = ServoCode::M3;
        Some(InkRule::Servo { code, up, source })
    }

    /// The largest S with which a laser would burn.
    fn full(&self) -> Option<f64> {
        let dwells = self.dwells.full.filter(|_| !self.is_drill());
        let all = [self.lines.full, dwells].into_iter().flatten();
        all.reduce(f64::max)
    }

    /// Heights of what a laser would burn: of its dots only if it burns no lines, because a spindle
    /// waits above its work.
    const fn burns(&self) -> &Range {
        if self.lines.full.is_some() {
            &self.lines.heights
        } else {
            &self.dwells.heights
        }
    }

    /// The rule of a mill, whose spindle turns all the time and which travels above its work.
    fn is_mill(&self) -> bool {
        self.has_drill_cycle
            || self.rapids.lowest > self.burns().highest
            || self.spindle.is_spindle()
    }

    /// Whether Z moves the tool into the work: by a drilling cycle, or below all moves along X or
    /// Y.
    const fn is_drill(&self) -> bool {
        let travels_mm = self.rapids.lowest.min(self.feeds.lowest);
        self.has_drill_cycle || self.plunges.lowest < travels_mm
    }

    /// If all travels have less power than all lines, a servo holds the pen up with that power.
    fn travel_power(&self) -> f64 {
        let most = self.travel_powers.highest.max(0.0);
        if most < self.line_powers.lowest && self.line_powers.lowest.is_finite() {
            most
        } else {
            0.0
        }
    }

    fn servo(&self, text: &[u8], end: &ToolState) -> Option<InkRule> {
        let of = |servo: &ServoStatistics, code| {
            let (up, source) = servo.up(text, code, end.angle(code))?;
            Some(InkRule::Servo { code, up, source })
        };
        of(&self.m280, ServoCode::M280).or_else(|| of(&self.m300, ServoCode::M300))
    }

    /// The height of the highest move along X or Y.
    const fn highest_line_mm(&self) -> f64 {
        self.rapids.highest.max(self.feeds.highest)
    }

    fn height(&self) -> Option<InkRule> {
        let (lowest, rapids) = (self.all.lowest, self.rapids.lowest);
        let of_lines = self.highest_line_mm();
        let highest = if self.has_feeds {
            of_lines
        } else {
            self.all.highest
        };
        if lowest >= highest {
            return None;
        }
        let (below_mm, source) = if lowest < 0.0 && highest >= 0.0 {
            self.about_zero(of_lines)
        } else if lowest < rapids && rapids.is_finite() {
            (rapids, HeightSource::Rapids)
        } else if lowest < 0.0 && self.all.highest >= 0.0 {
            (0.0, HeightSource::BelowZero)
        } else {
            (lowest + SAME_HEIGHT_MM, HeightSource::Lowest)
        };
        Some(InkRule::Height { below_mm, source })
    }

    /// The rule of a file that comes down to the single height of all its lines and travels by
    /// moves along Z only: only Z shows when the pen is down, and every move meanwhile draws,
    /// including G0.
    fn lifted(&self) -> Option<InkRule> {
        let (lowest, highest) = (self.all.lowest, self.all.highest);
        let of_lines = self.highest_line_mm();
        if !self.descends || of_lines > lowest {
            return None;
        }
        let (below_mm, source) = if lowest < 0.0 && highest >= 0.0 {
            (0.0, HeightSource::Zero)
        } else {
            (lowest + SAME_HEIGHT_MM, HeightSource::Lowest)
        };
        Some(InkRule::Height { below_mm, source })
    }

    /// The rule of a file with moves below 0.
    fn about_zero(&self, highest: f64) -> (f64, HeightSource) {
        if !self.zero.has_lines || highest < SAME_HEIGHT_MM {
            (0.0, HeightSource::Zero)
        } else if self.zero.has_ink() && self.rapids.lowest >= SAME_HEIGHT_MM {
            (SAME_HEIGHT_MM, HeightSource::AtZero)
        } else {
            (0.0, HeightSource::AboveZero)
        }
    }
}

/// What a laser would burn.
#[derive(Debug, Default)]
struct BurnStatistics {
    /// The largest S.
    full: Option<f64>,
    heights: Range,
    /// The position of the first one in the text.
    first_at: Option<usize>,
}

impl BurnStatistics {
    fn count(&mut self, motion: &Move) {
        if let Some(power) = motion.tool.power {
            self.full = Some(self.full.map_or(power, |full| full.max(power)));
            self.heights.count(motion.z_mm);
            self.first_at.get_or_insert(motion.at);
        }
    }
}

#[derive(Debug)]
struct Range {
    lowest: f64,
    highest: f64,
}

impl Range {
    fn count(&mut self, value: Option<f64>) {
        if let Some(value) = value {
            self.lowest = self.lowest.min(value);
            self.highest = self.highest.max(value);
        }
    }
}

impl Default for Range {
    fn default() -> Self {
        Self {
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
        }
    }
}

/// The S of full power, if only the largest S is known: that one, unless it is tiny in any scale of
/// controllers, of which 255 is the smallest that is not 1.
fn scale(most: f64) -> f64 {
    if most > 1.0 && most < 26.0 {
        255.0
    } else {
        most
    }
}

/// The S of full power from comments: `; Cut @ 600 mm/min, 20% power` before S200.
fn commented_full(text: &[u8]) -> Option<f64> {
    let mut percent = None;
    for line in text.split(|&byte| byte == b'\n') {
        // Only a power in a comment counts.
        if percent.is_none() && !line.starts_with(b";") {
            continue;
        }
        let line = String::from_utf8_lossy(line);
        if line.starts_with(';') {
            let before = line
                .split("% power")
                .next()
                .filter(|part| part.len() < line.len());
            let number = before.and_then(|before| before.rsplit([' ', ',']).next());
            percent = number
                .and_then(|number| number.parse::<f64>().ok())
                .or(percent);
            continue;
        }
        let power = line.split_once('S').map(|(_, rest)| rest.trim_end());
        let digits = power.and_then(|power| {
            power
                .split(|c: char| c != '.' && !c.is_ascii_digit())
                .next()
        });
        let power = digits
            .and_then(|digit| digit.parse::<f64>().ok())
            .filter(|digit| *digit > 0.0);
        if let (Some(percent), Some(power)) = (percent.filter(|percent| *percent > 0.0), power) {
            return Some((100.0 * power / percent).round());
        }
    }
    None
}

/// The smallest height difference of a sheet.
pub(super) const SAME_HEIGHT_MM: f64 = 0.1;
