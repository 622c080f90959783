//! The program of a robot.

use std::ffi::OsString;
use std::fmt;
use std::marker::PhantomData;
use std::process::ExitCode;

use bica::runner::{Robot, World};

use bica_recording::{Recordable, ReplayOptions, ReplayReport};
use clap::builder::PossibleValuesParser;
use clap::{ArgMatches, Args, Command, FromArgMatches, Subcommand};

use crate::bench::{self, BenchArgs};
use crate::console::{Failure, Outcome};
use crate::names;
use crate::params::Layer;
use crate::replay;
use crate::run::{self, RunArgs};
use crate::start::start;
use crate::tool::{Replay, Tool};
use crate::world::{Pace, RegisteredWorld, Robots, WorldOptions};

/// Program of the robot `R`: its worlds and commands. `L` is the program's own layer of parameters.
pub struct App<R: Robot, L: Layer = ()> {
    command: Command,
    kind: Option<&'static str>,
    worlds: Vec<RegisteredWorld<R>>,
    robot: Robots<R>,
    own: Vec<Commands>,
    default: Option<Commands>,
    replay: Option<Replay>,
    #[cfg(feature = "monitor")]
    panels: Vec<Box<dyn bica_monitor::program::Extension>>,
    layer: PhantomData<fn() -> L>,
}

/// Function that runs a command with its parsed arguments.
type Work = Box<dyn FnOnce(&ArgMatches) -> Result<Outcome, Failure> + Send>;

/// Commands that a program adds.
struct Commands {
    augment: fn(Command) -> Command,
    has: fn(&str) -> bool,
    run: Work,
}

impl<R, L> App<R, L>
where
    R: Robot + Default + 'static,
    L: Layer,
{
    /// Creates the program with a name. Its help begins with the doc comment of the tree.
    #[must_use]
    pub fn new(name: &'static str) -> Self {
        let about = R::GRAPH.doc.split_whitespace().collect::<Vec<_>>().join(" ");
        Self {
            command: Command::new(name).about(about).after_help(run::EXIT_CODES),
            kind: None,
            worlds: Vec::new(),
            robot: Robots { make: Box::default, is_done: None },
            own: Vec::new(),
            default: None,
            replay: None,
            #[cfg(feature = "monitor")]
            panels: Vec::new(),
            layer: PhantomData,
        }
    }

    /// Changes the help and the version of the program.
    #[must_use]
    pub fn describe(self, change: impl FnOnce(Command) -> Command) -> Self {
        Self { command: change(self.command), ..self }
    }

    /// Adds a simulated world. The first one is the default.
    #[must_use]
    pub fn world<W: World<R> + 'static>(
        self,
        name: &'static str,
        open: impl Fn(&WorldOptions) -> W + Send + Sync + 'static,
    ) -> Self {
        self.try_world(name, move |options| Ok(open(options)))
    }

    /// Adds a simulated world that may refuse its options.
    #[must_use]
    pub fn try_world<W: World<R> + 'static>(
        mut self,
        name: &'static str,
        open: impl Fn(&WorldOptions) -> Result<W, Failure> + Send + Sync + 'static,
    ) -> Self {
        self.worlds.push(RegisteredWorld::new(name, Pace::Program, open));
        self
    }

    /// Adds a real robot: a world that runs in real time and cannot be paused.
    #[must_use]
    pub fn device<W: World<R> + 'static>(
        mut self,
        name: &'static str,
        open: impl Fn(&WorldOptions) -> Result<W, Failure> + Send + Sync + 'static,
    ) -> Self {
        self.worlds.push(RegisteredWorld::new(name, Pace::Clock, open));
        self
    }

    /// Adds a real robot that determines when a cycle begins. Its world waits for the robot in each cycle, and cannot
    /// be paused. The world also ends the run on request ([`interrupt::requested`](crate::interrupt::requested)),
    /// because it may have to bring the robot to rest first.
    #[must_use]
    pub fn pacing_device<W: World<R> + 'static>(
        mut self,
        name: &'static str,
        open: impl Fn(&WorldOptions) -> Result<W, Failure> + Send + Sync + 'static,
    ) -> Self {
        self.worlds.push(RegisteredWorld::new(name, Pace::World, open));
        self
    }

    /// Adds panels to the page of the command `monitor`.
    #[cfg(feature = "monitor")]
    #[must_use]
    pub fn panels(mut self, panels: impl bica_monitor::program::Extension + 'static) -> Self {
        self.panels.push(Box::new(panels));
        self
    }

    /// Returns this program's part of the `monitor` page, for another server of the page.
    #[cfg(feature = "monitor")]
    #[must_use]
    pub fn monitor(self) -> bica_monitor::program::Program
    where
        R: Recordable<Error: fmt::Display>,
    {
        crate::monitor::program(self.worlds, self.robot, self.panels)
    }

    /// Sets the aim of a run: the run ends when `is_done` returns true, unless it is served to monitors. A run that
    /// ends earlier has exit code 1.
    #[must_use]
    pub fn until(self, is_done: fn(&R) -> bool) -> Self {
        Self { robot: Robots { is_done: Some(is_done), ..self.robot }, ..self }
    }

    /// Sets the function that creates a robot, before the parameters of the command line are applied. The default is [`Default`].
    #[must_use]
    pub fn robot(self, make: fn() -> Box<R>) -> Self {
        Self { robot: Robots { make, ..self.robot }, ..self }
    }

    /// Sets the kind of robot whose tune file `params` reads without `--kind`. The default is the name of the first world.
    #[must_use]
    pub fn kind(self, kind: &'static str) -> Self {
        Self { kind: Some(kind), ..self }
    }

    /// Adds commands.
    #[must_use]
    pub fn commands<C: Subcommand>(mut self, run: impl FnOnce(C) -> Result<Outcome, Failure> + Send + 'static) -> Self {
        self.own.push(Commands { augment: C::augment_subcommands, has: C::has_subcommand, run: parsed(run) });
        self
    }

    /// Sets the work of the program without a command, instead of `run`.
    #[must_use]
    pub fn default_command<A: Args>(self, run: impl FnOnce(A) -> Result<Outcome, Failure> + Send + 'static) -> Self {
        Self { default: Some(Commands { augment: A::augment_args, has: |_| false, run: parsed(run) }), ..self }
    }

    /// Sets the function that replays a recording. By default the replay uses the world and the options of the recorded set-up.
    #[must_use]
    pub fn replay(
        self,
        replay: impl FnOnce(&ReplayOptions<'_>) -> Result<ReplayReport, Failure> + Send + 'static,
    ) -> Self {
        Self { replay: Some(Box::new(replay)), ..self }
    }

    /// Returns the command line, for example for a test of documented commands.
    #[must_use]
    pub fn command(&self) -> Command {
        let mut command = self.command.clone().args_conflicts_with_subcommands(true);
        command = match &self.default {
            Some(default) => (default.augment)(command),
            None if self.worlds.is_empty() => command.subcommand_required(true).arg_required_else_help(true),
            None => self.run_args(command),
        };
        if !self.worlds.is_empty() {
            let about = "Run the robot in a world (the default command)";
            command = command.subcommand(self.run_args(Command::new("run")).about(about));
        }
        #[cfg(feature = "monitor")]
        if !self.worlds.is_empty() {
            command = command.subcommand(crate::monitor::command());
        }
        for own in &self.own {
            command = (own.augment)(command);
        }
        // The doc comments of the arguments would replace the description of the program.
        Tool::<L>::augment_subcommands(command).about(self.command.get_about().cloned().unwrap_or_default())
    }

    fn run_args(&self, command: Command) -> Command {
        let names: Vec<_> = self.worlds.iter().map(|world| world.name).collect();
        let first = names[0];
        let parser = PossibleValuesParser::new(names);
        RunArgs::<L>::augment_args(command).mut_arg("world", |world| world.value_parser(parser).default_value(first))
    }

    /// Runs the command of the command line; returns the exit code. It is 2 if two worlds or two commands share a name,
    /// or an output and a parameter of one component do.
    #[must_use]
    pub fn run(self) -> ExitCode
    where
        R: Recordable<Error: fmt::Display>,
    {
        self.run_from(std::env::args_os())
    }

    /// Runs the command of the given arguments, the first of which is the name of the program; returns the exit code.
    #[must_use]
    pub fn run_from(self, arguments: impl IntoIterator<Item = OsString>) -> ExitCode
    where
        R: Recordable<Error: fmt::Display>,
    {
        let command = self.command();
        let worlds: Vec<_> = self.worlds.iter().map(|world| world.name).collect();
        if let Err(failure) = names::check(const { &R::GRAPH }, &worlds, &command) {
            return failure.into();
        }
        let matches = command.get_matches_from(arguments);
        start(move || self.dispatch(&matches))
    }

    /// Measures the robot for `cargo bench`: runs it in its simulated worlds with several seeds. Compares the slowest
    /// run of each component with its `budget_us`, and the slowest cycle with the tree's `budget_ms`. Returns the exit
    /// code, 1 if a budget is exceeded. Call it in the `main` of a `[[bench]]` with `harness = false`.
    #[must_use]
    pub fn bench(self) -> ExitCode
    where
        R: Robot<Error: fmt::Display>,
    {
        self.bench_from(std::env::args_os())
    }

    /// Measures as [`bench`](Self::bench) does, with the given arguments, the first of which is the name of the program.
    #[must_use]
    pub fn bench_from(self, arguments: impl IntoIterator<Item = OsString>) -> ExitCode
    where
        R: Robot<Error: fmt::Display>,
    {
        let Self { command, worlds, robot, .. } = self;
        let name = command.get_name().to_owned();
        let matches = BenchArgs::augment_args(command).get_matches_from(arguments);
        start(move || bench::bench::<R>(&name, &worlds, robot, &parse(&matches)?))
    }

    /// Runs the robot as `run` does with these arguments, for use by a command of another program.
    ///
    /// # Errors
    /// If an argument is invalid, or the run cannot continue.
    pub fn play(&self, args: &RunArgs<L>) -> Result<Outcome, Failure>
    where
        R: Recordable<Error: fmt::Display>,
    {
        self.play_showing(args, &mut |_| ())
    }

    /// Runs the robot as [`play`](Self::play) does, and shows it to a function after each cycle: for a world that takes more of a robot
    /// than its commands.
    ///
    /// # Errors
    /// If an argument is invalid, or the run cannot continue.
    pub fn play_showing(&self, args: &RunArgs<L>, show: &mut dyn FnMut(&R)) -> Result<Outcome, Failure>
    where
        R: Recordable<Error: fmt::Display>,
    {
        run::run::<R, L>(&self.worlds, self.robot, args, show)
    }

    /// Runs the code again on a recording as `replay` does, for use by a command of another program.
    ///
    /// # Errors
    /// If the recording cannot be read, or was not made by this robot.
    pub fn repeat(&self, options: &ReplayOptions<'_>) -> Result<ReplayReport, Failure>
    where
        R: Recordable<Error: fmt::Display>,
    {
        replay::replay(&self.worlds, self.robot, options)
    }

    fn dispatch(self, matches: &ArgMatches) -> Result<Outcome, Failure>
    where
        R: Recordable<Error: fmt::Display>,
    {
        let Self { kind, worlds, robot, own, default, replay, .. } = self;
        let first = worlds.first().map(|world| world.name);
        match (matches.subcommand(), default) {
            (None, Some(default)) => (default.run)(matches),
            (None, None) => run::run::<R, L>(&worlds, robot, &parse(matches)?, &mut |_| ()),
            (Some(("run", matches)), _) if !worlds.is_empty() => {
                run::run::<R, L>(&worlds, robot, &parse(matches)?, &mut |_| ())
            }
            #[cfg(feature = "monitor")]
            (Some(("monitor", matches)), _) if !worlds.is_empty() => {
                crate::monitor::run(crate::monitor::program(worlds, robot, self.panels), &parse(matches)?)
            }
            (Some((name, _)), _) => {
                if let Some(own) = own.into_iter().find(|own| (own.has)(name)) {
                    return (own.run)(matches);
                }
                let again = replay.unwrap_or_else(|| Box::new(move |options| replay::replay(&worlds, robot, options)));
                parse::<Tool<L>>(matches)?.run::<R>(kind.or(first).unwrap_or(R::GRAPH.name), again)
            }
        }
    }
}

fn parsed<A: FromArgMatches>(run: impl FnOnce(A) -> Result<Outcome, Failure> + Send + 'static) -> Work {
    Box::new(move |matches| run(parse(matches)?))
}

fn parse<A: FromArgMatches>(matches: &ArgMatches) -> Result<A, Failure> {
    A::from_arg_matches(matches).map_err(|error| Failure::new(error.to_string(), "--help lists the arguments"))
}
