//! Film of a game in the league: robot and ball at their estimated positions, and the view of the camera.

use std::path::Path;
use std::sync::{Arc, PoisonError};
use std::time::Duration;

use bica::runner::{Runner, World};
use bica::{Setting, Tree};
use bica_app::{Console, Failure, interrupt};
use bica_drawing::TreeState;
use bica_drawing::canvas::{Canvas, Rgb};
use bica_evaluation::polar::Polar;
use bica_field::SSIM_2026;
use bica_motion::model::NAO;
use bica_motion::pose::Pose2;
use bica_player::league::Forward;
use bica_player::league::senses::{Object, View};
use bica_sim::mujoco::{Shown, Stage};
use bica_wire::model::Description;
use glam::Vec2;

use super::entry::{Entry, failure};
use super::robot::{Estimate, Footballer, Standing};
use super::start::Start;
use super::world::{LeagueGame, LeagueWorld};
use crate::game::film::camera_operator::{CameraOperator, Site};
use crate::game::film::gif::Gif;
use crate::game::film::{CAMERA_HEIGHT, CAMERA_WIDTH, INTERVAL, LAST_REPEAT, OUTSIDE_HEIGHT, OUTSIDE_WIDTH, sheet};

/// Tangent of half the angle of view of the league's camera, in both directions (60°).
const HALF_VIEW: f32 = 1.75;
const GRASS: Rgb = [40, 104, 50];
const MARK: Rgb = [245, 245, 245];
const BALL: Rgb = [236, 120, 30];
const OTHERS: Rgb = [60, 70, 90];
/// Position of a ball that has not been seen yet, m: outside the picture.
const NOWHERE: Vec2 = Vec2::splat(200.0);

/// Plays one game and films it.
///
/// # Errors
/// If the server, the renderer or the file fails.
pub(crate) fn play(
    robot: &'static Footballer,
    entry: &Entry,
    settings: &[Setting],
    seconds: f64,
    path: &Path,
    console: Console,
) -> Result<LeagueGame, Failure> {
    let mut film = Film::new(robot, path, entry.server.is_none().then(|| Start::new(entry.seed)))?;
    let standing = Standing::default();
    let world = LeagueWorld::open(robot, entry, Arc::clone(&standing)).map_err(|error| failure(&error))?;
    let begin = World::<Forward>::now(&world);
    let mut runner = Runner::new((robot.forward)(), world);
    _ = runner.robot_mut().set_params(settings);
    let limit = bica::Duration::from_micros((seconds * 1e6) as u64);
    loop {
        let t = World::<Forward>::now(runner.world()) - begin;
        if interrupt::requested() || World::<Forward>::is_over(runner.world()) || t >= limit {
            break;
        }
        // The error type is infallible.
        _ = runner.cycle();
        film.watch(Duration::from_micros(t.as_micros()), runner.robot(), runner.world())?;
    }
    drop(runner);
    let count = film.finish()?;
    let (game, error) = core::mem::take(&mut *standing.lock().unwrap_or_else(PoisonError::into_inner));
    error.map_or(Ok(()), |error| Err(failure(&error)))?;
    console.print(&game.line())?;
    console.print_row("film", &format!("{count} pictures in {}", path.display()))?;
    Ok(game)
}

struct Film {
    gif: Gif,
    stage: Stage,
    operator: CameraOperator,
    description: Description,
    next: Duration,
    /// Pose on the field at which the odometry began.
    origin: Option<Pose2>,
    /// Last position of the ball.
    ball: Vec2,
    last: Option<Canvas>,
}

impl Film {
    /// A film of a game whose start is known, unless others started the server.
    fn new(robot: &Footballer, path: &Path, start: Option<Start>) -> Result<Self, Failure> {
        let scale = robot.body.standing_height / NAO.dynamic_profile.gait.hip_height;
        let stage = Stage::new(robot.body.model, &SSIM_2026, OUTSIDE_WIDTH, OUTSIDE_HEIGHT).map_err(cannot_draw)?;
        Ok(Self {
            gif: Gif::new(path, OUTSIDE_WIDTH + CAMERA_WIDTH, OUTSIDE_HEIGHT)?,
            stage,
            operator: CameraOperator::new(Site::outdoors(&SSIM_2026, scale)),
            description: Description::of(const { &Forward::GRAPH }),
            next: Duration::ZERO,
            origin: start.map(|start| start.robot),
            ball: start.map_or(NOWHERE, |start| start.ball),
            last: None,
        })
    }

    /// Adds a picture when it is time for one.
    fn watch(&mut self, t: Duration, forward: &Forward, world: &LeagueWorld) -> Result<(), Failure> {
        let Estimate { odometry, robot, ball, goal } = Estimate::of(forward);
        self.origin = robot.map(|robot| robot * odometry.inverse()).or(self.origin);
        let Some(origin) = self.origin.filter(|_| t >= self.next) else { return Ok(()) };
        let robot = origin * odometry;
        self.next = (self.next + INTERVAL).max(t);
        self.ball = ball.map_or(self.ball, |(at, _)| robot.place(at));
        let subject = if self.ball == NOWHERE { robot.position } else { self.ball };
        let camera = self.operator.follow(robot.position, subject, Vec::new(), INTERVAL.as_secs_f32());
        let body = world.body();
        let tilt = (body.inertial.roll, body.inertial.pitch);
        let shown = Shown { at: robot, tilt, angles: &body.angles, ball: self.ball };
        let picture = self.stage.draw(&shown, &camera).map_err(cannot_draw)?;
        let tree = TreeState::of(&self.description, forward);
        let positions = [ball.map(|(at, seen)| Polar::new(at, seen)), goal.map(|at| Polar::new(at, false))];
        let sheet = sheet(&picture, Some(&seen(world.last_view())), t.as_secs_f64(), &tree, positions);
        self.last.replace(sheet).map_or(Ok(()), |last| self.gif.add(&last, 1))
    }

    fn finish(mut self) -> Result<usize, Failure> {
        self.last.take().map_or(Ok(()), |last| self.gif.add(&last, LAST_REPEAT))?;
        self.gif.finish()
    }
}

#[expect(clippy::needless_pass_by_value, reason = "it maps errors")]
fn cannot_draw(error: impl ToString) -> Failure {
    Failure::new(error.to_string(), "`cargo xtask mujoco` installs what MuJoCo needs to draw")
}

/// Draws the view of the camera: marks of the field, the ball, and feet of other players.
fn seen(view: &View) -> Canvas {
    let mut canvas = Canvas::new(CAMERA_WIDTH, CAMERA_HEIGHT, GRASS);
    let (middle, scale) =
        (0.5 * Vec2::new(CAMERA_WIDTH as f32, CAMERA_HEIGHT as f32), 0.5 * CAMERA_WIDTH as f32 / HALF_VIEW);
    for sight in view.iter().filter(|sight| sight.at[0] > 0.0) {
        let [ahead, left, up] = sight.at;
        let (radius, colour) = match sight.object {
            Object::Ball => ((scale * SSIM_2026.ball_radius() / ahead).max(3.0), BALL),
            Object::Mark(_) => (2.5, MARK),
            Object::Robot => (4.0, OTHERS),
        };
        canvas.disc(middle - scale * Vec2::new(left, up) / ahead, radius, colour);
    }
    canvas
}
