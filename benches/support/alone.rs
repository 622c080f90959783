//! One component of the forward, run without the others.

use bica::prelude::*;
use bica::runner::Robot;
use bica_player::Forward;
use bica_player::input::CameraInput;
use bica_sim::setup::Frame;

use crate::recording::Recording;

/// A forward in the middle of a game, all held latent but one component: what that one reads stays as it was, and each
/// tick is one run of it.
pub(crate) struct Alone {
    robot: Box<Forward>,
    /// In which it looks at the image of its newest moment.
    recording: Recording,
    sees: bool,
    now: Instant,
    period: Duration,
}

impl Alone {
    /// The component at this place in the tree's list.
    pub(crate) fn new(component: ComponentId, frame: Frame) -> Self {
        let (recording, mut robot) = Recording::of_game(frame, 55, 5);
        for other in (0..Forward::COUNT).map(ComponentId::new).filter(|other| *other != component) {
            robot.hold_at(other, Hold::Latent);
        }
        robot.hold_at(component, Hold::Active);
        let node = &Forward::GRAPH.nodes[component.index()];
        let hz = node.hz.unwrap_or(Forward::GRAPH.cycle_hz);
        let eye = Forward::id::<CameraInput>().index();
        let mut alone = Self {
            robot,
            recording,
            sees: node.links.iter().any(|link| link.to == eye),
            now: Instant::from_secs(10),
            period: Duration::from_micros((1e6 / f64::from(hz)).ceil() as u64),
        };
        // What became active only now settles.
        for _ in 0..3 {
            alone.look();
            alone.run();
        }
        alone
    }

    /// Whether it looks at images, and wants a new one for every run.
    pub(crate) fn sees(&self) -> bool {
        self.sees
    }

    /// A new image comes.
    pub(crate) fn look(&mut self) {
        for sensors in self.recording.sensors().filter(|sensors| sensors.image.is_some()) {
            self.robot.sense(&sensors).expect("the eye is large enough");
        }
        self.now += self.period;
    }

    /// One run.
    pub(crate) fn run(&mut self) {
        self.robot.tick(self.now);
        self.now += self.period;
    }
}
