//! The fields of an MCAP record, read one after the other.

/// What is left of a record. Nothing is allocated for lengths that the record does not have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fields<'b>(pub(crate) &'b [u8]);

impl<'b> Fields<'b> {
    pub(crate) fn u8(&mut self) -> Option<u8> {
        self.array().map(u8::from_le_bytes)
    }

    pub(crate) fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    pub(crate) fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    pub(crate) fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    /// A text with its length before it.
    pub(crate) fn text(&mut self) -> Option<&'b str> {
        let len = self.u32()?;
        std::str::from_utf8(self.bytes(len.into())?).ok()
    }

    /// Fields with their length before them.
    pub(crate) fn fields(&mut self) -> Option<Self> {
        let len = self.u32()?;
        self.bytes(len.into()).map(Self)
    }

    /// A record: its kind, its length and its fields.
    pub(crate) fn record(&mut self) -> Option<(u8, &'b [u8])> {
        let [kind] = self.array()?;
        let len = self.u64()?;
        Some((kind, self.bytes(len)?))
    }

    pub(crate) fn bytes(&mut self, len: u64) -> Option<&'b [u8]> {
        let (bytes, rest) = self.0.split_at_checked(usize::try_from(len).ok()?)?;
        self.0 = rest;
        Some(bytes)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (array, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*array)
    }
}
