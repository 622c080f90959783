//! Colours and light.

use std::fmt::Write;

use crate::field::render::palette::{
    BLUE_TEAM, CARPET, JOINT, LINE, ORANGE, RED_TEAM, Rgb, SHELL, SKY_BLUE, WHITE, YELLOW,
};
use crate::field::start::Layout;
use crate::referee::GoalColour;

/// The colours of a game.
pub(crate) struct Paint {
    attacked: Rgb,
    own: Rgb,
    team: Rgb,
    opponents: Rgb,
}

impl Paint {
    /// The team that defends the yellow goal plays in red, the other in blue (rules of 2009).
    pub(crate) fn of(layout: &Layout) -> Self {
        let both = |colour| match colour {
            GoalColour::Yellow => (YELLOW, RED_TEAM),
            GoalColour::SkyBlue => (SKY_BLUE, BLUE_TEAM),
        };
        let ((attacked, opponents), (own, team)) = (both(layout.attacks), both(layout.attacks.other()));
        Self { attacked, own, team, opponents }
    }

    /// Materials and lamps. A level surface is lit so that it has its own colour; one in the shade two thirds of it.
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
        xml.push_str("<asset>\n");
        for (name, Rgb { x, y, z }) in materials {
            let _ = writeln!(xml, "<material name=\"{name}\" rgba=\"{x} {y} {z} 1\" specular=\"0\" shininess=\"0\"/>");
        }
        xml.push_str("</asset>\n");
    }
}
