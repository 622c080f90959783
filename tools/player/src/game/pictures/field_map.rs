//! Map of the field with the true state of a game and the robot's estimates.

use bica_drawing::canvas::{Area, Canvas, Ink, Rgb};
use bica_drawing::palette::{TEXT, translucent};
use bica_drawing::text::Font;
use bica_evaluation::pictures::palette::{BALL, BLUE, CARPET, ESTIMATE, LINE, OTHER, ROBOT, YELLOW};
use bica_field::{FIELD, GoalColour};
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::state::{Estimates, GroundTruth};

/// Half the carpet, m.
const CARPET_HALF: Vec2 = FIELD.carpet_corner();
/// Half the field, line centres, m.
const FIELD_HALF: Vec2 = FIELD.field_corner();

/// Map of the field of 2009, with the attacked goal on the right.
#[derive(Debug)]
pub(crate) struct Map {
    canvas: Canvas,
    /// Pixels per metre.
    scale: f32,
}

impl Map {
    /// Creates the map of an empty field, `width` px wide.
    #[must_use]
    pub(crate) fn new(width: usize, attacks: GoalColour) -> Self {
        let scale = width as f32 / (2.0 * CARPET_HALF.x);
        let mut map = Self { canvas: Canvas::new(width, (2.0 * CARPET_HALF.y * scale) as usize, CARPET), scale };
        map.lines();
        map.goal(1.0, attacks);
        map.goal(-1.0, attacks.other());
        map
    }

    /// Returns the picture.
    #[must_use]
    pub(crate) fn into_canvas(self) -> Canvas {
        self.canvas
    }

    /// Draws the true positions.
    pub(crate) fn truth(&mut self, truth: &GroundTruth) {
        let trail: Vec<Vec2> = truth.trail.iter().map(|p| self.at(*p)).collect();
        self.canvas.polyline(&trail, 1.5, translucent(BALL, 0.6));
        for other in &truth.others {
            self.robot(other, OTHER);
        }
        self.robot(&truth.robot, ROBOT);
        let at = self.at(truth.ball);
        ball(&mut self.canvas, at);
    }

    /// Draws the robot's estimates.
    pub(crate) fn estimates(&mut self, estimates: &Estimates) {
        let pose = &estimates.robot;
        let here = self.at(pose.position);
        self.canvas.dashed_ring(here, 0.17 * self.scale, 2.0, ESTIMATE);
        let nose = self.at(pose.place(Vec2::new(0.3, 0.0)));
        self.canvas.line(here, nose, 2.0, ESTIMATE);
        if let Some(ball) = estimates.ball {
            let ball = self.at(pose.place(ball));
            self.canvas.dashed(here, ball, 1.0, 4.0, translucent(ESTIMATE, 0.8));
            self.canvas.ring(ball, 9.0, 2.0, ESTIMATE);
        }
        if let Some(goal) = estimates.goal {
            let goal = self.at(pose.place(goal));
            cross(&mut self.canvas, goal, 9.0);
        }
    }

    fn at(&self, field: Vec2) -> Vec2 {
        self.scale * Vec2::new(field.x + CARPET_HALF.x, CARPET_HALF.y - field.y)
    }

    fn lines(&mut self) {
        let width = FIELD.line_width() * self.scale;
        let mut boxes = vec![(-FIELD_HALF, FIELD_HALF)];
        for side in [-1.0, 1.0] {
            let area = FIELD.penalty_area_corner();
            boxes.push((Vec2::new(side * area.x, -area.y), Vec2::new(side * FIELD_HALF.x, area.y)));
        }
        for (from, to) in boxes {
            let corners = [from, Vec2::new(to.x, from.y), to, Vec2::new(from.x, to.y), from].map(|p| self.at(p));
            self.canvas.polyline(&corners, width, LINE);
        }
        self.canvas.line(self.at(Vec2::new(0.0, -FIELD_HALF.y)), self.at(Vec2::new(0.0, FIELD_HALF.y)), width, LINE);
        self.canvas.ring(self.at(Vec2::ZERO), FIELD.centre_circle_radius() * self.scale, width, LINE);
        for x in [-FIELD.penalty_mark(), 0.0, FIELD.penalty_mark()] {
            self.mark(Vec2::new(x, 0.0), width);
        }
    }

    fn mark(&mut self, at: Vec2, width: f32) {
        let half = FIELD.penalty_mark_size() / 2.0;
        for arm in [Vec2::new(half, 0.0), Vec2::new(0.0, half)] {
            self.canvas.line(self.at(at - arm), self.at(at + arm), width, LINE);
        }
    }

    fn goal(&mut self, side: f32, colour: GoalColour) {
        let rgb = match colour {
            GoalColour::Yellow => YELLOW,
            GoalColour::SkyBlue => BLUE,
        };
        let Vec2 { x: line, y: half } = FIELD.goal_post();
        let depth = FIELD.goal_back();
        let net = [self.at(Vec2::new(side * line, half)), self.at(Vec2::new(side * depth, -half))];
        self.canvas.rounded_rectangle(Area::around(&net, 0.0), 2.0, translucent(rgb, 0.35));
        for y in [-half, half] {
            self.canvas.disc(self.at(Vec2::new(side * line, y)), 0.07 * self.scale, rgb);
        }
        self.canvas.line(self.at(Vec2::new(side * line, -half)), self.at(Vec2::new(side * line, half)), 2.0, rgb);
    }

    fn robot(&mut self, pose: &Pose2, ink: impl Into<Ink>) {
        let ink = ink.into();
        let nose = pose.place(Vec2::new(0.28, 0.0));
        self.canvas.line(self.at(pose.position), self.at(nose), 1.5, TEXT);
        let body = [(0.1, 0.0), (0.02, 0.14), (-0.08, 0.12), (-0.08, -0.12), (0.02, -0.14)]
            .map(|(x, y)| self.at(pose.place(Vec2::new(x, y))));
        self.canvas.polygon(&body, ink);
        let mut edge = body.to_vec();
        edge.push(body[0]);
        self.canvas.polyline(&edge, 1.0, TEXT);
        self.canvas.disc(self.at(pose.position), 0.05 * self.scale, TEXT);
    }
}

/// Draws the legend of the map in one line that begins at `at`.
pub(crate) fn legend(canvas: &mut Canvas, at: Vec2) {
    let mut x = at.x;
    let mut entry = |sign: &dyn Fn(&mut Canvas, Vec2), words: &str| {
        sign(canvas, Vec2::new(x + 6.0, at.y + 6.0));
        canvas.write(Vec2::new(x + 17.0, at.y), Font::Normal, TEXT, words);
        x += 31.0 + Font::Normal.width(words);
    };
    entry(&|canvas, at| ball(canvas, at), "ball");
    entry(&|canvas, at| square(canvas, at, ROBOT), "robot");
    entry(&|canvas, at| square(canvas, at, OTHER), "others");
    entry(&|canvas, at| canvas.dashed_ring(at, 6.0, 2.0, ESTIMATE), "estimated: robot,");
    entry(&|canvas, at| canvas.ring(at, 6.0, 2.0, ESTIMATE), "ball,");
    entry(&|canvas, at| cross(canvas, at, 6.0), "goal");
}

fn ball(canvas: &mut Canvas, at: Vec2) {
    canvas.disc(at, 5.0, BALL);
    canvas.ring(at, 5.0, 1.0, TEXT);
}

fn square(canvas: &mut Canvas, at: Vec2, rgb: Rgb) {
    let area = Area { from: at - 6.0, to: at + 6.0 };
    canvas.rounded_rectangle(area, 2.0, rgb);
    canvas.outline(area, 2.0, 1.0, TEXT);
}

fn cross(canvas: &mut Canvas, at: Vec2, size: f32) {
    for arm in [Vec2::splat(size), Vec2::new(size, -size)] {
        canvas.line(at - arm, at + arm, 2.0, ESTIMATE);
    }
}
