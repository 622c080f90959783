//! Content of a world that monitors show: the field, and the true state.

use bica_core::visual::{Circle, List, Point2, Polyline, Pose2, Rectangle, Scene, SceneItem, Segment};
use bica_field::{FIELD, FieldDimensions, GoalColour};
use glam::Vec2;

use crate::referee::Referee;
use crate::setup::MAX_ROBOTS;

/// Frame of the field.
const FRAME: &str = "field";
const GRASS: [u8; 3] = [0x3d, 0x6e, 0x4e];
const MARKING: [u8; 3] = [0xe4, 0xeb, 0xe6];
const YELLOW: [u8; 3] = [0xf2, 0xc1, 0x1d];
const SKY_BLUE: [u8; 3] = [0x4a, 0xa3, 0xff];
/// Radius of the circle that represents another robot, m.
const ROBOT: f32 = 0.15;

/// Shows the carpet of a field and its markings.
pub fn show_field(field: &FieldDimensions, scene: &mut dyn Scene) {
    let rectangle =
        |x: f32, corner: Vec2| Rectangle { x, y: 0.0, heading: 0.0, length: 2.0 * corner.x, width: 2.0 * corner.y };
    let (corner, area) = (field.field_corner(), field.penalty_area_corner());
    let half_area = Vec2::new(0.5 * (corner.x - area.x), area.y);
    let outlines = [
        rectangle(0.0, corner),
        rectangle(corner.x - half_area.x, half_area),
        rectangle(half_area.x - corner.x, half_area),
    ];
    let outlines = outlines.map(|one| Polyline::<5> { points: corners(&one).into_iter().collect() });
    let halfway = Segment { start: Point2 { x: 0.0, y: corner.y }, end: Point2 { x: 0.0, y: -corner.y } };
    let circle = Circle { x: 0.0, y: 0.0, radius: field.centre_circle_radius() };
    let (mark, size) = (field.penalty_mark(), field.penalty_mark_size());
    let marks = [mark, -mark].map(|x| Rectangle { x, y: 0.0, heading: 0.0, length: size, width: size });
    let marking = |name| SceneItem::new(name, FRAME).colour(MARKING);
    let line = |name| marking(name).line_width(field.line_width());
    scene.show(&SceneItem::new("carpet", FRAME).colour(GRASS), &rectangle(0.0, field.carpet_corner()));
    scene.show(&line("lines"), &outlines);
    scene.show(&line("halfway line"), &halfway);
    scene.show(&line("centre circle"), &circle);
    scene.show(&marking("penalty marks"), &marks);
}

/// Corners of a rectangle; the first one is repeated at the end.
fn corners(of: &Rectangle) -> [Point2; 5] {
    let (x, y) = (0.5 * of.length, 0.5 * of.width);
    let corners = [(x, y), (-x, y), (-x, -y), (x, -y), (x, y)];
    corners.map(|(ahead, left)| Point2 { x: of.x + ahead, y: of.y + left })
}

/// Shows the goals and the true state of a world.
pub fn show_truth(referee: &Referee, scene: &mut dyn Scene) {
    let pose = |of: bica_motion::pose::Pose2| Pose2 { x: of.position.x, y: of.position.y, heading: of.heading };
    let circle = |Vec2 { x, y }: Vec2, radius: f32| Circle { x, y, radius };
    let others: List<Circle, MAX_ROBOTS> = referee.others().iter().map(|other| circle(other.position, ROBOT)).collect();
    for (name, is_attacked) in [("attacked goal", true), ("own goal", false)] {
        let [start, end] = FIELD.goal_posts(is_attacked).map(|Vec2 { x, y }| Point2 { x, y });
        let is_blue = is_attacked == (referee.attacks() == GoalColour::SkyBlue);
        let item = SceneItem::new(name, FRAME).colour(if is_blue { SKY_BLUE } else { YELLOW });
        scene.show(&item.line_width(FIELD.post_diameter()), &Segment { start, end });
    }
    scene.show(&SceneItem::new("start", FRAME).child("odometry"), &pose(referee.start()));
    scene.show(&SceneItem::new("robot", FRAME).child("robot"), &pose(referee.robot()));
    scene.show(&SceneItem::new("other robots", FRAME), &others);
    let ball = circle(referee.ball(), FIELD.ball_radius());
    scene.show(&SceneItem::new("ball", FRAME), &ball);
}
