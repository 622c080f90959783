//! Picture of a world's figures: median, slowest run and declared budget, on a logarithmic time axis.

use std::fmt::Write;

use super::figures::{Figures, Row};

const WIDTH: f64 = 860.0;
const LINE: f64 = 20.0;
const TOP: f64 = 62.0;
const LEFT: f64 = 130.0;
const RIGHT: f64 = 700.0;
const GREEN: &str = "#2e6f40";
const PALE: &str = "#8fc79f";
const RED: &str = "#c0392b";
const GREY: &str = "#555555";
/// Decades of the axis; it begins at 10 ns.
const TICKS: [&str; 9] = ["10 ns", "100 ns", "1 µs", "10 µs", "100 µs", "1 ms", "10 ms", "100 ms", "1 s"];

/// Returns the picture as SVG.
pub(super) fn draw(figures: &Figures) -> String {
    let rows: Vec<_> = figures.components.iter().chain(figures.phases.last()).filter(|row| row.runs > 0).collect();
    let bottom = TOP + LINE * rows.len() as f64;
    let frame = format!("stroke=\"{GREY}\" fill=\"none\"");
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>",
        height = bottom + 12.0
    );
    let title = format!("One run of each component of {} in {}", figures.robot, figures.world);
    text(&mut svg, 10.0, 20.0, &title, "font-weight=\"bold\"");
    for (x, paint, label) in [
        (360.0, format!("fill=\"{GREEN}\""), "median"),
        (430.0, format!("fill=\"{PALE}\""), "slowest run"),
        (530.0, frame.clone(), "declared"),
    ] {
        bar(&mut svg, x, 10.0, 16.0, 12.0, &paint);
        text(&mut svg, x + 21.0, 20.0, label, "");
    }
    text(&mut svg, WIDTH - 10.0, TOP - 9.0, "slowest / declared", "text-anchor=\"end\"");
    for (decade, label) in TICKS.iter().enumerate() {
        let x = LEFT + (RIGHT - LEFT) * decade as f64 / 8.0;
        _ = write!(svg, "\n<path d=\"M{x:.1} {TOP}V{bottom}\" stroke=\"#dddddd\"/>");
        text(&mut svg, x, TOP - 9.0, label, &format!("text-anchor=\"middle\" fill=\"{GREY}\""));
    }
    for (place, row) in rows.iter().enumerate() {
        bars(&mut svg, TOP + LINE * place as f64, row, &frame);
    }
    if let Some(deadline) = figures.deadline_ms {
        let x = x_of(1e3 * f64::from(deadline));
        _ = write!(svg, "\n<path d=\"M{x:.1} {TOP}V{bottom}\" stroke=\"{RED}\" stroke-width=\"2\"/>");
        text(&mut svg, 620.0, 20.0, &format!("deadline {deadline} ms"), &format!("fill=\"{RED}\""));
    }
    svg + "\n</svg>\n"
}

fn bars(svg: &mut String, y: f64, row: &Row, frame: &str) {
    text(svg, LEFT - 8.0, y + 14.0, row.name, "text-anchor=\"end\"");
    let slowest = if row.exceeded().is_some() { RED } else { PALE };
    for (us, paint) in [(row.max_us, slowest), (row.p50_us, GREEN)] {
        bar(svg, LEFT, y + 4.0, x_of(us) - LEFT, LINE - 8.0, &format!("fill=\"{paint}\""));
    }
    if let Some(declared) = row.declared_us {
        bar(svg, LEFT, y + 2.0, x_of(declared) - LEFT, LINE - 4.0, frame);
        text(svg, RIGHT + 12.0, y + 14.0, &format!("{:.2} of {declared} µs", row.max_us), "");
    }
}

fn x_of(us: f64) -> f64 {
    LEFT + (RIGHT - LEFT) * ((us.log10() + 2.0) / 8.0).clamp(0.0, 1.0)
}

fn text(svg: &mut String, x: f64, y: f64, words: &str, more: &str) {
    let words = words.replace('&', "&amp;").replace('<', "&lt;");
    _ = write!(svg, "\n<text x=\"{x:.0}\" y=\"{y:.0}\" {more}>{words}</text>");
}

fn bar(svg: &mut String, x: f64, y: f64, width: f64, height: f64, paint: &str) {
    _ = write!(svg, "\n<rect x=\"{x}\" y=\"{y}\" width=\"{width:.1}\" height=\"{height}\" {paint}/>");
}
