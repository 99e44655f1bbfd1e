//! The text at the start of a station.

use crossterm::style::Stylize;

/// The text at the start of a station.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Welcome {
    /// The address of page and API.
    pub(crate) page: String,
    /// The fingerprint of the certificate, with TLS.
    pub(crate) fingerprint: Option<String>,
    /// The arm.
    pub(crate) arm: String,
    /// The TCP address of raw packets.
    pub(crate) raw: Option<String>,
    /// The virtual serial port.
    pub(crate) pty: Option<String>,
    /// The address for Foxglove.
    pub(crate) foxglove: Option<String>,
    /// The name in the fleet.
    pub(crate) fleet: Option<String>,
    /// The data folder.
    pub(crate) data: String,
    /// Notes for the person.
    pub(crate) notes: Vec<String>,
}

impl Welcome {
    /// The text, with colours for a terminal.
    pub(crate) fn text(&self, colours: bool) -> String {
        let paint = Paint(colours);
        let facts = self.facts().into_iter().map(|(name, text, remark)| {
            let (name, remark) = (paint.dim(&format!("{name:11}")), paint.dim(remark));
            let text = if text == self.page {
                paint.strong(&text)
            } else {
                text
            };
            format!("  {name}  {text}  {remark}").trim_end().to_owned()
        });
        let hints = NEXT
            .iter()
            .map(|(name, what)| format!("  {}  {what}", paint.verb(&format!("{name:11}"))));
        let notes = self
            .notes
            .iter()
            .map(|note| format!("  {}  {note}", paint.note("note       ")));
        let title = paint.title(concat!(" dobot ", env!("CARGO_PKG_VERSION"), " "));
        let mut lines = vec![title];
        lines.extend(facts);
        lines.extend(notes);
        lines.extend(hints);
        lines.join("\n")
    }

    /// Logs the facts and notes.
    pub(crate) fn log(&self) {
        let Self {
            page,
            fingerprint,
            arm,
            raw,
            pty,
            foxglove,
            fleet,
            data,
            notes,
        } = self;
        tracing::info!(
            page,
            fingerprint,
            arm,
            raw,
            pty,
            foxglove,
            fleet,
            data,
            "the station has started"
        );
        for note in notes {
            tracing::warn!("{note}");
        }
    }

    fn facts(&self) -> Vec<(&'static str, String, &'static str)> {
        let fact =
            |name, text: &Option<String>, remark| text.clone().map(|text| (name, text, remark));
        [
            fact("page", &Some(self.page.clone()), ""),
            fact("fingerprint", &self.fingerprint, ""),
            fact("arm", &Some(self.arm.clone()), ""),
            fact(
                "raw packets",
                &self.raw,
                "for programs that use the arm's protocol",
            ),
            fact(
                "serial port",
                &self.pty,
                "for programs that need a serial port",
            ),
            fact(
                "Foxglove",
                &self.foxglove,
                "for its Open connection; watching only",
            ),
            fact("fleet", &self.fleet, "its board is at /fleet on the page"),
            fact("data", &Some(self.data.clone()), ""),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// Colours, or none.
struct Paint(bool);

impl Paint {
    fn title(&self, text: &str) -> String {
        self.when(text, |text| text.reverse().bold().to_string())
    }

    fn strong(&self, text: &str) -> String {
        self.when(text, |text| text.cyan().bold().to_string())
    }

    fn dim(&self, text: &str) -> String {
        self.when(text, |text| text.dim().to_string())
    }

    fn verb(&self, text: &str) -> String {
        self.when(text, |text| text.green().to_string())
    }

    fn note(&self, text: &str) -> String {
        self.when(text, |text| text.yellow().bold().to_string())
    }

    fn when(&self, text: &str, paint: impl Fn(&str) -> String) -> String {
        if self.0 && !text.is_empty() {
            paint(text)
        } else {
            text.to_owned()
        }
    }
}

/// What to do next.
const NEXT: [(&str, &str); 2] = [
    (
        "next",
        "open the page, or in another terminal: dobot watch, draw, stop",
    ),
    (
        "Ctrl-C",
        "end the station: the laser goes off, the arm comes to rest",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn welcome() -> Welcome {
        Welcome {
            page: "http://127.0.0.1:8642".into(),
            arm: "a virtual arm".into(),
            raw: Some("tcp:127.0.0.1:5555".into()),
            data: "/data".into(),
            ..Welcome::default()
        }
    }

    #[test]
    fn it_shows_the_address_the_arm_and_how_to_quit() {
        let text = welcome().text(false);
        for part in [
            "page         http://127.0.0.1:8642\n",
            "arm          a virtual arm\n",
            "tcp:127.0.0.1:5555",
            "dobot watch",
            "Ctrl-C",
        ] {
            assert!(text.contains(part), "`{part}` is missing:\n{text}");
        }
        assert!(!text.contains("fingerprint") && !text.contains("serial port"));
    }

    #[test]
    fn it_fits_on_a_terminal_of_eighty_columns() {
        let text = welcome().text(false);
        assert!(text.lines().count() <= 8, "{text}");
        let longest = text.lines().map(|line| line.chars().count()).max();
        assert!(longest <= Some(80), "{longest:?}:\n{text}");
    }

    #[test]
    fn output_to_a_file_has_no_colours() {
        assert!(!welcome().text(false).contains('\x1b'));
        let noted = Welcome {
            notes: vec!["nothing is recorded".into()],
            ..welcome()
        };
        assert!(
            noted
                .text(false)
                .contains("note         nothing is recorded")
        );
    }
}
