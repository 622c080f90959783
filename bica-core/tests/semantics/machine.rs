//! State machines.

use super::*;

#[derive(Default)]
pub(crate) struct Ball {
    pub(crate) near: bool,
    pub(crate) lost: bool,
}

#[component(crate = bica_core)]
impl Ball {
    const fn new() -> Self {
        Self { near: false, lost: false }
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

pub(crate) struct Player;

#[component(crate = bica_core)]
impl Player {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn look(&mut self, search: &mut Search) {}

    #[state]
    fn walk(&mut self, ball: &mut Ball) {}

    #[state]
    fn wait(&mut self) {}

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
    fn enter(&mut self) {}

    #[exit(look)]
    fn leave(&mut self, search: &mut Search) {}
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

#[test]
fn the_name_of_the_current_state_is_reported() {
    let mut tree = Team::new();
    assert_eq!(tree.of::<Player>().state_name(), None, "never active");
    tree.tick(at(0));
    assert_eq!(tree.of::<Player>().state_name(), Some("look"));
    tree.get_mut::<Ball>().near = true;
    tree.tick(at(10));
    assert_eq!(tree.of::<Player>().state_name(), Some("walk"));
    tree.of_mut::<Coach>().hold(Hold::Latent);
    tree.tick(at(20));
    assert!(!tree.of::<Player>().is_active());
    assert_eq!(tree.of::<Player>().state_name(), Some("walk"), "the state in which it became latent");
    assert_eq!(tree.of::<Coach>().state_name(), None, "no states");
}
