//! A drawing request: the checked options and their content.

use std::sync::Arc;

use dobot_api::CalibrationFile;
use dobot_arm::{Limits, Pose, Position, Unreachable};
use dobot_geometry::Point;
use dobot_import::{Align, Font, Shading, Source, SourceError, Text, system_fonts};
use dobot_plan::{ArmLimits, DrawingTool, Laser, Paper, Pass, Pen};
use dobot_wire::Dialect;

use super::check::check;
use super::placement::{center, marks, placement, wrap_texts};
use super::{ContentOptions, Options, OptionsError, PassesBy, PlaceOptions, Spacing, ToolOptions};
use crate::arm::calibrated::known_paper;
use crate::layout::place::PlaceError;
use crate::layout::test_card::Card;
use crate::material::{Material, Materials, UnknownMaterial};
use crate::preparation::progress::Progress;
use crate::prepare::{
    NamedSource, PrepareError, Prepared, Settings, prepare_multi_file, prepare_passes,
};
use crate::strokes::cutting::Cutting;
use crate::strokes::hatch::Hatch;
use dobot_geometry::CancelToken;

/// A drawing request: its content and settings, except those that depend on the arm.
#[derive(Clone, Debug)]
pub struct DrawingRequest {
    /// The title.
    pub title: String,
    options: Options,
    what: Drawable,
    settings: Settings,
}

/// The content of a drawing and its title.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The name of a file, or the first line of a text.
    pub title: String,
    /// Files, pictures and a text, on one page; none for the test card, which the options define.
    pub sources: Vec<NamedSource>,
}

#[derive(Clone, Debug)]
enum Drawable {
    Sources(Vec<NamedSource>),
    /// A complete layout: the test card.
    Passes(Vec<Pass>),
}

impl Subject {
    /// Creates the content of a file; its extension or first bytes determine the format.
    ///
    /// # Errors
    ///
    /// [`SourceError`] if the file cannot be drawn.
    pub fn of_file(name: &str, bytes: Vec<u8>) -> Result<Self, SourceError> {
        Ok(Self::of(name, Source::of_file(name, bytes)?))
    }

    /// Creates the content of lines computed by a program: x to the right, y down, in mm; `name` is
    /// the title.
    #[must_use]
    pub fn of_lines(name: &str, lines: Vec<Vec<Point>>) -> Self {
        Self::of(name, Source::Lines(lines))
    }

    /// Returns the text or the test card in the options; `None` if a file is to be drawn.
    #[must_use]
    pub fn of_text(what: &ContentOptions) -> Option<Self> {
        if what.card.is_some() {
            return Some(Self {
                title: "test card".to_owned(),
                sources: Vec::new(),
            });
        }
        let text = what.text.as_ref()?.replace("\\n", "\n");
        let mut lines = text.lines();
        let first = lines.find(|line| !line.trim().is_empty());
        let title = shortened(first.unwrap_or("text"));
        let text = Text {
            font: Font::of(what.font.as_deref().unwrap_or("sans")),
            height_mm: what.height.unwrap_or(10.0),
            align: what.align.unwrap_or(Align::Left),
            ..Text::new(text)
        };
        Some(Self::of(&title, Source::Text(text)))
    }

    /// Adds other content to the page; the title consists of the first name and the number of
    /// further files.
    #[must_use]
    pub fn and(mut self, mut other: Self) -> Self {
        let first = self.sources.first().map(|source| source.name.clone());
        self.sources.append(&mut other.sources);
        let is_file = |source: &&NamedSource| !matches!(source.source, Source::Text(_));
        let more = self
            .sources
            .iter()
            .filter(is_file)
            .count()
            .saturating_sub(1);
        if let Some(first) = first.filter(|_| more > 0) {
            self.title = format!("{first} and {more} more");
        }
        self
    }

    fn of(name: &str, source: Source) -> Self {
        let name = name.to_owned();
        Self {
            title: name.clone(),
            sources: vec![NamedSource { name, source }],
        }
    }
}

impl DrawingRequest {
    /// Converts the options to settings, with these pens and materials. Installed fonts are read if
    /// the drawing contains text that needs them.
    ///
    /// # Errors
    ///
    /// [`OptionsError`]: an unknown pen or material, options that conflict with each other or would
    /// have no effect for this source, or a test card that cannot be laid out.
    pub fn new(
        options: Options,
        subject: Subject,
        materials: &Materials,
    ) -> Result<Self, OptionsError> {
        let Subject { title, mut sources } = subject;
        let material = material(&options.tool, materials)?;
        let tool = with_options(material.tool, &options.tool)?;
        check(&options, &sources, &title)?;
        let placement = placement(&options, &sources)?;
        wrap_texts(&mut sources, &options, &placement);
        let needs_fonts = sources.iter().any(|source| source.source.needs_fonts());
        let settings = Settings {
            tolerance_mm: options.way.tolerance,
            placement,
            grid: options.place.grid,
            gap_mm: options.place.gap,
            marks: marks(&options.place),
            keeps_text_height: options.what.height.is_some(),
            tool,
            keeps_speed: options.tool.speed.is_some(),
            layers: options.what.layers,
            only: options.what.only.clone(),
            tools: layer_tools(&options.what, materials)?,
            hatch: hatch(&options.what, &material),
            shading: shading(&options, tool),
            crops: !options.what.no_crop,
            gcode: options.what.gcode,
            strict: options.what.strict,
            hides: options.what.hide,
            white_edges: options.what.white_edges,
            join_mm: options.way.join,
            drops_duplicates: options.way.drop_doubles,
            pen_passes: options.tool.passes.unwrap_or(1),
            cutting: Cutting {
                kerf_mm: options.tool.kerf,
                lead_in_mm: options.tool.lead_in,
                overcut_mm: options.tool.overcut,
                tabs: options.tool.tabs,
                tab_mm: options.tool.tab_width,
            },
            tries: (!options.way.keep_order).then_some(options.way.tries),
            seed: options.way.seed,
            from: options.way.from.clone(),
            fonts: Arc::new(needs_fonts.then(system_fonts).unwrap_or_default()),
            ..Settings::default()
        };
        let what = if sources.is_empty() {
            Drawable::Passes(card(&options, tool, material.spacing_mm)?)
        } else {
            Drawable::Sources(sources)
        };
        Ok(Self {
            title,
            options,
            what,
            settings,
        })
    }

    /// Sets the calibration of the arm.
    #[must_use]
    pub fn calibrated(mut self, calibration: Option<CalibrationFile>) -> Self {
        self.settings.calibration = calibration;
        self
    }

    /// Sets the cancel token.
    #[must_use]
    pub fn until(mut self, cancel: CancelToken) -> Self {
        self.settings.cancel = cancel;
        self
    }

    /// Returns the progress, which other threads may read.
    #[must_use]
    pub const fn progress(&self) -> &Progress {
        &self.settings.progress
    }

    /// Prepares the drawing for an arm with this dialect, if known, that touches the paper at this
    /// height, in mm.
    ///
    /// # Errors
    ///
    /// [`OptionsError`] if the paper is invalid or the drawing cannot be prepared.
    pub fn prepare(
        &self,
        dialect: Option<Dialect>,
        standing_z_mm: f64,
    ) -> Result<(Prepared, Settings), OptionsError> {
        let arm_limits = dialect.map_or_else(ArmLimits::default, ArmLimits::of);
        let settings = Settings {
            paper: self.paper(standing_z_mm)?,
            arm_limits: ArmLimits {
                acceleration_mm_s2: self.options.tool.acceleration,
                corner_deviation_mm: 2.0 * self.options.way.tolerance,
                ..arm_limits
            },
            ..self.settings.clone()
        };
        let prepared = match &self.what {
            Drawable::Sources(all) => prepare_multi_file(all, &settings, reach_of(&settings)),
            Drawable::Passes(passes) => {
                prepare_passes(passes.clone(), &settings, reach_of(&settings))
            }
        };
        match prepared {
            Ok(prepared) => Ok((prepared, settings)),
            Err(PrepareError::Place(error)) => Err(self.misplaced(error, &settings)),
            Err(error) => Err(error.into()),
        }
    }

    /// Adds the option with which the drawing would fit, if there is one, to an error.
    fn misplaced(&self, error: PlaceError, settings: &Settings) -> OptionsError {
        let may_fit = matches!(
            error,
            PlaceError::TooLarge { .. }
                | PlaceError::BeyondSheet { .. }
                | PlaceError::OutOfReach { .. }
                | PlaceError::WayOutOfReach { .. }
        );
        let mut remedies = REMEDIES.iter().filter(|_| may_fit);
        match remedies.find(|(change, _)| self.fits_with(*change, settings)) {
            Some((_, remedy)) => OptionsError::DoesNotFit { error, remedy },
            None => PrepareError::Place(error).into(),
        }
    }

    /// Whether the drawing can be prepared with a change of its placement.
    fn fits_with(&self, change: fn(&mut PlaceOptions), settings: &Settings) -> bool {
        let Drawable::Sources(all) = &self.what else {
            return false;
        };
        let mut options = self.options.clone();
        change(&mut options.place);
        let is_other = options.place != self.options.place;
        if !is_other || check(&options, all, &self.title).is_err() {
            return false;
        }
        let Ok(placement) = placement(&options, all) else {
            return false;
        };
        let mut sources = all.clone();
        wrap_texts(&mut sources, &options, &placement);
        let settings = Settings {
            placement,
            // The order of the file takes no time to find.
            tries: None,
            progress: Progress::default(),
            ..settings.clone()
        };
        prepare_multi_file(&sources, &settings, reach_of(&settings)).is_ok()
    }

    /// Returns the paper: through the touched points, at the given height, or at the arm's height.
    fn paper(&self, standing_z_mm: f64) -> Result<Paper, OptionsError> {
        let place = &self.options.place;
        let paper = match place.paper.as_deref() {
            Some(&[ax, ay, az, bx, by, bz, cx, cy, cz]) => {
                Paper::through(&[[ax, ay, az], [bx, by, bz], [cx, cy, cz]])?
            }
            _ => self.height(standing_z_mm)?,
        };
        let paper = paper.raised(place.offset);
        let tool = self.settings.tool.end_effector();
        Ok(match &self.settings.calibration {
            Some(known) => paper.to_raw(known.arm(), tool),
            None => paper,
        })
    }

    /// Returns the paper without touched points: at the given height, as calibrated, or at the
    /// arm's height.
    fn height(&self, standing_z_mm: f64) -> Result<Paper, OptionsError> {
        let known = self.settings.calibration.as_ref();
        let calibrated = known.and_then(|file| file.paper.as_ref());
        match (self.options.place.pen_down, calibrated) {
            (None, Some(paper)) => known_paper(paper),
            (given, _) => Ok(Paper::level(given.unwrap_or(standing_z_mm))),
        }
    }
}

/// Shortens a text to a title, which precedes error messages.
fn shortened(text: &str) -> String {
    match text.char_indices().nth(LONGEST_TITLE) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}

/// Returns the selected pen or material; if it is unknown, the error lists the others of its kind.
fn material(options: &ToolOptions, materials: &Materials) -> Result<Material, UnknownMaterial> {
    let burns = options.laser.is_some();
    let name = options.laser.as_ref().unwrap_or(&options.pen);
    let burns_too = |material: &Material| material.tool.burns() == burns;
    let is_of_kind = |name: &String| materials.get(name).is_ok_and(burns_too);
    materials.get(name).copied().map_err(|mut unknown| {
        unknown.known.retain(is_of_kind);
        unknown
    })
}

fn with_options(tool: DrawingTool, options: &ToolOptions) -> Result<DrawingTool, OptionsError> {
    let other_kind = |name: &str, is, field| {
        let name = name.to_owned();
        Err(OptionsError::OtherKind { name, is, field })
    };
    match (tool, &options.laser) {
        (DrawingTool::Pen(pen), None) => Ok(DrawingTool::Pen(Pen {
            lift_mm: options.lift.unwrap_or(pen.lift_mm),
            draw_speed_mm_s: options.speed.unwrap_or(pen.draw_speed_mm_s),
            travel_speed_mm_s: options.travel_speed.unwrap_or(pen.travel_speed_mm_s),
            ..pen
        })),
        (DrawingTool::Laser(laser), Some(_)) => Ok(DrawingTool::Laser(Laser {
            by_stroke: options.passes_by == PassesBy::Shape,
            burn_speed_mm_s: options.speed.unwrap_or(laser.burn_speed_mm_s),
            travel_speed_mm_s: options.travel_speed.unwrap_or(laser.travel_speed_mm_s),
            times: options.passes.unwrap_or(laser.times),
            ..laser
        })),
        (DrawingTool::Pen(_), Some(name)) => other_kind(name, "a pen", "tool.pen"),
        (DrawingTool::Laser(_), None) => {
            other_kind(&options.pen, "burned with the laser", "tool.laser")
        }
    }
}

fn layer_tools(
    what: &ContentOptions,
    materials: &Materials,
) -> Result<Vec<(String, DrawingTool)>, UnknownMaterial> {
    let named = what.layer.iter().map(|layer| {
        let material = materials.get(&layer.pen)?;
        Ok((layer.name.clone(), material.tool))
    });
    named.collect()
}

fn card(options: &Options, tool: DrawingTool, spacing_mm: f64) -> Result<Vec<Pass>, OptionsError> {
    let DrawingTool::Laser(laser) = tool else {
        return Err(OptionsError::CardByPen);
    };
    let (what, default) = (&options.what, Card::default());
    let name = options.tool.laser.clone();
    let card = Card {
        speeds_mm_s: what.card.clone().unwrap_or_default(),
        most_passes: what.card_passes.unwrap_or(default.most_passes),
        travel_speed_mm_s: laser.travel_speed_mm_s,
        cell_mm: what.card_size.unwrap_or(default.cell_mm),
        gap_mm: what.card_gap.unwrap_or(default.gap_mm),
        spacing_mm: what.spacing.unwrap_or(spacing_mm),
        caption: what.card_label.clone().or(name).unwrap_or_default(),
        center: center(options).unwrap_or(default.center),
        ..default
    };
    Ok(card.to_passes()?)
}

fn hatch(what: &ContentOptions, material: &Material) -> Option<Hatch> {
    let spacing_mm = match what.hatch? {
        Spacing::OfTool(_) => material.spacing_mm,
        Spacing::Millimeters(spacing_mm) => spacing_mm,
    };
    Some(Hatch {
        spacing_mm,
        // From behind the arm, left to right is -Y.
        angle_deg: what.hatch_angle - 90.0,
        cross: what.cross,
        style: what.hatch_style,
        inset_mm: what.hatch_inset,
        apart: material.tool.burns(),
    })
}

fn shading(options: &Options, tool: DrawingTool) -> Shading {
    let what = &options.what;
    let shading = what.shade.map_or_else(Shading::default, Shading::new);
    Shading {
        spacing_mm: what.spacing.unwrap_or(shading.spacing_mm),
        brightness: what.brightness / 100.0,
        contrast: what.contrast / 100.0,
        darkness: 1.0 / what.gamma,
        threshold: what.threshold,
        levels: what.levels.unwrap_or(shading.levels),
        invert: what.invert,
        apart: tool.burns(),
        seed: options.way.seed,
        ..shading
    }
}

/// Returns the check whether the arm reaches a position with the tool of these settings.
fn reach_of(settings: &Settings) -> impl Fn(Position) -> Result<(), Unreachable> + use<> {
    let tool = settings.tool.end_effector();
    move |position| {
        let pose = Pose {
            position,
            rotation: position.direction(),
        };
        Limits::STOCK.solve(&pose, tool).map(|_| ())
    }
}

/// A change that may make a drawing fit, and the hint for it.
type Remedy = (fn(&mut PlaceOptions), &'static str);

/// The remedies in the order in which they are tried.
const REMEDIES: [Remedy; 5] = [
    (
        |place| place.landscape |= place.paper_size.is_some() && place.paper.is_none(),
        "use `place.landscape`; then it fits",
    ),
    (
        |place| {
            if place.rotate == 0.0 {
                place.rotate = 90.0;
            }
        },
        "use `place.rotate 90`; then it fits",
    ),
    (
        |place| place.fit |= place.scale.take().is_some(),
        "use `place.fit` instead of `place.scale`; then it fits",
    ),
    (|place| place.fit = true, "use `place.fit`; then it fits"),
    (
        |place| place.clip = true,
        "use `place.clip` to draw only the part that fits",
    ),
];

/// The height of a virtual arm's paper, also used for planning while no arm reports its height: Z,
/// in mm.
pub const WITHOUT_ARM_Z_MM: f64 = -40.0;
/// In characters.
const LONGEST_TITLE: usize = 60;
