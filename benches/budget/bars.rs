//! Bar chart of the report, for the documentation.

use std::fmt::Write;

use crate::report::Report;
use bica_times::limits::Row;

const WIDTH: f64 = 860.0;
const LINE: f64 = 20.0;
/// Left and right end of the bars, px.
const LEFT: f64 = 130.0;
const RIGHT: f64 = 700.0;
/// First and last decade of the logarithmic axis, as powers of ten of 1 µs: 10 ns to 1 s.
const DECADES: (i32, i32) = (-2, 6);
const TOP: f64 = 62.0;

/// Draws the median, the slowest run and the declared budget of each component on a logarithmic time axis.
pub(crate) fn draw(report: &Report) -> String {
    let rows: Vec<&Row> = std::iter::once(&report.chain).chain(&report.rows).filter(|row| row.time.is_some()).collect();
    let bottom = TOP + LINE * rows.len() as f64;
    let height = bottom + 12.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    );
    legend(&mut svg, report);
    axis(&mut svg, bottom);
    for (place, row) in rows.iter().enumerate() {
        bar(&mut svg, row, TOP + LINE * place as f64);
    }
    let x = axis_x(report.deadline);
    let _ = writeln!(svg, "<path d=\"M{x:.1} {TOP}V{bottom}\" stroke=\"#c0392b\" stroke-width=\"2\"/>");
    svg.push_str("</svg>\n");
    svg
}

fn legend(svg: &mut String, report: &Report) {
    let (width, height) = report.size;
    let _ = writeln!(
        svg,
        "<text x=\"10\" y=\"20\" font-weight=\"bold\">One run of each component, {width}×{height}</text>\n\
         <rect x=\"300\" y=\"10\" width=\"16\" height=\"12\" fill=\"#2e6f40\"/><text x=\"321\" y=\"20\">median</text>\n\
         <rect x=\"380\" y=\"10\" width=\"16\" height=\"12\" fill=\"#8fc79f\"/><text x=\"401\" y=\"20\">slowest run</text>\n\
         <rect x=\"488\" y=\"10\" width=\"16\" height=\"12\" fill=\"none\" stroke=\"#555555\"/>\
         <text x=\"509\" y=\"20\">declared</text>\n\
         <path d=\"M578 9V23\" stroke=\"#c0392b\" stroke-width=\"2\"/><text x=\"585\" y=\"20\">deadline {:.0} ms</text>\n\
         <text x=\"{:.0}\" y=\"{:.0}\" text-anchor=\"end\">slowest / declared</text>",
        report.deadline * 1e-3,
        WIDTH - 10.0,
        TOP - 9.0
    );
}

fn axis(svg: &mut String, bottom: f64) {
    for decade in DECADES.0..=DECADES.1 {
        let us = 10_f64.powi(decade);
        let label = match decade {
            ..0 => format!("{:.0} ns", us * 1e3),
            0..3 => format!("{us:.0} µs"),
            3..6 => format!("{:.0} ms", us * 1e-3),
            _ => format!("{:.0} s", us * 1e-6),
        };
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} {TOP}V{bottom}\" stroke=\"#dddddd\"/>\
             <text x=\"{x:.1}\" y=\"{y:.0}\" text-anchor=\"middle\" fill=\"#555555\">{label}</text>",
            x = axis_x(us),
            y = TOP - 9.0
        );
    }
}

fn bar(svg: &mut String, row: &Row, y: f64) {
    let Some(time) = row.time else { return };
    let (top, high) = (y + 4.0, LINE - 8.0);
    let _ =
        writeln!(svg, "<text x=\"{:.0}\" y=\"{:.0}\" text-anchor=\"end\">{}</text>", LEFT - 8.0, y + 14.0, row.name);
    let over = row.budget.is_some_and(|budget| time.max > budget);
    for (us, colour) in [(time.max, if over { "#c0392b" } else { "#8fc79f" }), (time.p50, "#2e6f40")] {
        let long = axis_x(us) - LEFT;
        let _ =
            writeln!(svg, "<rect x=\"{LEFT}\" y=\"{top}\" width=\"{long:.1}\" height=\"{high}\" fill=\"{colour}\"/>");
    }
    if let Some(budget) = row.budget {
        let _ = writeln!(
            svg,
            "<rect x=\"{LEFT}\" y=\"{:.0}\" width=\"{:.1}\" height=\"{:.0}\" fill=\"none\" stroke=\"#555555\"/>\n\
             <text x=\"{:.0}\" y=\"{:.0}\">{} of {budget} µs</text>",
            top - 2.0,
            axis_x(budget) - LEFT,
            high + 4.0,
            RIGHT + 12.0,
            y + 14.0,
            short(time.max)
        );
    }
}

/// Position of a time on the axis, px.
fn axis_x(us: f64) -> f64 {
    let (from, to) = (f64::from(DECADES.0), f64::from(DECADES.1));
    LEFT + (RIGHT - LEFT) * ((us.log10() - from) / (to - from)).clamp(0.0, 1.0)
}

fn short(us: f64) -> String {
    if us < 9.95 { format!("{us:.1}") } else { format!("{us:.0}") }
}
