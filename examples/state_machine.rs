//! A component whose behaviour depends on the situation: states, transitions, a timer, hooks, and a transition that hands over what it
//! found.
//!
//! `cargo run --example state_machine`

use bica::prelude::*;

struct Ball {
    /// Distance in metres; `None` if the ball is not visible.
    distance: Option<f32>,
}

#[component]
impl Ball {}

struct Legs {
    speed: f32,
}

#[component(hz = 50)]
impl Legs {}

/// A planned kick.
struct Kick {
    /// From the body to the ball, metres.
    reach: f32,
}

struct Player {
    kicks: u32,
    /// Of the last kick, metres.
    reach: f32,
}

#[component(hz = 10)]
impl Player {
    /// Stands still and looks around.
    #[state(initial)]
    fn look(&mut self) {}

    /// The only state that needs the legs: they are active only here.
    #[state]
    fn walk(&mut self, legs: &mut Legs, ball: &Ball) {
        legs.speed = ball.distance.unwrap_or(0.0).min(0.2);
    }

    #[state]
    fn kick(&mut self) {}

    #[transition(look -> walk)]
    fn seen(&self, ball: &Ball) -> bool {
        ball.distance.is_some()
    }

    /// It is taken if it finds a kick; the entry hook of the state gets it.
    #[transition(walk -> kick)]
    fn near(&self, ball: &Ball) -> Option<Kick> {
        ball.distance.filter(|metres| *metres < 0.1).map(|reach| Kick { reach })
    }

    /// The timer and the condition must both hold.
    #[transition(walk -> look, after_ms = 1500)]
    fn lost(&self, ball: &Ball) -> bool {
        ball.distance.is_none()
    }

    #[transition(kick -> look, after_ms = 800)]
    fn kicked(&self) -> bool {
        true
    }

    #[entry(kick)]
    fn swing(&mut self, Found(kick): Found<Kick>) {
        self.kicks += 1;
        self.reach = kick.reach;
    }
}

activation_tree! {
    struct Robot {
        root: Player,
        cycle_hz: 50,
        components: [Player = Player { kicks: 0, reach: 0.0 }, Ball = Ball { distance: None }, Legs = Legs { speed: 0.0 }],
    }
}

fn main() {
    let (mut robot, mut metres) = (Robot::new(), 0.5);
    for ms in (0..6000).step_by(20) {
        metres -= if robot.of::<Legs>().is_active() { 0.02 * robot.get::<Legs>().speed } else { 0.0 };
        robot.get_mut::<Ball>().distance = (500..4000).contains(&ms).then_some(metres);
        let before = robot.of::<Player>().state_name();
        robot.tick(Instant::from_millis(ms));
        if let Some(state) = robot.of::<Player>().state_name().filter(|state| Some(*state) != before) {
            println!("{ms:4} ms: {state} with the ball at {metres:.2} m");
        }
    }
    let Player { kicks, reach } = robot.get::<Player>();
    println!("{kicks} kicks, the last one at {reach:.2} m");
}
