//! Score of one detector.

use std::fmt;

/// Recall, precision and errors of one detector.
pub(crate) struct Score {
    pub(crate) name: &'static str,
    unit: &'static str,
    pub(crate) due: usize,
    found: usize,
    seen: usize,
    right: usize,
    errors: Vec<f32>,
    /// Numbers of the poses with missed objects, and of those with false detections.
    pub(crate) missed: Vec<u64>,
    pub(crate) wrong: Vec<u64>,
}

impl Score {
    pub(crate) const fn new(name: &'static str, unit: &'static str) -> Self {
        Self {
            name,
            unit,
            due: 0,
            found: 0,
            seen: 0,
            right: 0,
            errors: Vec::new(),
            missed: Vec::new(),
            wrong: Vec::new(),
        }
    }

    /// Lets `view` add to the score, and stores the pose number if it adds a miss or a false detection.
    pub(crate) fn note(&mut self, pose: u64, view: impl FnOnce(&mut Self)) {
        let (missed, wrong) = (self.due - self.found, self.seen - self.right);
        view(self);
        self.missed.extend((self.due - self.found > missed).then_some(pose));
        self.wrong.extend((self.seen - self.right > wrong).then_some(pose));
    }

    /// Adds a due object.
    pub(crate) fn due(&mut self, is_found: bool) {
        self.due += 1;
        self.found += usize::from(is_found);
    }

    /// Adds a detection.
    pub(crate) fn seen(&mut self, is_right: bool) {
        self.seen += 1;
        self.right += usize::from(is_right);
    }

    /// Adds the error of a detection, if there is one.
    pub(crate) fn error(&mut self, off: impl Into<Option<f32>>) {
        self.errors.extend(off.into());
    }

    /// Recall: fraction of the due objects that were detected.
    pub(crate) fn recall(&self) -> f32 {
        self.found as f32 / self.due as f32
    }

    /// Precision: fraction of the detections that are right.
    pub(crate) fn precision(&self) -> f32 {
        self.right as f32 / self.seen as f32
    }

    /// Percentile of the errors.
    pub(crate) fn error_at(&self, percent: usize) -> f32 {
        let mut errors = self.errors.clone();
        errors.sort_by(f32::total_cmp);
        errors.get(errors.len().max(1).saturating_sub(1) * percent / 100).copied().unwrap_or(f32::NAN)
    }
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = format!("{} of {}", self.found, self.due);
        let right = format!("{} of {}", self.right, self.seen);
        write!(f, "{:17}{found:>15}{:9.3}{right:>15}{:11.3}", self.name, self.recall(), self.precision())?;
        write!(f, "   median {:.2}, 95 % {:.2} {}", self.error_at(50), self.error_at(95), self.unit)
    }
}
