//! A robot in MuJoCo behind the driver, in step.

use bica_body::mujoco::{Humanoid, Model, Physics};
use bica_body::random::Random;
use bica_booster::message::{ImuState, LowState, MotorState};
use bica_booster::{Body, Gait};
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Command, Sensors};
use glam::EulerRot;

use crate::stand_in::StandIn;

/// Time from the beginning of a cycle until the program has answered, ms.
const ANSWER: u64 = 2;

/// The robot, with a program that answers after some time.
pub(crate) struct InStep {
    robot: StandIn,
    pub(crate) body: Humanoid,
    of: &'static Body,
}

impl InStep {
    /// A robot that stands.
    pub(crate) fn new(of: &'static Body, model: &'static SimulatedModel, seed: u64, physics: &Physics) -> Self {
        let built = Model::on_floor(model, physics).expect("a model");
        let body = Humanoid::new(model, built, Pose2::ORIGIN, Random::new(seed, 1_u64), physics, |_| {});
        let mut robot = StandIn::following(of, Gait::Own);
        // The motion to the stand ends; then a cycle of the program begins with that of the body.
        robot.run(3000);
        let cycles = robot.cycles;
        while robot.cycles == cycles {
            robot.run(1);
        }
        robot.run(9);
        robot.program = |_, _| None;
        Self { robot, body, of }
    }

    pub(crate) fn cycle(&mut self, program: &mut dyn FnMut(&Sensors<'_>) -> Command) {
        let state = self.state();
        self.robot.q = state.motor_state_serial.iter().map(|motor| motor.q).collect();
        self.robot.measured = Some(state);
        for _ in 0..10 {
            self.robot.run(1);
            if let Some(sensors) = self.robot.sensed.take() {
                self.robot.command = Some((self.robot.millis + ANSWER, program(&sensors)));
            }
        }
        let (_, sent) = self.robot.commands.last().expect("a command");
        let mut command = Command::new(self.of.model.stand, 0.0);
        for (joint, motor) in self.of.motors.iter().zip(&sent.motor_cmd) {
            (command.targets[*joint], command.stiffness[*joint]) = (motor.q, motor.kp / self.of.kp[*joint]);
        }
        self.body.act(&command);
    }

    fn state(&self) -> LowState {
        let sensors = self.body.sensors();
        let (_, pitch, roll) = self.body.pose().matrix3.to_euler(EulerRot::ZYX);
        let motor = |joint: &_| MotorState { q: sensors.angles[*joint], temperature: 40, ..MotorState::default() };
        let motors: Vec<_> = self.of.motors.iter().map(motor).collect();
        let (gyro, acc) = (sensors.inertial.gyro.to_array(), sensors.inertial.acceleration.to_array());
        let imu_state = ImuState { rpy: [roll, pitch, 0.0], gyro, acc };
        LowState { imu_state, motor_state_parallel: motors.clone(), motor_state_serial: motors }
    }
}
