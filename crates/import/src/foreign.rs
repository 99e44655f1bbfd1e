//! Files that another program must convert first.

use crate::error::SourceError;

/// Refuses a file that another program must convert, and names the conversion.
pub(super) fn refuse_foreign(bytes: &[u8]) -> Result<(), SourceError> {
    let start = &bytes[..bytes.len().min(1000)];
    match KINDS.iter().find(|kind| (kind.0)(start)) {
        Some(&(_, what, way)) => Err(SourceError::Foreign { what, way }),
        None => Ok(()),
    }
}

/// Whether a file with this start is of the kind, its name, and the next step.
type Kind = (fn(&[u8]) -> bool, &'static str, &'static str);

/// Archives of office programs come before other archives.
const KINDS: [Kind; 15] = [
    (
        |start| has(start, b"%PDF-"),
        "a PDF file",
        "Inkscape opens it and saves it as SVG, and so does `pdftocairo -svg in.pdf out.svg`",
    ),
    (
        |start| start.starts_with(b"%!PS") || start.starts_with(&[0xc5, 0xd0, 0xd3, 0xc6]),
        "a PostScript or EPS file",
        "Inkscape opens it and saves it as SVG, and so do `ps2pdf in.eps in.pdf` and `pdftocairo -svg in.pdf out.svg`",
    ),
    (
        is_html,
        "an HTML page",
        "open it in a browser and save the drawing in it; if it was downloaded as a drawing, download it again",
    ),
    (
        |start| start.starts_with(b"8BPS") || start.starts_with(b"gimp xcf"),
        "a project file of an image editor",
        "export it as PNG",
    ),
    (
        |start| is_media(start, &[b"hei", b"mif1", b"avif"]),
        "an HEIC or AVIF picture",
        "save it as JPEG or PNG; phones have a setting for JPEG",
    ),
    (
        |start| is_media(start, &[b""]),
        "a video or a sound",
        "save one of its pictures as PNG",
    ),
    (
        |start| start.starts_with(b"RIFF") && start.get(8..11) == Some(b"CDR"),
        "a CorelDRAW file",
        "export it as SVG",
    ),
    (
        |start| start.starts_with(&[0xd7, 0xcd, 0xc6, 0x9a]) || start.get(40..44) == Some(b" EMF"),
        "a Windows metafile",
        "Inkscape opens it and saves it as SVG",
    ),
    (
        |start| start.starts_with(b"{\\rtf") || start.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]),
        "a document of an office program",
        OFFICE,
    ),
    (
        |start| is_zip(start) && has(start, b"[Content_Types].xml"),
        "a text document, spreadsheet or presentation",
        OFFICE,
    ),
    (
        |start| is_zip(start) && has(start, b"mimetypeapplication/vnd.oasis.opendocument"),
        "a text document, spreadsheet or presentation",
        OFFICE,
    ),
    (
        |start| {
            let is_stl = start.starts_with(b"solid ") && has(start, b"facet normal");
            is_stl || start.starts_with(b"ISO-10303-21")
        },
        "a 3D model",
        "export a flat drawing of it as DXF or SVG",
    ),
    (
        is_zip,
        "a zip archive",
        "unpack it and use the drawing in it",
    ),
    (
        |start| {
            start.starts_with(b"7z\xbc\xaf\x27\x1c")
                || start.starts_with(b"Rar!")
                || start.get(257..262) == Some(b"ustar")
        },
        "an archive",
        "unpack it and use the drawing in it",
    ),
    (
        |start| start.starts_with(b"version https://git-lfs.github.com/spec/"),
        "a Git LFS pointer instead of the file",
        "run `git lfs pull` in its folder",
    ),
];

fn has(start: &[u8], mark: &[u8]) -> bool {
    start.windows(mark.len()).any(|window| window == mark)
}

fn is_zip(start: &[u8]) -> bool {
    start.starts_with(b"PK\x03\x04")
}

/// Whether a file of the ISO media format has one of these brands.
fn is_media(start: &[u8], brands: &[&[u8]]) -> bool {
    let brand = start
        .get(8..12)
        .filter(|_| start.get(4..8) == Some(b"ftyp"));
    brand.is_some_and(|brand| brands.iter().any(|start| brand.starts_with(start)))
}

/// Whether a page begins, perhaps after comments, and not a drawing that contains one.
fn is_html(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start).to_ascii_lowercase();
    let text = text.trim_start_matches('\u{FEFF}').trim_start();
    let is_end = |c: char| matches!(c, '>' | '/') || c.is_whitespace();
    let tag = |mark: &&str| {
        let mut found = text.match_indices(mark);
        let whole = found.find(|(at, _)| text[at + mark.len()..].starts_with(is_end));
        whole.map(|(at, _)| at)
    };
    let page = ["<!doctype html", "<html", "<head", "<body"];
    let first = page.iter().filter_map(tag).min();
    let drawing = text.find("<svg").unwrap_or(text.len());
    text.starts_with('<') && first.is_some_and(|first| first < drawing)
}

const OFFICE: &str = "export the drawing in it as SVG, or all of it as PDF, which `pdftocairo -svg in.pdf out.svg` converts";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Source;

    #[test]
    fn a_web_page_under_another_name_is_recognised() {
        for page in [
            "<!DOCTYPE html><html>",
            "\u{feff}\n<HTML lang='en'><br>",
            "<html></html>",
            "<html/>",
        ] {
            let error = refuse_foreign(page.as_bytes()).expect_err("a web page");
            assert!(error.to_string().contains("an HTML page"), "{error}");
        }
        for other in ["<svg/>", "<!DOCTYPE svg><svg/>", "<htmlish/>"] {
            assert!(refuse_foreign(other.as_bytes()).is_ok(), "{other}");
        }
    }

    #[test]
    fn files_of_other_programs_are_named_with_the_next_step() {
        let archive = |name: &[u8]| [b"PK\x03\x04-version-sizes-", name].concat();
        for (start, what, step) in [
            (b"%PDF-1.7\n".to_vec(), "a PDF file", "pdftocairo -svg"),
            (
                b"%!PS-Adobe-3.0".to_vec(),
                "a PostScript or EPS file",
                "ps2pdf",
            ),
            (
                b"<!doctype html><p>".to_vec(),
                "an HTML page",
                "download it again",
            ),
            (
                archive(b"[Content_Types].xml"),
                "spreadsheet",
                "export the drawing",
            ),
            (
                archive(b"mimetypeapplication/vnd.oasis.opendocument.spreadsheet"),
                "spreadsheet",
                "export the drawing",
            ),
            (archive(b"a.svg"), "a zip archive", "unpack it"),
            (
                b"\0\0\0\x18ftypheic".to_vec(),
                "an HEIC or AVIF picture",
                "JPEG",
            ),
        ] {
            let error = Source::of_file("drawing.svg", start).expect_err("another program's file");
            let text = error.to_string();
            assert!(text.contains(what) && text.contains(step), "{what}: {text}");
        }
    }
}
