//! Blocked cross-validation.
//!
//! Consecutive images of a recording are near-copies, so a random split would test on the training data. The images are
//! split into consecutive blocks; each block is tested with thresholds fitted to the others.

use bica_vision::colour::{Colour, Filter};
use serde::Serialize;

use super::fit::{Axes, fit};
use super::samples::Sample;

/// Number of blocks; fewer if fewer images show the class.
pub(super) const BLOCKS: usize = 5;

/// Largest accepted fraction of the pixels that are known to be of other classes.
const ALLOWED_FALSE: f64 = 1e-4;
/// Largest increase of the minimum saturation, percent.
const MAX_INCREASE: u16 = 40;

/// Fitted class.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct FittedClass {
    /// Thresholds fitted to all samples.
    #[serde(skip)]
    pub(super) filter: Filter,
    /// Number of images that show the class.
    pub(super) images: usize,
    /// Number of blocks; 1 if the test used the training data.
    pub(super) blocks: usize,
    /// Fraction of the accepted pixels that are of the class.
    pub(super) precision: f64,
    /// Fraction of the pixels of the class that are accepted.
    pub(super) recall: f64,
}

/// Fits the thresholds of a class; `None` without a sample of it.
pub(super) fn fit_class(class: Colour, samples: &[Sample]) -> Option<FittedClass> {
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
    Some(FittedClass {
        filter: all,
        images: images.len(),
        blocks,
        precision: good / passed.max(1e-9),
        recall: good / total,
    })
}

/// Thresholds of a class without samples: those of the base profile, with the minimum saturation raised until nearly
/// all pixels known to be of other classes are rejected. If no increase suffices, the base profile is kept.
pub(super) fn with_raised_saturation(class: Colour, given: &Filter, samples: &[Sample]) -> Filter {
    let others = || samples.iter().filter(|sample| sample.is_not.has(class));
    let weight = |filter: &Filter| -> f64 {
        others().filter(|sample| filter.accepts(sample.pixel)).map(|sample| f64::from(sample.weight)).sum()
    };
    let (least, most) = given.saturation_range();
    let allowed = ALLOWED_FALSE * weight(&Filter::ANY);
    let mut raised = (least..most.min(least + MAX_INCREASE)).map(|least| given.saturation(least, most));
    raised.find(|filter| weight(filter) <= allowed).unwrap_or(*given)
}

fn concerns(class: Colour, sample: &Sample) -> bool {
    sample.is == Some(class) || sample.is_not.has(class)
}

/// Index of an image's block. The numbers of images with the class differ by at most one between blocks.
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
