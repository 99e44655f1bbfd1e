//! The orientation of the camera, from the Exif block of a picture.

/// The changes to the pixels, in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Orientation {
    /// Rows become columns.
    pub(super) transpose: bool,
    /// Left becomes right.
    pub(super) mirror_x: bool,
    /// Top becomes bottom.
    pub(super) mirror_y: bool,
}

impl Orientation {
    /// Reads tag 0x0112 of the first directory; upright if missing.
    pub(super) fn of_exif(exif: &[u8]) -> Self {
        let tiff = exif.strip_prefix(b"Exif\0\0").unwrap_or(exif);
        Self::numbered(orientation(tiff).unwrap_or(1))
    }

    /// The eight orientations of the Exif standard: the stored position of the picture's upper left
    /// corner.
    pub(super) const fn numbered(number: u16) -> Self {
        let (transpose, mirror_x, mirror_y) = match number {
            2 => (false, true, false),
            3 => (false, true, true),
            4 => (false, false, true),
            5 => (true, false, false),
            6 => (true, true, false),
            7 => (true, true, true),
            8 => (true, false, true),
            _ => (false, false, false),
        };
        Self {
            transpose,
            mirror_x,
            mirror_y,
        }
    }
}

fn orientation(tiff: &[u8]) -> Option<u16> {
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
            assert_eq!(Orientation::of_exif(exif), Orientation::numbered(6));
        }
    }

    proptest! {
        #[test]
        fn any_bytes_give_some_orientation(exif in prop::collection::vec(any::<u8>(), 0..100)) {
            Orientation::of_exif(&exif);
        }
    }
}
