//! Shots in real time, one after the other, for monitors.

use std::thread;
use std::time::{Duration, Instant};

use bica::Setting;
use bica::runner::Runner;
use bica_console::{Console, Failure, Outcome, interrupt};
use bica_link::{Address, LinkServer, ServerOptions};
use bica_motion::robot::Sensors;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Frame;
use bica_sim::shot::Shot;
use glam::Vec2;

use crate::shots::{self, Attempt, Plan};
use crate::story::Story;

/// Level of an information in the log of a link.
const INFORMATION: u8 = 2;

/// Additional time before a shot in which the goalkeeper finds the next ball.
const SEARCH: Duration = Duration::from_secs(8);

/// Plays shots until Ctrl-C.
pub(crate) fn run(
    plan: &Plan,
    settings: &[Setting],
    frame: Frame,
    address: &Address,
    anywhere: bool,
    console: Console,
) -> Result<Outcome, Failure> {
    let mut shot = plan.shot(plan.seed, 0);
    let world = shots::world(plan.seed, shot.from, frame)?;
    let options = ServerOptions { anywhere, ..ServerOptions::default() };
    let (server, requests, observer) =
        LinkServer::start(address, options).map_err(|error| Failure::new(error.to_string(), error.help()))?;
    console.print_row("link", &format!("monitors attach at {}", server.address()))?;
    let observer = observer.counting_images(|sensors: &Sensors<'_>| sensors.image.is_some());
    let keeper = shots::goalkeeper(&world, settings)?;
    let mut runner = Runner::new(keeper, world).with_requests(requests).with_observer((Story::new(), observer));
    let began = Instant::now();
    let mut number = 0;
    while !interrupt::requested() {
        let mut attempt = Attempt::new(shot, runner.world().now());
        while attempt.advance(runner.world_mut())? && !interrupt::requested() {
            shots::cycle(&mut runner)?;
            for line in runner.observer_mut().0.take() {
                console.print(&line)?;
            }
            thread::sleep(runner.world().now().saturating_sub(began.elapsed()));
        }
        if interrupt::requested() {
            break;
        }
        let saved = if attempt.result(plan.seed, runner.world()).let_in { "let in" } else { "saved" };
        let line = format!("shot {number}: {saved}");
        console.print(&line)?;
        server.log(INFORMATION, &line);
        shot = next(plan, &mut number, runner.world_mut());
    }
    Ok(Outcome::Interrupted)
}

/// Puts the ball at the start of the next shot that is possible: the robot may stand where one begins.
fn next(plan: &Plan, number: &mut u32, world: &mut KinematicWorld) -> Shot {
    loop {
        *number = number.wrapping_add(1);
        let shot = plan.shot(plan.seed, *number);
        if world.set_ball(shot.from, Vec2::ZERO).is_ok() {
            return Shot { rest: shot.rest + SEARCH, ..shot };
        }
    }
}
