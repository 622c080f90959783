//! XML of soft shadows on the carpet: flat discs below feet, torso and ball. A software renderer needs seconds for
//! MuJoCo's own shadows.

use std::fmt::Write;

use bica_motion::model::simulation::SimulatedModel;
use glam::Vec2;

/// Half length and half width of the shadow of the ball, m.
const BALL: Vec2 = Vec2::splat(0.045);
/// Opacity of a layer; each layer is smaller and slightly higher than the previous one.
const OPACITY: f32 = 0.11;
/// Scale of each layer.
const LAYERS: [f32; 4] = [1.1, 0.95, 0.8, 0.65];
/// Height of the lowest layer, above the lines, m.
const HEIGHT: f32 = 0.0013;

/// Number of shadows: left foot, right foot, torso, ball.
pub(crate) const SHADOWS: usize = 4;

/// Writes the shadows in this order, as mocap bodies.
pub(crate) fn write(model: &'static SimulatedModel, xml: &mut String) {
    let [foot, torso] = model.mujoco.shadows;
    let sizes: [Vec2; SHADOWS] = [foot, foot, torso, BALL];
    for Vec2 { x: length, y: width } in sizes {
        let _ = writeln!(xml, "<body mocap=\"true\">");
        for (layer, scale) in LAYERS.iter().enumerate() {
            let _ = writeln!(
                xml,
                "<geom type=\"ellipsoid\" size=\"{} {} 0.0001\" pos=\"0 0 {}\" rgba=\"0 0.02 0 {OPACITY}\" contype=\"0\" \
                 conaffinity=\"0\"/>",
                length * scale,
                width * scale,
                HEIGHT + 0.0002 * layer as f32
            );
        }
        xml.push_str("</body>\n");
    }
}
