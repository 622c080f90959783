//! Injected faults. Without the feature `fault-injection` there are none, and no code for them.

use bica_wire::message::FaultInjection;

use crate::board::Board;

/// The faults that are active.
pub(crate) struct Faults {
    /// Index of the delayed component, and the delay of each run, counter ticks.
    #[cfg(feature = "fault-injection")]
    delay: Option<(usize, u32)>,
    /// Index of the component that panics in its next run.
    #[cfg(feature = "fault-injection")]
    panics: Option<usize>,
}

#[cfg(feature = "fault-injection")]
impl Faults {
    /// No faults.
    pub(crate) const NONE: Self = Self { delay: None, panics: None };

    /// Adds or removes a fault.
    pub(crate) const fn inject(&mut self, fault: FaultInjection) {
        match fault {
            FaultInjection::Delay { ticks: 0, .. } => self.delay = None,
            FaultInjection::Delay { component, ticks } => self.delay = Some((component as usize, ticks)),
            FaultInjection::Panic { component } => self.panics = Some(component as usize),
        }
    }

    /// Panics if this fault is active for the component.
    pub(crate) fn before_run(&self, index: usize, name: &str) {
        assert!(self.panics != Some(index), "injected: {name} panics");
    }

    /// Waits if this fault is active for the component.
    pub(crate) fn after_run<B: Board>(&self, index: usize) {
        if let Some((_, ticks)) = self.delay.filter(|&(delayed, _)| delayed == index) {
            let start = B::counter();
            while B::counter().wrapping_sub(start) < ticks {}
        }
    }
}

#[cfg(not(feature = "fault-injection"))]
#[expect(clippy::unused_self, reason = "the interface is the same with and without the feature")]
impl Faults {
    /// No faults.
    pub(crate) const NONE: Self = Self {};

    /// Logs that the fault is ignored.
    pub(crate) fn inject(&mut self, _: FaultInjection) {
        defmt::warn!("this image was built without fault injection");
    }

    /// Does nothing.
    pub(crate) const fn before_run(&self, _: usize, _: &str) {}

    /// Does nothing.
    pub(crate) const fn after_run<B: Board>(&self, _: usize) {}
}
