//! The dynamic world: MuJoCo with motors, sensors, cameras and referee.

use core::marker::PhantomData;
use core::time::Duration;

use bica_core::action::Actions;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::MujocoModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Buttons, CameraId, Command, Image, Sensors};
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3};
use mujoco_rs::prelude::{MjData, MjModel};

use super::contacts::{Contacts, GeomOwners};
use super::error::Error;
use super::fall_monitor::FallMonitor;
use super::model::{Drive, FreeJoint, Model, SHADOWS, STEP};
use super::motors::{Motors, currents};
use super::physics::{Fault, Physics};
use super::robot_camera::{Exposure, RobotCamera};
use super::sensor_model::{Measurement, SensorModel};
use super::spectator::{Moving, SpectatorRenderer};
use super::state::{angles, ideal_measurement, place, pose, stand, write};
use crate::field::BALL_RADIUS;
use crate::layout::Layout;
use crate::motor_heat::MotorHeat;
use crate::placement;
use crate::random::{Random, Stream};
use crate::referee::Referee;
use crate::referee::rules::Rules;
use crate::setup::Setup;
use crate::shared_image::SharedImage;
use crate::spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
use crate::transform::{angular_velocity, ground_pose};
use crate::world::{CYCLE, CYCLE_SECONDS, World, frame, image_is_due};

/// Number of steps of the physics per control cycle.
const STEPS: usize = (CYCLE_SECONDS / STEP + 0.5) as usize;

/// A robot of the model `M` on the field of 2009, simulated by rigid-body dynamics.
pub struct MujocoWorld<M> {
    model: PhantomData<M>,
    setup: Setup,
    layout: Layout,
    cycle: u64,
    data: MjData<Box<MjModel>>,
    torso: FreeJoint,
    ball: FreeJoint,
    drives: Vec<Drive>,
    feet: [usize; 2],
    owners: GeomOwners,
    motors: Motors,
    heat: MotorHeat,
    sensor_model: SensorModel,
    measurement: Measurement,
    robot_camera: Option<RobotCamera>,
    spectator: Option<SpectatorRenderer>,
    camera: CameraId,
    /// Poses of both cameras in the previous cycle, field frame.
    previous_cameras: [Affine3A; 2],
    image_is_new: bool,
    buttons: Buttons,
    body_touches_floor: bool,
    fall_monitor: FallMonitor,
    rules: Rules,
    referee: Referee,
}

impl<M: MujocoModel> MujocoWorld<M> {
    /// Builds a world in its start state.
    ///
    /// # Errors
    ///
    /// If setup or physics is invalid, or no renderer is available; the error contains the reason.
    pub fn new(setup: &Setup, physics: &Physics) -> Result<Self, Error> {
        setup.check::<M>()?;
        physics.check()?;
        let layout = Layout::new(setup, &mut Random::new(setup.seed, Stream::Start));
        let Model { physics: model, torso, ball, drives, feet } = Model::new::<M>(setup, &layout, physics)?;
        let owners = GeomOwners::of(&model);
        let robot_camera = physics.cameras.then(|| RobotCamera::new(setup, &model)).transpose()?;
        let mut data = MjData::new(model);
        stand::<M>(&mut data, torso, &drives, layout.start.robot);
        place(&mut data, ball, layout.start.ball);
        data.forward();
        let fall_monitor = FallMonitor::new(layout.start.robot.heading);
        let others = layout.others.iter().map(|other| other.pose).collect();
        let mut sensor_model = SensorModel::new(ideal_measurement(&data, torso, &drives), setup.seed, physics);
        let measurement = sensor_model.measure();
        let referee = Referee::new(layout.attacks, layout.start.robot, layout.start.ball, others);
        let mut world = Self {
            model: PhantomData,
            setup: *setup,
            layout,
            cycle: 0,
            data,
            torso,
            ball,
            drives,
            feet,
            owners,
            motors: Motors::holding::<M>(M::STAND, physics),
            heat: MotorHeat::new::<M>(),
            sensor_model,
            measurement,
            robot_camera,
            spectator: None,
            camera: CameraId::Top,
            previous_cameras: [Affine3A::IDENTITY; 2],
            image_is_new: false,
            buttons: Buttons::default(),
            body_touches_floor: false,
            fall_monitor,
            rules: Rules::default(),
            referee,
        };
        world.previous_cameras = world.cameras();
        Ok(world)
    }

    /// Injects a permanent fault. For experiments.
    pub fn inject_fault(&mut self, fault: Fault) {
        match fault {
            Fault::Gyroscope => self.sensor_model.fail_gyroscope(),
            Fault::SoleSensors(side) => self.sensor_model.fail_sole(side),
            Fault::Motor(joint) => self.motors.fail(joint),
        }
    }

    /// Sets the temperature of a joint's motor, °C; from then on the thermal model continues. For experiments.
    pub fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.heat.set(joint, temperature);
    }

    /// Returns whether a part of the robot other than its feet touched the floor in the last control cycle. For experiments.
    #[must_use]
    pub const fn body_touches_floor(&self) -> bool {
        self.body_touches_floor
    }

    /// Sets the position of the ball, m, field frame, at rest. For experiments.
    ///
    /// Values that are not finite are ignored.
    pub fn set_ball(&mut self, at: Vec2) {
        if at.is_finite() {
            place(&mut self.data, self.ball, at);
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
            write(&mut self.data.qvel_mut()[self.ball.velocity..], &numbers);
        }
    }

    /// Advances by one step of the physics. Returns the torques of the joints, Nm.
    fn step(&mut self, contacts: &mut Contacts) -> Joints {
        let torques = self.motors.step(&self.angles());
        for drive in &self.drives {
            self.data.ctrl_mut()[drive.actuator] = torques[drive.joint].into();
        }
        self.data.step();
        let ahead = self.feet.map(|foot| {
            let pose = &self.data.xmat()[foot];
            Vec3::new(pose[0] as f32, pose[3] as f32, pose[6] as f32)
        });
        self.owners.collect(&self.data, ahead, contacts);
        self.sensor_model.step(ideal_measurement(&self.data, self.torso, &self.drives));
        torques
    }

    /// Returns the pose of the robot frame in the field frame.
    fn robot(&self) -> Affine3A {
        pose(&self.data, self.torso)
    }

    /// Returns the joint angles.
    fn angles(&self) -> Joints {
        angles(&self.data, &self.drives)
    }

    /// Returns the poses of all segments in the robot frame.
    fn skeleton(&self) -> Skeleton<M> {
        Skeleton::of(&self.angles())
    }

    /// Returns the poses of both cameras in the field frame.
    fn cameras(&self) -> [Affine3A; 2] {
        let (robot, skeleton) = (self.robot(), self.skeleton());
        [CameraId::Top, CameraId::Bottom].map(|camera| robot * skeleton.camera(camera))
    }

    /// Moves the shadows under feet, torso and ball.
    fn place_shadows(&mut self) {
        let (robot, skeleton) = (self.robot(), self.skeleton());
        let soles = Side::BOTH.map(|side| ground_pose(&(robot * skeleton.sole(side))));
        let middle = Vec2::new(M::EXTENTS.sole_middle, 0.0);
        let [left, right] = soles.map(|sole| Pose2 { position: sole.place(middle), ..sole });
        let ball = Pose2 { position: self.ball_state().0, heading: 0.0 };
        let shadows: [Pose2; SHADOWS] = [left, right, ground_pose(&robot), ball];
        for (index, shadow) in shadows.iter().enumerate() {
            let turn = Quat::from_rotation_z(shadow.heading);
            write(&mut self.data.mocap_pos_mut()[index], &shadow.position.to_array());
            write(&mut self.data.mocap_quat_mut()[index], &[turn.w, turn.x, turn.y, turn.z]);
        }
    }

    fn take_image(&mut self) {
        if self.image_is_new || !image_is_due(self.cycle) || self.robot_camera.is_none() {
            return;
        }
        let (previous, pose) = (self.previous_cameras[self.camera as usize], self.cameras()[self.camera as usize]);
        let angular_velocity = angular_velocity(&previous.matrix3, &pose.matrix3);
        let focal = M::DIMENSIONS.camera(self.camera).focal;
        let exposure = Exposure { camera: self.camera, pose, focal, angular_velocity, frame: frame(self.cycle) };
        self.place_shadows();
        if let Some(robot_camera) = &mut self.robot_camera {
            robot_camera.take(&mut self.data, &exposure);
            self.image_is_new = true;
        }
    }

    /// Updates ground truth and events at the end of a control cycle.
    fn update_referee(&mut self, contacts: Contacts) {
        let (now, robot) = (self.now(), self.robot());
        if let Some(event) = self.fall_monitor.step::<M>(&robot, contacts.floor) {
            self.referee.record(now, event);
        }
        self.referee.set_robot(self.fall_monitor.pose(&robot), self.fall_monitor.posture());
        if contacts.obstacle {
            self.rules.record_collision(now, &mut self.referee);
        }
        let (at, velocity) = self.ball_state();
        self.rules.record_touch(now, contacts.ball, velocity.length(), &mut self.referee);
        if let Some(back) = self.rules.apply(now, at, &mut self.referee) {
            place(&mut self.data, self.ball, back);
        }
        let (at, velocity) = self.ball_state();
        self.referee.set_ball(at, velocity);
    }

    /// Returns position, m, and velocity, m/s, of the ball, field frame.
    fn ball_state(&self) -> (Vec2, Vec2) {
        let plane = |numbers: &[f64], at: usize| Vec2::new(numbers[at] as f32, numbers[at + 1] as f32);
        (plane(self.data.qpos(), self.ball.position), plane(self.data.qvel(), self.ball.velocity))
    }
}

impl<M: MujocoModel> World for MujocoWorld<M> {
    fn now(&self) -> Duration {
        CYCLE * u32::try_from(self.cycle).unwrap_or(u32::MAX)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.take_image();
        Sensors {
            angles: self.measurement.angles,
            temperatures: self.heat.temperatures(),
            currents: self.heat.currents(),
            inertial: self.measurement.inertial,
            left_foot: self.measurement.feet[0],
            right_foot: self.measurement.feet[1],
            buttons: self.buttons,
            image: self.robot_camera.as_ref().filter(|_| self.image_is_new).map(|robot_camera| {
                let (width, height, yuyv) = robot_camera.image();
                Image { camera: self.camera, width, height, yuyv }
            }),
        }
    }

    fn act(&mut self, command: &Command) {
        self.previous_cameras = self.cameras();
        self.image_is_new = false;
        self.camera = command.camera;
        self.cycle += 1;
        self.motors.command::<M>(command);
        let mut contacts = Contacts::default();
        let mut mean_currents = Joints::all(0.0);
        for _ in 0..STEPS {
            let torques = self.step(&mut contacts);
            for (mean, current) in mean_currents.0.iter_mut().zip(currents::<M>(&torques).0) {
                *mean += current / STEPS as f32;
            }
        }
        self.heat.step(mean_currents);
        self.buttons = contacts.buttons;
        self.body_touches_floor = contacts.floor;
        self.measurement = self.sensor_model.measure();
        self.update_referee(contacts);
    }

    fn actions(&mut self) -> &mut dyn Actions {
        self
    }

    fn put_ball(&mut self, at: Vec2) -> Result<(), &'static str> {
        placement::check_ball::<M>(at, &self.referee)?;
        place(&mut self.data, self.ball, at);
        // The next image is drawn from quantities that are derived from the positions.
        self.data.forward();
        self.rules.cancel_return();
        self.referee.set_ball(at, Vec2::ZERO);
        Ok(())
    }

    fn put_robot(&mut self, at: Pose2) -> Result<(), &'static str> {
        placement::check_robot::<M>(at.position, &self.referee)?;
        stand::<M>(&mut self.data, self.torso, &self.drives, at);
        let of_ball = self.ball.velocity..self.ball.velocity + 6;
        for (index, velocity) in self.data.qvel_mut().iter_mut().enumerate() {
            if !of_ball.contains(&index) {
                *velocity = 0.0;
            }
        }
        self.data.forward();
        self.motors.hold(M::STAND);
        self.fall_monitor = FallMonitor::new(at.heading);
        self.previous_cameras = self.cameras();
        self.referee.set_robot(at, self.fall_monitor.posture());
        Ok(())
    }

    fn add_velocity(&mut self, velocity: Vec2) {
        if velocity.is_finite() {
            let own = &mut self.data.qvel_mut()[self.torso.velocity..][..2];
            own[0] += f64::from(velocity.x);
            own[1] += f64::from(velocity.y);
        }
    }

    fn shared_image(&self) -> SharedImage {
        self.robot_camera.as_ref().map(RobotCamera::shared).unwrap_or_default()
    }

    fn referee(&self) -> &Referee {
        &self.referee
    }
}

impl<M: MujocoModel> SpectatorView for MujocoWorld<M> {
    fn render_from(&mut self, camera: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError> {
        let fits = |renderer: &SpectatorRenderer| renderer.size() == (width, height);
        let renderer = match self.spectator.take().filter(fits) {
            Some(renderer) => renderer,
            None => SpectatorRenderer::new::<M>(&self.setup, &self.layout, width, height)?,
        };
        let ball = pose(&self.data, self.ball).translation.into();
        let moving = Moving { robot: self.robot(), skeleton: self.skeleton(), ball };
        self.spectator.insert(renderer).render(&moving, camera)
    }
}
