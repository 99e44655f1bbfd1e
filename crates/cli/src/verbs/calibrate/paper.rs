//! Touching the paper: its plane and its shape.

use std::io;
use std::path::PathBuf;
use std::time::Duration;

use crossterm::event::{Event, KeyEventKind};
use dobot_api::{CalibrationFile, State};
use dobot_calibrate::{PaperTouchError, SHEET_POINTS, TouchedPaper, paper};
use ratatui::Frame;
use ratatui::style::Stylize;
use ratatui::text::Line;

use super::kept::Kept;
use super::screen;
use super::toucher::{TouchKey, touch_key};
use crate::output;
use crate::pendant::{Panel, Pendant};

/// Lets a person touch the paper.
#[derive(Debug)]
pub(crate) struct PaperToucher {
    pendant: Pendant,
    /// The calibrated positions, in mm.
    touched: Vec<[f64; 3]>,
    /// The number of skipped suggestions.
    skipped: usize,
    /// The result of the touches.
    outcome: Result<TouchedPaper, PaperTouchError>,
    /// The calibration of the arm.
    arm: CalibrationFile,
    kept: Kept,
}

impl PaperToucher {
    /// Creates it; the result is saved in a file with the rest of the calibration.
    pub(crate) fn new(pendant: Pendant, file: PathBuf, known: Option<CalibrationFile>) -> Self {
        Self {
            pendant,
            touched: Vec::new(),
            skipped: 0,
            outcome: paper(&[]),
            arm: known.clone().unwrap_or_default(),
            kept: Kept::new(file, known),
        }
    }

    fn handle_key(&mut self, key: TouchKey) {
        self.pendant.release();
        if key != TouchKey::Save {
            self.kept.forget_shown();
        }
        match key {
            TouchKey::Touch => match self.place() {
                Ok(place) => {
                    self.touched.push(place);
                    self.judge();
                }
                Err(why) => self.pendant.show(format!("not touched: {why}")),
            },
            TouchKey::Undo if self.touched.pop().is_some() => self.judge(),
            TouchKey::Undo => self.pendant.show("no point is touched yet".into()),
            TouchKey::Skip => self.skipped += 1,
            TouchKey::Save => self.save(),
            TouchKey::Block => self
                .pendant
                .show("a block cannot be used on the paper".into()),
            TouchKey::Measured => self
                .pendant
                .show("no tool has to be measured for the paper".into()),
        }
    }

    /// The position of an arm at rest with a confirmed pose.
    fn place(&self) -> Result<[f64; 3], &'static str> {
        let status = self
            .pendant
            .status_at_rest("the pose is not confirmed; press r, look, and press y")?;
        Ok([status.x_mm, status.y_mm, status.z_mm].map(f64::from))
    }

    fn judge(&mut self) {
        self.outcome = paper(&self.touched);
        let touched = self.touched.len();
        self.pendant
            .show(format!("{} touched", output::count(touched, "point")));
    }

    fn save(&mut self) {
        let text = match &self.outcome {
            Ok(found) => self.kept.save(CalibrationFile {
                paper: Some(found.paper.clone()),
                ..self.arm.clone()
            }),
            Err(why) => Some(format!("nothing to save: {why}")),
        };
        if let Some(text) = text {
            self.pendant.show(text);
        }
    }

    fn lines(&self) -> Vec<Line<'static>> {
        let next = self.touched.len() + self.skipped;
        let [x_mm, y_mm] = SHEET_POINTS[next % SHEET_POINTS.len()];
        let text = format!(
            "touch the paper near {x_mm}, {y_mm}, from above ({} touched; 3 give a plane, 9 its shape)",
            self.touched.len()
        );
        let mut lines = vec![Line::from(text).bold()];
        match &self.outcome {
            Ok(found) => lines.extend(result(found)),
            Err(why) => {
                let texts = output::wrapped(&why.to_string(), screen::WIDTH);
                lines.extend(texts.into_iter().map(Line::from));
            }
        }
        lines
    }
}

fn result(found: &TouchedPaper) -> [Line<'static>; 3] {
    let away = (1..).zip(&found.away_mm);
    let away: Vec<String> = away
        .map(|(number, mm)| format!("{number} {mm:+.2}"))
        .collect();
    let is_bent = !found.paper.heights.is_empty();
    [
        Line::from(format!(
            "paper: z {:.2} mm at the axis of the base, slope {:.2} degrees",
            found.paper.z_mm, found.slope_deg
        )),
        Line::from(format!("height above the plane, mm: {}", away.join("  "))),
        if is_bent {
            Line::from(format!(
                "bent by {:.2} mm; drawings follow it",
                found.bent_mm()
            ))
        } else {
            Line::from("a plane; touch more points to check it").dim()
        },
    ]
}

impl Panel for PaperToucher {
    fn pendant(&mut self) -> &mut Pendant {
        &mut self.pendant
    }

    fn draw(&self, frame: &mut Frame) {
        screen::draw_touching(frame, &self.pendant, "paper", self.lines(), &[]);
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
        if is_lost && !self.touched.is_empty() {
            self.touched.clear();
            self.judge();
            let text =
                "the arm was reset, so that all touches are discarded; touch the paper again";
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

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
    use dobot_api::{ClientId, Zeros};
    use dobot_calibrate::read_calibration;

    use super::*;
    use crate::pendant::{Drive, KeyReports};

    fn toucher(known: Option<CalibrationFile>) -> PaperToucher {
        let dead_man = Duration::from_millis(150);
        let pendant = Pendant::new(ClientId(7), KeyReports::Presses, dead_man, Drive::Jog);
        PaperToucher::new(pendant, "arm.toml".into(), known)
    }

    #[expect(clippy::cast_possible_truncation, reason = "as a status holds it")]
    fn at(place: [f64; 3]) -> State {
        let mut state = State::sample();
        let status = &mut state.arm.as_mut().unwrap().status;
        [status.x_mm, status.y_mm, status.z_mm] = place.map(|number| number as f32);
        state
    }

    fn press(toucher: &mut PaperToucher, code: KeyCode) {
        let key = KeyEvent::new(code, KeyModifiers::NONE);
        toucher.handle_event(Duration::from_secs(1), &Event::Key(key));
    }

    fn touch_all(toucher: &mut PaperToucher, count: usize) {
        for [x, y] in &SHEET_POINTS[..count] {
            toucher.handle_state(at([*x, *y, -42.0 + 0.01 * x + (y / 100.0).powi(2)]));
            press(toucher, KeyCode::Enter);
        }
    }

    #[test]
    fn the_paper_is_saved_with_the_zeros_of_the_arm_after_it_was_shown() {
        let known = CalibrationFile {
            zeros: Zeros {
                base: 3.0,
                rear: 2.0,
                fore: 1.0,
            },
            ..CalibrationFile::default()
        };
        let mut toucher = toucher(Some(known.clone()));
        touch_all(&mut toucher, 9);
        press(&mut toucher, KeyCode::Char('w'));
        assert_eq!(toucher.poll_file(), None);
        press(&mut toucher, KeyCode::Char('w'));
        let (file, text) = toucher.poll_file().unwrap();
        assert_eq!(file, PathBuf::from("arm.toml.before"));
        assert_eq!(read_calibration(&text).unwrap(), known);
        let (file, text) = toucher.poll_file().unwrap();
        assert_eq!(file, PathBuf::from("arm.toml"));
        let kept = read_calibration(&text).unwrap();
        assert_eq!(kept.zeros, known.zeros);
        let found = kept.paper.unwrap();
        assert_eq!(found.heights.len(), 9);
        let bent: Vec<f64> = found.heights.iter().map(|height| height[2]).collect();
        assert!((bent[1] - bent[0] - 1.0).abs() < 0.01, "{bent:?}");
    }

    #[test]
    fn another_key_before_the_confirmation_saves_nothing() {
        let mut toucher = toucher(None);
        touch_all(&mut toucher, 3);
        press(&mut toucher, KeyCode::Char('w'));
        press(&mut toucher, KeyCode::Char('n'));
        press(&mut toucher, KeyCode::Char('w'));
        assert_eq!(toucher.poll_file(), None);
    }

    #[test]
    fn a_reset_of_the_arm_makes_the_touches_of_the_paper_void() {
        let mut toucher = toucher(None);
        touch_all(&mut toucher, 3);
        let mut state = at([200.0, 0.0, -42.0]);
        state.trust.trusted = false;
        toucher.handle_state(state);
        press(&mut toucher, KeyCode::Char('w'));
        press(&mut toucher, KeyCode::Char('w'));
        assert_eq!(toucher.poll_file(), None);
    }
}
