//! Fields of a packet, one after the other.

/// Reader of a packet whose length was checked before.
pub(crate) struct Reader<'a>(pub(crate) &'a [u8]);

impl Reader<'_> {
    /// Returns the next `N` bytes; zeros beyond the end.
    pub(crate) fn take<const N: usize>(&mut self) -> [u8; N] {
        let (bytes, rest) = self.0.split_first_chunk().unwrap_or((&[0; N], &[]));
        self.0 = rest;
        *bytes
    }

    /// Returns the next byte.
    pub(crate) fn byte(&mut self) -> u8 {
        let [byte] = self.take();
        byte
    }
}

/// Writer of a packet into memory that is large enough.
pub(crate) struct Writer<'a> {
    bytes: &'a mut [u8],
    written: usize,
}

impl<'a> Writer<'a> {
    /// Creates a writer at the start of `bytes`.
    pub(crate) const fn new(bytes: &'a mut [u8]) -> Self {
        Self { bytes, written: 0 }
    }

    /// Writes bytes; what does not fit is left out.
    pub(crate) fn put(&mut self, bytes: &[u8]) {
        if let Some(place) = self.bytes.get_mut(self.written..self.written + bytes.len()) {
            place.copy_from_slice(bytes);
            self.written += bytes.len();
        }
    }

    /// Returns the number of written bytes.
    pub(crate) const fn written(&self) -> usize {
        self.written
    }
}
