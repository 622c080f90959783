//! Software renderer for camera images.
//!
//! Hall and ground are a few large polygons, textured by homographies. Objects on the field are simple solids, drawn from the
//! farthest to the nearest (painter's algorithm). The image sensor adds motion blur, vignetting and noise.

mod figure;
mod goal;
mod ground;
mod hall;
mod lines;
mod solid;

use bica_motion::pose::Pose2;
use glam::{Affine3A, Vec2, Vec3};

pub(crate) use self::figure::PosedRobot;
use self::figure::RobotColours;
use self::ground::Ground;
use self::hall::Hall;
use self::solid::Solid;
use crate::camera::canvas::{Canvas, Pixel};
use crate::camera::image_sensor::ImageSensor;
use crate::camera::light::Light;
use crate::camera::palette::{self, Palette};
use crate::camera::pinhole::PinholeCamera;
use crate::field::BALL_RADIUS;
use crate::layout::Layout;
use crate::random::{Random, Stream};
use crate::segmentation::PixelLabel;
use crate::setup::Setup;
use crate::spectator::{Picture, SpectatorCamera};

/// Colour of pixels without an object; no object has this colour.
const BLANK: Pixel = [0, 0, 0, 0];

/// State of the world in one image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    /// Pose of the camera in the field frame.
    pub(crate) camera: Affine3A,
    /// Focal lengths of the camera relative to the width and the height of the image.
    pub(crate) focal: Vec2,
    /// Angular velocity of the camera, camera frame, rad/s.
    pub(crate) angular_velocity: Vec3,
    /// Index of the image.
    pub(crate) frame: u64,
    /// Centre of the ball, field frame, m.
    pub(crate) ball: Vec2,
    /// The robot.
    pub(crate) robot: PosedRobot,
}

/// Solids of one object; they are sorted by distance as one.
#[derive(Clone, Debug)]
struct Group {
    label: PixelLabel,
    place: Vec2,
    parts: Vec<Solid>,
}

/// Renderer of the images of one game.
#[derive(Clone, Debug)]
pub(crate) struct Renderer {
    seed: u64,
    canvas: Canvas,
    light: Light,
    ground: Ground,
    hall: Hall,
    sensor: ImageSensor,
    /// Objects that the robot does not move: goals, then other robots.
    static_objects: Vec<Group>,
    /// Number of those that are parts of goals.
    goals: usize,
    ball: Pixel,
    /// Colours of the other team and of the own one.
    team_colours: [RobotColours; 2],
}

impl Scene {
    /// Returns the view of the robot's camera in images of this size, pixels.
    fn view(&self, (width, height): (usize, usize)) -> PinholeCamera {
        PinholeCamera::new(self.camera, self.focal, width, height)
    }
}

impl Renderer {
    /// Returns the renderer of a game; `standing`: the posture of the other robots.
    pub(crate) fn new(setup: &Setup, layout: &Layout, standing: impl Fn(&Pose2) -> PosedRobot) -> Self {
        let mut camera = Random::new(setup.seed, Stream::Camera);
        let mut hall = Random::new(setup.seed, Stream::Hall);
        let palette = Palette::new(&mut camera);
        let light = Light::new(&mut hall);
        let (width, height) = setup.frame.size();
        let colours = |teammate: bool| {
            let defends = if teammate { layout.attacks.other() } else { layout.attacks };
            RobotColours::of_defender(defends, &palette)
        };
        let goals = goal::goals(layout.attacks, &palette).into_iter();
        let mut static_objects: Vec<Group> = goals.map(|part| Group::of_one(PixelLabel::Goal, part)).collect();
        let (goals, team_colours) = (static_objects.len(), [colours(false), colours(true)]);
        let others = layout.others.iter().map(|other| (standing(&other.pose), other.pose.position, other.teammate));
        static_objects.extend(groups(others, team_colours));
        Self {
            seed: setup.seed,
            canvas: Canvas::new(width, height),
            light,
            ground: Ground::new(&palette, light, &mut hall),
            hall: Hall::new(&palette, &mut hall),
            sensor: ImageSensor::new(&palette, width, height, &mut camera),
            static_objects,
            ball: palette.pixel(palette::ORANGE),
            goals,
            team_colours,
        }
    }

    /// Sets the other robots: each with its place, m, and whether it is a teammate.
    pub(crate) fn set_others(&mut self, others: impl Iterator<Item = (PosedRobot, Vec2, bool)>) {
        self.static_objects.truncate(self.goals);
        self.static_objects.extend(groups(others, self.team_colours));
    }

    /// Width and height of images, pixels.
    pub(crate) const fn size(&self) -> (usize, usize) {
        (self.canvas.width, self.canvas.height)
    }

    /// Renders a scene as a YUYV image.
    pub(crate) fn draw(&mut self, scene: &Scene, image: &mut [u8]) {
        let view = scene.view(self.size());
        self.hall.draw(&view, &self.ground, &mut self.canvas);
        self.draw_shadows(&view, scene);
        let own = self.own(&view, scene);
        self.draw_solids(&view, scene, &own, |_, _| ());
        let mut grain = Random::new(self.seed.wrapping_add(scene.frame << 32), Stream::Grain);
        self.sensor.expose(&self.canvas, &view, scene.angular_velocity, &mut grain, image);
    }

    /// Returns the label of every pixel of a scene's image.
    pub(crate) fn segmentation_mask(&mut self, scene: &Scene) -> Vec<PixelLabel> {
        let view = scene.view(self.size());
        self.canvas.pixels.fill(BLANK);
        let mut labels = vec![PixelLabel::Background; self.canvas.pixels.len()];
        let own = self.own(&view, scene);
        self.draw_solids(&view, scene, &own, |canvas, label| {
            for (shown, pixel) in labels.iter_mut().zip(&mut canvas.pixels).filter(|(_, pixel)| **pixel != BLANK) {
                (*shown, *pixel) = (label, BLANK);
            }
        });
        labels
    }

    /// Returns the body that carries the camera, without its head.
    fn own(&self, view: &PinholeCamera, scene: &Scene) -> Group {
        let parts = scene.robot.below_the_head(self.team_colours[1]);
        Group { label: PixelLabel::OwnBody, place: view.pose.translation.truncate(), parts }
    }

    /// Renders a scene from a spectator camera; the camera of the scene is not used.
    pub(crate) fn render_from(
        &mut self,
        scene: &Scene,
        camera: &SpectatorCamera,
        width: usize,
        height: usize,
    ) -> Picture {
        let image_canvas = core::mem::replace(&mut self.canvas, Canvas::new(width, height));
        let view = PinholeCamera::of_spectator(camera.pose(), width, height);
        self.hall.draw(&view, &self.ground, &mut self.canvas);
        self.draw_shadows(&view, scene);
        let parts = scene.robot.solids(self.team_colours[1]);
        let place = Vec3::from(scene.robot.robot.translation).truncate();
        self.draw_solids(&view, scene, &Group { label: PixelLabel::OwnBody, place, parts }, |_, _| ());
        let drawn = core::mem::replace(&mut self.canvas, image_canvas);
        Picture { width, height, rgb: drawn.pixels.into_iter().map(rgb).collect() }
    }

    fn draw_shadows(&mut self, view: &PinholeCamera, scene: &Scene) {
        let ball = Solid::Shadow { centre: scene.ball, radius: 1.7 * BALL_RADIUS, darkness: 0.6 };
        let shadows = self.static_objects.iter().flat_map(|group| &group.parts).filter(|part| part.is_shadow());
        for shadow in shadows.chain(&scene.robot.shadows()).chain([&ball]) {
            shadow.draw(view, &self.light, &mut self.canvas);
        }
    }

    /// Draws the objects on the field and the given parts of the robot. Calls `after` with the label of each drawn object.
    fn draw_solids(
        &mut self,
        view: &PinholeCamera,
        scene: &Scene,
        own: &Group,
        mut after: impl FnMut(&mut Canvas, PixelLabel),
    ) {
        let centre = scene.ball.extend(BALL_RADIUS);
        let ball = Group::of_one(PixelLabel::Ball, Solid::Sphere { centre, radius: BALL_RADIUS, colour: self.ball });
        let mut groups: Vec<&Group> = self.static_objects.iter().chain([&ball, own]).collect();
        let camera = Vec3::from(view.pose.translation);
        sort_far_first(&mut groups, |group| group.place.distance(camera.truncate()));
        for group in groups {
            let mut parts: Vec<&Solid> = group.parts.iter().filter(|part| !part.is_shadow()).collect();
            sort_far_first(&mut parts, |part| part.centre().distance(camera));
            for part in parts {
                part.draw(view, &self.light, &mut self.canvas);
            }
            after(&mut self.canvas, group.label);
        }
    }
}

impl Group {
    fn of_one(label: PixelLabel, part: Solid) -> Self {
        Self { label, place: part.centre().truncate(), parts: vec![part] }
    }
}

/// Converts a pixel to red, green and blue (BT.601, full range).
fn rgb([luma, blue, red, _]: Pixel) -> [u8; 3] {
    let (luma, blue, red) = (f32::from(luma), f32::from(blue) - 128.0, f32::from(red) - 128.0);
    [luma + 1.402 * red, luma - 0.344_136 * blue - 0.714_136 * red, luma + 1.772 * blue].map(|part| (part + 0.5) as u8)
}

fn sort_far_first<T>(items: &mut [T], distance: impl Fn(&T) -> f32) {
    items.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
}
/// Returns the parts of other robots, each with its place, m, and whether it is a teammate.
fn groups(
    others: impl Iterator<Item = (PosedRobot, Vec2, bool)>,
    team_colours: [RobotColours; 2],
) -> impl Iterator<Item = Group> {
    others.enumerate().map(move |(index, (robot, place, is_teammate))| {
        let parts = robot.solids(team_colours[usize::from(is_teammate)]).into_iter().chain(robot.shadows()).collect();
        Group { label: PixelLabel::OtherRobot(index), place, parts }
    })
}
