//! A component, the two components that it requires or modulates, and their tree.
//!
//! `cargo run --example first_component`

use bica::prelude::*;

/// Position of the ball in the image. The program writes its input before a tick.
struct BallDetector {
    image: f32,
    offset: f32,
}

#[component(hz = 30, budget_us = 900)]
impl BallDetector {
    const fn new() -> Self {
        Self { image: 0.0, offset: 0.0 }
    }

    /// Finds the ball in the image.
    fn step(&mut self) {
        self.offset = self.image;
    }
}

/// Pan angle of the head. The program reads its output after a tick.
struct Head {
    pan: f32,
}

#[component]
impl Head {
    const fn new() -> Self {
        Self { pan: 0.0 }
    }
}

struct FaceBall {
    gain: f32,
}

#[component(hz = 30, budget_us = 40)]
impl FaceBall {
    const fn new() -> Self {
        Self { gain: 0.5 }
    }

    /// Keeps the ball in the middle of the image.
    ///
    /// `&BallDetector` is required: it runs before. `&mut Head` is modulated: it runs after.
    fn step(&mut self, ball: &BallDetector, head: &mut Head) {
        head.pan += self.gain * ball.offset;
    }
}

activation_tree! {
    /// Looks at the ball.
    struct Robot {
        root: FaceBall,
        cycle_hz: 30,
        budget_ms: 1,
        components: [FaceBall, BallDetector, Head],
    }
}

fn main() {
    let ball_at = 0.8;
    let mut robot = Robot::new();
    for cycle in 0..6 {
        let seen = ball_at - robot.get::<Head>().pan;
        robot.get_mut::<BallDetector>().image = seen; // sense
        robot.tick(Instant::from_micros(cycle * 1_000_000 / 30)); // think
        println!("the ball is {seen:5.3} rad to the left, the head turns to {:5.3} rad", robot.get::<Head>().pan); // act
    }
}
