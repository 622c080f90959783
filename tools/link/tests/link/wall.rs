//! The world of the cart: a wall, with images and a scenery.

use bica::action::Actions;
use bica::runner::World;
use bica::visual::{Point2, Pose2, Scene, SceneItem, Segment};
use bica::{Blob, Format, Instant, world_actions};

use crate::robot::CartTree;
use crate::session::CYCLE_US;

/// Wall whose distance is a function of the cycle and of the commands.
pub(crate) struct Wall {
    pub(crate) cycle: u64,
    pub(crate) distance: f32,
}

impl Wall {
    pub(crate) const fn new() -> Self {
        Self { cycle: 0, distance: 2.0 }
    }
}

impl World<CartTree> for Wall {
    fn now(&self) -> Instant {
        Instant::from_micros(self.cycle * CYCLE_US)
    }

    fn sensors(&mut self) -> (f32, Blob<'static>) {
        let format = Format::Yuyv { width: WIDTH as u16, height: HEIGHT as u16 };
        (self.distance, Blob { bytes: &PIXELS, format, frame: CAMERA })
    }

    fn act(&mut self, command: &f32) {
        self.distance -= 0.01 * command;
        // The wall moves, so that commands never become constant.
        if self.cycle.is_multiple_of(300) {
            self.distance += 1.0;
        }
        self.cycle += 1;
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        Some(self)
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        let brick = |x: f32| Segment { start: Point2 { x, y: 0.0 }, end: Point2 { x, y: 1.0 } };
        let lines: Vec<_> = (0..BRICKS).map(|index| brick(index as f32)).collect();
        scene.show(&SceneItem::new("bricks", "road").colour([1, 2, 255]).line_width(0.5), &&lines[..]);
    }

    fn truth(&self, scene: &mut dyn Scene) {
        // The declarations change.
        let item = SceneItem::new("cart", "road").child("cart");
        let colour = [COLOURS[usize::from(is_late(self.cycle.saturating_sub(1)))], 0, 0];
        scene.show(&item.colour(colour), &Pose2 { x: self.distance, y: 0.0, heading: 0.0 });
        scene.show(&SceneItem::new("birds", "road"), &None::<Point2>);
    }
}

/// Number of bricks of the wall: more than one part has room for.
pub(crate) const BRICKS: usize = 200;
/// Red of the cart, early and late.
pub(crate) const COLOURS: [u8; 2] = [10, 20];
/// Name of the camera of every image.
pub(crate) const CAMERA: &str = "left eye";

/// Returns whether the cart has its late colour in a cycle.
pub(crate) const fn is_late(cycle: u64) -> bool {
    cycle / 64 % 2 == 1
}

/// Size of an image.
pub(crate) const WIDTH: usize = 320;
pub(crate) const HEIGHT: usize = 240;

/// Pixels of every image.
pub(crate) static PIXELS: [u8; 2 * WIDTH * HEIGHT] = {
    let mut pixels = [0; 2 * WIDTH * HEIGHT];
    let mut index = 0;
    while index < pixels.len() {
        pixels[index] = (index % 251) as u8;
        index += 1;
    }
    pixels
};

/// Largest distance at which the wall can be placed.
pub(crate) const FARTHEST: f32 = 3.0;

/// What an operator can do with the wall.
#[world_actions]
impl Wall {
    /// Places the wall.
    #[action(moves = "wall")]
    fn place_wall(
        &mut self,
        #[range(0.0..=FARTHEST)]
        #[unit("m")]
        #[place("road.x")]
        x: f32,
    ) -> Result<(), &'static str> {
        if x < 0.01 {
            return Err("the cart is there");
        }
        self.distance = x;
        Ok(())
    }
}
