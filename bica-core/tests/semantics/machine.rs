//! State machines.

use super::*;

#[derive(Default)]
pub(crate) struct Ball {
    pub(crate) near: bool,
    pub(crate) lost: bool,
    pub(crate) touched: u32,
}

#[component(crate = bica_core)]
impl Ball {
    const fn new() -> Self {
        Self { near: false, lost: false, touched: 0 }
    }

    fn step(&mut self) {}
}

pub(crate) struct Search;

#[component(crate = bica_core)]
impl Search {
    const fn new() -> Self {
        Self
    }
}

/// Records the calls of its functions.
pub(crate) struct Player {
    pub(crate) calls: Vec<&'static str>,
}

#[component(crate = bica_core)]
impl Player {
    const fn new() -> Self {
        Self { calls: Vec::new() }
    }

    #[state(initial)]
    fn look(&mut self, search: &mut Search) {
        self.calls.push("look");
    }

    #[state]
    fn walk(&mut self, ball: &mut Ball) {
        self.calls.push("walk");
        ball.touched += 1;
    }

    #[state]
    fn wait(&mut self) {
        self.calls.push("wait");
    }

    #[transition(look | wait -> walk)]
    fn near(&self, ball: &Ball) -> bool {
        ball.near
    }

    #[transition(walk -> look, after_ms = 100)]
    fn lost(&self, ball: &Ball) -> bool {
        ball.lost
    }

    #[transition(walk -> wait, after_ms = 300)]
    fn tired(&self) -> bool {
        true
    }

    #[transition(* -> wait)]
    fn never(&self, time: &Time) -> bool {
        time.in_state > Duration::from_secs(3600)
    }

    #[entry(look | walk)]
    fn enter(&mut self) {
        self.calls.push("enter");
    }

    #[exit(look)]
    fn leave(&mut self, search: &mut Search) {
        self.calls.push("leave look");
    }
}

activation_tree! {
    pub(crate) struct Team {
        root: Coach,
        cycle_hz: 100,
        components: [Coach, Player, Resumer, Ball, Search],
        crate: bica_core,
    }
}

/// Activates both machines; tests hold the other one latent.
pub(crate) struct Coach;

#[component(crate = bica_core)]
impl Coach {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, player: &mut Player, resumer: &mut Resumer) {}
}

/// Two states in sequence, without a transition back.
pub(crate) struct Resumer;

#[component(resume, crate = bica_core)]
impl Resumer {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn first(&mut self) {}

    #[state(last)]
    fn second(&mut self) {}

    #[transition(first -> second, after_ms = 50)]
    fn done(&self) -> bool {
        true
    }
}

fn player(tree: &mut Team, ms: u64) -> Vec<&'static str> {
    tree.tick(at(ms));
    std::mem::take(&mut tree.get_mut::<Player>().calls)
}

fn state<T: Tree>(tree: &T, name: &str) -> Option<&'static str> {
    tree.state_name_at(name)
}

#[test]
fn a_transition_loses_no_cycle() {
    let mut tree = Team::new();
    tree.tick(at(0));
    tree.get_mut::<Player>().calls.clear();
    tree.get_mut::<Ball>().near = true;
    assert_eq!(player(&mut tree, 10), ["leave look", "enter", "walk"]);
    assert_eq!(state(&tree, "Player"), Some("walk"));
}

#[test]
fn a_first_run_enters_before_it_leaves() {
    let mut tree = Team::new();
    tree.get_mut::<Ball>().near = true;
    assert_eq!(player(&mut tree, 0), ["enter", "leave look", "enter", "walk"]);
}

#[test]
fn a_modulated_child_runs_after_though_read() {
    let mut tree = Team::new();
    tree.hold::<Resumer>(Hold::Latent);
    tree.get_mut::<Ball>().near = true;
    tree.tick(at(0));
    assert_eq!(runs(&mut tree, 10), ["Coach", "Player", "Ball"]);
    tree.get_mut::<Ball>().near = false;
    tree.tick(at(400));
    assert_eq!(state(&tree, "Player"), Some("wait"));
    assert_eq!(runs(&mut tree, 410), ["Coach", "Ball", "Player"]);
}

#[test]
fn a_transition_needs_timer_and_condition() {
    let mut tree = Team::new();
    tree.get_mut::<Ball>().near = true;
    tree.tick(at(0));
    tree.get_mut::<Ball>().near = false;
    for (ms, lost, expected) in [(50, true, "walk"), (99, true, "walk"), (100, false, "walk"), (110, true, "look")] {
        tree.get_mut::<Ball>().lost = lost;
        tree.tick(at(ms));
        assert_eq!(state(&tree, "Player"), Some(expected), "at {ms} ms");
    }
}

#[test]
fn a_timer_tolerates_a_clock_that_is_set_back() {
    let mut tree = Team::new();
    tree.tick(at(1_000_000));
    tree.tick(at(1000));
    assert_eq!(state(&tree, "Resumer"), Some("first"));
    tree.tick(at(1049));
    assert_eq!(state(&tree, "Resumer"), Some("first"));
    tree.tick(at(1050));
    assert_eq!(state(&tree, "Resumer"), Some("second"));
}

#[test]
fn a_transition_splits_a_run_in_two_sections() {
    struct Sections(Vec<&'static str>);
    impl Probe for Sections {
        fn begin(&mut self, component: bica_core::ComponentId) {
            self.0.push(Team::GRAPH.nodes[component.index()].name);
        }

        fn end(&mut self, _: bica_core::ComponentId) {
            self.0.push("end");
        }
    }
    let mut tree = Team::new();
    tree.hold::<Resumer>(Hold::Latent);
    tree.get_mut::<Ball>().near = true;
    tree.tick(at(0));
    let mut stretches = Sections(Vec::new());
    tree.tick_with(at(400), &mut stretches);
    let expected = ["Coach", "end", "Player", "end", "Ball", "end", "Player", "end"];
    assert_eq!(stretches.0, expected);
}

#[test]
fn the_name_of_the_current_state_is_reported() {
    let mut tree = Team::new();
    assert_eq!(tree.state_name::<Player>(), None, "never active");
    tree.tick(at(0));
    assert_eq!(tree.state_name::<Player>(), Some("look"));
    tree.get_mut::<Ball>().near = true;
    tree.tick(at(10));
    assert_eq!(tree.state_name::<Player>(), Some("walk"));
    tree.hold::<Coach>(Hold::Latent);
    tree.tick(at(20));
    assert!(!tree.is_active::<Player>());
    assert_eq!(tree.state_name::<Player>(), Some("walk"), "the state in which it became latent");
    assert_eq!(tree.state_name::<Coach>(), None, "no states");
    assert_eq!(tree.state_name_at("Playr"), None);
}
