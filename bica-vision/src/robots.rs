//! Detection of other robots: obstacles on the carpet that are not ball, line or goal.
//!
//! Columns are scanned upwards from the bottom of the image. Where green ends, an obstacle begins; it is a robot if it
//! is as high as a robot at that position. Neighbouring columns within a robot's width form one robot; the lowest of
//! their feet is its position. The colour of the waistband and other parts gives the team.
//!
//! The scanned columns are the field boundary's; its search has already read the green below the lowest obstacle.
//!
//! Cost at 320 × 240: 40 columns of up to 120 pixels and the box of each robot.

mod stand;

use bica_core::Params;
use bica_macros::Params;
use glam::Vec2;
use heapless::Vec;

use self::stand::Stand;
use crate::colour::{Classify, Colour, Filter};
use crate::field_boundary::{self, COLUMNS, FieldBoundary};
use crate::frame::{Frame, Pair, Pixel};
use crate::projection::Camera;

/// Maximum number of robots in a frame. Of more, the smallest are dropped.
pub const ROBOTS: usize = 8;

/// Robots of a frame.
pub type Robots = Vec<Robot, ROBOTS>;

/// Minimum height without a known camera pose, as a share of the frame height.
const LEAST_PART: f32 = 0.15;
/// Maximum vertical distance of the feet in neighbouring columns without a known pose, as a share of the frame height.
const STEP: f32 = 0.12;
/// A white obstacle with at least this share of a goal colour is a net, unless it shows a team colour.
const GOAL: f32 = 0.02;

/// Red plastic of the red team: hue 95–121 in recorded frames, 100–106 in the built-in world.
const RED: Filter = Filter::ANY.hue(85, 118).saturation(30, 400).chroma(24);
/// Blue plastic of the blue team, darker and more violet than the sky-blue goal.
const BLUE: Filter = Filter::ANY.hue(334, 359).saturation(30, 400).chroma(16);

/// Maximum width of a robot, m.
const MAX_WIDTH: f32 = 0.9;

/// Detection of other robots in an image.
#[derive(Clone, Copy, Debug, PartialEq, Params)]
#[params(crate = bica_core, check = Self::is_ordered)]
pub struct RobotDetection {
    /// Minimum height of a robot without a gap of green: its shoulders.
    #[param(default = 0.35, range = 0.05..=1.0, unit = "m", step = 0.01)]
    pub min_height: f32,
    /// Maximum height of a robot.
    #[param(default = 0.6, range = 0.05..=1.5, unit = "m", step = 0.01)]
    pub max_height: f32,
    /// Minimum width of a robot.
    #[param(default = 0.08, range = 0.01..=0.9, unit = "m", step = 0.01)]
    pub min_width: f32,
    /// Maximum width of one robot; anything wider is two robots side by side.
    #[param(default = 0.38, range = 0.05..=0.9, unit = "m", step = 0.01)]
    pub max_single_width: f32,
    /// Maximum gap between columns of one robot: the space between arm and leg.
    #[param(default = 0.18, range = 0.01..=0.5, unit = "m", step = 0.01)]
    pub max_gap: f32,
    /// Minimum distance of a foot below the field boundary, as a share of the image height.
    #[param(default = 0.025, range = 0.0..=0.3, step = 0.005)]
    pub boundary_margin: f32,
    /// Length of green that ends a robot, as a share of its minimum height: shoes and shadows contain some green.
    #[param(default = 0.03, range = 0.0..=0.5, step = 0.01)]
    pub max_green: f32,
    /// Maximum share of goal and ball colours in a column of a robot.
    #[param(default = 0.3, range = 0.0..=1.0, step = 0.05)]
    pub max_other_colours: f32,
    /// Minimum share of white in a column of a robot.
    #[param(default = 0.15, range = 0.0..=1.0, step = 0.05)]
    pub min_white: f32,
    /// Minimum share of the team colour in the box around a robot.
    #[param(default = 0.01, range = 0.0..=0.2, step = 0.001)]
    pub min_team_colour: f32,
}

impl RobotDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.min_height > self.max_height {
            Err("`min_height` must not be above `max_height`")
        } else if self.min_width > self.max_single_width {
            Err("`min_width` must not be above `max_single_width`")
        } else {
            Ok(())
        }
    }
}

/// Team of 2009, named by its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Team {
    /// Team that defends the yellow goal.
    Red,
    /// Team that defends the sky-blue goal.
    Blue,
}

/// Another robot in the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robot {
    /// Top left corner of the bounding box, px.
    pub min: Vec2,
    /// Bottom right corner, px, in the row where the robot touches the ground.
    pub max: Vec2,
    /// Team, if its colour is visible.
    pub team: Option<Team>,
    /// Whether the feet are in the image.
    pub has_base: bool,
}

impl Robot {
    /// Middle of the lower edge, px: where the robot touches the ground.
    #[must_use]
    pub fn base(&self) -> Vec2 {
        Vec2::new(0.5 * (self.min.x + self.max.x), self.max.y)
    }

    /// Near edge of the feet, ground frame, m. `None` if it is not on the ground or not in the image.
    #[must_use]
    pub fn ground(&self, camera: &Camera) -> Option<Vec2> {
        camera.ground(self.base(), 0.0).filter(|_| self.has_base)
    }

    /// Whether a pixel is in the bounding box.
    #[must_use]
    pub fn covers(&self, pixel: Vec2) -> bool {
        pixel.cmpge(self.min).all() && pixel.cmple(self.max).all()
    }

    fn area(&self) -> f32 {
        let size = self.max - self.min;
        size.x * size.y
    }
}

/// Finds the robots below the field boundary of the same frame and colours.
///
/// With `camera`, a robot must reach nearly to the horizon, have a robot's width and show a team colour. Without it, a
/// robot is any high obstacle that is not a net.
#[must_use]
pub fn find(
    frame: &Frame<'_>,
    colours: &impl Classify,
    field_boundary: &FieldBoundary,
    camera: Option<&Camera>,
) -> Robots {
    find_tuned(frame, colours, field_boundary, camera, &RobotDetection::DEFAULT)
}

/// Finds the robots as [`find`] does, with thresholds of the caller.
#[must_use]
pub fn find_tuned(
    frame: &Frame<'_>,
    colours: &impl Classify,
    field_boundary: &FieldBoundary,
    camera: Option<&Camera>,
    tuning: &RobotDetection,
) -> Robots {
    let scan = Scan { frame, colours, field_boundary, camera, tuning };
    let pitch = f32::from(frame.width()) / COLUMNS as f32;
    let (mut robots, mut open): (Robots, Option<Group>) = (Vec::new(), None);
    for (column, x) in field_boundary::columns(frame.width()).enumerate() {
        let (left, right) = (column as f32 * pitch, (column + 1) as f32 * pitch);
        let Some(foot) = scan.foot(x, field_boundary.green_below(column)) else { continue };
        let (min, max) = (Vec2::new(left, foot.top), Vec2::new(right, foot.row));
        let is_new = open.as_ref().is_none_or(|group| !scan.belongs(group, max));
        if is_new {
            scan.finish(open.take(), &mut robots);
        }
        open.get_or_insert(Group { min, max, cut: 0, whole: 0 }).grow(min, max, foot.is_cut);
    }
    scan.finish(open, &mut robots);
    robots
}

/// Columns of one robot: bounding box, and numbers of columns cut and not cut by the lower image edge.
struct Group {
    min: Vec2,
    max: Vec2,
    cut: u8,
    whole: u8,
}

impl Group {
    fn grow(&mut self, min: Vec2, max: Vec2, is_cut: bool) {
        (self.min, self.max) = (self.min.min(min), self.max.max(max));
        self.cut += u8::from(is_cut);
        self.whole += u8::from(!is_cut);
    }
}

/// Obstacle in a column: highest row, lowest row, and whether the lowest row is at the image edge.
struct Foot {
    top: f32,
    row: f32,
    is_cut: bool,
}

struct Scan<'a, C> {
    frame: &'a Frame<'a>,
    colours: &'a C,
    field_boundary: &'a FieldBoundary,
    camera: Option<&'a Camera>,
    tuning: &'a RobotDetection,
}

impl<C: Classify> Scan<'_, C> {
    /// Lowest obstacle of a column in which all pixels below the row `lowest` are green.
    fn foot(&self, x: f32, lowest: u16) -> Option<Foot> {
        let end = self.field_boundary.row_at(x)? + self.tuning.boundary_margin * f32::from(self.frame.height());
        // Highest row below the boundary, which itself is not an obstacle.
        let whole = end.max(0.0) as u16;
        let end = whole.saturating_add(u16::from(f32::from(whole) < end));
        let bottom = self.frame.height() - 1;
        let mut pixels = self.frame.column(x as u16).upwards_from(lowest);
        loop {
            let mut is_ground = true;
            let (base, class, least) = loop {
                let (row, pixel) = pixels.next()?;
                if row < end {
                    return None;
                }
                let class = self.colours.classify(pixel);
                if class == Colour::Green {
                    is_ground = true;
                } else if is_ground {
                    if let Some(least) = self.least_rows(x, row) {
                        break (row, class, least);
                    }
                    is_ground = false;
                }
            };
            let mut stand = Stand::new(f32::from(base), least, class, self.tuning);
            while !stand.is_over() {
                let (row, pixel) = pixels.next()?;
                if stand.add(self.colours.classify(pixel), f32::from(row), self.tuning) {
                    return Some(Foot { top: stand.top, row: stand.base, is_cut: base >= bottom });
                }
            }
        }
    }

    /// Minimum number of rows of a robot with its foot here; `None` if it cannot stand here.
    fn least_rows(&self, x: f32, row: u16) -> Option<f32> {
        let pixel = Vec2::new(x, f32::from(row));
        let Some(camera) = self.camera else { return Some(LEAST_PART * f32::from(self.frame.height())) };
        let place = camera.ground(pixel, 0.0)?;
        let top = camera.pixel(place.extend(self.tuning.min_height))?;
        // A robot cut by the upper image edge needs to reach that edge only.
        Some((pixel.y - top.y).min(0.8 * pixel.y).max(6.0))
    }

    /// Whether a column that ends at a pixel belongs to the robot at its left. Arms end above the feet, so a column
    /// belongs if the result is not too wide for one robot.
    fn belongs(&self, robot: &Group, end: Vec2) -> bool {
        let Some(camera) = self.camera else {
            return (end.y - robot.max.y).abs() <= STEP * f32::from(self.frame.height());
        };
        let row = end.y.max(robot.max.y);
        let [left, last, right] = [robot.min.x, robot.max.x, end.x].map(|x| camera.ground(Vec2::new(x, row), 0.0));
        let (Some(left), Some(last), Some(right)) = (left, last, right) else { return false };
        left.distance(right) <= self.tuning.max_single_width && last.distance(right) <= self.tuning.max_gap
    }

    fn finish(&self, group: Option<Group>, robots: &mut Robots) {
        let Some(robot) = group.and_then(|group| self.measured(&group)) else { return };
        let Err(robot) = robots.push(robot) else { return };
        let smallest = robots.iter_mut().min_by(|a, b| a.area().total_cmp(&b.area()));
        if let Some(smallest) = smallest.filter(|smallest| smallest.area() < robot.area()) {
            *smallest = robot;
        }
    }

    /// Robot with full height and team, if it has a robot's width. A robot cut in all columns may be the own body.
    fn measured(&self, group: &Group) -> Option<Robot> {
        if group.whole == 0 {
            return None;
        }
        let mut robot = Robot { min: group.min, max: group.max, team: None, has_base: group.cut == 0 };
        if let Some(camera) = self.camera {
            let [left, right] = [robot.min.x, robot.max.x].map(|x| camera.ground(Vec2::new(x, robot.max.y), 0.0));
            let (left, right) = (left?, right?);
            let width = left.distance(right);
            if !(self.tuning.min_width..=MAX_WIDTH).contains(&width) {
                return None;
            }
            let top = camera.pixel(left.midpoint(right).extend(self.tuning.max_height))?;
            robot.min.y = robot.min.y.min(top.y.max(0.0));
        }
        let [red, blue] = self.team_colours(&robot);
        let least = self.tuning.min_team_colour;
        robot.team = match (red >= least, blue >= least) {
            (true, _) if red > 2.0 * blue => Some(Team::Red),
            (_, true) if blue > 2.0 * red => Some(Team::Blue),
            _ => None,
        };
        let stands_alone = self.camera.is_none() && !self.is_net(&robot);
        (red.max(blue) >= least || stands_alone).then_some(robot)
    }

    /// Whether the box shows a goal colour.
    fn is_net(&self, robot: &Robot) -> bool {
        let (mut goal, mut all) = (0_u32, 0_u32);
        for row in (robot.min.y as u16..=robot.max.y as u16).step_by(2) {
            for pixel in self.pixels(robot, row) {
                goal += u32::from(matches!(self.colours.classify(pixel), Colour::Yellow | Colour::Blue));
                all += 1;
            }
        }
        goal as f32 > GOAL * all as f32
    }

    /// Pixels of a row within the robot's box.
    fn pixels(&self, robot: &Robot, row: u16) -> impl Iterator<Item = Pixel> + use<'_, C> {
        let pairs = self.frame.row(row).get(robot.min.x as usize / 2..).unwrap_or(&[]);
        let width = ((robot.max.x - robot.min.x) as usize / 2).max(1);
        pairs.iter().take(width).map(|pair| Pair(*pair).mean())
    }

    /// Shares of the robot's box with each team colour.
    fn team_colours(&self, robot: &Robot) -> [f32; 2] {
        let (mut red, mut blue, mut all) = (0_u32, 0_u32, 0_u32);
        for row in (robot.min.y as u16..=robot.max.y as u16).step_by(2) {
            for pixel in self.pixels(robot, row) {
                red += u32::from(RED.accepts(pixel));
                blue += u32::from(BLUE.accepts(pixel));
                all += 1;
            }
        }
        [red, blue].map(|count| count as f32 / all.max(1) as f32)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use proptest::prelude::*;

    use super::*;

    const WIDTH: u16 = 80;
    const HEIGHT: u16 = 60;

    /// Classifier by luma alone.
    struct ByLuma;

    impl Classify for ByLuma {
        fn classify(&self, pixel: Pixel) -> Colour {
            Colour::from_index(pixel.y)
        }
    }

    /// Carpet with upright boxes of all classes.
    fn frame() -> impl Strategy<Value = std::vec::Vec<u8>> {
        let one = (0..WIDTH / 2, 0..HEIGHT, 1..10_u16, 1..40_u16, 0..6_u8);
        prop::collection::vec(one, 0..8).prop_map(|boxes| {
            let mut pairs =
                std::vec![[Colour::Green as u8, 128, Colour::Green as u8, 128]; (WIDTH / 2 * HEIGHT).into()];
            for (left, top, width, height, class) in boxes {
                for (y, x) in (top..top + height).flat_map(|y| (left..left + width).map(move |x| (y, x))) {
                    if y < HEIGHT && x < WIDTH / 2 {
                        pairs[usize::from(y * (WIDTH / 2) + x)] = [class, 128, class, 128];
                    }
                }
            }
            pairs.into_flattened()
        })
    }

    #[test]
    fn sizes_are_ordered() {
        let robot = RobotDetection::DEFAULT;
        assert!(RobotDetection { min_height: 0.61, ..robot }.is_ordered().is_err());
        assert!(RobotDetection { min_width: 0.39, ..robot }.is_ordered().is_err());
        assert!(RobotDetection { max_single_width: 0.07, ..robot }.is_ordered().is_err());
        assert!(RobotDetection { max_single_width: 0.08, ..robot }.is_ordered().is_ok());
    }

    proptest! {
        #[test]
        fn robots_are_those_of_search_in_all_rows(bytes in frame()) {
            let frame = Frame::new(WIDTH, HEIGHT, &bytes).expect("a frame");
            let boundary = FieldBoundary::find(&frame, &ByLuma);
            let expected = find(&frame, &ByLuma, &boundary.without_columns(), None);
            prop_assert_eq!(find(&frame, &ByLuma, &boundary, None), expected);
        }
    }
}
