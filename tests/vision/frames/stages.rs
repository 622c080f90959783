//! Segmentation and connected components against simple reference implementations.

use std::collections::BTreeMap;

use bica_vision::colour::{Classify, Colour, ColourSet};
use bica_vision::frame::{Frame, Pair, Pixel};
use bica_vision::regions::Regions;
use bica_vision::segment::{Area, Run, Runs};
use proptest::prelude::*;

/// Classifier by luma alone, so that a test draws classes directly.
pub(crate) struct ByLuma;

impl Classify for ByLuma {
    fn classify(&self, pixel: Pixel) -> Colour {
        Colour::from_index(pixel.y)
    }
}

const WIDTH: u16 = 32;
const HEIGHT: u16 = 20;

/// Frame of classes, one for each pixel pair, in runs so that regions have some size.
fn classes() -> impl Strategy<Value = Vec<u8>> {
    let pairs = usize::from(WIDTH / 2 * HEIGHT);
    let stretch = (0_u8..6, 1_usize..6);
    prop::collection::vec(stretch, pairs).prop_map(move |stretches| {
        stretches.into_iter().flat_map(|(class, n)| std::iter::repeat_n(class, n)).take(pairs).collect()
    })
}

fn bytes(classes: &[u8]) -> Vec<u8> {
    classes.iter().flat_map(|class| [*class, 128, *class, 128]).collect()
}

fn selected() -> impl Strategy<Value = ColourSet> {
    prop::collection::vec(0_usize..5, 0..5)
        .prop_map(|set| set.into_iter().fold(ColourSet::EMPTY, |all, one| all | ColourSet::of(Colour::ALL[one])))
}

/// Pixel pairs of the selected classes: (row, first pixel, class).
fn pairs_of(runs: &[Run]) -> Vec<(u16, u16, Colour)> {
    runs.iter().flat_map(|run| (run.start..run.end).step_by(2).map(|x| (run.row, x, run.colour))).collect()
}

/// Reference: 8-connected flood fill over pixel pairs in the scanned rows; (class, pairs) of each region.
fn flood(pairs: &[(u16, u16, Colour)], step: u16) -> Vec<(Colour, Vec<(u16, u16)>)> {
    let mut left: BTreeMap<(u16, u16), Colour> = pairs.iter().map(|(row, x, class)| ((*row, *x), *class)).collect();
    let mut found = Vec::new();
    while let Some((start, colour)) = left.pop_first() {
        let (mut region, mut edge) = (vec![start], vec![start]);
        while let Some((row, x)) = edge.pop() {
            for next in [-1, 0, 1]
                .into_iter()
                .flat_map(|dy| [-1, 0, 1].map(|dx| (dy, dx)))
                .map(|(dy, dx)| (row.wrapping_add_signed(dy * step as i16), x.wrapping_add_signed(2 * dx)))
            {
                if left.get(&next) == Some(&colour) {
                    left.remove(&next);
                    region.push(next);
                    edge.push(next);
                }
            }
        }
        found.push((colour, region));
    }
    found
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn runs_are_exactly_the_wanted_pairs(
        classes in classes(), selected in selected(), first in 0_u16..HEIGHT, end in 0_u16..2 * HEIGHT, step in 0_u16..4,
    ) {
        let bytes = bytes(&classes);
        let frame = Frame::new(WIDTH, HEIGHT, &bytes).unwrap();
        let mut runs = Runs::<1024>::new();
        runs.segment(&frame, &ByLuma, selected, Area { first, end, step });
        let mut expected = Vec::new();
        for row in (first..end.min(HEIGHT)).step_by(usize::from(step.max(1))) {
            for (pair, x) in frame.row(row).iter().zip((0..).step_by(2)) {
                let class = ByLuma.classify(Pair(*pair).mean());
                if selected.has(class) {
                    expected.push((row, x, class));
                }
            }
        }
        prop_assert_eq!(pairs_of(runs.as_slice()), expected);
        for pair in runs.as_slice().windows(2) {
            let apart = pair[0].row < pair[1].row || pair[0].end < pair[1].start || pair[0].colour != pair[1].colour;
            prop_assert!(apart, "touching runs are not merged: {pair:?}");
        }
        prop_assert_eq!(runs.dropped(), 0);
    }

    #[test]
    fn full_list_keeps_the_widest_runs(classes in classes(), selected in selected()) {
        let bytes = bytes(&classes);
        let frame = Frame::new(WIDTH, HEIGHT, &bytes).unwrap();
        let (mut few, mut all) = (Runs::<40>::new(), Runs::<1024>::new());
        few.segment(&frame, &ByLuma, selected, Area::ALL);
        all.segment(&frame, &ByLuma, selected, Area::ALL);
        let kept = few.as_slice();
        prop_assert_eq!(kept.len() + few.dropped() as usize, all.as_slice().len());
        prop_assert!(kept.iter().all(|run| all.as_slice().contains(run)));
        prop_assert!(kept.is_sorted_by_key(|run| (run.row, run.start)));
        let narrowest = kept.iter().map(|run| run.width()).min();
        if few.dropped() == 0 {
            prop_assert_eq!(kept, all.as_slice());
        } else if let Some(narrowest) = narrowest {
            let wider = all.as_slice().iter().filter(|run| run.width() > narrowest);
            prop_assert!(wider.count() <= kept.len() || kept.len() == 40, "wide runs were dropped before narrow ones");
        }
    }

    #[test]
    fn regions_equal_those_of_a_flood_fill(classes in classes(), selected in selected(), step in 1_u16..4) {
        let bytes = bytes(&classes);
        let frame = Frame::new(WIDTH, HEIGHT, &bytes).unwrap();
        let mut runs = Runs::<1024>::new();
        runs.segment(&frame, &ByLuma, selected, Area::ALL.every(step));
        let mut regions = Regions::<1024, 512>::new();
        regions.connect(&runs, 0);
        let mut found: Vec<_> = regions.as_slice().iter().map(|r| {
            let (x, y) = r.centroid;
            (r.colour as u8, r.x0, r.y0, r.x1, r.y1, r.area, (x * 16.0).round() as i32, (y * 16.0).round() as i32)
        }).collect();
        let mut expected: Vec<_> = flood(&pairs_of(runs.as_slice()), step).into_iter().map(|(colour, pairs)| {
            let n = pairs.len() as f32;
            let x = pairs.iter().map(|(_, x)| f32::from(*x) + 0.5).sum::<f32>() / n;
            let y = pairs.iter().map(|(row, _)| f32::from(*row)).sum::<f32>() / n;
            let columns = || pairs.iter().map(|(_, x)| *x);
            let rows = || pairs.iter().map(|(row, _)| *row);
            let area = 2 * pairs.len() as u32 * u32::from(step);
            (colour as u8, columns().min().unwrap(), rows().min().unwrap(), columns().max().unwrap() + 2,
             rows().max().unwrap() + 1, area, (x * 16.0).round() as i32, (y * 16.0).round() as i32)
        }).collect();
        found.sort_unstable();
        expected.sort_unstable();
        prop_assert_eq!(found, expected);
    }

    #[test]
    fn full_list_keeps_the_largest_regions(classes in classes(), min_area in 0_u16..20) {
        let bytes = bytes(&classes);
        let frame = Frame::new(WIDTH, HEIGHT, &bytes).unwrap();
        let mut runs = Runs::<1024>::new();
        runs.segment(&frame, &ByLuma, Colour::Orange | Colour::Green, Area::ALL);
        let (mut few, mut all) = (Regions::<1024, 3>::new(), Regions::<1024, 512>::new());
        few.connect(&runs, min_area);
        all.connect(&runs, min_area);
        let areas = |regions: &[bica_vision::regions::Region]| {
            let mut areas: Vec<_> = regions.iter().map(|region| region.area).collect();
            areas.sort_unstable_by(|a, b| b.cmp(a));
            areas
        };
        let mut expected = areas(all.as_slice());
        prop_assert_eq!(few.dropped() as usize, expected.len().saturating_sub(3));
        expected.truncate(3);
        prop_assert!(expected.iter().all(|area| *area >= u32::from(min_area)));
        prop_assert_eq!(areas(few.as_slice()), expected);
    }
}

/// Row of noise: a run in every second pair.
fn noisy_row(pairs: usize) -> Vec<u8> {
    (0..pairs).map(|pair| (pair % 2) as u8).collect()
}

#[test]
fn rest_of_a_noisy_row_is_skipped_and_counted() {
    let quiet = [[0; 40], [1; 40], [0; 40]].concat();
    let rows = [&quiet[..], &noisy_row(120), &quiet].concat();
    let bytes = bytes(&rows.repeat(6));
    let frame = Frame::new(240, 18, &bytes).unwrap();
    let mut runs = Runs::<512>::new();
    runs.segment(&frame, &ByLuma, ColourSet::of(Colour::Orange), Area::ALL);
    let in_row = |row: u16| runs.as_slice().iter().filter(|run| run.row == row).count();
    assert!((0..18).all(|row| if row % 3 == 1 { (20..40).contains(&in_row(row)) } else { in_row(row) == 1 }));
    assert_eq!(runs.dropped(), 6);
}

#[test]
fn regions_are_sorted_by_area() {
    let classes: Vec<u8> = [1_usize, 5, 2, 7, 3].iter().flat_map(|n| [vec![1; *n], vec![0; 16 - n]].concat()).collect();
    let rows: Vec<u8> = classes.chunks(16).flat_map(|row| [row, &[0; 16]].concat()).cycle().take(16 * 20).collect();
    let bytes = bytes(&rows);
    let frame = Frame::new(WIDTH, HEIGHT, &bytes).unwrap();
    let mut runs = Runs::<1024>::new();
    runs.segment(&frame, &ByLuma, ColourSet::of(Colour::Orange), Area::ALL);
    let mut regions = Regions::<1024, 64>::new();
    regions.connect(&runs, 0);
    assert_eq!(regions.as_slice().len(), 10);
    assert!(regions.as_slice().is_sorted_by(|a, b| a.area >= b.area));
    assert!(regions.as_slice().iter().all(|region| region.runs == 1));
}
