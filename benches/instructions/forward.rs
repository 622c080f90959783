//! The forward: one run of each component, and its whole loop.

use std::hint::black_box;

use bica::prelude::*;
use bica::runner::Runner;
use bica_player::Forward;
use bica_player::behaviour::{
    Dribble, FaceBall, Fixmove, FollowBall, GoRound, LookAround, Player, SafetyGuard, SearchBall, SearchNet,
};
use bica_player::input::{CameraInput, Colours, GameState, HealthMonitor, RobotProfile, RobotState};
use bica_player::motion::{Body, GoStraight, Head, Kicker, Turn, Walk};
use bica_player::output::{CameraSelector, Motors};
use bica_player::perception::{
    BallDetector, CameraPose, FallDetector, FieldBoundary, FieldLines, GoalDetector, Localization, Odometry, OwnBody,
    RobotDetector,
};
use bica_sim::setup::Frame;
use gungraun::prelude::*;

use bica_benches::alone::Alone;
use bica_benches::recording::{CYCLES, Recording, WARM};

/// The component, with a new image before it.
fn alone<C: 'static>() -> Alone
where
    Forward: Has<C>,
{
    let mut alone = Alone::new(Forward::id::<C>(), Frame::Medium);
    if alone.sees() {
        alone.look();
    }
    alone
}

macro_rules! components {
    ($($name:ident: $kind:ty),* $(,)?) => {
        #[library_benchmark]
        $(#[bench::$name(alone::<$kind>())])*
        fn component(mut component: Alone) -> Alone {
            component.run();
            component
        }

        const _: () = assert!([$(stringify!($name)),*].len() == Forward::COUNT, "a component is missing here");
    };
}

components! {
    player: Player,
    search_ball: SearchBall,
    follow_ball: FollowBall,
    search_net: SearchNet,
    look_around: LookAround,
    go_round: GoRound,
    fixmove: Fixmove,
    dribble: Dribble,
    safety_guard: SafetyGuard,
    face_ball: FaceBall,
    body: Body,
    go_straight: GoStraight,
    turn: Turn,
    walk: Walk,
    kicker: Kicker,
    head: Head,
    localization: Localization,
    ball_detector: BallDetector,
    goal_detector: GoalDetector,
    field_lines: FieldLines,
    robot_detector: RobotDetector,
    field_boundary: FieldBoundary,
    own_body: OwnBody,
    camera_pose: CameraPose,
    odometry: Odometry,
    fall_detector: FallDetector,
    camera_input: CameraInput,
    colours: Colours,
    robot_state: RobotState,
    health_monitor: HealthMonitor,
    game_state: GameState,
    robot_profile: RobotProfile,
    motors: Motors,
    camera_selector: CameraSelector,
}

library_benchmark_group!(name = components, benchmarks = [component]);

/// A forward, and what it is about to sense.
fn recording(frame: Frame) -> (Recording, Box<Forward>) {
    Recording::of_game(frame, WARM, CYCLES)
}

// As in the budget report, which times it.
#[library_benchmark]
#[bench::at_160x120(recording(Frame::Small))]
#[bench::at_320x240(recording(Frame::Medium))]
#[bench::at_640x480(recording(Frame::Large))]
fn forward((recording, robot): (Recording, Box<Forward>)) -> (Recording, Box<Forward>) {
    let mut runner = Runner::new(robot, ());
    for (cycle, sensors) in recording.sensors().enumerate() {
        let now = Instant::from_millis(10_000 + 10 * cycle as u64);
        runner.sense(now, &sensors).expect("the image fits");
        black_box(runner.think(now));
    }
    (recording, runner.into_parts().0)
}

library_benchmark_group!(name = whole_loop, benchmarks = [forward]);
