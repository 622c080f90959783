//! Prints the table of `docs/forward.md`: games with a fault that begins after 8 s.

use std::time::Duration;

use bica_app::Failure;
use bica_player_program::game::{GameObserver, GameResult, GameSummary, Rules, Scene, WorldKind, play_recorded};
use bica_sim::setup::Frame;

/// Number of games for each fault.
const GAMES: u64 = 10;

/// Options of the world, one for each fault.
const FAULTS: [&str; 17] = [
    "",
    "image=freeze",
    "image=dark",
    "image=bright",
    "image=noise",
    "image=drop",
    "gyro=0.2",
    "gyro=0.1",
    "gyro=-0.1",
    "stuck=HeadYaw",
    "stuck=HeadPitch",
    "stuck=LHipYawPitch",
    "stuck=LHipRoll",
    "stuck=LKneePitch",
    "stuck=RAnklePitch",
    "hot=LKneePitch",
    "button=8",
];

/// State of the root at the end of a game.
#[derive(Default)]
struct LastState(String);

impl GameObserver for LastState {
    fn tree_changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let tree = scene.tree();
        tree.state(tree.tree.root).unwrap_or("-").clone_into(&mut self.0);
        Ok(())
    }
}

fn play(seed: u64, option: &str) -> Result<(GameSummary, String), Failure> {
    let options: Vec<String> = match option {
        "" => Vec::new(),
        button if button.starts_with("button") => vec![button.to_owned()],
        fault => vec![fault.to_owned(), "from=8".to_owned()],
    };
    let rules = Rules {
        world: WorldKind::BuiltIn,
        seed,
        size: Frame::Small,
        robots: 0,
        limit: Duration::from_mins(2),
        realtime: false,
        firmware: None,
        settings: &[],
        options: options.leak(),
    };
    let mut state = LastState::default();
    let (summary, _) = play_recorded(&rules, &mut state, None, None)?;
    Ok((summary, state.0))
}

fn main() -> Result<(), Failure> {
    println!(
        "| option | goals of {GAMES} | state at the end of the others | what it says, and after how long at most |"
    );
    println!("|---|---|---|---|");
    for option in FAULTS {
        let games = (0..GAMES).map(|seed| play(seed, option)).collect::<Result<Vec<_>, _>>()?;
        let goals = games.iter().filter(|(game, _)| game.result == GameResult::Goal).count();
        let mut states: Vec<_> =
            games.iter().filter(|(game, _)| game.result != GameResult::Goal).map(|(_, state)| &**state).collect();
        states.sort_unstable();
        states.dedup();
        let first = games.iter().filter_map(|(game, _)| game.faults.first());
        let (named, latest) = (first.clone().count(), first.max_by(|a, b| a.t.total_cmp(&b.t)));
        let says = latest.map_or_else(String::new, |fault| {
            format!("{}, {:.1} s, in {named} games", fault.fault.as_deref().unwrap_or_default(), fault.t - 8.0)
        });
        let option = if option.is_empty() { "none".to_owned() } else { format!("`{option}`") };
        println!("| {option} | {goals} | {} | {says} |", states.join(", "));
    }
    Ok(())
}
