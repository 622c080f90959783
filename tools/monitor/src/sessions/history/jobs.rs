//! Jobs beside the loop on the timeline.

use std::collections::HashMap;

use bica::JobEnd;
use bica_link::{Description, JobEvent};
use bica_recording::{RequestRecord, RunEvent};

use super::{History, Told};
use crate::protocol::Job;

impl History {
    /// Returns the jobs of each component, of which a part lies in an interval. Of jobs that begin within one resolution only the first
    /// is listed, and those that were late or have failed.
    pub(crate) fn jobs(&self, tree: &Description, from_us: u64, until_us: u64, resolution_us: u64) -> Vec<Vec<Job>> {
        let places: HashMap<&str, usize> =
            tree.components.iter().enumerate().map(|(index, component)| (&*component.name, index)).collect();
        let mut jobs: Vec<Vec<Job>> = vec![Vec::new(); tree.components.len()];
        for (time_us, told) in self.told.between(0, until_us) {
            let event = match told {
                Told::Event(RunEvent { kind, detail, .. }) => JobEvent::read(kind, detail).and_then(|(name, event)| {
                    let (component, _) = name.rsplit_once('.')?;
                    Some((*places.get(component)?, event))
                }),
                Told::Request(RequestRecord::Ended { component, end }) => {
                    Some((component.index(), JobEvent::Ended(*end)))
                }
                _ => None,
            };
            let Some((of, event)) = event else { continue };
            let Some(of) = jobs.get_mut(of) else { continue };
            let open = of.last_mut().filter(|job| job.2.is_none());
            match event {
                JobEvent::Begun(ms) => {
                    // A job that was begun in place of another one.
                    if let Some(job) = open {
                        job.2 = Some(*time_us);
                    }
                    of.push(Job(*time_us, time_us.saturating_add(ms.saturating_mul(1000)), None, None));
                }
                JobEvent::Ended(end) => {
                    if let Some(job) = open {
                        (job.2, job.3) = (Some(*time_us), Some(end));
                    }
                }
            }
        }
        for of in &mut jobs {
            let mut last = None;
            of.retain(|job| {
                let is_seen = job.2.unwrap_or(job.1) >= from_us;
                let is_apart = last.is_none_or(|last| job.0 >= resolution_us.saturating_add(last));
                let is_kept = is_seen && (is_apart || matches!(job.3, Some(JobEnd::Late | JobEnd::Failed)));
                last = if is_kept { Some(job.0) } else { last };
                is_kept
            });
        }
        jobs
    }
}

#[cfg(test)]
mod tests {
    use bica::ComponentId;
    use bica_link::JOB;
    use bica_wire::model::Component;

    use super::super::Limits;
    use super::*;

    fn tree() -> Description {
        let component = |name: &str| Component { name: name.to_owned(), ..Component::default() };
        Description { components: vec![component("Legs"), component("Planner")], ..Description::default() }
    }

    fn told(event: JobEvent) -> Told {
        let detail = event.detail("Planner.search");
        Told::Event(RunEvent { at_ns: 0, kind: JOB.to_owned(), detail })
    }

    /// A history with jobs; their ends as a robot sends them, or as a recording has them.
    fn history(ended: fn(JobEnd) -> Told) -> History {
        let mut history = History::new(Limits::default(), 2);
        let begun = told(JobEvent::Begun(20));
        for (time_us, what) in [
            (1000, begun.clone()),
            (21_000, ended(JobEnd::OnTime)),
            (22_000, begun.clone()),
            (52_000, ended(JobEnd::Late)),
            (53_000, begun.clone()),
            (60_000, begun.clone()),
            (61_000, ended(JobEnd::Failed)),
            (62_000, begun),
        ] {
            history.told.push(time_us, what);
        }
        history
    }

    const ALL: [Job; 5] = [
        Job(1000, 21_000, Some(21_000), Some(JobEnd::OnTime)),
        Job(22_000, 42_000, Some(52_000), Some(JobEnd::Late)),
        Job(53_000, 73_000, Some(60_000), None),
        Job(60_000, 80_000, Some(61_000), Some(JobEnd::Failed)),
        Job(62_000, 82_000, None, None),
    ];

    #[test]
    fn jobs_of_a_robot_and_of_its_recording_are_equal() {
        let live = history(|end| told(JobEvent::Ended(end)));
        let recorded = history(|end| Told::Request(RequestRecord::Ended { component: ComponentId::new(1), end }));
        for history in [live, recorded] {
            assert_eq!(history.jobs(&tree(), 0, 99_000, 0), [vec![], ALL.to_vec()]);
            assert_eq!(history.jobs(&tree(), 55_000, 60_500, 0)[1], [ALL[2], Job(60_000, 80_000, None, None)]);
            // Coarse intervals list what is late or has failed.
            assert_eq!(history.jobs(&tree(), 0, 99_000, 90_000)[1], [ALL[0], ALL[1], ALL[3]]);
        }
    }
}
