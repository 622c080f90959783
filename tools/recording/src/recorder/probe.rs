//! What a recorder takes from the events of a tick: the times of components, and the jobs beside the loop.

use bica::{ComponentId, Instant, JobEnd, Probe};

use super::Recorder;
use crate::request::RequestRecord;

impl Probe for Recorder {
    fn cycle_begin(&mut self, now: Instant) {
        self.works.now = now;
        if let Some(meter) = &mut self.meter {
            meter.cycle_begin(now);
        }
    }

    fn work_begun(&mut self, component: ComponentId, due: Instant) {
        self.event(self.works.begun(component, due));
    }

    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {
        self.requests.push(RequestRecord::Ended { component, end });
    }

    fn run(&mut self, component: ComponentId) {
        if let Some(meter) = &mut self.meter {
            meter.run(component);
        }
    }

    fn begin(&mut self, component: ComponentId) {
        if let Some(meter) = &mut self.meter {
            meter.begin(component);
        }
    }

    fn end(&mut self, component: ComponentId) {
        if let Some(meter) = &mut self.meter {
            meter.end(component);
        }
    }

    fn cycle_end(&mut self) {
        if let Some(meter) = &mut self.meter {
            meter.cycle_end();
        }
    }
}
