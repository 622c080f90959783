//! Active and latent components, and their hooks.

use super::*;

/// Counts the calls of its hooks, which a probe does not report.
macro_rules! hooked {
    ($name:ident, $rate:literal, $($step:item)?) => {
        #[derive(Default)]
        pub(crate) struct $name {
            pub(crate) started: u32,
            pub(crate) stopped: u32,
            pub(crate) ran: u32,
        }

        #[component(hz = $rate, crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self { started: 0, stopped: 0, ran: 0 }
            }

            $($step)?

            #[start]
            fn on_start(&mut self) {
                self.started += 1;
            }

            #[stop]
            fn on_stop(&mut self) {
                self.stopped += 1;
            }
        }
    };
}

hooked!(
    Parent,
    1,
    fn step(&mut self, _: &mut Child) {
        self.ran += 1;
    }
);
hooked!(
    Child,
    1,
    fn step(&mut self) {
        self.ran += 1;
    }
);

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
fn an_activated_component_starts_and_runs_at_once() {
    let mut tree = Lamp::new();
    assert_eq!(cycle(&mut tree, 0), ["start Switch", "run Switch"]);
    assert_eq!(tree.active().collect::<Vec<_>>(), [Lamp::id::<Switch>()]);
    tree.get_mut::<Switch>().on = true;
    let expected = ["run Switch", "Switch: off -> on", "start Parent", "run Parent", "start Child", "run Child"];
    assert_eq!(cycle(&mut tree, 10), expected);
    assert_eq!(tree.active().map(bica_core::ComponentId::index).collect::<Vec<_>>(), [0, 1, 2]);
}

#[test]
fn activators_stop_first() {
    let mut tree = Lamp::new();
    tree.get_mut::<Switch>().on = true;
    tree.tick(at(0));
    tree.get_mut::<Switch>().on = false;
    assert_eq!(cycle(&mut tree, 10), ["run Switch", "Switch: on -> off", "stop Parent", "stop Child"]);
    assert_eq!(cycle(&mut tree, 20), ["run Switch"]);
    assert!(!tree.is_active::<Child>());
}

#[test]
fn an_unlisted_component_is_never_active() {
    let mut tree = Lamp::new();
    let unlisted = "entry 0: no such component; there are: Child, Parent, Switch";
    assert_eq!(tree.hold_at(99, Hold::Active).unwrap_err().to_string(), unlisted);
    assert_eq!(tree.set_rate_at("Chidl", Some(1.0)).unwrap_err().to_string(), unlisted);
    tree.tick(at(0));
    assert!(!tree.is_active_at(99) && !tree.is_active_at("Chidl"));
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
    tree.set_rate_at(child, Some(0.5)).unwrap();
    tree.set_rate_at(switch, Some(20.0)).unwrap();
    tree.hold_at(switch, Hold::Active).unwrap();
    let since = Some(at(70));
    assert_eq!(tree.status(child), Some(Status { active: true, since, hz: Some(0.5), ..latent }));
    let expected = Status { active: true, held: Hold::Active, state: Some(1), since, hz: Some(20.0) };
    assert_eq!(tree.status(switch), Some(expected));
    tree.set_rate_at(Lamp::id::<Child>(), Some(f32::INFINITY)).unwrap();
    assert_eq!(tree.rate::<Child>().hz(), Some(1.0));
}
