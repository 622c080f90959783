//! A machine that answers the results of another one: an arm tries to pick up a thing, again after a pause, and gives up after three
//! attempts. The pause is a parameter.
//!
//! `cargo run --example retry`

use bica::prelude::*;

/// Times of the picker.
#[derive(Params)]
struct Picking {
    /// Pause before the next attempt.
    #[param(default = 0.5, range = 0.0..=10.0, unit = "s")]
    pause: f32,
}

/// Decides what to do; `Reach` knows how.
struct Picker;

#[component(hz = 50)]
impl Picker {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    #[transition(reach -> lift, when = done(Reach))]
    #[transition(reach -> wait, when = failed(Reach), times = 2)]
    #[transition(reach -> give_up, when = failed(Reach))]
    fn reach(&mut self, reach: &mut Reach) {}

    #[state]
    #[transition(wait -> reach, after = Picking::pause)]
    fn wait(&mut self) {}

    #[state(done)]
    fn lift(&mut self) {}

    #[state(failed)]
    fn give_up(&mut self) {}
}

/// Moves the hand to the thing. Each time that it begins, it begins with `approach`.
struct Reach {
    attempts: u32,
}

#[component(hz = 50)]
impl Reach {
    #[state(initial)]
    fn approach(&mut self) {}

    #[state(done)]
    fn touches(&mut self) {}

    #[state(failed)]
    fn blocked(&mut self) {}

    #[transition(approach -> touches, after_ms = 300)]
    fn arrives(&self, thing: &Thing) -> bool {
        self.attempts > thing.slips
    }

    #[transition(approach -> blocked, after_ms = 400)]
    fn takes_too_long(&self) -> bool {
        true
    }

    #[entry(approach)]
    fn count(&mut self) {
        self.attempts += 1;
    }
}

/// The thing slips away from the first attempts.
struct Thing {
    slips: u32,
}

#[component]
impl Thing {}

activation_tree! {
    struct Arm {
        root: Picker,
        cycle_hz: 50,
        tunable,
        components: [Picker, Reach = Reach { attempts: 0 }, Thing = Thing { slips: 0 }],
    }
}

/// Returns the last state of the picker, and the number of attempts, if the thing slips away so often.
fn pick(slips: u32) -> (Option<&'static str>, u32) {
    let mut arm = Arm::new();
    arm.get_mut::<Thing>().slips = slips;
    for ms in (0..10_000).step_by(20) {
        arm.tick(Instant::from_millis(ms));
    }
    (arm.of::<Picker>().state_name(), arm.get::<Reach>().attempts)
}

fn main() {
    for slips in [0, 2, 3] {
        let (state, attempts) = pick(slips);
        println!("slips {slips} times: {} after {attempts} attempts", state.unwrap_or("nothing"));
    }
}
