//! Header of an image in the stream.

use bica_motion::robot::CameraId;

/// Size of the header, bytes.
pub(crate) const HEADER_BYTES: usize = 32;
/// First bytes of a header.
const MAGIC: &[u8] = b"FRM1";
/// Time from one sensor map of a NAO to the next, µs.
const CYCLE_MICROS: u64 = 12_000;
/// Sizes of images, px.
const SIZES: [(u16, u16); 2] = [(640, 480), (320, 240)];

/// Header of an image. All numbers are little-endian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Header {
    /// Source of the image.
    pub camera: CameraId,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// Number of the sensor map to which the image belongs, from 0.
    pub number: u32,
}

impl Header {
    /// Number of bytes of the pixels, YUYV 4:2:2.
    #[must_use]
    pub fn pixel_bytes(&self) -> usize {
        2 * usize::from(self.width) * usize::from(self.height)
    }

    /// Decodes a header.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn decode(bytes: &[u8; 32]) -> Result<Self, &'static str> {
        let half = |at: usize| u16::from_le_bytes([bytes[at], bytes[at + 1]]);
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let camera = match (&bytes[..4], bytes[4]) {
            (MAGIC, 0) => CameraId::Top,
            (MAGIC, 1) => CameraId::Bottom,
            (MAGIC, _) => return Err("the camera is neither 0 (top) nor 1 (bottom)"),
            _ => return Err("it does not begin with FRM1"),
        };
        let header = Self { camera, width: half(8), height: half(10), number: word(12) };
        match () {
            () if bytes[5] != 0 => Err("the format is not 0 (YUYV)"),
            () if !SIZES.contains(&(header.width, header.height)) => Err("the size is neither 640x480 nor 320x240"),
            () if word(24) as usize != header.pixel_bytes() => Err("the number of bytes does not fit the size"),
            () => Ok(header),
        }
    }

    /// Encodes the header, for stand-ins. The time is that of a stand-in that runs in step.
    #[must_use]
    pub fn encode(&self) -> [u8; 32] {
        let mut bytes = [0; HEADER_BYTES];
        bytes[..4].copy_from_slice(MAGIC);
        bytes[4] = u8::from(self.camera == CameraId::Bottom);
        bytes[8..10].copy_from_slice(&self.width.to_le_bytes());
        bytes[10..12].copy_from_slice(&self.height.to_le_bytes());
        bytes[12..16].copy_from_slice(&self.number.to_le_bytes());
        bytes[16..24].copy_from_slice(&(CYCLE_MICROS * u64::from(self.number)).to_le_bytes());
        bytes[24..28].copy_from_slice(&(self.pixel_bytes() as u32).to_le_bytes());
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: Header = Header { camera: CameraId::Bottom, width: 320, height: 240, number: 0x0102_0304 };

    #[test]
    fn header_has_the_documented_layout() {
        let bytes = HEADER.encode();
        assert_eq!(bytes[..16], *b"FRM1\x01\x00\x00\x00\x40\x01\xf0\x00\x04\x03\x02\x01");
        assert_eq!(bytes[24..28], (2 * 320 * 240_u32).to_le_bytes());
        assert_eq!(Header::decode(&bytes), Ok(HEADER));
    }

    #[test]
    fn wrong_headers_are_refused_with_the_reason() {
        for (at, value, reason) in
            [(0, b'X', "FRM1"), (4, 2, "camera"), (5, 1, "format"), (8, 0x41, "size"), (24, 1, "bytes")]
        {
            let mut bytes = HEADER.encode();
            bytes[at] = value;
            assert!(Header::decode(&bytes).is_err_and(|why| why.contains(reason)), "{reason}");
        }
    }
}
