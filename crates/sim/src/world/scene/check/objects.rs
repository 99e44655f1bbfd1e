//! The checks of objects: where they stand, on what, and that no two are in one place.

use std::ops::RangeInclusive;

use dobot_geometry::Point;
use toml::Spanned;

use super::{MAX_G, NEAR_MM, SceneCheck};
use crate::world::color::{color, names};
use crate::world::footprint::Footprint;
use crate::world::scene::SceneError;
use crate::world::scene::file::{self, File};
use crate::world::{Object, Shape};

/// The properties that every object has, whatever its shape.
struct ObjectKeys<'a> {
    name: String,
    line: usize,
    at_mm: &'a Spanned<[f64; 2]>,
    mass_g: Option<&'a Spanned<f64>>,
    color: Option<&'a Spanned<String>>,
    on: Option<&'a Spanned<String>>,
}

/// An object whose height is not known yet.
struct Placed<'a> {
    object: Object,
    line: usize,
    on: Option<&'a Spanned<String>>,
}

impl SceneCheck<'_> {
    /// The objects, in the order of the file, at their heights.
    pub(super) fn objects(&self, file: &File) -> Result<Vec<Object>, SceneError> {
        let mut placed = Vec::new();
        for (i, it) in file.r#box.iter().enumerate() {
            placed.push(self.place_box(it, i + 1)?);
        }
        for (i, it) in file.cylinder.iter().enumerate() {
            placed.push(self.place_cylinder(it, i + 1)?);
        }
        if placed.len() > MAX_OBJECTS {
            return Err(SceneError::Value {
                line: placed[MAX_OBJECTS].line,
                what: "the number of objects".to_owned(),
                found: placed.len().to_string(),
                allowed: format!("up to {MAX_OBJECTS} are allowed"),
            });
        }
        placed.sort_by_key(|it| it.line);
        unique_names(&placed)?;
        self.stack(&mut placed)?;
        apart(&placed)?;
        Ok(placed.into_iter().map(|it| it.object).collect())
    }

    fn place_box<'a>(
        &self,
        it: &'a Spanned<file::Box>,
        number: usize,
    ) -> Result<Placed<'a>, SceneError> {
        let file = it.get_ref();
        let name = self.name(file.name.as_ref(), || format!("box {number}"))?;
        let of = |key: &str| format!("{key} of `{name}`");
        let size_mm = *file.size_mm.get_ref();
        for side in size_mm {
            self.within(&file.size_mm, side, &of("size_mm"), SIZE_MM)?;
        }
        let turn_deg =
            self.optional(file.turn_deg.as_ref(), &of("turn_deg"), -360.0..=360.0, 0.0)?;
        let thing = ObjectKeys {
            name,
            line: self.line(it),
            at_mm: &file.at_mm,
            mass_g: file.mass_g.as_ref(),
            color: file.color.as_ref(),
            on: file.on.as_ref(),
        };
        self.place(thing, Shape::Box { size_mm }, turn_deg)
    }

    fn place_cylinder<'a>(
        &self,
        it: &'a Spanned<file::Cylinder>,
        number: usize,
    ) -> Result<Placed<'a>, SceneError> {
        let file = it.get_ref();
        let name = self.name(file.name.as_ref(), || format!("cylinder {number}"))?;
        let of = |key: &str| format!("{key} of `{name}`");
        let shape = Shape::Cylinder {
            diameter_mm: self.number(&file.diameter_mm, &of("diameter_mm"), SIZE_MM)?,
            height_mm: self.number(&file.height_mm, &of("height_mm"), SIZE_MM)?,
        };
        let thing = ObjectKeys {
            name,
            line: self.line(it),
            at_mm: &file.at_mm,
            mass_g: file.mass_g.as_ref(),
            color: file.color.as_ref(),
            on: file.on.as_ref(),
        };
        self.place(thing, shape, 0.0)
    }

    fn place<'a>(
        &self,
        thing: ObjectKeys<'a>,
        shape: Shape,
        turn_deg: f64,
    ) -> Result<Placed<'a>, SceneError> {
        let name = thing.name;
        let mass = format!("mass_g of `{name}`");
        let object = Object {
            shape,
            at_mm: self.near(thing.at_mm, &name)?,
            turn_deg,
            mass_g: self.optional(thing.mass_g, &mass, MASS_G, 20.0)?,
            color: self.color(thing.color, &name)?,
            bottom_mm: 0.0,
            name,
        };
        self.on_the_table(thing.at_mm, &object)?;
        Ok(Placed {
            object,
            line: thing.line,
            on: thing.on,
        })
    }

    fn name(
        &self,
        name: Option<&Spanned<String>>,
        made: impl FnOnce() -> String,
    ) -> Result<String, SceneError> {
        let Some(span) = name else {
            return Ok(made());
        };
        let name = span.get_ref();
        let long = name.chars().count();
        if (1..=40).contains(&long) && !name.chars().any(char::is_control) && name.trim() == name {
            return Ok(name.clone());
        }
        let allowed =
            "1 to 40 characters on one line, no blanks around them, are allowed".to_owned();
        Err(self.value(span, "a name".to_owned(), format!("{name:?}"), allowed))
    }

    fn color(&self, it: Option<&Spanned<String>>, name: &str) -> Result<String, SceneError> {
        let found = it.map_or("gray", |it| it.get_ref());
        match (color(found), it) {
            (Some(color), _) => Ok(color),
            (None, Some(span)) => {
                let allowed = format!("allowed are #rrggbb, {}", names());
                Err(self.value(
                    span,
                    format!("color of `{name}`"),
                    format!("{found:?}"),
                    allowed,
                ))
            }
            (None, None) => Ok("#8d969c".to_owned()),
        }
    }

    fn near(&self, at: &Spanned<[f64; 2]>, name: &str) -> Result<Point, SceneError> {
        let [x, y] = *at.get_ref();
        if x.hypot(y) <= NEAR_MM {
            return Ok(Point::new(x, y));
        }
        let allowed = format!("a place within {NEAR_MM} mm of the base axis is allowed");
        Err(self.value(
            at,
            format!("at_mm of `{name}`"),
            format!("[{x}, {y}]"),
            allowed,
        ))
    }

    /// Nothing stands in the base of the arm.
    fn on_the_table(&self, at: &Spanned<[f64; 2]>, object: &Object) -> Result<(), SceneError> {
        let base = Footprint::Disc {
            middle: Point::default(),
            radius_mm: BASE_RADIUS_MM,
        };
        if !object.footprint().overlaps(&base) {
            return Ok(());
        }
        let Point { x, y } = object.at_mm;
        let allowed = format!(
            "that is in the base of the arm, which takes {BASE_RADIUS_MM} mm around its axis"
        );
        let what = format!("at_mm of `{}`", object.name);
        Err(self.value(at, what, format!("[{x}, {y}]"), allowed))
    }

    /// Gives those that stand on others their heights: the lower ones first.
    fn stack(&self, placed: &mut [Placed<'_>]) -> Result<(), SceneError> {
        let mut known: Vec<bool> = placed.iter().map(|it| it.on.is_none()).collect();
        while let Some(next) = self.next_to_stack(placed, &known)? {
            let (it, under) = next;
            placed[it].object.bottom_mm = placed[under].object.top_mm();
            known[it] = true;
        }
        Ok(())
    }

    /// One whose height is not known but that of what it stands on.
    fn next_to_stack(
        &self,
        placed: &[Placed<'_>],
        known: &[bool],
    ) -> Result<Option<(usize, usize)>, SceneError> {
        let mut waiting = None;
        let unknown = placed.iter().enumerate().filter(|(i, _)| !known[*i]);
        for (it, on) in unknown.filter_map(|(i, it)| Some((i, it.on?))) {
            let under = placed.iter().position(|it| it.object.name == *on.get_ref());
            let fail = |reason| self.unsupported(&placed[it], on, reason);
            let under = under.ok_or_else(|| fail("there is no object of that name"))?;
            let footprint = placed[it].object.footprint();
            if !footprint.overlaps(&placed[under].object.footprint()) {
                return Err(fail("no part of it is above that"));
            }
            if known[under] {
                return Ok(Some((it, under)));
            }
            waiting.get_or_insert_with(|| fail("they stand on each other in a circle"));
        }
        waiting.map_or(Ok(None), Err)
    }

    fn unsupported(
        &self,
        it: &Placed<'_>,
        on: &Spanned<String>,
        reason: &'static str,
    ) -> SceneError {
        SceneError::Support {
            line: self.line(on),
            name: it.object.name.clone(),
            on: on.get_ref().clone(),
            reason,
        }
    }
}

fn unique_names(placed: &[Placed<'_>]) -> Result<(), SceneError> {
    for (i, it) in placed.iter().enumerate() {
        let name = &it.object.name;
        if let Some(first) = placed[..i].iter().find(|first| first.object.name == *name) {
            return Err(SceneError::NameTwice {
                line: it.line,
                name: name.clone(),
                first_line: first.line,
            });
        }
    }
    Ok(())
}

fn apart(placed: &[Placed<'_>]) -> Result<(), SceneError> {
    for (i, it) in placed.iter().enumerate() {
        let in_it = |other: &&Placed<'_>| {
            let depth_mm = it.object.overlap_mm(&other.object);
            depth_mm.is_some_and(|depth| depth > 0.01)
        };
        if let Some(other) = placed[..i].iter().find(in_it) {
            return Err(SceneError::Overlap {
                line: it.line,
                name: it.object.name.clone(),
                other: other.object.name.clone(),
                other_line: other.line,
            });
        }
    }
    Ok(())
}

/// What the base takes up.
const BASE_RADIUS_MM: f64 = 80.0;
const SIZE_MM: RangeInclusive<f64> = 0.5..=500.0;
const MASS_G: RangeInclusive<f64> = 0.1..=MAX_G;
const MAX_OBJECTS: usize = 500;
