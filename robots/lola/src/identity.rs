//! Who the robot is.

use core::fmt;

/// Longest text that is kept, bytes: a serial number has 20.
const LONGEST: usize = 20;

/// Serial number and version of the robot's body, then of its head. Longer texts are cut off; the default is a stand-in's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Identity([[u8; LONGEST]; 4]);

impl Identity {
    /// The identity in a sensor map.
    #[must_use]
    pub fn new(texts: [&[u8]; 4]) -> Self {
        Self(texts.map(|text| core::array::from_fn(|i| text.get(i).copied().unwrap_or_default())))
    }

    /// The texts, in the order of the sensor map.
    #[must_use]
    pub fn texts(&self) -> [&str; 4] {
        self.0.each_ref().map(|text| {
            let end = text.iter().position(|&byte| byte == 0).unwrap_or(LONGEST);
            str::from_utf8(&text[..end]).unwrap_or_default()
        })
    }
}

impl Default for Identity {
    fn default() -> Self {
        Self::new([b"P0000000A00S00I00000", b"6.0.0", b"P0000000A00S00I00000", b"6.0.0"])
    }
}

impl fmt::Display for Identity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [body, body_version, head, head_version] = self.texts();
        write!(f, "body {body}, version {body_version}; head {head}, version {head_version}")
    }
}
