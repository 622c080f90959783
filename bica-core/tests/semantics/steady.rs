//! A tree that may be steady does what the same tree does that never is: every sequence of a few requests, in trees with all
//! kinds of fixed components.

use bica_core::ComponentId;

use super::*;

/// Component with a number that depends on all that it reads and on its times.
macro_rules! part {
    ($name:ident [$($option:tt)*] reads($($read:ident: $Read:ty),*) writes($($write:ident: $Write:ty),*)) => {
        pub(crate) struct $name(pub(crate) u64);

        #[component($($option)* crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self(1)
            }

            fn step(&mut self, time: &Time $(, $read: &$Read)* $(, $write: &mut $Write)*) {
                let times = time.since_run.as_ticks() ^ time.in_state.as_ticks() << 20;
                self.0 = self.0.wrapping_mul(31).wrapping_add(times) $(.wrapping_mul(37).wrapping_add($read.0))*;
                $($write.0 ^= self.0;)*
            }
        }
    };
}

/// Machine that leaves a state after 20 ms.
macro_rules! machine {
    ($name:ident [$($option:tt)*] ($($first:ident: $First:ty),*) ($($second:ident: $Second:ty),*)) => {
        pub(crate) struct $name(pub(crate) u64);

        #[component($($option)* crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self(1)
            }

            #[state(initial)]
            fn first(&mut self $(, $first: &$First)*) {
                self.0 = self.0.wrapping_mul(41) $(.wrapping_add($first.0))*;
            }

            #[state]
            fn second(&mut self $(, $second: &mut $Second)*) {
                self.0 = self.0.wrapping_mul(43);
                $($second.0 ^= self.0;)*
            }

            #[transition(first -> second, after_ms = 20)]
            fn on(&self) -> bool {
                true
            }

            #[transition(second -> first, after_ms = 20)]
            fn back(&self) -> bool {
                true
            }
        }
    };
}

mod fixed {
    use super::*;

    part!(Root [hz = 50,] reads(left: Left, right: Right) writes(after: After));
    part!(Left [hz = 50,] reads(shared: Shared) writes());
    part!(Right [hz = 100,] reads(shared: Shared) writes());
    part!(After [] reads(shared: Shared) writes());
    part!(Shared [hz = 50,] reads() writes());

    activation_tree! {
        /// Every component is fixed.
        pub(super) struct Fixed {
            root: Root,
            cycle_hz: 100,
            components: [Shared, After, Root, Right, Left],
            crate: bica_core,
        }
    }
}

mod mixed {
    use super::*;

    part!(Root [hz = 50,] reads(leaf: Leaf, shared: Shared) writes(branch: Branch));
    machine!(Leaf [hz = 50,] () ());
    machine!(Branch [] (shared: Shared) (below: Below));
    part!(Below [hz = 50,] reads() writes());
    part!(Shared [hz = 50,] reads() writes());

    activation_tree! {
        /// The root and a machine without links are fixed, what another machine reaches is not.
        pub(super) struct Mixed {
            root: Root,
            cycle_hz: 100,
            components: [Root, Leaf, Branch, Below, Shared],
            crate: bica_core,
        }
    }
}

mod choosing {
    use super::*;

    machine!(Root [hz = 50,] (shared: Shared, left: Left) (branch: Branch, below: Below));
    part!(Left [] reads(shared: Shared) writes(below: Below));
    machine!(Branch [] (below: Below) (left: Left));
    part!(Below [hz = 50,] reads(shared: Shared) writes());
    part!(Shared [hz = 50,] reads() writes());

    activation_tree! {
        /// The root is a machine with children, one of them a machine that reaches what the root reaches too.
        pub(super) struct Choosing {
            root: Root,
            cycle_hz: 100,
            components: [Root, Left, Branch, Below, Shared],
            crate: bica_core,
        }
    }
}

mod rated {
    use super::*;

    pub(crate) struct Root(pub(crate) u64);

    #[component(crate = bica_core)]
    impl Root {
        const fn new() -> Self {
            Self(1)
        }

        fn step(&mut self, usual: &Usual, slowed: &mut Slowed, rate: &mut Rate<Slowed>) {
            self.0 = self.0.wrapping_mul(31).wrapping_add(usual.0);
            slowed.0 ^= self.0;
            rate.set(if self.0.is_multiple_of(3) { 20.0 } else { 50.0 });
        }
    }

    pub(crate) struct Slow(pub(crate) u64);

    #[component(hz = 50, crate = bica_core)]
    impl Slow {
        const fn new() -> Self {
            Self(1)
        }

        fn step(&mut self, rate: &mut Rate<Self>) {
            self.0 = self.0.wrapping_mul(31).wrapping_add(1);
            rate.set(if self.0.is_multiple_of(5) { 25.0 } else { 50.0 });
        }
    }

    part!(Usual [hz = 50,] reads() writes(slow: Slow));
    part!(Slowed [hz = 50,] reads(under: Under) writes());
    part!(Under [] reads() writes());

    activation_tree! {
        /// Two components have rates that a step sets.
        pub(super) struct Rated {
            root: Root,
            cycle_hz: 100,
            components: [Slow, Slowed, Under, Usual, Root],
            crate: bica_core,
        }
    }
}

/// Request between two cycles.
#[derive(Clone, Copy, Debug)]
enum Request {
    None,
    Hold(usize, Hold),
    Rate(usize, Option<f32>),
}

/// A request, and the time from the previous tick to the next, ms.
type Step = (Request, u64);

/// Cycles without a request before the first one and after the last one: the tree becomes steady.
const AROUND: usize = 3;

fn steps(components: usize) -> Vec<Step> {
    let holds = [Hold::Latent, Hold::Active, Hold::Tree];
    let of = |index| {
        let holds = holds.map(|hold| Request::Hold(index, hold));
        // The last one requests the declared rate.
        holds.into_iter().chain([Request::Rate(index, Some(25.0)), Request::Rate(index, None)])
    };
    let requests = || std::iter::once(Request::None).chain((0..components).flat_map(of));
    [10, 14].into_iter().flat_map(|ms| requests().map(move |request| (request, ms))).collect()
}

/// Events of one cycle: the kind, the component and two more numbers.
#[derive(Default, PartialEq, Debug)]
struct Recorder(Vec<(u8, usize, usize, usize)>);

impl Probe for Recorder {
    fn start(&mut self, component: ComponentId) {
        self.0.push((0, component.index(), 0, 0));
    }
    fn stop(&mut self, component: ComponentId) {
        self.0.push((1, component.index(), 0, 0));
    }
    fn skip(&mut self, component: ComponentId) {
        self.0.push((2, component.index(), 0, 0));
    }
    fn run(&mut self, component: ComponentId) {
        self.0.push((3, component.index(), 0, 0));
    }
    fn begin(&mut self, component: ComponentId) {
        self.0.push((4, component.index(), 0, 0));
    }
    fn end(&mut self, component: ComponentId) {
        self.0.push((5, component.index(), 0, 0));
    }
    fn condition(&mut self, component: ComponentId, transition: usize, holds: bool) {
        self.0.push((6, component.index(), transition, usize::from(holds)));
    }
    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        self.0.push((7, component.index(), from, to));
    }
}

fn request<T: Tree>(tree: &mut T, request: Request) {
    match request {
        Request::None => {}
        Request::Hold(index, hold) => tree.hold_at(index, hold).unwrap(),
        Request::Rate(index, hz) => tree.set_rate_at(index, hz).unwrap(),
    }
}

/// Whether the next tick is steady: a bit of what components share.
fn is_steady<T: Tree>(tree: &T) -> bool {
    tree.engine().relative_state().next().is_some_and(|shared| shared >> 9 & 1 == 1)
}

/// Compares a tree with one that is never steady; returns the numbers of cycles and of steady ones. `unsettle` writes a
/// rate without changing it.
fn compare<T: Tree>(sequence: &[Step], new: fn() -> T, unsettle: fn(&mut T), values: fn(&T) -> Vec<u64>) -> (u64, u64) {
    let (mut tree, mut plain) = (new(), new());
    let (mut seen, mut expected) = (Recorder::default(), Recorder::default());
    let (mut now, mut counts) = (1_000, (0, 0));
    for (cycle, &(wanted, ms)) in sequence.iter().enumerate() {
        now += ms;
        request(&mut tree, wanted);
        request(&mut plain, wanted);
        unsettle(&mut plain);
        assert!(!is_steady(&plain));
        counts = (counts.0 + 1, counts.1 + u64::from(is_steady(&tree)));
        seen.0.clear();
        expected.0.clear();
        tree.tick_with(Instant::from_millis(now), &mut seen);
        plain.tick_with(Instant::from_millis(now), &mut expected);
        assert_eq!(seen, expected, "cycle {cycle} of {sequence:?}");
        let status = |tree: &T| (0..T::COUNT).map(|index| tree.status(index)).collect::<Vec<_>>();
        assert_eq!(status(&tree), status(&plain), "cycle {cycle} of {sequence:?}");
        assert_eq!(values(&tree), values(&plain), "cycle {cycle} of {sequence:?}");
    }
    counts
}

/// Compares every sequence with a number of requests, and checks that many cycles are steady.
fn explore<T: Tree>(requests: u32, new: fn() -> T, unsettle: fn(&mut T), values: fn(&T) -> Vec<u64>) {
    let steps = steps(T::COUNT);
    let (mut sequences, mut cycles, mut steady) = (0, 0, 0);
    for mut code in 0..steps.len().pow(requests) {
        let mut sequence = vec![(Request::None, 10); AROUND + requests as usize + AROUND];
        for step in &mut sequence[AROUND..][..requests as usize] {
            *step = steps[code % steps.len()];
            code /= steps.len();
        }
        let counts = compare(&sequence, new, unsettle, values);
        (sequences, cycles, steady) = (sequences + 1, cycles + counts.0, steady + counts.1);
    }
    println!("{}: {sequences} sequences, {cycles} cycles compared, {steady} of them steady", T::GRAPH.name);
    assert!((cycles / 5..cycles).contains(&steady), "{steady} of {cycles} cycles are steady");
}

fn explore_all(requests: u32) {
    macro_rules! explore_each {
        ($($module:ident::$Tree:ident: $($component:ident),*;)*) => {$(
            let values = |tree: &$module::$Tree| vec![$(tree.get::<$module::$component>().0),*];
            explore(requests, $module::$Tree::new, |tree| _ = tree.rate_mut::<$module::Root>(), values);
        )*};
    }
    explore_each! {
        fixed::Fixed: Root, Left, Right, After, Shared;
        mixed::Mixed: Root, Leaf, Branch, Below, Shared;
        choosing::Choosing: Root, Left, Branch, Below, Shared;
        rated::Rated: Root, Slow, Slowed, Usual, Under;
    }
}

#[test]
#[cfg_attr(miri, ignore = "takes Miri more than ten minutes; other tests tick steady trees in it")]
fn steady_ticks_change_nothing_after_two_requests() {
    explore_all(2);
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_steady_ticks_change_nothing_after_three_requests() {
    explore_all(3);
}
