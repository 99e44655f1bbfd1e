//! Why a packet is not the command or the status that it claims to be.

/// Why a packet is not the command or the status that it claims to be.
///
/// The text states the field, the value found, the allowed values and the source.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ParseError {
    /// Float 1 names none of the states of Table 2.2.
    #[error("float 1 (state) is {0}; Table 2.2 knows 1 to 10")]
    UnknownState(f32),

    /// The floats have their high byte first.
    #[error(
        "the floats are big-endian: float 1 (state) would be {0}; send the low byte of each float first (Table 2.1)"
    )]
    BigEndian(f32),

    /// Float 1 is 5, but voice commands do not travel as floats (note N17).
    #[error("float 1 (state) is 5; note N17 wants voice commands as text between B5 and 5B")]
    VoiceAsFloats,

    /// A float is outside the range of its table.
    #[error("float {float} ({name}) is {found}; {table} allows {allowed}")]
    OutOfRange {
        /// The number of the float, counted from 1 as in the tables.
        float: usize,
        /// The name of the float in its table.
        name: &'static str,
        /// The value found.
        found: f32,
        /// The allowed values.
        allowed: &'static str,
        /// The table or note that defines them.
        table: &'static str,
    },

    /// A voice text is longer than a packet can hold.
    #[error("the voice text is {found} bytes long; note N17 allows up to 40")]
    VoiceTooLong {
        /// Its length in bytes.
        found: usize,
    },

    /// A voice text holds something else than printable ASCII.
    #[error("byte {byte} of the voice text is {found:#04x}; note N17 allows printable ASCII")]
    VoiceByte {
        /// The number of the byte, counted from 1.
        byte: usize,
        /// The value found.
        found: u8,
    },
}
