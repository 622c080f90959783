//! Perception of a player in a cycle.

use bica_motion::joints::Joints;
use glam::Vec3;

use super::body::joint_of;
use super::error::Error;
use super::expression::{Expression, find, numbers};

/// Perception of a player in a cycle of 20 ms: everything that the server sends except the true pose.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Perception {
    /// State of the game.
    pub(crate) game: Game,
    /// Joint angles, rad; zero for joints that the robot lacks.
    pub(crate) angles: Joints,
    /// Angular velocity along the axes of the torso (x forward, y left, z up), rad/s.
    pub(crate) gyro: Vec3,
    /// Specific force along the same axes, m/s²: (0, 0, 9.81) at rest.
    pub(crate) acceleration: Vec3,
    /// Objects that the camera sees; in every second cycle.
    pub(crate) sights: Option<Vec<Sight>>,
}

/// State of the game.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Game {
    /// Play mode.
    pub(crate) mode: PlayMode,
    /// Goals of the left and of the right team.
    pub(crate) score: [u32; 2],
    /// Names of the left and of the right team; empty until a player of it has joined.
    pub(crate) teams: [String; 2],
}

/// Play mode, as far as a player distinguishes it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum PlayMode {
    /// Before a kick-off: players may be placed.
    #[default]
    BeforeKickOff,
    /// The ball is in play.
    PlayOn,
    /// After a goal.
    Goal,
    /// The game is over.
    GameOver,
    /// A restart, such as a kick-off or a corner kick: only the team with this index in [`Game::teams`] may touch the ball.
    Restart(usize),
    /// A mode of a newer server: nobody plays.
    Other,
}

/// Object in the view of the camera, which covers 60° to each side, up and down. The server computes it without noise
/// and without occlusion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sight {
    /// The object.
    pub(crate) what: Seen,
    /// Distance from the camera, m.
    pub(crate) distance: f32,
    /// Angle to the left of the camera's axis, rad.
    pub(crate) azimuth: f32,
    /// Angle above the plane of the camera's axes forward and left, rad.
    pub(crate) elevation: f32,
}

/// Kind of a sight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    /// The centre of the ball.
    Ball,
    /// A mark of the field, by its name, such as `l_ruf` or `g_rup`.
    Mark(String),
    /// A part of a player.
    Player {
        /// Name of its team.
        team: String,
        /// Number of the player.
        number: u32,
        /// `head`, `lfoot` or another name of the robot's model.
        part: String,
    },
}

impl PlayMode {
    /// Returns whether the team with an index in [`Game::teams`] may play: the ball is in play, or the team restarts.
    pub(crate) const fn lets_play(self, team: usize) -> bool {
        match self {
            Self::PlayOn => true,
            Self::Restart(by) => by == team,
            _ => false,
        }
    }
}

impl Perception {
    /// Parses the message of a cycle.
    ///
    /// # Errors
    /// If it is not well-formed, or lacks the game, the gyroscope or the accelerometer.
    pub(crate) fn parse(message: &str) -> Result<Self, Error> {
        let all = Expression::parse(message)?;
        let one = |name, value| find(&all, name).and_then(|rest| numbers::<3>(find(rest, value)?));
        let missing = |what| Error::Message(what);
        let game = find(&all, "GS").and_then(Game::of).ok_or(missing("it has no state of the game"))?;
        let gyro = one("GYR", "rt").ok_or(missing("it has no gyroscope"))?.map(f32::to_radians);
        let acceleration = one("ACC", "a").ok_or(missing("it has no accelerometer"))?;
        let mut angles = Joints::default();
        for (head, joint) in all.iter().filter_map(Expression::call) {
            let name = find(joint, "n").and_then(|name| joint_of(name.first()?.atom()?));
            if let (true, Some(joint), Some([angle])) = (head == "HJ", name, find(joint, "ax").and_then(numbers)) {
                angles[joint] = angle.to_radians();
            }
        }
        let sights = find(&all, "See").map(|sights| sights.iter().flat_map(sights_of).collect());
        Ok(Self { game, angles, gyro: gyro.into(), acceleration: acceleration.into(), sights })
    }

    /// Returns the centre of the ball in the newest view.
    #[cfg(test)]
    pub(crate) fn ball(&self) -> Option<&Sight> {
        self.sights.iter().flatten().find(|sight| sight.what == Seen::Ball)
    }
}

impl Game {
    fn of(state: &[Expression<'_>]) -> Option<Self> {
        let count = |name| numbers::<1>(find(state, name)?).map(|[goals]| goals as u32);
        let mode = match find(state, "pm")?.first()?.atom()? {
            "BeforeKickOff" => PlayMode::BeforeKickOff,
            "PlayOn" => PlayMode::PlayOn,
            "Goal_Left" | "Goal_Right" => PlayMode::Goal,
            "GameOver" => PlayMode::GameOver,
            // In `offside_left` the right team was offside, and the left one restarts, too.
            name => match name.to_ascii_lowercase().rsplit_once('_') {
                Some((_, "left")) => PlayMode::Restart(0),
                Some((_, "right")) => PlayMode::Restart(1),
                _ => PlayMode::Other,
            },
        };
        let team = |name| find(state, name).and_then(|name| name.first()?.atom()).unwrap_or_default().to_owned();
        Some(Self { mode, score: [count("sl")?, count("sr")?], teams: [team("tl"), team("tr")] })
    }
}

/// Returns the sights of one element of `See`: one, or the parts of a player.
fn sights_of(expression: &Expression<'_>) -> Vec<Sight> {
    let Some((name, rest)) = expression.call() else { return Vec::new() };
    if name != "P" {
        let what = if name == "B" { Seen::Ball } else { Seen::Mark(name.to_owned()) };
        return Sight::of(what, rest).into_iter().collect();
    }
    let text = |name| find(rest, name).and_then(|value| value.first()?.atom());
    let (Some(team), Some(number)) = (text("team"), text("id").and_then(|id| id.parse().ok())) else {
        return Vec::new();
    };
    let part =
        |(part, at): (&str, _)| Sight::of(Seen::Player { team: team.to_owned(), number, part: part.to_owned() }, at);
    rest.iter().filter_map(Expression::call).filter_map(part).collect()
}

impl Sight {
    fn of(what: Seen, rest: &[Expression<'_>]) -> Option<Self> {
        let [distance, azimuth, elevation] = numbers(find(rest, "pol")?)?;
        Some(Self { what, distance, azimuth: azimuth.to_radians(), elevation: elevation.to_radians() })
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joint;

    use super::*;

    /// A message as the server sends it, shortened.
    const MESSAGE: &str = "(time (now 7.13))(GS (t 0.0)(pm PlayOn)(tl Bica)(sl 2)(sr 1))\
        (quat (n torso_quat) (q 1 0 0 0))(pos (n torso_pos) (p -3.2 1.5 0.67))\
        (GYR (n torso_gyro) (rt 114.59156 0 -57.29578))(ACC (n torso_acc) (a 0.1 0.2 9.81))\
        (HJ (n q_hj1)(ax 57.29578)(vx 0))(HJ (n q_llj4)(ax 28.64789)(vx 1))(HJ (n unknown)(ax 1)(vx 1))\
        (See (B (pol 2 10 -20))(g_rup (pol 9.5 0 1))(P (team Bica)(id 1)(head (pol 0.1 1 2))(lfoot (pol 1 3 -60))))";

    #[test]
    fn senses_are_in_si_units() {
        let read = Perception::parse(MESSAGE).expect("well-formed");
        assert_eq!(read.game.mode, PlayMode::PlayOn);
        assert_eq!((read.game.score, &*read.game.teams[0], &*read.game.teams[1]), ([2, 1], "Bica", ""));
        assert!((read.angles[Joint::HeadYaw] - 1.0).abs() < 1e-4);
        assert!((read.angles[Joint::LKneePitch] - 0.5).abs() < 1e-4);
        assert!((read.gyro - Vec3::new(2.0, 0.0, -1.0)).length() < 1e-3);
        let ball = read.ball().expect("the ball is seen");
        assert!((ball.distance - 2.0).abs() < 1e-6 && (ball.azimuth - 0.1745).abs() < 1e-4, "{ball:?}");
        let kinds: Vec<Seen> = read.sights.into_iter().flatten().map(|sight| sight.what).collect();
        assert_eq!(kinds.len(), 4);
        assert_eq!(kinds[1], Seen::Mark("g_rup".to_owned()));
    }

    #[test]
    fn restarts_belong_to_a_team() {
        for (name, play) in [
            ("PlayOn", [true, true]),
            ("KickOff_Left", [true, false]),
            ("KickIn_Right", [false, true]),
            ("goal_kick_left", [true, false]),
            ("offside_right", [false, true]),
            ("BeforeKickOff", [false, false]),
            ("Goal_Left", [false, false]),
            ("unknown", [false, false]),
        ] {
            let read = Perception::parse(&MESSAGE.replace("PlayOn", name)).expect("well-formed");
            assert_eq!([0, 1].map(|team| read.game.mode.lets_play(team)), play, "{name}");
        }
    }

    #[test]
    fn true_pose_is_not_read() {
        let elsewhere = MESSAGE.replace("(p -3.2 1.5 0.67)", "(p 9 9 9)").replace("(q 1 0 0 0)", "(q 0 0 0 1)");
        let without = MESSAGE.replace("(quat (n torso_quat) (q 1 0 0 0))(pos (n torso_pos) (p -3.2 1.5 0.67))", "");
        assert!(elsewhere != MESSAGE && without.len() < MESSAGE.len());
        let read = Perception::parse(MESSAGE).expect("well-formed");
        for other in [elsewhere, without] {
            assert_eq!(Perception::parse(&other).expect("well-formed"), read);
        }
    }

    #[test]
    fn cycle_without_a_view_differs_from_an_empty_view() {
        let (without, _) = MESSAGE.split_once("(See").expect("a view");
        assert_eq!(Perception::parse(without).expect("well-formed").sights, None);
        let empty = format!("{without}(See )");
        assert_eq!(Perception::parse(&empty).expect("well-formed").sights, Some(Vec::new()));
    }

    #[test]
    fn what_is_missing_is_named() {
        for (name, missing) in [("(GYR", "(XYZ"), ("(ACC", "(XYZ"), ("(GS", "(XYZ")] {
            let error = Perception::parse(&MESSAGE.replace(name, missing)).expect_err("incomplete");
            assert!(error.to_string().contains("it has no"), "{error}");
        }
    }
}
