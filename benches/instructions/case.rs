//! Benchmarks by name.

use std::hint::black_box;

/// Work whose instructions are counted, with its name.
pub(crate) struct Case {
    pub(crate) name: String,
    prepare: Box<dyn FnOnce() -> Box<dyn FnMut()>>,
}

impl Case {
    /// `prepare` makes the input of `work`, which alone is counted.
    pub(crate) fn new<S: 'static>(
        name: impl Into<String>,
        prepare: impl FnOnce() -> S + 'static,
        work: impl Fn(&mut S) + 'static,
    ) -> Self {
        let prepare = || {
            let mut state = prepare();
            Box::new(move || work(&mut state)) as Box<dyn FnMut()>
        };
        Self { name: name.into(), prepare: Box::new(prepare) }
    }

    /// Prepares the work and executes it once.
    pub(crate) fn run(self) {
        counted(&mut *(self.prepare)());
    }
}

/// Executes the work. Valgrind counts the instructions from the entry of this function to its end; the result prevents a jump to the
/// work in place of a call.
#[inline(never)]
fn counted(work: &mut dyn FnMut()) -> u32 {
    work();
    black_box(1)
}
