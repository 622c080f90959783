//! A component driven by hand: outputs, modulations, holds, and requests to a running robot.
//!
//! `cargo run --example operator`

use bica::output::{OutputSink, OutputType};
use bica::prelude::*;
use bica::runner::{OwnedRequest, Request, RequestQueue};

/// The wheels of a cart.
struct Wheels {
    speed: f32,
    driven: f32,
}

#[component(hz = 50)]
impl Wheels {
    const fn new() -> Self {
        Self { speed: 0.0, driven: 0.0 }
    }

    /// Sets the speed, positive ahead. An operator can call it as an activator does.
    #[modulation]
    fn drive(
        &mut self,
        #[range(-0.5..=0.5)]
        #[unit("m/s")]
        speed: f32,
    ) {
        self.speed = speed;
    }

    /// Distance from the start.
    #[output(unit = "m")]
    fn driven(&self) -> f32 {
        self.driven
    }

    fn step(&mut self, time: &Time) {
        self.driven += self.speed * time.dt();
    }
}

/// Drives ahead for two metres.
struct Errand;

#[component(hz = 50)]
impl Errand {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, wheels: &mut Wheels) {
        wheels.drive(if wheels.driven() < 2.0 { 0.4 } else { 0.0 });
    }
}

activation_tree! {
    struct Cart { root: Errand, cycle_hz: 50, components: [Errand, Wheels] }
}

impl Robot for Cart {
    type Sensors<'a> = ();
    type Command = f32;
    type Error = Infallible;

    fn sense(&mut self, (): &()) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) -> f32 {
        self.get::<Wheels>().speed
    }
}

/// World that measures nothing.
struct Clock(u64);

impl World<Cart> for Clock {
    fn now(&self) -> Instant {
        Instant::from_millis(20 * self.0)
    }

    fn sensors(&mut self) {}

    fn act(&mut self, _speed: &f32) {
        self.0 += 1;
    }
}

/// Prints values as JSON; a link would serialise them in another format.
struct Print;

impl OutputSink for Print {
    fn take<V: OutputType>(&mut self, value: &V) {
        println!("{}", serde_json::to_string(value).unwrap_or_else(|error| error.to_string()));
    }
}

fn print_outputs(cart: &Cart) {
    for node in Cart::GRAPH.nodes {
        for output in node.outputs {
            print!("     {}.{} ({}, {}) = ", node.name, output.name, output.ty, output.unit.unwrap_or("no unit"));
            cart.read_output(node.name, output.name, &mut Print);
        }
    }
}

fn main() -> Result<(), Refusal> {
    let (errand, wheels) = (Cart::id::<Errand>(), Cart::id::<Wheels>());
    let drive = |speed| Request::modulate::<Cart>("Wheels", "drive", &[Value::F32(speed)]).map(OwnedRequest::from);
    let script = [
        ("the errand drives", vec![]),
        (
            "by hand: the root is held latent, the wheels are held active and go back",
            vec![
                OwnedRequest::Hold { component: errand, hold: Hold::Latent },
                OwnedRequest::Hold { component: wheels, hold: Hold::Active },
                drive(-0.2)?,
            ],
        ),
        ("too fast: refused, and nothing changes", vec![drive(2.0)?]),
        (
            "the tree decides again",
            vec![
                OwnedRequest::Hold { component: errand, hold: Hold::Tree },
                OwnedRequest::Hold { component: wheels, hold: Hold::Tree },
            ],
        ),
    ];
    let mut runner = Runner::new(Box::new(Cart::new()), Clock(0)).with_requests(RequestQueue::new());
    for (second, (text, requests)) in script.into_iter().enumerate() {
        println!("{second} s: {text}");
        for request in requests {
            runner.requests_mut().push(request);
        }
        for _ in 0..50 {
            let Ok(_) = runner.cycle();
        }
        for refusal in runner.requests_mut().take_answers().into_iter().filter_map(Result::err) {
            println!("     refused: {refusal}");
        }
        print_outputs(runner.robot());
    }
    Ok(())
}
