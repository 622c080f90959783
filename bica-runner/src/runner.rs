//! The sense-think-act loop.

use core::ops::DerefMut;

use bica_core::action::Actions;
use bica_core::refusal::Refusal;
use bica_core::{Instant, Tree};

use crate::clock::Clock;
use crate::jobs::Jobs;
use crate::observer::{Cycle, Observer};
use crate::request::{Request, Requests};
use crate::robot::Robot;
use crate::world::World;

/// Robot with the world that it controls, its source of requests and its observer.
///
/// `T` points to the tree: `Box<Tree>`, `&mut Tree`, `&'static mut Tree`. `W` is the [`World`], or `()` if sensor
/// values are received as messages.
#[derive(Debug)]
pub struct Runner<T, W = (), Q = (), O = (), J = ()> {
    robot: T,
    world: W,
    clock: Clock,
    requests: Q,
    observer: O,
    jobs: J,
}

impl<T, W> Runner<T, W> {
    /// Creates a runner without requests and observer; its tree runs jobs itself, in simulated time.
    pub const fn new(robot: T, world: W) -> Self {
        Self { robot, world, clock: Clock::new(), requests: (), observer: (), jobs: () }
    }
}

impl<T, W, Q, O, J> Runner<T, W, Q, O, J> {
    /// Sets the source of requests.
    pub fn with_requests<N: Requests>(self, requests: N) -> Runner<T, W, N, O, J> {
        let Self { robot, world, clock, observer, jobs, .. } = self;
        Runner { robot, world, clock, requests, observer, jobs }
    }

    /// Sets the observer.
    pub fn with_observer<N>(self, observer: N) -> Runner<T, W, Q, N, J> {
        let Self { robot, world, clock, requests, jobs, .. } = self;
        Runner { robot, world, clock, requests, observer, jobs }
    }

    /// Sets who runs the jobs of components.
    pub fn with_jobs<N>(self, jobs: N) -> Runner<T, W, Q, O, N> {
        let Self { robot, world, clock, requests, observer, .. } = self;
        Runner { robot, world, clock, requests, observer, jobs }
    }

    /// Returns the world.
    pub const fn world(&self) -> &W {
        &self.world
    }

    /// Returns the world for changes between two cycles.
    pub const fn world_mut(&mut self) -> &mut W {
        &mut self.world
    }

    /// Returns the observer.
    pub const fn observer(&self) -> &O {
        &self.observer
    }

    /// Returns the observer for reading and resetting.
    pub const fn observer_mut(&mut self) -> &mut O {
        &mut self.observer
    }

    /// Returns the source of requests.
    pub const fn requests_mut(&mut self) -> &mut Q {
        &mut self.requests
    }

    /// Returns the parts: robot, world, requests, observer.
    pub fn into_parts(self) -> (T, W, Q, O) {
        (self.robot, self.world, self.requests, self.observer)
    }
}

impl<T, W, Q, O, J> Runner<T, W, Q, O, J>
where
    T: DerefMut<Target: Robot>,
    O: Observer<T::Target>,
    J: Jobs<T::Target>,
{
    /// Returns the tree.
    pub fn robot(&self) -> &T::Target {
        &self.robot
    }

    /// Returns the tree for changes before the first cycle. Later changes are [requests](Self::request), which
    /// observers receive.
    pub fn robot_mut(&mut self) -> &mut T::Target {
        &mut self.robot
    }

    /// Returns who runs the jobs, and the tree that they are of.
    pub fn jobs_mut(&mut self) -> (&mut J, &T::Target) {
        (&mut self.jobs, &self.robot)
    }

    /// Runs a part of a job between two cycles; returns whether there was one.
    pub fn idle(&mut self) -> bool {
        self.jobs.idle(&*self.robot)
    }

    /// Applies one request to the tree between two cycles.
    ///
    /// # Errors
    /// If the tree refuses the request, or if it is to the world; then nothing changes.
    #[inline]
    pub fn request(&mut self, now: Instant, request: Request<'_>) -> Result<(), Refusal> {
        self.request_in(now, None, request)
    }

    /// Applies one request as [`request`](Self::request) does, to the tree or to a world that this runner does not own.
    ///
    /// # Errors
    /// If the tree or the world refuses the request; then nothing changes.
    #[inline]
    pub fn request_in(
        &mut self,
        now: Instant,
        world: Option<&mut dyn Actions>,
        request: Request<'_>,
    ) -> Result<(), Refusal> {
        apply(&mut *self.robot, world, &mut self.observer, now, request)
    }

    /// Writes sensor values into the tree: the first half of a cycle, for values that are received as messages.
    ///
    /// # Errors
    /// If the robot rejects the values.
    #[inline]
    pub fn sense(
        &mut self,
        now: Instant,
        sensors: &<T::Target as Robot>::Sensors<'_>,
    ) -> Result<(), <T::Target as Robot>::Error> {
        sense(&mut *self.robot, &mut self.observer, now, sensors)
    }

    /// Ticks the tree and reads the command: the second half of a cycle.
    #[inline]
    pub fn think(&mut self, now: Instant) -> <T::Target as Robot>::Command {
        self.jobs.deliver(now, &*self.robot);
        self.robot.tick_with(now, &mut self.observer);
        self.jobs.collect(&*self.robot);
        let command = self.robot.act();
        self.observer.acted(&Cycle { now, robot: &*self.robot, command: &command });
        command
    }
}

impl<T, W, Q, O, J> Runner<T, W, Q, O, J>
where
    T: DerefMut<Target: Robot>,
    W: World<T::Target>,
    Q: Requests,
    O: Observer<T::Target>,
    J: Jobs<T::Target>,
{
    /// Returns the time of the cycles: that of the world's clock, as long as that makes no step.
    pub fn now(&self) -> Instant {
        self.clock.at(self.world.now())
    }

    /// Runs one cycle: requests, sense, think, act. Returns the command that was passed to the world.
    ///
    /// # Errors
    /// If the robot rejects the sensor values. Then the tree is not ticked and the world does not advance.
    #[inline]
    pub fn cycle(&mut self) -> Result<<T::Target as Robot>::Command, <T::Target as Robot>::Error> {
        let world = self.world.now();
        let stepped = self.clock.begin(world, <T::Target as Tree>::GRAPH.cycle_hz);
        let now = self.clock.at(world);
        if let Some(step) = stepped {
            self.observer.clock_stepped(now, &step);
        }
        self.take_requests(now);
        sense(&mut *self.robot, &mut self.observer, now, &self.world.sensors())?;
        let command = self.think(now);
        self.world.act(&command);
        Ok(command)
    }

    /// Applies the waiting requests without a cycle, for a loop that is paused. They are in force in the next cycle, as if they
    /// had come just before it.
    pub fn apply_requests(&mut self) {
        let now = self.now();
        self.take_requests(now);
        self.observer.requests_applied(now, &*self.robot);
    }

    #[inline]
    fn take_requests(&mut self, now: Instant) {
        while let Some(request) = self.requests.next(now) {
            let world = if let Request::World { .. } = request { self.world.actions() } else { None };
            let result = apply(&mut *self.robot, world, &mut self.observer, now, request);
            self.requests.answered(now, result);
        }
    }
}

#[inline]
fn apply<R: Robot, O: Observer<R>>(
    robot: &mut R,
    world: Option<&mut dyn Actions>,
    observer: &mut O,
    now: Instant,
    request: Request<'_>,
) -> Result<(), Refusal> {
    let result = request.apply_in(robot, world);
    match &result {
        Ok(()) => observer.requested(now, &request),
        Err(refusal) => observer.refused(now, &request, refusal),
    }
    result
}

#[inline]
fn sense<R: Robot, O: Observer<R>>(
    robot: &mut R,
    observer: &mut O,
    now: Instant,
    sensors: &R::Sensors<'_>,
) -> Result<(), R::Error> {
    observer.sensing(now, sensors);
    let taken = robot.sense(sensors);
    observer.sensed();
    taken
}
