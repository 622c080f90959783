//! The forward: one run of each component, and the whole loop.

use std::hint::black_box;

use bica::prelude::*;
use bica::runner::Runner;
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
use bica_player::{Forward, tunable};
use bica_sim::setup::Frame;
use gungraun::prelude::*;

use bica_benches::game::ForwardTree;
use bica_benches::isolated::IsolatedComponent;
use bica_benches::recording::{CYCLES, Recording, WARM};

/// Isolates a component and loads a new image for it.
fn alone<C: 'static>() -> IsolatedComponent
where
    Forward: Has<C>,
{
    let mut alone = IsolatedComponent::new(Forward::id::<C>(), Frame::Medium);
    if alone.needs_image() {
        alone.load_image();
    }
    alone
}

macro_rules! components {
    ($($name:ident: $kind:ty),* $(,)?) => {
        #[library_benchmark]
        $(#[bench::$name(alone::<$kind>())])*
        fn component(mut component: IsolatedComponent) -> IsolatedComponent {
            component.run();
            component
        }

        const _: () = assert!([$(stringify!($name)),*].len() == Forward::COUNT, "the list lacks a component");
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

/// Recorded sensor values, and the forward that processes them.
fn recording<T: ForwardTree>(frame: Frame) -> (Recording, Box<T>) {
    Recording::of_game(frame, WARM, CYCLES)
}

// Same loop as in the budget report, which measures its time.
#[library_benchmark]
#[bench::at_160x120(recording(Frame::Small))]
#[bench::at_320x240(recording(Frame::Medium))]
#[bench::at_640x480(recording(Frame::Large))]
fn forward((recording, robot): (Recording, Box<Forward>)) -> (Recording, Box<Forward>) {
    play(recording, robot)
}

#[library_benchmark]
#[bench::at_160x120(recording(Frame::Small))]
fn tunable_forward((recording, robot): (Recording, Box<tunable::Forward>)) -> (Recording, Box<tunable::Forward>) {
    play(recording, robot)
}

#[inline]
fn play<T: ForwardTree>(recording: Recording, robot: Box<T>) -> (Recording, Box<T>) {
    let mut runner = Runner::new(robot, ());
    for (cycle, sensors) in recording.sensors().enumerate() {
        let now = Instant::from_millis(10_000 + 10 * cycle as u64);
        runner.sense(now, &sensors).expect("the image fits");
        black_box(runner.think(now));
    }
    (recording, runner.into_parts().0)
}

library_benchmark_group!(name = whole_loop, benchmarks = [forward, tunable_forward]);
