//! A drawing request: the checked options and their content.

use std::sync::Arc;

use dobot_api::CalibrationFile;
use dobot_arm::{Limits, Pose, Position, Unreachable};
use dobot_geometry::Point;
use dobot_import::{Align, Font, Shading, Source, SourceError, Text, system_fonts};
use dobot_plan::{ArmLimits, DrawingTool, Laser, Paper, Pass, Pen};
use dobot_wire::Dialect;

use super::check::check;
use super::{ContentOptions, Options, OptionsError, PassesBy, PlaceOptions, Spacing, ToolOptions};
use crate::arm::calibrated::known_paper;
use crate::layout::place::{AREA, Placement, Size};
use crate::layout::sheet::SheetPlace;
use crate::layout::test_card::Card;
use crate::material::{Material, Materials, UnknownMaterial};
use crate::preparation::cancel::CancelToken;
use crate::preparation::progress::Progress;
use crate::prepare::{NamedSource, Prepared, Settings, prepare_multi_file, prepare_passes};
use crate::strokes::cutting::Cutting;
use crate::strokes::hatch::Hatch;

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
        let Subject { title, sources } = subject;
        let material = material(&options.tool, materials)?;
        let tool = with_options(material.tool, &options.tool)?;
        check(&options, &sources, &title)?;
        let needs_fonts = sources.iter().any(|source| source.source.needs_fonts());
        let settings = Settings {
            tolerance_mm: options.way.tolerance,
            placement: placement(&options, &sources)?,
            grid: options.place.grid,
            gap_mm: options.place.gap,
            tool,
            keeps_speed: options.tool.speed.is_some(),
            layers: options.what.layers,
            only: options.what.only.clone(),
            tools: layer_tools(&options.what, materials)?,
            hatch: hatch(&options.what, &material),
            shading: shading(&options, tool),
            crops: !options.what.no_crop,
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
        let tool = settings.tool.end_effector();
        let reachable = |position| reachable(position, tool);
        let prepared = match &self.what {
            Drawable::Sources(all) => prepare_multi_file(all, &settings, reachable),
            Drawable::Passes(passes) => prepare_passes(passes.clone(), &settings, reachable),
        };
        Ok((prepared?, settings))
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

fn placement(options: &Options, sources: &[NamedSource]) -> Result<Placement, OptionsError> {
    // A picture beside other files has the size given by its resolution.
    let fills = !sources.is_empty() && sources.iter().all(|source| !source.source.has_size());
    let sheet = sheet(&options.place)?;
    Ok(Placement {
        size: match (options.place.fit || fills, options.place.scale) {
            (_, Some(factor)) => Size::Scaled(factor),
            (true, None) => Size::Fit,
            (false, None) => Size::Within,
        },
        margin_mm: options.place.margin,
        rotate_deg: options.place.rotate,
        center: center(options).filter(|_| sheet.is_none()),
        mirrors: options.place.mirror,
        sheet,
        clips: options.place.clip,
        ..Placement::default()
    })
}

/// The height of a virtual arm's paper, also used for planning while no arm reports its height: Z,
/// in mm.
pub const WITHOUT_ARM_Z_MM: f64 = -40.0;
/// The minimum distance of a sheet's lower edge in front of the arm.
const NEAREST_MM: f64 = 140.0;
/// The distance below the sheet's lower edge at which the touches may be, because people rarely hit
/// the edge exactly.
const TOUCHED_BELOW_MM: f64 = 5.0;
/// In characters.
const LONGEST_TITLE: usize = 60;

/// Returns the sheet: through the touched points, at its corner or centre, or as close in front of
/// the arm as its whole lower edge can be reached.
fn sheet(place: &PlaceOptions) -> Result<Option<SheetPlace>, OptionsError> {
    let Some(size) = place.paper_size else {
        return Ok(None);
    };
    let size = if place.landscape {
        size.landscape()
    } else {
        size
    };
    if let Some(&[ax, ay, _, bx, by, _, cx, cy, _]) = place.paper.as_deref() {
        let [a, b, c] = [(ax, ay), (bx, by), (cx, cy)].map(Point::from);
        let touched = SheetPlace::through(size, a, b).ok_or(OptionsError::SamePoint)?;
        let below_mm = touched.on_sheet(c).y - size.height_mm;
        if below_mm > TOUCHED_BELOW_MM {
            return Err(OptionsError::BelowSheet(below_mm));
        }
        return Ok(Some(touched));
    }
    if let Some(&[x_mm, y_mm]) = place.corner.as_deref() {
        let corner = Point::new(x_mm, y_mm);
        return Ok(Some(SheetPlace::from_lower_left(size, corner)));
    }
    let middle = match place.at.as_deref() {
        Some(&[x_mm, y_mm]) => Point::new(x_mm, y_mm),
        _ => Point::new(
            (NEAREST_MM + size.height_mm / 2.0).max(AREA.center().x),
            0.0,
        ),
    };
    Ok(Some(SheetPlace::centered(size, middle)))
}

fn center(options: &Options) -> Option<Point> {
    match options.place.at.as_deref() {
        Some(&[x_mm, y_mm]) => Some(Point::new(x_mm, y_mm)),
        _ => None,
    }
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

fn reachable(position: Position, tool: dobot_arm::Tool) -> Result<(), Unreachable> {
    let pose = Pose {
        position,
        rotation: position.direction(),
    };
    Limits::STOCK.solve(&pose, tool).map(|_| ())
}
