//! The simulated world: a room with a pillar, and the robot in it.

use std::fmt;

use bica::prelude::*;
use bica::runner::World;
use bica::visual::{Pose2, Rectangle, Scene, SceneItem};

use super::robot::{RAYS, Sensors, TRACK_WIDTH, WallFollower, WheelSpeeds};

/// Width of a square of the map, m.
const SQUARE: f32 = 0.25;
/// Length of a cycle, s.
const CYCLE: f32 = 0.02;
/// Number of cycles of a run: 300 s.
const LAST_CYCLE: u64 = 15_000;

/// `#` is a wall, `>` is the start of the robot, which faces to the right.
const MAP: [&str; 18] = [
    "################################",
    "#                              #",
    "#                              #",
    "#                              #",
    "#                              #",
    "#                              #",
    "#                    ###########",
    "#                    #          ",
    "#     >              #          ",
    "#                    #          ",
    "#                    ###########",
    "#                              #",
    "#                              #",
    "########                       #",
    "       #                       #",
    "       #                       #",
    "       #                       #",
    "       #########################",
];

/// The room with the robot in it.
pub(crate) struct Room {
    position: [f32; 2],
    heading: f32,
    rolled: [f32; 2],
    cycle: u64,
    /// Positions of the robot so far, m.
    track: Vec<[f32; 2]>,
}

/// Whether there is a wall at a position, m: x to the right, y up.
fn is_wall([x, y]: [f32; 2]) -> bool {
    let (column, row) = ((x / SQUARE) as usize, MAP.len() as isize - 1 - (y / SQUARE) as isize);
    let row = usize::try_from(row).ok().and_then(|row| MAP.get(row));
    x < 0.0 || y < 0.0 || row.and_then(|row| row.as_bytes().get(column)).is_none_or(|square| *square == b'#')
}

/// The walls of each row of the map.
fn walls() -> Vec<Rectangle> {
    let mut walls = Vec::new();
    for (row, text) in MAP.iter().rev().enumerate() {
        let y = (row as f32 + 0.5) * SQUARE;
        let mut column = 0;
        for run in text.as_bytes().chunk_by(|a, b| (*a == b'#') == (*b == b'#')) {
            let length = run.len() as f32 * SQUARE;
            let x = column as f32 * SQUARE + 0.5 * length;
            if run[0] == b'#' {
                walls.push(Rectangle { x, y, heading: 0.0, length, width: SQUARE });
            }
            column += run.len();
        }
    }
    walls
}

fn ahead([x, y]: [f32; 2], angle: f32, distance: f32) -> [f32; 2] {
    [x + distance * angle.cos(), y + distance * angle.sin()]
}

/// Length of a ray to the next wall, in steps of 5 cm and then of 1 mm, m.
fn cast(from: [f32; 2], angle: f32) -> f32 {
    let hits = |millimetres: u16| is_wall(ahead(from, angle, 1e-3 * f32::from(millimetres)));
    let coarse = (0..20_000).step_by(50).find(|millimetres| hits(*millimetres)).unwrap_or(20_000);
    1e-3 * f32::from((coarse.saturating_sub(50)..coarse).find(|millimetres| hits(*millimetres)).unwrap_or(coarse))
}

impl Room {
    pub(crate) fn new() -> Self {
        let row = MAP.iter().position(|row| row.contains('>')).expect("a start");
        let column = MAP[row].find('>').expect("a start");
        let position = [(column as f32 + 0.5) * SQUARE, ((MAP.len() - row) as f32 - 0.5) * SQUARE];
        Self { position, heading: 0.0, rolled: [0.0; 2], cycle: 0, track: vec![position] }
    }

    /// Whether the robot, with a radius of 0.17 m, ever touched a wall.
    #[cfg(test)]
    pub(crate) fn collided(&self) -> bool {
        self.track.iter().any(|place| (0..16).any(|i| is_wall(ahead(*place, f32::from(i as u8) * 0.393, 0.17))))
    }

    /// Moves the robot to another position in the room, m.
    #[cfg(test)]
    pub(crate) fn put(&mut self, position: [f32; 2], heading: f32) {
        (self.position, self.heading) = (position, heading);
    }
}

impl World<WallFollower> for Room {
    fn now(&self) -> Instant {
        Instant::from_millis(20 * self.cycle)
    }

    fn sensors(&mut self) -> Sensors {
        let angle = |ray: usize| self.heading + ray as f32 * core::f32::consts::TAU / RAYS as f32;
        Sensors { ranges: core::array::from_fn(|ray| cast(self.position, angle(ray))), rolled: self.rolled }
    }

    fn act(&mut self, WheelSpeeds(speeds): &WheelSpeeds) {
        self.rolled = speeds.map(|speed| speed * CYCLE);
        let [left, right] = self.rolled;
        self.heading += (right - left) / TRACK_WIDTH;
        self.position = ahead(self.position, self.heading, 0.5 * (left + right));
        self.track.push(self.position);
        self.cycle += 1;
    }

    fn is_over(&self) -> bool {
        self.cycle >= LAST_CYCLE
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        write!(out, "{self}")
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        scene.show(&SceneItem::new("walls", "room"), &&walls()[..]);
    }

    fn truth(&self, scene: &mut dyn Scene) {
        let pose = |[x, y]: [f32; 2], heading| Pose2 { x, y, heading };
        scene.show(&SceneItem::new("start", "room").place_of("odometry"), &pose(self.track[0], 0.0));
        scene.show(&SceneItem::new("robot", "room").place_of("robot"), &pose(self.position, self.heading));
    }
}

/// The map with the track.
impl fmt::Display for Room {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut map: Vec<Vec<u8>> = MAP.iter().map(|row| row.bytes().collect()).collect();
        let mut draw = |[x, y]: [f32; 2], sign| {
            let (column, row) = ((x / SQUARE) as usize, map.len().saturating_sub(1 + (y / SQUARE) as usize));
            if let Some(square) = map.get_mut(row).and_then(|row| row.get_mut(column)) {
                *square = sign;
            }
        };
        self.track.iter().for_each(|place| draw(*place, b'.'));
        draw(self.track[0], b'>');
        draw(self.position, b'@');
        map.iter().try_for_each(|row| writeln!(f, "{}", String::from_utf8_lossy(row)))
    }
}
