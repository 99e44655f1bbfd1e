//! Calibration as an engine: the pendant, the touches and their result.

use std::io;
use std::path::PathBuf;
use std::time::Duration;

use crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use dobot_api::{Backlash, CalibrationFile, State};
use dobot_arm::{Joints, Tool};
use dobot_calibrate::{Fit, FitError, Procedure, Trust, found, residuals_svg};
use ratatui::Frame;

use super::kept::Kept;
use super::screen;
use crate::output;
use crate::pendant::{Panel, Pendant};

/// Lets a person touch the points of the sheet.
#[derive(Debug)]
pub(crate) struct Toucher {
    pub(super) pendant: Pendant,
    pub(super) procedure: Procedure,
    /// The result of the touches.
    pub(super) outcome: Result<Fit, FitError>,
    pub(super) kept: Kept,
    backlash: Backlash,
    picture: Option<PathBuf>,
    /// The height of the block, in mm.
    block_mm: Option<f64>,
    /// Whether the block is on the next point.
    pub(super) on_block: bool,
}

impl Toucher {
    /// Creates it; the result is saved in a file, with the previous calibration beside it.
    pub(super) fn new(pendant: Pendant, file: PathBuf, known: Option<CalibrationFile>) -> Self {
        let procedure = Procedure::new(Tool::SuctionCup);
        let backlash = known
            .as_ref()
            .map(|known| known.backlash)
            .unwrap_or_default();
        Self {
            pendant,
            outcome: procedure.outcome(),
            procedure,
            kept: Kept::new(file, known),
            backlash,
            picture: None,
            block_mm: None,
            on_block: false,
        }
    }

    /// Sets the backlash of base, rear arm and forearm, in degrees; by default as in the previous calibration.
    pub(super) fn with_backlash(mut self, backlash_deg: Option<[f64; 3]>) -> Self {
        if let Some([base, rear, fore]) = backlash_deg {
            self.backlash = Backlash { base, rear, fore };
        }
        self
    }

    /// Sets the file of a picture of the errors, written when the result is saved.
    pub(super) fn with_picture(mut self, picture: Option<PathBuf>) -> Self {
        self.picture = picture;
        self
    }

    /// Sets the height of a block to put on points, in mm.
    pub(super) const fn with_block(mut self, height_mm: Option<f64>) -> Self {
        self.block_mm = height_mm;
        self
    }

    /// The height of the next touch above the paper, in mm.
    pub(super) fn height_mm(&self) -> f64 {
        self.block_mm.filter(|_| self.on_block).unwrap_or(0.0)
    }

    /// Puts the block on the next point, or takes it away.
    fn toggle_block(&mut self) {
        if self.block_mm.is_none() {
            let text = "the height of the block is unknown; quit, and give it: --block 40";
            return self.pendant.show(text.into());
        }
        self.on_block = !self.on_block;
    }

    /// Accepts the fitted tool offset, which the person has measured.
    fn accept_tool(&mut self) {
        match self.outcome.clone() {
            Ok(fit) if fit.trust == Trust::Unmeasured => {
                self.outcome = Ok(fit.with_measured_tool());
                self.pendant.show("the tool is as measured".into());
            }
            _ => self.pendant.show("the tool needs no measurement".into()),
        }
    }

    fn handle_key(&mut self, key: TouchKey) {
        self.pendant.release();
        if key != TouchKey::Save {
            self.kept.forget_shown();
        }
        match key {
            TouchKey::Touch => match self.joints() {
                Ok(joints) => {
                    self.procedure.touch(joints, self.height_mm());
                    self.on_block = false;
                    self.judge();
                }
                Err(why) => {
                    let text = format!("not touched: {why}");
                    self.pendant.show(text);
                }
            },
            TouchKey::Undo if self.procedure.undo() => self.judge(),
            TouchKey::Undo => self.pendant.show("no point is touched yet".into()),
            TouchKey::Skip => self.procedure.skip(),
            TouchKey::Save => self.save(),
            TouchKey::Block => self.toggle_block(),
            TouchKey::Measured => self.accept_tool(),
        }
    }

    /// The reported joint angles of an arm at rest with a confirmed pose.
    fn joints(&self) -> Result<Joints, &str> {
        let untrusted = "the pose is not confirmed; press r, look, and press y";
        let status = self.pendant.status_at_rest(untrusted)?;
        let arm = self.pendant.state().and_then(|state| state.arm.as_ref());
        if let Some(why) = arm.and_then(|arm| arm.touch_refused.as_deref()) {
            return Err(why);
        }
        // The raw angles of an arm that is already calibrated.
        let status = arm.and_then(|arm| arm.raw.as_ref()).unwrap_or(status);
        Ok(Joints::new(
            status.base_deg.into(),
            status.rear_deg.into(),
            status.fore_deg.into(),
            status.servo_deg.into(),
        ))
    }

    fn judge(&mut self) {
        self.outcome = self.procedure.outcome();
        let touched = self.procedure.touches().len();
        self.pendant
            .show(format!("{} touched", output::count(touched, "point")));
    }

    /// Saves a result that was shown, otherwise shows it.
    fn save(&mut self) {
        let text = match &self.outcome {
            Ok(fit) if fit.trust == Trust::Unmeasured => Some(
                "not saved: measure the tool, and press m if it is where the result puts it".into(),
            ),
            Ok(fit) => {
                let text = self.kept.save(found(fit, self.backlash));
                if let Some(picture) = self.picture.clone().filter(|_| text.is_none()) {
                    let svg = residuals_svg(self.procedure.touches(), fit);
                    self.kept.write(picture, svg);
                }
                text
            }
            Err(why) => Some(format!("nothing to save: {why}")),
        };
        if let Some(text) = text {
            self.pendant.show(text);
        }
    }
}

impl Panel for Toucher {
    fn pendant(&mut self) -> &mut Pendant {
        &mut self.pendant
    }

    fn draw(&self, frame: &mut Frame) {
        screen::draw(frame, self);
    }

    fn handle_event(&mut self, now: Duration, event: &Event) {
        match event {
            Event::Key(key) if key.kind == KeyEventKind::Release => {}
            Event::Key(key) => {
                if let Some(meaning) = touch_key(key) {
                    if key.kind == KeyEventKind::Press {
                        self.handle_key(meaning);
                    }
                    return;
                }
                self.kept.forget_shown();
            }
            _ => {}
        }
        self.pendant.handle_event(now, event);
    }

    fn handle_state(&mut self, state: State) {
        let is_lost = state.arm.is_some() && !state.trust.trusted;
        self.pendant.handle_state(state);
        if is_lost && self.procedure.restart() > 0 {
            self.judge();
            let text = "the arm was reset, so that all touches are discarded; touch point 1 again";
            self.pendant.show(text.into());
        }
    }

    fn poll_file(&mut self) -> Option<(PathBuf, String)> {
        self.kept.poll_file()
    }

    fn handle_saved(&mut self, text: String, saved: io::Result<()>) {
        if let Some(text) = self.kept.handle_saved(&text, saved) {
            self.pendant.show(text);
        }
    }
}

/// The action of a key in the procedure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TouchKey {
    /// Record the point under the tip.
    Touch,
    /// Skip the point, which is out of reach.
    Skip,
    /// Undo the last touch.
    Undo,
    /// Show the result, then save it.
    Save,
    /// Put the block on the point, or take it away.
    Block,
    /// Accept the fitted tool offset, which was measured.
    Measured,
}

/// Returns the action of a key; `None` for a key of the pendant.
pub(super) fn touch_key(key: &KeyEvent) -> Option<TouchKey> {
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        return None;
    }
    match key.code {
        KeyCode::Enter => Some(TouchKey::Touch),
        KeyCode::Char('n') => Some(TouchKey::Skip),
        KeyCode::Char('z') => Some(TouchKey::Undo),
        KeyCode::Char('w') => Some(TouchKey::Save),
        KeyCode::Char('b') => Some(TouchKey::Block),
        KeyCode::Char('m') => Some(TouchKey::Measured),
        _ => None,
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use dobot_api::ClientId;
    use dobot_arm::{Calibration, Position};
    use dobot_calibrate::{SHEET_POINTS, read_calibration};

    use super::*;
    use crate::pendant::{Drive, KeyReports};

    const ARM: Calibration = Calibration {
        base_deg: 5.0,
        rear_deg: -4.0,
        fore_deg: 3.0,
        reach_mm: 2.0,
        left_mm: 1.0,
        axis_mm: [0.0, 0.0],
        backlash_deg: [0.0; 3],
        table: None,
    };

    fn toucher(known: Option<CalibrationFile>) -> Toucher {
        let dead_man = Duration::from_millis(150);
        let pendant = Pendant::new(ClientId(7), KeyReports::Presses, dead_man, Drive::Jog);
        let mut toucher = Toucher::new(pendant, "arm.toml".into(), known).with_block(Some(30.0));
        toucher.handle_state(State::sample());
        toucher
    }

    /// The tip is on a point of the sheet.
    fn on([x, y]: [f64; 2]) -> State {
        at(Position::new(x, y, -40.0))
    }

    fn at(place: Position) -> State {
        state_of(&ARM, place)
    }

    #[expect(clippy::cast_possible_truncation, reason = "as a status holds it")]
    fn state_of(arm: &Calibration, place: Position) -> State {
        let raw = arm.raw_joints(place, Tool::SuctionCup).unwrap();
        let mut state = State::sample();
        let status = &mut state.arm.as_mut().unwrap().status;
        status.base_deg = raw.base.0 as f32;
        status.rear_deg = raw.rear.0 as f32;
        status.fore_deg = raw.fore.0 as f32;
        state
    }

    fn press(toucher: &mut Toucher, code: KeyCode) {
        let key = KeyEvent::new(code, KeyModifiers::NONE);
        toucher.handle_event(Duration::from_secs(1), &Event::Key(key));
    }

    fn touch_all(toucher: &mut Toucher) {
        for point in SHEET_POINTS {
            toucher.handle_state(on(point));
            press(toucher, KeyCode::Enter);
        }
    }

    #[test]
    fn a_result_is_saved_only_after_it_was_shown() {
        let mut toucher = toucher(None);
        touch_all(&mut toucher);
        press(&mut toucher, KeyCode::Char('w'));
        assert_eq!(toucher.poll_file(), None);
        press(&mut toucher, KeyCode::Char('w'));
        let (file, text) = toucher.poll_file().unwrap();
        assert_eq!(file, PathBuf::from("arm.toml"));
        let known = read_calibration(&text).unwrap();
        assert_eq!(known.touched.unwrap().points, 9);
        let place = Position::new(230.0, -50.0, -40.0);
        let raw = known.arm().raw_place(place, Tool::SuctionCup).unwrap();
        let reached = ARM.true_place(raw, Tool::SuctionCup).unwrap();
        assert!(reached.distance(place).0 < 0.2, "{reached:?}");
    }

    #[test]
    fn a_previous_calibration_is_backed_up_first() {
        let known = CalibrationFile::default();
        let mut toucher = toucher(Some(known.clone()));
        touch_all(&mut toucher);
        press(&mut toucher, KeyCode::Char('w'));
        press(&mut toucher, KeyCode::Char('w'));
        let (file, text) = toucher.poll_file().unwrap();
        assert_eq!(file, PathBuf::from("arm.toml.before"));
        assert_eq!(read_calibration(&text).unwrap(), known);
        let full = io::Error::other("the disk is full");
        toucher.handle_saved(text, Err(full));
        assert_eq!(toucher.poll_file(), None, "nothing is replaced without it");
    }

    #[test]
    fn a_touch_on_a_block_is_corrected_by_its_height() {
        let mut toucher = toucher(None);
        touch_all(&mut toucher);
        let flat = toucher.outcome.clone().unwrap();
        press(&mut toucher, KeyCode::Char('b'));
        let [x, y] = SHEET_POINTS[0];
        toucher.handle_state(at(Position::new(x, y, -10.0)));
        press(&mut toucher, KeyCode::Enter);
        let found = toucher.outcome.clone().unwrap();
        assert!(found.residual_mm(9) < 0.1, "{}", found.residual_mm(9));
        assert!(found.left_out.is_empty());
        assert!(found.unsure.len() <= flat.unsure.len());
        // The next touch is on the paper again.
        assert_eq!(toucher.height_mm(), 0.0);
    }

    #[test]
    fn an_unusual_tool_is_saved_only_after_it_was_measured() {
        let mut toucher = toucher(None);
        let long = Calibration {
            reach_mm: 10.0,
            ..ARM
        };
        for [x, y] in SHEET_POINTS {
            toucher.handle_state(state_of(&long, Position::new(x, y, -40.0)));
            press(&mut toucher, KeyCode::Enter);
        }
        press(&mut toucher, KeyCode::Char('w'));
        press(&mut toucher, KeyCode::Char('w'));
        assert_eq!(toucher.poll_file(), None);
        press(&mut toucher, KeyCode::Char('m'));
        press(&mut toucher, KeyCode::Char('w'));
        press(&mut toucher, KeyCode::Char('w'));
        assert!(toucher.poll_file().is_some());
    }

    #[test]
    fn too_few_touches_are_not_saved() {
        let mut toucher = toucher(None);
        for point in &SHEET_POINTS[..3] {
            toucher.handle_state(on(*point));
            press(&mut toucher, KeyCode::Enter);
        }
        press(&mut toucher, KeyCode::Char('w'));
        press(&mut toucher, KeyCode::Char('w'));
        assert_eq!(toucher.poll_file(), None);
    }

    #[test]
    fn a_reset_of_the_arm_makes_all_touches_void() {
        let mut toucher = toucher(None);
        touch_all(&mut toucher);
        let mut state = on(SHEET_POINTS[0]);
        state.trust.trusted = false;
        toucher.handle_state(state);
        assert!(toucher.procedure.touches().is_empty());
        press(&mut toucher, KeyCode::Enter);
        assert!(
            toucher.procedure.touches().is_empty(),
            "not touched before it is confirmed"
        );
    }

    #[test]
    fn a_touch_from_the_wrong_side_is_not_recorded() {
        let mut toucher = toucher(None);
        let mut state = on(SHEET_POINTS[0]);
        state.arm.as_mut().unwrap().touch_refused =
            Some("the base came from the other side".into());
        toucher.handle_state(state);
        press(&mut toucher, KeyCode::Enter);
        assert!(toucher.procedure.touches().is_empty());
    }

    #[test]
    fn an_arm_that_moves_touches_nothing() {
        let mut toucher = toucher(None);
        let mut state = on(SHEET_POINTS[0]);
        state.arm.as_mut().unwrap().moving = true;
        toucher.handle_state(state);
        press(&mut toucher, KeyCode::Enter);
        assert!(toucher.procedure.touches().is_empty());
    }
}
