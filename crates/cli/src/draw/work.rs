//! What the options ask for: a source or a test card, and how it is to be drawn.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use anyhow::Context;
use dobot_arm::{Limits, Pose, Position, Unreachable};
use dobot_draw::{
    Card, Hatch, Material, Materials, PlaceError, Placement, PrepareError, Prepared, Settings,
    Size, UnknownMaterial, prepare, prepare_passes,
};
use dobot_geometry::Point;
use dobot_plan::{Laser, Machine, Paper, Pass, Pen, Tool};
use dobot_source::{Align, Font, Shading, Source, SourceError, Text, fontdb};
use dobot_wire::Dialect;

use super::args::{Args, Spacing};
use super::fitting::{Kind, check};
use super::input::read;
use crate::failure::Failure;

/// What is to be drawn, and how, apart from what depends on the arm.
#[derive(Debug)]
pub(super) struct Work {
    pub(super) title: String,
    what: What,
    settings: Settings,
}

#[derive(Debug)]
enum What {
    Source(Source),
    /// Laid out already: the test card.
    Passes(Vec<Pass>),
}

impl What {
    const fn kind(&self) -> Kind {
        match self {
            Self::Passes(_) => Kind::Card,
            Self::Source(Source::Text(_)) => Kind::Text,
            Self::Source(Source::Picture(_)) => Kind::Picture,
            Self::Source(_) => Kind::Lines,
        }
    }
}

impl Work {
    pub(super) fn new(args: &Args) -> Result<Self, Failure> {
        let materials = materials(args.tool.materials.as_deref())?;
        let material = material(args, &materials)?;
        let tool = with_options(material.tool, args)?;
        let (title, what) = match &args.what.card {
            Some(speeds) => ("test card".to_owned(), card(args, speeds, tool)?),
            None => source(args)?,
        };
        check(args, what.kind(), &title)?;
        let fonts = fonts(&what);
        let size = size(args, &what);
        let settings = Settings {
            tolerance_mm: args.way.tolerance,
            placement: placement(args, size),
            tool,
            layers: args.what.layers,
            only: args.what.only.clone(),
            tools: layer_tools(args, &materials)?,
            hatch: hatch(args, &material),
            shading: shading(args),
            clips: args.place.clip,
            tries: (!args.way.keep_order).then_some(args.way.tries),
            seed: args.way.seed,
            from: args.way.from.clone(),
            fonts,
            ..Settings::default()
        };
        Ok(Self {
            title,
            what,
            settings,
        })
    }

    /// Plans it for an arm that speaks this dialect, if that is known, and stands at this height
    /// with its pen on the paper.
    pub(super) fn prepare(
        &self,
        args: &Args,
        dialect: Option<Dialect>,
        standing_z_mm: f64,
    ) -> Result<(Prepared, Settings), Failure> {
        let machine = dialect.map_or_else(Machine::default, Machine::of);
        let settings = Settings {
            paper: paper(args, standing_z_mm)?,
            machine: Machine {
                acceleration_mm_s2: args.tool.acceleration,
                corner_deviation_mm: args.way.tolerance,
                ..machine
            },
            ..self.settings.clone()
        };
        let tool = end_effector(settings.tool);
        let reachable = |position| reachable(position, tool);
        let prepared = match &self.what {
            What::Source(source) => prepare(source, &settings, reachable),
            What::Passes(passes) => prepare_passes(passes.clone(), &settings, reachable),
        };
        match prepared {
            Ok(prepared) => Ok((prepared, settings)),
            Err(error) => Err(self.failure(error)),
        }
    }

    fn failure(&self, error: PrepareError) -> Failure {
        let hint = hint(&error);
        let error = anyhow::Error::from(error).context(self.title.clone());
        match hint {
            Some(hint) => Failure::new(error, hint),
            None => error.into(),
        }
    }
}

/// The materials that are known, and those of a file.
pub(crate) fn materials(file: Option<&Path>) -> Result<Materials, Failure> {
    let known = Materials::built_in();
    let Some(file) = file else {
        return Ok(known);
    };
    let text =
        fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mine = Materials::from_toml(&text).with_context(|| file.display().to_string())?;
    Ok(known.with(mine))
}

/// The pen or the material that was named; where it is unknown, the others of its kind are told.
fn material(args: &Args, materials: &Materials) -> Result<Material, UnknownMaterial> {
    let burns = args.tool.laser.is_some();
    let name = args.tool.laser.as_ref().unwrap_or(&args.tool.pen);
    let is_of_kind = |name: &String| {
        let material = materials.get(name);
        material.is_ok_and(|it| matches!(it.tool, Tool::Laser(_)) == burns)
    };
    materials.get(name).copied().map_err(|mut unknown| {
        unknown.known.retain(is_of_kind);
        unknown
    })
}

fn source(args: &Args) -> Result<(String, What), Failure> {
    if let Some(text) = &args.what.text {
        let text = Text {
            font: Font::of(args.what.font.as_deref().unwrap_or("sans")),
            height_mm: args.what.height.unwrap_or(10.0),
            align: args.what.align.unwrap_or(Align::Left),
            ..Text::new(text.replace("\\n", "\n"))
        };
        let mut lines = text.text.lines();
        let first = lines.find(|it| !it.trim().is_empty());
        return Ok((
            first.unwrap_or("--text").to_owned(),
            What::Source(Source::Text(text)),
        ));
    }
    let file = args.file.as_deref().expect("the options ask for one");
    let (path, name) = match file.file_name() {
        Some(name) if file != Path::new("-") => {
            (file.display().to_string(), name.to_string_lossy())
        }
        _ => (STANDARD_INPUT.to_owned(), STANDARD_INPUT.into()),
    };
    let source = Source::of_file(&name, read(file)?).map_err(|error| match error {
        // It says the name itself.
        SourceError::UnknownKind { .. } if path == name => error.into(),
        _ => anyhow::Error::from(error).context(path),
    })?;
    Ok((name.into_owned(), What::Source(source)))
}

fn card(args: &Args, speeds_mm_s: &[f64], tool: Tool) -> Result<What, Failure> {
    let Tool::Laser(laser) = tool else {
        return Err(Failure::new(
            anyhow::anyhow!("a test card is burned, and the tool is a pen"),
            "add `--laser MATERIAL`; `dobot materials` lists them",
        ));
    };
    let card = Card {
        speeds_mm_s: speeds_mm_s.to_vec(),
        most_passes: args.what.card_passes.unwrap_or(3),
        travel_speed_mm_s: laser.travel_speed_mm_s,
        center: center(args).unwrap_or_else(|| Card::default().center),
        ..Card::default()
    };
    Ok(What::Passes(card.to_passes()?))
}

fn with_options(tool: Tool, args: &Args) -> Result<Tool, Failure> {
    let options = &args.tool;
    Ok(match tool {
        Tool::Pen(pen) if options.laser.is_none() => Tool::Pen(Pen {
            lift_mm: options.lift.unwrap_or(pen.lift_mm),
            draw_speed_mm_s: options.speed.unwrap_or(pen.draw_speed_mm_s),
            travel_speed_mm_s: options.travel_speed.unwrap_or(pen.travel_speed_mm_s),
            ..pen
        }),
        Tool::Laser(laser) if options.laser.is_some() => Tool::Laser(Laser {
            burn_speed_mm_s: options.speed.unwrap_or(laser.burn_speed_mm_s),
            travel_speed_mm_s: options.travel_speed.unwrap_or(laser.travel_speed_mm_s),
            times: options.passes.unwrap_or(laser.times),
        }),
        Tool::Pen(_) => return Err(wrong_kind(options.laser.as_deref(), "a pen", "--pen")),
        Tool::Laser(_) => {
            return Err(wrong_kind(
                Some(&options.pen),
                "burned with the laser",
                "--laser",
            ));
        }
    })
}

fn wrong_kind(name: Option<&str>, is: &str, option: &str) -> Failure {
    let name = name.unwrap_or_default();
    Failure::new(
        anyhow::anyhow!("{name} is {is}"),
        format!("`{option} {name}`; `dobot materials` lists pens and materials"),
    )
}

fn layer_tools(args: &Args, materials: &Materials) -> Result<Vec<(String, Tool)>, Failure> {
    let named = |(layer, name): &(String, String)| {
        let material = materials.get(name)?;
        Ok((layer.clone(), material.tool))
    };
    args.what.layer_tools.iter().map(named).collect()
}

fn placement(args: &Args, size: Size) -> Placement {
    Placement {
        size,
        margin_mm: args.place.margin,
        rotate_deg: args.place.rotate,
        center: center(args),
        ..Placement::default()
    }
}

fn center(args: &Args) -> Option<Point> {
    args.place.at.as_ref().map(|at| Point::new(at[0], at[1]))
}

fn size(args: &Args, what: &What) -> Size {
    let fills = matches!(what, What::Source(source) if !source.has_size());
    match (args.place.fit || fills, args.place.scale) {
        (_, Some(factor)) => Size::Scaled(factor),
        (true, None) => Size::Fit,
        (false, None) => Size::Within,
    }
}

fn hatch(args: &Args, material: &Material) -> Option<Hatch> {
    let spacing_mm = match args.what.hatch? {
        Spacing::OfTool => material.spacing_mm,
        Spacing::Millimeters(spacing_mm) => spacing_mm,
    };
    Some(Hatch {
        spacing_mm,
        // As a person behind the arm sees it: left to right is -Y.
        angle_deg: args.what.hatch_angle - 90.0,
        cross: args.what.cross,
        ..Hatch::default()
    })
}

fn shading(args: &Args) -> Shading {
    let shading = args.what.shade.map_or_else(Shading::default, Shading::new);
    Shading {
        spacing_mm: args.what.spacing.unwrap_or(shading.spacing_mm),
        invert: args.what.invert,
        seed: args.way.seed,
        ..shading
    }
}

/// Where the paper lies: through the touched points, at the height told, or where the arm stands.
fn paper(args: &Args, standing_z_mm: f64) -> Result<Paper, Failure> {
    let paper = match &args.place.paper {
        Some(it) => Paper::through([
            [it[0], it[1], it[2]],
            [it[3], it[4], it[5]],
            [it[6], it[7], it[8]],
        ])?,
        None => Paper::level(args.place.pen_down.unwrap_or(standing_z_mm)),
    };
    Ok(paper.raised(args.place.offset))
}

/// The fonts of this machine, if there is anything to letter.
fn fonts(what: &What) -> Arc<fontdb::Database> {
    let mut fonts = fontdb::Database::new();
    let letters = match what {
        What::Source(Source::Svg(svg)) => svg.contains("<text") || svg.contains(":text"),
        What::Source(Source::Text(text)) => matches!(text.font, Font::Outline(_)),
        _ => false,
    };
    if letters {
        fonts.load_system_fonts();
        name_generic(&mut fonts);
    }
    Arc::new(fonts)
}

/// Takes for each of the families that every file may ask for the first that is here.
fn name_generic(fonts: &mut fontdb::Database) {
    let here = |names: &[&str]| {
        let is_here = |name: &str| {
            fonts
                .faces()
                .any(|it| it.families.iter().any(|it| it.0 == name))
        };
        let name = names.iter().find(|it| is_here(it));
        name.map(|it| (*it).to_owned())
    };
    let [serif, sans, mono, cursive, fantasy] =
        [SERIF, SANS_SERIF, MONOSPACE, CURSIVE, FANTASY].map(here);
    if let Some(name) = serif {
        fonts.set_serif_family(name);
    }
    // Handwriting and display letters are rarer: what is plain comes nearest.
    if let Some(name) = cursive.or_else(|| sans.clone()) {
        fonts.set_cursive_family(name);
    }
    if let Some(name) = fantasy.or_else(|| sans.clone()) {
        fonts.set_fantasy_family(name);
    }
    if let Some(name) = sans {
        fonts.set_sans_serif_family(name);
    }
    if let Some(name) = mono {
        fonts.set_monospace_family(name);
    }
}

/// What the arm carries: the laser is nearer to it than the pen.
const fn end_effector(tool: Tool) -> dobot_arm::Tool {
    match tool {
        Tool::Pen(_) => dobot_arm::Tool::SuctionCup,
        Tool::Laser(_) => dobot_arm::Tool::Laser,
    }
}

fn reachable(position: Position, tool: dobot_arm::Tool) -> Result<(), Unreachable> {
    let pose = Pose {
        position,
        rotation: position.direction(),
    };
    Limits::STOCK.solve(&pose, tool).map(|_| ())
}

fn hint(error: &PrepareError) -> Option<String> {
    match error {
        PrepareError::Place(PlaceError::TooLarge { .. }) => {
            Some("`--fit` makes it as large as the drawing area allows".into())
        }
        PrepareError::Place(PlaceError::OutOfReach { .. }) => Some(
            "`--clip` draws what is within reach; `--fit` without `--at` places it inside; `--pen-down` and `--lift` set the heights".into(),
        ),
        _ => None,
    }
}

const SERIF: &[&str] = &[
    "DejaVu Serif",
    "Liberation Serif",
    "Noto Serif",
    "Times New Roman",
    "Times",
];
const SANS_SERIF: &[&str] = &[
    "DejaVu Sans",
    "Liberation Sans",
    "Noto Sans",
    "Arial",
    "Helvetica",
];
const MONOSPACE: &[&str] = &[
    "DejaVu Sans Mono",
    "Liberation Mono",
    "Noto Sans Mono",
    "Courier New",
    "Menlo",
];
const CURSIVE: &[&str] = &["Comic Neue", "Comic Sans MS", "Apple Chancery"];
const FANTASY: &[&str] = &["Impact", "Papyrus"];

const STANDARD_INPUT: &str = "standard input";

#[cfg(test)]
mod tests {
    use fontdb::{Database, FaceInfo, Family, ID, Language, Source, Stretch, Style, Weight};

    use super::*;

    fn with_fonts(names: &[&str]) -> Database {
        let mut fonts = Database::new();
        for name in names {
            fonts.push_face_info(FaceInfo {
                id: ID::dummy(),
                source: Source::Binary(Arc::new(Vec::<u8>::new())),
                index: 0,
                families: vec![((*name).to_owned(), Language::English_UnitedStates)],
                post_script_name: String::new(),
                style: Style::Normal,
                weight: Weight::NORMAL,
                stretch: Stretch::Normal,
                monospaced: false,
            });
        }
        name_generic(&mut fonts);
        fonts
    }

    #[test]
    fn the_families_that_every_file_may_ask_for_are_fonts_that_are_here() {
        let fonts = with_fonts(&[
            "Liberation Serif",
            "Noto Sans",
            "Liberation Sans",
            "Courier New",
        ]);
        for (family, name) in [
            (Family::Serif, "Liberation Serif"),
            (Family::SansSerif, "Liberation Sans"),
            (Family::Monospace, "Courier New"),
            (Family::Cursive, "Liberation Sans"),
            (Family::Fantasy, "Liberation Sans"),
        ] {
            assert_eq!(fonts.family_name(&family), name);
        }
        let handwriting = with_fonts(&["Noto Sans", "Comic Neue"]);
        assert_eq!(handwriting.family_name(&Family::Cursive), "Comic Neue");
    }
}
