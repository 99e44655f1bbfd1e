//! Points in CSV.
//!
//! ```text
//!   x,y            a header may name the columns, in any order; without one they are x and y
//!   0,0            a point for each line, separated by commas, semicolons or tabs
//!   10,0.5
//!                  an empty line begins a stroke, and so does a change in a column `stroke`
//!   20,0           or `pen`; each value of `pen` is a layer
//! ```

use dobot_geometry::Point;

use crate::artwork::{Artwork, Layer};
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::place::{beginning, shortened};
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;

/// Two numbers, or a header with x and y.
pub(crate) fn is_likely(start: &str) -> bool {
    let first = start.lines().next().unwrap_or_default();
    let fields = first
        .split([',', ';', '\t'])
        .map(|part| part.trim().to_ascii_lowercase());
    let fields: Vec<String> = fields.collect();
    let has = |name: &str| fields.iter().any(|field| field == name);
    let is_number = |text: &String| text.parse::<f64>().is_ok();
    (has("x") && has("y")) || (fields.len() >= 2 && fields.iter().all(is_number))
}

/// Reads points in CSV.
pub(crate) fn read(
    text: &str,
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut reader = CsvReader {
        sketch: Sketch::new(text.as_bytes(), options)?,
        text,
        columns: None,
        points: Vec::new(),
        key: [None; 2],
    };
    let mut at = beginning(text.as_bytes());
    for line in text[at..].split_inclusive('\n') {
        options.cancel.check()?;
        reader.line(at, line.trim_end_matches(['\r', '\n']))?;
        at += line.len();
    }
    reader.end_stroke();
    reader.sketch.finish(Y::Down, "no points in the file")
}

struct CsvReader<'a> {
    sketch: Sketch<'a>,
    text: &'a str,
    columns: Option<Columns>,
    /// The points of the current stroke.
    points: Vec<Point>,
    /// Its values in the columns `stroke` and `pen`.
    key: Key<'a>,
}

/// The values of a line in the columns `stroke` and `pen`, if there are such columns.
type Key<'a> = [Option<&'a str>; 2];

/// The columns.
struct Columns {
    separator: char,
    count: usize,
    x: usize,
    y: usize,
    stroke: Option<usize>,
    pen: Option<usize>,
}

impl<'a> CsvReader<'a> {
    fn line(&mut self, at: usize, line: &'a str) -> Result<(), SourceError> {
        if line.trim().is_empty() {
            self.end_stroke();
            return Ok(());
        }
        let Some(columns) = &self.columns else {
            return self.first_line(at, line);
        };
        let (mut x, mut y) = ("", "");
        let mut key: Key<'a> = [None; 2];
        let mut count = 0;
        for field in line.split(columns.separator) {
            let is = |column: Option<usize>| column == Some(count);
            match () {
                () if is(Some(columns.x)) => x = field,
                () if is(Some(columns.y)) => y = field,
                () if is(columns.stroke) => key[0] = Some(field.trim()),
                () if is(columns.pen) => key[1] = Some(field.trim()),
                () => {}
            }
            count += 1;
        }
        if count != columns.count {
            let found = format!("{count} fields");
            let expected = format!("{} fields, decimals with a point", columns.count);
            return Err(self.sketch.found(at, found, &expected));
        }
        let point = Point::new(self.number(x)?, self.number(y)?);
        let point = self.sketch.check(at, point)?;
        if self.points.is_empty() || key != self.key {
            self.end_stroke();
            self.key = key;
            self.use_pen(key[1])?;
        }
        // Before the rest of them fills the memory.
        self.sketch.spend(1)?;
        self.points.push(point);
        Ok(())
    }

    /// Parses the header, or the first points.
    fn first_line(&mut self, at: usize, line: &'a str) -> Result<(), SourceError> {
        let separators = [';', '\t', ','];
        let separator = separators
            .into_iter()
            .find(|&separator| line.contains(separator));
        let separator = separator.unwrap_or(',');
        let names: Vec<String> = line
            .split(separator)
            .map(|part| part.trim().to_ascii_lowercase())
            .collect();
        let column = |name: &str| names.iter().position(|column| column == name);
        let (Some(x), Some(y)) = (column("x"), column("y")) else {
            let is_header = line.contains(|c: char| c.is_alphabetic() && !"eE".contains(c));
            if is_header || names.len() != 2 {
                let expected = "a header with x and y, or two numbers x,y";
                let text = self.text.as_bytes();
                return Err(SourceError::unexpected(text, at, expected));
            }
            self.columns = Some(Columns {
                separator,
                count: 2,
                x: 0,
                y: 1,
                stroke: None,
                pen: None,
            });
            return self.line(at, line);
        };
        let known = ["x", "y", "stroke", "pen"];
        for name in names.iter().filter(|name| !known.contains(&name.as_str())) {
            let what = format!("column {:?}", shortened(name));
            self.sketch.warn(at, &what, "left out");
        }
        let (stroke, pen) = (column("stroke"), column("pen"));
        self.columns = Some(Columns {
            separator,
            count: names.len(),
            x,
            y,
            stroke,
            pen,
        });
        Ok(())
    }

    fn number(&self, field: &'a str) -> Result<f64, SourceError> {
        let field = field.trim();
        let is_plain = field.bytes().all(|byte| b"0123456789+-.eE".contains(&byte));
        let number = field
            .parse()
            .ok()
            .filter(|x: &f64| is_plain && x.is_finite());
        number.ok_or_else(|| {
            let at = field.as_ptr() as usize - self.text.as_ptr() as usize;
            let found = format!("{:?}", shortened(field));
            self.sketch
                .found(at, found, "a number such as 12.5, with a decimal point")
        })
    }

    fn use_pen(&mut self, pen: Option<&str>) -> Result<(), SourceError> {
        match pen {
            Some(pen) => self.sketch.use_layer(Layer {
                name: format!("pen {pen}"),
                ..Layer::default()
            }),
            None => Ok(()),
        }
    }

    fn end_stroke(&mut self) {
        let mut points = std::mem::take(&mut self.points);
        // There may be millions of strokes; spare capacity would add up.
        points.shrink_to_fit();
        self.sketch.counted_stroke(points);
    }
}
