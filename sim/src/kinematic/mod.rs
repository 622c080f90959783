//! The built-in world: one NAO, its joints moving by kinematics, on the field of 2009.
//!
//! The robot stands on the foot that carries it; nothing accelerates but the ball. That is plain, but it is honest about
//! what a player must cope with: late motors, slipping feet, falls, noise, and images with all that a hall holds.

mod ball;
mod body;
mod collision;
mod convex_hull;
mod foot_contact;
mod game;
mod render;

use core::time::Duration;

use bica_motion::joints::Joint;
use bica_motion::robot::{Buttons, CameraId, Command, Image, Sensors};
use glam::{Affine3A, Vec2};

use self::ball::Ball;
use self::body::Body;
use self::game::Game;
use self::render::{Renderer, Scene};
use crate::layout::{Layout, Other};
use crate::obstacle::{GOALS, Obstacle};
use crate::random::{Random, Stream};
use crate::referee::{Posture, Referee};
use crate::segmentation::PixelLabel;
use crate::setup::{Setup, SetupError};
use crate::spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
use crate::transform::angular_velocity;
use crate::world::{CYCLE, World, frame, image_is_due};

/// A robot on the field of 2009.
#[derive(Clone, Debug)]
pub struct KinematicWorld {
    cycle: u64,
    body: Body,
    buttons: Buttons,
    game: Game,
    others: Vec<Obstacle>,
    referee: Referee,
    camera: CameraId,
    /// Both cameras' poses a cycle ago.
    cameras_before: [Affine3A; 2],
    renderer: Renderer,
    image: Vec<u8>,
    image_is_new: bool,
}

impl KinematicWorld {
    /// A game that is about to start.
    ///
    /// # Errors
    ///
    /// If the setup makes no world; the error names what is wrong.
    pub fn new(setup: &Setup) -> Result<Self, SetupError> {
        setup.check()?;
        let layout = Layout::new(setup, &mut Random::new(setup.seed, Stream::Start));
        let body = Body::standing(layout.start.robot, setup.seed);
        let others = layout.others.iter().map(|other| other.pose).collect();
        let referee = Referee::new(layout.attacks, body.pose(), layout.start.ball, others);
        let cameras_before = cameras(&body);
        let (width, height) = setup.frame.size();
        let mut world = Self {
            cycle: 0,
            body,
            buttons: Buttons::default(),
            game: Game::new(Ball::at(layout.start.ball, layout.braking)),
            others: layout.others.iter().map(legs).collect(),
            referee,
            camera: CameraId::Top,
            cameras_before,
            renderer: Renderer::new(setup, &layout),
            image: vec![0; 2 * width * height],
            image_is_new: false,
        };
        world.keep_out();
        Ok(world)
    }

    /// Makes a joint's motor that hot, °C; from then on it cools or warms as usual. For trials.
    pub fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.body.heat(joint, temperature);
    }

    /// Whether a camera takes an image in this cycle.
    const fn image_is_due(&self) -> bool {
        image_is_due(self.cycle)
    }

    /// The number of the newest image.
    const fn frame(&self) -> u64 {
        frame(self.cycle)
    }

    fn keep_out(&mut self) -> bool {
        let standing: Vec<Obstacle> = GOALS.iter().chain(&self.others).copied().collect();
        let (buttons, hit) = collision::resolve(&mut self.body, &standing);
        self.buttons = buttons;
        hit
    }

    fn move_ball(&mut self, soles_before: [Affine3A; 2], now: Duration) {
        let soles = self.body.soles();
        let ways = [(soles_before[0], soles[0]), (soles_before[1], soles[1])];
        let mut obstacles: Vec<Obstacle> = GOALS.iter().chain(&self.others).copied().collect();
        if matches!(self.body.posture(), Posture::Down(_)) {
            obstacles.push(lying(&self.body));
        }
        self.game.step(now, ways, &obstacles, &mut self.referee);
    }

    /// What every pixel of an image taken now would show, row by row from the top left. For judging only, as all that the
    /// [`Referee`] knows. Cost: about that of an image.
    pub fn segmentation_mask(&mut self) -> Vec<PixelLabel> {
        let camera = self.body.camera(self.camera);
        let scene = scene(&self.body, camera, &camera, self.frame(), self.game.ball.position);
        self.renderer.segmentation_mask(&scene)
    }

    fn take_image(&mut self) {
        let camera = self.body.camera(self.camera);
        let before = &self.cameras_before[self.camera as usize];
        let scene = scene(&self.body, camera, before, self.frame(), self.game.ball.position);
        self.renderer.draw(&scene, &mut self.image);
    }
}

impl SpectatorView for KinematicWorld {
    fn render_from(&mut self, from: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError> {
        let camera = self.body.camera(self.camera);
        let scene = scene(&self.body, camera, &camera, self.frame(), self.game.ball.position);
        Ok(self.renderer.film(&scene, from, width, height))
    }
}

/// What the camera sees that was at the pose `before` a cycle ago.
fn scene<'a>(body: &'a Body, camera: Affine3A, before: &Affine3A, frame: u64, ball: Vec2) -> Scene<'a> {
    let turning = angular_velocity(&before.matrix3, &camera.matrix3);
    Scene { camera, turning, frame, ball, robot: body.robot(), skeleton: body.skeleton() }
}

impl World for KinematicWorld {
    fn now(&self) -> Duration {
        CYCLE * u32::try_from(self.cycle).unwrap_or(u32::MAX)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        if self.image_is_due() && !self.image_is_new {
            self.take_image();
            self.image_is_new = true;
        }
        let (width, height) = self.renderer.size();
        let image = Image { camera: self.camera, width: width as u16, height: height as u16, yuyv: &self.image };
        let felt = self.body.felt();
        Sensors {
            angles: felt.angles,
            temperatures: felt.temperatures,
            currents: felt.currents,
            inertial: felt.inertial,
            left_foot: felt.feet[0],
            right_foot: felt.feet[1],
            buttons: self.buttons,
            image: self.image_is_new.then_some(image),
        }
    }

    fn act(&mut self, command: &Command) {
        self.cameras_before = cameras(&self.body);
        self.image_is_new = false;
        self.cycle += 1;
        self.camera = command.camera;
        let now = self.now();
        let soles_before = self.body.soles();
        if let Some(event) = self.body.step(command) {
            self.referee.record(now, event);
        }
        if self.keep_out() {
            self.game.rules.note_collision(now, &mut self.referee);
        }
        self.body.measure();
        self.referee.set_robot(self.body.pose(), self.body.posture());
        self.move_ball(soles_before, now);
    }

    fn referee(&self) -> &Referee {
        &self.referee
    }
}

fn cameras(body: &Body) -> [Affine3A; 2] {
    [CameraId::Top, CameraId::Bottom].map(|camera| body.camera(camera))
}

fn legs(other: &Other) -> Obstacle {
    let foot = |y| other.pose.place(Vec2::new(0.02, y));
    Obstacle::legs(foot(0.05), foot(-0.05))
}

fn lying(body: &Body) -> Obstacle {
    let along = |z| body.robot().transform_point3(glam::Vec3::new(0.0, 0.0, z)).truncate();
    Obstacle::lying(along(0.0), along(0.25))
}
