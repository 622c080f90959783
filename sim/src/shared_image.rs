//! Camera image with shared pixels.

use core::mem;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Access to the pixels of a world's newest image without a copy, also from other threads. Clones belong to the same world.
///
/// Shared pixels never change: the world draws its next image into other memory.
#[derive(Clone, Debug, Default)]
pub struct SharedImage(Arc<Mutex<Option<Arc<Vec<u8>>>>>);

impl SharedImage {
    /// Returns the owner of these pixels if they are the newest image of the world. It compares addresses, not values.
    #[must_use]
    pub fn owner_of(&self, pixels: &[u8]) -> Option<Arc<Vec<u8>>> {
        self.lock().as_ref().filter(|owner| core::ptr::eq(owner.as_slice(), pixels)).cloned()
    }

    fn lock(&self) -> MutexGuard<'_, Option<Arc<Vec<u8>>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Memory for the images of a world: one image, and more as long as older ones are shared.
#[derive(Clone, Debug)]
pub(crate) struct ImageMemory {
    newest: Arc<Vec<u8>>,
    older: Vec<Arc<Vec<u8>>>,
    shared: SharedImage,
}

impl ImageMemory {
    /// Creates the memory for images of a number of bytes.
    pub(crate) fn new(bytes: usize) -> Self {
        Self { newest: Arc::new(vec![0; bytes]), older: Vec::new(), shared: SharedImage::default() }
    }

    /// Draws a new image into memory that is not shared.
    pub(crate) fn draw(&mut self, draw: impl FnOnce(&mut [u8])) {
        *self.shared.lock() = None;
        if Arc::get_mut(&mut self.newest).is_none() {
            let free = self.older.iter_mut().position(|older| Arc::get_mut(older).is_some());
            let next = free.map_or_else(|| Arc::new(vec![0; self.newest.len()]), |free| self.older.swap_remove(free));
            self.older.push(mem::replace(&mut self.newest, next));
        }
        // The memory is not shared, so this copies nothing.
        draw(Arc::make_mut(&mut self.newest).as_mut_slice());
        *self.shared.lock() = Some(Arc::clone(&self.newest));
    }

    /// Returns the newest image.
    pub(crate) fn pixels(&self) -> &[u8] {
        &self.newest
    }

    /// Returns access to the newest image.
    pub(crate) fn shared(&self) -> SharedImage {
        self.shared.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_that_are_kept_do_not_change() {
        let mut memory = ImageMemory::new(4);
        let shared = memory.shared();
        assert_eq!(shared.owner_of(memory.pixels()), None, "nothing was drawn");
        let mut kept = Vec::new();
        for value in 0..5 {
            memory.draw(|pixels| pixels.fill(value));
            assert_eq!(memory.pixels(), [value; 4]);
            kept.push(shared.owner_of(memory.pixels()).expect("it is the newest"));
        }
        for (value, pixels) in kept.iter().enumerate() {
            assert_eq!(**pixels, [value as u8; 4]);
        }
        assert_eq!(shared.owner_of(&kept[0]), None, "it is not the newest");
        assert_eq!(shared.owner_of(&[4; 4]), None, "it is a copy");
    }

    #[test]
    fn memory_that_nobody_keeps_is_used_again() {
        let mut memory = ImageMemory::new(4);
        let mut kept = None;
        let mut places = std::collections::BTreeSet::new();
        for value in 0..10 {
            memory.draw(|pixels| pixels.fill(value));
            places.insert(memory.pixels().as_ptr());
            if value % 2 == 0 {
                kept = memory.shared().owner_of(memory.pixels());
            }
        }
        assert!(kept.is_some() && (2..=3).contains(&places.len()), "{} places", places.len());
    }
}
