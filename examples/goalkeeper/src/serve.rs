//! Shots in real time, one after the other, for monitors.

use std::thread;
use std::time::{Duration, Instant};

use bica::Setting;
use bica::runner::Runner;
use bica_app::{Console, Failure, Outcome, interrupt};
use bica_link::{Address, LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_player::Model;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Frame;
use bica_sim::shot::Shot;
use bica_wire::message::{LogSource, Offers};
use glam::Vec2;

use crate::Keeper;
use crate::shots::{self, Attempt, Plan};
use crate::story::Story;

/// Level of informative lines in the log of a link.
const INFORMATION: u8 = 2;
/// Additional time before a shot in which the goalkeeper finds the next ball.
const SEARCH: Duration = Duration::from_secs(8);
/// Time between two polls of the requests of a paused world.
const PAUSED: Duration = Duration::from_millis(5);

type Game = Runner<Box<Keeper>, KinematicWorld<Model>, LinkRequests, (Story, LinkObserver<Keeper>)>;

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
    let offers = Offers::PAUSE;
    let options = ServerOptions { anywhere, offers, ..ServerOptions::default() };
    let (server, requests, observer) = LinkServer::start_in_world::<Keeper>(address, options, &world)?;
    console.print_row("link", &format!("monitors attach at {}", server.address()))?;
    let keeper = shots::goalkeeper(&world, settings)?;
    let observers = (Story::new(), observer);
    let mut game = Runner::new(keeper, world).with_requests(requests).with_observer(observers);
    let mut number = 0;
    while !interrupt::requested() {
        let mut attempt = Attempt::new(shot, game.world().now());
        play(&mut game, &mut attempt, console)?;
        if interrupt::requested() {
            break;
        }
        let result = if attempt.result(plan.seed, game.world()).let_in { "let in" } else { "saved" };
        let line = format!("shot {number}: {result}");
        console.print(&line)?;
        server.log(INFORMATION, LogSource::World, &line);
        shot = next(plan, &mut number, game.world_mut());
    }
    Ok(Outcome::Interrupted)
}

/// Plays one shot in real time, with the operator's pauses.
fn play(game: &mut Game, attempt: &mut Attempt, console: Console) -> Result<(), Failure> {
    let (mut began, start) = (Instant::now(), game.world().now());
    while attempt.advance(game.world_mut())? && !interrupt::requested() {
        if !game.requests_mut().begins_cycle() {
            let paused = Instant::now();
            game.apply_requests();
            show_truth(game);
            thread::sleep(PAUSED);
            began += paused.elapsed();
            continue;
        }
        shots::cycle(game)?;
        show_truth(game);
        for line in game.observer_mut().0.take() {
            console.print(&line)?;
        }
        let played = game.world().now().saturating_sub(start);
        thread::sleep(played.saturating_sub(began.elapsed()));
    }
    Ok(())
}

/// Puts the ball at the start of the next shot that is possible: the robot may stand where one begins.
fn next(plan: &Plan, number: &mut u32, world: &mut KinematicWorld<Model>) -> Shot {
    loop {
        *number = number.wrapping_add(1);
        let shot = plan.shot(plan.seed, *number);
        if world.set_ball(shot.from, Vec2::ZERO).is_ok() {
            return Shot { rest: shot.rest + SEARCH, ..shot };
        }
    }
}

/// Sends the true state after the last cycle to monitors that watch it.
fn show_truth(game: &Game) {
    let (_, observer) = game.observer();
    observer.show_truth(game.world());
}
