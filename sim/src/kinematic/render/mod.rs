//! What the cameras see, drawn by a small rasteriser of our own.
//!
//! The hall and the ground are a few large polygons whose pixels are mapped back to the plane that they show; what
//! stands on the field are simple solids, drawn from the farthest to the nearest; the camera adds blur and noise.

mod figure;
mod goal;
mod ground;
mod hall;
mod lines;
mod solid;

use bica_field::FIELD;
use bica_motion::kinematics::Skeleton;
use bica_motion::model::{Nao, RobotModel};
use glam::{Affine3A, Vec2, Vec3};

use self::figure::RobotColours;
use self::ground::Ground;
use self::hall::Hall;
use self::solid::Solid;
use crate::camera::canvas::{Canvas, Pixel};
use crate::camera::image_sensor::ImageSensor;
use crate::camera::light::Light;
use crate::camera::palette::{self, Palette};
use crate::camera::pinhole::PinholeCamera;
use crate::layout::{Layout, Other};
use crate::random::{Random, Stream};
use crate::segmentation::PixelLabel;
use crate::setup::Setup;
use crate::spectator::{Picture, SpectatorCamera};
use crate::transform::level_pose;

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// A picture with nothing on it: no thing has this colour.
const BLANK: Pixel = [0, 0, 0, 0];

/// What there is to see in one image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene<'a> {
    /// The camera's pose in the field frame.
    pub(crate) camera: Affine3A,
    /// Its angular velocity in its own frame, rad/s.
    pub(crate) turning: Vec3,
    /// The image's number.
    pub(crate) frame: u64,
    /// The ball's middle, field frame, m.
    pub(crate) ball: Vec2,
    /// The robot frame's pose in the field frame.
    pub(crate) robot: &'a Affine3A,
    /// The robot's parts.
    pub(crate) skeleton: &'a Skeleton,
}

/// Things that are seen as one from afar, and where.
#[derive(Clone, Debug)]
struct Group {
    thing: PixelLabel,
    place: Vec2,
    parts: Vec<Solid>,
}

/// Draws images of one game.
#[derive(Clone, Debug)]
pub(crate) struct Renderer {
    seed: u64,
    canvas: Canvas,
    light: Light,
    ground: Ground,
    hall: Hall,
    sensor: ImageSensor,
    /// What never moves.
    still: Vec<Group>,
    ball: Pixel,
    dress: RobotColours,
}

impl Renderer {
    pub(crate) fn new(setup: &Setup, layout: &Layout) -> Self {
        let mut camera = Random::new(setup.seed, Stream::Camera);
        let mut hall = Random::new(setup.seed, Stream::Hall);
        let palette = Palette::new(&mut camera);
        let light = Light::new(&mut hall);
        let (width, height) = setup.frame.size();
        let dress = |mate: bool| {
            let defends = if mate { layout.attacks.other() } else { layout.attacks };
            RobotColours::of_defender(defends, &palette)
        };
        let goals = goal::goals(layout.attacks, &palette).into_iter();
        let mut still: Vec<Group> = goals.map(|part| Group::of_one(PixelLabel::Goal, part)).collect();
        let others = layout.others.iter().enumerate();
        still.extend(others.map(|(index, other)| Group::of_robot(index, other, dress(other.mate))));
        Self {
            seed: setup.seed,
            canvas: Canvas::new(width, height),
            light,
            ground: Ground::new(&palette, light, &mut hall),
            hall: Hall::new(&palette, &mut hall),
            sensor: ImageSensor::new(&palette, width, height, &mut camera),
            still,
            ball: palette.pixel(palette::ORANGE),
            dress: dress(true),
        }
    }

    /// Width and height of images, pixels.
    pub(crate) const fn size(&self) -> (usize, usize) {
        (self.canvas.width, self.canvas.height)
    }

    /// Draws a scene into an image, YUYV.
    pub(crate) fn draw(&mut self, scene: &Scene<'_>, image: &mut [u8]) {
        let view = PinholeCamera::new(scene.camera, self.canvas.width, self.canvas.height);
        self.hall.draw(&view, &self.ground, &mut self.canvas);
        self.draw_shadows(&view, scene);
        let own = self.own(&view, scene);
        self.draw_solids(&view, scene, &own, |_, _| ());
        let mut grain = Random::new(self.seed.wrapping_add(scene.frame << 32), Stream::Grain);
        self.sensor.expose(&self.canvas, &view, scene.turning, &mut grain, image);
    }

    /// What every pixel of a scene's image shows.
    pub(crate) fn segmentation_mask(&mut self, scene: &Scene<'_>) -> Vec<PixelLabel> {
        let view = PinholeCamera::new(scene.camera, self.canvas.width, self.canvas.height);
        self.canvas.pixels.fill(BLANK);
        let mut things = vec![PixelLabel::Background; self.canvas.pixels.len()];
        let own = self.own(&view, scene);
        self.draw_solids(&view, scene, &own, |canvas, thing| {
            for (shown, pixel) in things.iter_mut().zip(&mut canvas.pixels).filter(|(_, pixel)| **pixel != BLANK) {
                (*shown, *pixel) = (thing, BLANK);
            }
        });
        things
    }

    /// What the robot sees of itself.
    fn own(&self, view: &PinholeCamera, scene: &Scene<'_>) -> Group {
        let parts = figure::below_the_head(scene.robot, scene.skeleton, self.dress);
        Group { thing: PixelLabel::OwnBody, place: view.pose.translation.truncate(), parts }
    }

    /// Draws a scene as it is seen from outside. The scene's own camera does not matter.
    pub(crate) fn film(&mut self, scene: &Scene<'_>, from: &SpectatorCamera, width: usize, height: usize) -> Picture {
        let own = core::mem::replace(&mut self.canvas, Canvas::new(width, height));
        let view = PinholeCamera::of_onlooker(from.pose(), width, height);
        self.hall.draw(&view, &self.ground, &mut self.canvas);
        self.draw_shadows(&view, scene);
        let parts = figure::figure(scene.robot, scene.skeleton, self.dress);
        let place = Vec3::from(scene.robot.translation).truncate();
        self.draw_solids(&view, scene, &Group { thing: PixelLabel::OwnBody, place, parts }, |_, _| ());
        let drawn = core::mem::replace(&mut self.canvas, own);
        Picture { width, height, rgb: drawn.pixels.into_iter().map(rgb).collect() }
    }

    fn draw_shadows(&mut self, view: &PinholeCamera, scene: &Scene<'_>) {
        let ball = Solid::Shadow { centre: scene.ball, radius: 1.7 * BALL_RADIUS, darkness: 0.6 };
        let still = self.still.iter().flat_map(|group| &group.parts).filter(|part| part.is_shadow());
        for shadow in still.chain(&figure::shadows(scene.robot, scene.skeleton)).chain([&ball]) {
            shadow.draw(view, &self.light, &mut self.canvas);
        }
    }

    /// Draws what stands on the field, and of the robot itself what is given; `after` is told each thing that was drawn.
    fn draw_solids(
        &mut self,
        view: &PinholeCamera,
        scene: &Scene<'_>,
        own: &Group,
        mut after: impl FnMut(&mut Canvas, PixelLabel),
    ) {
        let centre = scene.ball.extend(BALL_RADIUS);
        let ball = Group::of_one(PixelLabel::Ball, Solid::Sphere { centre, radius: BALL_RADIUS, colour: self.ball });
        let mut groups: Vec<&Group> = self.still.iter().chain([&ball, own]).collect();
        let camera = Vec3::from(view.pose.translation);
        sort_far_first(&mut groups, |group| group.place.distance(camera.truncate()));
        for group in groups {
            let mut parts: Vec<&Solid> = group.parts.iter().filter(|part| !part.is_shadow()).collect();
            sort_far_first(&mut parts, |part| part.middle().distance(camera));
            for part in parts {
                part.draw(view, &self.light, &mut self.canvas);
            }
            after(&mut self.canvas, group.thing);
        }
    }
}

impl Group {
    fn of_one(thing: PixelLabel, part: Solid) -> Self {
        Self { thing, place: part.middle().truncate(), parts: vec![part] }
    }

    fn of_robot(index: usize, other: &Other, dress: RobotColours) -> Self {
        let skeleton = Skeleton::<Nao>::of(&Nao::STAND);
        let sole = skeleton.sole(bica_motion::side::Side::Left);
        let robot = level_pose(&other.pose) * Affine3A::from_translation(Vec3::new(0.0, 0.0, -sole.translation.z));
        let mut parts = figure::figure(&robot, &skeleton, dress);
        parts.extend(figure::shadows(&robot, &skeleton));
        Self { thing: PixelLabel::OtherRobot(index), place: other.pose.position, parts }
    }
}

/// BT.601, full range.
fn rgb([luma, blue, red, _]: Pixel) -> [u8; 3] {
    let (luma, blue, red) = (f32::from(luma), f32::from(blue) - 128.0, f32::from(red) - 128.0);
    [luma + 1.402 * red, luma - 0.344_136 * blue - 0.714_136 * red, luma + 1.772 * blue].map(|part| (part + 0.5) as u8)
}

fn sort_far_first<T>(things: &mut [T], distance: impl Fn(&T) -> f32) {
    things.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
}
