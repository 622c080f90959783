//! Recent images.

use std::collections::VecDeque;

use crate::program::Image;

/// Of so many images one stays in the older half of the memory.
const THINNING: usize = 4;

/// Recent images, in bounded memory: all of the newer half, and one of [`THINNING`] of the older half.
#[derive(Debug, Default)]
pub(crate) struct Images {
    all: VecDeque<Image>,
    bytes: usize,
    max_bytes: usize,
    /// Number of images at the front that are thinned.
    thinned: usize,
    /// Number of images that gave way since the last one that stayed.
    removed: usize,
}

impl Images {
    pub(super) const fn new(max_bytes: usize) -> Self {
        Self { all: VecDeque::new(), bytes: 0, max_bytes, thinned: 0, removed: 0 }
    }

    /// Adds the newest image; older ones give way if the memory is full. A repeated image is ignored.
    pub(crate) fn push(&mut self, image: Image) {
        if self.all.back().is_some_and(|last| (last.number, last.time_us) == (image.number, image.time_us)) {
            return;
        }
        self.bytes += image.yuyv.len();
        self.all.push_back(image);
        while self.bytes > self.max_bytes && self.all.len() > 1 {
            self.give_way();
        }
    }

    /// Removes an image: the next one between both halves, or the oldest one.
    fn give_way(&mut self) {
        if self.removed == THINNING - 1 {
            (self.removed, self.thinned) = (0, self.thinned + 1);
        }
        if self.thinned < self.all.len() / 2 {
            self.removed += 1;
            self.remove(self.thinned);
        } else {
            self.pop();
        }
    }

    fn pop(&mut self) {
        self.thinned = self.thinned.saturating_sub(1);
        self.remove(0);
    }

    fn remove(&mut self, index: usize) {
        if let Some(image) = self.all.remove(index) {
            self.bytes -= image.yuyv.len();
        }
    }

    pub(super) fn evict(&mut self, horizon: u64) {
        while self.all.len() > 1 && self.all.front().is_some_and(|image| image.time_us < horizon) {
            self.pop();
        }
    }

    /// Returns the last image that is not later than a time, µs.
    pub(crate) fn at(&self, time_us: u64) -> Option<&Image> {
        let end = self.all.partition_point(|image| image.time_us <= time_us);
        self.all.get(end.checked_sub(1)?)
    }

    /// Returns the image with this number.
    pub(crate) fn get(&self, number: u32) -> Option<&Image> {
        let index = self.all.binary_search_by_key(&number, |image| image.number).ok()?;
        self.all.get(index)
    }

    /// Returns the newest image.
    pub(crate) fn newest(&self) -> Option<&Image> {
        self.all.back()
    }

    /// Returns the images after a time and up to another one, µs.
    pub(super) fn part(&self, after_us: Option<u64>, last_us: u64) -> impl Iterator<Item = &Image> {
        let begin = after_us.map_or(0, |after| self.all.partition_point(|image| image.time_us <= after));
        self.all.range(begin..).take_while(move |image| image.time_us <= last_us)
    }

    /// Returns the memory of the pixels, bytes.
    pub(crate) const fn bytes(&self) -> usize {
        self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_images_give_way() {
        let mut images = Images::new(610);
        for number in 0..1000 {
            let yuyv = vec![0; 30].into();
            images.push(Image { number, time_us: u64::from(number), camera: "".into(), width: 5, height: 3, yuyv });
            assert!(images.bytes() <= 610);
        }
        assert_eq!(images.bytes(), 600);
        let numbers: Vec<_> = images.part(None, 1000).map(|image| image.number).collect();
        let [older, newer] = [&numbers[..10], &numbers[10..]];
        assert_eq!(newer, (990..1000).collect::<Vec<_>>());
        assert!(older[..9].windows(2).all(|pair| (3..=5).contains(&(pair[1] - pair[0]))), "{older:?}");
        assert!(older[0] <= 955, "{older:?}");
        assert_eq!(images.at(995).unwrap().number, 995);
        assert_eq!(images.at(u64::from(older[4]) + 2).unwrap().number, older[4]);
        assert!(images.get(older[4] + 1).is_none() && images.at(900).is_none());
        images.evict(2000);
        assert_eq!(images.at(2000).unwrap().number, 999, "the newest one stays");
    }
}
