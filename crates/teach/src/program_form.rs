//! The file formats of programs: TOML and the vendor's formats.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::vendor::{self, Read};
use crate::{Files, Program, ProgramError};

/// The file format of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ProgramForm {
    /// TOML.
    #[default]
    Toml,
    /// `PlayBackPoints.xml`.
    Xml,
    /// `.play`.
    Play,
    /// `.playback`, which is only read.
    Playback,
}

impl ProgramForm {
    /// Returns the format for a file name extension, in upper or lower case.
    ///
    /// ```
    /// use dobot_teach::ProgramForm;
    ///
    /// assert_eq!(ProgramForm::of_name("PlayBackPoints.XML"), Some(ProgramForm::Xml));
    /// assert_eq!(ProgramForm::of_name("cubes"), None);
    /// ```
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, end) = name.rsplit_once('.')?;
        match end.to_ascii_lowercase().as_str() {
            "toml" => Some(Self::Toml),
            "xml" => Some(Self::Xml),
            "play" => Some(Self::Play),
            "playback" => Some(Self::Playback),
            _ => None,
        }
    }

    /// Parses a program of this format and returns warnings.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if it is not a program of this format.
    pub fn read(self, bytes: &[u8]) -> Result<Read<Program>, ProgramError> {
        let points = match self {
            Self::Toml => {
                let content = Program::from_toml(text_of(bytes)?)?;
                return Ok(Read {
                    content,
                    warnings: Vec::new(),
                });
            }
            Self::Xml => vendor::read_points(bytes),
            Self::Play => vendor::read_play(bytes),
            Self::Playback => return vendor::read_playback(bytes),
        }?;
        Ok(Read {
            content: vendor::program_of(&points.content),
            warnings: points.warnings,
        })
    }

    /// Writes the program in this format and returns what the format cannot express. `files` provides
    /// the called programs and the drawings.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the format can express none of the program, or a position is out of reach.
    pub fn write(
        self,
        program: &Program,
        files: &mut dyn Files,
    ) -> Result<Read<String>, ProgramError> {
        let write = match self {
            Self::Toml => {
                return Ok(Read {
                    content: program.to_toml(),
                    warnings: Vec::new(),
                });
            }
            Self::Xml => vendor::write_points,
            Self::Play => vendor::write_play,
            Self::Playback => {
                return Err(ProgramError::new(
                    ".playback files are only read; write a .toml, .xml or .play file",
                ));
            }
        };
        let (points, warnings) = vendor::points_of(program, files)?;
        if points.is_empty() {
            return Err(ProgramError::new(
                "the program has no point that this format can express",
            ));
        }
        Ok(Read {
            content: write(&points),
            warnings,
        })
    }
}

fn text_of(bytes: &[u8]) -> Result<&str, ProgramError> {
    std::str::from_utf8(bytes)
        .map_err(|_| ProgramError::new("the file is not UTF-8 text; save it as UTF-8"))
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::NoFiles;

    const FORMS: [ProgramForm; 3] = [ProgramForm::Toml, ProgramForm::Xml, ProgramForm::Play];

    const JOINTS: &str = "[[steps]]\ngo = { base = 10, rear = 40, fore = 40 }\nsuction = true\n\
                          [[steps]]\ngo = { base = -10, rear = 40, fore = 40 }\npath = \"movj\"\n";

    #[test]
    fn a_program_of_joint_angles_is_restored_from_every_form() {
        let program = Program::from_toml(JOINTS).unwrap();
        for form in FORMS {
            let written = form.write(&program, &mut NoFiles).unwrap();
            assert!(written.warnings.is_empty(), "{form:?}");
            let read = form.read(written.content.as_bytes()).unwrap();
            let ways = |program: &Program| -> Vec<_> {
                let steps = program
                    .steps
                    .0
                    .iter()
                    .map(|program| program.get_ref().clone());
                steps
                    .map(|step| match step {
                        crate::Action::Go(go) => (go.to, go.path, go.then.suction.unwrap_or(true)),
                        other => panic!("{other:?}"),
                    })
                    .collect()
            };
            assert_eq!(ways(&read.content), ways(&program), "{form:?}");
        }
    }

    #[test]
    fn content_that_a_form_cannot_carry_is_reported() {
        let mixed = format!("{JOINTS}[[steps]]\nwait = \"look\"\n");
        let mixed = Program::from_toml(&mixed).unwrap();
        for form in [ProgramForm::Xml, ProgramForm::Play] {
            let written = form.write(&mixed, &mut NoFiles).unwrap();
            let [warning] = <[String; 1]>::try_from(written.warnings).unwrap();
            assert!(warning.starts_with("line 7: a wait"), "{warning}");
        }
        let error = ProgramForm::Playback
            .write(&mixed, &mut NoFiles)
            .unwrap_err();
        assert!(error.to_string().contains("only read"), "{error}");
    }

    #[test]
    fn bytes_that_are_not_text_are_not_a_program() {
        let error = ProgramForm::Toml.read(b"title = \"\xff\"").unwrap_err();
        assert_eq!(
            error.to_string(),
            "the file is not UTF-8 text; save it as UTF-8"
        );
    }

    #[test]
    fn the_form_of_a_file_is_given_by_its_extension_alone() {
        for (name, form) in [
            ("PlayBackPoints.xml", Some(ProgramForm::Xml)),
            ("a.toml.PLAY", Some(ProgramForm::Play)),
            ("cubes.playback", Some(ProgramForm::Playback)),
            ("x/y.d/cubes.Toml", Some(ProgramForm::Toml)),
            ("x.toml/cubes", None),
            ("PlayBackParams.json", None),
            ("toml", None),
        ] {
            assert_eq!(ProgramForm::of_name(name), form, "{name}");
        }
    }
}
