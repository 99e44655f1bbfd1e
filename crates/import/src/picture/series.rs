//! Detection of files with several pictures.

use super::decode::ANIMATION;
use super::format::PictureFormat;

/// The kind of a file with more than one picture; `None` for one picture, or for damage after it.
pub(super) fn series(bytes: &[u8], format: PictureFormat) -> Option<&'static str> {
    match format {
        PictureFormat::Gif => has_further_gif(bytes)?.then_some(ANIMATION),
        PictureFormat::WebP => is_moving_webp(bytes)?.then_some(ANIMATION),
        PictureFormat::Tiff => has_further_page(bytes)?.then_some("file of several pages"),
        _ => None,
    }
}

/// Whether a second image descriptor follows the first.
///
/// ```text
///   GIF89a  size, flags, colours   21 label, blocks   2C place, flags, colours, 1 byte, blocks   2C ...   3B
/// ```
fn has_further_gif(bytes: &[u8]) -> Option<bool> {
    let mut at = 13 + colors(*bytes.get(10)?);
    let mut images = 0;
    loop {
        match bytes.get(at)? {
            0x21 => at += 2,
            0x2c => {
                images += 1;
                at += 11 + colors(*bytes.get(at + 9)?);
            }
            _ => return Some(false),
        }
        if images == 2 {
            return Some(true);
        }
        loop {
            let length = usize::from(*bytes.get(at)?);
            at += 1 + length;
            if length == 0 {
                break;
            }
        }
    }
}

/// The length of a colour table, in bytes.
fn colors(flags: u8) -> usize {
    if flags & 0x80 == 0 {
        return 0;
    }
    3 << ((flags & 7) + 1)
}

/// Whether the flags declare one.
fn is_moving_webp(bytes: &[u8]) -> Option<bool> {
    let is_extended = bytes.get(12..16)? == b"VP8X";
    Some(is_extended && bytes.get(20)? & 2 != 0)
}

/// Whether a second directory follows the first that is not a thumbnail or a mask.
fn has_further_page(bytes: &[u8]) -> Option<bool> {
    let is_little = bytes.starts_with(b"II");
    let number = |at: usize, length: usize| {
        let bytes = bytes.get(at..at.checked_add(length)?)?;
        let add = |sum: usize, byte: &u8| sum << 8 | usize::from(*byte);
        Some(if is_little {
            bytes.iter().rev().fold(0, add)
        } else {
            bytes.iter().fold(0, add)
        })
    };
    let count = |directory: usize| number(directory, 2);
    let first = number(4, 4)?;
    let second = number(first + 2 + 12 * count(first)?, 4)?;
    if second == 0 {
        return Some(false);
    }
    let mut entries = (0..count(second)?).map(|i| second + 2 + 12 * i);
    let kind = entries.find(|&at| number(at, 2) == Some(NEW_SUBFILE_TYPE));
    let kind = kind.map_or(Some(0), |at| number(at + 8, 4))?;
    Some(kind & (SMALLER | MASK) == 0)
}

/// The TIFF tag of the kind of a picture.
const NEW_SUBFILE_TYPE: usize = 254;
const SMALLER: usize = 1;
const MASK: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;

    /// A GIF of this number of one-pixel pictures.
    fn gif(images: usize) -> Vec<u8> {
        let header = b"GIF89a\x01\0\x01\0\x80\0\0\0\0\0\xff\xff\xff";
        let image = b"\x21\xf9\x04\0\0\0\0\0\x2c\0\0\0\0\x01\0\x01\0\0\x02\x02\x44\x01\0";
        [&header[..], &image.repeat(images), b"\x3b"].concat()
    }

    /// A TIFF of two directories, the second with an entry of this tag and value.
    fn tiff(tag: u8, value: u8) -> Vec<u8> {
        let second = [&[1, 0, tag, 0, 4, 0, 1, 0, 0, 0, value][..], &[0; 7]].concat();
        [&b"II*\0\x08\0\0\0\0\0\x0e\0\0\0"[..], &second].concat()
    }

    #[test]
    fn further_pictures_are_found_without_looking_at_their_pixels() {
        let of_gif = |images| series(&gif(images), PictureFormat::Gif);
        assert_eq!([of_gif(1), of_gif(2)], [None, Some(ANIMATION)]);
        let webp = |flags| [&b"RIFF....WEBPVP8X\x0a\0\0\0"[..], &[flags]].concat();
        let of_webp = |flags| series(&webp(flags), PictureFormat::WebP);
        assert_eq!([of_webp(0x10), of_webp(0x12)], [None, Some(ANIMATION)]);
        let of_tiff = |tag, value| series(&tiff(tag, value), PictureFormat::Tiff);
        let pages = Some("file of several pages");
        assert_eq!([of_tiff(254, 2), of_tiff(255, 1)], [pages, pages]);
        // A thumbnail and a mask.
        assert_eq!([of_tiff(254, 1), of_tiff(254, 4)], [None, None]);
    }

    #[test]
    fn a_truncated_file_has_no_further_pictures() {
        for (bytes, format) in [
            (gif(2), PictureFormat::Gif),
            (tiff(254, 0), PictureFormat::Tiff),
        ] {
            for end in 0..bytes.len() - 24 {
                assert_eq!(series(&bytes[..end], format), None);
            }
        }
        assert_eq!(series(b"II*\0\xff\xff\xff\xff", PictureFormat::Tiff), None);
    }
}
