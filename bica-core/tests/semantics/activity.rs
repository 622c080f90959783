//! What a tree reports about its components.

use super::*;

pub(crate) struct Parent;

#[component(hz = 1, crate = bica_core)]
impl Parent {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, _: &mut Child) {}
}

pub(crate) struct Child;

#[component(hz = 1, crate = bica_core)]
impl Child {
    const fn new() -> Self {
        Self
    }
}

pub(crate) struct Switch {
    pub(crate) on: bool,
}

#[component(crate = bica_core)]
impl Switch {
    const fn new() -> Self {
        Self { on: false }
    }

    #[state(initial)]
    fn off(&mut self) {}

    #[state]
    fn on(&mut self, parent: &mut Parent) {}

    #[transition(off -> on)]
    fn switched_on(&self) -> bool {
        self.on
    }

    #[transition(on -> off)]
    fn switched_off(&self) -> bool {
        !self.on
    }
}

activation_tree! {
    pub(crate) struct Lamp {
        root: Switch,
        cycle_hz: 100,
        components: [Child, Parent, Switch],
        crate: bica_core,
    }
}

#[test]
fn an_unlisted_component_is_never_active() {
    let mut tree = Lamp::new();
    let unlisted = "entry 0: no such component; there are: Child, Parent, Switch";
    assert_eq!(tree.at_mut(99).unwrap_err().to_string(), unlisted);
    assert_eq!(tree.at("Chidl").unwrap_err().to_string(), unlisted);
    tree.tick(at(0));
    assert_eq!((tree.state(99), tree.status(99), tree.status("Chidl")), (None, None, None));
}

#[test]
fn the_status_of_each_component_is_current() {
    let mut tree = Lamp::new();
    let [child, switch] = ["Child", "Switch"];
    let latent = Status { active: false, held: Hold::Tree, state: None, since: None, hz: Some(1.0) };
    assert_eq!(tree.status(child), Some(latent));
    tree.get_mut::<Switch>().on = true;
    tree.tick(at(70));
    tree.at_mut(child).unwrap().set_rate(Some(0.5));
    tree.at_mut(switch).unwrap().set_rate(Some(20.0));
    tree.at_mut(switch).unwrap().hold(Hold::Active);
    let since = Some(at(70));
    assert_eq!(tree.status(child), Some(Status { active: true, since, hz: Some(0.5), ..latent }));
    let expected = Status { active: true, held: Hold::Active, state: Some(1), since, hz: Some(20.0) };
    assert_eq!(tree.status(switch), Some(expected));
    tree.of_mut::<Child>().set_rate(Some(f32::INFINITY));
    assert_eq!(tree.rate::<Child>().hz(), Some(1.0));
}
