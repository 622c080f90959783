//! Recent images.

use std::collections::VecDeque;

use crate::program::Image;

/// Recent images, in bounded memory.
#[derive(Debug, Default)]
pub(crate) struct Images {
    all: VecDeque<Image>,
    bytes: usize,
    max_bytes: usize,
}

impl Images {
    pub(super) const fn new(max_bytes: usize) -> Self {
        Self { all: VecDeque::new(), bytes: 0, max_bytes }
    }

    /// Adds the newest image, and removes the oldest ones if the memory is full. A repeated image is ignored.
    pub(crate) fn push(&mut self, image: Image) {
        if self.all.back().is_some_and(|last| (last.number, last.time_us) == (image.number, image.time_us)) {
            return;
        }
        self.bytes += image.yuyv.len();
        self.all.push_back(image);
        while self.bytes > self.max_bytes && self.all.len() > 1 {
            self.pop();
        }
    }

    fn pop(&mut self) {
        if let Some(image) = self.all.pop_front() {
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
    fn the_oldest_images_give_way() {
        let mut images = Images::new(100);
        for number in 0..10 {
            let time_us = u64::from(number) * 10;
            let yuyv = vec![0; 30].into();
            images.push(Image { number, time_us, camera: "".into(), width: 5, height: 3, yuyv });
        }
        assert_eq!(images.bytes(), 90);
        assert!(images.get(6).is_none());
        assert_eq!(images.get(7).unwrap().time_us, 70);
        assert_eq!(images.at(85).unwrap().number, 8);
        assert!(images.at(69).is_none());
        images.evict(1000);
        assert_eq!(images.at(1000).unwrap().number, 9, "the newest one stays");
    }
}
