//! The dynamic world: MuJoCo with motors, sensors, cameras and referee.

use core::f32::consts::FRAC_PI_2;
use core::time::Duration;

use bica_body::mujoco::{Data, Fault, FreeJoint, Humanoid, Physics, pose, write};
use bica_body::transform::{angular_velocity, ground_pose};
use bica_core::action::Actions;
use bica_motion::joints::Joint;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command, Image, Sensors};
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2};

use super::error::Error;
use super::model::{SHADOWS, build};
use super::robot_camera::{Exposure, RobotCamera};
use super::spectator::{Moving, SpectatorRenderer};
use crate::field::BALL_RADIUS;
use crate::layout::{Layout, OtherRobot};
use crate::limb_motions::LimbMotions;
use crate::match_field::{MatchWorld, Other};
use crate::placement;
use crate::random::{Random, Stream};
use crate::referee::rules::Rules;
use crate::referee::{Event, Posture, Referee};
use crate::setup::Setup;
use crate::shared_image::SharedImage;
use crate::spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
use crate::world::{CYCLE, Pushes, World, frame, image_is_due};

/// Distance from the middle of the field at which the others are built, m.
const AWAY: f32 = 9.0;
/// Height of the middle of a robot that lies, m.
const LYING_HEIGHT: f32 = 0.06;

/// A humanoid on the field of 2009, simulated by rigid-body dynamics.
pub struct MujocoWorld {
    model: &'static SimulatedModel,
    setup: Setup,
    layout: Layout,
    cycle: u64,
    body: Humanoid,
    ball: FreeJoint,
    robot_camera: Option<RobotCamera>,
    spectator: Option<SpectatorRenderer>,
    camera: CameraId,
    /// Poses of both cameras in the previous cycle, field frame.
    previous_cameras: [Affine3A; 2],
    image_is_new: bool,
    /// Limb motions that an operator has requested.
    pub(crate) limbs: LimbMotions,
    pushes: Pushes,
    rules: Rules,
    referee: Referee,
}

impl MujocoWorld {
    /// Builds a world in its start state.
    ///
    /// # Errors
    ///
    /// If setup or physics is invalid, or no renderer is available; the error contains the reason.
    pub fn new(model: &'static SimulatedModel, setup: &Setup, physics: &Physics) -> Result<Self, Error> {
        setup.check(model)?;
        Self::with_layout(model, setup, physics, Layout::new(setup, &mut Random::new(setup.seed, Stream::Start)))
    }

    /// Builds the world of a robot of a match. `mates`: whether each of the others belongs to its team; they come to the field with
    /// [`MatchWorld::set_others`].
    pub(crate) fn in_match(model: &'static SimulatedModel, setup: &Setup, mates: &[bool]) -> Result<Self, Error> {
        setup.check(model)?;
        let mut layout = Layout::new(setup, &mut Random::new(setup.seed, Stream::Start));
        let away = |index: usize| Pose2::new(index as f32, AWAY, 0.0);
        layout.others.extend((0..).zip(mates).map(|(index, mate)| OtherRobot { pose: away(index), teammate: *mate }));
        layout.others_move = true;
        Self::with_layout(model, setup, &Physics::of(model), layout)
    }

    fn with_layout(
        model: &'static SimulatedModel,
        setup: &Setup,
        physics: &Physics,
        layout: Layout,
    ) -> Result<Self, Error> {
        let (built, ball) = build(model, setup, &layout, physics)?;
        let robot_camera = physics.cameras.then(|| RobotCamera::new(setup, &built.physics)).transpose()?;
        let noise = Random::new(setup.seed, Stream::Sensors);
        let body = Humanoid::new(model, built, layout.start.robot, noise, physics, |data| {
            place(data, ball, layout.start.ball);
        });
        let others = layout.others.iter().map(|other| other.pose).collect();
        let referee = Referee::new(layout.attacks, layout.start.robot, layout.start.ball, others);
        let mut world = Self {
            model,
            setup: *setup,
            layout,
            cycle: 0,
            body,
            ball,
            robot_camera,
            spectator: None,
            camera: CameraId::Top,
            previous_cameras: [Affine3A::IDENTITY; 2],
            image_is_new: false,
            limbs: LimbMotions::default(),
            pushes: Pushes::default(),
            rules: Rules::default(),
            referee,
        };
        world.previous_cameras = world.cameras();
        Ok(world)
    }

    /// Injects a permanent fault. For experiments.
    pub fn inject_fault(&mut self, fault: Fault) {
        self.body.inject_fault(fault);
    }

    /// Sets the temperature of a joint's motor, °C; from then on the thermal model continues. For experiments.
    pub fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.body.set_motor_temperature(joint, temperature);
    }

    /// Returns whether a part of the robot other than its feet touched the floor in the last control cycle. For experiments.
    #[must_use]
    pub const fn body_touches_floor(&self) -> bool {
        self.body.contacts().floor
    }

    /// Sets the position of the ball, m, field frame, at rest. For experiments.
    ///
    /// Values that are not finite are ignored.
    pub fn set_ball(&mut self, at: Vec2) {
        if at.is_finite() {
            place(self.body.data_mut(), self.ball, at);
            self.referee.set_ball(at, Vec2::ZERO);
        }
    }

    /// Sets the velocity of the ball, m/s, field frame, rolling without slip. For experiments.
    ///
    /// Values that are not finite are ignored.
    pub fn kick_ball(&mut self, velocity: Vec2) {
        if velocity.is_finite() {
            let spin = Vec2::new(-velocity.y, velocity.x) / BALL_RADIUS;
            let numbers = [velocity.x, velocity.y, 0.0, spin.x, spin.y, 0.0];
            write(&mut self.body.data_mut().qvel_mut()[self.ball.velocity..], &numbers);
        }
    }

    /// Returns the poses of both cameras in the field frame.
    fn cameras(&self) -> [Affine3A; 2] {
        let (robot, skeleton) = (self.body.pose(), self.body.skeleton());
        [CameraId::Top, CameraId::Bottom].map(|camera| robot * skeleton.camera(camera))
    }

    /// Moves the shadows under feet, torso and ball.
    fn place_shadows(&mut self) {
        let (robot, skeleton) = (self.body.pose(), self.body.skeleton());
        let soles = Side::BOTH.map(|side| ground_pose(&(robot * skeleton.sole(side))));
        let middle = Vec2::new(self.model.extents.sole_middle, 0.0);
        let [left, right] = soles.map(|sole| Pose2 { position: sole.place(middle), ..sole });
        let ball = Pose2 { position: self.ball_state().0, heading: 0.0 };
        let shadows: [Pose2; SHADOWS] = [left, right, ground_pose(&robot), ball];
        for (index, shadow) in shadows.iter().enumerate() {
            let turn = Quat::from_rotation_z(shadow.heading);
            write(&mut self.body.data_mut().mocap_pos_mut()[index], &shadow.position.to_array());
            write(&mut self.body.data_mut().mocap_quat_mut()[index], &[turn.w, turn.x, turn.y, turn.z]);
        }
    }

    fn take_image(&mut self) {
        if self.image_is_new || !image_is_due(self.cycle) || self.robot_camera.is_none() {
            return;
        }
        let (previous, pose) = (self.previous_cameras[self.camera as usize], self.cameras()[self.camera as usize]);
        let angular_velocity = angular_velocity(&previous.matrix3, &pose.matrix3);
        let focal = self.model.dimensions.camera(self.camera).focal;
        let exposure = Exposure { camera: self.camera, pose, focal, angular_velocity, frame: frame(self.cycle) };
        self.place_shadows();
        if let Some(robot_camera) = &mut self.robot_camera {
            robot_camera.take(self.body.data_mut(), &exposure);
            self.image_is_new = true;
        }
    }

    /// Updates ground truth and events at the end of a control cycle.
    fn update_referee(&mut self, change: Option<Posture>) {
        let (now, contacts) = (self.now(), *self.body.contacts());
        if let Some(posture) = change {
            let event = if let Posture::Down(fall) = posture { Event::Fall(fall) } else { Event::GotUp };
            self.referee.record(now, event);
        }
        self.referee.set_robot(self.body.ground_pose(), self.body.posture());
        if contacts.obstacle {
            self.rules.record_collision(now, &mut self.referee);
        }
        let (at, velocity) = self.ball_state();
        self.rules.record_touch(now, contacts.loose, velocity.length(), &mut self.referee);
        if let Some(back) = self.rules.apply(now, at, &mut self.referee) {
            place(self.body.data_mut(), self.ball, back);
        }
        let (at, velocity) = self.ball_state();
        self.referee.set_ball(at, velocity);
    }

    /// Returns position, m, and velocity, m/s, of the ball, field frame.
    fn ball_state(&self) -> (Vec2, Vec2) {
        let plane = |numbers: &[f64], at: usize| Vec2::new(numbers[at] as f32, numbers[at + 1] as f32);
        (plane(self.body.data().qpos(), self.ball.position), plane(self.body.data().qvel(), self.ball.velocity))
    }
}

impl World for MujocoWorld {
    fn now(&self) -> Duration {
        CYCLE * u32::try_from(self.cycle).unwrap_or(u32::MAX)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.take_image();
        Sensors {
            image: self.robot_camera.as_ref().filter(|_| self.image_is_new).map(|robot_camera| {
                let (width, height, yuyv) = robot_camera.image();
                Image { camera: self.camera, width, height, yuyv }
            }),
            ..self.body.sensors()
        }
    }

    fn act(&mut self, command: &Command) {
        self.previous_cameras = self.cameras();
        self.image_is_new = false;
        self.camera = command.camera;
        self.cycle += 1;
        self.pushes = Pushes::default();
        let command = self.limbs.over(self.model, command, &self.body.sensors().angles);
        let change = self.body.act(&command);
        if self.body.failure().is_none() {
            self.update_referee(change);
        }
    }

    fn actions(&mut self) -> &mut dyn Actions {
        self
    }

    fn put_ball(&mut self, at: Vec2) -> Result<(), &'static str> {
        placement::check_ball(self.model, at, &self.referee)?;
        place(self.body.data_mut(), self.ball, at);
        // The next image is drawn from quantities that are derived from the positions.
        self.body.data_mut().forward();
        self.rules.cancel_return();
        self.referee.set_ball(at, Vec2::ZERO);
        Ok(())
    }

    fn put_robot(&mut self, at: Pose2) -> Result<(), &'static str> {
        placement::check_robot(self.model, at.position, &self.referee)?;
        self.body.stand(at);
        self.limbs = LimbMotions::default();
        self.previous_cameras = self.cameras();
        self.referee.set_robot(at, self.body.posture());
        Ok(())
    }

    fn add_velocity(&mut self, velocity: Vec2) {
        self.body.add_velocity(self.pushes.add(velocity));
    }

    fn failure(&self) -> Option<&str> {
        self.body.failure()
    }

    fn shared_image(&self) -> SharedImage {
        self.robot_camera.as_ref().map(RobotCamera::shared).unwrap_or_default()
    }

    fn referee(&self) -> &Referee {
        &self.referee
    }
}

impl MatchWorld for MujocoWorld {
    fn as_send(&mut self) -> Option<&mut (dyn MatchWorld + Send)> {
        None
    }

    fn touches(&self) -> bool {
        self.body.contacts().loose.is_some()
    }

    fn ball(&self) -> [Vec2; 2] {
        self.ball_state().into()
    }

    fn follow_ball(&mut self, [position, velocity]: [Vec2; 2]) {
        place(self.body.data_mut(), self.ball, position);
        self.kick_ball(velocity);
        self.referee.set_ball(position, velocity);
    }

    fn cancel_return(&mut self) {
        self.rules.cancel_return();
    }

    fn as_other(&self, turned: bool) -> Other {
        Other::new(self.model, (self.body.pose(), &self.body.skeleton()), &self.referee, turned)
    }

    fn set_others(&mut self, others: &[Other]) {
        let data = self.body.data_mut();
        for (index, other) in (SHADOWS..).zip(others) {
            let Pose2 { position, heading } = other.pose;
            let (height, tilt) = if other.is_down { (LYING_HEIGHT, FRAC_PI_2) } else { (0.0, 0.0) };
            let turn = Quat::from_rotation_z(heading) * Quat::from_rotation_y(tilt);
            write(&mut data.mocap_pos_mut()[index], &position.extend(height).to_array());
            write(&mut data.mocap_quat_mut()[index], &[turn.w, turn.x, turn.y, turn.z]);
        }
        self.referee.set_others(others.iter().map(|other| other.pose));
    }
}

impl SpectatorView for MujocoWorld {
    fn render_from(&mut self, camera: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError> {
        let fits = |renderer: &SpectatorRenderer| renderer.size() == (width, height);
        let renderer = match self.spectator.take().filter(fits) {
            Some(renderer) => renderer,
            None => SpectatorRenderer::new(self.model, &self.setup, &self.layout, width, height)?,
        };
        let ball = pose(self.body.data(), self.ball).translation.into();
        let moving = Moving { robot: self.body.pose(), skeleton: self.body.skeleton(), ball };
        self.spectator.insert(renderer).render(&moving, camera)
    }
}

/// Sets the ball to a position, at rest.
fn place(data: &mut Data, ball: FreeJoint, at: Vec2) {
    write(&mut data.qpos_mut()[ball.position..], &[at.x, at.y, BALL_RADIUS, 1.0, 0.0, 0.0, 0.0]);
    data.qvel_mut()[ball.velocity..][..6].fill(0.0);
}
