//! The orientation of the camera, from the Exif block of a picture.

use dobot_shading::Orientation;

/// Reads tag 0x0112 of the first directory; upright if missing.
pub(super) fn orientation(exif: &[u8]) -> Orientation {
    let tiff = exif.strip_prefix(b"Exif\0\0").unwrap_or(exif);
    Orientation::numbered(number(tiff).unwrap_or(1))
}

fn number(tiff: &[u8]) -> Option<u16> {
    let little = tiff.starts_with(b"II");
    let short = |at: usize| {
        let bytes = tiff.get(at..at.checked_add(2)?)?.try_into().ok()?;
        Some(if little {
            u16::from_le_bytes(bytes)
        } else {
            u16::from_be_bytes(bytes)
        })
    };
    let offset = tiff.get(4..8)?.try_into().ok()?;
    let directory = if little {
        u32::from_le_bytes(offset)
    } else {
        u32::from_be_bytes(offset)
    };
    let directory = usize::try_from(directory).ok()?;
    let entries = usize::from(short(directory)?);
    let mut places = (0..entries).map(|entry| directory + 2 + 12 * entry);
    let place = places.find(|&place| short(place) == Some(ORIENTATION))?;
    short(place + 8)
}

const ORIENTATION: u16 = 0x0112;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn both_byte_orders_are_read() {
        let intel = b"Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
        let motorola = b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0";
        for exif in [intel.as_slice(), motorola] {
            assert_eq!(orientation(exif), Orientation::numbered(6));
        }
    }

    proptest! {
        #[test]
        fn any_bytes_give_some_orientation(exif in prop::collection::vec(any::<u8>(), 0..100)) {
            orientation(&exif);
        }
    }
}
