//! Camera image with detections.

use bica_drawing::canvas::{Area, Canvas, Rgb};
use bica_drawing::palette::{TEXT, WHITE, translucent};
use bica_drawing::text::Font;
use bica_field::{CrossingKind, GoalColour};
use bica_motion::robot::Image;
use bica_vision::ball::Ball;
use bica_vision::crossings::Crossing;
use bica_vision::goal::{Goal, Post};
use bica_vision::lines::Line;
use bica_vision::own_body::OwnBody;
use bica_vision::robots::{Robot, Team};
use glam::Vec2;

use super::Marks;
use super::palette::{BLUE, ESTIMATE, LINE_MARK, ROBOT, YELLOW};

/// Draws an image, enlarged by a whole factor to at most `width` px, with detections.
#[must_use]
pub fn view(image: &Image<'_>, marks: &Marks, width: usize) -> Canvas {
    let times = (width / usize::from(image.width).max(1)).max(1);
    let mut canvas = Canvas::new(usize::from(image.width) * times, usize::from(image.height) * times, TEXT);
    pixels(&mut canvas, image, times);
    let mut view = View { canvas, scale: times as f32 };
    view.own(&marks.own);
    view.field_boundary(&marks.field_boundary);
    view.circle(&marks.circle);
    marks.lines.iter().for_each(|line| view.line(line));
    marks.crossings.iter().for_each(|crossing| view.crossing(crossing));
    marks.robots.iter().for_each(|robot| view.robot(robot));
    marks.goals.iter().for_each(|goal| view.goal(goal));
    marks.ball.iter().for_each(|ball| view.ball(ball));
    view.canvas
}

struct View {
    canvas: Canvas,
    /// Canvas pixels per image pixel.
    scale: f32,
}

impl View {
    fn at(&self, pixel: Vec2) -> Vec2 {
        self.scale * (pixel + 0.5)
    }

    /// Draws the outline of the robot's own body, dotted.
    fn own(&mut self, own: &OwnBody) {
        let covers = |x: usize, y: usize| own.covers(Vec2::new(x as f32, y as f32) / self.scale - 0.5);
        let step = 2;
        let mut outline = vec![];
        for y in (step..self.canvas.height()).step_by(step) {
            for x in (step..self.canvas.width()).step_by(step) {
                if covers(x, y) != covers(x - step, y) || covers(x, y) != covers(x, y - step) {
                    outline.push((x, y));
                }
            }
        }
        for (x, y) in outline {
            self.canvas.set(x, y, ESTIMATE);
        }
    }

    fn field_boundary(&mut self, line: &[Vec2]) {
        let line: Vec<Vec2> = line.iter().map(|p| self.at(*p)).collect();
        self.canvas.polyline(&line, 4.0, translucent(TEXT, 0.5));
        self.canvas.polyline(&line, 2.0, WHITE);
    }

    fn line(&mut self, line: &Line) {
        let (from, to) = (self.at(line.from), self.at(line.to));
        self.canvas.line(from, to, 3.0, translucent(TEXT, 0.5));
        self.canvas.line(from, to, 1.5, LINE_MARK);
    }

    fn circle(&mut self, points: &[Vec2]) {
        let line: Vec<Vec2> = points.iter().map(|p| self.at(*p)).collect();
        self.canvas.polyline(&line, 3.0, translucent(ESTIMATE, 0.8));
    }

    fn crossing(&mut self, crossing: &Crossing) {
        let at = self.at(crossing.at);
        self.canvas.disc(at, 3.5, LINE_MARK);
        self.canvas.ring(at, 3.5, 1.5, TEXT);
        let word = match crossing.kind {
            CrossingKind::L => "L",
            CrossingKind::T => "T",
            CrossingKind::X => "X",
        };
        self.label(at + Vec2::new(5.0, -18.0), word, LINE_MARK);
    }

    fn robot(&mut self, robot: &Robot) {
        let frame = Area { from: self.at(robot.min), to: self.at(robot.max) };
        self.canvas.outline(frame, 2.0, 3.0, TEXT);
        self.canvas.outline(frame, 2.0, 1.5, ROBOT);
        let word = match robot.team {
            Some(Team::Red) => "red robot",
            Some(Team::Blue) => "blue robot",
            None => "robot",
        };
        self.label(Vec2::new(frame.from.x, frame.to.y + 2.0), word, ROBOT);
    }

    fn goal(&mut self, goal: &Goal) {
        let rgb = if goal.colour == GoalColour::Yellow { YELLOW } else { BLUE };
        let frame = Area { from: self.at(goal.min - 0.5), to: self.at(goal.max + 0.5) };
        self.canvas.outline(frame, 2.0, 3.0, TEXT);
        self.canvas.outline(frame, 2.0, 2.0, rgb);
        self.post(&goal.first, rgb);
        goal.second.iter().for_each(|post| self.post(post, rgb));
        let word = if goal.is_complete() { "goal" } else { "part of a goal" };
        self.label(frame.from - Vec2::new(0.0, 16.0), word, rgb);
    }

    fn post(&mut self, post: &Post, rgb: Rgb) {
        let aside = Vec2::new(0.5 * post.width * self.scale, 0.0);
        let (foot, top) = (self.at(post.base), self.at(post.top));
        self.canvas.polygon(&[foot - aside, top - aside, top + aside, foot + aside], translucent(rgb, 0.45));
        self.canvas.line(foot, top, 2.0, WHITE);
        if post.has_base {
            self.canvas.disc(foot, 4.0, WHITE);
            self.canvas.ring(foot, 4.0, 1.5, TEXT);
        }
    }

    fn ball(&mut self, ball: &Ball) {
        let (centre, radius) = (self.at(ball.centre), ball.radius * self.scale);
        self.canvas.ring(centre, radius, 4.0, WHITE);
        self.canvas.ring(centre, radius, 2.0, ESTIMATE);
        for arm in [Vec2::X, Vec2::Y] {
            self.canvas.line(centre - 4.0 * arm, centre + 4.0 * arm, 1.5, WHITE);
        }
        self.label(centre + Vec2::new(radius + 5.0, -8.0), "ball", ESTIMATE);
    }

    fn label(&mut self, at: Vec2, word: &str, rgb: Rgb) {
        let size = Vec2::new(Font::Bold.width(word) + 8.0, 15.0);
        let room = Vec2::new(self.canvas.width() as f32, self.canvas.height() as f32) - size;
        let at = at.min(room).max(Vec2::ZERO);
        self.canvas.rounded_rectangle(Area { from: at, to: at + size }, 3.0, translucent(TEXT, 0.75));
        self.canvas.write(at + Vec2::new(4.0, 1.0), Font::Bold, rgb, word);
    }
}

fn pixels(canvas: &mut Canvas, image: &Image<'_>, times: usize) {
    let width = usize::from(image.width);
    for (index, pair) in image.yuyv.as_chunks::<4>().0.iter().enumerate() {
        let &[first, cb, second, cr] = pair;
        for (offset, luma) in [first, second].into_iter().enumerate() {
            let (x, y) = ((2 * index + offset) % width, (2 * index + offset) / width);
            let rgb = rgb(luma, cb, cr);
            for (dx, dy) in (0..times * times).map(|n| (n % times, n / times)) {
                canvas.set(x * times + dx, y * times + dy, rgb);
            }
        }
    }
}

/// Converts full-range BT.601 to RGB.
fn rgb(luma: u8, cb: u8, cr: u8) -> Rgb {
    let (luma, cb, cr) = (f32::from(luma), f32::from(cb) - 128.0, f32::from(cr) - 128.0);
    [luma + 1.402 * cr, luma - 0.344_136 * cb - 0.714_136 * cr, luma + 1.772 * cb].map(|v| v.round() as u8)
}
