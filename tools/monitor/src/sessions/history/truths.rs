//! True states of a world with their times.

use std::sync::Arc;

use bica_link::Shown;
use serde_json::Value;

use super::Timed;

/// True states with their times. Their items seldom change, and are shared in memory. Values are stored as text, which needs less memory.
#[derive(Debug, Default)]
pub(in crate::sessions) struct Truths(Timed<(Arc<[Shown]>, Box<str>)>);

impl Truths {
    pub(in crate::sessions) fn push(&mut self, time_us: u64, items: &[Shown]) {
        let bare = |item: &Shown| Shown { value: Value::Null, ..item.clone() };
        let (bare, values): (Vec<_>, Vec<_>) = items.iter().map(|item| (bare(item), &item.value)).unzip();
        let known = self.0.newest().map(|(_, (known, _))| known).filter(|known| ***known == *bare);
        let declared = known.map_or_else(|| bare.into(), Arc::clone);
        let values = serde_json::to_string(&values).unwrap_or_default();
        self.0.push(time_us, (declared, values.into()));
    }

    /// Returns the last true state that is not later than a time, µs.
    pub(in crate::sessions) fn at(&self, time_us: u64) -> Option<Vec<Shown>> {
        self.0.at(time_us).map(restored).map(|(_, items)| items)
    }

    /// Returns the newest true state with its time, µs.
    pub(in crate::sessions) fn newest(&self) -> Option<(u64, Vec<Shown>)> {
        self.0.newest().map(restored)
    }

    /// Removes the true states before `horizon`.
    pub(super) fn evict(&mut self, horizon: u64) {
        self.0.evict(horizon);
    }
}

fn restored((time_us, (declared, values)): &(u64, (Arc<[Shown]>, Box<str>))) -> (u64, Vec<Shown>) {
    let values: Vec<Value> = serde_json::from_str(values).unwrap_or_default();
    let items = declared.iter().zip(values).map(|(item, value)| Shown { value, ..item.clone() });
    (*time_us, items.collect())
}
