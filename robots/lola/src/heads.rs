//! Angles of the head in the last maps.

use std::collections::VecDeque;
use std::time::Duration;

use bica_motion::joints::Joint;

use crate::sensor_map::SensorMap;

/// Number of maps that are kept: an image that is half a second old is not used.
const KEPT: usize = 64;

/// Times and head angles of the last maps.
///
/// An image of a camera arrives after several maps: exposure, transfer and the driver take 40 ms and more. The head turns meanwhile, by
/// up to 4 rad/s.
#[derive(Debug, Default)]
pub(crate) struct Heads(VecDeque<(Duration, [f32; 2])>);

impl Heads {
    /// Adds a map that came at a time.
    pub(crate) fn push(&mut self, at: Duration, map: &SensorMap) {
        self.0.truncate(KEPT - 1);
        self.0.push_front((at, [Joint::HeadYaw, Joint::HeadPitch].map(|joint| map.position[joint.index()])));
    }

    /// The map with the head angles of the map nearest to this time.
    pub(crate) fn at(&self, taken: Duration, map: &SensorMap) -> SensorMap {
        let nearest = self.0.iter().min_by_key(|(at, _)| at.abs_diff(taken));
        let mut map = *map;
        if let Some((_, [yaw, pitch])) = nearest {
            (map.position[Joint::HeadYaw.index()], map.position[Joint::HeadPitch.index()]) = (*yaw, *pitch);
        }
        map
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn map_has_the_head_of_the_image_s_moment() {
        let (mut heads, mut map) = (Heads::default(), SensorMap::default());
        for number in 0..200_u16 {
            map.position = [f32::from(number); 25];
            heads.push(Duration::from_millis(12 * u64::from(number)), &map);
        }
        for (taken, head) in [(12 * 195 + 5, 195.0), (12 * 195 + 7, 196.0), (99_999, 199.0), (0, 136.0)] {
            let seen = heads.at(Duration::from_millis(taken), &map).position;
            assert_eq!((seen[0], seen[1], seen[2]), (head, head, 199.0), "{taken} ms");
        }
    }
}
