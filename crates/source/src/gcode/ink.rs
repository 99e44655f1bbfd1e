//! The ink that moves leave.

use super::ink_rule::InkRule;
use super::machine::{Move, MoveKind, ToolState};
use crate::arc::Arc;
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::sketch::Sketch;

/// Draws the moves of a program.
#[derive(Debug)]
pub(super) struct Inker<'s, 'a> {
    sketch: &'s mut Sketch<'a>,
    rule: InkRule,
    /// What the last ink was drawn with.
    tool: Option<ToolState>,
    /// The pen was lowered here, or the laser waits, and has drawn nothing yet.
    lowered: Option<Move>,
    /// Where layers below full power begin.
    dim: Vec<usize>,
}

impl<'s, 'a> Inker<'s, 'a> {
    pub(super) const fn new(sketch: &'s mut Sketch<'a>, rule: InkRule) -> Self {
        Self {
            sketch,
            rule,
            tool: None,
            lowered: None,
            dim: Vec::new(),
        }
    }

    pub(super) fn draw(&mut self, it: &Move) -> Result<(), SourceError> {
        let is_arc = matches!(it.kind, MoveKind::Arc { .. });
        match (self.inks(it), it.from == it.to && !is_arc) {
            (true, true) => {
                self.stand(it);
                Ok(())
            }
            (true, false) => self.ink(it),
            (false, stands) => {
                if let Some(lowered) = self.lowered.take() {
                    self.dot(lowered)?;
                }
                if !stands {
                    self.sketch.lift();
                }
                Ok(())
            }
        }
    }

    /// Tells of what the whole drawing has shown.
    pub(super) fn finish(mut self) -> Result<(), SourceError> {
        if let Some(waits) = self.lowered.take_if(|it| it.kind == MoveKind::Dwell) {
            self.dot(waits)?;
        }
        for at in self.dim {
            let instead =
                "burned at full power, for this laser is on or off; draw it faster instead";
            self.sketch.warn(at, "weaker layer", instead);
        }
        Ok(())
    }

    fn inks(&self, it: &Move) -> bool {
        match self.rule {
            InkRule::Laser { .. } => it.kind != MoveKind::Rapid && it.tool.power.is_some(),
            InkRule::Height { below_mm, .. } => it.z_mm.is_some_and(|z_mm| z_mm < below_mm),
            InkRule::Servo { up } => it.tool.servo.is_some_and(|angle| angle != up),
            InkRule::Plain => it.kind != MoveKind::Rapid,
        }
    }

    /// The pen touches the paper, or the laser burns, where it is.
    fn stand(&mut self, it: &Move) {
        let laser = matches!(self.rule, InkRule::Laser { .. });
        let waits = it.kind == MoveKind::Dwell;
        let is_nothing = self.rule == InkRule::Plain || (laser && !waits);
        if !is_nothing && !self.sketch.ends_at(it.to) {
            // A stroke from here may follow: then the wait is only for the pen to come down.
            self.lowered = Some(*it);
        }
    }

    fn dot(&mut self, mut it: Move) -> Result<(), SourceError> {
        if !matches!(self.rule, InkRule::Laser { .. }) {
            // That of going down is not the speed of lines.
            (it.tool.feed, it.tool.speed_mm_s) = (None, None);
        }
        self.take(&it)?;
        self.sketch.dot(it.to)
    }

    fn ink(&mut self, it: &Move) -> Result<(), SourceError> {
        self.take(it)?;
        self.lowered = None;
        match it.kind {
            MoveKind::Arc { center, sweep_rad } => {
                let arc = Arc::between(center, it.from, sweep_rad, it.to);
                self.sketch.arc(it.at, &arc)
            }
            _ => self.sketch.line(it.from, it.to),
        }
    }

    /// Uses the layer of a move's tool.
    fn take(&mut self, it: &Move) -> Result<(), SourceError> {
        let tool = it.tool;
        if self.tool == Some(tool) {
            return Ok(());
        }
        let before = self.tool.replace(tool);
        let InkRule::Laser { full } = self.rule else {
            return self.take_pen(it, before);
        };
        let name = [("T", tool.number), ("S", tool.power), ("F", tool.feed)];
        if self.use_layer(&name, tool)? && tool.power.is_some_and(|it| it < full) {
            self.dim.push(it.at);
        }
        Ok(())
    }

    fn take_pen(&mut self, it: &Move, before: Option<ToolState>) -> Result<(), SourceError> {
        let tool = it.tool;
        if before.is_none_or(|before| before.number != tool.number) {
            self.use_layer(&[("T", tool.number)], tool)?;
        }
        let layer = self.sketch.layer();
        let first = layer.speed_mm_s;
        layer.speed_mm_s = first.or(tool.speed_mm_s);
        if first.is_some() && tool.speed_mm_s.is_some() && tool.speed_mm_s != first {
            let instead = "drawn with the first speed of its tool";
            self.sketch.warn(it.at, "speed change", instead);
        }
        Ok(())
    }

    /// Whether that layer is new.
    fn use_layer(
        &mut self,
        name: &[(&str, Option<f64>)],
        tool: ToolState,
    ) -> Result<bool, SourceError> {
        let words = name
            .iter()
            .filter_map(|(letter, value)| Some(format!("{letter}{}", (*value)?)));
        let words: Vec<String> = words.collect();
        self.sketch.use_layer(Layer {
            name: words.join(" "),
            speed_mm_s: tool.speed_mm_s,
            ..Layer::default()
        })?;
        Ok(self.sketch.layer().is_empty())
    }
}
