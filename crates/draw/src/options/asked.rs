//! What was asked for, checked: what is drawn, and with which settings.

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
use crate::prepare::{NamedSource, Prepared, Settings, prepare_passes, prepare_together};
use crate::strokes::cutting::Cutting;
use crate::strokes::hatch::Hatch;

/// A drawing that was asked for: what it is, and how it is to be drawn apart from what depends on the
/// arm.
#[derive(Clone, Debug)]
pub struct DrawingRequest {
    /// What a person calls it.
    pub title: String,
    options: Options,
    what: Drawable,
    settings: Settings,
}

/// What is to be drawn, with what a person calls it.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The name of a file, the first line of a text.
    pub title: String,
    /// Files, pictures and a text, on one page; none for the test card, which the options tell whole.
    pub sources: Vec<NamedSource>,
}

#[derive(Clone, Debug)]
enum Drawable {
    Sources(Vec<NamedSource>),
    /// Laid out already: the test card.
    Passes(Vec<Pass>),
}

impl Subject {
    /// A file of this name, whose ending or first bytes tell its kind.
    ///
    /// # Errors
    ///
    /// [`SourceError`] where it is none that can be drawn.
    pub fn of_file(name: &str, bytes: Vec<u8>) -> Result<Self, SourceError> {
        Ok(Self::of(name, Source::of_file(name, bytes)?))
    }

    /// Lines of points that a program has calculated: x to the right, y down, in mm; `name` is what a person calls them.
    #[must_use]
    pub fn of_lines(name: &str, lines: Vec<Vec<Point>>) -> Self {
        Self::of(name, Source::Lines(lines))
    }

    /// The text or the test card that the options tell; none where a file is to be drawn.
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
        let first = lines.find(|it| !it.trim().is_empty());
        let title = shortened(first.unwrap_or("text"));
        let text = Text {
            font: Font::of(what.font.as_deref().unwrap_or("sans")),
            height_mm: what.height.unwrap_or(10.0),
            align: what.align.unwrap_or(Align::Left),
            ..Text::new(text)
        };
        Some(Self::of(&title, Source::Text(text)))
    }

    /// This and another one on the same page; what a person calls them names the first, and how many more files
    /// there are.
    #[must_use]
    pub fn and(mut self, mut other: Self) -> Self {
        let first = self.sources.first().map(|it| it.name.clone());
        self.sources.append(&mut other.sources);
        let is_file = |it: &&NamedSource| !matches!(it.source, Source::Text(_));
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
    /// Makes settings of the options, for a drawing with these pens and materials. The fonts of this
    /// machine are read where the drawing has letters that need them.
    ///
    /// # Errors
    ///
    /// [`OptionsError`]: a pen or a material that nobody knows, options that exclude each other or
    /// that would do nothing for this source, a test card that cannot be laid out.
    pub fn new(
        options: Options,
        subject: Subject,
        materials: &Materials,
    ) -> Result<Self, OptionsError> {
        let Subject { title, sources } = subject;
        let material = material(&options.tool, materials)?;
        let tool = with_options(material.tool, &options.tool)?;
        check(&options, &sources, &title)?;
        let needs_fonts = sources.iter().any(|it| it.source.needs_fonts());
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
            join_mm: options.way.join,
            drops_doubles: options.way.drop_doubles,
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

    /// The same for an arm of which is known what is wrong with it.
    #[must_use]
    pub fn calibrated(mut self, calibration: Option<CalibrationFile>) -> Self {
        self.settings.calibration = calibration;
        self
    }

    /// The same, until somebody gives it up.
    #[must_use]
    pub fn until(mut self, cancel: CancelToken) -> Self {
        self.settings.cancel = cancel;
        self
    }

    /// How far its planning is, also for others than who plans it.
    #[must_use]
    pub const fn progress(&self) -> &Progress {
        &self.settings.progress
    }

    /// Plans it for an arm that speaks this dialect, if that is known, and stands at this height
    /// with its pen on the paper, in mm.
    ///
    /// # Errors
    ///
    /// [`OptionsError`] where the paper lies as none can, or the drawing cannot be made so.
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
            Drawable::Sources(all) => prepare_together(all, &settings, reachable),
            Drawable::Passes(passes) => prepare_passes(passes.clone(), &settings, reachable),
        };
        Ok((prepared?, settings))
    }

    /// Where the paper lies: through the touched points, at the height told, or where the arm stands.
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

    /// The paper of which no points are told: at the height told, as calibrated, or where the arm
    /// stands.
    fn height(&self, standing_z_mm: f64) -> Result<Paper, OptionsError> {
        let known = self.settings.calibration.as_ref();
        let calibrated = known.and_then(|it| it.paper.as_ref());
        match (self.options.place.pen_down, calibrated) {
            (None, Some(it)) => known_paper(it),
            (given, _) => Ok(Paper::level(given.unwrap_or(standing_z_mm))),
        }
    }
}

/// A text as a title: in a message it stands before what is wrong with it.
fn shortened(text: &str) -> String {
    match text.char_indices().nth(LONGEST_TITLE) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}

/// The pen or the material that was named; where it is unknown, the others of its kind are told.
fn material(options: &ToolOptions, materials: &Materials) -> Result<Material, UnknownMaterial> {
    let burns = options.laser.is_some();
    let name = options.laser.as_ref().unwrap_or(&options.pen);
    let burns_too = |it: &Material| it.tool.burns() == burns;
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
    let named = what.layer.iter().map(|it| {
        let material = materials.get(&it.pen)?;
        Ok((it.name.clone(), material.tool))
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
    // A picture beside other files is as large as its resolution says.
    let fills = !sources.is_empty() && sources.iter().all(|it| !it.source.has_size());
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

/// Where the paper of a virtual arm lies, and where a drawing is planned while no arm tells its height: Z, in mm.
pub const WITHOUT_ARM_Z_MM: f64 = -40.0;
/// How near before the arm the lower edge of a sheet lies.
const NEAREST_MM: f64 = 140.0;
/// So far below the lower edge of the sheet the pen may have touched the paper: nobody meets an edge.
const TOUCHED_BELOW_MM: f64 = 5.0;
/// In characters.
const LONGEST_TITLE: usize = 60;

/// Where the sheet lies: through the touched points, at its corner or its middle, or as near before the
/// arm as all of its lower edge can be reached.
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
        // As a person behind the arm sees it: left to right is -Y.
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
