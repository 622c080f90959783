//! The check that tells a damaged packet from a whole one.

/// The generator polynomial of CRC-32/ISO-HDLC (ITU-T V.42), bits reversed.
const POLYNOMIAL: u32 = 0xedb8_8320;

/// One entry for every half byte: a sixteenth of the usual table, for the sake of small memories.
const TABLE: [u32; 16] = {
    let mut table = [0; 16];
    let mut entry = 0;
    while entry < 16 {
        let (mut value, mut bit) = (entry as u32, 0);
        while bit < 4 {
            value = (value >> 1) ^ (POLYNOMIAL & (value & 1).wrapping_neg());
            bit += 1;
        }
        table[entry] = value;
        entry += 1;
    }
    table
};

/// CRC-32/ISO-HDLC, the one of Ethernet and zip.
///
/// It notices every burst of damage up to 32 bits, and all but one of 2³² others.
///
/// ```
/// assert_eq!(bica_wire::crc32(b"123456789"), 0xcbf4_3926);
/// ```
#[must_use]
pub fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = Crc32::new();
    for &byte in bytes {
        crc.add(byte);
    }
    crc.value()
}

/// The same, byte by byte.
pub(crate) struct Crc32(u32);

impl Crc32 {
    /// Of no bytes.
    pub(crate) const fn new() -> Self {
        Self(!0)
    }

    /// Takes the next byte in.
    pub(crate) const fn add(&mut self, byte: u8) {
        let crc = self.0 ^ byte as u32;
        let crc = (crc >> 4) ^ TABLE[(crc & 15) as usize];
        self.0 = (crc >> 4) ^ TABLE[(crc & 15) as usize];
    }

    /// The check of all bytes so far.
    pub(crate) const fn value(&self) -> u32 {
        !self.0
    }
}
