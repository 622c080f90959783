//! One game: the forward in a world, cycle by cycle, until a goal or the end of the time.

use std::thread;
use std::time::{Duration, Instant as Clock};

use bica::runner::{self, Runner};
use bica::{Refusal, Tree, visual};
use bica_app::Failure;
use bica_motion::pose::Pose2;
use bica_player::input::{HealthMonitor, RobotProfile};
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_sim::SpectatorView;
use glam::Vec2;

use crate::game::control::{GameControl, NextStep};
use crate::game::event;
use crate::game::fingerprint::Fingerprint;
use crate::game::firmware::FirmwareCheck;
use crate::game::latency::Stopwatch;
use crate::game::link::{GameLink, LinkQueue, LinkView, ServeOptions};
use crate::game::meter::Meter;
use crate::game::observer::GameObserver;
use crate::game::recording::{GameRecorder, RecordOptions, RecordingSummary};
use crate::game::rules::Rules;
use crate::game::scene::{GRAPH, Scene};
use crate::game::summary::{FaultRecord, GameResult, GameSummary, Measurements};
use crate::game::world_factory;

/// Least distance between two points of the ball's path, m.
const PATH_STEP: f32 = 0.03;

/// Time between two polls for requests while the game is paused.
const BETWEEN_REQUESTS: Duration = Duration::from_millis(5);

/// Plays until a goal, the end of the time, or Ctrl-C; on request records the game and serves it to monitors. A recording that
/// ends early does not end the game.
///
/// # Errors
/// If the world, the firmware, the file or the server cannot be started, an observer fails, or the firmware deviates from this
/// program.
pub fn play_recorded(
    rules: &Rules,
    observer: &mut (impl GameObserver + ?Sized),
    record: Option<RecordOptions<'_>>,
    serve: Option<ServeOptions<'_>>,
) -> Result<(GameSummary, Option<RecordingSummary>), Failure> {
    play_controlled(rules, observer, &mut (), record, serve)
}

/// Plays as [`play_recorded`], with control over each step: pause, single cycles, end.
///
/// # Errors
/// As [`play_recorded`].
pub fn play_controlled(
    rules: &Rules,
    observer: &mut (impl GameObserver + ?Sized),
    control: &mut impl GameControl,
    record: Option<RecordOptions<'_>>,
    serve: Option<ServeOptions<'_>>,
) -> Result<(GameSummary, Option<RecordingSummary>), Failure> {
    let mut game = Game::new(rules, record, serve, control.lets_operators_pause())?;
    let began = Clock::now();
    let mut paused = Duration::ZERO;
    loop {
        let asked = Clock::now();
        let next = control.next(game.is_over(rules));
        if next == NextStep::End {
            break;
        }
        if game.runs_a_cycle(next) {
            paused += asked.elapsed();
            game.cycle()?;
        } else {
            thread::sleep(BETWEEN_REQUESTS);
            paused += asked.elapsed();
            game.runner.apply_requests();
            game.send_truth();
            continue;
        }
        game.report(observer)?;
        if let Some(note) = control.note() {
            game.recorder_mut().note(&note);
        }
        if let Some(reason) = game.recorder_mut().newly_ended() {
            control.recording_ended(&reason);
        }
        if rules.realtime {
            let ahead = game.now().saturating_sub(began.elapsed().saturating_sub(paused));
            thread::sleep(ahead);
        }
    }
    Ok(game.summarize(rules, began.elapsed()))
}

/// Observers of the loop. The stopwatch measures neither the firmware, which comes first, nor the recorder and the link
/// at the end of a cycle, which come last.
type LoopObservers = (FirmwareCheck, ((Meter, Stopwatch), (GameRecorder, LinkView)));

struct Game {
    runner: Runner<Box<Forward>, Box<dyn SpectatorView>, LinkQueue, LoopObservers>,
    link: GameLink,
    cycles: u64,
    tree_changes: u64,
    fingerprint: Fingerprint,
    /// Duration of the last cycle.
    cycle_time: Duration,
    start: Pose2,
    ball_path: Vec<Vec2>,
    /// Number of events that the observer has received.
    reported_events: usize,
    faults: Vec<FaultRecord>,
    seed: u64,
}

impl Game {
    fn new(
        rules: &Rules,
        record: Option<RecordOptions<'_>>,
        serve: Option<ServeOptions<'_>>,
        can_pause: bool,
    ) -> Result<Self, Failure> {
        let mut world = world_factory::open(rules)?;
        let actions = world.actions().list();
        let mut robot = Box::new(Forward::new());
        let (attacks, start, ball) = (world.referee().attacks(), world.referee().robot(), world.referee().ball());
        robot.get_mut::<RobotProfile>().set(rules.world.profile());
        robot.get_mut::<GoalDetector>().attack(attacks);
        let refused = |refusal: Refusal| Failure::new(refusal.to_string(), "check parameters with `player params`");
        robot.set_params(rules.settings).map_err(refused)?;
        let mut firmware = FirmwareCheck::new(rules.firmware.map(|image| image.start(attacks)).transpose()?);
        let scenery = |scene: &mut dyn visual::Scene| runner::World::<Forward>::scenery(&*world, scene);
        let image = world.shared_image();
        let recorder = GameRecorder::new(record, rules, attacks, (&robot, actions), image, scenery)?;
        let (link, requests, view) = GameLink::start(serve, rules, actions, &*world, can_pause, &mut firmware)?;
        let measured = (Meter::new(&GRAPH), Stopwatch::default());
        let observers = (firmware, (measured, (recorder, view)));
        Ok(Self {
            runner: Runner::new(robot, world).with_requests(requests).with_observer(observers),
            link,
            cycles: 0,
            tree_changes: 0,
            fingerprint: Fingerprint::default(),
            cycle_time: Duration::ZERO,
            start,
            ball_path: vec![ball],
            reported_events: 0,
            faults: Vec::new(),
            seed: rules.seed,
        })
    }

    fn now(&self) -> Duration {
        self.runner.world().now()
    }

    fn meter(&self) -> &Meter {
        let (_, ((meter, _), _)) = self.runner.observer();
        meter
    }

    fn view(&self) -> &LinkView {
        let (_, (_, (_, view))) = self.runner.observer();
        view
    }

    const fn recorder_mut(&mut self) -> &mut GameRecorder {
        let (_, (_, (recorder, _))) = self.runner.observer_mut();
        recorder
    }

    fn is_over(&self, rules: &Rules) -> bool {
        let world = self.runner.world();
        world.referee().goals() > 0 || self.now() >= rules.limit || world.failure().is_some()
    }

    /// Returns whether a cycle comes next: neither an operator nor the control has paused the game.
    fn runs_a_cycle(&mut self, next: NextStep) -> bool {
        let Some(requests) = self.runner.requests_mut() else { return true };
        if next == NextStep::Pause {
            requests.pause();
        }
        requests.begins_cycle()
    }

    fn cycle(&mut self) -> Result<(), Failure> {
        self.cycle_time = self.now();
        let command =
            self.runner.cycle().map_err(|error| Failure::new(error.to_string(), "choose a smaller --size"))?;
        let (firmware, ((meter, _), (recorder, _))) = self.runner.observer_mut();
        firmware.result()?;
        recorder.measured(meter);
        let ball = self.runner.world().referee().ball();
        self.fingerprint.add(&command, ball);
        self.cycles += 1;
        self.send_truth();
        self.tree_changes += u64::from(self.meter().changed());
        if self.ball_path.last().is_none_or(|last| last.distance(ball) > PATH_STEP) {
            self.ball_path.push(ball);
        }
        Ok(())
    }

    /// Sends the true state to monitors that watch the world.
    fn send_truth(&self) {
        if let Some(view) = self.view() {
            view.show_truth(&**self.runner.world());
        }
    }

    fn scene(&self) -> Scene<'_> {
        Scene {
            seed: self.seed,
            t: self.cycle_time.as_secs_f64(),
            robot: self.runner.robot(),
            referee: self.runner.world().referee(),
            meter: self.meter(),
            start: self.start,
            ball_path: &self.ball_path,
        }
    }

    fn report(&mut self, observer: &mut (impl GameObserver + ?Sized)) -> Result<(), Failure> {
        if let Some(view) = observer.view(self.now(), self.runner.world().referee()) {
            let picture = self.runner.world_mut().render_from(&view.camera, view.width, view.height);
            let picture = picture.map_err(|error| {
                Failure::new(error.to_string(), "`cargo xtask mujoco` installs what MuJoCo needs to draw")
            })?;
            observer.rendered(&self.scene(), &picture)?;
        }
        if self.meter().changed() {
            observer.tree_changed(&self.scene())?;
        }
        let (referee, (_, (_, (recorder, _)))) = (self.runner.world().referee(), self.runner.observer());
        for event in &referee.events()[self.reported_events..] {
            recorder.event(event);
            self.link.event(event);
            observer.event(event)?;
        }
        self.reported_events = referee.events().len();
        self.report_fault(observer)
    }

    /// Fault of the world, or those of body and senses; `None` without one.
    fn fault(&self) -> Option<String> {
        let health = self.runner.robot().get::<HealthMonitor>();
        let of_robot = [health.fault(), health.sense_fault()].into_iter().flatten().map(|fault| fault.to_string());
        let of_robot: Vec<_> = of_robot.collect();
        let of_world = self.runner.world().failure().map(ToOwned::to_owned);
        of_world.or_else(|| (!of_robot.is_empty()).then(|| of_robot.join("; ")))
    }

    fn report_fault(&mut self, observer: &mut (impl GameObserver + ?Sized)) -> Result<(), Failure> {
        let fault = self.fault();
        if self.faults.last().and_then(|last| last.fault.as_ref()) == fault.as_ref() {
            return Ok(());
        }
        let record = FaultRecord { t: self.cycle_time.as_secs_f64(), fault };
        let (_, (_, (recorder, _))) = self.runner.observer();
        recorder.fault(&record.text());
        observer.fault(&record)?;
        self.faults.push(record);
        Ok(())
    }

    fn summarize(self, rules: &Rules, real: Duration) -> (GameSummary, Option<RecordingSummary>) {
        let fault = self.fault();
        let (_, world, _, (firmware, ((meter, stopwatch), (recorder, _)))) = self.runner.into_parts();
        let measurements = Measurements {
            cycles: self.cycles,
            tree_changes: self.tree_changes,
            fingerprint: self.fingerprint,
            latencies: stopwatch.latencies,
            meter,
        };
        let broke = world.failure().is_some();
        let mut summary = GameSummary {
            fault,
            faults: self.faults,
            firmware: firmware.summarize(),
            ..GameSummary::new(rules, world.referee(), world.now(), measurements, real)
        };
        if broke && summary.result == GameResult::Interrupted {
            summary.result = GameResult::NoGoal;
        }
        let result = world.referee().events().iter().filter_map(event::result).next_back();
        let result = result.into_iter().chain([format!("fingerprint {}", summary.fingerprint)]).collect::<Vec<_>>();
        let recording = recorder.finish(&result.join(", "));
        (summary, recording)
    }
}
