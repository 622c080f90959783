//! Soft shadows on the carpet: flat discs that follow what casts them. MuJoCo's own shadows cost a software renderer
//! seconds.

use std::fmt::Write;

/// Half the length and the width of the shadow of each foot, the torso and the ball, m.
const SIZES: [(f32, f32); 4] = [(0.1, 0.062), (0.1, 0.062), (0.15, 0.15), (0.045, 0.045)];
/// How dark each of the layers is; each one is smaller and a little higher than the one before.
const DARK: f32 = 0.11;
/// The size of each layer.
const LAYERS: [f32; 4] = [1.1, 0.95, 0.8, 0.65];
/// How high they lie: over the lines, m.
const RAISED: f32 = 0.0013;

/// How many shadows there are: left foot, right foot, torso, ball.
pub(crate) const SHADOWS: usize = SIZES.len();

/// Writes the shadows, in their order.
pub(crate) fn write(xml: &mut String) {
    for (length, width) in SIZES {
        let _ = writeln!(xml, "<body mocap=\"true\">");
        for (layer, scale) in LAYERS.iter().enumerate() {
            let _ = writeln!(
                xml,
                "<geom type=\"ellipsoid\" size=\"{} {} 0.0001\" pos=\"0 0 {}\" rgba=\"0 0.02 0 {DARK}\" contype=\"0\" \
                 conaffinity=\"0\"/>",
                length * scale,
                width * scale,
                RAISED + 0.0002 * layer as f32
            );
        }
        xml.push_str("</body>\n");
    }
}
