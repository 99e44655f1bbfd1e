//! The ink of moves.

use super::ink_rule::InkRule;
use super::laser::LaserSwitch;
use super::machine::{Move, MoveKind, ToolState};
use super::ramp;
use super::servo::ServoCode;
use crate::arc::Arc;
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::sketch::Sketch;

/// A renderer of moves.
#[derive(Debug)]
pub(super) struct Inker<'s, 'a> {
    sketch: &'s mut Sketch<'a>,
    rule: InkRule,
    /// The state of the laser; `None` for a pen.
    switch: Option<LaserSwitch>,
    /// The tool of the last ink.
    tool: Option<ToolState>,
    /// Whether something moved along X or Y.
    has_moved: bool,
    /// The place where the pen was lowered, or the laser waits, and has drawn nothing yet.
    lowered: Option<Move>,
    /// The warnings about layers below full power.
    dim: Vec<DimLayer>,
}

impl<'s, 'a> Inker<'s, 'a> {
    pub(super) const fn new(
        sketch: &'s mut Sketch<'a>,
        rule: InkRule,
        switch: Option<LaserSwitch>,
    ) -> Self {
        Self {
            sketch,
            rule,
            switch,
            tool: None,
            has_moved: false,
            lowered: None,
            dim: Vec::new(),
        }
    }

    /// Draws a move; a ramp through the height of the paper only where the pen is down.
    pub(super) fn draw(&mut self, motion: &Move) -> Result<(), SourceError> {
        let paper_mm = match self.rule {
            InkRule::Height { below_mm, .. } => below_mm,
            InkRule::HighPen { above_mm } => above_mm,
            _ => return self.draw_part(motion),
        };
        let parts = ramp::parts(motion, paper_mm);
        parts
            .iter()
            .flatten()
            .try_for_each(|part| self.draw_part(part))
    }

    fn draw_part(&mut self, motion: &Move) -> Result<(), SourceError> {
        if motion.kind == MoveKind::Drill && !matches!(self.rule, InkRule::Height { .. }) {
            let instead = "left out, because Z does not lift the pen";
            self.sketch.warn(motion.at, "drilled hole", instead);
            return Ok(());
        }
        let is_still = motion.is_still();
        self.has_moved |= !is_still;
        // A waiting tool may continue from here: only a dot would be burned.
        let inks = self.inks(motion) && (is_still || !self.stays_dark(motion));
        if !inks && motion.is_line() && motion.has_power_word && motion.laser.is_switched_off() {
            let instead = "left out, because M5 or M107 is active there; put M3 or M4 before it";
            self.sketch.warn(motion.at, "powered line", instead);
        }
        match (inks, is_still) {
            (true, true) => {
                self.stand(motion);
                Ok(())
            }
            (true, false) => self.ink(motion),
            (false, is_still) => {
                if let Some(lowered) = self.lowered.take() {
                    self.dot(lowered)?;
                }
                if !is_still {
                    self.sketch.lift();
                }
                Ok(())
            }
        }
    }

    /// Reports what the whole drawing has shown.
    pub(super) fn finish(mut self) -> Result<(), SourceError> {
        if let Some(waits) = self
            .lowered
            .take_if(|lowered| lowered.kind == MoveKind::Dwell)
        {
            self.dot(waits)?;
        }
        if self.switch.is_none() {
            return Ok(());
        }
        let strong = self.dim.iter().filter(|item| {
            item.speed_mm_s
                .is_none_or(|speed_mm_s| speed_mm_s > FASTEST_MM_S)
        });
        let too_strong = strong.min_by(|a, b| a.share.total_cmp(&b.share));
        if let Some(first) = self.dim.first() {
            let instead = "burned faster instead, because this laser is only on or off";
            self.sketch.warn(first.at, "weaker layer", instead);
        }
        if let Some(layer) = too_strong {
            let InkRule::Laser { full, .. } = self.rule else {
                return Ok(());
            };
            let percent = 100.0 * layer.share;
            let times = layer
                .speed_mm_s
                .map_or(1.0 / layer.share, |mm_s| mm_s / FASTEST_MM_S);
            let instead = format!(
                "S{} is {percent:.3} % of full power ({full}), and the arm is too slow for that: it burns {times:.1} times as much; omit the layer with what.only",
                layer.share * full
            );
            self.sketch
                .warn(layer.at, "layer burned too strongly", &instead);
        }
        Ok(())
    }

    fn inks(&self, motion: &Move) -> bool {
        match self.rule {
            InkRule::Laser { travel, .. } => {
                let least = if motion.kind == MoveKind::Dwell {
                    travel
                } else {
                    0.0
                };
                motion.kind != MoveKind::Rapid
                    && motion.tool.power.is_some_and(|power| power > least)
            }
            InkRule::Height { below_mm, .. } => motion.z_mm.is_some_and(|z_mm| z_mm < below_mm),
            InkRule::HighPen { above_mm } => motion.z_mm.is_some_and(|z_mm| z_mm > above_mm),
            InkRule::Switch => motion.kind != MoveKind::Rapid && motion.tool.is_on_without_power,
            InkRule::Servo { code, up, .. } => {
                motion.tool.angle(code).is_some_and(|angle| angle != up)
            }
            InkRule::Plain { .. } => motion.kind != MoveKind::Rapid,
            InkRule::Dark => false,
        }
    }

    /// Whether a laser burns nothing in a move in which a pen would draw; warns if so.
    fn stays_dark(&mut self, motion: &Move) -> bool {
        let Some(switch) = self.switch else {
            return false;
        };
        let is_dwell = motion.kind == MoveKind::Dwell;
        let is_by_z = matches!(self.rule, InkRule::Height { .. } | InkRule::HighPen { .. });
        let (what, instead) = if motion.is_still() && (is_by_z || !is_dwell) {
            let instead = "not burned, because Z and drilling cycles do not switch a laser on";
            ("hole", instead)
        } else if switch.is_on(motion) {
            return false;
        } else if is_dwell && switch.is_spindle_dwell(motion) {
            let instead = "not burned (G4 before the first line, above all lines or of a drill)";
            ("spindle dwell", instead)
        } else {
            let instead = "not burned, because the laser is off there (G0, M5, M107 or S0)";
            ("dark move", instead)
        };
        self.sketch.warn(motion.at, what, instead);
        true
    }

    /// Makes a dot where the pen touches the paper or the laser burns.
    fn stand(&mut self, motion: &Move) {
        let laser = matches!(self.rule, InkRule::Laser { .. });
        let waits = motion.kind == MoveKind::Dwell;
        let is_unlifted = matches!(self.rule, InkRule::Plain { .. } | InkRule::Switch);
        let is_nothing = is_unlifted || (laser && !waits);
        if !is_nothing && !self.sketch.ends_at(motion.to) {
            // A stroke from here may follow: then the wait is only for the pen to come down.
            self.lowered = Some(*motion);
        }
    }

    fn dot(&mut self, mut motion: Move) -> Result<(), SourceError> {
        if !self.has_moved && self.has_trial() {
            let instead = "left out, before the first move (M300)";
            self.sketch.warn(motion.at, "pen test", instead);
            return Ok(());
        }
        if self.stays_dark(&motion) {
            return Ok(());
        }
        if !matches!(self.rule, InkRule::Laser { .. }) {
            // The speed of lowering is not that of lines.
            (motion.tool.feed, motion.tool.speed_mm_s) = (None, None);
        }
        self.take(&motion)?;
        self.sketch.dot(motion.to)
    }

    /// Whether programs for this tool start with a pen test and then wait for a person.
    const fn has_trial(&self) -> bool {
        matches!(
            self.rule,
            InkRule::Servo {
                code: ServoCode::M300,
                ..
            }
        )
    }

    fn ink(&mut self, motion: &Move) -> Result<(), SourceError> {
        self.take(motion)?;
        self.lowered = None;
        match motion.kind {
            MoveKind::Arc { center, sweep_rad } => {
                let arc = Arc::between(center, motion.from, sweep_rad, motion.to);
                self.sketch.arc(motion.at, &arc)
            }
            MoveKind::UprightArc {
                by: [first, second],
            } => {
                let corners = [motion.from, first, second, motion.to];
                let mut lines = corners.windows(2).filter(|pair| pair[0] != pair[1]);
                lines.try_for_each(|line| self.sketch.line(line[0], line[1]))
            }
            _ => self.sketch.line(motion.from, motion.to),
        }
    }

    /// Uses the layer of a move's tool.
    fn take(&mut self, motion: &Move) -> Result<(), SourceError> {
        let tool = motion.tool;
        if self.tool == Some(tool) {
            return Ok(());
        }
        let before = self.tool.replace(tool);
        let InkRule::Laser { full, .. } = self.rule else {
            return self.take_pen(motion, before);
        };
        let name = [("T", tool.number), ("S", tool.power), ("F", tool.feed)];
        let share = tool.power.map_or(1.0, |power| power / full);
        let speed_mm_s = tool.speed_mm_s.map(|speed_mm_s| speed_mm_s / share);
        let is_new = self.use_layer(
            &name,
            speed_mm_s.map(|speed_mm_s| speed_mm_s.min(FASTEST_MM_S)),
        )?;
        if is_new && share < FULL {
            self.dim.push(DimLayer {
                at: motion.at,
                share,
                speed_mm_s,
            });
        }
        Ok(())
    }

    fn take_pen(&mut self, motion: &Move, before: Option<ToolState>) -> Result<(), SourceError> {
        let tool = motion.tool;
        if before.is_none_or(|before| before.number != tool.number) {
            self.use_layer(&[("T", tool.number)], tool.speed_mm_s)?;
        }
        let layer = self.sketch.layer();
        let first = layer.speed_mm_s;
        layer.speed_mm_s = first.or(tool.speed_mm_s);
        if first.is_some() && tool.speed_mm_s.is_some() && tool.speed_mm_s != first {
            let instead = "drawn with the first speed of the tool";
            self.sketch.warn(motion.at, "speed change", instead);
        }
        Ok(())
    }

    /// Whether that layer is new.
    fn use_layer(
        &mut self,
        name: &[(&str, Option<f64>)],
        speed_mm_s: Option<f64>,
    ) -> Result<bool, SourceError> {
        let words = name
            .iter()
            .filter_map(|(letter, value)| Some(format!("{letter}{}", (*value)?)));
        let words: Vec<String> = words.collect();
        self.sketch.use_layer(Layer {
            name: words.join(" "),
            speed_mm_s,
            is_burned: matches!(self.rule, InkRule::Laser { .. }),
            ..Layer::default()
        })?;
        Ok(self.sketch.layer().is_empty())
    }
}

/// A layer to be burned below full power.
#[derive(Debug)]
struct DimLayer {
    at: usize,
    share: f64,
    /// The speed at which full power burns equally, in mm/s, if the file has a speed.
    speed_mm_s: Option<f64>,
}

/// The largest speed of the arm while it writes, in mm/s.
const FASTEST_MM_S: f64 = 200.0;
/// The threshold of full power.
const FULL: f64 = 0.999;
