//! Eyes of a robot whose program takes directions and distances: they make them of camera images.

use bica_camera::Images;
use bica_field::FIELD;
use bica_motion::joints::Joints;
use bica_motion::model::RobotModel;
use bica_motion::robot::{CameraId, Image};
use bica_motion::side::Side;
use bica_player::league::FIELD as LEAGUE;
use bica_player::league::senses::{Object, SIGHTS, Sight, View};
use bica_vision::frame::Frame;
use bica_vision::goal::GoalFinder;
use bica_vision::own_body::OwnBody;
use bica_vision::pipeline::Pipeline;
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;
use glam::Vec2;

/// Images, and the detectors that look at them.
pub(crate) struct Eyes {
    images: Images,
    detectors: Box<Detectors>,
    cycles: u32,
}

/// The detectors, for the ball and the goals of 2009 in the built-in colours.
struct Detectors {
    all: Pipeline<512, 512>,
    /// The goal of a tall robot's image lies below the horizon: with the pose of the camera it would be rejected.
    goals: GoalFinder<512>,
}

impl Detectors {
    const fn new() -> Self {
        Self { all: Pipeline::new(FIELD.ball_radius()), goals: GoalFinder::new() }
    }
}

impl Eyes {
    /// Eyes that look at these images.
    pub(crate) fn new(images: Images) -> Self {
        Self { images, detectors: Box::new(Detectors::new()), cycles: 0 }
    }

    /// What is in a new image of this cycle; `None` without one.
    pub(crate) fn look(&mut self, model: &'static RobotModel, angles: &Joints) -> Option<View> {
        self.cycles = self.cycles.saturating_add(1);
        let frame = self.images.take(CameraId::Top, self.cycles, false)?;
        view(&mut self.detectors, model, angles, &frame.image())
    }
}

/// The ball, both posts of the yellow goal, which the robot attacks, and other robots; `None` if the image cannot be used.
fn view(detectors: &mut Detectors, model: &'static RobotModel, angles: &Joints, image: &Image<'_>) -> Option<View> {
    let frame = Frame::from_image(image).ok()?;
    let camera = Camera::of(model, image.camera, angles, Side::Left, image.width, image.height);
    let own = OwnBody::of(model, &camera, image.camera, angles);
    let seen = detectors.all.detect_with_body(&frame, &BUILT_IN_TABLE, Some(&camera), &own);
    let sight = |object, place: Vec2, height: f32| {
        let at = camera.pose().inverse().transform_point3(place.extend(height));
        Sight { object, at: at.into() }
    };
    let radius = FIELD.ball_radius();
    let ball = seen.ball.and_then(|ball| ball.ground(&camera, radius)).map(|at| sight(Object::Ball, at, radius));
    let goals = detectors.goals.find(&frame, &BUILT_IN_TABLE, &seen.boundary, None);
    let goal = goals.yellow.and_then(|goal| Some([goal.first, goal.second?]));
    let posts = goal.into_iter().flat_map(|posts| posts.into_iter().zip(LEAGUE.goal_posts(true)));
    let posts = posts.filter_map(|(post, Vec2 { x, y })| {
        let place = post.ground(&camera)?;
        Some(sight(Object::Mark([x, y, 0.0]), place, 0.0))
    });
    let robots = seen.robots.iter().filter_map(|robot| Some(sight(Object::Robot, robot.ground(&camera)?, 0.0)));
    Some(ball.into_iter().chain(posts).chain(robots).take(SIGHTS).collect())
}

#[cfg(test)]
mod tests {
    use bica_field::GoalColour;
    use bica_motion::model::simulation::T1;
    use bica_motion::pose::Pose2;
    use bica_sim::World;
    use bica_sim::kinematic::KinematicWorld;
    use bica_sim::setup::{Frame as Size, Setup, Start};

    use super::*;

    #[test]
    fn ball_and_posts_are_where_the_world_has_them() {
        let (robot, ball) = (Pose2::new(-1.5, 0.0, 0.0), Vec2::new(1.5, 0.2));
        let start = Some(Start { robot, ball });
        let setup = Setup {
            seed: 4,
            frame: Size::Large,
            start,
            goalkeeper: false,
            attacks: Some(GoalColour::Yellow),
            ..Setup::default()
        };
        let mut world = KinematicWorld::new(T1, &setup).expect("a valid start");
        let (robot, ball) = (world.referee().robot(), world.referee().ball());
        let sensors = world.sensors();
        let image = sensors.image.expect("an image in the first cycle");
        let seen = view(&mut Detectors::new(), T1.robot, &sensors.angles, &image).expect("a view");
        let camera = Camera::of(T1.robot, image.camera, &sensors.angles, Side::Left, image.width, image.height);
        let place = |wanted: Object| {
            let sight = seen.iter().find(|sight| sight.object == wanted)?;
            let on_ground = camera.pose().transform_point3(sight.at.into()).truncate();
            Some(robot.place(on_ground))
        };
        let at = place(Object::Ball).expect("the ball");
        assert!(at.distance(ball) < 0.1, "{at} instead of {ball}");
        for (mark, post) in LEAGUE.goal_posts(true).into_iter().zip(FIELD.goal_posts(true)) {
            let at = place(Object::Mark([mark.x, mark.y, 0.0])).expect("a post");
            assert!(at.distance(post) < 0.3, "{at} instead of {post}");
        }
    }
}
