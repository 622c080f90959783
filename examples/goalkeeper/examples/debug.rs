//! debug
use bica::Tree;
use bica::runner::Runner;
use bica_player::perception::BallDetector;
use bica_sim::World;
use bica_sim::setup::Frame;
use bica_sim::shot::{SPEEDS, Shot};
use goalkeeper::skills::*;
use goalkeeper::{Story, shots};
fn main() {
    let seed: u64 = std::env::args().nth(1).unwrap().parse().unwrap();
    std::thread::Builder::new().stack_size(32 << 20).spawn(move || run(seed)).unwrap().join().unwrap();
}
fn run(seed: u64) {
    let shot = Shot::draw(seed, 0, &SPEEDS);
    println!("{shot:?}");
    let world = shots::world(seed, shot.from, Frame::Small).ok().unwrap();
    let mut series = shots::Series::new(shot);
    let mut runner = Runner::new(shots::goalkeeper(&world, &[]).ok().unwrap(), world).with_observer(Story::new());
    let mut n = 0;
    while series.referee(runner.world_mut()).ok().unwrap() {
        shots::cycle(&mut runner).ok().unwrap();
        let t = runner.world().now().as_millis() as i64 - shot.rest.as_millis() as i64;
        for line in runner.observer_mut().take() { println!("{t:6} {line}"); }
        n += 1;
        if (t > -1100 && t < 2500 && n % 10 == 0) || n % 100 == 0 {
            let r = runner.world().referee();
            let robot = runner.robot();
            let true_ball = r.robot().locate(r.ball());
            let ball = robot.get::<BallDetector>();
            println!("{t:6} robot {:.2?} {:.2} est {:.2?} {:.2} | ball {:.2?} seen {:.2?} v {:.2?} rolls {:.2} conf {} | {:.2?}",
                r.robot().position.to_array(), r.robot().heading, robot.get::<FieldPose>().pose().position.to_array(), robot.get::<FieldPose>().pose().heading,
                true_ball.to_array(), ball.position().map(|p| p.to_array()), ball.memory().velocity().to_array(), ball.memory().rolls(), ball.is_confirmed(),
                robot.get::<BallPath>().crossing());
        }
    }
    println!("{:?}", runner.world().referee().events());
}
