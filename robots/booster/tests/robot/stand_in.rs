//! A robot in memory: joints go where they are sent. It checks what the interface asks of each command and request.

use std::time::Duration;

use bica_booster::message::{FallDownState, LowCmd, LowState, MotorState, RpcReqMsg, RpcRespMsg, SERIAL};
use bica_booster::{Body, Driver, Gait, Inputs, Motion, Outputs};
use bica_motion::robot::{Command, Sensors};

/// Time between two steps of the driver.
const STEP: Duration = Duration::from_millis(1);

/// A request of a service: time in ms, number of the service, mode that it requests.
pub(crate) type Requested = (u64, u64, Option<i64>);

pub(crate) struct StandIn {
    pub(crate) driver: Driver,
    body: &'static Body,
    pub(crate) millis: u64,
    pub(crate) mode: i64,
    pub(crate) q: Vec<f32>,
    pub(crate) rpy: [f32; 3],
    /// What a body with dynamics measures, in place of joints that go where they are sent.
    pub(crate) measured: Option<LowState>,
    /// Sensor values of the newest cycle, until somebody takes them.
    pub(crate) sensed: Option<Sensors<'static>>,
    pub(crate) fall: u32,
    /// Whether states are sent; what spoils them; whether requests are answered, and with which status changes of the mode are.
    pub(crate) is_silent: bool,
    pub(crate) spoil: Option<fn(&mut LowState)>,
    pub(crate) is_deaf: bool,
    pub(crate) status: i64,
    /// Time that an answer takes, ms.
    pub(crate) delay: u64,
    /// Number of steps in which gains and velocities in another mode are not judged: the driver cannot know it yet.
    pub(crate) tolerated: u32,
    /// Time from the answer until the mode changes, ms.
    pub(crate) transition: u64,
    pub(crate) next_mode: Option<(u64, i64)>,
    pub(crate) stop: bool,
    pub(crate) program: fn(&Sensors<'_>, u64) -> Option<Command>,
    /// Time that the program takes in a cycle, ms.
    pub(crate) latency: fn(u64) -> u64,
    pub(crate) motion: Motion,
    pub(crate) requests: Vec<Requested>,
    pub(crate) bodies: Vec<String>,
    pub(crate) commands: Vec<(u64, LowCmd)>,
    pub(crate) cycles: u64,
    pub(crate) notes: Vec<String>,
    answers: Vec<(u64, RpcRespMsg)>,
    /// Answer of the program, and when it comes, ms.
    pub(crate) command: Option<(u64, Command)>,
}

/// Commands the stand.
pub(crate) fn stand(body: &Body) -> Command {
    Command::new(body.model.stand, 1.0)
}

impl StandIn {
    pub(crate) fn new(body: &'static Body, gait: Gait) -> Self {
        let q = body.motors.iter().map(|joint| body.model.stand[*joint] + 0.05).collect();
        Self {
            driver: Driver::new(body, gait, 42),
            body,
            millis: 0,
            mode: 0,
            q,
            rpy: [0.0; 3],
            measured: None,
            sensed: None,
            fall: 0,
            is_silent: false,
            spoil: None,
            is_deaf: false,
            status: 0,
            delay: 5,
            tolerated: 0,
            transition: 0,
            next_mode: None,
            stop: false,
            program: |_, _| Some(Command::new(bica_booster::T1.model.stand, 1.0)),
            latency: |_| 0,
            motion: Motion::default(),
            requests: Vec::new(),
            bodies: Vec::new(),
            commands: Vec::new(),
            cycles: 0,
            notes: Vec::new(),
            answers: Vec::new(),
            command: None,
        }
    }

    /// A robot that the program commands.
    pub(crate) fn following(body: &'static Body, gait: Gait) -> Self {
        let mut robot = Self::new(body, gait);
        robot.run(6000);
        assert!(robot.cycles > 0, "the program gets cycles: {:?}", robot.notes);
        robot
    }

    fn state(&self) -> LowState {
        if let Some(measured) = &self.measured {
            return measured.clone();
        }
        let motor = |q: &f32| MotorState { q: *q, temperature: 40, ..MotorState::default() };
        let motors: Vec<_> = self.q.iter().map(motor).collect();
        let mut state =
            LowState { motor_state_parallel: motors.clone(), motor_state_serial: motors, ..LowState::default() };
        state.imu_state.acc = [0.0, 0.0, 9.81];
        state.imu_state.rpy = self.rpy;
        if let Some(spoil) = self.spoil {
            spoil(&mut state);
        }
        state
    }

    pub(crate) fn run(&mut self, millis: u64) {
        (0..millis).for_each(|_| self.step());
    }

    /// Runs until the driver is over; returns the time that this takes, ms.
    pub(crate) fn run_to_the_end(&mut self) -> u64 {
        let start = self.millis;
        while !self.driver.is_over() {
            self.step();
            assert!(self.millis - start <= 6000, "it does not end: {:?}", self.notes);
        }
        self.millis - start
    }

    fn step(&mut self) {
        if let Some((_, mode)) = self.next_mode.take_if(|(at, _)| *at <= self.millis) {
            self.mode = mode;
        }
        let states = if self.is_silent || self.millis % 2 == 1 { vec![] } else { vec![self.state()] };
        let now = self.millis;
        let (due, later) = self.answers.drain(..).partition::<Vec<_>, _>(|(at, _)| *at <= now);
        self.answers = later;
        let answers: Vec<_> = due.into_iter().map(|(_, answer)| answer).collect();
        let fall = FallDownState { fall_down_state: self.fall, is_recovery_available: self.fall == 2 };
        let command = self.command.take_if(|(at, _)| *at <= now).map(|(_, command)| command);
        let inputs = Inputs {
            states: &states,
            fall: Some(fall),
            answers: &answers,
            command: command.as_ref().map(|command| (command, self.motion)),
            stop: self.stop,
        };
        let outputs = self.driver.step(STEP * now as u32, &inputs);
        self.take(outputs);
        self.millis += 1;
        self.tolerated = self.tolerated.saturating_sub(1);
    }

    fn take(&mut self, Outputs { command, requests, cycle, notes }: Outputs) {
        self.notes.extend(notes);
        if let Some(command) = command {
            self.check(&command);
            for (q, motor) in self.q.iter_mut().zip(&command.motor_cmd) {
                if motor.kp > 0.0 {
                    *q = motor.q;
                }
            }
            self.commands.push((self.millis, command));
        }
        if self.has_gains() {
            let last = self.commands.last().map_or(0, |(at, _)| *at);
            assert!(self.millis - last <= 200, "a pause while gains are on");
        }
        for request in &requests {
            self.answer(request);
        }
        if let Some(sensors) = cycle {
            self.cycles += 1;
            self.sensed = Some(sensors);
            let at = self.millis + 1 + (self.latency)(self.cycles);
            self.command = (self.program)(&sensors, self.cycles).map(|command| (at, command));
        }
    }

    /// Whether the last command has gains.
    pub(crate) fn has_gains(&self) -> bool {
        let has_gain = |(_, last): &(u64, LowCmd)| last.motor_cmd.iter().any(|motor| motor.kp > 0.0 || motor.kd > 0.0);
        self.commands.last().is_some_and(has_gain)
    }

    fn check(&self, command: &LowCmd) {
        assert_eq!((command.cmd_type, command.motor_cmd.len()), (SERIAL, self.body.motors.len()));
        let last = self.commands.last().map(|(at, last)| (self.millis - at, last));
        for (index, motor) in command.motor_cmd.iter().enumerate() {
            let range = self.body.range(self.body.motors[index]);
            let is_right = (0.0..=1.0).contains(&motor.weight)
                && (0.0..=1000.0).contains(&motor.kp)
                && (0.0..=50.0).contains(&motor.kd)
                && (motor.kp <= 0.0 || motor.kd > 0.0)
                && motor.tau.abs() <= self.body.torque[self.body.motors[index]]
                && (range.min - 0.02..=range.max + 0.02).contains(&motor.q);
            assert!(is_right, "motor {index}: {motor:?}");
            if motor.kp > 0.0 || motor.kd > 0.0 {
                assert!(self.mode == 3 || self.tolerated > 0, "gains in another mode at {} ms", self.millis);
                match last {
                    Some((millis, last)) if last.motor_cmd[index].kp > 0.0 => {
                        let speed = (motor.q - last.motor_cmd[index].q).abs() / (millis as f32 * 1e-3);
                        assert!(speed <= 20.0, "motor {index} moves at {speed} rad/s");
                    }
                    // The target of a limp joint follows the joint at a limited speed.
                    _ if motor.kp <= 0.0 => {}
                    _ => assert!((motor.q - self.q[index]).abs() <= 0.3, "motor {index} starts at {}", motor.q),
                }
            }
        }
    }

    fn answer(&mut self, request: &RpcReqMsg) {
        let header: serde_json::Value = serde_json::from_str(&request.header).expect("JSON");
        let body: serde_json::Value = serde_json::from_str(&request.body).unwrap_or_default();
        let service = header["api_id"].as_u64().expect("a service");
        let mode = body["mode"].as_i64();
        self.requests.push((self.millis, service, mode));
        if mode.is_some_and(|mode| mode != 3) {
            let gains = self.commands.iter().rfind(|(_, it)| it.motor_cmd.iter().any(|motor| motor.kd > 0.0));
            let since = gains.map_or(u64::MAX, |(at, _)| self.millis - at);
            assert!(since >= 30, "the mode would overtake the last gains");
        }
        self.bodies.push(request.body.clone());
        if self.is_deaf {
            return;
        }
        let (mut status, mut result) = (0, String::new());
        match (service, mode) {
            (2000, Some(mode)) if self.status == 0 && self.transition == 0 => self.mode = mode,
            (2000, Some(mode)) if self.status == 0 => self.next_mode = Some((self.millis + self.transition, mode)),
            (2000, _) => status = self.status,
            (2001, _) => assert!(matches!(self.mode, 2 | 4) || self.tolerated > 0, "a velocity in mode {}", self.mode),
            (2008, _) => self.fall = 3,
            (2017, _) => result = format!(r#"{{"mode":{}}}"#, self.mode),
            _ => {}
        }
        let header = format!(r#"{{"status":{status}}}"#);
        let answer = RpcRespMsg { uuid: request.uuid.clone(), header, body: result };
        self.answers.push((self.millis + self.delay, answer));
    }

    /// Times of the requests for a mode, ms.
    pub(crate) fn asked_for(&self, mode: i64) -> Vec<u64> {
        let is_it = |(_, service, of): &&Requested| (*service, *of) == (2000, Some(mode));
        self.requests.iter().filter(is_it).map(|(at, ..)| *at).collect()
    }
}
