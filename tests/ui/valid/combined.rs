//! Roles, ages, work and writers in unusual combinations.

use bica::prelude::*;

/// Methods of roles with every receiver, a default body, and lifetimes.
#[role]
pub(crate) trait Senses {
    fn range(self: &Self) -> Option<&f32>;
    fn is_blocked(&self) -> bool {
        self.range().is_some_and(|range| *range < 0.5)
    }
}

#[role]
pub(crate) trait Drive {
    fn go(&mut self, speed: f32);
}

pub(crate) struct Sonar<const COUNT: usize> {
    range: [f32; COUNT],
}

#[component(hz = 25)]
impl<const COUNT: usize> Sonar<COUNT> {
    fn step(&mut self) {}
}

impl<const COUNT: usize> Senses for Sonar<COUNT> {
    fn range(&self) -> Option<&f32> {
        self.range.first()
    }
}

/// Its last writer counts, and it is a generic machine that works.
pub(crate) struct Wheels<const STEPS: u32> {
    speed: f32,
    planned: Option<u32>,
}

#[component(writers = last)]
impl<const STEPS: u32> Wheels<STEPS> {
    const fn new() -> Self {
        Self { speed: 0.0, planned: None }
    }

    /// In slices, with a pattern, of a generic component.
    #[work(slices, takes_ms = 20)]
    fn plan(&mut (ref mut left, sum): &mut (u32, u32)) -> Option<u32> {
        *left = left.checked_sub(1)?;
        (*left == 0).then_some(sum)
    }

    #[state(initial)]
    fn stands(&mut self, jobs: &mut bica::Work<Self>) {
        self.planned = self.planned.or(jobs.result());
    }

    #[state]
    fn rolls(&mut self, r#work: &mut Work<Self>, time: &Time) {
        self.planned = self.planned.or(work.result());
    }

    #[transition(stands -> rolls)]
    fn starts(&self) -> bool {
        self.speed > 0.0
    }

    #[transition(rolls -> stands)]
    fn ends(&self) -> bool {
        self.speed <= 0.0
    }

    #[entry(rolls)]
    fn begin(&mut self, work: &mut Work<Self>) {
        work.begin((STEPS, 7));
    }
}

impl<const STEPS: u32> Drive for Wheels<STEPS> {
    fn go(&mut self, speed: f32) {
        self.speed = speed;
    }
}

pub(crate) struct Avoid([Option<u64>; 2]);

#[component]
impl Avoid {
    /// Ages of a role and of a component that it does not link, in any order with other arguments.
    fn step(
        &mut self,
        senses: &impl Senses,
        drive: &mut impl Drive,
        fresh: &Age<impl Senses>,
        time: &Time,
        wheels: &Age<Wheels<3>>,
    ) {
        self.0 = [Some(time.since_run), wheels.since_run()].map(|age| age.map(|age| age.as_millis()));
        drive.go(if senses.is_blocked() || !fresh.is_within(Duration::from_secs(1)) { 0.0 } else { 0.2 });
    }
}

pub(crate) struct Follow;

#[component]
impl Follow {
    /// It writes what its child writes, too.
    #[state(initial)]
    fn follow(&mut self, avoid: &mut Avoid, drive: &mut impl Drive) {
        drive.go(0.1);
    }

    #[state(last)]
    fn rest(&mut self, drive: &mut impl Drive) {
        drive.go(0.0);
    }

    #[transition(follow -> rest)]
    fn blocked(&self, sonar: &Sonar<2>, age: &Age<Sonar<2>>) -> bool {
        sonar.range[1] < 0.5 && age.since_run().is_some()
    }
}

activation_tree! {
    struct Robot {
        root: Follow,
        cycle_hz: 100,
        roles: { Drive: Wheels<3>, Senses: Sonar<2>, },
        components: [
            Wheels<3>,
            Avoid = Avoid([None; 2]),
            Follow = Follow,
            front = Sonar<2> = Sonar { range: [1.0; 2] },
        ],
    }
}

#[test]
fn roles_ages_and_work_meet_in_one_tree() {
    let mut robot = Robot::new();
    for cycle in 0..6 {
        robot.tick(Instant::from_millis(10 * cycle));
    }
    let wheels = robot.of::<Wheels<3>>();
    assert_eq!((wheels.state_name(), robot.get::<Wheels<3>>().planned), (Some("rolls"), Some(7)));
    assert_eq!(robot.get::<Wheels<3>>().speed, 0.2, "`Avoid` writes after its activator");
    assert_eq!(robot.get::<Avoid>().0, [Some(10), Some(10)]);
    robot.get_mut::<Sonar<2>>().range[1] = 0.0;
    robot.tick(Instant::from_millis(60));
    assert_eq!((robot.of::<Follow>().state_name(), robot.get::<Wheels<3>>().speed), (Some("rest"), 0.0));
}
