//! Random scripts: inputs of a tree from outside.

use bica::prelude::*;
use proptest::prelude::*;
use proptest::sample::Index;

/// Change of the clock before a tick.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Clock {
    /// Advances by this number of ticks.
    Later(u64),
    /// Goes back by this number of ticks.
    Earlier(u64),
    /// Jumps to this tick.
    At(u64),
}

/// Action of a script before a tick.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Action {
    /// Sets the flags of a component.
    Flags(u32),
    /// Sets the rate of a component, by its type.
    Rate(f32),
    /// Resets the rate of a component to the declared one.
    Reset,
    /// Makes a component set the rate of its child in its next run.
    SetChildRate(f32),
    /// Holds a component.
    Hold(Hold),
    /// Makes a machine go to a state.
    Go(Index),
}

/// One cycle: the actions before it with the indices of their components, and the clock.
#[derive(Clone, Debug)]
pub(crate) struct Tick {
    pub(crate) actions: Vec<(Index, Action)>,
    pub(crate) clock: Clock,
    /// Number of calls of functions of components before one panics.
    pub(crate) panics: Option<u32>,
}

pub(crate) type Script = Vec<Tick>;

/// Relative frequencies of the actions of a script.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stress {
    pub(crate) flags: u32,
    pub(crate) rates: u32,
    pub(crate) holds: u32,
    pub(crate) ways: u32,
    /// Percentage of ticks in which a function of a component may panic.
    pub(crate) panics: u32,
    /// Whether the clock jumps, also backwards.
    pub(crate) jumps: bool,
}

/// Scripts of up to 48 cycles.
pub(crate) fn scripts(stress: Stress) -> impl Strategy<Value = Script> {
    // Most ticks have no requests, so that a tree can become steady.
    let requests = prop::collection::vec((any::<Index>(), action(stress)), 1..4);
    let actions = prop_oneof![3 => Just(Vec::new()), 1 => requests];
    let panics = prop_oneof![100 - stress.panics => Just(None), stress.panics => (0..20_u32).prop_map(Some)];
    let tick = (actions, clock(stress.jumps), panics);
    let tick = tick.prop_map(|(actions, clock, panics)| Tick { actions, clock, panics });
    prop::collection::vec(tick, 1..48)
}

fn action(stress: Stress) -> BoxedStrategy<Action> {
    prop_oneof![
        1 => Just(Action::Flags(0)),
        stress.flags => (any::<u32>(), any::<u32>()).prop_map(|(a, b)| Action::Flags(a & b)),
        2 * stress.rates => rate().prop_map(Action::Rate),
        stress.rates => Just(Action::Reset),
        stress.rates => rate().prop_map(Action::SetChildRate),
        stress.holds => hold().prop_map(Action::Hold),
        stress.ways => any::<Index>().prop_map(Action::Go),
    ]
    .boxed()
}

fn hold() -> impl Strategy<Value = Hold> {
    prop_oneof![1 => Just(Hold::Active), 1 => Just(Hold::Latent), 3 => Just(Hold::Tree)]
}

const ODD: [f32; 9] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, -1.0, f32::MIN_POSITIVE, 1e-30, 1e30];

/// Rates around the declared ones, and invalid ones.
fn rate() -> impl Strategy<Value = f32> {
    prop_oneof![3 => 0.5_f32..120.0, 1 => prop::sample::select(&ODD[..])]
}

fn clock(jumps: bool) -> BoxedStrategy<Clock> {
    let ms = |range: std::ops::Range<u64>| range.prop_map(|ms| Clock::Later(ms * 1000));
    let steady = prop_oneof![
        4 => Just(Clock::Later(10_000)),
        2 => ms(1..40),
        2 => (0..50_000_u64).prop_map(Clock::Later),
        1 => ms(40..700),
        1 => Just(Clock::Later(0)),
    ];
    let jump = prop_oneof![
        (0..5_000_000_u64).prop_map(Clock::Earlier),
        (0..90_000_u64).prop_map(Clock::Earlier),
        any::<u64>().prop_map(Clock::At),
        prop::sample::select(&[0, 1, u64::MAX - 1, u64::MAX][..]).prop_map(Clock::At),
    ];
    if jumps { prop_oneof![3 => steady, 1 => jump].boxed() } else { steady.boxed() }
}

impl Clock {
    pub(crate) fn after(self, now: u64) -> u64 {
        match self {
            Self::Later(ticks) => now.saturating_add(ticks),
            Self::Earlier(ticks) => now.saturating_sub(ticks),
            Self::At(tick) => tick,
        }
    }
}
