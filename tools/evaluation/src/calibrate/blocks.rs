//! Cross-validation that keeps neighbouring images together.
//!
//! Images of a recording are near-copies of their neighbours: split at random, each would be tested by its twin. So the
//! images are cut into blocks that follow each other, and each block is tested by what the others taught.

use bica_vision::colour::{Colour, Filter};
use serde::Serialize;

use super::fit::{Axes, fit};
use super::samples::Sample;

/// Blocks that the images are cut into, if there are as many with the class.
pub const BLOCKS: usize = 5;

/// The part of what is known to be something else that may still pass.
const STRAY: f64 = 1e-4;
/// By how much a saturation may be raised to keep the rest out, percent.
const RAISE: u16 = 40;

/// What was learned of a class.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Learned {
    /// The thresholds by all samples.
    #[serde(skip)]
    pub filter: Filter,
    /// Images with the class.
    pub images: usize,
    /// Blocks that were tested by the others; 1 if all images were tested by themselves.
    pub blocks: usize,
    /// The part of the pixels that pass and are of the class.
    pub precision: f64,
    /// The part of the class that passes.
    pub recall: f64,
}

/// Learns a class; none without a sample of it.
pub fn learn(class: Colour, samples: &[Sample]) -> Option<Learned> {
    let own: Vec<&Sample> = samples.iter().filter(|sample| concerns(class, sample)).collect();
    let mut images: Vec<usize> =
        own.iter().filter(|sample| sample.is == Some(class)).map(|sample| sample.image).collect();
    images.sort_unstable();
    images.dedup();
    let blocks = images.len().min(BLOCKS);
    let block = |sample: &Sample| block(&images, blocks, sample.image);
    let all = thresholds(class, own.iter().copied())?;
    let mut count = Count::default();
    for tested in 0..blocks {
        let others = own.iter().copied().filter(|sample| blocks == 1 || block(sample) != tested);
        let filter = thresholds(class, others)?;
        own.iter().filter(|sample| block(sample) == tested).for_each(|sample| count.add(class, sample, &filter));
    }
    let Count { good, passed, total } = count;
    Some(Learned {
        filter: all,
        images: images.len(),
        blocks,
        precision: good / passed.max(1e-9),
        recall: good / total,
    })
}

/// The thresholds of a class that nothing was learned of: those given, with a saturation above nearly all that is known
/// to be something else.
pub fn guarded(class: Colour, given: &Filter, samples: &[Sample]) -> Filter {
    let others = || samples.iter().filter(|sample| sample.is_not.has(class));
    let weight = |filter: &Filter| -> f64 {
        others().filter(|sample| filter.accepts(sample.pixel)).map(|sample| f64::from(sample.weight)).sum()
    };
    let (least, most) = given.saturation_range();
    let allowed = STRAY * weight(&Filter::ANY);
    let mut raised = (least..most.min(least + RAISE)).map(|least| given.saturation(least, most));
    raised.find(|filter| weight(filter) <= allowed).unwrap_or(*given)
}

fn concerns(class: Colour, sample: &Sample) -> bool {
    sample.is == Some(class) || sample.is_not.has(class)
}

/// The block of an image: every block has as many images with the class, give or take one.
fn block(with_class: &[usize], blocks: usize, image: usize) -> usize {
    let before = with_class.partition_point(|other| *other < image).min(with_class.len() - 1);
    before * blocks / with_class.len()
}

fn thresholds<'a>(class: Colour, samples: impl Iterator<Item = &'a Sample> + Clone) -> Option<Filter> {
    let of_class = samples.clone().filter(|sample| sample.is == Some(class));
    let axes = Axes::of(of_class.map(|sample| (sample.pixel, sample.weight)));
    let points: Vec<_> =
        samples.map(|sample| axes.point(sample.pixel, sample.weight, sample.is == Some(class))).collect();
    fit(class, axes, &points)
}

#[derive(Default)]
struct Count {
    good: f64,
    passed: f64,
    total: f64,
}

impl Count {
    fn add(&mut self, class: Colour, sample: &Sample, filter: &Filter) {
        let (weight, is) = (f64::from(sample.weight), sample.is == Some(class));
        let passes = filter.accepts(sample.pixel);
        self.total += if is { weight } else { 0.0 };
        self.passed += if passes { weight } else { 0.0 };
        self.good += if passes && is { weight } else { 0.0 };
    }
}
