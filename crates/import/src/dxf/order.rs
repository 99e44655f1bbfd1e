//! The draw order of entities, if the file changes it.

use std::collections::HashMap;

use super::file::{File, MAX_OBJECTS, Span, too_many};
use super::pairs::{Pair, pairs};
use crate::error::SourceError;

/// Sorts the entities of the drawing and of each block in draw order.
///
/// A SORTENTSTABLE gives entities (331) other handles (5); all entities of its drawing or block are
/// drawn in the order of these handles, the others by their own.
pub(super) fn sort(file: &mut File<'_>) -> Result<(), SourceError> {
    let mut places = HashMap::new();
    for table in file.objects.values() {
        if table.kind == b"SORTENTSTABLE" {
            read(file.text, table, &mut places)?;
        }
    }
    if places.is_empty() {
        return Ok(());
    }
    let blocks = file.blocks.values_mut().map(|block| &mut block.entities);
    for entities in blocks.chain([&mut file.entities]) {
        let sorted = sorted(file.text, entities, &places)?;
        *entities = sorted;
    }
    Ok(())
}

/// Reads the pairs of an entity and its sort handle.
fn read(text: &[u8], table: &Span<'_>, places: &mut HashMap<u64, u64>) -> Result<(), SourceError> {
    let mut entity = None;
    for pair in pairs(&text[..table.end], table.begin) {
        let pair = pair?;
        match pair.code {
            331 => entity = Some(handle(&pair)?),
            // The first is that of the table itself.
            5 => {
                if let Some(entity) = entity.take() {
                    places.insert(entity, handle(&pair)?);
                }
            }
            _ => {}
        }
        if places.len() > MAX_OBJECTS {
            return Err(too_many(text, pair.at));
        }
    }
    Ok(())
}

/// The entities in draw order, each followed by its parts; unchanged if no table names one of them.
fn sorted<'a>(
    text: &'a [u8],
    entities: &[Span<'a>],
    places: &HashMap<u64, u64>,
) -> Result<Vec<Span<'a>>, SourceError> {
    let mut keys = Vec::with_capacity(entities.len());
    let mut is_listed = false;
    for (number, span) in entities.iter().enumerate() {
        let is_part = matches!(span.kind, b"VERTEX" | b"ATTRIB" | b"SEQEND");
        let whole = keys.last().filter(|_| is_part);
        let place = match whole {
            Some(&(place, _)) => place,
            None => match own_handle(text, span)? {
                Some(handle) => {
                    let place = places.get(&handle);
                    is_listed |= place.is_some();
                    place.copied().unwrap_or(handle)
                }
                None => u64::MAX,
            },
        };
        keys.push((place, number));
    }
    if is_listed {
        keys.sort_unstable();
    }
    Ok(keys
        .into_iter()
        .map(|(_, number)| entities[number])
        .collect())
}

fn own_handle(text: &[u8], span: &Span<'_>) -> Result<Option<u64>, SourceError> {
    for pair in pairs(&text[..span.end], span.begin) {
        let pair = pair?;
        match pair.code {
            5 => return handle(&pair).map(Some),
            // The following groups belong to a kind of entity.
            100 => break,
            _ => {}
        }
    }
    Ok(None)
}

fn handle(pair: &Pair<'_>) -> Result<u64, SourceError> {
    let digits = pair.text();
    u64::from_str_radix(&digits, 16).map_err(|_| pair.refused("a handle such as 1F"))
}
