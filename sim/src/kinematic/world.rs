//! The kinematic world: body, ball, obstacles, camera and referee.

use core::time::Duration;

use bica_core::action::Actions;
use bica_motion::joints::Joint;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Buttons, CameraId, Command, Image, Sensors};
use glam::{Affine3A, Vec2};

use super::ball::Ball;
use super::body::Body;
use super::render::{PosedRobot, Renderer, Scene};
use super::{ball_motion, collision};
use crate::layout::Layout;
use crate::limb_motions::LimbMotions;
use crate::match_field::{MatchWorld, Other};
use crate::obstacle::{GOALS, Obstacle};
use crate::placement;
use crate::random::{Random, Stream};
use crate::referee::rules::Rules;
use crate::referee::{Posture, Referee};
use crate::segmentation::PixelLabel;
use crate::setup::{Setup, SetupError, check_ball};
use crate::shared_image::{ImageMemory, SharedImage};
use crate::spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
use crate::world::{CYCLE, Pushes, World, frame, image_is_due};
use bica_body::transform::angular_velocity;

/// A humanoid on the field of 2009, simulated by kinematics.
#[derive(Clone, Debug)]
pub struct KinematicWorld {
    model: &'static SimulatedModel,
    cycle: u64,
    body: Body,
    buttons: Buttons,
    ball: Ball,
    rules: Rules,
    /// Goals, then other robots.
    obstacles: Vec<Obstacle>,
    referee: Referee,
    camera: CameraId,
    /// Poses of both cameras in the previous cycle, field frame.
    previous_cameras: [Affine3A; 2],
    renderer: Renderer,
    image: ImageMemory,
    image_is_new: bool,
    /// Limb motions that an operator has requested.
    pub(crate) limbs: LimbMotions,
    pushes: Pushes,
    /// Whether the robot has touched the ball in the last cycle.
    touches: bool,
}

impl KinematicWorld {
    /// Builds a world in its start state.
    ///
    /// # Errors
    ///
    /// If the setup is invalid; the error names the parameter.
    pub fn new(model: &'static SimulatedModel, setup: &Setup) -> Result<Self, SetupError> {
        setup.check(model)?;
        let layout = Layout::new(setup, &mut Random::new(setup.seed, Stream::Start));
        let mut body = Body::standing(model, layout.start.robot, setup.seed);
        body.mount_cameras(setup.mounting);
        let others = layout.others.iter().map(|other| other.pose).collect();
        let referee = Referee::new(layout.attacks, body.pose(), layout.start.ball, others);
        let previous_cameras = cameras(&body);
        let (width, height) = setup.frame.size();
        let mut world = Self {
            model,
            cycle: 0,
            body,
            buttons: Buttons::default(),
            ball: Ball::at(layout.start.ball, layout.rolling_deceleration),
            rules: Rules::default(),
            obstacles: GOALS
                .iter()
                .copied()
                .chain(layout.others.iter().map(|other| Obstacle::legs(model, &other.pose)))
                .collect(),
            referee,
            camera: CameraId::Top,
            previous_cameras,
            renderer: Renderer::new(setup, &layout, |at| PosedRobot::standing(model, at)),
            image: ImageMemory::new(2 * width * height),
            image_is_new: false,
            limbs: LimbMotions::default(),
            pushes: Pushes::default(),
            touches: false,
        };
        world.resolve_collisions();
        Ok(world)
    }

    /// Sets the temperature of a joint's motor, °C; from then on the thermal model continues. For experiments.
    pub fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.body.set_motor_temperature(joint, temperature);
    }

    /// Puts the ball at a position, m, with a velocity, m/s; field frame. This cancels a pending return into play. For
    /// experiments, such as shots at a goal.
    ///
    /// # Errors
    ///
    /// If the position is not on the carpet, within a goal post or a net or under the robot, or if the velocity is not finite. The
    /// ball then stays as it is.
    pub fn set_ball(&mut self, position: Vec2, velocity: Vec2) -> Result<(), SetupError> {
        check_ball(self.model, position, velocity, self.body.pose())?;
        self.ball.position = position;
        self.ball.velocity = velocity;
        self.rules.cancel_return();
        self.referee.set_ball(position, velocity);
        Ok(())
    }

    /// Renders the label of each pixel of an image taken now, row by row from the top left. Ground truth, for evaluation
    /// only. Takes about as long as an image.
    pub fn segmentation_mask(&mut self) -> Vec<PixelLabel> {
        let scene = self.scene(&self.body.camera(self.camera));
        self.renderer.segmentation_mask(&scene)
    }

    /// Moves the robot out of obstacles and sets the bumpers. Returns whether it touched any.
    fn resolve_collisions(&mut self) -> bool {
        let (buttons, hit) = collision::resolve(&mut self.body, &self.obstacles);
        self.buttons = buttons;
        hit
    }

    fn move_ball(&mut self, previous_soles: [Affine3A; 2], now: Duration) {
        let soles = self.body.soles();
        let motions = [(previous_soles[0], soles[0]), (previous_soles[1], soles[1])];
        let mut obstacles = self.obstacles.clone();
        if matches!(self.body.posture(), Posture::Down(_)) {
            obstacles.push(Obstacle::lying(self.model, self.body.robot()));
        }
        let touching = ball_motion::advance(self.model, &mut self.ball, motions, &obstacles);
        self.touches = touching.is_some();
        self.rules.record_touch(now, touching, self.ball.velocity.length(), &mut self.referee);
        if let Some(place) = self.rules.apply(now, self.ball.position, &mut self.referee) {
            self.ball = Ball::at(place, self.ball.rolling_deceleration);
        }
        self.referee.set_ball(self.ball.position, self.ball.velocity);
    }

    /// Describes the scene of the selected camera, whose pose was `previous` one cycle ago.
    fn scene(&self, previous: &Affine3A) -> Scene {
        let camera = self.body.camera(self.camera);
        Scene {
            camera,
            focal: self.model.dimensions.camera(self.camera).focal,
            angular_velocity: angular_velocity(&previous.matrix3, &camera.matrix3),
            frame: frame(self.cycle),
            ball: self.ball.position,
            robot: PosedRobot::new(self.model, *self.body.robot(), self.body.skeleton()),
        }
    }

    fn take_image(&mut self) {
        let scene = self.scene(&self.previous_cameras[self.camera as usize]);
        self.image.draw(|pixels| self.renderer.draw(&scene, pixels));
    }
}

impl World for KinematicWorld {
    fn now(&self) -> Duration {
        CYCLE * u32::try_from(self.cycle).unwrap_or(u32::MAX)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        if image_is_due(self.cycle) && !self.image_is_new {
            self.take_image();
            self.image_is_new = true;
        }
        let (width, height) = self.renderer.size();
        let image =
            Image { camera: self.camera, width: width as u16, height: height as u16, yuyv: self.image.pixels() };
        let measured = self.body.measurement();
        Sensors {
            angles: measured.angles,
            temperatures: measured.temperatures,
            currents: measured.currents,
            inertial: measured.inertial,
            left_foot: measured.feet[0],
            right_foot: measured.feet[1],
            buttons: self.buttons,
            image: self.image_is_new.then_some(image),
        }
    }

    fn act(&mut self, command: &Command) {
        self.previous_cameras = cameras(&self.body);
        self.image_is_new = false;
        self.cycle += 1;
        self.pushes = Pushes::default();
        self.camera = command.camera;
        let now = self.now();
        let previous_soles = self.body.soles();
        let command = self.limbs.over(self.model, command, &self.body.measurement().angles);
        if let Some(event) = self.body.step(&command) {
            self.referee.record(now, event);
        }
        if self.resolve_collisions() {
            self.rules.record_collision(now, &mut self.referee);
        }
        self.body.measure();
        self.referee.set_robot(self.body.pose(), self.body.posture());
        self.move_ball(previous_soles, now);
    }

    fn actions(&mut self) -> &mut dyn Actions {
        self
    }

    fn put_ball(&mut self, at: Vec2) -> Result<(), &'static str> {
        placement::check_ball(self.model, at, &self.referee)?;
        self.ball = Ball::at(at, self.ball.rolling_deceleration);
        self.rules.cancel_return();
        self.referee.set_ball(at, Vec2::ZERO);
        Ok(())
    }

    fn put_robot(&mut self, at: Pose2) -> Result<(), &'static str> {
        placement::check_robot(self.model, at.position, &self.referee)?;
        self.body.stand_at(at);
        self.limbs = LimbMotions::default();
        self.buttons = Buttons::default();
        self.previous_cameras = cameras(&self.body);
        self.referee.set_robot(self.body.pose(), self.body.posture());
        Ok(())
    }

    fn add_velocity(&mut self, velocity: Vec2) {
        if let Some(event) = self.body.push(self.pushes.add(velocity)) {
            self.referee.record(self.now(), event);
        }
        self.resolve_collisions();
        self.referee.set_robot(self.body.pose(), self.body.posture());
    }

    fn shared_image(&self) -> SharedImage {
        self.image.shared()
    }

    fn referee(&self) -> &Referee {
        &self.referee
    }
}

impl MatchWorld for KinematicWorld {
    fn as_send(&mut self) -> Option<&mut (dyn MatchWorld + Send)> {
        Some(self)
    }

    fn touches(&self) -> bool {
        self.touches
    }

    fn ball(&self) -> [Vec2; 2] {
        [self.ball.position, self.ball.velocity]
    }

    fn follow_ball(&mut self, [position, velocity]: [Vec2; 2]) {
        (self.ball.position, self.ball.velocity) = (position, velocity);
        self.referee.set_ball(position, velocity);
    }

    fn cancel_return(&mut self) {
        self.rules.cancel_return();
    }

    fn as_other(&self, turned: bool) -> Other {
        Other::new(self.model, (*self.body.robot(), self.body.skeleton()), &self.referee, turned)
    }

    fn set_others(&mut self, others: &[Other]) {
        self.obstacles.truncate(GOALS.len());
        let model = self.model;
        let obstacle = |other: &Other| {
            if other.is_down { Obstacle::lying(model, &other.posed.robot) } else { Obstacle::legs(model, &other.pose) }
        };
        self.obstacles.extend(others.iter().map(obstacle));
        self.referee.set_others(others.iter().map(|other| other.pose));
        if image_is_due(self.cycle) {
            self.renderer.set_others(others.iter().map(|other| (other.posed, other.pose.position, other.is_teammate)));
        }
    }
}

impl SpectatorView for KinematicWorld {
    fn render_from(&mut self, camera: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError> {
        let scene = self.scene(&self.body.camera(self.camera));
        Ok(self.renderer.render_from(&scene, camera, width, height))
    }
}

fn cameras(body: &Body) -> [Affine3A; 2] {
    [CameraId::Top, CameraId::Bottom].map(|camera| body.camera(camera))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use crate::setup::{Frame, Start};

    #[test]
    fn robot_sees_one_that_comes_into_its_view() {
        let world = |robot| {
            let start = Some(Start { robot, ball: Vec2::new(2.0, 1.0) });
            let setup = Setup { frame: Frame::Small, goalkeeper: false, start, ..Setup::default() };
            KinematicWorld::new(TEST_MODEL, &setup).expect("a free place")
        };
        let seen = |other: Pose2| {
            let mut own = world(Pose2::new(-1.0, 0.0, 0.0));
            own.set_others(&[world(other).as_other(true)]);
            let labels = own.segmentation_mask();
            labels.iter().filter(|label| matches!(label, PixelLabel::OtherRobot(_))).count()
        };
        assert!(seen(Pose2::new(-1.0, 0.5, 0.0)) > 0, "it is ahead");
        assert_eq!(seen(Pose2::new(2.5, 0.5, 0.0)), 0, "it is behind");
    }
}
