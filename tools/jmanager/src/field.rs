//! The soccer field and the true state of a game, as what a map draws.

use bica::visual::{Circle, List, Point2, Polyline, Pose2, Rectangle, Segment};
use bica_field::FIELD;
use bica_link::Description;
use bica_monitor::program::Scene;
use bica_monitor::protocol::Drawn;
use bica_wire::message::Truth;
use glam::Vec2;

/// Frame of the field: origin in the middle, x to the attacked goal, y to the left.
const FRAME: &str = "field";
const GRASS: &str = "#3d6e4e";
const MARKING: &str = "#e4ebe6";
const GOAL_COLOURS: [&str; 2] = ["#f2c11d", "#4aa3ff"];
/// Radius that shows another robot, m.
const ROBOT: f32 = 0.15;

/// The field, for robots that give outputs in its frame.
pub(crate) struct Field;

impl Scene for Field {
    fn scenery(&self, description: &Description) -> Vec<Drawn> {
        let outputs = description.components.iter().flat_map(|component| &component.info);
        let is_on_field = outputs.filter_map(|info| info.placement.as_ref()).any(|place| place.frame == FRAME);
        if is_on_field { scenery() } else { Vec::new() }
    }

    fn truth(&self, of: &Truth) -> Vec<Drawn> {
        truth(of)
    }
}

/// The carpet with its markings.
fn scenery() -> Vec<Drawn> {
    let rectangle =
        |x: f32, corner: Vec2| Rectangle { x, y: 0.0, heading: 0.0, length: 2.0 * corner.x, width: 2.0 * corner.y };
    let (corner, area) = (FIELD.field_corner(), FIELD.penalty_area_corner());
    let half_area = Vec2::new(0.5 * (corner.x - area.x), area.y);
    let outlines = [
        rectangle(0.0, corner),
        rectangle(corner.x - half_area.x, half_area),
        rectangle(half_area.x - corner.x, half_area),
    ];
    let points = outlines.map(|one| Polyline::<5> { points: corners(&one).collect() });
    let middle = Segment { start: Point2 { x: 0.0, y: corner.y }, end: Point2 { x: 0.0, y: -corner.y } };
    let circle = Circle { x: 0.0, y: 0.0, radius: FIELD.centre_circle_radius() };
    let (mark, half) = (FIELD.penalty_mark(), 0.5 * FIELD.penalty_mark_size());
    let marks = [mark, -mark].map(|x| Rectangle { length: 2.0 * half, width: 2.0 * half, ..rectangle(x, Vec2::ZERO) });
    let line = |drawn: Drawn| Drawn { line_width: Some(FIELD.line_width()), ..drawn };
    let of = |drawn: Drawn| Drawn { colour: Some(MARKING), ..drawn };
    vec![
        Drawn { colour: Some(GRASS), ..Drawn::new("carpet", FRAME, &rectangle(0.0, FIELD.carpet_corner())) },
        line(of(Drawn::new("lines", FRAME, &points))),
        line(of(Drawn::new("halfway line", FRAME, &middle))),
        line(of(Drawn::new("centre circle", FRAME, &circle))),
        of(Drawn::new("penalty marks", FRAME, &marks)),
    ]
}

/// The corners of a rectangle, the first one again at the end.
fn corners(of: &Rectangle) -> impl Iterator<Item = Point2> {
    let (x, y) = (0.5 * of.length, 0.5 * of.width);
    [(x, y), (-x, y), (-x, -y), (x, -y), (x, y)]
        .map(|(ahead, left)| Point2 { x: of.x + ahead, y: of.y + left })
        .into_iter()
}

/// The true state of a game.
fn truth(truth: &Truth) -> Vec<Drawn> {
    let circle = |[x, y]: [f32; 2], radius: f32| Circle { x, y, radius };
    let pose = |[x, y, heading]: [f32; 3]| Pose2 { x, y, heading };
    let others: List<Circle, 16> = truth.others.iter().map(|&other| circle(other, ROBOT)).collect();
    let goal = |attacked: bool| {
        let [start, end] = FIELD.goal_posts(attacked).map(|Vec2 { x, y }| Point2 { x, y });
        let colour = GOAL_COLOURS[usize::from(attacked == truth.attacks_blue)];
        let drawn = Drawn::new(if attacked { "attacked goal" } else { "own goal" }, FRAME, &Segment { start, end });
        Drawn { colour: Some(colour), line_width: Some(FIELD.post_diameter()), ..drawn }
    };
    vec![
        goal(true),
        goal(false),
        Drawn { child: Some("odometry"), ..Drawn::new("start", FRAME, &pose(truth.start)) },
        Drawn::new("robot", FRAME, &pose(truth.robot)),
        Drawn::new("other robots", FRAME, &others),
        Drawn::new("ball", FRAME, &circle(truth.ball, FIELD.ball_radius())),
    ]
}
