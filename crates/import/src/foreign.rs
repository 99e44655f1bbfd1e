//! Files that another program must convert first.

use crate::error::SourceError;

/// Refuses a file that another program must convert, and names the conversion.
pub(super) fn refuse_foreign(bytes: &[u8]) -> Result<(), SourceError> {
    let start = &bytes[..bytes.len().min(1000)];
    let has = |mark: &[u8]| start.windows(mark.len()).any(|start| start == mark);
    let converted =
        "Inkscape opens it and saves it as SVG, and so does `pdftocairo -svg in.pdf out.svg`";
    let kinds = [
        (has(b"%PDF-"), "a PDF file", converted),
        (
            start.starts_with(b"%!PS") || start.starts_with(&[0xc5, 0xd0, 0xd3, 0xc6]),
            "a PostScript or EPS file",
            "Inkscape opens it and saves it as SVG, and so do `ps2pdf in.eps in.pdf` and `pdftocairo -svg in.pdf out.svg`",
        ),
        (
            is_html(start),
            "an HTML page",
            "download the file itself: the address leads to a page about it, or to an error",
        ),
        (
            start.starts_with(b"8BPS") || start.starts_with(b"gimp xcf"),
            "a project file of an image editor",
            "export it as PNG",
        ),
        (
            start.get(4..12).is_some_and(|start| {
                start.starts_with(b"ftyphei")
                    || start.starts_with(b"ftypmif1")
                    || start.starts_with(b"ftypavif")
            }),
            "an HEIC or AVIF picture",
            "save it as JPEG or PNG; phones have a setting for JPEG",
        ),
        (
            start.starts_with(b"version https://git-lfs.github.com/spec/"),
            "a Git LFS pointer instead of the file",
            "run `git lfs pull` in its folder",
        ),
        (
            start.starts_with(b"PK\x03\x04"),
            "a zip archive",
            "unpack it and use the drawing in it",
        ),
    ];
    match kinds.into_iter().find(|kind| kind.0) {
        Some((_, what, way)) => Err(SourceError::Foreign { what, way }),
        None => Ok(()),
    }
}

/// Whether a file is a web page, which a browser saves under any name.
fn is_html(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start).to_ascii_lowercase();
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let is_tag = |rest: &str| rest.starts_with(|sign: char| sign == '>' || sign.is_whitespace());
    text.starts_with("<!doctype html") || text.strip_prefix("<html").is_some_and(is_tag)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_web_page_under_another_name_is_recognised() {
        for page in [
            "<!DOCTYPE html><html>",
            "\u{feff}\n<HTML lang='en'><br>",
            "<html></html>",
        ] {
            let error = refuse_foreign(page.as_bytes()).expect_err("a web page");
            assert!(error.to_string().contains("an HTML page"), "{error}");
        }
        for other in ["<svg/>", "<!DOCTYPE svg><svg/>", "<htmlish/>"] {
            assert!(refuse_foreign(other.as_bytes()).is_ok(), "{other}");
        }
    }
}
