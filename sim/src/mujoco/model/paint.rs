//! XML of materials, background and lamps.

use std::fmt::Write;

use glam::Vec3;

use crate::camera::light::Light;
use crate::camera::palette::{BLUE_TEAM, CARPET, JOINT, LINE, ORANGE, RED_TEAM, Rgb, SHELL, SKY_BLUE, WHITE, YELLOW};
use crate::layout::Layout;
use bica_field::GoalColour;

/// Colours of a game.
pub(crate) struct Paint {
    attacked: Rgb,
    own: Rgb,
    team: Rgb,
    opponents: Rgb,
}

impl Paint {
    /// Returns the colours of a layout: the team that defends the yellow goal plays in red, the other in blue (rules of 2009).
    pub(crate) fn of(layout: &Layout) -> Self {
        Self::attacking(layout.attacks)
    }

    /// Returns the colours of a game in which the goal at positive x has a colour.
    pub(crate) fn attacking(attacks: GoalColour) -> Self {
        let both = |colour| match colour {
            GoalColour::Yellow => (YELLOW, RED_TEAM),
            GoalColour::SkyBlue => (SKY_BLUE, BLUE_TEAM),
        };
        let ((attacked, opponents), (own, team)) = (both(attacks), both(attacks.other()));
        Self { attacked, own, team, opponents }
    }

    /// Writes the materials of field, ball, goals and robots.
    pub(crate) fn write(&self, xml: &mut String) {
        let materials = [
            ("carpet", CARPET),
            ("line", LINE),
            ("ball", ORANGE),
            ("attacked", self.attacked),
            ("own", self.own),
            ("net", WHITE),
            ("floor", Rgb::new(0.42, 0.40, 0.38)),
            ("opponents", self.opponents),
            ("mates", self.team),
            ("shells", SHELL),
            ("joints", JOINT),
        ];
        for (name, Rgb { x, y, z }) in materials {
            let _ = writeln!(xml, "<material name=\"{name}\" rgba=\"{x} {y} {z} 1\" specular=\"0\" shininess=\"0\"/>");
        }
    }
}

/// Rendering options for the robot's cameras. Multisampling and shadows would take most of the time of a software renderer.
pub(crate) const RENDER_OPTIONS: &str = "<statistic center=\"0 0 0.3\" extent=\"1\"/>\n<visual>\n\
    <global offwidth=\"1280\" offheight=\"960\"/>\n<quality offsamples=\"0\" shadowsize=\"0\"/>\n\
    <map znear=\"0.02\" zfar=\"40\"/>\n\
    <headlight ambient=\"0.74 0.74 0.74\" diffuse=\"0 0 0\" specular=\"0 0 0\"/>\n</visual>\n";

/// Background texture.
pub(crate) const BACKGROUND: &str = "<texture name=\"hall\" type=\"skybox\" builtin=\"gradient\" rgb1=\"0.62 0.62 0.64\" \
    rgb2=\"0.40 0.39 0.38\" width=\"64\" height=\"384\"/>\n";

/// Returns MJCF in which the material `team` is replaced by that of a team's robots.
pub(crate) fn in_team_colour(xml: &str, teammate: bool) -> String {
    xml.replace("\"team\"", if teammate { "\"mates\"" } else { "\"opponents\"" })
}

/// Returns the colour of the robot's own team.
pub(crate) fn team(layout: &Layout) -> Rgb {
    Paint::of(layout).team
}

/// Writes a lamp above and one on the brighter side. With the ambient light a horizontal surface has about its own
/// colour, and a surface in the shade three quarters of it, as in the kinematic simulator.
pub(crate) fn lamps(xml: &mut String, light: Light) {
    let Vec3 { x, y, z } = -light.from;
    for (direction, strength) in [((0.0, 0.0, -1.0), 0.17), ((x, y, z), 0.2)] {
        let (x, y, z) = direction;
        let _ = writeln!(
            xml,
            "<light type=\"directional\" pos=\"0 0 4\" dir=\"{x} {y} {z}\" castshadow=\"false\" \
             diffuse=\"{strength} {strength} {strength}\" specular=\"0.1 0.1 0.1\"/>"
        );
    }
}
