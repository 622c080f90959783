//! Obstacles near the ball.

use bica::prelude::*;
use glam::Vec2;
use heapless::Vec;

/// Distances that robot and ball keep from obstacles.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Clearance {
    /// Radius of the ball plus the uncertainty of its path.
    #[param(default = 0.06, range = 0.03..=0.3, unit = "m", step = 0.01)]
    pub ball_path_radius: f32,
    /// Radius of the free area that the robot needs for a kick: its shoulders, or its feet with the steps to the ball.
    #[param(default = 0.15, range = 0.05..=0.4, unit = "m", step = 0.01)]
    pub body_radius: f32,
    /// Largest distance of an obstacle from the ball that counts; farther robots will have moved by then.
    #[param(default = 0.8, range = 0.2..=4.0, unit = "m", step = 0.1)]
    pub obstacle_distance: f32,
    /// Radius of another robot: half of its width, less the compliance of its arms.
    #[param(default = 0.12, range = 0.05..=0.4, unit = "m", step = 0.01)]
    pub robot_radius: f32,
    /// Distance from the toes of a robot, which are detected, to its middle.
    #[param(default = 0.08, range = 0.0..=0.3, unit = "m", step = 0.01)]
    pub robot_toe_distance: f32,
    /// Radius of the path around the ball that is tested for obstacles. It should equal `GoRound.radius`.
    #[param(default = 0.24, range = 0.15..=1.0, unit = "m", step = 0.01)]
    pub way_round_radius: f32,
}

/// Circular obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Obstacle {
    /// Centre in the ground frame, m.
    pub(super) at: Vec2,
    /// Radius, m.
    pub(super) radius: f32,
}

/// Two goal posts and all remembered robots.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Obstacles(pub(super) Vec<Obstacle, 6>);

impl Obstacles {
    /// Whether the robot can stand at a position in the ground frame, m.
    pub(super) fn allow_stand(&self, place: Vec2, clearance: &Clearance) -> bool {
        self.0.iter().all(|obstacle| obstacle.at.distance(place) > obstacle.radius + clearance.body_radius)
    }

    /// Whether a ball can be kicked along the vector `path`, m. Obstacles behind the ball and beyond the end of the path
    /// have no effect.
    pub(super) fn allow_kick(&self, ball: Vec2, path: Vec2, clearance: &Clearance) -> bool {
        let ahead = path.normalize_or_zero();
        self.0.iter().all(|obstacle| {
            let off = obstacle.at - ball;
            let counts = (0.0..clearance.obstacle_distance).contains(&off.dot(ahead));
            let before = counts && off.dot(ahead) < path.length();
            !before || libm::fabsf(off.perp_dot(ahead)) > obstacle.radius + clearance.ball_path_radius
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_distance_of_the_clearance_counts() {
        let robot = Obstacle { at: Vec2::new(0.7, 0.2), radius: 0.12 };
        let obstacles = Obstacles([robot].into_iter().collect());
        let kick = |clearance: &Clearance| obstacles.allow_kick(Vec2::ZERO, Vec2::new(2.0, 0.0), clearance);
        assert!(kick(&Clearance::DEFAULT));
        let wide = Clearance { ball_path_radius: 0.1, ..Clearance::DEFAULT };
        assert!(!kick(&wide));
        assert!(kick(&Clearance { obstacle_distance: 0.6, ..wide }), "the robot is too far away to count");
        let place = Vec2::new(0.7, -0.1);
        assert!(obstacles.allow_stand(place, &Clearance::DEFAULT));
        assert!(!obstacles.allow_stand(place, &Clearance { body_radius: 0.2, ..Clearance::DEFAULT }));
    }
}
