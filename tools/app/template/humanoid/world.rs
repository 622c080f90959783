//! A level floor.

use std::fmt;

use bica::prelude::*;
use bica::runner::World;
use bica::visual::{Pose2, Scene, SceneItem};
use bica_body::ideal::IdealBody;
use bica_motion::pose;
use bica_motion::robot::{Command, Sensors};
#[cfg(feature = "mujoco")]
use bica_motion::senses::SenseEstimator;

use crate::Biped;
use crate::model::MODEL;

/// The robot's body.
enum Body {
    /// It follows its targets exactly, and never falls.
    Ideal(IdealBody),
    /// Rigid bodies in MuJoCo, and the estimates of tilt and support, which the robot does not measure.
    #[cfg(feature = "mujoco")]
    Forces(Box<bica_body::mujoco::Humanoid>, SenseEstimator),
}

/// A floor with the robot.
pub(crate) struct Floor {
    cycle: u64,
    body: Body,
}

impl Floor {
    /// A floor without forces.
    pub(crate) fn ideal() -> Self {
        Self {
            cycle: 0,
            body: Body::Ideal(IdealBody::new(MODEL, MODEL.stand)),
        }
    }

    /// A floor in MuJoCo; the seed draws the noise of the sensors.
    #[cfg(feature = "mujoco")]
    pub(crate) fn with_forces(seed: u64) -> Result<Self, bica_app::Failure> {
        use bica_body::mujoco::{Humanoid, Model, Physics};
        use bica_body::random::Random;

        use crate::model::SIMULATED;

        let physics = Physics {
            cameras: false,
            ..Physics::of(SIMULATED)
        };
        let model = Model::on_floor(SIMULATED, &physics).map_err(|error| {
            bica_app::Failure::new(error.to_string(), "compare robot.xml with src/model.rs")
        })?;
        let noise = Random::new(seed, 0_u64);
        let humanoid = Humanoid::new(
            SIMULATED,
            model,
            pose::Pose2::ORIGIN,
            noise,
            &physics,
            |_| (),
        );
        Ok(Self {
            cycle: 0,
            body: Body::Forces(Box::new(humanoid), SenseEstimator::new(MODEL)),
        })
    }

    fn pose(&self) -> pose::Pose2 {
        match &self.body {
            Body::Ideal(body) => body.ground_pose(),
            #[cfg(feature = "mujoco")]
            Body::Forces(body, _) => body.ground_pose(),
        }
    }
}

impl World<Biped> for Floor {
    fn now(&self) -> Instant {
        Instant::from_millis(10 * self.cycle)
    }

    fn sensors(&mut self) -> Sensors<'static> {
        match &mut self.body {
            Body::Ideal(body) => body.sensors(),
            #[cfg(feature = "mujoco")]
            Body::Forces(body, estimator) => {
                let mut sensors = body.sensors();
                estimator.complete(&mut sensors, 0.01);
                sensors
            }
        }
    }

    fn act(&mut self, command: &Command) {
        match &mut self.body {
            Body::Ideal(body) => body.act(&command.targets),
            #[cfg(feature = "mujoco")]
            Body::Forces(body, _) => _ = body.act(command),
        }
        self.cycle += 1;
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        let at = self.pose().position;
        write!(out, "{:.2} m from its start", at.length())
    }

    fn figures(&self, figure: &mut dyn FnMut(&'static str, f64, &'static str)) {
        figure("distance", self.pose().position.length().into(), "m");
    }

    fn truth(&self, scene: &mut dyn Scene) {
        let pose::Pose2 { position, heading } = self.pose();
        scene.show(
            &SceneItem::new("robot", "floor"),
            &Pose2 {
                x: position.x,
                y: position.y,
                heading,
            },
        );
    }
}
