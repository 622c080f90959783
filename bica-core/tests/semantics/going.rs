//! Machines that go to a state by request.

use bica_core::Found;

use super::*;

pub(crate) struct Boss {
    is_tired: bool,
}

#[component(crate = bica_core)]
impl Boss {
    const fn new() -> Self {
        Self { is_tired: false }
    }

    #[state(initial)]
    fn work(&mut self, arm: &mut Arm) {}

    #[state]
    fn pause(&mut self) {}

    #[transition(work -> pause)]
    fn tired(&self) -> bool {
        self.is_tired
    }

    #[transition(pause -> work)]
    fn rested(&self) -> bool {
        !self.is_tired
    }
}

pub(crate) struct Arm {
    calls: Vec<&'static str>,
}

#[component(hz = 10, crate = bica_core)]
impl Arm {
    const fn new() -> Self {
        Self { calls: Vec::new() }
    }

    #[state(initial)]
    fn rest(&mut self) {
        self.calls.push("rest");
    }

    #[state]
    fn reach(&mut self, hand: &Hand) {
        self.calls.push("reach");
    }

    #[state(last)]
    fn grip(&mut self) {
        self.calls.push("grip");
    }

    #[exit(rest)]
    fn rise(&mut self) {
        self.calls.push("rise");
    }

    #[entry(reach)]
    fn aim(&mut self) {
        self.calls.push("aim");
    }

    #[entry(grip)]
    fn close(&mut self, place: Found<u8>) {
        self.calls.push("close");
    }

    #[transition(rest -> reach)]
    fn asked(&self) -> bool {
        false
    }

    #[transition(reach -> grip)]
    fn seen(&self) -> Option<u8> {
        Some(1)
    }
}

pub(crate) struct Hand;

#[component(crate = bica_core)]
impl Hand {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    pub(crate) struct Robot { root: Boss, cycle_hz: 50, components: [Boss, Arm, Hand], crate: bica_core }
}

fn tick(robot: &mut Robot, ms: u64) {
    robot.tick(Instant::from_millis(ms));
}

#[test]
fn a_machine_goes_with_hooks_in_the_next_cycle() {
    let mut robot = Robot::new();
    tick(&mut robot, 0);
    robot.of_mut::<Arm>().go("reach").unwrap();
    assert_eq!(robot.of::<Arm>().state_name(), Some("rest"), "not before the cycle");
    // The arm is not due in this cycle.
    tick(&mut robot, 20);
    assert_eq!(robot.get::<Arm>().calls, ["rest", "rise", "aim", "reach"]);
    let status = robot.status("Arm").unwrap();
    assert_eq!((status.state, status.since), (Some(1), Some(Instant::from_millis(20))));
    assert!(robot.of::<Hand>().is_active());
    // Its transitions are tried from its next run on.
    tick(&mut robot, 40);
    assert_eq!(robot.get::<Arm>().calls.len(), 4);
    tick(&mut robot, 100);
    assert_eq!(robot.get::<Arm>().calls[4..], ["close", "grip"]);
}

#[test]
fn an_impossible_request_is_refused_with_the_reason() {
    let mut robot = Robot::new();
    let refused = |robot: &mut Robot, component: &str, state: &str, words: &str| {
        let text = robot.at_mut(component).unwrap().go(state).expect_err(state).to_string();
        assert!(text.contains(words), "{text}");
    };
    refused(&mut robot, "Arm", "reach", "`Arm.reach`: the machine is latent");
    tick(&mut robot, 0);
    refused(&mut robot, "Arm", "reaches", "no such state; there are: rest, reach, grip");
    refused(&mut robot, "Hand", "rest", "`Hand`: no such state");
    refused(&mut robot, "Arm", "grip", "only a transition can enter it");
    robot.of_mut::<Arm>().go("reach").unwrap();
    refused(&mut robot, "Boss", "pause", "another machine goes to a state in this cycle");
    robot.of_mut::<Arm>().go("rest").unwrap();
    robot.of_mut::<Arm>().hold(Hold::Latent);
    refused(&mut robot, "Arm", "reach", "is latent");
    tick(&mut robot, 20);
    assert_eq!(robot.get::<Arm>().calls, ["rest"], "the hold came after the request");
}

#[test]
fn a_machine_that_becomes_latent_goes_nowhere() {
    let mut robot = Robot::new();
    tick(&mut robot, 0);
    robot.of_mut::<Arm>().go("reach").unwrap();
    robot.get_mut::<Boss>().is_tired = true;
    tick(&mut robot, 20);
    robot.get_mut::<Boss>().is_tired = false;
    tick(&mut robot, 40);
    assert_eq!(robot.get::<Arm>().calls, ["rest", "rest"]);
    robot.of_mut::<Boss>().go("pause").unwrap();
    tick(&mut robot, 60);
    assert_eq!(robot.of::<Boss>().state_name(), Some("pause"), "no request waits");
    assert!(!robot.of::<Arm>().is_active());
}
