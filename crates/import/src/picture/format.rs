//! The formats of pictures, by the starts of their files.

/// A format of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureFormat {
    Png,
    Jpeg,
    Gif,
    WebP,
    Bmp,
    Tiff,
}

impl PictureFormat {
    /// Its name, as in [`FORMATS`](crate::FORMATS).
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Jpeg => "JPEG",
            Self::Gif => "GIF",
            Self::WebP => "WebP",
            Self::Bmp => "BMP",
            Self::Tiff => "TIFF",
        }
    }
}

/// The format of a file with this start, whatever its name is.
pub(crate) fn format(bytes: &[u8]) -> Option<PictureFormat> {
    let is_webp = bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP");
    let is_bmp = bytes.starts_with(b"BM") && bytes.get(6..10) == Some(&[0; 4]);
    let is_tiff = bytes.starts_with(b"II*\0") || bytes.starts_with(b"MM\0*");
    let formats = [
        (PictureFormat::Png, bytes.starts_with(b"\x89PNG\r\n\x1a\n")),
        (PictureFormat::Jpeg, bytes.starts_with(b"\xff\xd8\xff")),
        (PictureFormat::Gif, bytes.starts_with(b"GIF8")),
        (PictureFormat::WebP, is_webp),
        (PictureFormat::Bmp, is_bmp),
        (PictureFormat::Tiff, is_tiff),
    ];
    formats.into_iter().find(|format| format.1).map(|at| at.0)
}
