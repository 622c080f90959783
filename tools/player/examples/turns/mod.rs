//! Two forwards that alternate on the same sensor values, in real time: measures the cost of an observer for the loop.

use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::runner::{Observer, Requests, Runner};
use bica::{Instant, Tree};
use bica_evaluation::statistics::percentile;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{CameraId, Image, Sensors};
use bica_player::input::RobotProfile;
use bica_player::tunable::Forward;
use bica_player_program::game::WorldKind;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

pub(crate) const WIDTH: usize = 640;
pub(crate) const HEIGHT: usize = 480;
/// Number of images that are repeated.
const IMAGES: usize = 30;

/// Sensor values of a world, with images of 640×480 at 30/s.
pub(crate) struct Values {
    world: KinematicWorld,
    images: Vec<Arc<Vec<u8>>>,
    newest: Arc<Mutex<Arc<Vec<u8>>>>,
}

impl Values {
    /// Creates the values of the built-in world; `images` replaces its images.
    pub(crate) fn new(images: Option<Vec<Arc<Vec<u8>>>>) -> Self {
        let setup = Setup { frame: Frame::Large, ..Setup::default() };
        let mut world = KinematicWorld::new(NAO, &setup).expect("valid");
        let images = images.unwrap_or_else(|| rendered(&mut world));
        let newest = Arc::new(Mutex::new(Arc::clone(&images[0])));
        Self { world, images, newest }
    }

    /// Returns a function that returns the shared owner of an image's pixels.
    pub(crate) fn owner(&self) -> impl Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send + 'static {
        let newest = Arc::clone(&self.newest);
        move |_| Some(Arc::clone(&newest.lock().expect("no panic")))
    }

    /// Runs both forwards for a range of cycles. Returns the sorted cycle times without and with the observer, ms, by `clock`.
    pub(crate) fn take_turns<O: Observer<Forward>>(
        &mut self,
        (requests, with): (&mut impl Requests, &mut Runner<Box<Forward>, (), (), O>),
        without: &mut Runner<Box<Forward>, ()>,
        cycles: std::ops::Range<u64>,
        clock: impl Fn() -> Duration,
    ) -> [Vec<f64>; 2] {
        let (mut times, began) = ([Vec::new(), Vec::new()], Clock::now());
        for cycle in cycles.clone() {
            thread::sleep(Duration::from_millis(10 * (cycle - cycles.start)).saturating_sub(began.elapsed()));
            let has_image = cycle == 0 || cycle * 3 / 10 != (cycle - 1) * 3 / 10;
            let yuyv = &self.images[(cycle * 3 / 10) as usize % self.images.len()];
            self.newest.lock().expect("no panic").clone_from(yuyv);
            let image = Image { camera: CameraId::Top, width: WIDTH as u16, height: HEIGHT as u16, yuyv };
            let sensors = Sensors { image: has_image.then_some(image), ..self.world.sensors() };
            let now = Instant::from_millis(10 * cycle);
            // The second forward finds the image in the cache, so the order alternates.
            for index in [cycle % 2, 1 - cycle % 2] {
                let start = clock();
                if index == 0 {
                    without.sense(now, &sensors).expect("the image fits");
                    without.think(now);
                } else {
                    while requests.next(now).is_some() {}
                    with.sense(now, &sensors).expect("the image fits");
                    with.think(now);
                }
                times[index as usize].push(clock().saturating_sub(start).as_secs_f64() * 1e3);
            }
        }
        times.each_mut().into_iter().for_each(|times| times.sort_by(f64::total_cmp));
        times
    }
}

fn rendered(world: &mut KinematicWorld) -> Vec<Arc<Vec<u8>>> {
    let mut images = Vec::new();
    let mut robot = forward();
    while images.len() < IMAGES {
        images.extend(world.sensors().image.map(|image| Arc::new(image.yuyv.to_vec())));
        let now = Instant::from_micros(World::now(world).as_micros() as u64);
        bica::runner::Robot::sense(&mut *robot, &world.sensors()).expect("the image fits");
        robot.tick(now);
        let command = bica::runner::Robot::act(&mut *robot);
        world.act(&command);
    }
    images
}

/// Returns a forward for the built-in world.
pub(crate) fn forward() -> Box<Forward> {
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(WorldKind::BuiltIn.profile());
    robot
}

/// Returns median, 99th percentile and maximum of sorted times, as text.
pub(crate) fn shown(times: &[f64]) -> String {
    let [median, slow, max] = [0.5, 0.99, 1.0].map(|part| percentile(times, part).unwrap_or(0.0));
    format!("median {median:.3}, p99 {slow:.3}, max {max:.3} ms")
}
