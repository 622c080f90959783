//! XML of the other robots: static bodies.

use std::fmt::Write;

use crate::layout::OtherRobot;

/// Writes a robot that stands still.
pub(crate) fn write(xml: &mut String, other: &OtherRobot) {
    let (at, heading) = (other.pose.position, other.pose.heading);
    let team = if other.teammate { "mates" } else { "opponents" };
    let _ = writeln!(xml, "<body pos=\"{} {} 0\" euler=\"0 0 {heading}\">", at.x, at.y);
    let contact = "contype=\"8\" conaffinity=\"33\" friction=\"0.5 0.005 0.0001\"";
    let mut part = |shape: &str, material: &str| {
        let _ = writeln!(xml, "<geom {shape} material=\"{material}\" {contact}/>");
    };
    part("type=\"ellipsoid\" size=\"0.05 0.064 0.088\" pos=\"0 0 0.347\"", "shells");
    part("type=\"capsule\" size=\"0.043\" fromto=\"0 -0.037 0.388 0 0.037 0.388\"", "shells");
    part("type=\"ellipsoid\" size=\"0.053 0.063 0.03\" pos=\"-0.002 0 0.298\"", team);
    part("type=\"box\" size=\"0.03 0.05 0.03\" pos=\"-0.005 0 0.24\"", "joints");
    part("type=\"ellipsoid\" size=\"0.051 0.058 0.056\" pos=\"0 0 0.482\"", "shells");
    for y in [1.0, -1.0] {
        let y = |left: f32| y * left;
        part(&format!("type=\"capsule\" size=\"0.028\" fromto=\"0 {} 0.4 0.01 {} 0.3\"", y(0.1), y(0.118)), "shells");
        part(&format!("type=\"capsule\" size=\"0.024\" fromto=\"0.01 {} 0.3 0.03 {} 0.2\"", y(0.118), y(0.11)), team);
        part(&format!("type=\"capsule\" size=\"0.035\" fromto=\"0 {} 0.2 0.045 {} 0.14\"", y(0.05), y(0.05)), "shells");
        part(
            &format!("type=\"capsule\" size=\"0.032\" fromto=\"0.045 {} 0.13 -0.01 {} 0.06\"", y(0.05), y(0.05)),
            "shells",
        );
        part(&format!("type=\"box\" size=\"0.075 0.043 0.025\" pos=\"0.02 {} 0.025\"", y(0.0555)), team);
    }
    xml.push_str("</body>\n");
}
