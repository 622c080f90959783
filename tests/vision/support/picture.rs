//! PNG image with marked detections.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

use bica_field::CrossingKind;
use bica_motion::robot::Image;
use bica_sim::World;
use bica_vision::pipeline::Detections;
use bica_vision::projection::Camera;
use glam::Vec2;

use crate::survey::View;
use crate::survey::detect;

/// Scale of the picture.
const TIMES: usize = 3;

type Rgb = [u8; 3];

struct Picture {
    width: usize,
    pixels: Vec<Rgb>,
}

/// Writes the image of a view with marks of all detections.
pub(crate) fn write(path: &Path, view: &View) -> io::Result<()> {
    let (camera, seen) = detect::see(view);
    let mut world = view.world.clone();
    let mut picture = Picture::of(&world.sensors().image.expect("there is a new one"));
    picture.mark(&seen, &camera);
    let height = picture.pixels.len() / picture.width;
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), picture.width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    let bytes = picture.pixels.as_flattened();
    encoder.write_header().and_then(|mut writer| writer.write_image_data(bytes)).map_err(io::Error::other)
}

impl Picture {
    fn of(image: &Image<'_>) -> Self {
        let (width, height) = (usize::from(image.width), usize::from(image.height));
        let pixel = |index: usize| {
            let (x, y) = (index % (TIMES * width) / TIMES, index / (TIMES * TIMES * width));
            let pair = &image.yuyv[2 * (y * width + x / 2 * 2)..][..4];
            rgb(pair[x % 2 * 2], pair[1], pair[3])
        };
        Self { width: TIMES * width, pixels: (0..TIMES * TIMES * width * height).map(pixel).collect() }
    }

    fn mark(&mut self, seen: &Detections, camera: &Camera) {
        self.path(seen.boundary.corners(), [255, 255, 255]);
        for line in &seen.markings.lines {
            let ends = [line.from, line.to].map(|end| camera.pixel(end.extend(0.0)));
            if let [Some(from), Some(to)] = ends {
                self.path(&[from, to], [255, 0, 0]);
            }
        }
        for crossing in &seen.markings.crossings {
            let colour = match crossing.kind {
                CrossingKind::L => [255, 0, 255],
                CrossingKind::T => [0, 255, 255],
                CrossingKind::X => [255, 255, 0],
            };
            self.frame(crossing.at - 4.0, crossing.at + 4.0, colour);
        }
        if let Some(circle) = seen.markings.circle {
            let points = (0..41_u8).map(|i| circle.centre + 0.6 * Vec2::from_angle(0.157_08 * f32::from(i)));
            let points: Vec<Vec2> = points.filter_map(|at| camera.pixel(at.extend(0.0))).collect();
            self.path(&points, [255, 160, 0]);
        }
        for robot in &seen.robots {
            self.frame(robot.min, robot.max, [160, 0, 255]);
        }
        for goal in [seen.goals.yellow, seen.goals.blue].into_iter().flatten() {
            self.frame(goal.min, goal.max, [0, 0, 255]);
            for post in [Some(goal.first), goal.second].into_iter().flatten() {
                self.path(&[post.base, post.top], [0, 0, 255]);
            }
        }
        if let Some(ball) = seen.ball {
            self.frame(ball.centre - ball.radius, ball.centre + ball.radius, [0, 0, 0]);
        }
    }

    fn frame(&mut self, min: Vec2, max: Vec2, colour: Rgb) {
        let corners = [min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y), min];
        self.path(&corners, colour);
    }

    fn path(&mut self, corners: &[Vec2], colour: Rgb) {
        for ends in corners.windows(2) {
            let count = (TIMES as f32 * ends[0].distance(ends[1])).clamp(1.0, 9999.0);
            for step in 0..=count as u16 {
                let at = (ends[0].lerp(ends[1], f32::from(step) / count) + 0.5) * TIMES as f32;
                let height = self.pixels.len() / self.width;
                if at.min_element() >= 0.0 && at.x < self.width as f32 && at.y < height as f32 {
                    self.pixels[at.y as usize * self.width + at.x as usize] = colour;
                }
            }
        }
    }
}

/// BT.601, full range.
fn rgb(y: u8, cb: u8, cr: u8) -> Rgb {
    let (y, cb, cr) = (f32::from(y), f32::from(cb) - 128.0, f32::from(cr) - 128.0);
    [y + 1.402 * cr, y - 0.344_136 * cb - 0.714_136 * cr, y + 1.772 * cb].map(|part| part.clamp(0.0, 255.0) as u8)
}
