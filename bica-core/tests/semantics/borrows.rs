//! Borrowing several components at once.

use super::*;

#[derive(Clone, Copy)]
pub(crate) struct Cell<const N: usize>(u32);

#[component(hz = 50, crate = bica_core)]
impl<const N: usize> Cell<N> {
    const fn new() -> Self {
        Self(N as u32)
    }

    fn step(&mut self) {
        self.0 += 1;
    }
}

pub(crate) struct Sum<const N: usize> {
    pub(crate) all: Vec<u32>,
}

#[component(crate = bica_core)]
impl<const N: usize> Sum<N> {
    const fn new() -> Self {
        Self { all: Vec::new() }
    }

    fn step(
        &mut self,
        a: &Cell<0>,
        own: &Cell<N>,
        c: &mut Cell<2>,
        time: &Time,
        rate: &mut Rate<Cell<0>>,
        d: &mut Cell<3>,
    ) {
        self.all = vec![a.0, own.0, c.0, d.0];
        c.0 = 100 * d.0;
        d.0 = a.0 + own.0;
        rate.set(if time.dt() > 0.0 { 25.0 } else { 50.0 });
    }
}

activation_tree! {
    pub(crate) struct Cells {
        root: Sum<1>,
        cycle_hz: 100,
        components: [Sum<1>, Cell<0>, Cell<1>, Cell<2> = Cell(20), Cell<3>],
        crate: bica_core,
    }
}

#[test]
fn each_argument_borrows_its_own_component() {
    let mut tree = Cells::new();
    tree.tick(at(0));
    assert_eq!(tree.get::<Sum<1>>().all, [1, 2, 20, 3]);
    assert_eq!((tree.get::<Cell<2>>().0, tree.get::<Cell<3>>().0), (301, 4));
    assert_eq!(tree.rate::<Cell<0>>().hz(), Some(50.0));
    tree.tick(at(10));
    assert_eq!(tree.rate::<Cell<0>>().hz(), Some(25.0));
}

#[test]
fn a_tree_can_be_moved_and_cloned() {
    let mut tree = Box::new(Cells::new());
    tree.tick(at(0));
    let mut moved = *tree;
    moved.tick(at(20));
    assert_eq!(moved.get::<Cell<0>>().0, 2);
    std::thread::spawn(move || moved.get::<Cell<0>>().0).join().unwrap();
    assert_eq!(Cells::default().get::<Cell<0>>().0, 0);
}

#[test]
fn a_panic_in_a_probe_leaves_a_tree_that_can_be_used() {
    struct Stop;
    impl Probe for Stop {
        fn end(&mut self, _: bica_core::ComponentId) {
            panic!("as intended");
        }
    }
    let mut tree = Cells::new();
    let ticked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| tree.tick_with(at(0), &mut Stop)));
    assert!(ticked.is_err());
    tree.tick(at(10));
    assert!(tree.of::<Cell<3>>().is_active());
}
