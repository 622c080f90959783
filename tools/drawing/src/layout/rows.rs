//! Order and places of boxes in rows.

/// White at both ends of a row, px.
pub(super) const MARGIN: f64 = 8.0;
/// Passes over the rows that sort or move their boxes, downward and upward in turn.
const SWEEPS: usize = 8;

/// Links between boxes, by index.
pub(super) struct Graph {
    /// The boxes to which each one leads, each once.
    pub(super) targets: Vec<Vec<usize>>,
    /// The boxes with a link to each one.
    pub(super) sources: Vec<Vec<usize>>,
}

impl Graph {
    pub(super) fn new(count: usize, links: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut graph = Self { targets: vec![Vec::new(); count], sources: vec![Vec::new(); count] };
        for (from, to) in links.filter(|(from, to)| from != to) {
            if !graph.targets[from].contains(&to) {
                graph.targets[from].push(to);
                graph.sources[to].push(from);
            }
        }
        graph
    }

    /// Sum of a value over the neighbours of a box, and their number.
    fn sum(&self, index: usize, of: &[f64]) -> (f64, f64) {
        let near = self.targets[index].iter().chain(&self.sources[index]);
        near.fold((0.0, 0.0), |(sum, count), one| (sum + of[*one], count + 1.0))
    }

    /// Sorts each row by the mean place of the neighbours, so that few links cross (barycentre heuristic).
    pub(super) fn sort(&self, rows: &mut [Vec<usize>]) {
        let mut places = vec![0.0; self.targets.len()];
        let number = |row: &[usize], places: &mut [f64]| {
            row.iter().enumerate().for_each(|(at, index)| places[*index] = (at as f64 + 0.5) / row.len() as f64);
        };
        for row in &*rows {
            number(row, &mut places);
        }
        for row in sweeps(rows.len()) {
            let mean = |index: usize| match self.sum(index, &places) {
                (sum, count) if count > 0.0 => sum / count,
                _ => places[index],
            };
            let mut wanted: Vec<(f64, usize)> = rows[row].iter().map(|index| (mean(*index), *index)).collect();
            wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
            rows[row] = wanted.into_iter().map(|(_, index)| index).collect();
            number(&rows[row], &mut places);
        }
    }

    /// The centres of all boxes: near those of their neighbours, and spread over the width. Boxes of a row are `gap` apart if
    /// there is room.
    pub(super) fn columns(&self, rows: &[Vec<usize>], widths: &[f64], width: f64, gap: f64) -> Vec<f64> {
        let mut x = vec![width / 2.0; widths.len()];
        let (left, right) = (MARGIN, width - MARGIN);
        for row in sweeps(rows.len()).map(|row| &rows[row]) {
            let even = |at: usize| left + (at as f64 + 0.5) / row.len() as f64 * (right - left);
            let wanted = row.iter().enumerate().map(|(at, index)| {
                let (sum, count) = self.sum(*index, &x);
                (even(at) + sum) / (count + 1.0)
            });
            let (wanted, own): (Vec<f64>, Vec<f64>) = wanted.zip(row.iter().map(|index| widths[*index])).unzip();
            let spare = (right - left - own.iter().sum::<f64>()) / (row.len().max(2) - 1) as f64;
            let places = apart(&wanted, &own, (left, right), gap.min(spare));
            row.iter().zip(places).for_each(|(index, place)| x[*index] = place);
        }
        stretched(&x, widths, (left, right))
    }
}

/// Indices of the rows in the order of all passes.
fn sweeps(rows: usize) -> impl Iterator<Item = usize> {
    (0..SWEEPS).flat_map(move |sweep| (0..rows).map(move |row| if sweep % 2 == 0 { row } else { rows - 1 - row }))
}

/// Moves boxes apart so that they fill the width.
fn stretched(x: &[f64], widths: &[f64], (left, right): (f64, f64)) -> Vec<f64> {
    let edges = || x.iter().zip(widths).map(|(x, width)| (*x, width / 2.0));
    let Some(first) = edges().min_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1))) else { return Vec::new() };
    let last = edges().max_by(|a, b| (a.0 + a.1).total_cmp(&(b.0 + b.1))).unwrap_or(first);
    let begin = left + first.1;
    let factor = if last.0 > first.0 { (right - last.1 - begin) / (last.0 - first.0) } else { 1.0 };
    edges().map(|(x, half)| (begin + (x - first.0) * factor).min(right - half).max(left + half)).collect()
}

/// The places nearest to the wanted ones at which boxes of a row do not touch (isotonic regression by pooling adjacent violators).
pub(super) fn apart(wanted: &[f64], widths: &[f64], (left, right): (f64, f64), gap: f64) -> Vec<f64> {
    let mut end = 0.0;
    let offsets = widths.iter().map(|width| {
        end += width + gap;
        end - gap - width / 2.0
    });
    let offsets: Vec<f64> = offsets.collect();
    let room = right - offsets.last().zip(widths.last()).map_or(0.0, |(offset, width)| offset + width / 2.0);
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for (place, offset) in wanted.iter().zip(&offsets) {
        let (mut sum, mut count) = (place - offset, 1);
        while let Some((before, number)) =
            pools.pop_if(|(before, number)| *before / *number as f64 > sum / count as f64)
        {
            (sum, count) = (sum + before, count + number);
        }
        pools.push((sum, count));
    }
    let starts =
        pools.iter().flat_map(|(sum, count)| std::iter::repeat_n((sum / *count as f64).min(room).max(left), *count));
    starts.zip(offsets).map(|(start, offset)| start + offset).collect()
}
