//! `play --world booster`: a real Booster T1 or K1.

use std::process::{self, Command as Process};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

use bica::runner::World;
use bica::{Instant, Tree};
use bica_app::{App, Failure, Outcome, RunArgs, interrupt};
use bica_booster::{Body, BoosterWorld, Dds, Driver, Gait, K1, Motion, Options, T1, address};
use bica_camera::{Images, Origin};
use bica_motion::robot::Command;
use bica_player::input::RobotProfile;
use bica_player::league::senses::{Senses, View};
use bica_player::league::{Forward, K1_PARAMETERS, T1_PARAMETERS};
use bica_player::model::set_model;
use bica_player::motion::{Head, Walk};
use bica_recording::{ReplayOptions, ReplayReport};
use bica_tuning::Layers;

use crate::cli::{BoosterArgs, GaitArg, Play};
use crate::colour_profile::ColourProfile;
use crate::eyes::Eyes;
use crate::play::recorded_options;

/// Name of the world in recordings and options.
const WORLD: &str = "booster";
/// Command that runs the guard.
pub(crate) const GUARD: &str = "booster-guard";
/// Exit code of a program that hangs: that of a panic.
const HUNG: i32 = 101;
/// Name of the option that selects the robot in a recording.
const ROBOT: &str = "robot";

/// Whether the firmware has the robot back at the end, and what failed.
type Standing = Arc<Mutex<bool>>;

/// The robot behind the forward's senses.
struct Field {
    world: BoosterWorld,
    body: &'static Body,
    /// `None` without images.
    eyes: Option<Eyes>,
    /// What they see in this cycle.
    view: Option<View>,
    /// What the forward requests of the firmware's gait.
    motion: Arc<Mutex<Motion>>,
    standing: Standing,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl World<Forward> for Field {
    fn now(&self) -> Instant {
        self.world.time()
    }

    fn sensors(&mut self) -> Senses<'_> {
        Senses { body: self.world.sense(), view: self.view.clone(), playing: !self.world.is_ending() }
    }

    fn act(&mut self, command: &Command) {
        self.world.request(*lock(&self.motion));
        self.world.command(command);
        let angles = self.world.sense().angles;
        self.view = self.eyes.as_mut().and_then(|eyes| eyes.look(self.body.model, &angles));
        *lock(&self.standing) = self.world.is_in_order();
    }

    fn is_over(&self) -> bool {
        self.world.has_ended()
    }

    fn report(&self, out: &mut dyn core::fmt::Write) -> core::fmt::Result {
        self.world.counts().write(out)
    }
}

/// Plays on a real robot as the command line requests.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    refuse(args)?;
    let Some(body) = args.tuning.robot().and_then(Body::named) else {
        let what = "the robot behind these topics is a T1 or a K1";
        return Err(Failure::new(what, "give --robot t1 or --robot k1, too"));
    };
    interrupt::end_in_order();
    let standing = Standing::new(Mutex::new(true));
    let motion = Arc::<Mutex<Motion>>::default();
    let open = opener(args, body, &standing, &motion)?;
    play(args, body, &motion, open)?;
    let is_in_order = *lock(&standing);
    Ok(if is_in_order { Outcome::Success } else { Outcome::Unsuccessful })
}

/// Returns what opens the world.
fn opener(
    args: &Play,
    body: &'static Body,
    standing: &Standing,
    motion: &Arc<Mutex<Motion>>,
) -> Result<impl Fn() -> Result<Field, Failure> + Send + Sync + use<>, Failure> {
    let interface = args.booster.dds_interface.as_deref().map(address).transpose();
    let interface = interface.map_err(|error| {
        Failure::new(format!("--dds-interface: {error}"), "give a name that `ip address` lists, or an IPv4 address")
    })?;
    let (gait, booster) = (args.booster.gait.into(), args.booster.clone());
    let (domain, limit, standing) = (args.booster.dds_domain, args.seconds, Arc::clone(standing));
    let (frames, motion) = (args.frames.clone(), Arc::clone(motion));
    Ok(move || {
        let transport = Dds::open(domain, interface).map_err(|error| {
            Failure::new(error, "is the network up? `--dds-interface` names the interface to the robot")
        })?;
        say(&format!("waits for a {} in domain {domain}", body.model.name));
        let stop = Box::new(interrupt::requested);
        let guard = Some(guard_command(body, &booster));
        let abandon = || process::exit(HUNG);
        let options = Options { body, gait, client: client(), limit, guard, abandon, stop, say };
        let world = BoosterWorld::open(transport, options);
        let world = world.map_err(|error| Failure::new(error.to_string(), "is there memory left?"))?;
        let images = frames.clone().map(|socket| Images::start(Origin::Socket(socket), say)).transpose();
        let images = images.map_err(|error| Failure::new(error.to_string(), "is there memory left?"))?;
        let (eyes, motion, standing) = (images.map(Eyes::new), Arc::clone(&motion), Arc::clone(&standing));
        Ok(Field { world, body, eyes, view: None, motion, standing })
    })
}

fn guard_command(body: &Body, args: &BoosterArgs) -> Process {
    let program = std::env::current_exe().unwrap_or_else(|_| "player".into());
    let gait = if args.gait == GaitArg::Own { "own" } else { "firmware" };
    let mut command = Process::new(program);
    command.args([GUARD, body.model.id, "--gait", gait, "--dds-domain", &args.dds_domain.to_string()]);
    command.args(args.dds_interface.iter().flat_map(|interface| ["--dds-interface", interface]));
    command
}

/// Runs the guard of a program: `player booster-guard ROBOT`. A run starts this command itself.
pub(crate) fn guard(robot: &str, args: &BoosterArgs) -> Result<Outcome, Failure> {
    interrupt::end_in_order();
    let failed = |error| Failure::new(error, "leave the start of a guard to `player play --world booster`");
    let body = Body::named(robot).ok_or_else(|| failed(format!("there is no robot `{robot}`")))?;
    let interface = args.dds_interface.as_deref().map(address).transpose().map_err(failed)?;
    let transport = Dds::open(args.dds_domain, interface).map_err(failed)?;
    bica_booster::guard(transport, Driver::guarding(body, args.gait.into(), client()), say);
    Ok(Outcome::Success)
}

impl From<GaitArg> for Gait {
    fn from(gait: GaitArg) -> Self {
        if gait == GaitArg::Firmware { Self::Firmware } else { Self::Own }
    }
}

/// Plays with all that the program of a robot offers.
fn play(
    args: &Play,
    body: &'static Body,
    motion: &Mutex<Motion>,
    open: impl Fn() -> Result<Field, Failure> + Send + Sync + 'static,
) -> Result<(), Failure> {
    // Without a limit: the world itself ends the run, after the firmware has the robot back.
    let run = RunArgs { tuning: args.tuning.of_known_robot(), ..args.run_args(WORLD, vec![option(body)]) };
    let app = App::<Forward, ColourProfile>::new("player").robot(maker(body)).pacing_device(WORLD, move |options| {
        options.value(ROBOT, body.model.id.to_owned())?;
        open()
    });
    app.play_showing(&run, &mut |forward| *lock(motion) = requested(forward)).map(drop)
}

/// What the forward requests of the firmware.
fn requested(forward: &Forward) -> Motion {
    let velocity = forward.get::<Walk>().requested();
    let head = forward.get::<Head>().target();
    let walks = forward.of::<Walk>().is_active();
    let velocity = if walks { [velocity.forward, velocity.left, velocity.turn] } else { [0.0; 3] };
    Motion { velocity, head: [head.pitch, head.yaw] }
}

/// Replays the recording of a run; `None` if the recording is not of this world.
pub(crate) fn replay(options: &ReplayOptions<'_>) -> Option<Result<ReplayReport, Failure>> {
    let body = if recorded_options(options.path, WORLD)?.contains(&option(K1)) { K1 } else { T1 };
    Some(App::<Forward, ColourProfile>::new("player").robot(maker(body)).repeat(options))
}

fn option(body: &Body) -> String {
    format!("{ROBOT}={}", body.model.id)
}

fn say(text: &str) {
    eprintln!("booster: {text}");
}

/// Number that differs from that of each other client of the robot.
fn client() -> u64 {
    let nanos = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_nanos() as u64);
    nanos.rotate_left(32) ^ u64::from(process::id())
}

/// Refuses options that a real robot does not support.
fn refuse(args: &Play) -> Result<(), Failure> {
    let simulated = args.pictures.is_some() || args.film.is_some() || args.games.is_some() || args.robots > 0;
    let other = args.image.is_some() || args.cameras.is_some() || args.league.server.is_some() || args.league.against;
    if simulated || other {
        let what = "a real Booster has no pictures, films, series, other robots, firmware images, V4L2 cameras and servers here";
        let help = "leave out --pictures, --film, --games, --robots, --image, --cameras, --server and --against";
        return Err(Failure::new(what, help));
    }
    Ok(())
}

fn maker(body: &'static Body) -> fn() -> Box<Forward> {
    if body.model.id == K1.model.id { || forward(K1, K1_PARAMETERS) } else { || forward(T1, T1_PARAMETERS) }
}

/// Returns the forward with the motions that were tuned in `MuJoCo`.
fn forward(body: &'static Body, parameters: &str) -> Box<Forward> {
    let mut forward = Box::<Forward>::default();
    set_model(&mut *forward, body.model);
    forward.get_mut::<RobotProfile>().set(body.model.dynamic_profile);
    let mut layers = Layers::new(const { &Forward::GRAPH });
    // A test of the league reads the same texts.
    _ = layers.read_text(body.model.id, parameters);
    _ = forward.set_params(&layers.settings());
    forward
}
