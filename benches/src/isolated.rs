//! One component of the forward, run without the others.

use bica::prelude::*;
use bica::runner::Robot;
use bica_player::Forward;
use bica_player::input::CameraInput;
use bica_sim::setup::Frame;

use crate::recording::Recording;

/// Forward in the middle of a game in which all components but one are held latent. The inputs of that component do not
/// change, and each tick is one run of it.
pub struct IsolatedComponent {
    robot: Box<Forward>,
    recording: Recording,
    needs_image: bool,
    now: Instant,
    period: Duration,
}

impl IsolatedComponent {
    /// Isolates the component with this identifier; images have this size.
    ///
    /// # Panics
    /// If the tree lists no such component.
    #[must_use]
    pub fn new(component: ComponentId, frame: Frame) -> Self {
        let (recording, mut robot) = Recording::of_game::<Forward>(frame, 55, 5);
        for other in (0..Forward::COUNT).map(ComponentId::new).filter(|other| *other != component) {
            robot.at_mut(other).expect("a component of the tree").hold(Hold::Latent);
        }
        robot.at_mut(component).expect("a component of the tree").hold(Hold::Active);
        let node = &Forward::GRAPH.nodes[component.index()];
        let hz = node.hz.unwrap_or(Forward::GRAPH.cycle_hz);
        let input = Forward::id::<CameraInput>().index();
        let mut alone = Self {
            robot,
            recording,
            needs_image: node.links.iter().any(|link| link.to == input),
            now: Instant::from_secs(10),
            period: Duration::from_micros((1e6 / f64::from(hz)).ceil() as u64),
        };
        // The first runs after a start differ from later ones.
        for _ in 0..3 {
            alone.load_image();
            alone.run();
        }
        alone
    }

    /// Whether the component reads images; it then needs a new one for every run.
    #[must_use]
    pub const fn needs_image(&self) -> bool {
        self.needs_image
    }

    /// Loads a new image.
    ///
    /// # Panics
    /// If the size of the image is not accepted.
    pub fn load_image(&mut self) {
        for sensors in self.recording.sensors().filter(|sensors| sensors.image.is_some()) {
            self.robot.sense(&sensors).expect("the image fits");
        }
        self.now += self.period;
    }

    /// Runs the component once.
    pub fn run(&mut self) {
        self.robot.tick(self.now);
        self.now += self.period;
    }
}
