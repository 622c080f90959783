//! The hall around the field: four walls with posters, furniture and people, a floor and a ceiling.
//!
//! Some of these distractors have the colours of ball and goals. All of them are outside the carpet.

use glam::{Vec2, Vec3};

use super::ground::Ground;
use crate::camera::canvas::{Canvas, Edge, Pixel};
use crate::camera::palette::{Palette, Rgb};
use crate::camera::pinhole::{LANES, Mapping, PinholeCamera, round_wrapping};
use crate::field::CARPET;
use crate::random::Random;

/// Half length, half width, and height of the hall, m.
const HALL: Vec3 = Vec3::new(6.0, 5.0, 3.5);
/// Resolution of a wall's texture, points per metre.
const POINTS: f32 = 50.0;

/// Textures of the walls and colour of the ceiling.
#[derive(Clone, Debug)]
pub(crate) struct Hall {
    walls: [Wall; 4],
    ceiling: Pixel,
}

/// A wall and its texture, rows from the floor up.
#[derive(Clone, Debug)]
struct Wall {
    /// Lower left corner seen from inside, field frame, m.
    corner: Vec3,
    along: Vec3,
    size: Vec2,
    width: usize,
    height: usize,
    points: Vec<Pixel>,
}

impl Hall {
    pub(crate) fn new(palette: &Palette, random: &mut Random) -> Self {
        let wallpapers = [
            Rgb::new(0.66, 0.65, 0.61),
            Rgb::new(0.52, 0.54, 0.56),
            Rgb::new(0.60, 0.54, 0.46),
            Rgb::new(0.70, 0.70, 0.70),
        ];
        let wallpaper = wallpapers[random.below(wallpapers.len())];
        let (x, y) = (HALL.x, HALL.y);
        let walls = [
            (Vec3::new(x, y, 0.0), Vec3::NEG_Y),
            (Vec3::new(x, -y, 0.0), Vec3::NEG_X),
            (Vec3::new(-x, -y, 0.0), Vec3::Y),
            (Vec3::new(-x, y, 0.0), Vec3::X),
        ];
        let walls = walls.map(|(corner, along)| {
            let shade = random.between(0.85, 1.05);
            let mut wall = Wall::blank(corner, along, palette.pixel(shade * wallpaper));
            wall.decorate(palette, random);
            wall.add_texture_noise(random);
            wall
        });
        Self { walls, ceiling: palette.pixel(Rgb::new(0.72, 0.72, 0.74)) }
    }

    /// Paints the background: the whole canvas.
    pub(crate) fn draw(&self, view: &PinholeCamera, ground: &Ground, canvas: &mut Canvas) {
        canvas.pixels.fill(self.ceiling);
        for wall in &self.walls {
            let mapping = view.mapping(wall.corner, wall.along, Vec3::Z);
            let polygon = view.polygon(wall.corners());
            canvas.fill(&polygon, Edge::Hard, |v, u, pixels| wall.paint(&mapping, v, u, pixels));
        }
        let mapping = view.mapping(Vec3::ZERO, Vec3::X, Vec3::Y);
        let carpet = view.polygon(rectangle(-CARPET, CARPET));
        for strip in floor_strips() {
            let floor = view.polygon(strip);
            canvas.fill(&floor, Edge::Hard, |v, u, pixels| ground.paint_floor(&mapping, v, u, pixels));
        }
        canvas.fill(&carpet, Edge::Soft, |v, u, pixels| ground.paint_carpet(&mapping, v, u, pixels));
    }
}

impl Wall {
    fn blank(corner: Vec3, along: Vec3, paper: Pixel) -> Self {
        let length = if along.x == 0.0 { 2.0 * HALL.y } else { 2.0 * HALL.x };
        let (width, height) = ((length * POINTS) as usize, (HALL.z * POINTS) as usize);
        let size = Vec2::new(length, HALL.z);
        Self { corner, along, size, width, height, points: vec![paper; width * height] }
    }

    fn corners(&self) -> [Vec3; 4] {
        let (right, up) = (self.along * self.size.x, Vec3::Z * self.size.y);
        [self.corner, self.corner + right, self.corner + right + up, self.corner + up]
    }

    fn paint(&self, mapping: &Mapping, v: usize, first: usize, pixels: &mut [Pixel]) {
        let most = |count: usize| count as f32 - 1.0;
        for (i, pixels) in pixels.chunks_mut(LANES).enumerate() {
            let (along, up) = mapping.row((first + i * LANES) as f32, v as f32);
            let mut places = [0; LANES];
            for i in 0..LANES {
                let column = round_wrapping((along[i] * POINTS - 0.5).clamp(0.0, most(self.width)));
                let row = round_wrapping((up[i] * POINTS - 0.5).clamp(0.0, most(self.height)));
                places[i] = row * self.width as u32 + column;
            }
            for (pixel, place) in pixels.iter_mut().zip(places) {
                *pixel = self.points[place as usize];
            }
        }
    }

    fn decorate(&mut self, palette: &Palette, random: &mut Random) {
        if random.chance(0.5) {
            let panel = palette.pixel(muted(random));
            self.rectangle(Vec2::ZERO, Vec2::new(self.size.x, random.between(0.3, 1.1)), panel);
        }
        for _ in 0..3 + random.below(4) {
            self.poster(palette, random);
        }
        for _ in 0..=random.below(4) {
            self.furniture(palette, random);
        }
        for _ in 0..2 + random.below(5) {
            self.person(palette, random);
        }
    }

    fn poster(&mut self, palette: &Palette, random: &mut Random) {
        let size = Vec2::new(random.between(0.4, 1.8), random.between(0.4, 1.3));
        let at = Vec2::new(random.between(0.0, self.size.x - size.x), random.between(0.8, 2.0));
        self.rectangle(at, size, palette.pixel(any_colour(random)));
        for _ in 0..random.below(5) {
            let part = size * Vec2::new(random.between(0.1, 0.6), random.between(0.05, 0.4));
            let inside = at + (size - part) * Vec2::new(random.unit(), random.unit());
            self.rectangle(inside, part, palette.pixel(any_colour(random)));
        }
    }

    fn furniture(&mut self, palette: &Palette, random: &mut Random) {
        let size = Vec2::new(random.between(0.4, 2.0), random.between(0.3, 0.9));
        let at = Vec2::new(random.between(0.0, self.size.x - size.x), 0.0);
        self.rectangle(at, size, palette.pixel(any_colour(random)));
        let top = Vec2::new(size.x, 0.05);
        self.rectangle(at + Vec2::new(0.0, size.y), top, palette.pixel(muted(random)));
    }

    fn person(&mut self, palette: &Palette, random: &mut Random) {
        let x = random.between(0.4, self.size.x - 0.4);
        let tall = random.between(1.5, 1.95);
        let (trousers, shirt) = (palette.pixel(muted(random)), palette.pixel(any_colour(random)));
        let skin = palette.pixel(Rgb::new(0.78, 0.57, 0.46) * random.between(0.45, 1.05));
        let hair = palette.pixel(Rgb::new(0.25, 0.18, 0.12) * random.between(0.3, 2.0));
        for side in [-0.1, 0.1] {
            self.ellipse(Vec2::new(x + side, 0.25 * tall), Vec2::new(0.09, 0.27 * tall), trousers);
        }
        self.ellipse(Vec2::new(x, 0.66 * tall), Vec2::new(0.24, 0.2 * tall), shirt);
        self.ellipse(Vec2::new(x, 0.94 * tall), Vec2::new(0.10, 0.075 * tall), hair);
        self.ellipse(Vec2::new(x, 0.92 * tall), Vec2::new(0.085, 0.065 * tall), skin);
    }

    fn rectangle(&mut self, at: Vec2, size: Vec2, colour: Pixel) {
        self.shape(at, at + size, colour, |_| true);
    }

    fn ellipse(&mut self, centre: Vec2, radii: Vec2, colour: Pixel) {
        let inside = |point: Vec2| ((point - centre) / radii).length_squared() < 1.0;
        self.shape(centre - radii, centre + radii, colour, inside);
    }

    fn shape(&mut self, from: Vec2, to: Vec2, colour: Pixel, inside: impl Fn(Vec2) -> bool) {
        let index = |x: f32, most: usize| ((x * POINTS).max(0.0) as usize).min(most);
        for row in index(from.y, self.height)..index(to.y, self.height) {
            for column in index(from.x, self.width)..index(to.x, self.width) {
                if inside((Vec2::new(column as f32, row as f32) + 0.5) / POINTS) {
                    self.points[row * self.width + column] = colour;
                }
            }
        }
    }

    /// Adds a vertical brightness gradient and noise.
    fn add_texture_noise(&mut self, random: &mut Random) {
        for (i, point) in self.points.iter_mut().enumerate() {
            let row = i / self.width;
            let shade = (row as i32 * 24 / self.height as i32) - 12 + (random.bits() >> 30) as i32 * 2;
            point[0] = (point[0] as i32 + shade).clamp(0, 255) as u8;
        }
    }
}

/// Returns the floor around the carpet as rectangles that reach 0.1 m under it, so that no gap is visible.
fn floor_strips() -> [[Vec3; 4]; 4] {
    let (hall, carpet) = (HALL.truncate(), CARPET - 0.1);
    [
        rectangle(Vec2::new(carpet.x, -hall.y), hall),
        rectangle(-hall, Vec2::new(-carpet.x, hall.y)),
        rectangle(Vec2::new(-carpet.x, carpet.y), Vec2::new(carpet.x, hall.y)),
        rectangle(Vec2::new(-carpet.x, -hall.y), Vec2::new(carpet.x, -carpet.y)),
    ]
}

fn rectangle(from: Vec2, to: Vec2) -> [Vec3; 4] {
    [(from.x, from.y), (to.x, from.y), (to.x, to.y), (from.x, to.y)].map(|(x, y)| Vec3::new(x, y, 0.0))
}

/// Draws an unsaturated colour: grey, brown or dark blue.
fn muted(random: &mut Random) -> Rgb {
    let grey = random.between(0.1, 0.75);
    let tints = [Rgb::ONE, Rgb::new(1.0, 0.82, 0.62), Rgb::new(0.75, 0.85, 1.1), Rgb::new(0.85, 0.95, 0.85)];
    grey * tints[random.below(tints.len())]
}

/// Draws a colour that is muted with probability 0.6, otherwise vivid: some are near the colours of ball, goals and teams.
fn any_colour(random: &mut Random) -> Rgb {
    const VIVID: [Rgb; 8] = [
        Rgb::new(0.65, 0.12, 0.12),
        Rgb::new(0.82, 0.36, 0.14),
        Rgb::new(0.75, 0.66, 0.12),
        Rgb::new(0.20, 0.40, 0.60),
        Rgb::new(0.15, 0.20, 0.50),
        Rgb::new(0.70, 0.30, 0.50),
        Rgb::new(0.80, 0.78, 0.72),
        Rgb::new(0.12, 0.35, 0.20),
    ];
    if random.chance(0.6) {
        return muted(random);
    }
    VIVID[random.below(VIVID.len())] * random.between(0.75, 1.1)
}
