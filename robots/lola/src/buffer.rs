//! Maps in a stream of bytes, in which some may be short, long or damaged.

use crate::mistake::{Mistake, Undecoded};
use crate::sensor_map::{SENSOR_MAP_BYTES, SensorMap};

/// Bytes after which an incomplete map is given up: no map is longer.
const LONGEST: usize = 4 * SENSOR_MAP_BYTES;

/// What was found in the stream.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    /// A valid map.
    Map(Box<SensorMap>),
    /// Bytes that are no valid map, and were dropped.
    Rejected(Mistake),
}

/// Bytes that were received and not yet used.
///
/// Maps have no separator. After bytes that are no map the search goes on at each byte with which a map could begin; one that is
/// decoded as a whole, with all keys, types and the right size, cannot be a part of another one.
#[derive(Debug, Default)]
pub struct MapBuffer {
    bytes: Vec<u8>,
}

impl MapBuffer {
    /// Adds received bytes.
    pub fn push(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
    }

    /// Forgets everything, for a new connection.
    pub fn clear(&mut self) {
        self.bytes.clear();
    }

    /// Whether the next map is here, and valid.
    #[must_use]
    pub fn has_map(&self) -> bool {
        matches!(SensorMap::decode(&self.bytes), Ok((_, SENSOR_MAP_BYTES)))
    }

    /// Takes the next map out; `None` until more bytes are received.
    pub fn next_map(&mut self) -> Option<Found> {
        if self.skip_to_start(0) > 0 {
            return Some(Found::Rejected(Mistake::NoMap));
        }
        if self.bytes.is_empty() {
            return None;
        }
        match SensorMap::decode(&self.bytes) {
            Ok((map, size)) => {
                self.bytes.drain(..size);
                // A map is followed by another one or, so far, by nothing.
                let mistake = match () {
                    () if size != SENSOR_MAP_BYTES => Some(Mistake::Size(size)),
                    () if self.skip_to_start(0) > 0 => Some(Mistake::Trailing),
                    () => None,
                };
                Some(mistake.map_or_else(|| Found::Map(Box::new(map)), Found::Rejected))
            }
            Err(Undecoded::Incomplete) if !self.has_later_map() && self.bytes.len() <= LONGEST => None,
            Err(Undecoded::Incomplete) => {
                self.skip_to_start(1);
                Some(Found::Rejected(Mistake::Size(SENSOR_MAP_BYTES.min(self.bytes.len()))))
            }
            Err(Undecoded::Wrong(mistake)) => {
                self.skip_to_start(1);
                Some(Found::Rejected(mistake))
            }
        }
    }

    /// Whether a whole map lies behind the incomplete one at the front, which then never becomes complete.
    fn has_later_map(&self) -> bool {
        (1..self.bytes.len())
            .filter(|&at| may_begin(&self.bytes[at..]))
            .any(|at| matches!(SensorMap::decode(&self.bytes[at..]), Ok((_, SENSOR_MAP_BYTES))))
    }

    /// Drops the bytes before the first one from `from` on with which a map could begin; returns how many.
    fn skip_to_start(&mut self, from: usize) -> usize {
        let start = (from..self.bytes.len()).find(|&at| may_begin(&self.bytes[at..])).unwrap_or(self.bytes.len());
        self.bytes.drain(..start);
        start
    }
}

/// Whether a map could begin here: the header of a map, then that of a text.
fn may_begin(bytes: &[u8]) -> bool {
    let header = match bytes.first() {
        Some(0x80..=0x8f) => 1,
        Some(0xde) => 3,
        _ => return false,
    };
    bytes.get(header).is_none_or(|key| matches!(key, 0xa0..=0xbf | 0xd9))
}
