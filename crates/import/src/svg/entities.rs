//! Limits on entities: abbreviations that a hostile file could use to fill the memory.

use crate::error::SvgError;
use crate::place::place;

/// Refuses entities that expand to much more than the file. Drawing programs declare a few short
/// ones for their namespaces; no drawing needs nested or external ones.
pub(crate) fn check(text: &str) -> Result<(), SvgError> {
    let Some(first) = text.find("<!ENTITY") else {
        return Ok(());
    };
    let end = first + text[first..].find("]>").unwrap_or(text.len() - first);
    let (declared, used) = text[first..].split_at(end - first);
    let refuse = |problem| {
        Err(SvgError::Entities {
            place: place(text.as_bytes(), first),
            problem,
        })
    };
    if refers_to_another(declared) {
        return refuse("further entities");
    }
    let references = used.bytes().filter(|&byte| byte == b'&').count();
    if declared.len().saturating_mul(references) > LIMIT {
        return refuse("more than 2 million characters");
    }
    Ok(())
}

fn refers_to_another(declared: &str) -> bool {
    let mut references = declared.split('&').skip(1);
    references.any(|rest| {
        !["#", "amp;", "lt;", "gt;", "quot;", "apos;"]
            .iter()
            .any(|s| rest.starts_with(s))
    })
}

const LIMIT: usize = 2_000_000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_namespaces_of_drawing_programs_are_accepted() {
        let text = "<!DOCTYPE svg [\n<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n]>\n<svg xmlns=\"&ns_svg;\"/>";
        assert_eq!(check(text), Ok(()));
    }

    #[test]
    fn a_billion_laughs_attack_is_refused_and_its_place_is_named() {
        let text = "<!DOCTYPE svg [\n <!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">]><svg>&b;</svg>";
        let error = check(text).expect_err("entities in entities");
        assert_eq!(
            error.to_string(),
            "2:2: entities that expand to further entities; save the file without a DOCTYPE"
        );
    }

    #[test]
    fn many_uses_of_a_long_entity_are_refused() {
        let long = "x".repeat(10_000);
        let uses = "&a;".repeat(2_000);
        let text = format!("<!DOCTYPE svg [<!ENTITY a \"{long}\">]><svg>{uses}</svg>");
        assert!(matches!(check(&text), Err(SvgError::Entities { .. })));
    }
}
