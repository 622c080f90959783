//! XML of soft shadows on the carpet: flat discs below feet, torso and ball. A software renderer needs seconds for
//! MuJoCo's own shadows.

use std::fmt::Write;

/// Half length and half width of the shadows of left foot, right foot, torso and ball, m.
const SIZES: [(f32, f32); 4] = [(0.1, 0.062), (0.1, 0.062), (0.15, 0.15), (0.045, 0.045)];
/// Opacity of a layer; each layer is smaller and slightly higher than the previous one.
const OPACITY: f32 = 0.11;
/// Scale of each layer.
const LAYERS: [f32; 4] = [1.1, 0.95, 0.8, 0.65];
/// Height of the lowest layer, above the lines, m.
const HEIGHT: f32 = 0.0013;

/// Number of shadows: left foot, right foot, torso, ball.
pub(crate) const SHADOWS: usize = SIZES.len();

/// Writes the shadows in this order, as mocap bodies.
pub(crate) fn write(xml: &mut String) {
    for (length, width) in SIZES {
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
