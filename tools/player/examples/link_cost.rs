//! Cost of the link, or of a ROS 2 node, for the forward's loop: processor time of the cycles with and without it, in one run.
//!
//! `cargo run --profile dist -p bica-player-program --features measure,ros --example link_cost -- --ros`: images of
//! 640×480 at 30/s, in real time. As in a game, the link shares the owner of the image. Prints a line for each window
//! of time, until the end of its input.

use std::io::{Read as _, stdin};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use bica::Tree as _;
use bica::runner::Runner;
use bica::runner::STACK_BYTES;
use bica_app::{Console, ServeArgs};
use bica_link::{LinkServer, ServerOptions};
use bica_player::tunable::Forward;
use bica_wire::model::Description;
use clap::Parser;
use rustix::time::{ClockId, clock_gettime};

mod turns;

#[derive(Clone, Debug, Parser)]
struct Args {
    #[command(flatten)]
    serve: ServeArgs,
    /// Length of a window, s
    #[arg(long, default_value_t = 15)]
    window: u64,
}

fn main() {
    let args = Args::parse();
    let run = move || run(&args);
    thread::Builder::new().stack_size(STACK_BYTES).spawn(run).expect("a thread").join().expect("no panic");
}

fn run(args: &Args) {
    let address = args.serve.address().expect("--serve or --ros");
    let mut values = turns::Values::new(None);
    let options = ServerOptions { realtime: true, ..ServerOptions::default() };
    let (server, mut requests, observer) = LinkServer::start::<Forward>(&address, options).expect("an address");
    let started = args.serve.started(
        Console::new(false),
        &Description::of(const { &Forward::GRAPH }),
        &address,
        server.address(),
    );
    let _node = started.expect("a network");
    let mut with = Runner::new(turns::forward(), ()).with_observer(observer.sharing_images(values.owner()));
    let mut without = Runner::new(turns::forward(), ());
    let ended = Arc::new(AtomicBool::new(false));
    let end = Arc::clone(&ended);
    thread::spawn(move || {
        let _ = stdin().read_to_end(&mut Vec::new());
        end.store(true, Ordering::Relaxed);
    });
    let (mut cycle, window) = (0, 100 * args.window);
    while !ended.load(Ordering::Relaxed) {
        let cycles = cycle..cycle + window;
        let times = values.take_turns((&mut requests, &mut with), &mut without, cycles, processor_time);
        println!("without: {}; with: {}", turns::shown(&times[0]), turns::shown(&times[1]));
        cycle += window;
    }
}

/// Processor time of this thread; other programs are not counted.
fn processor_time() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
