//! Solids of the goals.

use glam::{Vec2, Vec3};

use super::solid::Solid;
use crate::camera::palette::{self, Palette};
use crate::field::{BAR_RADIUS, GOAL_BACK, GOAL_HEIGHT, GOAL_PANEL, POST, POST_RADIUS};
use bica_field::GoalColour;

/// Returns the solids of both goals. `attacked`: colour of the goal at positive x.
pub(crate) fn goals(attacked: GoalColour, palette: &Palette) -> Vec<Solid> {
    [(1.0, attacked), (-1.0, attacked.other())]
        .into_iter()
        .flat_map(|(end, colour)| goal(end, colour, palette))
        .collect()
}

fn goal(end: f32, colour: GoalColour, palette: &Palette) -> Vec<Solid> {
    let paint = palette.pixel(match colour {
        GoalColour::Yellow => palette::YELLOW,
        GoalColour::SkyBlue => palette::SKY_BLUE,
    });
    let white = palette.pixel(palette::WHITE);
    let at = |x: f32, y: f32, z: f32| Vec3::new(end * x, y, z);
    let top = GOAL_HEIGHT - BAR_RADIUS;
    let bar = [at(POST.x, -POST.y, top), at(POST.x, POST.y, top)];
    let back = [at(GOAL_BACK, POST.y, 0.0), at(GOAL_BACK, -POST.y, 0.0)];
    let mut parts = vec![
        Solid::Tube { ends: bar, radii: [BAR_RADIUS; 2], colour: paint },
        Solid::Net { corners: [bar[0], bar[1], back[0], back[1]], colour: white },
    ];
    for y in [-POST.y, POST.y] {
        let foot = at(POST.x, y, 0.0);
        let deep = at(POST.x + GOAL_PANEL, y, 0.0);
        let high = at(POST.x, y, GOAL_PANEL);
        let rear = at(GOAL_BACK, y, 0.0);
        let over = at(POST.x, y, GOAL_HEIGHT);
        parts.push(Solid::Shadow { centre: Vec2::new(foot.x, y), radius: 0.16, darkness: 0.35 });
        parts.push(Solid::Net { corners: [foot, rear, over, foot], colour: white });
        parts.push(Solid::Sheet { corners: [foot, deep, high], colour: white });
        parts.push(Solid::Tube { ends: [foot, over], radii: [POST_RADIUS; 2], colour: paint });
    }
    parts
}
