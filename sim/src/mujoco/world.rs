//! The world: MuJoCo steps, and what is around it.

use bica_field::FIELD;
use core::time::Duration;

use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::Pose2;
use bica_motion::robot::{Buttons, CameraId, Command, Image, Sensors};
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3};
use mujoco_rs::prelude::{MjData, MjModel};

use super::contacts::{Owners, Touches};
use super::error::Error;
use super::fall_monitor::FallMonitor;
use super::model::{Model, Place, SHADOWS, STEP};
use super::motors::{Motors, currents};
use super::physics::{Fault, Physics};
use super::robot_camera::{Aim, RobotCamera};
use super::sensor_model::{Measurement, SensorModel};
use super::spectator::{Moving, SpectatorRenderer};
use super::state::{angles, place, pose, stand, truth, write};
use crate::layout::Layout;
use crate::motor_heat::MotorHeat;
use crate::random::{Random, Stream};
use crate::referee::Referee;
use crate::referee::rules::Rules;
use crate::setup::Setup;
use crate::spectator::{Picture, RenderError, SpectatorCamera, SpectatorView};
use crate::transform::{angular_velocity, ground_pose};
use crate::world::{CYCLE, CYCLE_SECONDS, World, frame, image_is_due};

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// Steps of the physics in a control cycle.
const STEPS: usize = (CYCLE_SECONDS / STEP + 0.5) as usize;

/// A robot on the field of 2009, with real forces.
pub struct MujocoWorld {
    setup: Setup,
    layout: Layout,
    cycle: u64,
    data: MjData<Box<MjModel>>,
    torso: Place,
    ball: Place,
    joints: [usize; JOINTS],
    feet: [usize; 2],
    owners: Owners,
    motors: Motors,
    heat: MotorHeat,
    senses: SensorModel,
    felt: Measurement,
    eye: Option<RobotCamera>,
    film: Option<SpectatorRenderer>,
    camera: CameraId,
    /// Both cameras' poses a cycle ago.
    cameras_before: [Affine3A; 2],
    image_is_new: bool,
    buttons: Buttons,
    on_ground: bool,
    watch: FallMonitor,
    rules: Rules,
    referee: Referee,
}

impl MujocoWorld {
    /// A game that is about to start.
    ///
    /// # Errors
    ///
    /// If the setup or the physics makes no world; the error names what is wrong.
    pub fn new(setup: &Setup, physics: &Physics) -> Result<Self, Error> {
        setup.check()?;
        physics.check()?;
        let layout = Layout::new(setup, &mut Random::new(setup.seed, Stream::Start));
        let Model { physics: model, torso, ball, joints, feet } = Model::new(setup, &layout, physics)?;
        let owners = Owners::of(&model);
        let eye = physics.cameras.then(|| RobotCamera::new(setup, &model)).transpose()?;
        let mut data = MjData::new(model);
        stand(&mut data, torso, &joints, layout.start.robot);
        place(&mut data, ball, layout.start.ball);
        data.forward();
        let watch = FallMonitor::new(layout.start.robot.heading);
        let others = layout.others.iter().map(|other| other.pose).collect();
        let mut senses = SensorModel::new(truth(&data, torso, &joints), setup.seed, physics);
        let felt = senses.feel();
        let referee = Referee::new(layout.attacks, layout.start.robot, layout.start.ball, others);
        let mut world = Self {
            setup: *setup,
            layout,
            cycle: 0,
            data,
            torso,
            ball,
            joints,
            feet,
            owners,
            motors: Motors::holding(Nao::STAND, physics),
            heat: MotorHeat::new(),
            senses,
            felt,
            eye,
            film: None,
            camera: CameraId::Top,
            cameras_before: [Affine3A::IDENTITY; 2],
            image_is_new: false,
            buttons: Buttons::default(),
            on_ground: false,
            watch,
            rules: Rules::default(),
            referee,
        };
        world.cameras_before = world.cameras();
        Ok(world)
    }

    /// Pushes the robot: changes the velocity of its torso at once by `velocity`, m/s, field frame.
    ///
    /// A push that is no number is none.
    pub fn push(&mut self, velocity: Vec2) {
        if velocity.is_finite() {
            let own = &mut self.data.qvel_mut()[self.torso.velocity..][..2];
            own[0] += f64::from(velocity.x);
            own[1] += f64::from(velocity.y);
        }
    }

    /// Breaks a part of the robot for good. For trials.
    pub fn inject_fault(&mut self, fault: Fault) {
        match fault {
            Fault::Gyroscope => self.senses.break_gyroscope(),
            Fault::SoleSensors(side) => self.senses.break_sole(side),
            Fault::Motor(joint) => self.motors.break_down(joint),
        }
    }

    /// Makes a joint's motor that hot, °C; from then on it cools or warms as usual. For trials.
    pub fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.heat.set(joint, temperature);
    }

    /// Whether more of the robot than its feet touched the floor in the last control cycle. For trials.
    #[must_use]
    pub const fn body_touches_floor(&self) -> bool {
        self.on_ground
    }

    /// Puts the ball somewhere, at rest; m, field frame. For trials.
    /// A place that is no number is none.
    pub fn place_ball(&mut self, at: Vec2) {
        if at.is_finite() {
            place(&mut self.data, self.ball, at);
            self.referee.set_ball(at, Vec2::ZERO);
        }
    }

    /// Lets the ball roll at once with a velocity, m/s, field frame. For trials. One that is no number is none.
    pub fn kick_ball(&mut self, velocity: Vec2) {
        if velocity.is_finite() {
            let spin = Vec2::new(-velocity.y, velocity.x) / BALL_RADIUS;
            let numbers = [velocity.x, velocity.y, 0.0, spin.x, spin.y, 0.0];
            write(&mut self.data.qvel_mut()[self.ball.velocity..], &numbers);
        }
    }

    /// One step of the physics; the torques of the joints in it, Nm.
    fn step(&mut self, touches: &mut Touches) -> Joints {
        let torques = self.motors.step(&angles(&self.data, &self.joints));
        for (control, torque) in self.data.ctrl_mut().iter_mut().zip(torques.0) {
            *control = torque.into();
        }
        self.data.step();
        let ahead = self.feet.map(|foot| {
            let pose = &self.data.xmat()[foot];
            Vec3::new(pose[0] as f32, pose[3] as f32, pose[6] as f32)
        });
        self.owners.look(&self.data, ahead, touches);
        self.senses.step(truth(&self.data, self.torso, &self.joints));
        torques
    }

    /// The robot frame's pose in the field frame.
    fn robot(&self) -> Affine3A {
        pose(&self.data, self.torso)
    }

    /// Both cameras' poses in the field frame.
    fn cameras(&self) -> [Affine3A; 2] {
        let (robot, skeleton) = (self.robot(), Skeleton::<Nao>::of(&angles(&self.data, &self.joints)));
        [CameraId::Top, CameraId::Bottom].map(|camera| robot * skeleton.camera(camera))
    }

    /// Puts the shadows to where they are seen.
    fn shade(&mut self) {
        let (robot, skeleton) = (self.robot(), Skeleton::<Nao>::of(&angles(&self.data, &self.joints)));
        let soles = Side::BOTH.map(|side| ground_pose(&(robot * skeleton.sole(side))));
        let middle = Vec2::new(0.0227, 0.0);
        let [left, right] = soles.map(|sole| Pose2 { position: sole.place(middle), ..sole });
        let ball = Pose2 { position: self.seen_ball().0, heading: 0.0 };
        let shades: [Pose2; SHADOWS] = [left, right, ground_pose(&robot), ball];
        for (place, shade) in shades.iter().enumerate() {
            let turn = Quat::from_rotation_z(shade.heading);
            write(&mut self.data.mocap_pos_mut()[place], &shade.position.to_array());
            write(&mut self.data.mocap_quat_mut()[place], &[turn.w, turn.x, turn.y, turn.z]);
        }
    }

    fn take_image(&mut self) {
        if self.image_is_new || !image_is_due(self.cycle) || self.eye.is_none() {
            return;
        }
        let (before, pose) = (self.cameras_before[self.camera as usize], self.cameras()[self.camera as usize]);
        let turning = angular_velocity(&before.matrix3, &pose.matrix3);
        let aim = Aim { camera: self.camera, pose, turning, frame: frame(self.cycle) };
        self.shade();
        if let Some(eye) = &mut self.eye {
            eye.take(&mut self.data, &aim);
            self.image_is_new = true;
        }
    }

    fn judge(&mut self, touches: Touches) {
        let (now, robot) = (self.now(), self.robot());
        if let Some(event) = self.watch.look(&robot, touches.ground) {
            self.referee.record(now, event);
        }
        self.referee.set_robot(self.watch.pose(&robot), self.watch.posture());
        if touches.thing {
            self.rules.note_collision(now, &mut self.referee);
        }
        let (at, velocity) = self.seen_ball();
        self.rules.note_touch(now, touches.ball, velocity.length(), &mut self.referee);
        if let Some(back) = self.rules.apply(now, at, &mut self.referee) {
            place(&mut self.data, self.ball, back);
        }
        let (at, velocity) = self.seen_ball();
        self.referee.set_ball(at, velocity);
    }

    fn seen_ball(&self) -> (Vec2, Vec2) {
        let plane = |numbers: &[f64], at: usize| Vec2::new(numbers[at] as f32, numbers[at + 1] as f32);
        (plane(self.data.qpos(), self.ball.position), plane(self.data.qvel(), self.ball.velocity))
    }
}

impl World for MujocoWorld {
    fn now(&self) -> Duration {
        CYCLE * u32::try_from(self.cycle).unwrap_or(u32::MAX)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.take_image();
        Sensors {
            angles: self.felt.angles,
            temperatures: self.heat.temperatures(),
            currents: self.heat.currents(),
            inertial: self.felt.inertial,
            left_foot: self.felt.feet[0],
            right_foot: self.felt.feet[1],
            buttons: self.buttons,
            image: self.eye.as_ref().filter(|_| self.image_is_new).map(|eye| {
                let (width, height, yuyv) = eye.image();
                Image { camera: self.camera, width, height, yuyv }
            }),
        }
    }

    fn act(&mut self, command: &Command) {
        self.cameras_before = self.cameras();
        self.image_is_new = false;
        self.camera = command.camera;
        self.cycle += 1;
        self.motors.command(command);
        let mut touches = Touches::default();
        let mut drawn = Joints::all(0.0);
        for _ in 0..STEPS {
            let torques = self.step(&mut touches);
            for (mean, current) in drawn.0.iter_mut().zip(currents(&torques).0) {
                *mean += current / STEPS as f32;
            }
        }
        self.heat.step(drawn);
        self.buttons = touches.buttons;
        self.on_ground = touches.ground;
        self.felt = self.senses.feel();
        self.judge(touches);
    }

    fn referee(&self) -> &Referee {
        &self.referee
    }
}

impl SpectatorView for MujocoWorld {
    fn render_from(&mut self, from: &SpectatorCamera, width: usize, height: usize) -> Result<Picture, RenderError> {
        let fits = |film: &SpectatorRenderer| film.size() == (width, height);
        let film = match self.film.take().filter(fits) {
            Some(film) => film,
            None => SpectatorRenderer::new(&self.setup, &self.layout, width, height)?,
        };
        let ball = pose(&self.data, self.ball).translation.into();
        let skeleton = Skeleton::<Nao>::of(&angles(&self.data, &self.joints));
        let moving = Moving { robot: self.robot(), skeleton, ball };
        self.film.insert(film).take(&moving, from)
    }
}
