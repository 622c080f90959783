//! The simulated world: a room with a pillar, the robot in it, and a box that an operator may place.

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

/// Half the width of the box, m.
const BOX: f32 = 0.2;
/// Radius of the robot, m.
const ROBOT: f32 = 0.17;

/// The room with the robot in it.
pub(crate) struct Room {
    position: [f32; 2],
    heading: f32,
    /// Middle of the box, m; none until it is placed.
    obstacle: Option<[f32; 2]>,
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

/// What an operator can do.
#[world_actions]
impl Room {
    /// Pushes the robot: it slides and turns.
    #[action]
    fn push(
        &mut self,
        /// Direction on the map, 0 to the right.
        #[range(-3.15..=3.15)]
        #[unit("rad")]
        #[place("room.heading")]
        direction: f32,
        #[range(0.0..=0.5)]
        #[unit("m")]
        #[default(0.2)]
        distance: f32,
        /// Angle by which it turns, to the left if positive.
        #[range(-1.6..=1.6)]
        #[unit("rad")]
        turn: f32,
    ) -> Result<(), &'static str> {
        let position = ahead(self.position, direction, distance);
        if self.is_taken_around(position, ROBOT) {
            return Err("a wall or the box is in the way");
        }
        (self.position, self.heading) = (position, self.heading + turn);
        Ok(())
    }

    /// Places a box in the room, which the lidar sees; there is one.
    #[action(moves = "box")]
    pub(crate) fn place_box(
        &mut self,
        #[range(0.0..=8.0)]
        #[unit("m")]
        #[place("room.x")]
        x: f32,
        #[range(0.0..=4.5)]
        #[unit("m")]
        #[place("room.y")]
        y: f32,
    ) -> Result<(), &'static str> {
        let [dx, dy] = [x - self.position[0], y - self.position[1]];
        if dx.abs().max(dy.abs()) < BOX + ROBOT {
            return Err("the robot is there");
        }
        self.obstacle = Some([x, y]);
        Ok(())
    }
}

impl Room {
    /// Whether a wall or the box is at a position, m.
    fn is_taken(&self, [x, y]: [f32; 2]) -> bool {
        let in_box = |[left, bottom]: [f32; 2]| (x - left).abs().max((y - bottom).abs()) < BOX;
        is_wall([x, y]) || self.obstacle.is_some_and(in_box)
    }

    /// Whether a wall or the box touches a disc, m.
    fn is_taken_around(&self, middle: [f32; 2], radius: f32) -> bool {
        (0..16_u8).any(|i| self.is_taken(ahead(middle, f32::from(i) * 0.393, radius)))
    }

    /// Length of a ray to the next wall, in steps of 5 cm and then of 1 mm, m.
    fn cast(&self, angle: f32) -> f32 {
        let hits = |millimetres: u16| self.is_taken(ahead(self.position, angle, 1e-3 * f32::from(millimetres)));
        let coarse = (0..20_000).step_by(50).find(|millimetres| hits(*millimetres)).unwrap_or(20_000);
        1e-3 * f32::from((coarse.saturating_sub(50)..coarse).find(|millimetres| hits(*millimetres)).unwrap_or(coarse))
    }

    pub(crate) fn new() -> Self {
        let row = MAP.iter().position(|row| row.contains('>')).expect("a start");
        let column = MAP[row].find('>').expect("a start");
        let position = [(column as f32 + 0.5) * SQUARE, ((MAP.len() - row) as f32 - 0.5) * SQUARE];
        Self { position, heading: 0.0, obstacle: None, rolled: [0.0; 2], cycle: 0, track: vec![position] }
    }

    /// Whether the robot ever touched a wall or the box.
    #[cfg(test)]
    pub(crate) fn collided(&self) -> bool {
        self.track.iter().any(|place| self.is_taken_around(*place, ROBOT))
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
        Sensors { ranges: core::array::from_fn(|ray| self.cast(angle(ray))), rolled: self.rolled }
    }

    fn act(&mut self, WheelSpeeds(speeds): &WheelSpeeds) {
        self.rolled = speeds.map(|speed| speed * CYCLE);
        let [left, right] = self.rolled;
        self.heading += (right - left) / TRACK_WIDTH;
        self.position = ahead(self.position, self.heading, 0.5 * (left + right));
        self.track.push(self.position);
        self.cycle += 1;
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        Some(self)
    }

    fn is_over(&self) -> bool {
        self.cycle >= LAST_CYCLE
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        write!(out, "{self}")
    }

    fn figures(&self, figure: &mut dyn FnMut(&'static str, f64, &'static str)) {
        let steps = self.track.windows(2).map(|step| (step[1][0] - step[0][0]).hypot(step[1][1] - step[0][1]));
        figure("travelled", steps.map(f64::from).sum(), "m");
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        scene.show(&SceneItem::new("walls", "room"), &&walls()[..]);
    }

    fn truth(&self, scene: &mut dyn Scene) {
        let pose = |[x, y]: [f32; 2], heading| Pose2 { x, y, heading };
        scene.show(&SceneItem::new("start", "room").child("odometry"), &pose(self.track[0], 0.0));
        scene.show(&SceneItem::new("robot", "room").child("robot"), &pose(self.position, self.heading));
        let (length, width) = (2.0 * BOX, 2.0 * BOX);
        let placed = self.obstacle.map(|[x, y]| Rectangle { x, y, heading: 0.0, length, width });
        scene.show(&SceneItem::new("box", "room"), &placed);
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
