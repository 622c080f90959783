//! A field with the robots of two teams.

use core::f32::consts::PI;

use bica_core::action::Actions;
use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::{Command, Sensors};
use glam::{Affine3A, Vec2};

use crate::kinematic::{KinematicWorld, PosedRobot};
use crate::referee::{Event, Posture, Referee};
use crate::setup::{Setup, SetupError, Start};
use crate::world::World;

/// A robot at the start of a match.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entrant {
    /// Team: whether it is the second one, which attacks the other goal.
    pub is_second: bool,
    /// Pose in the frame of the field of its own team: x towards the goal that the team attacks.
    pub at: Pose2,
}

/// Another robot on the field, in the frame of a world.
#[derive(Clone, Copy, Debug)]
pub struct Other {
    /// Pose on the ground.
    pub(crate) pose: Pose2,
    /// Its parts.
    pub(crate) posed: PosedRobot,
    /// Whether it lies.
    pub(crate) is_down: bool,
    /// Whether it belongs to the team of the world's robot.
    pub(crate) is_teammate: bool,
}

impl Other {
    /// A robot in the frame of its own team, or, `turned`, in that of the other one. `robot`: pose of the robot frame.
    pub(crate) fn new(
        model: &'static SimulatedModel,
        (robot, skeleton): (Affine3A, &Skeleton),
        truth: &Referee,
        turned: bool,
    ) -> Self {
        let turn = if turned { Affine3A::from_rotation_z(PI) } else { Affine3A::IDENTITY };
        let pose = truth.robot();
        Self {
            pose: if turned { Pose2 { position: -pose.position, heading: wrap(pose.heading + PI) } } else { pose },
            posed: PosedRobot::new(model, turn * robot, skeleton),
            is_down: matches!(truth.posture(), Posture::Down(_)),
            is_teammate: !turned,
        }
    }
}

/// World of one robot of a match, in the frame of its team.
pub trait MatchWorld: World {
    /// The world for a call in another thread; `None` if it must stay in the thread that has built it.
    fn as_send(&mut self) -> Option<&mut (dyn MatchWorld + Send)>;

    /// Whether the robot has touched the ball in the last cycle.
    fn touches(&self) -> bool;

    /// Position and velocity of the ball, m and m/s.
    fn ball(&self) -> [Vec2; 2];

    /// Sets position and velocity of the ball: another robot has moved it.
    fn follow_ball(&mut self, ball: [Vec2; 2]);

    /// Cancels the return of the ball into play: an operator has placed it.
    fn cancel_return(&mut self);

    /// The robot as another one on the field, in the frame of the own team, or, `turned`, in that of the other one.
    fn as_other(&self, turned: bool) -> Other;

    /// Sets the other robots on the field, as obstacles, for the referee and in the next image.
    fn set_others(&mut self, others: &[Other]);
}

/// A field with several robots that move. Each has a world of its own, in the frame of its team, in which the others are obstacles
/// and are seen; the ball is one. Robots do not push each other over: in the built-in world a robot that overlaps another one is moved
/// out of it, in MuJoCo the others are bodies that nothing moves.
pub struct MatchField {
    worlds: Vec<Box<dyn MatchWorld>>,
    entrants: Vec<Entrant>,
    /// Index of the world whose robot has touched the ball last: its ball is that of all worlds.
    owner: usize,
}

impl MatchField {
    /// Builds a field of the built-in world in its start state, with the ball at the centre. The seed of a robot is that of `setup` plus
    /// its index; start positions, goalkeeper and number of robots of `setup` have no effect.
    ///
    /// # Errors
    /// If a robot does not fit at its pose.
    pub fn new(model: &'static SimulatedModel, setup: &Setup, entrants: &[Entrant]) -> Result<Self, SetupError> {
        Self::of(setup, entrants, |setup, _| Ok(Box::new(KinematicWorld::new(model, setup)?)))
    }

    /// Builds a field as [`new`](Self::new) does, with the dynamics of MuJoCo.
    ///
    /// # Errors
    /// If a robot does not fit at its pose, MuJoCo rejects the model, or no renderer is available.
    #[cfg(feature = "mujoco")]
    pub fn in_mujoco(
        model: &'static SimulatedModel,
        setup: &Setup,
        entrants: &[Entrant],
    ) -> Result<Self, crate::mujoco::Error> {
        Self::of(setup, entrants, |setup, mates| {
            Ok(Box::new(crate::mujoco::MujocoWorld::in_match(model, setup, mates)?))
        })
    }

    /// Builds the worlds from their setups, and whether each of the others is a teammate.
    fn of<E>(
        setup: &Setup,
        entrants: &[Entrant],
        build: impl Fn(&Setup, &[bool]) -> Result<Box<dyn MatchWorld>, E>,
    ) -> Result<Self, E> {
        let attacks = setup.attacks.unwrap_or(bica_field::GoalColour::Yellow);
        let world = |(index, entrant): (usize, &Entrant)| {
            let setup = Setup {
                seed: setup.seed.wrapping_add(index as u64),
                goalkeeper: false,
                robots: 0,
                start: Some(Start { robot: entrant.at, ball: Vec2::ZERO }),
                attacks: Some(if entrant.is_second { attacks.other() } else { attacks }),
                ..*setup
            };
            let others = entrants.iter().enumerate().filter(|(other, _)| *other != index);
            build(&setup, &others.map(|(_, other)| other.is_second == entrant.is_second).collect::<Vec<_>>())
        };
        let worlds = entrants.iter().enumerate().map(world).collect::<Result<_, _>>()?;
        let mut field = Self { worlds, entrants: entrants.to_vec(), owner: 0 };
        field.share_robots();
        Ok(field)
    }

    /// Number of robots.
    #[must_use]
    pub const fn robots(&self) -> usize {
        self.worlds.len()
    }

    /// The worlds of all robots, to read their sensors side by side. Only [`act`](Self::act) may act in them.
    pub fn worlds_mut(&mut self) -> &mut [Box<dyn MatchWorld>] {
        &mut self.worlds
    }

    /// Sensor values of a robot.
    ///
    /// # Panics
    /// If there is no robot with this index.
    pub fn sensors(&mut self, robot: usize) -> Sensors<'_> {
        self.worlds[robot].sensors()
    }

    /// Truth of a robot in the frame of its own team.
    ///
    /// # Panics
    /// If there is no robot with this index.
    #[must_use]
    pub fn truth(&self, robot: usize) -> &Referee {
        self.worlds[robot].referee()
    }

    /// Whether a robot belongs to the second team.
    ///
    /// # Panics
    /// If there is no robot with this index.
    #[must_use]
    pub fn is_second(&self, robot: usize) -> bool {
        self.entrants[robot].is_second
    }

    /// Whether a robot lies.
    ///
    /// # Panics
    /// If there is no robot with this index.
    #[must_use]
    pub fn is_down(&self, robot: usize) -> bool {
        matches!(self.truth(robot).posture(), Posture::Down(_))
    }

    /// Goals of the first team and of the second one.
    #[must_use]
    pub fn score(&self) -> [usize; 2] {
        let Some(first) = self.worlds.first() else { return [0; 2] };
        let goals = |event: &Event| matches!(event, Event::Goal);
        let own_goals = |event: &Event| matches!(event, Event::OwnGoal);
        let counts = [first.referee().count(goals), first.referee().count(own_goals)];
        if self.entrants[0].is_second { [counts[1], counts[0]] } else { counts }
    }

    /// Executes one command of each robot for one control cycle. A robot without a command keeps its posture.
    pub fn act(&mut self, commands: &[Command]) {
        for (world, command) in self.worlds.iter_mut().zip(commands) {
            world.act(command);
        }
        let touching = self.worlds.iter().position(|world| world.touches());
        self.share_ball_of(touching.unwrap_or(self.owner));
        self.share_robots();
    }

    /// Reason why the match cannot continue; `None` if it can.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        self.worlds.iter().find_map(|world| world.failure())
    }

    /// Gives all worlds the ball of one of them.
    fn share_ball_of(&mut self, moved: usize) {
        let Some(world) = self.worlds.get(moved) else { return };
        self.owner = moved;
        let (ball, side) = (world.ball(), self.entrants[moved].is_second);
        for (index, world) in self.worlds.iter_mut().enumerate().filter(|(index, _)| *index != moved) {
            let is_turned = self.entrants[index].is_second != side;
            world.follow_ball(if is_turned { ball.map(|vector| -vector) } else { ball });
        }
    }

    /// Shows each robot to all others.
    fn share_robots(&mut self) {
        for index in 0..self.worlds.len() {
            let own = self.entrants[index].is_second;
            let others = self.worlds.iter().zip(&self.entrants).enumerate().filter(|(other, _)| *other != index);
            let others: Vec<Other> =
                others.map(|(_, (world, entrant))| world.as_other(entrant.is_second != own)).collect();
            self.worlds[index].set_others(&others);
        }
    }

    /// Puts a robot on its feet at a pose in the frame of its own team, as people do who carry it.
    ///
    /// # Errors
    /// If the pose is beyond the lines, or a post, the ball or a robot is there.
    ///
    /// # Panics
    /// If there is no robot with this index.
    pub fn put_robot(&mut self, robot: usize, at: Pose2) -> Result<(), &'static str> {
        self.worlds[robot].put_robot(at)?;
        self.share_robots();
        Ok(())
    }

    /// Puts the ball at a position, m, in the frame of the first robot's team, at rest.
    ///
    /// # Errors
    /// If the position is beyond the lines, or a post or a robot is there.
    pub fn put_ball(&mut self, at: Vec2) -> Result<(), &'static str> {
        let Some(first) = self.worlds.first_mut() else { return Ok(()) };
        first.put_ball(at)?;
        self.share_ball_of(0);
        Ok(())
    }

    /// Lets an operator act in the world of a robot, in the frame of its team; the other worlds follow.
    ///
    /// # Panics
    /// If there is no robot with this index.
    pub fn operate<T>(&mut self, robot: usize, act: impl FnOnce(&mut dyn Actions) -> T) -> T {
        let before = self.worlds[robot].ball();
        let done = act(self.worlds[robot].actions());
        if self.worlds[robot].ball() != before {
            self.worlds.iter_mut().for_each(|world| world.cancel_return());
            self.share_ball_of(robot);
        }
        self.share_robots();
        done
    }
}

#[cfg(test)]
mod tests {
    use bica_core::Value;
    use bica_core::action::perform;

    use super::*;
    use crate::TEST_MODEL;
    use crate::setup::Frame;

    fn field(entrants: &[Entrant]) -> MatchField {
        let setup = Setup { frame: Frame::Small, ..Setup::default() };
        MatchField::new(TEST_MODEL, &setup, entrants).expect("there is room")
    }

    fn standing() -> Command {
        Command::new(TEST_MODEL.stand, 1.0)
    }

    const MATES: [Entrant; 3] = [
        Entrant { is_second: false, at: Pose2::new(-1.0, 0.0, 0.0) },
        Entrant { is_second: false, at: Pose2::new(-2.0, 1.0, 0.5) },
        Entrant { is_second: true, at: Pose2::new(-1.0, 0.5, 0.0) },
    ];

    #[test]
    fn each_robot_has_the_others_in_its_own_frame() {
        let field = field(&MATES);
        let places = |robot: usize| field.truth(robot).others().iter().map(|other| other.position).collect::<Vec<_>>();
        let is_near = |places: Vec<Vec2>, expected: [Vec2; 2]| {
            places.len() == 2 && places.iter().zip(expected).all(|(place, expected)| place.distance(expected) < 0.05)
        };
        assert!(is_near(places(0), [Vec2::new(-2.0, 1.0), Vec2::new(1.0, -0.5)]), "{:?}", places(0));
        assert!(is_near(places(2), [Vec2::new(1.0, 0.0), Vec2::new(2.0, -1.0)]), "{:?}", places(2));
        assert_ne!(field.truth(0).attacks(), field.truth(2).attacks());
    }

    #[test]
    fn ball_is_one_for_all() {
        let mut field = field(&MATES);
        field.put_ball(Vec2::new(0.5, 0.4)).expect("a free place");
        field.worlds[0].follow_ball([Vec2::new(0.5, 0.4), Vec2::X]);
        for _ in 0..100 {
            field.act(&[standing(); 3]);
        }
        let balls = [0, 1, 2].map(|robot| field.truth(robot).ball());
        assert!(balls[0].x > 1.0 && balls[0] == balls[1] && balls[2] == -balls[0], "{balls:?}");
    }

    #[test]
    fn operator_places_the_ball_for_all_robots() {
        let mut field = field(&MATES);
        field.worlds[0].follow_ball([Vec2::new(2.5, 1.5), Vec2::new(2.5, 0.0)]);
        let stand = |field: &mut MatchField, cycles| (0..cycles).for_each(|_| field.act(&[standing(); 3]));
        stand(&mut field, 60);
        assert_eq!(field.truth(0).outs(), 1, "the referee is about to return it");
        let at = [1.0, 0.5].map(Value::F32);
        field.operate(2, |world| perform(Some(world), "place_ball", &at)).expect("a free place");
        stand(&mut field, 500);
        let balls = [0, 1, 2].map(|robot| field.truth(robot).ball());
        assert_eq!(balls, [Vec2::new(-1.0, -0.5), Vec2::new(-1.0, -0.5), Vec2::new(1.0, 0.5)]);
        let refused = field.operate(0, |world| perform(Some(world), "place_ball", &[-2.0, 1.0].map(Value::F32)));
        assert!(refused.is_err_and(|refusal| refusal.to_string().contains("robot")), "a teammate is there");
    }

    #[test]
    fn robots_that_overlap_are_moved_apart() {
        let near = Entrant { at: Pose2::new(-1.1, 0.05, 0.0), ..MATES[0] };
        let mut field = field(&[MATES[0], near]);
        for _ in 0..50 {
            field.act(&[standing(); 2]);
        }
        let apart = field.truth(0).robot().position.distance(field.truth(1).robot().position);
        assert!(apart > 0.15, "{apart} m");
    }

    #[test]
    fn goals_count_for_the_team_that_attacks() {
        let mut field = field(&MATES);
        for (velocity, score) in [(Vec2::new(2.5, 0.0), [1, 0]), (Vec2::new(-2.5, 0.0), [1, 1])] {
            field.worlds[0].follow_ball([Vec2::new(velocity.x.signum() * 2.5, 0.3), velocity]);
            for _ in 0..400 {
                field.act(&[standing(); 3]);
            }
            assert_eq!(field.score(), score);
        }
    }
}
